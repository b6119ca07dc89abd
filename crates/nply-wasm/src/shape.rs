//! What a ply looks like.

use core::f64::consts::TAU;

use nply::geometry::{Centreline, Contact, ContactLine, HelicalAngle, Section};
use nply::{DomainError, Handedness};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::strands::hand;

/// The outline of strand 0 in the plane z = 0 across the ply, x and y of `points` points, in units of r; the cut at another height, and of
/// another strand, is turned by the azimuth there. `radius_ratio` is R/r, `helical_angle` in rad.
#[wasm_bindgen]
#[must_use]
pub fn outline(strands: u32, helical_angle: f64, radius_ratio: f64, handedness: f64, points: usize) -> Vec<f64> {
    let section = HelicalAngle::new(helical_angle)
        .and_then(|angle| Section::on_helix(strands, radius_ratio, angle, hand(handedness)));
    let Ok(section) = section else { return Vec::new() };
    (0..points).flat_map(|i| section.outline(0, 0.0, TAU * i as f64 / points as f64)).collect()
}

/// Where round its section a strand touches its neighbours, as angles α of (9)–(10) (π/2 towards the axis), and the radius and azimuth (at z = 0,
/// about the axis, from x towards y) of the contact line between strands 0 and 1: four numbers, lengths in units of r.
#[wasm_bindgen]
#[must_use]
pub fn touching_sides(strands: u32, helical_angle: f64, handedness: f64) -> Vec<f64> {
    touching(strands, helical_angle, hand(handedness)).unwrap_or_default()
}

fn touching(strands: u32, helical_angle: f64, hand: Handedness) -> Result<Vec<f64>, DomainError> {
    let contact = Contact::at_angle(strands, HelicalAngle::new(helical_angle)?)?;
    let line = ContactLine::new(&contact, hand);
    // the touching section of strand 0 lies half the shift before the contact point, that of strand 1 as far behind it
    let side = |strand: u32, s: f64| {
        let frame = Centreline::new(&contact, hand, strand);
        let (centre, point) = (frame.position(s), line.position(0.0));
        let frame = frame.frame(s);
        let away: [f64; 3] = core::array::from_fn(|i| point[i] - centre[i]);
        let along = |axis: [f64; 3]| (0..3).map(|i| away[i] * axis[i]).sum::<f64>();
        // (10): cos α along the binormal, sin α along the normal, which points to the axis
        libm::atan2(along(frame.normal), along(frame.binormal))
    };
    let [x, y, _] = line.position(0.0);
    Ok(vec![
        side(0, -0.5 * line.shift()),
        side(1, 0.5 * line.shift()),
        line.radius(),
        if line.radius() > 0.0 { libm::atan2(y, x) } else { 0.0 },
    ])
}
