//! Figures 9 and 10: the plane of end force and end moment of a ply of given pretwist.

use nply::geometry::HelicalAngle;
use nply::mechanics::{Balance, Load, Ply, Twist};
use nply::{DomainError, Handedness};

use super::{Data, Parts, rad};
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape, Picture};

const GAMMA: f64 = 0.75;
/// Degrees between lines of constant angle.
const EVERY: u32 = 10;
const POINTS: usize = 160;

pub(super) fn two() -> Result<Parts, DomainError> {
    let (picture, data) = draw(2, [((-2.4, 2.4), (-1.6, 1.6)), ((-5.0, 5.0), (-5.0, 3.0))])?;
    Ok(Parts::charts(
        "Force and moment on two strands of pretwist −0.2 and −2. On the bold curves neighbours just stop pressing; they begin, square, at \
         the moment that holds straight strands, pass 45° at the diamonds and end, triangle, at flat rings. Each angle has a straight line of \
         loads that holds it: solid where neighbours press, dashed where they would have to pull. The lines rise for right-handed plies and \
         fall for left-handed ones. Up to 45° the balances agree; beyond it those of radial balance are the pale ones. γ = 3/4.",
        data,
        picture,
    ))
}

pub(super) fn three() -> Result<Parts, DomainError> {
    let (picture, data) = draw(3, [((-3.0, 3.0), (-2.4, 2.4)), ((-7.5, 7.5), (-7.5, 4.5))])?;
    Ok(Parts::charts(
        "The same for three strands. The bold curves are those of either balance, the straight lines through them are not: in contact \
         balance they are steeper, and stand upright at the angle of the most turns, where no force can hold a moment. Lines of radial \
         balance are pale.",
        data,
        picture,
    ))
}

type Window = ((f64, f64), (f64, f64));

fn draw(strands: u32, windows: [Window; 2]) -> Result<(Picture, Data), DomainError> {
    let mut data = Data::new(["pretwist", "curve", "hand", "helical_angle_deg", "force", "moment"]);
    let mut charts = Vec::new();
    for (i, (pretwist, (across, up))) in [-0.2, -2.0].into_iter().zip(windows).enumerate() {
        let twist = Twist::Pretwist(pretwist);
        let mut chart = Chart::new(
            format!("{}  φ̄a = −{}", ["a", "b"][i], -pretwist),
            Axis::new("end force f", "B/r²").with_range(across.0, across.1),
            Axis::new("end moment m", "B/r").with_range(up.0, up.1),
        )
        .with_size(430.0, 430.0);
        let far = 4.0 * (across.1 - across.0 + up.1 - up.0);
        let mut row = |curve: &str, hand: Handedness, angle: HelicalAngle, load: Load| {
            let (degrees, hand) = (angle.degrees(), name(hand));
            data.push([
                pretwist.into(),
                curve.into(),
                hand.into(),
                degrees.into(),
                load.force.into(),
                load.moment.into(),
            ]);
        };
        for balance in [Balance::Radial, Balance::Contact] {
            let ply = Ply::with_balance(strands, GAMMA, balance)?;
            for hand in Handedness::BOTH {
                for degrees in (EVERY..90).step_by(EVERY as usize) {
                    let angle = HelicalAngle::new(rad(f64::from(degrees)))?;
                    let parting = ply.separation_at(angle, hand, twist)?.load();
                    let direction = direction(&ply, angle, hand, twist, parting)?;
                    row(&format!("angle, {}", balance.name()), hand, angle, parting);
                    let at = |steps: f64| {
                        let Load { force, moment } = direction;
                        row(
                            &format!("angle, {}", balance.name()),
                            hand,
                            angle,
                            Load { force: parting.force + force, moment: parting.moment + moment },
                        );
                        (parting.force + steps * force, parting.moment + steps * moment)
                    };
                    let [near, presses, pulls] = [0.0, far, -far].map(at);
                    let differs = strands > 2 || degrees > 45;
                    if balance == Balance::Radial && !differs {
                        continue;
                    }
                    chart = line(chart, balance, hand, degrees == 50, near, presses, pulls);
                }
            }
        }
        let locus = Ply::new(strands, GAMMA)?.separation_locus(twist, POINTS)?;
        for hand in Handedness::BOTH {
            let points: Vec<(HelicalAngle, Load)> = (0..locus.len()).map(|i| locus.point(hand, i)).collect();
            for &(angle, load) in &points {
                row("locus", hand, angle, load);
            }
            let points = points.into_iter().map(|(_, load)| (load.force, load.moment));
            chart = chart.with_curve(Curve::new("p = 0", points).with_colour(6).with_width(3.0));
        }
        let ply = Ply::new(strands, GAMMA)?;
        for hand in Handedness::BOTH {
            let marks = [
                ("θ = 0", 90.0, MarkerShape::Square),
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
        charts.push(if i == 1 { chart } else { chart.without_legend() });
    }
    Ok((Picture::row(charts), data))
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

fn line(
    chart: Chart,
    balance: Balance,
    hand: Handedness,
    named: bool,
    near: (f64, f64),
    presses: (f64, f64),
    pulls: (f64, f64),
) -> Chart {
    let colour = usize::from(hand == Handedness::Left);
    let radial = balance == Balance::Radial;
    let drawn = |words: &str, to: (f64, f64)| {
        let name = format!("{}-handed, {}{words}", name(hand), balance.name());
        let curve = Curve::new(if named { name } else { String::new() }, [near, to]);
        let curve = curve.with_colour(colour).with_width(if radial { 1.0 } else { 1.4 });
        if radial { curve.pale() } else { curve }
    };
    chart.with_curve(drawn("", presses)).with_curve(drawn(", p < 0", pulls).dashed())
}
