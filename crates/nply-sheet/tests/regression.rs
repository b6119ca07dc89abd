//! Estimates against plies whose numbers are known: without noise to rounding, with noise as often as the errors say.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]

use nply::Handedness;
use nply::mechanics::{Balance, ExtensiblePly, Load, Ply, StretchingStrand, Support, Twist};
use nply_sheet::Spec;
use nply_sheet::regression::{
    DataColumn, Given, Measurements, Model, Observable, Parameter, Regressed, Regression, RegressionQuestion,
    RegressionReport, Role,
};

/// Uniform numbers, the same on every machine (Steele and others' split mix), and normal ones from pairs of them.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }
}

/// A cord: n strands, r in m, B in N m², γ, twist per length in rad/m.
#[derive(Clone, Copy)]
struct Cord {
    strands: u32,
    radius: f64,
    bending: f64,
    ratio: f64,
    per_length: f64,
    balance: Balance,
}

const CORD: Cord =
    Cord { strands: 3, radius: 0.3e-3, bending: 2e-9, ratio: 0.8, per_length: -1500.0, balance: Balance::Contact };

impl Cord {
    fn model(self) -> Model {
        Model::new(self.strands, self.balance)
            .and_then(|m| m.with(Parameter::Radius, self.radius))
            .and_then(|m| m.with(Parameter::BendingStiffness, self.bending))
            .and_then(|m| m.with(Parameter::StiffnessRatio, self.ratio))
            .and_then(|m| m.with(Parameter::TurnsPerLength, self.per_length))
            .unwrap()
    }

    /// Force and moment in SI → angle, turning per strand length (rad/m), lay length (m), of the right-handed state of least angle.
    fn state(self, force: f64, moment: f64) -> (f64, f64, f64) {
        let (r, b) = (self.radius, self.bending);
        let ply = Ply::with_balance(self.strands, self.ratio, self.balance).unwrap();
        let load = Load { force: force * r * r / b, moment: moment * r / b };
        let state = ply.equilibria(Twist::Pretwist(self.per_length * r), load).unwrap()[0];
        assert_eq!(state.handedness(), Handedness::Right);
        (state.contact().helical_angle(), state.rotation() / r, state.contact().lay_length() * r)
    }
}

fn near(found: f64, truth: f64, share: f64, what: &str) {
    assert!((found - truth).abs() <= share * truth.abs(), "{what}: {found} for {truth}");
}

fn estimated(fit: &Regressed, parameter: Parameter) -> f64 {
    fit.estimates.iter().find(|estimate| estimate.parameter == parameter).unwrap().value
}

fn loads() -> Vec<(f64, f64)> {
    let forces = [0.0, 1e-3, 3e-3, 6e-3, 1e-2];
    forces.iter().flat_map(|f| [-2e-6, 0.0, 2e-6].map(|m| (*f, m))).collect()
}

/// Columns of a cord under dead loads: angle and turning measured with given errors, of which noise is drawn.
fn columns(cord: Cord, errors: [f64; 2], noise: Option<&mut Noise>) -> Vec<DataColumn> {
    let loads = loads();
    let mut none = Noise(0);
    let scale = if noise.is_some() { 1.0 } else { 0.0 };
    let noise = noise.unwrap_or(&mut none);
    let mut angles = Vec::new();
    let mut turns = Vec::new();
    for (force, moment) in &loads {
        let (angle, turning, _) = cord.state(*force, *moment);
        angles.push(angle + scale * errors[0] * noise.normal());
        turns.push(turning + scale * errors[1] * noise.normal());
    }
    let count = loads.len();
    vec![
        DataColumn::held(Observable::Force, loads.iter().map(|l| l.0).collect()),
        DataColumn::held(Observable::Moment, loads.iter().map(|l| l.1).collect()),
        DataColumn::new(Observable::HelicalAngle, angles, Role::Measured(vec![errors[0]; count])),
        DataColumn::new(Observable::PlyTurnsPerStrandLength, turns, Role::Measured(vec![errors[1]; count])),
    ]
}

