//! The numbers as a page of Markdown, and as JSON.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::published::{Published, Trust};
use crate::verdict::{Agreement, Row};

/// The page's table: what it comes to, then group by group.
pub(crate) fn markdown(published: &Published, rows: &[Row]) -> String {
    let mut page = summary(rows);
    for group in published.groups() {
        let of: Vec<&Row> = rows.iter().filter(|row| row.number.group == group).collect();
        let _ = write!(page, "\n## {group}\n\n{}", table(published, &of));
    }
    let _ = write!(page, "\n## Sources\n\n{}", sources(published));
    page
}

fn count(rows: &[Row], agreement: Agreement) -> usize {
    rows.iter().filter(|row| row.agreement() == agreement).count()
}

fn summary(rows: &[Row]) -> String {
    let memory = rows.iter().filter(|row| row.number.trust == Trust::Memory).count();
    let mut text = "| | numbers |\n|---|---|\n".to_owned();
    for (what, many) in [
        ("agree to every printed digit", count(rows, Agreement::Digits)),
        ("agree within the source's own tolerance", count(rows, Agreement::Tolerance)),
        ("differ, for a reason that is given", count(rows, Agreement::Differs)),
        ("cannot be worked out from what the source says", count(rows, Agreement::NotRemade)),
        ("**in all**", rows.len()),
        ("of these quoted from memory", memory),
    ] {
        let _ = writeln!(text, "| {what} | {many} |");
    }
    text
}

fn table(published: &Published, rows: &[&Row]) -> String {
    let mut text = "| | quantity and source | published | nply | difference |\n|---|---|---|---|---|\n".to_owned();
    let (mut reasons, mut commands) = (String::new(), String::new());
    for (index, row) in rows.iter().enumerate() {
        let (number, n) = (row.number, index + 1);
        let place = number.place.as_ref().map(|place| format!(", {place}")).unwrap_or_default();
        let source = format!("source [{}](#sources){place}{}", source_number(published, row), said_how(number.trust));
        let printed = number.printed.as_ref().map(|printed| format!("{printed} = ")).unwrap_or_default();
        let shown = minus(&number.published);
        let unit = match number.unit.as_str() {
            "–" => String::new(),
            "°" => "°".to_owned(),
            unit => format!(" {unit}"),
        };
        let ours = row.ours.map_or_else(|| "–".to_owned(), |value| shown_ours(row, value));
        let difference = match (row.agreement(), row.difference()) {
            (Agreement::Digits, _) => "every digit".to_owned(),
            (Agreement::Tolerance, Some(value)) => {
                format!("{}, within tolerance", signed(value, row.published.decimals + 1))
            }
            (_, Some(value)) => signed(value, row.published.decimals + 1),
            (_, None) => "not remade".to_owned(),
        };
        let quantity = &number.quantity;
        let _ = writeln!(
            text,
            "| {n} | {quantity}<br><small>{source}</small> | {printed}{shown}{unit} | {ours} | {difference} |"
        );
        if let Some(why) = &number.why {
            let _ = writeln!(reasons, "- **{n}** {why}");
        }
        if let (Some(within), Some(because)) = (number.within, &number.within_because) {
            let _ = writeln!(reasons, "- **{n}** within ±{within}: {because}");
        }
        let _ = match (&number.command, &number.path, &number.theory) {
            (Some(command), Some(path), _) => writeln!(commands, "{n}. `{command}`: `{path}`"),
            (_, _, Some(call)) => {
                writeln!(commands, "{n}. the library: `{call}` in `crates/nply-cli/examples/validate/theory.rs`")
            }
            _ => writeln!(commands, "{n}. none"),
        };
    }
    if !reasons.is_empty() {
        let _ = write!(text, "\nWhy they differ:\n\n{reasons}");
    }
    let _ = write!(text, "\n<details><summary>The commands</summary>\n\n{commands}\n</details>\n");
    text
}

/// Its place in the list of sources, from 1.
fn source_number(published: &Published, row: &Row) -> usize {
    published.sources.iter().position(|source| source.id == row.number.source).map_or(0, |place| place + 1)
}

fn sources(published: &Published) -> String {
    let mut text = String::new();
    for (index, source) in published.sources.iter().enumerate() {
        let link = source.link.as_ref().map(|link| format!(". <{link}>")).unwrap_or_default();
        let _ = writeln!(text, "{}. {}{link}", index + 1, source.cite);
    }
    text
}

fn said_how(trust: Trust) -> &'static str {
    match trust {
        Trust::Source => "",
        Trust::Press => " (press report)",
        Trust::Formula => " (by its formula)",
        Trust::Memory => " (**from memory**)",
    }
}

fn mark(agreement: Agreement) -> &'static str {
    match agreement {
        Agreement::Digits => "every digit",
        Agreement::Tolerance => "within",
        Agreement::Differs => "differs",
        Agreement::NotRemade => "not remade",
    }
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}

/// Two digits more than print has; of an exact number no zeros behind it.
fn shown_ours(row: &Row, value: f64) -> String {
    let text = rounded(value, row.published.decimals + 2);
    let whole = !row.number.exact || !text.contains('.');
    if whole { text } else { text.trim_end_matches('0').trim_end_matches('.').to_owned() }
}

/// A zero has no digits.
fn rounded(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let zero = text.trim_start_matches('-').chars().all(|letter| matches!(letter, '0' | '.'));
    if zero { "0".to_owned() } else { minus(&text) }
}

fn signed(value: f64, decimals: usize) -> String {
    let text = rounded(value, decimals);
    if value > 0.0 && text != "0" { format!("+{text}") } else { text }
}

/// Every number with all that is known of it.
pub(crate) fn json(published: &Published, rows: &[Row]) -> Value {
    let numbers = rows.iter().map(|row| {
        let number = row.number;
        let source = published.source(number);
        json!({
            "id": number.id,
            "group": number.group,
            "source": source.map(|source| &source.cite),
            "link": source.and_then(|source| source.link.as_ref()),
            "place": number.place,
            "trust": format!("{:?}", number.trust).to_lowercase(),
            "quantity": number.quantity,
            "unit": number.unit,
            "printed": number.printed,
            "published": row.published.value,
            "decimals": row.published.decimals,
            "command": number.command,
            "path": number.path,
            "theory": number.theory,
            "ours": row.ours,
            "difference": row.difference(),
            "stated_difference": number.difference,
            "holds": row.holds(),
            "agreement": mark(row.agreement()),
            "why": number.why,
        })
    });
    json!({
        "every_digit": count(rows, Agreement::Digits),
        "within": count(rows, Agreement::Tolerance),
        "differs": count(rows, Agreement::Differs),
        "not_remade": count(rows, Agreement::NotRemade),
        "numbers": numbers.collect::<Vec<_>>(),
    })
}
