//! Figures 6 and 7: the ply without loads, over its angle.

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, Load, Ply};
use nply::{DomainError, Handedness};

use super::{Data, Parts, rad};
use crate::plot::sample::{sampled, steps};
use crate::plot::{Axis, Chart, Curve, Picture};

/// The strand twist that balances does not depend on it.
const GAMMA: f64 = 0.75;

/// One panel: a number of the state over the angle.
struct Panel {
    word: &'static str,
    title: &'static str,
    axis: &'static str,
    range: (f64, f64),
    step: f64,
    /// with left-handed states at negative angles
    signed: bool,
    value: fn(&Equilibrium) -> f64,
}

const PANELS: [Panel; 4] = [
    Panel {
        word: "radius_ratio",
        title: "(a) Helix radius",
        axis: "ρ = R/r",
        range: (0.0, 6.0),
        step: 1.0,
        signed: false,
        value: |state| state.contact().radius_ratio(),
    },
    Panel {
        word: "twisting_moment",
        title: "(b) Twisting moment in a strand",
        axis: "γ r u₃",
        range: (-4.0, 4.0),
        step: 1.0,
        signed: true,
        value: |state| state.stiffness_ratio() * state.strand_twist(),
    },
    Panel {
        word: "resultant_pressure",
        title: "(c) Resultant pressure",
        axis: "p r³/B",
        range: (-2.0, 2.0),
        step: 0.5,
        signed: false,
        value: Equilibrium::resultant_pressure,
    },
    Panel {
        word: "interstrand_pressure",
        title: "(d) Pressure between neighbours",
        axis: "p₁ r³/B",
        range: (-2.0, 2.0),
        step: 0.5,
        signed: false,
        value: Equilibrium::interstrand_pressure,
    },
];

/// A family of touching strands over the angle.
struct Family {
    word: &'static str,
    name: &'static str,
    contact: fn(HelicalAngle) -> Result<Contact, DomainError>,
    balance: Balance,
    from: f64,
    curve: fn(Curve) -> Curve,
}

pub(super) fn two() -> Result<Parts, DomainError> {
    let line = |angle| Ok(Contact::line(angle));
    let helix = |angle| Contact::at_angle(2, angle);
    let families = [
        Family {
            word: "line",
            name: "line contact",
            contact: line,
            balance: Balance::Radial,
            from: 0.0,
            curve: |curve| curve.with_colour(6),
        },
        Family {
            word: "helix, radial",
            name: "contact on a helix, radial balance",
            contact: helix,
            balance: Balance::Radial,
            from: 45.0,
            curve: |curve| curve.with_colour(0).dashed(),
        },
        Family {
            word: "helix, contact",
            name: "contact on a helix, contact balance",
            contact: helix,
            balance: Balance::Contact,
            from: 45.0,
            curve: |curve| curve.with_colour(1).dashed(),
        },
    ];
    let (picture, data) = draw(2, &families)?;
    Ok(Parts::charts(
        "A ply of two strands that carries no loads. Twist and pressures grow without bound towards 45°, from either side; below it the \
         strands press on each other, above it they would have to pull. Line contact goes on beyond 45° in theory only, where the strands \
         overlap. On the helix that they touch along instead, radial balance takes p₁ to −π²/8 for flat rings and p to 0, line contact \
         to −1/2 and −1; contact balance takes both to 0, with a twisting moment of −π/4. Left-handed states have negative angles in (b).",
        data,
        picture,
    ))
}

pub(super) fn three() -> Result<Parts, DomainError> {
    let helix = |angle| Contact::at_angle(3, angle);
    let families = [
        Family {
            word: "radial",
            name: "radial balance",
            contact: helix,
            balance: Balance::Radial,
            from: 0.0,
            curve: |curve| curve.with_colour(0),
        },
        Family {
            word: "contact",
            name: "contact balance",
            contact: helix,
            balance: Balance::Contact,
            from: 0.0,
            curve: |curve| curve.with_colour(1),
        },
    ];
    let (picture, data) = draw(3, &families)?;
    Ok(Parts::charts(
        "The same of three strands. In radial balance everything grows without bound at 45°, as with two strands. Contact forces that \
         cross from one height to another move this angle down to 37.88°, that of the most torsion, and leave flat rings with a twisting \
         moment of −π/6 in each strand and no pressure. The radius does not depend on the balance.",
        data,
        picture,
    ))
}

fn draw(strands: u32, families: &[Family]) -> Result<(Picture, Data), DomainError> {
    let mut data = Data::new(["panel", "curve", "helical_angle_deg", "value"]);
    let mut charts = Vec::new();
    for (i, panel) in PANELS.iter().enumerate() {
        let left = if panel.signed { -90.0 } else { 0.0 };
        let step = if panel.signed { 45.0 } else { 15.0 };
        let mut chart = Chart::new(
            panel.title,
            Axis::new("helical angle θ", "deg").with_range(left, 90.0).with_step(step),
            Axis::new(panel.axis, "").with_range(panel.range.0, panel.range.1).with_step(panel.step),
        )
        .with_size(380.0, 280.0);
        for family in families {
            let ply = Ply::with_balance(strands, GAMMA, family.balance)?;
            let hands = if panel.signed { &Handedness::BOTH[..] } else { &Handedness::BOTH[..1] };
            for &hand in hands {
                let point = |degrees: f64| {
                    let angle = HelicalAngle::from_pitch_angle(rad(90.0 - degrees)).ok()?;
                    let state = ply.pretwist_on((family.contact)(angle).ok()?, hand, Load::NONE).ok()?;
                    Some((hand.sign() * degrees, (panel.value)(&state)))
                };
                let (low, high) = panel.range;
                let place = |(x, y): &(f64, f64)| vec![x / 90.0, (y - low) / (high - low)];
                for run in sampled(point, place, &steps(family.from.max(1e-6), 90.0 - 1e-4, 90)) {
                    let points = run.into_iter().map(|(_, point)| point);
                    let curve = (family.curve)(Curve::new(family.name, points));
                    chart = data.draw(chart, &[panel.word, family.word], curve);
                }
            }
        }
        // one list of names is enough
        charts.push(if i == 1 { chart } else { chart.without_legend() });
    }
    Ok((Picture::grid(charts, 2), data))
}
