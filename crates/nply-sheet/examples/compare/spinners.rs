//! The spinner's rules: ply with two thirds of the singles' twist, or with n/(n + 1) of it, against the ply that balances.

use std::error::Error;

use nply::geometry::HelicalAngle;
use nply::mechanics::Ply;
use nply_sheet::plot::{Axis, Chart, Curve};

use crate::page::{degrees, percent, picture, range, table};

/// Strands and stiffness ratio.
const PLIES: [(u32, f64); 4] = [(2, 0.75), (2, 1.0), (3, 0.75), (3, 1.0)];
const ANGLES: [f64; 8] = [5.0, 10.0, 15.0, 20.0, 25.0, 27.5, 30.0, 35.0];

/// Ply twist over singles' twist in balance.
fn ratio(strands: u32, stiffness_ratio: f64, angle: f64) -> Option<f64> {
    Ply::new(strands, stiffness_ratio).ok()?.twist_ratio(HelicalAngle::new(angle.to_radians()).ok()?)
}

fn two_thirds(_strands: u32) -> f64 {
    2.0 / 3.0
}

fn of_all_strands(strands: u32) -> f64 {
    f64::from(strands) / f64::from(strands + 1)
}

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let mut page = String::new();
    for (name, rule) in [("two thirds", two_thirds as fn(u32) -> f64), ("n/(n + 1)", of_all_strands)] {
        let mut head = vec![format!("{name}: angle of the balanced ply")];
        head.extend(PLIES.map(|(n, gamma)| format!("n = {n}, C/B = {gamma}")));
        let rows = ANGLES.map(|angle| {
            let cells = PLIES.map(|(n, gamma)| {
                ratio(n, gamma, angle).map_or_else(|| "–".to_owned(), |ratio| percent(rule(n) / ratio - 1.0))
            });
            [vec![degrees(angle)], cells.to_vec()].concat()
        });
        let mut last = vec!["**right at; within 1 %**".to_owned()];
        for (n, gamma) in PLIES {
            let ply = Ply::new(n, gamma)?;
            let at = |ratio: f64| ply.angle_of_twist_ratio(ratio).map(|angle| angle.degrees());
            let (low, middle, high) = (at(rule(n) / 0.99)?, at(rule(n))?, at(rule(n) / 1.01)?);
            last.push(format!("{}; {} to {}", degrees(middle), degrees(low), degrees(high)));
        }
        page.push_str(&table(&head, rows.into_iter().chain([last])));
        page.push('\n');
    }
    let x = Axis::new("angle of the balanced ply", "deg").with_range(0.0, 45.0);
    let mut chart = Chart::new("Ply twist over singles' twist", x, Axis::new("ratio", "").with_range(0.0, 1.0));
    for (n, gamma) in PLIES {
        let points = range(0.5, 44.5, 176).filter_map(|angle| Some((angle, ratio(n, gamma, angle)?)));
        chart = chart.with_curve(Curve::new(format!("n = {n}, C/B = {gamma}"), points));
    }
    chart = chart.with_curve(Curve::new("two thirds", [(0.0, 2.0 / 3.0), (45.0, 2.0 / 3.0)]).dashed());
    page.push_str(&picture(&chart, "Ply twist per ply length over singles' twist, in balance, and the rule."));
    Ok(page)
}
