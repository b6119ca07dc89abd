//! A page of the project's documentation taken in: `docs/symbols.md`, or `docs/json.md | Section` for one section of it.

use std::fs;

use crate::site::Site;

/// The page without its title, or the section without its heading.
pub(crate) fn expand(wish: &str, site: &Site) -> Result<String, String> {
    let (path, section) = wish.split_once('|').map_or((wish, ""), |(path, section)| (path.trim(), section.trim()));
    let text =
        fs::read_to_string(site.root.join(path.trim())).map_err(|error| format!("cannot read {path}: {error}"))?;
    if section.is_empty() {
        // a page of its own begins with its title, which the chapter has already
        return Ok(match text.split_once('\n') {
            Some((title, rest)) if depth(title) == 1 => rest.to_owned(),
            _ => text,
        });
    }
    let mut lines = text.lines();
    let heading = lines.by_ref().find(|line| line.starts_with('#') && line.trim_start_matches('#').trim() == section);
    let level = heading.map(depth).ok_or_else(|| format!("{path} has no section `{section}`"))?;
    let own = lines.take_while(|line| depth(line) == 0 || depth(line) > level);
    Ok(own.map(|line| format!("{line}\n")).collect())
}

/// The depth of a heading; 0 of what is none.
fn depth(line: &str) -> usize {
    let marks = line.bytes().take_while(|&b| b == b'#').count();
    if line[marks..].starts_with(' ') { marks } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    #[test]
    fn a_section_ends_where_the_next_begins() {
        let site = Site::here(PathBuf::new(), PathBuf::new(), PathBuf::new(), None);
        let page = expand("docs/symbols.md", &site).unwrap();
        assert!(page.contains("## Geometry") && !page.contains("# Symbols"));
        let section = expand("docs/symbols.md | Geometry", &site).unwrap();
        assert!(section.contains("`helical_angle`") && !section.contains("## "));
        assert!(expand("docs/symbols.md | Nothing", &site).is_err());
    }
}
