//! How many wires fit on a core.

use std::error::Error;

use crate::layers::{ellipse, exact, flat};
use crate::page::{degrees, table};

/// Rounding in a radius that is just enough.
const SLACK: f64 = 1e-12;

/// The most wires whose touching radius is at most `radius` (in wire radii).
fn most(touching: impl Fn(u32) -> f64, radius: f64) -> u32 {
    (2..).take_while(|wires| touching(*wires) <= radius * (1.0 + SLACK)).last().unwrap_or(1)
}

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let head = ["core/wire diameter", "lay angle", "flat", "ellipse", "exact", "wires too many: flat, ellipse"];
    let mut rows = Vec::new();
    for core in [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 40.0_f64] {
        for angle in [5.0, 10.0, 20.0, 30.0_f64] {
            let (radius, theta) = (1.0 + core, angle.to_radians());
            let counts = [
                most(|n| flat(n, theta), radius),
                most(|n| ellipse(n, theta), radius),
                most(|n| exact(n, theta).unwrap_or(f64::INFINITY), radius),
            ];
            let [by_circles, by_ellipses, fit] = counts;
            let mut row = vec![format!("{core}"), degrees(angle)];
            row.extend(counts.map(|count| count.to_string()));
            row.push(format!("{}, {}", by_circles - fit, by_ellipses - fit));
            rows.push(row);
        }
    }
    Ok(table(&head.map(str::to_owned), rows))
}