#[test]
fn without_noise_every_number_comes_back() {
    use Parameter::{
        BendingStiffness, Diameter, Radius, ShearModulus, StiffnessRatio, TorsionalStiffness, TurnsPerLength,
        YoungsModulus,
    };
    let fourth = std::f64::consts::PI * CORD.radius.powi(4);
    let truth = |parameter| match parameter {
        Radius => CORD.radius,
        Diameter => 2.0 * CORD.radius,
        BendingStiffness => CORD.bending,
        YoungsModulus => 4.0 * CORD.bending / fourth,
        StiffnessRatio => CORD.ratio,
        TorsionalStiffness => CORD.ratio * CORD.bending,
        ShearModulus => 2.0 * CORD.ratio * CORD.bending / fourth,
        TurnsPerLength => CORD.per_length,
        other => panic!("{other:?}"),
    };
    for strands in [2, 3, 7] {
        for balance in Balance::BOTH {
            let cord = Cord { strands, balance, ..CORD };
            for asked in [
                &[StiffnessRatio][..],
                &[Radius],
                &[BendingStiffness],
                &[TurnsPerLength],
                &[Radius, BendingStiffness, StiffnessRatio],
                &[Diameter, BendingStiffness, TorsionalStiffness, TurnsPerLength],
                &[Radius, YoungsModulus, ShearModulus, TurnsPerLength],
            ] {
                let start = asked
                    .iter()
                    .zip([1.4, 0.8, 1.3, 0.9])
                    .try_fold(cord.model(), |model, (parameter, off)| model.with(*parameter, off * truth(*parameter)));
                let fit = Regression::new(start.unwrap(), asked, columns(cord, [1e-3, 1.0], None))
                    .unwrap()
                    .with_starts(2)
                    .run()
                    .unwrap();
                for parameter in asked {
                    near(
                        estimated(&fit, *parameter),
                        truth(*parameter),
                        1e-9,
                        &format!("{strands} {balance:?} {asked:?} {parameter:?}"),
                    );
                }
                assert_eq!(fit.degrees_of_freedom, 30 - asked.len());
                assert!(fit.chi_squared < 1e-12, "{}", fit.chi_squared);
            }
        }
    }
}

/// Over many draws: pulls (estimate less truth, in standard errors) have a mean of 0 and a variance of 1, and χ² that of its degrees.
#[test]
fn standard_errors_are_as_large_as_the_scatter() {
    let asked = [Parameter::Radius, Parameter::BendingStiffness, Parameter::StiffnessRatio];
    let truth = [CORD.radius, CORD.bending, CORD.ratio];
    const DRAWS: u64 = 200;
    let mut noise = Noise(7);
    let (mut pulls, mut squares, mut chi, mut chi_squares) = ([0.0; 3], [0.0; 3], 0.0, 0.0);
    let mut beyond = 0;
    let mut product = 0.0;
    let mut said = 0.0;
    for _ in 0..DRAWS {
        let columns = columns(CORD, [5e-3, 8.0], Some(&mut noise));
        let fit = Regression::new(CORD.model(), &asked, columns).unwrap().with_starts(1).run().unwrap();
        let pull: Vec<f64> = fit
            .estimates
            .iter()
            .zip(truth)
            .map(|(estimate, truth)| {
                let error = estimate.standard_error.unwrap();
                // the spread is that of the logarithm
                (estimate.value / truth).ln() / (error / estimate.value)
            })
            .collect();
        for k in 0..3 {
            pulls[k] += pull[k];
            squares[k] += pull[k] * pull[k];
            beyond += usize::from(pull[k].abs() > 3.0);
        }
        product += pull[0] * pull[1];
        said += fit.correlation[0][1].unwrap();
        chi += fit.chi_squared;
        chi_squares += fit.chi_squared * fit.chi_squared;
    }
    let draws = DRAWS as f64;
    for k in 0..3 {
        let mean = pulls[k] / draws;
        let variance = squares[k] / draws - mean * mean;
        assert!(mean.abs() < 0.25, "{k}: {mean}"); // 3.5 of its own errors
        assert!((0.65..1.4).contains(&variance), "{k}: {variance}");
    }
    assert!(beyond <= 8, "{beyond} of {} beyond three errors", 3 * DRAWS); // 1.6 are expected
    assert!((product / draws - said / draws).abs() < 0.25, "{} {}", product / draws, said / draws);
    let (mean, freedom) = (chi / draws, 27.0);
    assert!((mean - freedom).abs() < 2.0, "{mean}");
    let variance = chi_squares / draws - mean * mean;
    assert!((0.6 * 2.0 * freedom..1.6 * 2.0 * freedom).contains(&variance), "{variance}");
}

