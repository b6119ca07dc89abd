//! Figures 9 and 10: the plane of end force and end moment of a ply of given pretwist.

use nply::geometry::HelicalAngle;
use nply::mechanics::{Balance, Load, Ply, Twist};
use nply::{DomainError, Handedness};

use super::{Data, Parts, rad};
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape, Picture};

const GAMMA: f64 = 0.75;
/// Degrees between lines of constant angle.
const EVERY: u32 = 15;
const POINTS: usize = 160;

pub(super) fn two() -> Result<Parts, DomainError> {
    let (picture, data) = draw(2, [((-1.5, 1.5), (-1.8, 1.5)), ((-5.0, 5.0), (-5.0, 2.0))])?;
    Ok(Parts::charts(
        "Force and moment on two strands of pretwist −0.2, on the left, and −2. On the bold curves neighbours just stop pressing; they begin, \
         square, at the moment that holds straight strands, pass 45° at the diamonds and end, triangle, at flat rings. Each angle, here every \
         15°, has a straight line of loads that holds it: solid where neighbours press, dashed where they would have to pull. The upper \
         pictures are in radial balance, where these lines rise for right-handed plies and fall for left-handed ones; the lower ones are in \
         contact balance, which has the same bold curves and, up to 45°, the same lines. Past the most turns, 50.6°, its lines lean over \
         to the other side. γ = 3/4.",
        data,
        picture,
    ))
}

pub(super) fn three() -> Result<Parts, DomainError> {
    let (picture, data) = draw(3, [((-2.2, 2.2), (-2.7, 2.2)), ((-8.0, 8.0), (-8.0, 3.0))])?;
    Ok(Parts::charts(
        "The same for three strands. Here the balances agree at no angle but along the bold curves, which are those of either: in contact \
         balance the lines are steeper everywhere, and stand upright at the most turns, 47.2°.",
        data,
        picture,
    ))
}

type Window = ((f64, f64), (f64, f64));

fn draw(strands: u32, windows: [Window; 2]) -> Result<(Picture, Data), DomainError> {
    let mut data = Data::new(["balance", "pretwist", "curve", "hand", "helical_angle_deg", "force", "moment"]);
    let mut charts = Vec::new();
    for balance in [Balance::Radial, Balance::Contact] {
        for (pretwist, window) in [-0.2, -2.0].into_iter().zip(windows) {
            let ply = Ply::with_balance(strands, GAMMA, balance)?;
            let chart = panel(&ply, pretwist, window, ["a", "b", "c", "d"][charts.len()], &mut data)?;
            charts.push(if charts.len() == 1 { chart } else { chart.without_legend() });
        }
    }
    Ok((Picture::grid(charts, 2), data))
}

fn panel(ply: &Ply, pretwist: f64, (across, up): Window, letter: &str, data: &mut Data) -> Result<Chart, DomainError> {
    let twist = Twist::Pretwist(pretwist);
    let balance = ply.balance().name();
    let mut chart = Chart::new(
        format!("({letter}) φ̄a = −{}, {balance} balance", -pretwist),
        Axis::new("end force f", "B/r²").with_range(across.0, across.1),
        Axis::new("end moment m", "B/r").with_range(up.0, up.1),
    )
    .with_size(380.0, 360.0);
    let far = 4.0 * (across.1 - across.0 + up.1 - up.0);
    let mut row = |curve: &str, hand: Handedness, angle: HelicalAngle, load: Load| {
        let words = [balance.into(), pretwist.into(), curve.into(), name(hand).into()];
        let numbers = [angle.degrees(), load.force, load.moment].map(super::Cell::from);
        data.push(words.into_iter().chain(numbers));
    };
    for hand in Handedness::BOTH {
        for degrees in (EVERY..90).step_by(EVERY as usize) {
            let angle = HelicalAngle::new(rad(f64::from(degrees)))?;
            let parting = ply.separation_at(angle, hand, twist)?.load();
            let direction = direction(ply, angle, hand, twist, parting)?;
            let at = |steps: f64| Load {
                force: parting.force + steps * direction.force,
                moment: parting.moment + steps * direction.moment,
            };
            for (words, steps) in [("", far), (", p < 0", -far)] {
                let curve = format!("angle{words}");
                row(&curve, hand, angle, parting);
                row(&curve, hand, angle, at(steps.signum()));
                let name = if degrees == EVERY { format!("{}-handed{words}", name(hand)) } else { String::new() };
                let ends = [at(0.0), at(steps)].map(|load| (load.force, load.moment));
                let curve = Curve::new(name, ends).with_colour(usize::from(hand == Handedness::Left)).with_width(1.4);
                chart = chart.with_curve(if steps < 0.0 { curve.dashed() } else { curve });
            }
        }
    }
    let locus = ply.separation_locus(twist, POINTS)?;
    for hand in Handedness::BOTH {
        let points: Vec<(HelicalAngle, Load)> = (0..locus.len()).map(|i| locus.point(hand, i)).collect();
        for &(angle, load) in &points {
            row("locus", hand, angle, load);
        }
        let points = points.into_iter().map(|(_, load)| (load.force, load.moment));
        chart = chart.with_curve(Curve::new("p = 0", points).with_colour(6).with_width(3.0));
    }
    for hand in Handedness::BOTH {
        let marks = [
            ("θ = 0°", 90.0, MarkerShape::Square),
            ("θ = 45°", 45.0, MarkerShape::Diamond),
            ("θ = 90°", 1e-9, MarkerShape::Triangle),
        ];
        for (label, pitch, shape) in marks {
            let angle = HelicalAngle::from_pitch_angle(rad(pitch))?;
            let load = ply.separation_at(angle, hand, twist)?.load();
            row(label, hand, angle, load);
            chart = chart.with_marker(Marker::new(label, load.force, load.moment, shape).with_colour(6));
        }
    }
    Ok(chart)
}

const fn name(hand: Handedness) -> &'static str {
    match hand {
        Handedness::Right => "right",
        Handedness::Left => "left",
    }
}

/// The direction of the loads that hold an angle, towards those that press neighbours together.
fn direction(
    ply: &Ply,
    angle: HelicalAngle,
    hand: Handedness,
    twist: Twist,
    parting: Load,
) -> Result<Load, DomainError> {
    // the force that goes with another moment: no angle of a picture is one at which the moment alone does no work
    let moment = hand.sign();
    let state = ply.force_at(angle, hand, twist, parting.moment + moment)?;
    let force = state.load().force - parting.force;
    let length = libm::hypot(force, moment);
    Ok(Load { force: force / length, moment: moment / length })
}
