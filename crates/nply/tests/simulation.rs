//! Free elastic rods in contact, simulated without a helix, a contact formula or a balance (`authorities/simulate.py`), against the theory.

#![allow(clippy::unwrap_used, clippy::panic)] // a test fails by panicking

mod common;

use common::{Row, short_table, table};
use nply::Handedness;
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Support, Twist};

/// What a row's rods were given.
struct Given {
    strands: u32,
    stiffness_ratio: f64,
    twist: Twist,
    load: Load,
}

impl Given {
    fn of(row: &Row) -> Self {
        Self {
            strands: row.strands(),
            stiffness_ratio: row.number("gamma"),
            twist: Twist::Pretwist(row.number("pretwist")),
            load: Load { force: row.number("force"), moment: row.number("moment") },
        }
    }

    /// The state of a balance and a hand whose angle is nearest.
    fn nearest(&self, balance: Balance, hand: Handedness, degrees: f64) -> Equilibrium {
        let ply = Ply::with_balance(self.strands, self.stiffness_ratio, balance).unwrap();
        let off = |state: &Equilibrium| (state.contact().angle().degrees() - degrees).abs();
        let states = ply.equilibria(self.twist, self.load).unwrap();
        states.into_iter().filter(|s| s.handedness() == hand).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap()
    }
}

fn hand(row: &Row) -> Handedness {
    if row.number("handedness") > 0.0 { Handedness::Right } else { Handedness::Left }
}

#[track_caller]
fn assert_within(got: f64, simulated: f64, error: f64, what: &str) {
    assert!((got - simulated).abs() <= error, "{what}: {got}, simulated {simulated} ± {error:e}");
}

/// Angle, radius and the force between neighbours are those of contact balance, to the simulation's own error; radial
/// balance, where it says something else, is at least a thousand errors away.
#[test]
fn free_rods_that_touch_come_to_rest_in_contact_balance() {
    for row in table("simulation").iter().filter(|row| row.text("core_radius").is_empty()) {
        let (given, simulated, error) = (Given::of(row), row.number("theta_simulated_deg"), row.number("error_deg"));
        let state = given.nearest(Balance::Contact, hand(row), simulated);
        let (angle, what) = (state.contact().angle().degrees(), format!("n = {}, {:?}", given.strands, given.twist));
        assert_within(angle, simulated, error, &what);
        assert_within(angle, row.number("theta_contact_deg"), 2e-10, &what);
        assert_within(
            state.contact().radius_ratio(),
            row.number("helix_radius"),
            row.number("helix_radius_error"),
            &what,
        );
        assert_within(
            state.interstrand_pressure(),
            row.number("contact_force"),
            row.number("contact_force_error"),
            &what,
        );

        let radial = given.nearest(Balance::Radial, hand(row), simulated).contact().angle().degrees();
        if given.strands == 2 && simulated < 45.0 {
            assert_within(radial, angle, 1e-10, &what); // line contact: one balance
        } else {
            assert!((radial - simulated).abs() > 1000.0 * error, "{what}: {radial} is not told apart");
        }
    }
}

/// Strands that a core holds apart obey radial balance, in the same simulation.
#[test]
fn free_rods_apart_on_a_core_come_to_rest_in_radial_balance() {
    let rows = table("simulation");
    let cored: Vec<&Row> = rows.iter().filter(|row| !row.text("core_radius").is_empty()).collect();
    assert!(!cored.is_empty());
    for row in cored {
        let given = Given::of(row);
        let ply = Ply::new(given.strands, given.stiffness_ratio).unwrap();
        let states = ply.supported_states(given.twist, given.load, Some(row.number("core_radius"))).unwrap();
        let (simulated, error) = (row.number("theta_simulated_deg"), row.number("error_deg"));
        let state = states.iter().find(|s| s.handedness() == hand(row) && s.support() == Support::Core).unwrap();
        assert_within(state.angle().degrees(), simulated, error, "on a core");
        assert_within(state.angle().degrees(), row.number("theta_radial_deg"), 2e-10, "on a core");
    }
}

/// The answers to small changes of force and moment; the two mixed ones are one number, as radial balance has them not.
#[test]
fn free_rods_answer_small_loads_as_contact_balance_says() {
    let rows = short_table("simulation_flexibility");
    let states = table("simulation");
    for row in &rows {
        let same = |other: &&Row| ["n", "gamma", "pretwist"].iter().all(|name| other.text(name) == row.text(name));
        let unloaded = |other: &&Row| other.number("force") == 0.0 && other.number("moment") == 0.0;
        let state = states.iter().filter(unloaded).find(same).unwrap();
        let given = Given::of(state);
        let place = |column: &str, second: &str| usize::from(row.text(column) == second);
        let entry = |balance| {
            let at = given.nearest(balance, hand(state), state.number("theta_simulated_deg"));
            at.flexibility().unwrap()[place("displacement", "d_m")][place("load", "m")]
        };
        let (simulated, error) = (row.number("simulated"), row.number("error"));
        assert_within(entry(Balance::Contact), simulated, error, "flexibility");
        assert!((entry(Balance::Radial) - simulated).abs() > 100.0 * error, "radial balance is not told apart");
    }
    let mixed: Vec<f64> = rows
        .iter()
        .filter(|row| {
            ["d_f m", "d_m f"].contains(&format!("{} {}", row.text("displacement"), row.text("load")).as_str())
        })
        .map(|row| row.number("simulated"))
        .collect();
    assert_eq!(mixed.len(), 2 * rows.len() / 4);
    for pair in mixed.chunks(2) {
        assert!((pair[0] - pair[1]).abs() < 1e-5, "{pair:?}");
    }
}
