//! What a spinner should know of the plies, in sentences.

use core::f64::consts::TAU;

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle, SpecialLays};
use nply::mechanics::Balance;

use super::{Plied, opposite};
use crate::preferred::{six_digits, six_digits_within};
use crate::{Case, Dimension};

impl Plied {
    /// The lay of the most turns, if this one is closer: turns per strand length are fewer again.
    fn beyond_most_turns(&self) -> Option<Contact> {
        let contact = self.state.contact();
        let most = SpecialLays::of(contact.strands()).ok()?.zero_twist();
        (contact.helical_angle() > most.helical_angle()).then_some(most)
    }

    /// Which way the free end turns: the moment that holds it is let go.
    fn turns(&self) -> Handedness {
        opposite(if self.state.load().moment > 0.0 { Handedness::Right } else { Handedness::Left })
    }

    /// Whether the angle falls, let go: the energy rises with it, dE/dθ = m d(turns)/dθ. In radial balance the radius is held for that
    /// work, and turns always grow with the angle.
    fn lengthens(&self) -> bool {
        let more_turns_more_angle = self.balance == Balance::Radial || self.beyond_most_turns().is_none();
        (self.turns() != self.state.handedness()) == more_turns_more_angle
    }
}

/// What a reader should know, a sentence each.
pub(super) fn of(case: &Case, plies: &[Plied], rules: &[(Balance, HelicalAngle, HelicalAngle)]) -> Vec<String> {
    let mut notes = Vec::new();
    let find = |balance, name| plies.iter().find(|p: &&Plied| p.balance == balance && p.name == name);
    let angles: Vec<String> =
        rules.iter().map(|(balance, rule, _)| format!("{:.3}° ({} balance)", rule.degrees(), balance.name())).collect();
    let off = rules.first().and_then(|(balance, ..)| {
        let [balanced, rule] = [find(*balance, "balanced")?, find(*balance, "two_thirds")?];
        let more = 100.0 * (rule.per_ply_length() / balanced.per_ply_length() - 1.0);
        let word = if more > 0.0 { "more" } else { "less" };
        Some(format!(": here two thirds are {:.1} % {word} ply twist than balances", more.abs()))
    });
    notes.push(format!(
        "Two thirds of the singles twist balance a ply of one angle alone, {}{}.",
        angles.join(" and "),
        off.unwrap_or_default()
    ));
    match rules.first().map(|(balance, ..)| find(*balance, "two_thirds")) {
        Some(None) => notes.push(
            "Two thirds of the singles twist do not go into a ply of these singles: it would be closer than turns can lie to each other."
                .to_owned(),
        ),
        Some(Some(rule)) if rule.beyond_most_turns().is_some() => notes.push(
            "Two thirds of the singles twist do not go into a ply of these singles by turning: it would lie beyond the angle of the most turns."
                .to_owned(),
        ),
        _ => {}
    }
    let pulled: Vec<&str> = plies
        .iter()
        .filter(|plied| plied.state.interstrand_pressure() < 0.0)
        .map(|plied| if plied.name == "two_thirds" { "two thirds" } else { plied.name })
        .collect();
    if !pulled.is_empty() {
        notes.push(format!("Neighbours would have to pull on each other (p₁ < 0) in: {}.", pulled.join(", ")));
    }
    if let Some(given) = plies.iter().find(|plied| plied.name == "given") {
        notes.extend(given.beyond_most_turns().map(|most| most_turns(case, given, &most)));
        notes.extend(find(given.balance, "balanced").map(|balanced| let_go(given, balanced)));
        let radial = rules.iter().any(|(balance, ..)| *balance == Balance::Radial);
        if radial && given.beyond_most_turns().is_some() {
            notes.push(
                "Radial balance does not know that: its moment of the ply as given is that of turns which go on growing with the angle."
                    .to_owned(),
            );
        }
    }
    notes.push(
        "Fresh elastic singles are meant: what steam, heat or time has set in a yarn no longer turns it. Turns put in by a flyer or a \
         ring go into ply and singles together, as here."
            .to_owned(),
    );
    notes.extend(super::super::packing(case));
    notes
}

/// That a ply was asked for which turning does not make.
fn most_turns(case: &Case, given: &Plied, most: &Contact) -> String {
    // a limit is not printed past itself
    let written = |per_radius: f64| match case.strand_radius {
        Some(radius) => {
            let si = per_radius / radius;
            let unit = case.units.unit(Dimension::ANGLE_PER_LENGTH, si);
            format!("{} {unit}", six_digits_within(unit.of_si(si)))
        }
        None => format!("{} turns/r", six_digits_within(per_radius / TAU)),
    };
    let angle = most.angle();
    format!(
        "The ply as given lies beyond the angle of the most turns, {}°, by turns that do not go in: into singles of given length go {} at \
         most, in a ply of {}, and more do not go in. A closer ply has fewer of them again, {}, and turning does not make it.",
        six_digits(angle.degrees()),
        written(angle.sin() / most.radius_ratio()),
        written(angle.tan() / most.radius_ratio()),
        written(given.state.rotation().abs()),
    )
}

/// What the ply as given does when it is let go.
fn let_go(given: &Plied, balanced: &Plied) -> String {
    let (hand, turns) = (given.state.handedness(), given.turns());
    let more = given.per_ply_length() / balanced.per_ply_length();
    // up to the most turns the free end goes on turning, and back from there
    let on_and_back = given.beyond_most_turns().is_some().then(|| {
        let (on, back) = (hand.lay_letter(), opposite(hand).lay_letter());
        format!("Its free end turns {on} until it lies at the angle of the most turns, and {back} from there.")
    });
    if hand != balanced.state.handedness() {
        let winds = "The ply as given winds the same way as its singles were twisted";
        if !given.lengthens() {
            let turns = turns.lay_letter();
            return format!(
                "{winds}, so steeply that it does not turn back: let go, its angle grows. Its free end turns {turns}."
            );
        }
        let back = format!("{winds}: let go, it turns back through straight strands to the other hand.");
        return on_and_back.map_or_else(|| back.clone(), |path| format!("{back} {path}"));
    }
    if (more - 1.0).abs() < 1e-9 {
        return "The ply as given is balanced.".to_owned();
    }
    let (share, word) = if more > 1.0 { (more - 1.0, "more") } else { (1.0 - more, "less") };
    let has = format!("The ply as given has {:.1} % {word} ply twist than balances", 100.0 * share);
    if let Some(path) = on_and_back {
        return format!("{has}: let go, its angle falls until it is the balanced one. {path}");
    }
    let does = if given.lengthens() { "untwists" } else { "twists up further" };
    format!(
        "{has}: let go, it {does} until it is the balanced one. Its free end turns {turn}, and a slack loop of it snarls {turn}.",
        turn = turns.lay_letter()
    )
}
