//! A block of commands: each shown, run, and followed by what it says.

use crate::command::{Bench, Runner, Said};
use crate::fence::fenced;
use crate::picture;

/// The words after `nply` in a block's info string: which lines of the output are shown; whether the command is not; whether the output is Markdown and part of the chapter; the
/// exit code that is right; the caption of the pictures.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Wish {
    ranges: Option<Vec<(usize, usize)>>,
    hide: bool,
    raw: bool,
    exit: i32,
    caption: String,
}

impl Wish {
    fn read(info: &str) -> Result<Self, String> {
        let mut wish = Self { ranges: None, hide: false, raw: false, exit: 0, caption: String::new() };
        let mut rest = info.trim();
        while !rest.is_empty() {
            let (word, after) = match rest.strip_prefix("caption=\"") {
                Some(quoted) => {
                    let (caption, after) = quoted.split_once('"').ok_or("the caption has no closing quote")?;
                    caption.clone_into(&mut wish.caption);
                    ("", after)
                }
                None => rest.split_once(' ').unwrap_or((rest, "")),
            };
            rest = after.trim_start();
            match word.split_once('=') {
                Some(("lines", list)) => wish.ranges = Some(ranges(list)?),
                Some(("exit", code)) => wish.exit = code.parse().map_err(|_| format!("`{word}`: no exit code"))?,
                None if word == "hide" => wish.hide = true,
                None if word == "raw" => wish.raw = true,
                None if word.is_empty() => {}
                _ => return Err(format!("`{word}` is none of lines=1-12, hide, raw, exit=1, caption=\"…\"")),
            }
        }
        Ok(wish)
    }
}

/// `1-12` or `1-3,8-10`, or a single line.
fn ranges(list: &str) -> Result<Vec<(usize, usize)>, String> {
    let wrong = || format!("`lines={list}`: wanted are lines such as 1-12 or 1-3,8-10");
    let mut ranges = Vec::new();
    let mut last = 0;
    for range in list.split(',') {
        let (from, to) = range.split_once('-').unwrap_or((range, range));
        let (from, to): (usize, usize) = (from.parse().map_err(|_| wrong())?, to.parse().map_err(|_| wrong())?);
        if from <= last || to < from {
            return Err(wrong());
        }
        ranges.push((from, to));
        last = to;
    }
    Ok(ranges)
}

/// The commands of a block, joined where a line ends in a backslash; with the line of each.
fn commands(lines: &[&str]) -> Vec<(usize, String)> {
    let mut commands: Vec<(usize, String)> = Vec::new();
    let mut goes_on = false;
    for (at, line) in lines.iter().enumerate() {
        match commands.last_mut() {
            Some((_, command)) if goes_on => {
                command.push('\n');
                command.push_str(line);
            }
            _ if line.trim().is_empty() => {}
            _ => commands.push((at, (*line).to_owned())),
        }
        goes_on = line.ends_with('\\');
    }
    commands
}

/// The block in the page; an error has the line within the block.
pub(crate) fn expand(
    info: &str,
    lines: &[&str],
    chapter: &str,
    bench: &mut Bench,
    runner: &Runner,
) -> Result<String, (usize, String)> {
    let wish = Wish::read(info).map_err(|why| (0, why))?;
    let commands = commands(lines);
    if commands.is_empty() {
        return Err((0, "the block has no command".to_owned()));
    }
    let (open, close) = if wish.raw { ("\n", "\n\n") } else { ("<div class=\"console\">\n\n", "</div>\n\n") };
    let mut page = String::new();
    let mut pictures = String::new();
    for (at, command) in commands {
        let failed = |why: String| (at + 1, format!("`{command}`: {why}"));
        if !wish.hide {
            page.push_str(&fenced("text,command", &command));
            page.push('\n');
        }
        if command.starts_with('#') {
            continue;
        }
        let placed = bench.place(&command);
        let said = runner.run(&placed.line).map_err(failed)?;
        if said.code != Some(wish.exit) {
            return Err(failed(format!(
                "ended with {} and not with {}\n{}",
                code(&said),
                wish.exit,
                said.error.trim_end()
            )));
        }
        let said = bench.unplaced(&format!("{}{}", said.output, said.error));
        let shown = match &wish.ranges {
            Some(ranges) => cut(&said, ranges).map_err(failed)?,
            None => said,
        };
        let draws = placed.writes.iter().any(|name| is_picture(name));
        if wish.hide && draws {
            // a picture alone is wished
        } else if wish.raw {
            page.push_str(&format!("\n{}\n", shown.trim()));
        } else if !shown.trim().is_empty() {
            // a refusal is a sentence, what is no refusal a table
            let info = if wish.exit == 0 { "text,said" } else { "text,said,refusal" };
            page.push_str(&fenced(info, shown.trim_start_matches('\n')));
            page.push('\n');
        }
        for name in &placed.writes {
            if !bench.path(name).exists() {
                return Err(failed(format!("did not write {name}")));
            }
            if is_picture(name) {
                let folder = format!("{}{}/", picture::to_made(chapter), slug(chapter));
                let dark = on_dark(&command, name, bench, runner).map_err(failed)?;
                // what is drawn without a ground suits any
                let suits_any = command.contains("--background transparent").then(|| name.clone());
                let dark = dark.or(suits_any).map(|dark| format!("{folder}{dark}"));
                pictures.push_str(&picture::figure(&format!("{folder}{name}"), dark.as_deref(), &wish.caption));
                pictures.push('\n');
            }
        }
    }
    let page = if page.is_empty() { page } else { format!("{open}{page}{close}") };
    Ok(format!("{page}{pictures}"))
}