/// Forces and moments with errors of their own, as a machine reads them, beside a turning that is held: estimates stay unbiased.
#[test]
fn loads_may_be_measured_too() {
    let loads = loads();
    let truth = [CORD.bending, CORD.ratio];
    let asked = [Parameter::BendingStiffness, Parameter::StiffnessRatio];
    let run = |noise: &mut Noise, size: f64| {
        let (mut forces, mut moments, mut turns, mut lays) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (force, moment) in &loads {
            let (_, turning, lay) = CORD.state(*force, *moment);
            forces.push(force + size * 2e-4 * noise.normal());
            moments.push(moment + size * 2e-7 * noise.normal());
            turns.push(turning + size * 2.0 * noise.normal());
            lays.push(lay + size * 3e-6 * noise.normal());
        }
        let measured = |observable, values: Vec<f64>, error: f64| {
            let count = values.len();
            DataColumn::new(observable, values, Role::Measured(vec![error; count]))
        };
        let columns = vec![
            measured(Observable::Force, forces, 2e-4),
            measured(Observable::Moment, moments, 2e-7),
            measured(Observable::PlyTurnsPerStrandLength, turns, 2.0),
            measured(Observable::LayLength, lays, 3e-6),
        ];
        let start = CORD.model().with(Parameter::BendingStiffness, 1.3 * truth[0]).unwrap();
        Regression::new(start, &asked, columns).unwrap().with_starts(1).run().unwrap()
    };
    let exact = run(&mut Noise(1), 0.0);
    near(exact.estimates[0].value, truth[0], 1e-9, "B");
    near(exact.estimates[1].value, truth[1], 1e-9, "γ");
    // four numbers a row, of which two go into the row's own state
    assert_eq!(exact.degrees_of_freedom, 2 * loads.len() - 2);
    const DRAWS: usize = 30;
    let mut noise = Noise(11);
    let (mut squares, mut chi) = ([0.0; 2], 0.0);
    for _ in 0..DRAWS {
        let fit = run(&mut noise, 1.0);
        for k in 0..2 {
            let estimate = fit.estimates[k];
            let pull = (estimate.value / truth[k]).ln() * estimate.value / estimate.standard_error.unwrap();
            squares[k] += pull * pull / DRAWS as f64;
        }
        chi += fit.chi_squared / DRAWS as f64;
    }
    for square in squares {
        assert!((0.4..1.9).contains(&square), "{squares:?}");
    }
    assert!((chi - 28.0).abs() < 4.5, "{chi}");
}

