//! A figure or table of the paper, drawn by `nply figure`: `4 | caption`.

use crate::command::{Bench, Runner};
use crate::picture;
use crate::site::Site;

/// The figure in the page, on light and on dark ground.
pub(crate) fn expand(wish: &str, chapter: &str, site: &Site, runner: &Runner) -> Result<String, String> {
    let (name, caption) = wish.split_once('|').map_or((wish, ""), |(name, caption)| (name.trim(), caption.trim()));
    let name = name.trim();
    let figure = name.replace("table-", "table");
    let file = if name.starts_with("table") { name.to_owned() } else { format!("figure-{name}") };
    let mut bench = Bench::new(site.made.join("figures"));
    for (ground, name) in [("", format!("{file}.svg")), (" --dark", format!("{file}-dark.svg"))] {
        let said = runner.run(&bench.place(&format!("nply figure {figure} --output {name}{ground}")))?;
        if said.code != Some(0) {
            return Err(said.error.trim_end().to_owned());
        }
    }
    let folder = format!("{}figures/", picture::to_made(chapter));
    let dark = format!("{folder}{file}-dark.svg");
    Ok(format!("\n{}\n", picture::figure(&format!("{folder}{file}.svg"), Some(&dark), caption)))
}
