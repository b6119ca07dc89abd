//! Points outside an open curve, over which to close it for a count of crossings.

use crate::numerics::vector::{Vector, add, cross, dot, norm, sub, times, unit};

/// Pairs of points over which to close an open curve by three segments, those first whose segments keep farthest from it.
///
/// Two, so that where its ends lie close together there is no hairpin, about which a twist would be ill defined.
pub(crate) fn closures(points: &[Vector]) -> Vec<[Vector; 2]> {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in points {
        for k in 0..3 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let centre = times(0.5, add(low, high));
    // twice that of a sphere round all points
    let radius = norm(sub(high, low));
    let (first, last) = (points[0], points[points.len() - 1]);
    // even over the sphere, on a spiral
    let apexes = (0..APEXES).map(|k| {
        let height = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(APEXES);
        let (sin, cos) = libm::sincos(2.399_963_229_728_653 * f64::from(k) + 0.7);
        let across = (1.0 - height * height).sqrt();
        add(centre, times(radius, [across * cos, across * sin, height]))
    });
    let apexes: Vec<_> =
        apexes.map(|apex| (apex, clearance(points, last, apex), clearance(points, first, apex))).collect();
    let mut pairs = Vec::new();
    for &(p, from, _) in &apexes {
        for &(q, _, to) in &apexes {
            // the line between them stays outside that sphere
            if (0.6 * radius..1.3 * radius).contains(&norm(sub(p, q))) {
                pairs.push((f64::min(from, to), [p, q]));
            }
        }
    }
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    pairs.into_iter().map(|(_, pair)| pair).take(CLOSURES).collect()
}

const APEXES: u32 = 24;
/// How many pairs there are to choose from.
pub(crate) const CLOSURES: usize = 16;

/// How closely the curve, at a sample of its points, comes to the line from its end to a point, as a share of the way from the end.
fn clearance(points: &[Vector], end: Vector, apex: Vector) -> f64 {
    let line = unit(sub(apex, end));
    let beside = points.iter().step_by(points.len().div_ceil(256)).filter_map(|p| {
        let r = sub(*p, end);
        let away = norm(r);
        let beside = if dot(r, line) > 0.0 { norm(cross(r, line)) } else { away };
        (away > 0.0).then(|| beside / away)
    });
    beside.fold(1.0, f64::min)
}