fn is_picture(name: &str) -> bool {
    name.ends_with(".svg") || name.ends_with(".png")
}

/// The same picture on dark ground, from commands that can draw it.
fn on_dark(command: &str, name: &str, bench: &mut Bench, runner: &Runner) -> Result<Option<String>, String> {
    let draws = ["nply plot ", "nply figure "].iter().any(|verb| command.starts_with(verb));
    if !draws || command.contains("--dark") || command.contains('|') {
        return Ok(None);
    }
    let Some((stem, ending)) = name.rsplit_once('.') else { return Ok(None) };
    let dark = format!("{stem}-dark.{ending}");
    let placed = bench.place(&format!("{} --dark", command.replace(name, &dark)));
    let said = runner.run(&placed.line)?;
    Ok((said.code == Some(0) && bench.path(&dark).exists()).then_some(dark))
}

fn code(said: &Said) -> String {
    said.code.map_or_else(|| "a signal".to_owned(), |code| code.to_string())
}

/// The wished lines, with … where lines are left out.
fn cut(text: &str, ranges: &[(usize, usize)]) -> Result<String, String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut shown: Vec<&str> = Vec::new();
    let mut next = 1;
    for &(from, to) in ranges {
        if from > lines.len() {
            return Err(format!("has {} lines of output, and line {from} is wished", lines.len()));
        }
        if from > next {
            shown.push("…");
        }
        shown.extend(&lines[from - 1..to.min(lines.len())]);
        next = to + 1;
    }
    if next <= lines.len() {
        shown.push("…");
    }
    Ok(shown.join("\n"))
}

/// A chapter's path as the name of its folder of made files.
pub(crate) fn slug(chapter: &str) -> String {
    chapter.trim_end_matches(".md").replace('/', "-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wish_is_read() {
        let wish = Wish::read("lines=1-3,8 hide exit=1 caption=\"A ply, as it lies\"").unwrap();
        assert_eq!(wish.ranges, Some(vec![(1, 3), (8, 8)]));
        assert!(wish.hide);
        assert_eq!((wish.exit, wish.caption.as_str()), (1, "A ply, as it lies"));
        assert!(Wish::read("lines=3-1").is_err());
        assert!(Wish::read("hidden").is_err());
    }

    #[test]
    fn lines_are_cut_with_a_mark() {
        assert_eq!(cut("a\nb\nc\nd\n", &[(1, 1), (3, 3)]).unwrap(), "a\n…\nc\n…");
        assert_eq!(cut("a\nb\n", &[(1, 9)]).unwrap(), "a\nb");
        assert!(cut("a\n", &[(2, 3)]).unwrap_err().contains("1 lines"));
    }

    #[test]
    fn a_command_goes_on_after_a_backslash() {
        assert_eq!(
            commands(&["nply a \\", "  --b", "", "nply c"]),
            [(0, "nply a \\\n  --b".into()), (3, "nply c".into())]
        );
    }
}
