//! Lay radius of n wires that touch: three formulas against the helices themselves.

use std::error::Error;
use std::f64::consts::PI;

use nply::DomainError;
use nply::geometry::Contact;
use nply_sheet::plot::{Axis, Chart, Curve};

use crate::page::{degrees, first_above, percent, picture, range, table};

/// R/r of wires cut as circles.
pub(crate) fn flat(wires: u32, _angle: f64) -> f64 {
    1.0 / (PI / f64::from(wires)).sin()
}

/// R/r of wires cut as ellipses.
pub(crate) fn ellipse(wires: u32, angle: f64) -> f64 {
    let half = PI / f64::from(wires);
    1.0f64.hypot(half.cos() / (half.sin() * angle.cos()))
}

/// R/r of wires whose widths d/cos θ, one after the other, fill the circle of lay.
pub(crate) fn perimeter(wires: u32, angle: f64) -> f64 {
    f64::from(wires) / (PI * angle.cos())
}

/// R/r of helical tubes that touch.
pub(crate) fn exact(wires: u32, angle: f64) -> Result<f64, DomainError> {
    Contact::new(wires, angle).map(|contact| contact.radius_ratio())
}

/// The error of a formula: of its radius, and at that radius of the gap over the wire's diameter.
pub(crate) fn error(formula: fn(u32, f64) -> f64, wires: u32, angle: f64) -> f64 {
    exact(wires, angle).map_or(f64::NAN, |exact| formula(wires, angle) / exact - 1.0)
}

const WIRES: [u32; 5] = [2, 3, 6, 12, 24];
const ANGLES: [f64; 9] = [2.0, 5.0, 8.5, 12.0, 15.0, 20.0, 25.0, 30.0, 40.0];
type Formula = (&'static str, fn(u32, f64) -> f64);
const FORMULAS: [Formula; 3] = [("flat", flat), ("perimeter", perimeter), ("ellipse", ellipse)];

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let mut page = String::new();
    for (name, formula) in FORMULAS {
        let mut head = vec![format!("{name}: lay angle")];
        head.extend(WIRES.map(|n| format!("n = {n}")));
        let rows = ANGLES.map(|angle| {
            let cells = WIRES.map(|n| percent(error(formula, n, angle.to_radians())));
            [vec![degrees(angle)], cells.to_vec()].concat()
        });
        page.push_str(&table(&head, rows));
        page.push('\n');
    }
    page.push_str(&good_enough());
    let x = Axis::new("lay angle", "deg").with_range(0.0, 45.0);
    let mut chart =
        Chart::new("Lay radius by formula, less the true one", x, Axis::new("error", "%").with_range(-20.0, 1.0));
    for n in [3, 6, 24] {
        for (name, formula) in FORMULAS {
            let points = range(0.0, 45.0, 180).map(|angle| (angle, 100.0 * error(formula, n, angle.to_radians())));
            let curve = Curve::new(format!("{name}, n = {n}"), points);
            if name != "perimeter" {
                chart = chart.with_curve(if name == "flat" { curve.dashed() } else { curve });
            }
        }
    }
    page.push_str(&picture(
        &chart,
        "Error of the lay radius by the flat and the ellipse formula, against the lay angle.",
    ));
    Ok(page)
}

/// Up to which angle each is within one per cent.
fn good_enough() -> String {
    let mut head = vec!["**error below 1 % up to**".to_owned()];
    head.extend(WIRES.map(|n| format!("n = {n}")));
    let rows = FORMULAS.map(|(name, formula)| {
        let limits = WIRES.map(|n| {
            let error = |angle: f64| error(formula, n, angle.to_radians()).abs();
            match first_above(error, 0.01, 0.0, 89.0) {
                None => "89°".to_owned(),
                _ if error(0.0) >= 0.01 => "not at small angles".to_owned(),
                Some(angle) => degrees(angle),
            }
        });
        [vec![name.to_owned()], limits.to_vec()].concat()
    });
    table(&head, rows)
}
