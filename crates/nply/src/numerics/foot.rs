//! The foot of a perpendicular on a helix: Kepler's equation with its sign turned.

/// A step that is lost in rounding.
const SETTLED: f64 = 1e-15;
/// A triple root, at M = π with e = 1, is approached by a constant factor; its distance is stationary long before.
const MOST: u32 = 60;

/// The root E in [0, M] of E + e sin E = M, for e ≥ 0 and 0 ≤ M ≤ π.
///
/// On [0, π] the left side is concave, and it has passed M before it turns: there is one root on the way up, and Newton's tangents
/// lead to it from the left without passing it.
pub(crate) fn anomaly(e: f64, mean: f64) -> f64 {
    let mut anomaly = mean / (1.0 + e);
    for _ in 0..MOST {
        let (sin, cos) = libm::sincos(anomaly);
        let (rest, slope) = (mean - anomaly - e * sin, 1.0 + e * cos);
        if rest <= 0.0 || slope <= 0.0 {
            break; // there, to rounding
        }
        let step = rest / slope;
        anomaly = (anomaly + step).min(mean);
        if step <= SETTLED * anomaly {
            break;
        }
    }
    anomaly
}

#[cfg(test)]
mod tests {
    use super::anomaly;

    #[test]
    fn the_root_on_the_way_up() {
        for e in [0.0, 1e-9, 0.3, 1.0, 1.7, 40.0, 1e6] {
            for i in 0..=64 {
                let mean = core::f64::consts::PI * f64::from(i) / 64.0;
                let root = anomaly(e, mean);
                assert!((0.0..=mean).contains(&root));
                let rest = root + e * libm::sin(root) - mean;
                assert!(rest.abs() < 1e-14 * (1.0 + e), "e {e}, M {mean}: {rest:e}");
                // none before it
                let before = (0..200).map(|k| f64::from(k) / 200.0 * root);
                assert!(before.into_iter().all(|x| x + e * libm::sin(x) <= mean + 1e-12 * (1.0 + e)));
            }
        }
    }
}
