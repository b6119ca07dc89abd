//! (68)–(75): the ply as one straight rod.

use nply::mechanics::Balance;

use crate::common::touch::{Touch, slope, touch_at};
use crate::flexibility::step;
use crate::state::{balanced, close, scale, states};

#[test]
fn eq68_eq69() {
    let (scale, r, length) = (scale(), 0.3, 25.0);
    for state in states(Balance::Contact) {
        let Touch { s, c, rho, .. } = state.t;
        let (a, big_r) = (r / length, scale.length(rho));
        let twist = state.eps * (length / big_r) * s / (length * c);
        close(scale.per_length(state.got.ply_twist()), twist, twist, 1e-13, "(68)");
        let (d_m, d_f) = (state.got.rotation() / a, state.got.extension() / a);
        close(scale.per_length(state.got.ply_twist()), d_m / d_f / r, twist, 1e-13, "(68), second form");
        // (69): 1 at the state itself
        close(a * d_f / c, 1.0, 1.0, 1e-14, "(69)");
    }
}

/// (70) and (71) as printed, through (60) with the printed (63); (72) to (75) are their reciprocals.
#[test]
fn eq70_eq71_eq72_eq73_eq74_eq75() {
    let (scale, r, b) = (scale(), 0.3, 7.0);
    for state in balanced(Balance::Radial) {
        let Touch { s, c, rho, .. } = state.t;
        let (eps, g) = (state.eps, state.got.balance_slope());
        let [[ff, fm], [mf, mm]] = state.got.flexibility_as_published().unwrap();
        // d(d_m/d_f) = d(d_m)/d_f − d_m d(d_f)/d_f², a = 1
        let (d_f, d_m) = (state.got.extension(), state.got.rotation());
        let twist_by = |df: f64, dm: f64| dm / d_f - d_m * df / (d_f * d_f);
        close(twist_by(fm, mm) / r, 1.0 / g / (r * c), 1.0 / g / (r * c), 1e-12, "(70), m");
        let want = -eps / g * rho * s / (r * c * c);
        // two terms of one sign: nothing cancels
        close(twist_by(ff, mf) / r, want, want, 1e-12, "(70), f");
        close(ff / c, rho * rho * s * s / (g * c), ff / c, 1e-13, "(71), f");
        close(fm / c, -eps / g * rho * s, fm / c, 1e-13, "(71), m");

        let got = state.got.stiffness_as_published().unwrap();
        let big_r = rho * r;
        close(scale.stiffness(got.torsional), b * c * g, b * g, 1e-13, "(72)");
        let axial = b * c / (big_r * big_r * s * s) * g;
        close(scale.force(got.axial), axial, axial, 1e-13, "(73)");
        let cross = -eps * b * c * c / (big_r * s) * g;
        close(scale.moment(got.force_per_twist), cross, cross, 1e-13, "(74)");
        let cross = -eps * b / (big_r * s) * g;
        close(scale.moment(got.moment_per_extension), cross, cross, 1e-13, "(75)");
    }
}

/// The same without dropping ρ′, by differences along the branch, in both balances.
#[test]
fn whole_stiffness() {
    for balance in Balance::BOTH {
        for state in states(balance).into_iter().chain(balanced(balance)) {
            let Touch { theta, c, .. } = state.t;
            let n = state.got.contact().strands();
            let (by_force, by_moment) = state.got.angle_slopes().unwrap();
            let twist = slope(|t| state.eps * t.tan() / touch_at(n, t).rho, theta, step(theta));
            let extension = slope(f64::cos, theta, 1e-3) / c;
            let got = state.got.stiffness().unwrap();
            // d(tan θ/ρ)/dθ passes through zero near the greatest number of turns per ply length: compare reciprocals
            let size = 1.0 / (c * c * state.t.rho) + state.t.rho;
            let name = state.name();
            close(1.0 / got.torsional, twist * by_moment, size * by_moment, 3e-7, &name);
            close(1.0 / got.force_per_twist, twist * by_force, size * by_force, 3e-7, &name);
            close(1.0 / got.axial, extension * by_force, extension * by_force, 1e-9, &name);
            close(1.0 / got.moment_per_extension, extension * by_moment, extension * by_moment, 1e-9, &name);
        }
    }
}
