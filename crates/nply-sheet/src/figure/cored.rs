//! Figure 11: six strands on a core, over the end force.

use nply::geometry::Contact;
use nply::mechanics::{Balance, Equilibrium, Ply, Twist};
use nply::{DomainError, Handedness};

use super::{Data, Parts};
use crate::plot::{Area, Axis, Chart, Curve, Marker, MarkerShape, Picture};

const GAMMA: f64 = 0.75;
const PRETWIST: f64 = -0.2;
/// ρ; the core's radius is one strand radius less.
const RADIUS_RATIO: f64 = 2.1;
/// The axis of force reaches so far left and right.
const REACH: f64 = 3.0;

pub(super) fn make() -> Result<Parts, DomainError> {
    let mut data = Data::new(["panel", "curve", "hand", "force", "value"]);
    let twist = Twist::Pretwist(PRETWIST);
    let contact = Contact::from_radius_ratio(6, RADIUS_RATIO)?;
    let force = || Axis::new("end force f", "B/r²").with_range(-REACH, REACH).with_step(1.0);
    let mut pressure = Chart::new("(a) Resultant pressure", force(), Axis::new("p r³/B", "").with_range(-0.04, 0.04));
    let mut moment =
        Chart::new("(b) Moment that holds the angle", force(), Axis::new("m", "B/r").with_range(-5.0, 3.0));
    let ply = Ply::new(6, GAMMA)?;
    for wedge in ply.wedges(twist, RADIUS_RATIO - 1.0)?.into_iter().flatten() {
        let tip = (wedge.tip.force, wedge.tip.moment);
        let far = |load: nply::mechanics::Load| {
            let steps = 40.0;
            (tip.0 + steps * load.force, tip.1 + steps * load.moment)
        };
        let corners = [tip, far(wedge.neighbours_just_touch), far(wedge.core_just_touches)];
        moment = moment.with_area(Area::new("neighbours and core press", corners, 2));
        let hand = hand(wedge.handedness);
        data.push(["moment".into(), "tip of the wedge".into(), hand.into(), tip.0.into(), tip.1.into()]);
        moment = moment.with_marker(Marker::new("both just touch", tip.0, tip.1, MarkerShape::Circle).with_colour(6));
        pressure = pressure.with_marker(Marker::new("both just touch", tip.0, 0.0, MarkerShape::Circle).with_colour(6));
    }
    for (colour, balance) in [(0, Balance::Radial), (1, Balance::Contact)] {
        let ply = Ply::with_balance(6, GAMMA, balance)?;
        let carried = if balance == Balance::Radial { "radial (core carries)" } else { "contact (neighbours)" };
        for side in Handedness::BOTH {
            // both are straight lines: two points each
            let state = |force| ply.moment_at(contact.angle(), side, twist, force);
            let ends = [state(-REACH)?, state(0.0)?, state(REACH)?];
            let name = format!("{}, {carried}", hand(side));
            let curve = |of: fn(&Equilibrium) -> f64| {
                let curve = Curve::new(name.clone(), ends.iter().map(|state| (state.load().force, of(state))));
                let curve = curve.with_colour(colour);
                if side == Handedness::Left { curve.dashed() } else { curve }
            };
            let words = |panel| [panel, balance.name(), hand(side)];
            pressure = data.draw(pressure, &words("resultant_pressure"), curve(Equilibrium::resultant_pressure));
            moment = data.draw(moment, &words("moment"), curve(|state| state.load().moment));
        }
    }
    let charts = [pressure.with_size(380.0, 320.0).without_legend(), moment.with_size(380.0, 320.0)];
    Ok(Parts::charts(
        "Six strands with R = 2.1 r, as on a core of radius 1.1 r: touching each other they lie at 20.0°, whatever the force, if the \
         moment follows it. The lines of radial balance are those of a core that carries all, with neighbours just touching; the \
         lines of contact balance are those of neighbours that carry all, with the core just touched. Between them lies a whole wedge of \
         loads under which both press. Only along its edges is a moment fixed by the force. γ = 3/4, φ̄a = −0.2.",
        data,
        Picture::row(charts),
    ))
}

const fn hand(hand: Handedness) -> &'static str {
    match hand {
        Handedness::Right => "right",
        Handedness::Left => "left",
    }
}
