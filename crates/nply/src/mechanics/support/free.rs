//! Free helices: strands that nothing carries but the end loads.

use crate::Handedness;
use crate::geometry::HelicalAngle;
use crate::mechanics::Ends;
use crate::mechanics::{Load, Ply, Twist};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};

/// A helix in equilibrium by itself.
pub(super) struct FreeHelix {
    pub(super) handedness: Handedness,
    pub(super) angle: HelicalAngle,
    /// sin θ/ρ > 0
    pub(super) rotation: f64,
    pub(super) load: Load,
}

/// Powers of cos θ, up to the fourth.
struct Powers;

impl Basis<5> for Powers {
    fn at(&self, t: f64) -> [Dual; 5] {
        let c = Dual::new(t, 1.0);
        let mut power = Dual::new(1.0, 0.0);
        core::array::from_fn(|_| {
            let this = power;
            power = power * c;
            this
        })
    }
}

/// Free helices: p̂ = 0 and ∂E/∂θ = 0 with θ and ρ both unknown, whatever is in their way.
///
/// With y = sin θ/ρ and c = cos θ they read εm/n = y sin²θ + γ(ε r u₃)c and f/n = y(γ ε r u₃ − c y), the moment and the force of
/// a helical rod by itself.
pub(super) fn helices(ply: &Ply, twist: Twist, ends: Ends, mut found: impl FnMut(FreeHelix)) {
    let n = f64::from(ply.strands());
    let (love, held) = twist.weights(ply.stiffness_ratio());
    match ends {
        Ends::Loads(load) => under_loads(n, love, held, load, &mut found),
        Ends::Rotation { rotation, force } => {
            // f/n = y(h + (love − 1)cy) gives c
            let eps = rotation.signum();
            let (y, h) = (rotation.abs(), eps * held);
            let c = (force / (n * y) - h) / ((love - 1.0) * y);
            if c > 0.0 && c < 1.0 {
                let moment = eps * n * (y * (1.0 - c * c) + (h + love * c * y) * c);
                found(FreeHelix {
                    handedness: Handedness::of_sign(rotation),
                    angle: HelicalAngle::of_cosine(c),
                    rotation: y,
                    load: Load { force, moment },
                });
            }
        }
        Ends::Length { extension: c, moment } => {
            // εm/n = y sin²θ + (h + love c y)c gives y
            for handedness in Handedness::BOTH {
                let eps = handedness.sign();
                let (h, ss) = (eps * held, (1.0 - c) * (1.0 + c));
                let y = (eps * moment / n - h * c) / (ss + love * c * c);
                if y > 0.0 {
                    let force = n * y * (h + (love - 1.0) * c * y);
                    let angle = HelicalAngle::of_cosine(c);
                    found(FreeHelix { handedness, angle, rotation: y, load: Load { force, moment } });
                }
            }
        }
    }
}

/// The moment's equation gives y, the force's then is a polynomial of degree four in c. Where it vanishes for every c (γ = 1
/// under a moment alone, without pretwist) every angle is as good as another, and none is given.
fn under_loads(n: f64, love: f64, held: f64, load: Load, found: &mut impl FnMut(FreeHelix)) {
    let lag = love - 1.0;
    for handedness in Handedness::BOTH {
        let eps = handedness.sign();
        // γ ε r u₃ = h + love c y, so y = (M − hc)/(1 + lag c²) and F(1 + lag c²)² = (M − hc)(h + lag M c)
        let (big_m, big_f, h) = (eps * load.moment / n, load.force / n, eps * held);
        let polynomial =
            [big_f - big_m * h, h * h - lag * big_m * big_m, lag * (2.0 * big_f + big_m * h), 0.0, big_f * lag * lag];
        let pair = Pair { even: polynomial, odd: [0.0; 5] };
        for (start, end) in [(0.0, 0.25), (0.25, 0.5), (0.5, 0.75), (0.75, 1.0)] {
            Panel::fit(&Powers, start, end).roots(&Powers, &pair.tamed(), &mut |side, root| {
                if side < 0.0 {
                    return; // both of the pair are the same polynomial
                }
                let c = root.at;
                let (left, size) = (big_m - h * c, big_m.abs() + (h * c).abs());
                let rotation = left / (1.0 + lag * c * c);
                // no turning at all is no helix but straight strands that lean
                if rotation > 0.0 && left.abs() > 8.0 * f64::EPSILON * size {
                    found(FreeHelix { handedness, angle: HelicalAngle::of_cosine(c), rotation, load });
                }
            });
        }
    }
}
