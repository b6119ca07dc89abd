//! The part of a curve that lies in the frame.

const FAR: f64 = 1e100;

/// A frame from its lower to its upper corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Frame {
    pub(super) fn holds(&self, point: [f64; 2]) -> bool {
        (0..2).all(|i| (self.low[i]..=self.high[i]).contains(&point[i]))
    }

    /// The part of a segment within the frame (Liang and Barsky), as fractions of its length.
    fn part(&self, a: [f64; 2], b: [f64; 2]) -> Option<(f64, f64)> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for i in 0..2 {
            let step = b[i] - a[i];
            if step == 0.0 {
                if a[i] < self.low[i] || a[i] > self.high[i] {
                    return None;
                }
                continue;
            }
            let (near, far) = ((self.low[i] - a[i]) / step, (self.high[i] - a[i]) / step);
            from = from.max(near.min(far));
            to = to.min(near.max(far));
        }
        (from <= to).then_some((from, to))
    }

    /// The part of a polygon within the frame (Sutherland and Hodgman): cut by one side after the other. Empty where a corner is not
    /// finite.
    pub(super) fn polygon(&self, corners: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        if !corners.iter().flatten().all(|v| v.is_finite()) {
            return Vec::new();
        }
        let mut kept: Vec<[f64; 2]> = corners.into_iter().map(|corner| corner.map(|v| v.clamp(-FAR, FAR))).collect();
        for i in 0..2 {
            for (side, sign) in [(self.low[i], 1.0), (self.high[i], -1.0)] {
                let inside = |p: &[f64; 2]| sign * (p[i] - side) >= 0.0;
                let before = kept.iter().cycle().skip(kept.len().saturating_sub(1));
                let mut cut = Vec::new();
                for (here, last) in kept.iter().zip(before) {
                    if inside(here) != inside(last) {
                        let t = (side - last[i]) / (here[i] - last[i]);
                        cut.push([0, 1].map(|k| if k == i { side } else { (1.0 - t) * last[k] + t * here[k] }));
                    }
                    if inside(here) {
                        cut.push(*here);
                    }
                }
                kept = cut;
            }
        }
        kept
    }

    /// The curve in pieces: cut where it leaves the frame and where a point is not finite.
    pub(super) fn pieces(&self, points: impl Iterator<Item = [f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        let mut pieces = Vec::new();
        let mut piece: Vec<[f64; 2]> = Vec::new();
        let mut before: Option<[f64; 2]> = None;
        for point in points {
            // Far enough out for any frame, and differences do not overflow.
            let point = point.map(|v| if v.is_finite() { v.clamp(-FAR, FAR) } else { v });
            if !point.iter().all(|v| v.is_finite()) {
                pieces.push(std::mem::take(&mut piece));
                before = None;
                continue;
            }
            match before {
                None if self.holds(point) => piece.push(point),
                None => {}
                Some(last) => match self.part(last, point) {
                    None => pieces.push(std::mem::take(&mut piece)),
                    Some((from, to)) => {
                        let along = |t: f64, i: usize| (1.0 - t) * last[i] + t * point[i];
                        let at = |t| [0, 1].map(|i| along(t, i).clamp(self.low[i], self.high[i]));
                        if piece.is_empty() {
                            piece.push(at(from));
                        }
                        piece.push(at(to));
                        if to < 1.0 {
                            pieces.push(std::mem::take(&mut piece));
                        }
                    }
                },
            }
            before = Some(point);
        }
        pieces.push(piece);
        pieces.retain(|piece| !piece.is_empty());
        pieces
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp, reason = "halves are exact")]
    use super::*;

    #[test]
    fn a_curve_is_cut_at_the_frame_and_at_gaps() {
        let frame = Frame { low: [0.0, 0.0], high: [4.0, 2.0] };
        let curve = [[-1.0, 1.0], [1.0, 1.0], [2.0, 3.0], [3.0, 1.0], [f64::NAN, 0.0], [3.5, 0.5], [2.0, -9.0]];
        let pieces = frame.pieces(curve.into_iter());
        assert_eq!(pieces[0], [[0.0, 1.0], [1.0, 1.0], [1.5, 2.0]]);
        assert_eq!(pieces[1], [[2.5, 2.0], [3.0, 1.0]]);
        assert_eq!((pieces.len(), pieces[2][0]), (3, [3.5, 0.5]));
    }

    #[test]
    fn a_polygon_loses_what_is_outside() {
        let frame = Frame { low: [0.0, 0.0], high: [4.0, 2.0] };
        let area = |p: &[[f64; 2]]| {
            let cross = |i: usize| p[i][0] * p[(i + 1) % p.len()][1] - p[(i + 1) % p.len()][0] * p[i][1];
            0.5 * (0..p.len()).map(cross).sum::<f64>()
        };
        let square = frame.polygon(vec![[1.0, 1.0], [9.0, 1.0], [9.0, 9.0], [1.0, 9.0]]);
        assert_eq!(area(&square), 3.0);
        assert_eq!(frame.polygon(vec![[5.0, 5.0], [6.0, 5.0], [6.0, 6.0]]).len(), 0);
        assert_eq!(frame.polygon(vec![[f64::NAN, 0.0], [1.0, 0.0], [0.0, 1.0]]).len(), 0);
        assert_eq!(frame.polygon(Vec::new()).len(), 0);
    }
}
