//! A curve through as many of its points as its bends need.

/// How often a step is halved.
const DEPTH: u32 = 14;
/// How far, in parts of the window, a step's middle may lie off its chord.
const FLAT: f64 = 5e-4;
/// The longest step, in parts of the window.
const LONGEST: f64 = 0.08;

/// The points of a curve from one parameter to another, in runs: broken where it has no point, and where it jumps or runs through infinity.
///
/// `place` says where a point lies, in parts of the window that is looked at (0 to 1 inside, any number of axes); how finely the curve is
/// divided depends on that alone.
pub(crate) fn sampled<T: Clone>(
    curve: impl Fn(f64) -> Option<T>,
    place: impl Fn(&T) -> Vec<f64>,
    parameters: &[f64],
) -> Vec<Vec<(f64, T)>> {
    let at = |t: f64| {
        let point = curve(t)?;
        // beyond the window nothing is told apart, so that poles are not chased
        let place = place(&point);
        let is_point = place.iter().all(|v| v.is_finite());
        let place = place.into_iter().map(|v| v.clamp(-2.0, 3.0)).collect();
        is_point.then_some(Node { t, point, place })
    };
    let mut walk = Walk { at, runs: Vec::new(), run: Vec::new() };
    let mut before: Option<(f64, Option<Node<T>>)> = None;
    for &t in parameters {
        let here = (walk.at)(t);
        if let Some((from, last)) = &before {
            walk.join((*from, last.as_ref()), (t, here.as_ref()), 0);
        } else if let Some(first) = &here {
            walk.run.push((first.t, first.point.clone()));
        }
        before = Some((t, here));
    }
    walk.cut();
    // crumbs of a pole
    if walk.runs.len() > 1 {
        walk.runs.retain(|run| run.len() > 1);
    }
    walk.runs
}

/// From `from` to `to` in so many steps.
pub(crate) fn steps(from: f64, to: f64, count: u32) -> Vec<f64> {
    (0..=count).map(|i| f64::from(i) / f64::from(count)).map(|share| from * (1.0 - share) + to * share).collect()
}

#[derive(Clone)]
struct Node<T> {
    t: f64,
    point: T,
    place: Vec<f64>,
}

struct Walk<T, F> {
    at: F,
    runs: Vec<Vec<(f64, T)>>,
    run: Vec<(f64, T)>,
}

type End<'n, T> = (f64, Option<&'n Node<T>>);

impl<T: Clone, F: Fn(f64) -> Option<Node<T>>> Walk<T, F> {
    fn cut(&mut self) {
        if !self.run.is_empty() {
            self.runs.push(std::mem::take(&mut self.run));
        }
    }

    fn push(&mut self, node: Option<&Node<T>>) {
        match node {
            Some(node) => self.run.push((node.t, node.point.clone())),
            None => self.cut(),
        }
    }

    /// Goes on from a point that is in the run already to another.
    fn join(&mut self, (from, a): End<'_, T>, (to, b): End<'_, T>, depth: u32) {
        let middle = 0.5 * (from + to);
        let beyond = depth >= DEPTH || middle <= from.min(to) || middle >= from.max(to);
        let apart =
            |a: &Node<T>, b: &Node<T>| a.place.iter().zip(&b.place).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        match (a, b) {
            (Some(a), Some(b)) if beyond => {
                if apart(a, b) > 2.0 * LONGEST {
                    self.cut();
                }
                self.push(Some(b));
            }
            _ if beyond => self.push(b),
            (None, None) if depth >= 1 => {}
            _ => {
                let m = (self.at)(middle);
                if let (Some(a), Some(m), Some(b)) = (a, &m, b) {
                    let off = (0..a.place.len())
                        .map(|i| (m.place[i] - 0.5 * (a.place[i] + b.place[i])).abs())
                        .fold(0.0, f64::max);
                    if off < FLAT && apart(a, b) < LONGEST {
                        self.push(Some(b));
                        return;
                    }
                }
                self.join((from, a), (middle, m.as_ref()), depth + 1);
                self.join((middle, m.as_ref()), (to, b), depth + 1);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pole_is_a_gap_and_a_bend_is_followed() {
        let runs = sampled(|t| Some(1.0 / (t - 0.3141)), |y| vec![0.5 + 0.01 * y], &steps(0.0, 1.0, 10));
        assert_eq!(runs.len(), 2);
        assert!(runs[0].iter().all(|(t, y)| *t < 0.3141 && *y < 0.0) && runs[1].iter().all(|(t, _)| *t > 0.3141));
        let root = |t: f64| (t >= 0.5).then(|| libm::sqrt(t - 0.5));
        let runs = sampled(root, |y| vec![*y], &steps(0.0, 1.0, 4));
        assert_eq!(runs.len(), 1);
        let (first, y) = runs[0][0];
        assert!(first - 0.5 < 1e-3 && y < 0.04, "{first}");
        for pair in runs[0].windows(2) {
            let middle = root(0.5 * (pair[0].0 + pair[1].0)).unwrap_or(f64::NAN);
            assert!((middle - 0.5 * (pair[0].1 + pair[1].1)).abs() < 1e-3);
        }
    }
}
