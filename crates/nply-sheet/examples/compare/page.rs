//! Tables and pictures in Markdown.

use base64::Engine as _;
use nply_sheet::plot::Chart;

/// A table: its head, then its rows.
pub(crate) fn table(head: &[String], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(head);
    text.push_str(&format!("|{}\n", "---|".repeat(head.len())));
    for row in rows {
        text.push_str(&line(&row));
    }
    text
}

/// A picture that stands in the page itself.
pub(crate) fn picture(chart: &Chart, caption: &str) -> String {
    let data = base64::engine::general_purpose::STANDARD.encode(chart.svg());
    format!(
        "\n<figure><img alt=\"{caption}\" src=\"data:image/svg+xml;base64,{data}\"><figcaption>{caption}</figcaption></figure>\n\n"
    )
}

/// A share as per cent, with its sign.
pub(crate) fn percent(share: f64) -> String {
    let text = format!("{:+.2} %", 100.0 * share);
    if text.trim_start_matches(['+', '-']) == "0.00 %" { "0".to_owned() } else { text.replace('-', "−") }
}

pub(crate) fn degrees(value: f64) -> String {
    format!("{value:.1}°")
}

/// Where a quantity that is below `limit` at `low` first reaches it, up to `high`; nothing if it never does.
pub(crate) fn first_above(of: impl Fn(f64) -> f64, limit: f64, low: f64, high: f64) -> Option<f64> {
    const STEPS: u32 = 2000;
    let place = |step: u32| low + (high - low) * f64::from(step) / f64::from(STEPS);
    let step = (1..=STEPS).find(|step| of(place(*step)) >= limit)?;
    let (mut low, mut high) = (place(step - 1), place(step));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if of(middle) < limit { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

/// Equally spaced numbers, both ends among them.
pub(crate) fn range(low: f64, high: f64, steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |step| low + (high - low) * f64::from(step) / f64::from(steps))
}