/// A column of each kind alone gives what it depends on.
#[test]
fn every_column_serves() {
    let length = 0.5;
    let model = || {
        let mut model = CORD.model();
        model.strand_length = Some(length);
        model
    };
    for observable in Observable::ALL.into_iter().filter(|observable| !observable.is_load()) {
        let r = CORD.radius;
        let value = |(force, moment): &(f64, f64)| {
            let ply = Ply::new(CORD.strands, CORD.ratio).unwrap();
            let load = Load { force: force * r * r / CORD.bending, moment: moment * r / CORD.bending };
            let state = ply.equilibria(Twist::Pretwist(CORD.per_length * r), load).unwrap()[0];
            let at = state.contact();
            match observable {
                Observable::LengthRatio => state.extension(),
                Observable::PlyLength => length * state.extension(),
                Observable::PlyRotation | Observable::PlyTurns => state.rotation() * length / r,
                Observable::PlyTurnsPerStrandLength => state.rotation() / r,
                Observable::PlyTurnsPerLength => state.ply_twist() / r,
                Observable::HelicalAngle | Observable::LayAngle => at.helical_angle(),
                Observable::PitchAngle => at.pitch_angle(),
                Observable::LayLength => at.lay_length() * r,
                Observable::LayRatio => at.lay_ratio(),
                Observable::RadiusRatio => at.radius_ratio(),
                Observable::HelixRadius => at.radius_ratio() * r,
                Observable::OuterDiameter => 2.0 * at.outer_radius() * r,
                other => panic!("{other:?}"),
            }
        };
        let loads = loads();
        let columns = vec![
            DataColumn::held(Observable::Force, loads.iter().map(|l| l.0).collect()),
            DataColumn::held(Observable::Moment, loads.iter().map(|l| l.1).collect()),
            DataColumn::new(observable, loads.iter().map(value).collect(), Role::Unweighted),
        ];
        let asked = [Parameter::BendingStiffness, Parameter::StiffnessRatio];
        let start =
            model().with(Parameter::StiffnessRatio, 1.2).unwrap().with(Parameter::BendingStiffness, 1.5e-9).unwrap();
        let fit = Regression::new(start, &asked, columns).unwrap().run().unwrap();
        near(fit.estimates[0].value, CORD.bending, 1e-8, observable.name());
        near(fit.estimates[1].value, CORD.ratio, 1e-8, observable.name());
    }
}

/// Held turning, measured moment: what a torsion machine gives. The force is dead.
#[test]
fn shapes_may_be_held_and_loads_measured() {
    let r = CORD.radius;
    let (force_unit, moment_unit) = (CORD.bending / r / r, CORD.bending / r);
    let ply = Ply::new(CORD.strands, CORD.ratio).unwrap();
    let turns: Vec<f64> = (1..12).map(|k| 120.0 * f64::from(k)).collect();
    let moments: Vec<f64> = turns
        .iter()
        .map(|turning| {
            // the angle that has the turning, by halving below the most turns
            let (mut low, mut high) = (0.0, 0.6);
            for _ in 0..100 {
                let middle: f64 = 0.5 * (low + high);
                let at = nply::geometry::Contact::new(3, middle).unwrap();
                if middle.sin() / at.radius_ratio() < turning * r { low = middle } else { high = middle }
            }
            let angle = nply::geometry::HelicalAngle::new(low).unwrap();
            let twist = Twist::Pretwist(CORD.per_length * r);
            ply.moment_at(angle, Handedness::Right, twist, 5e-3 / force_unit).unwrap().load().moment * moment_unit
        })
        .collect();
    let count = turns.len();
    let columns = vec![
        DataColumn::held(Observable::Force, vec![5e-3; count]),
        DataColumn::held(Observable::PlyTurnsPerStrandLength, turns),
        DataColumn::new(Observable::Moment, moments, Role::Measured(vec![1e-8; count])),
    ];
    let asked = [Parameter::BendingStiffness, Parameter::TorsionalStiffness, Parameter::TurnsPerLength];
    let start =
        CORD.model().with(Parameter::TurnsPerLength, -1100.0).unwrap().with(Parameter::BendingStiffness, 3e-9).unwrap();
    let fit = Regression::new(start, &asked, columns).unwrap().run().unwrap();
    // B and C tell apart only as far as the force's share of the moment does: looser than elsewhere
    near(fit.estimates[0].value, CORD.bending, 1e-6, "B");
    near(fit.estimates[1].value * fit.estimates[2].value, CORD.bending * CORD.ratio * CORD.per_length, 1e-6, "C φ̄/L");
}

