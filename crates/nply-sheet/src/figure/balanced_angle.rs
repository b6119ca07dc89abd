//! Figure 8: the angle a ply takes without loads, over the pretwist.

use nply::geometry::{Contact, HelicalAngle, SpecialLays};
use nply::mechanics::{Balance, Load, Ply};
use nply::{DomainError, Handedness};

use super::{Data, Parts, rad};
use crate::plot::sample::{sampled, steps};
use crate::plot::{Axis, Chart, Curve, Dash, Picture};

const GAMMA: f64 = 0.75;
/// The axis of pretwist reaches so far left and right.
const REACH: f64 = 6.0;

pub(super) fn make() -> Result<Parts, DomainError> {
    let mut data = Data::new(["balance", "strands", "pretwist", "signed_helical_angle_deg"]);
    let mut chart = Chart::new(
        "",
        Axis::new("pretwist φ̄a", "").with_range(-REACH, REACH).with_step(2.0),
        Axis::new("helical angle θ, left-handed negative", "deg").with_range(-90.0, 90.0).with_step(15.0),
    )
    .with_size(560.0, 460.0);
    for (colour, balance) in [(0, Balance::Radial), (1, Balance::Contact)] {
        for (strands, dash) in [(2, Dash::Solid), (3, Dash::Dashed), (6, Dash::Dotted)] {
            let ply = Ply::with_balance(strands, GAMMA, balance)?;
            for hand in Handedness::BOTH {
                let point = |degrees: f64| {
                    let angle = HelicalAngle::from_pitch_angle(rad(90.0 - degrees)).ok()?;
                    let state = ply.pretwist_on(Contact::at_angle(strands, angle).ok()?, hand, Load::NONE).ok()?;
                    Some((state.pretwist(), hand.sign() * degrees))
                };
                let place = |(x, y): &(f64, f64)| vec![0.5 + 0.5 * x / REACH, 0.5 + y / 180.0];
                for run in sampled(point, place, &steps(1e-6, 90.0 - 1e-4, 90)) {
                    let name = format!("n = {strands}, {} balance", balance.name());
                    let curve = Curve::new(name, run.into_iter().map(|(_, point)| point));
                    let curve = curve.with_colour(colour).with_dash(dash);
                    chart = data.draw(chart, &[balance.name(), &strands.to_string()], curve);
                }
            }
        }
    }
    let limit = |strands| SpecialLays::of(strands).map(|lays| lays.most_torsion().angle().degrees());
    let caption = format!(
        "However much pretwist is put into strands side by side, the angle at which they come to rest stays below a limit: 45° in radial \
         balance, and in contact balance the angle of the most torsion, {:.2}° for three strands and {:.2}° for six. They lie against their \
         pretwist. Beyond the limit there is another branch, of the other hand, on which neighbours would have to pull. In radial balance \
         it ends at no pretwist, in contact balance at −π/(2nγ) for right-handed flat rings, so that weak pretwists have three states. \
         The balances agree for two strands below 45°. γ = 3/4.",
        limit(3)?,
        limit(6)?
    );
    Ok(Parts::charts(caption, data, Picture::row([chart])))
}
