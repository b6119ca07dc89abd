//! Axial stiffness of a strand whose ends cannot turn: sums of E A cos³θ against the energy's second derivative.

use std::error::Error;

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{ExtensiblePly, FormedLay, Load, StretchingStrand, Support, Twist, WorkingCore};

use crate::page::{degrees, percent, table};

/// EA r²/B of a solid round wire.
const WIRE: f64 = 4.0;
const WIRES: u32 = 6;

/// EA over that of seven straight wires: six on a king wire of the same material, 1 % clear of each other.
struct Stiffness {
    exact: f64,
    /// Σ EA cos³θ
    cubes: f64,
    /// Σ EA cos³θ/(1 + ν sin²θ)
    thinned_cubes: f64,
}

fn stiffness(angle: f64, poisson: f64) -> Result<Stiffness, Box<dyn Error>> {
    let angle = HelicalAngle::new(angle.to_radians())?;
    let radius_ratio = 1.01 * Contact::at_angle(WIRES, angle)?.radius_ratio();
    let (core, gamma) = (radius_ratio - 1.0, 1.0 / (1.0 + poisson));
    let core_stiffness = WIRE * core * core;
    let lay = FormedLay { handedness: Handedness::Right, angle, radius_ratio, preforming: 1.0 };
    let king = WorkingCore::new(core, core_stiffness, gamma * core * core * core * core, poisson)?;
    let ply =
        ExtensiblePly::new(WIRES, StretchingStrand::new(gamma, WIRE, poisson)?)?.with_core(king)?.formed_in(lay)?;
    // a pull so small that nothing moves, and contact is sure
    let states = ply.states(Twist::Pretwist(0.0), Load { force: 1e-7, moment: 0.0 })?;
    let on_core = states.iter().find(|state| state.support() == Support::Core).ok_or("no state on the core")?;
    let exact = on_core.stiffness().ok_or("no stiffness")?.axial;
    let all = f64::from(WIRES) * WIRE;
    let (sine, cosine) = (angle.sin(), angle.cos());
    let over = |wires: f64| (all * wires + core_stiffness) / (all + core_stiffness);
    let cube = cosine * cosine * cosine;
    Ok(Stiffness {
        exact: exact / (all + core_stiffness),
        cubes: over(cube),
        thinned_cubes: over(cube / (1.0 + poisson * sine * sine)),
    })
}

pub(crate) fn page() -> Result<String, Box<dyn Error>> {
    let head = ["lay angle", "exact, ν = 0", "Σ EA cos³θ", "exact, ν = 0.3", "Σ EA cos³θ", "Σ EA cos³θ/(1 + ν sin²θ)"];
    let mut rows = Vec::new();
    for angle in [5.0, 8.5, 12.0, 15.0, 17.0, 20.0, 25.0, 30.0] {
        let mut row = vec![degrees(angle)];
        for poisson in [0.0, 0.3] {
            let found = stiffness(angle, poisson)?;
            row.push(format!("{:.4}", found.exact));
            row.push(percent(found.cubes / found.exact - 1.0));
            if poisson > 0.0 {
                row.push(percent(found.thinned_cubes / found.exact - 1.0));
            }
        }
        rows.push(row);
    }
    Ok(table(&head.map(str::to_owned), rows))
}