/// Strands that stretch: k (EA) with the radius, as of an actuator's strings, from length and turning under dead loads.
#[test]
fn strands_that_stretch_give_their_stiffness() {
    let (n, r, b, gamma, axial, nu) = (3, 0.5e-3, 1e-8, 0.8, 3e3, 0.2);
    let (force_unit, moment_unit) = (b / r / r, b / r);
    let strand = StretchingStrand::new(gamma, axial / force_unit, nu).unwrap();
    let ply = ExtensiblePly::new(n, strand).unwrap();
    let loads: Vec<(f64, f64)> =
        [5.0, 15.0, 30.0, 50.0].iter().flat_map(|f| [2e-3, 6e-3, 1.2e-2].map(|m| (*f, m))).collect();
    let states: Vec<(f64, f64)> = loads
        .iter()
        .map(|(force, moment)| {
            let load = Load { force: force / force_unit, moment: moment / moment_unit };
            let states = ply.states(Twist::Pretwist(0.0), load).unwrap();
            let state = states.iter().find(|state| state.support() == Support::Neighbours).unwrap();
            assert_eq!(state.handedness(), Handedness::Right);
            (state.extension(), state.rotation() / r)
        })
        .collect();
    let count = loads.len();
    let columns = vec![
        DataColumn::held(Observable::Force, loads.iter().map(|l| l.0).collect()),
        DataColumn::held(Observable::Moment, loads.iter().map(|l| l.1).collect()),
        DataColumn::new(
            Observable::LengthRatio,
            states.iter().map(|s| s.0).collect(),
            Role::Measured(vec![1e-4; count]),
        ),
        DataColumn::new(
            Observable::PlyTurnsPerStrandLength,
            states.iter().map(|s| s.1).collect(),
            Role::Measured(vec![0.5; count]),
        ),
    ];
    let mut start = Model::new(n, Balance::Contact)
        .and_then(|m| m.with(Parameter::Radius, 0.4e-3))
        .and_then(|m| m.with(Parameter::BendingStiffness, b))
        .and_then(|m| m.with(Parameter::StiffnessRatio, gamma))
        .and_then(|m| m.with(Parameter::Pretwist, 0.0))
        .and_then(|m| m.with(Parameter::AxialStiffness, 6e3))
        .unwrap();
    start.thinning = nu;
    let asked = [Parameter::AxialStiffness, Parameter::Radius];
    let fit = Regression::new(start, &asked, columns).unwrap().run().unwrap();
    near(fit.estimates[0].value, axial, 1e-8, "EA");
    near(fit.estimates[1].value, r, 1e-8, "r");
}

/// Under one load several states are in equilibrium: each row goes to the one that was measured, whichever that is.
#[test]
fn a_row_belongs_to_the_state_nearest_to_it() {
    // radial balance, two strands: every pretwist has two balanced angles, of opposite hands, on either side of 45°
    let ply = Ply::with_balance(2, 0.7, Balance::Radial).unwrap();
    let (mut twists, mut angles) = (Vec::new(), Vec::new());
    for pretwist in [-0.4, -0.8, -1.6, -3.0] {
        for state in ply.equilibria(Twist::Pretwist(pretwist), Load::NONE).unwrap() {
            twists.push(pretwist);
            angles.push(state.contact().helical_angle());
        }
    }
    assert_eq!(angles.len(), 8);
    let columns = vec![
        DataColumn::held(Parameter::Pretwist, twists),
        DataColumn::new(Observable::HelicalAngle, angles, Role::Measured(vec![1e-3; 8])),
    ];
    let model = Model::new(2, Balance::Radial).unwrap().with(Parameter::StiffnessRatio, 1.5).unwrap();
    let fit = Regression::new(model, &[Parameter::StiffnessRatio], columns).unwrap().run().unwrap();
    near(fit.estimates[0].value, 0.7, 1e-9, "γ");
    assert!(fit.rows.iter().all(|row| row.states == 2));
    assert!(fit.notes.iter().any(|note| note.contains("In 8 of 8 rows several states")), "{:?}", fit.notes);
}

