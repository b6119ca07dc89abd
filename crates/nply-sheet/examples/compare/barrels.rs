//! Radii of coiled coils and of barrels of strands: guesses from straight packing against touching helices.

use std::error::Error;
use std::f64::consts::PI;

use nply_sheet::plot::{Axis, Chart, Curve};

use crate::layers::{error, exact, flat};
use crate::page::{degrees, first_above, percent, picture, range, table};

/// Name, helices, superhelix radius and pitch in Å: the basis set of the open programs ISAMBARD and AMPAL, as in `nply preset`.
const COILS: [(&str, u32, f64, f64); 6] = [
    ("CC-Di", 2, 5.07, 225.8),
    ("CC-Tri", 3, 6.34, 194.0),
    ("CC-Tet", 4, 6.81, 213.2),
    ("CC-Pent", 5, 8.62, 182.8),
    ("CC-Hex", 6, 9.13, 228.4),
    ("CC-Hept", 7, 9.80, 328.6),
];

/// R/r of n strands a distance 2r apart on a barrel, their tilt α: b/(2 sin(π/n) cos α).
fn barrel(strands: u32, tilt: f64) -> f64 {
    flat(strands, tilt) / tilt.cos()
}

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let head = ["coiled coil", "helices", "angle", "helix radius, R sin(π/n)", "exact, R/ρ(θ)", "guess too large by"];
    let mut rows = Vec::new();
    for (name, helices, radius, pitch) in COILS {
        let angle = (2.0 * PI * radius / pitch).atan();
        let (guess, real) = (radius / flat(helices, angle), radius / exact(helices, angle)?);
        let cells = [format!("{guess:.3} Å"), format!("{real:.3} Å"), percent(guess / real - 1.0)];
        rows.push([vec![name.to_owned(), helices.to_string(), degrees(angle.to_degrees())], cells.to_vec()].concat());
    }
    let mut page = table(&head.map(str::to_owned), rows);
    page.push('\n');

    const STRANDS: [u32; 5] = [6, 8, 12, 16, 22];
    const TILTS: [f64; 6] = [10.0, 20.0, 30.0, 36.0, 45.0, 56.0];
    let mut head = vec!["tilt α".to_owned()];
    head.extend(STRANDS.map(|n| format!("n = {n}")));
    let rows = TILTS.map(|tilt| {
        let cells = STRANDS.map(|n| percent(error(barrel, n, tilt.to_radians())));
        [vec![degrees(tilt)], cells.to_vec()].concat()
    });
    let within = STRANDS.map(|n| {
        let size = |tilt: f64| error(barrel, n, tilt.to_radians()).abs();
        first_above(size, 0.01, 0.0, 89.0).map_or_else(|| "89°".to_owned(), degrees)
    });
    let last = [vec!["**below 1 % up to**".to_owned()], within.to_vec()].concat();
    page.push_str(&table(&head, rows.into_iter().chain([last])));

    let x = Axis::new("tilt", "deg").with_range(0.0, 60.0);
    let mut chart = Chart::new("Barrel radius by formula, less that of touching strands", x, Axis::new("error", "%"));
    for n in [4, 8, 16] {
        let points = range(0.0, 60.0, 120).map(|tilt| (tilt, 100.0 * error(barrel, n, tilt.to_radians())));
        chart = chart.with_curve(Curve::new(format!("n = {n}"), points));
    }
    page.push_str(&picture(&chart, "Error of b/(2 sin(π/n) cos α), against the tilt of the strands."));
    Ok(page)
}
