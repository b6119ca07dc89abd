//! The equations' texts, as rustdoc shows them, in the book: Markdown, its blocks of formulas set.

use std::fs;
use std::path::Path;

use crate::fence::{Piece, pieces};
use crate::math::place;
use crate::typeset;

/// The page on which every equation stands.
pub(crate) const PAGE: &str = "theory/equations.md";

/// All equations, in the order of the paper, then those that are not in it by name.
#[derive(Debug)]
pub struct Equations {
    all: Vec<Equation>,
}

#[derive(Debug)]
struct Equation {
    /// The file's name without ending: `eq34_36`, `eqA05`, `kepler`.
    file: String,
    /// The numbers it carries, first and last.
    numbers: Option<Numbers>,
    /// The file.
    text: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Numbers {
    appendix: bool,
    first: u32,
    last: u32,
}

impl Numbers {
    /// Of a file's name.
    fn of(file: &str) -> Option<Self> {
        let rest = file.strip_prefix("eq")?;
        let (appendix, rest) = rest.strip_prefix('A').map_or((false, rest), |rest| (true, rest));
        let (first, last) = rest.split_once('_').unwrap_or((rest, rest));
        Some(Self { appendix, first: first.parse().ok()?, last: last.parse().ok()? })
    }

    fn shown(self, number: u32) -> String {
        if self.appendix { format!("A.{number}") } else { number.to_string() }
    }

    /// The number, or the first and the last.
    fn title(self) -> String {
        let first = format!("({})", self.shown(self.first));
        if self.last == self.first { first } else { format!("{first}–({})", self.shown(self.last)) }
    }
}

impl Equations {
    /// Reads the folder of equations.
    ///
    /// # Errors
    /// A sentence, where it cannot be read.
    pub fn read(root: &Path) -> Result<Self, String> {
        let folder = root.join("crates/nply/src/equations");
        let wrong = |error: std::io::Error| format!("cannot read {}: {error}", folder.display());
        let mut all = Vec::new();
        for entry in fs::read_dir(&folder).map_err(wrong)? {
            let path = entry.map_err(wrong)?.path();
            let Some(file) = path.file_name().and_then(|name| name.to_str()?.strip_suffix(".md")) else { continue };
            let text = fs::read_to_string(&path).map_err(wrong)?;
            all.push(Equation { file: file.to_owned(), numbers: Numbers::of(file), text });
        }
        all.sort_by_key(|equation| match equation.numbers {
            Some(numbers) => (u8::from(numbers.appendix), numbers.first, String::new()),
            None => (2, 0, equation.file.clone()),
        });
        Ok(Self { all })
    }

    /// The equation of a number such as `38`, `A.5` or of a file's name.
    fn find(&self, wish: &str) -> Result<&Equation, String> {
        let (appendix, digits) =
            wish.strip_prefix('A').map_or((false, wish), |rest| (true, rest.trim_start_matches('.')));
        let number: Option<u32> = digits.parse().ok();
        let is_wished = |equation: &&Equation| match (number, equation.numbers) {
            (Some(number), Some(numbers)) => {
                numbers.appendix == appendix && (numbers.first..=numbers.last).contains(&number)
            }
            _ => equation.file == wish,
        };
        self.all.iter().find(is_wished).ok_or_else(|| format!("there is no equation `{wish}`"))
    }

    /// One equation in a chapter, its number leading to the page of all.
    pub(crate) fn one(&self, wish: &str, chapter: &str) -> Result<String, String> {
        let equation = self.find(wish)?;
        let up = "../".repeat(chapter.matches('/').count());
        let title = equation.title();
        let anchor = &equation.file;
        Ok(format!(
            "\n<div class=\"equation\">\n\n<p class=\"number\"><a href=\"{up}{}#{anchor}\">{title}</a></p>\n\n{}\n</div>\n\n",
            PAGE.replace(".md", ".html"),
            equation.page()?
        ))
    }

    /// Every equation, each with its anchor.
    pub(crate) fn all(&self) -> Result<String, String> {
        let mut page = String::new();
        let mut part = None;
        for equation in &self.all {
            let own = equation.numbers.map(|numbers| numbers.appendix);
            if part != Some(own) {
                part = Some(own);
                page.push_str(match own {
                    Some(false) => "\n## Of the paper\n",
                    Some(true) => "\n## Of the paper's appendix: link, twist, writhe\n",
                    None => "\n## Beyond the paper\n",
                });
            }
            page.push_str(&format!("\n### {} {{#{}}}\n\n{}", equation.title(), equation.file, equation.page()?));
        }
        Ok(page)
    }

    /// Names of all files, and the LaTeX of each block of formulas.
    ///
    /// # Errors
    /// A sentence that names the file, where a block cannot be read.
    pub fn latex(&self) -> Result<Vec<(String, String)>, String> {
        let mut all = Vec::new();
        for equation in &self.all {
            let page = equation.page()?;
            all.extend(crate::math::formulas(&page).into_iter().map(|(latex, _)| (equation.file.clone(), latex)));
        }
        Ok(all)
    }
}

impl Equation {
    fn title(&self) -> String {
        match self.numbers {
            Some(numbers) => numbers.title(),
            None => {
                let words = self.file.replace('_', " ");
                let mut letters = words.chars();
                letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
            }
        }
    }

    /// The text, its formulas set; the first block of a file with one number carries it.
    fn page(&self) -> Result<String, String> {
        let mut number = self.numbers.filter(|numbers| numbers.first == numbers.last).map(|n| n.shown(n.first));
        let mut page = String::new();
        for piece in pieces(&self.text) {
            match piece {
                Piece::Prose { text, .. } => page.push_str(&typeset::prose(text)),
                Piece::Fence { info: "text", lines, line, .. } => {
                    let blocks = typeset::set(&lines.join("\n"), number.take().as_deref())
                        .map_err(|why| format!("{}.md:{line}: {why}", self.file))?;
                    for block in blocks {
                        page.push_str(&match block {
                            typeset::Block::Formula(latex) => format!("{}\n\n", place(&latex, true)),
                            typeset::Block::Prose(text) => format!("{}\n\n", typeset::prose(&text)),
                        });
                    }
                }
                Piece::Fence { whole, .. } => page.push_str(whole),
            }
        }
        page.push('\n');
        Ok(page)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_equation_is_found_by_number_and_by_name() {
        let equations = Equations::read(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))).unwrap();
        let file = |wish: &str| equations.find(wish).map(|equation| equation.file.as_str());
        assert_eq!(file("38"), Ok("eq38"));
        assert_eq!(file("35"), Ok("eq34_36"));
        assert_eq!(file("A.5"), Ok("eqA05"));
        assert_eq!(file("kepler"), Ok("kepler"));
        assert!(file("99").is_err());
        assert_eq!(equations.find("35").unwrap().title(), "(34)–(36)");
        assert_eq!(equations.find("contact_balance").unwrap().title(), "Contact balance");
    }

    #[test]
    fn the_page_of_all_has_every_file() {
        let equations = Equations::read(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))).unwrap();
        let page = equations.all().unwrap();
        for equation in &equations.all {
            assert!(page.contains(&format!("{{#{}}}", equation.file)), "{}", equation.file);
        }
        assert!(page.find("{#eq01}") < page.find("{#eq75}").or(page.find("{#eq72_75}")));
        assert!(page.find("{#eq72_75}") < page.find("{#eqA01}") && page.find("{#eqA32}") < page.find("{#kepler}"));
    }
}