#[test]
fn what_the_data_do_not_determine_is_said() {
    let run = |asked: &[Parameter], columns: Vec<DataColumn>| {
        Regression::new(CORD.model(), asked, columns).unwrap().run().unwrap()
    };
    // angles under a force alone: B and r come in as F r²/B and rφ̄/L; with a twist per radius held, B/r² is all there is
    let angles: Vec<f64> = loads().iter().map(|(force, _)| CORD.state(*force, 0.0).0).collect();
    let count = angles.len();
    let columns = || {
        vec![
            DataColumn::held(Observable::Force, loads().iter().map(|l| l.0).collect()),
            DataColumn::new(Observable::HelicalAngle, angles.clone(), Role::Measured(vec![1e-3; count])),
        ]
    };
    let model = CORD.model().with(Parameter::Pretwist, CORD.per_length * CORD.radius).unwrap();
    let both = [Parameter::BendingStiffness, Parameter::Radius];
    let fit = Regression::new(model, &both, columns()).unwrap().run().unwrap();
    assert!(fit.estimates.iter().all(|estimate| estimate.standard_error.is_none()));
    assert_eq!((fit.correlation[0][1], fit.degrees_of_freedom), (None, count - 1));
    assert_eq!(
        fit.notes[0],
        "These measurements do not tell bending_stiffness and radius apart: changing bending_stiffness by 1 % and radius by 0.5 % together \
         changes no residual. Near here only bending_stiffness/radius^2 is determined; hold one of the two."
    );
    near(fit.estimates[0].value / fit.estimates[1].value.powi(2), CORD.bending / CORD.radius.powi(2), 1e-8, "B/r²");
    // no load: B means nothing
    let free = CORD.state(0.0, 0.0).0;
    let angle = DataColumn::new(Observable::HelicalAngle, vec![free; 3], Role::Measured(vec![1e-3; 3]));
    let fit = run(&[Parameter::BendingStiffness], vec![angle]);
    assert_eq!(fit.estimates[0].standard_error, None);
    assert_eq!(
        fit.notes[0],
        "These measurements say nothing of bending_stiffness: it changes no residual. Hold it, or measure what depends on it."
    );
    // hardly told apart is not the same: one twist, two angles near each other
    let fit = run(&[Parameter::StiffnessRatio, Parameter::TurnsPerLength], {
        let two = [(0.0, 0.0), (1e-3, 0.0)];
        let angles = two.map(|(force, moment)| CORD.state(force, moment).0).to_vec();
        vec![
            DataColumn::held(Observable::Force, vec![0.0, 1e-3]),
            DataColumn::new(Observable::HelicalAngle, angles, Role::Measured(vec![1e-3; 2])),
        ]
    });
    assert!(fit.estimates.iter().all(|estimate| estimate.standard_error.is_some()));
    assert!(fit.notes.iter().any(|note| note.contains("hardly told apart")), "{:?}", fit.notes);
}

#[test]
fn without_errors_the_residuals_tell_them() {
    let mut noise = Noise(3);
    let with = columns(CORD, [4e-3, 1.0], Some(&mut noise));
    let alone = |role: Role| vec![with[0].clone(), with[1].clone(), DataColumn { role, ..with[2].clone() }];
    let asked = [Parameter::BendingStiffness, Parameter::StiffnessRatio];
    let run = |role| Regression::new(CORD.model(), &asked, alone(role)).unwrap().run().unwrap();
    let (weighed, free) = (run(Role::Measured(vec![4e-3; 15])), run(Role::Unweighted));
    let scale = (weighed.chi_squared / weighed.degrees_of_freedom as f64).sqrt();
    for (a, b) in weighed.estimates.iter().zip(&free.estimates) {
        near(b.value, a.value, 1e-9, "value");
        near(b.standard_error.unwrap(), scale * a.standard_error.unwrap(), 1e-6, "error");
    }
    assert_eq!((free.weighed, free.probability), (false, None));
    near(free.rows[0].compared[0].error.unwrap(), 4e-3 * scale, 1e-9, "a row's error");
}

