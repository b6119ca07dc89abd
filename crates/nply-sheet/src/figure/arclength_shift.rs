//! Figures 1 and 3: every solution of the contact condition (5), as arclength shift over angle.

use core::f64::consts::{PI, TAU};

use nply::DomainError;
use nply::geometry::{BranchKind, branch_at_anomaly};

use super::{Data, Parts};
use crate::plot::sample::{sampled, steps};
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape, Picture};

/// The axis of x reaches so far up and down.
const REACH: f64 = 11.0;

pub(super) fn two() -> Result<Parts, DomainError> {
    let (chart, data) = draw(2)?;
    let chart = chart.with_marker(Marker::new("pitchfork, 45°", 45.0, 0.0, MarkerShape::Diamond).with_colour(6));
    Ok(Parts::charts(
        "Two strands touch in a straight line, without any shift, up to 45°. There the line splits: what was the place of \
         least distance becomes one of greatest distance (dashed, the strands would overlap), and a pair of mirror images takes \
         over, which ends at x = ±π for flat rings. The remaining solutions come from flat rings and go back to them; strands laid by \
         them overlap.",
        data,
        Picture::row([chart]),
    ))
}

pub(super) fn three() -> Result<Parts, DomainError> {
    let (chart, data) = draw(3)?;
    Ok(Parts::charts(
        "Three strands are never without shift: the pitchfork of two strands comes apart, and one branch runs from straight strands \
         to flat rings, with slope sin 120° at its beginning and x = 2π/3 at its end. It alone keeps the strands from overlapping. \
         More strands look the same.",
        data,
        Picture::row([chart]),
    ))
}

fn draw(strands: u32) -> Result<(Chart, Data), DomainError> {
    let mut data = Data::new(["curve", "helical_angle_deg", "arclength_shift", "radius_ratio"]);
    let mut chart = Chart::new(
        "",
        Axis::new("helical angle θ", "deg").with_range(0.0, 90.0).with_step(15.0),
        Axis::new("arclength shift x", "R").with_range(-REACH, REACH).with_step(2.0),
    )
    .with_size(520.0, 380.0);
    let lambda = TAU / f64::from(strands);
    let mut add = |chart: Chart, word: &str, points: Vec<(f64, f64, f64)>, curve: fn(Curve) -> Curve| {
        for &(angle, x, rho) in &points {
            data.push([word.into(), angle.into(), x.into(), rho.into()]);
        }
        let name = match word {
            "main" => "touching strands",
            "line" => "line contact (overlap)",
            _ => "other solutions (overlap)",
        };
        chart.with_curve(curve(Curve::new(name, points.into_iter().map(|(angle, x, _)| (angle, x)))))
    };
    if strands == 2 {
        let line = |from: u32, to: u32| (from..=to).map(|angle| (f64::from(angle), 0.0, 1.0)).collect();
        chart = add(chart, "main", line(0, 45), |curve| curve.with_colour(0).with_width(2.6));
        chart = add(chart, "line", line(45, 90), |curve| curve.with_colour(0).dashed());
    }
    // between neighbouring multiples of π, and 2π/n, each curve runs once; those that end beyond the axis are left out
    let furthest = 8;
    for k in (0..furthest).chain(-furthest..0) {
        let (from, to) = (PI * f64::from(k), PI * f64::from(k + 1));
        let to = if k == 0 { to.min(lambda) } else { to };
        let point = |share: f64| {
            let eased = share * share * (3.0 - 2.0 * share);
            let (angle, branch) = branch_at_anomaly(strands, from + (to - from) * eased).ok()??;
            Some((angle.degrees(), branch))
        };
        let Some((_, middle)) = point(0.5) else { continue };
        let place = |(angle, branch): &(f64, nply::geometry::Branch)| {
            vec![angle / 90.0, 0.5 + 0.5 * branch.arclength_shift / REACH]
        };
        for run in sampled(point, place, &steps(1e-4, 1.0 - 1e-4, 40)) {
            let mut points: Vec<(f64, f64, f64)> =
                run.iter().map(|(_, (angle, branch))| (*angle, branch.arclength_shift, branch.radius_ratio)).collect();
            points.retain(|(_, x, rho)| x.abs() < 1.5 * REACH && rho.is_finite());
            if points.is_empty() {
                continue;
            }
            chart = match middle.kind {
                BranchKind::Main => {
                    // its limit at flat rings or straight strands, where it has no anomaly within reach
                    if strands > 2 {
                        points.push((0.0, 0.0, 1.0 / libm::sin(0.5 * lambda)));
                        points.sort_by(|a, b| a.0.total_cmp(&b.0));
                    }
                    add(chart, "main", points, |curve| curve.with_colour(0).with_width(2.6))
                }
                _ => add(chart, "satellite", points, |curve| curve.with_colour(3).dashed()),
            };
        }
    }
    Ok((chart, data))
}
