//! Points outside an open curve, over which to close it for a count of crossings.

use crate::numerics::vector::{Vector, add, cross, dot, norm, sub, times, unit};

/// Points over which to close an open curve, those first whose segments keep farthest from it.
pub(crate) fn closures(points: &[Vector]) -> Vec<Vector> {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in points {
        for k in 0..3 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let centre = times(0.5, add(low, high));
    let radius = norm(sub(high, low));
    let ends = [points[0], points[points.len() - 1]];
    let mut apexes: Vec<(f64, Vector)> = (0..CLOSURES)
        .map(|k| {
            // even over the sphere, on a spiral
            let height = 1.0 - (2.0 * k as f64 + 1.0) / CLOSURES as f64;
            let (sin, cos) = libm::sincos(2.399_963_229_728_653 * k as f64 + 0.7);
            let across = (1.0 - height * height).sqrt();
            let apex = add(centre, times(radius, [across * cos, across * sin, height]));
            (clearance(points, ends, apex), apex)
        })
        .collect();
    apexes.sort_by(|a, b| b.0.total_cmp(&a.0));
    apexes.into_iter().map(|(_, apex)| apex).collect()
}

/// How many points there are to choose from.
pub(crate) const CLOSURES: usize = 24;

/// How closely the curve, at a sample of its points, comes to the lines from its ends to a point, as a share of the way from the end.
fn clearance(points: &[Vector], ends: [Vector; 2], apex: Vector) -> f64 {
    let step = points.len().div_ceil(256);
    let mut least = f64::INFINITY;
    for end in ends {
        let line = unit(sub(apex, end));
        for p in points.iter().step_by(step) {
            let r = sub(*p, end);
            let away = norm(r);
            if away > 0.0 {
                let beside = if dot(r, line) > 0.0 { norm(cross(r, line)) } else { away };
                least = least.min(beside / away);
            }
        }
    }
    least
}