/// Numbers that are not known are left out; a load that is not known is found with the row's state.
#[test]
fn gaps_are_gaps() {
    let mut columns = columns(CORD, [1e-3, 1.0], None);
    columns[2].values[3] = f64::NAN; // an angle
    columns[1].values[5] = f64::NAN; // a moment: the row's turning fixes it
    columns[3].values[0] = f64::NAN;
    columns[2].values[0] = f64::NAN; // nothing measured: no row
    let asked = [Parameter::BendingStiffness, Parameter::StiffnessRatio];
    let start = CORD.model().with(Parameter::StiffnessRatio, 1.1).unwrap();
    let fit = Regression::new(start, &asked, columns).unwrap().run().unwrap();
    near(fit.estimates[0].value, CORD.bending, 1e-9, "B");
    near(fit.estimates[1].value, CORD.ratio, 1e-9, "γ");
    assert_eq!(fit.rows.len(), 14);
    assert_eq!(fit.degrees_of_freedom, 30 - 2 - 1 - 1 - 2);
    near(fit.rows[4].moment, loads()[5].1, 1e-8, "the moment that was not known");
}

/// r, B and F, M scale together: dimensionless data give γ and the twist, and no unit changes any of it.
#[test]
fn units_change_nothing() {
    let deg = 180.0 / std::f64::consts::PI;
    let mut plain = String::from("# angles\nforce [N],moment_N_mm,helical_angle_deg,helical_angle_error_deg\n");
    let mut other = String::from("force_kgf;moment [lbf in];helical_angle (rad);helical_angle_error_deg;note\n");
    let mut bare = String::from("force\tmoment\thelical_angle_deg\thelical_angle_error_deg\n");
    let (r, b) = (CORD.radius, CORD.bending);
    for (force, moment) in loads() {
        let angle = CORD.state(force, moment).0;
        plain += &format!("{force:?},{:?},{:?},0.1\n", moment * 1e3, angle * deg);
        other +=
            &format!("{:?};{:?};{angle:?};0.1;\"a, note\"\n", force / 9.80665, moment / (4.448_221_615_260_5 * 0.0254));
        bare += &format!("{:?}\t{:?}\t{:?}\t0.1\n", force * r * r / b, moment * r / b, angle * deg);
    }
    let sized = [
        ("strands", "3"),
        ("radius", "0.3 mm"),
        ("bending-stiffness", "2e-9 N m^2"),
        ("stiffness-ratio", "1.1"),
        ("pretwist", "-0.4"),
    ];
    let report = |data: &str, flags: &[(&str, &str)]| {
        let question = RegressionQuestion {
            estimate: vec!["stiffness_ratio".into(), "pretwist".into()],
            ..RegressionQuestion::default()
        };
        let data = Measurements::read("data.csv", data.as_bytes()).unwrap();
        RegressionReport::of(&Spec::from_flags(flags.iter().copied()).unwrap(), &data, &question).unwrap()
    };
    let fits = [report(&plain, &sized), report(&other, &sized), report(&bare, &[sized[0], sized[3], sized[4]])];
    for fit in &fits {
        let [ratio, twist] = &fit.answer().estimates[..] else { panic!() };
        near(ratio.value, CORD.ratio, 1e-8, "γ");
        near(twist.value, CORD.per_length * CORD.radius, 1e-8, "φ̄a");
        near(ratio.standard_error.unwrap(), fits[0].answer().estimates[0].standard_error.unwrap(), 1e-6, "error");
    }
}

