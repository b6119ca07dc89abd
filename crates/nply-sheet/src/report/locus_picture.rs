//! The locus as a picture, as Figures 9 and 10: both curves, and the lines of constant angle that end on them.

use nply::Handedness;
use nply::geometry::HelicalAngle;

use super::LocusReport;
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape, Note, Side};

/// Degrees between lines of constant angle.
const EVERY: u32 = 10;

/// Where on its way to a far point a line is about to leave the frame, and the side on which words stand clear of it. None if it begins
/// outside.
fn at_the_frame((x, y): (f64, f64), far: (f64, f64), across: (f64, f64), up: (f64, f64)) -> Option<((f64, f64), Side)> {
    // room for the words, in parts of the frame
    const ROOM: (f64, f64) = (0.05, 0.04);
    let (width, height) = (across.1 - across.0, up.1 - up.0);
    let (dx, dy) = (far.0 - x, far.1 - y);
    let until = |from: f64, step: f64, (low, high): (f64, f64), room: f64| match step {
        step if step > 0.0 => (high - room - from) / step,
        step if step < 0.0 => (low + room - from) / step,
        _ => f64::INFINITY,
    };
    let (aside, upright) = (until(x, dx, across, ROOM.0 * width), until(y, dy, up, ROOM.1 * height));
    let share = aside.min(upright);
    let side = if upright < aside { Side::Right } else { Side::Above };
    (share > 0.0).then_some(((x + share * dx, y + share * dy), side))
}

impl LocusReport {
    /// Both curves in the plane of force and moment, with lines of constant angle: solid where neighbours press, dashed where they would
    /// have to pull.
    ///
    /// ```
    /// use nply_sheet::{LocusReport, Spec};
    /// let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")];
    /// let picture = LocusReport::of(&Spec::from_flags(flags)?.check()?, 200)?.picture();
    /// assert!(picture.svg().contains("end force"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn picture(&self) -> Chart {
        let [force, moment] = self.readings();
        let points = || Handedness::BOTH.into_iter().flat_map(|hand| self.curve(hand));
        let range = |values: &mut dyn Iterator<Item = f64>| {
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            // room for the lines on the side where neighbours press
            let room = if high > low { high - low } else { 1.0 };
            (low - 0.25 * room, high + 0.5 * room)
        };
        let across = range(&mut points().map(|(_, load)| load.force * force.factor));
        let up = range(&mut points().map(|(_, load)| load.moment * moment.factor));
        let title = self.title().unwrap_or_default();
        let mut chart = Chart::new(
            title,
            Axis::new("end force", force.unit.clone()).with_range(across.0, across.1),
            Axis::new("end moment", moment.unit.clone()).with_range(up.0, up.1),
        );
        let far = 4.0 * ((across.1 - across.0) / force.factor + (up.1 - up.0) / moment.factor);
        for hand in Handedness::BOTH {
            let colour = usize::from(hand == Handedness::Left);
            let side = if hand == Handedness::Right { "right" } else { "left" };
            for degrees in (EVERY..90).step_by(EVERY as usize) {
                let line =
                    HelicalAngle::new(f64::from(degrees).to_radians()).map(|angle| self.line_of_angle(angle, hand));
                let Ok(Ok(line)) = line else { continue };
                let length = libm::hypot(line.direction.force, line.direction.moment);
                let end = |steps: f64| {
                    let load = line.at(steps / length);
                    (load.force * force.factor, load.moment * moment.factor)
                };
                let first = degrees == EVERY;
                let name = |words: &str| if first { format!("{side}, {words}") } else { String::new() };
                let presses = Curve::new(name(&format!("helical angle every {EVERY}°")), [end(0.0), end(far)])
                    .with_colour(colour)
                    .with_width(1.4);
                let pulls =
                    Curve::new(name("p < 0"), [end(0.0), end(-far)]).with_colour(colour).with_width(1.4).dashed();
                chart = chart.with_curve(presses).with_curve(pulls);
                if let Some((place, side)) = at_the_frame(end(0.0), end(far), across, up) {
                    let note = Note::new(format!("{degrees}°"), place.0, place.1, side).with_colour(colour);
                    chart = chart.with_note(note);
                }
            }
        }
        for hand in Handedness::BOTH {
            let points = self.curve(hand).map(|(_, load)| (load.force * force.factor, load.moment * moment.factor));
            chart = chart.with_curve(Curve::new("p = 0", points).with_colour(6).with_width(3.0));
        }
        for point in self.special_points() {
            let (name, shape) = match point.name {
                "straight" => ("0°", MarkerShape::Square),
                "diagonal" => ("45°", MarkerShape::Diamond),
                "rings" => ("90°", MarkerShape::Triangle),
                _ => continue,
            };
            let (x, y) = (point.load.force * force.factor, point.load.moment * moment.factor);
            chart = chart.with_marker(Marker::new(name, x, y, shape).with_colour(6));
        }
        chart
    }
}
