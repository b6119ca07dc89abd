//! Twisted strings: the formula of a constant radius against strings that cannot pass through each other.

use std::error::Error;

use nply::mechanics::{ConstantRadius, TwistedStrings};
use nply_sheet::plot::{Axis, Chart, Curve};

use crate::page::{first_above, percent, picture, range, table};

const STRINGS: [u32; 4] = [2, 3, 4, 6];
const SHARES: [f64; 8] = [0.1, 0.25, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99];

/// A formula's stroke and torque over the true ones, less 1, at a share of the most turns.
fn errors(strings: u32, share: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let rotation = share * TwistedStrings::most_turns(strings)?.rotation();
    let (real, formula) = (TwistedStrings::new(strings, rotation)?, ConstantRadius::new(strings)?);
    let none = "the formula has no triangle there";
    let (extension, lever) = (formula.extension(rotation).ok_or(none)?, formula.lever(rotation).ok_or(none)?);
    Ok(((1.0 - extension) / real.contraction() - 1.0, lever / real.lever() - 1.0))
}

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let mut page = String::new();
    for (what, of) in [("stroke", 0), ("torque", 1)] {
        let mut head = vec![format!("{what}: share of the most turns")];
        head.extend(STRINGS.map(|n| format!("n = {n}")));
        let mut rows = Vec::new();
        for share in SHARES {
            let mut row = vec![format!("{:.0} %", 100.0 * share)];
            for n in STRINGS {
                let (stroke, torque) = errors(n, share)?;
                row.push(percent(if of == 0 { stroke } else { torque }));
            }
            rows.push(row);
        }
        let mut within = vec!["**below 1 % up to**".to_owned()];
        for n in STRINGS {
            let size = |share: f64| {
                errors(n, share).map_or(f64::INFINITY, |(stroke, torque)| if of == 0 { stroke } else { torque }.abs())
            };
            within.push(
                first_above(size, 0.01, 1e-3, 0.9999)
                    .map_or_else(|| "the end".to_owned(), |share| format!("{:.0} %", 100.0 * share)),
            );
        }
        rows.push(within);
        page.push_str(&table(&head, rows));
        page.push('\n');
    }
    page.push_str(&limits()?);
    let x = Axis::new("share of the most turns", "%").with_range(0.0, 100.0);
    let y = Axis::new("error of the torque", "%").with_range(-60.0, 5.0);
    let mut chart = Chart::new("Torque by constant radius, less the true one", x, y);
    for n in STRINGS {
        let points: Result<Vec<_>, Box<dyn Error>> =
            range(0.005, 0.995, 198).map(|share| Ok((100.0 * share, 100.0 * errors(n, share)?.1))).collect();
        chart = chart.with_curve(Curve::new(format!("n = {n}"), points?));
    }
    page.push_str(&picture(&chart, "Error of the torque, against the share of the most turns that the strings take."));
    Ok(page)
}

/// Where strings jam, and where the formula thinks they do.
fn limits() -> Result<String, Box<dyn Error>> {
    let head = [
        "strings",
        "jam at",
        "formula's end",
        "turns it promises beyond",
        "stroke at the end",
        "by the formula at its own",
    ];
    let mut rows = Vec::new();
    for n in STRINGS {
        let (real, formula) = (TwistedStrings::most_turns(n)?, ConstantRadius::new(n)?);
        let stroke = formula.extension(formula.most_turns()).map_or(f64::NAN, |extension| 1.0 - extension);
        rows.push(vec![
            n.to_string(),
            format!("{:.2}°", real.contact().angle().degrees()),
            format!("{:.2}°", formula.steepest().degrees()),
            percent(formula.most_turns() / real.rotation() - 1.0),
            format!("{:.1} %", 100.0 * real.contraction()),
            format!("{:.1} %", 100.0 * stroke),
        ]);
    }
    Ok(table(&head.map(str::to_owned), rows))
}