#[test]
fn what_cannot_be_answered_is_refused_in_a_sentence() {
    let sized = "radius = \"0.3 mm\"\nbending_stiffness = \"2e-9 N m^2\"\n";
    let table = include_str!("regression/refused.txt");
    let mut count = 0;
    let mut found = String::new();
    for case in table.split("\n\n").filter(|case| !case.trim().is_empty() && !case.starts_with('#')) {
        let (mut size, mut question, mut rows, mut wanted) =
            ("", RegressionQuestion::default(), Vec::new(), Vec::new());
        question.estimate = vec!["stiffness_ratio".to_owned()];
        let mut more = String::new();
        for line in case.lines() {
            match line.split_once(": ") {
                Some(("sized", _)) => size = sized,
                Some(("estimate", names)) => question.estimate = names.split(',').map(str::to_owned).collect(),
                Some(("measured", names)) => question.measured = names.split(',').map(str::to_owned).collect(),
                Some(("held", names)) => question.held = names.split(',').map(str::to_owned).collect(),
                Some(("error", text)) => question.errors.push(text.to_owned()),
                Some(("ply", text)) => more += &format!("{text}\n"),
                Some((">", sentence)) => wanted.push(sentence.to_owned()),
                _ => rows.push(line.strip_prefix("| ").unwrap_or(line)),
            }
        }
        let twist = if rows.first().is_some_and(|head| head.contains("pretwist")) || more.contains("[twist]") {
            ""
        } else {
            "[twist]\npretwist = -0.5\n"
        };
        let ply = format!("ply.strands = 3\n[strand]\nstiffness_ratio = 0.75\n{size}{more}{twist}");
        let spec = Spec::from_toml("ply.toml", &ply).unwrap();
        let data = Measurements::read("data.csv", rows.join("\n").as_bytes());
        let answer = data.and_then(|data| RegressionReport::of(&spec, &data, &question));
        let said = answer.err().unwrap_or_else(|| panic!("it is answered:\n{case}")).to_string();
        let kept: Vec<&str> = case.lines().filter(|line| !line.starts_with(">: ")).collect();
        found += &format!("{}\n>: {said}\n\n", kept.join("\n"));
        if std::env::var_os("UPDATE_MESSAGES").is_none() {
            assert_eq!(wanted, [said], "{case}");
        }
        count += 1;
    }
    if std::env::var_os("UPDATE_MESSAGES").is_some() {
        let head = table.lines().take_while(|line| line.starts_with('#')).collect::<Vec<_>>().join("\n");
        std::fs::write(
            concat!(env!("CARGO_MANIFEST_DIR"), "/tests/regression/refused.txt"),
            format!("{head}\n\n{}", found.trim_end().to_owned() + "\n"),
        )
        .unwrap();
    }
    assert!(count >= 30, "{count}");
}

#[test]
fn a_column_is_what_it_is_called() {
    for observable in Observable::ALL {
        assert_eq!(Given::from(observable).name(), observable.name());
    }
    for parameter in Parameter::ALL {
        assert_eq!(Parameter::named(&parameter.name().replace('_', "-")), Some(parameter));
    }
}

/// Turns without their sign: no stiffness ratio comes near, and one row does not tell more than two.
#[test]
fn a_search_that_runs_off_determines_nothing_of_one_row_either() {
    let ply = Spec::from_flags([("strands", "2"), ("diameter", "0.03 inch"), ("stiffness-ratio", "1")]).unwrap();
    let asked = RegressionQuestion { estimate: vec!["stiffness_ratio".to_owned()], ..RegressionQuestion::default() };
    for (rows, count) in [("8,5.2\n", "fitted to 1 row of"), ("8,5.2\n10,6.5\n", "fitted to 2 rows of")] {
        let table = format!("turns_per_length [tpi],ply_turns_per_length [tpi]\n{rows}");
        let data = Measurements::read("plied.csv", table.as_bytes()).unwrap();
        let report = RegressionReport::of(&ply, &data, &asked).unwrap();
        assert!(!report.answer().estimates[0].determined);
        let text = report.text(false);
        assert!(text.contains("–  not determined") && text.contains(count), "{text}");
    }
    // with its sign one row determines it, though nothing tells how well
    let table = "turns_per_length [tpi],ply_turns_per_length [tpi]\n8,-5.2\n";
    let data = Measurements::read("plied.csv", table.as_bytes()).unwrap();
    let report = RegressionReport::of(&ply, &data, &asked).unwrap();
    let estimate = report.answer().estimates[0];
    assert!(estimate.determined && estimate.standard_error.is_none());
}
