//! Start geometry of beams: six wires as thick as their king wire, laid at R = 2r as the flat formula says.

use std::error::Error;

use nply::geometry::{Chords, HelicalAngle};
use nply_sheet::plot::{Axis, Chart, Curve};

use crate::page::{degrees, picture, range, table};

const WIRES: u32 = 6;
const RADIUS: f64 = 2.0;
const ELEMENTS: [u32; 4] = [12, 24, 48, 96];

/// Overlap of neighbours in wire diameters: as helices, then with so many elements a lay length, nodes side by side.
fn overlap(angle: f64, elements: Option<u32>) -> Result<f64, Box<dyn Error>> {
    let lay =
        Chords::new(WIRES, HelicalAngle::new(angle.to_radians())?, elements.unwrap_or(3))?.laid(RADIUS, Some(0.0));
    Ok(1.0 - 0.5 * elements.map_or(lay.smooth_distance, |_| lay.least_distance))
}

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let mut head = vec!["lay angle".to_owned(), "helices".to_owned()];
    head.extend(ELEMENTS.map(|count| format!("{count} elements")));
    head.push("R that clears 24 elements".to_owned());
    let mut rows = Vec::new();
    for angle in [5.0, 8.5, 10.0, 12.0, 15.0, 17.44, 20.0] {
        let mut row = vec![degrees(angle), size(overlap(angle, None)?)];
        for count in ELEMENTS {
            row.push(size(overlap(angle, Some(count))?));
        }
        let clear =
            Chords::new(WIRES, HelicalAngle::new(f64::to_radians(angle))?, 24)?.narrowest(2.0, 0.0, Some(0.0))?;
        row.push(format!("{:.4} r", clear.radius_ratio));
        rows.push(row);
    }
    let mut page = table(&head, rows);
    let x = Axis::new("lay angle", "deg").with_range(0.0, 25.0);
    let mut chart = Chart::new("Overlap of six wires laid at R = 2r", x, Axis::new("overlap/wire diameter", "%"));
    for (name, elements) in [("helices", None), ("24 elements", Some(24)), ("12 elements", Some(12))] {
        let points: Result<Vec<_>, Box<dyn Error>> =
            range(0.25, 25.0, 99).map(|angle| Ok((angle, 100.0 * overlap(angle, elements)?))).collect();
        chart = chart.with_curve(Curve::new(name, points?));
    }
    page.push_str(&picture(
        &chart,
        "Overlap of neighbouring wires in per cent of their diameter, against the lay angle.",
    ));
    Ok(page)
}

fn size(overlap: f64) -> String {
    format!("{:.2} %", 100.0 * overlap)
}
