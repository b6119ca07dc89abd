//! What a link can point at within a chapter: headings, as mdBook names them, and what has an `id`.

use std::collections::BTreeSet;

use crate::fence::{Piece, pieces};

/// The anchors of an expanded chapter.
pub(crate) fn anchors(text: &str) -> BTreeSet<String> {
    let mut anchors = BTreeSet::new();
    for piece in pieces(text) {
        let Piece::Prose { text, .. } = piece else { continue };
        for line in text.lines() {
            let heading = line.trim_start_matches('#');
            if heading.len() < line.len() && heading.starts_with(' ') {
                let named = heading.trim_end().strip_suffix('}').and_then(|rest| rest.rsplit_once("{#"));
                let mut name = named.map_or_else(|| of_heading(heading), |(_, name)| name.to_owned());
                let first = name.clone();
                let mut count = 0;
                while !anchors.insert(name.clone()) {
                    count += 1;
                    name = format!("{first}-{count}");
                }
            }
            for (at, mark) in line.match_indices(" id=\"") {
                anchors.extend(line[at + mark.len()..].split('"').next().map(str::to_owned));
            }
        }
    }
    anchors
}

/// The name mdBook gives a heading.
fn of_heading(heading: &str) -> String {
    let text = heading.trim().replace(['`', '*'], "");
    text.chars()
        .filter_map(|letter| match letter {
            _ if letter.is_alphanumeric() || letter == '_' || letter == '-' => {
                Some(letter.to_lowercase().next().unwrap_or(letter))
            }
            _ if letter.is_whitespace() => Some('-'),
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_and_ids_are_anchors() {
        let text = "# What `nply` says: two\n\n## A {#b}\n\n```sh\n# none\n```\n<a id=\"c\"></a>\n## Again\n## Again\n";
        let wanted = ["what-nply-says-two", "b", "c", "again", "again-1"].map(str::to_owned);
        assert_eq!(anchors(text), BTreeSet::from(wanted));
    }
}
