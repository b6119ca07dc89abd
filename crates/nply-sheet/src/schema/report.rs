//! Schemas of what is written out as JSON: a report of each command.

use nply::mechanics::{Balance, Cause, Change, End, Holding, LayerSupport, Mark, Stability, Support};
use serde_json::{Value, json};

use super::meaning;
use super::node::{Object, flag, list, number, or_null, text, tuple, whole, words};
use crate::mesh::Element;
use crate::report::listed::{self, Named, Of, Sized};
use crate::report::{Known, Measure, header};

/// A report begins so.
fn report(about: &str) -> Object {
    let said = [
        ("program", "Who wrote this"),
        ("version", "The version of the program"),
        (
            "schema_version",
            "The version of this layout: it changes when a name is renamed or removed, not when one is added",
        ),
    ];
    header().into_iter().fold(Object::new(about), |object, (name, value)| {
        let meaning = said.iter().find(|(known, _)| *known == name).map_or("", |(_, meaning)| meaning);
        let schema = match value {
            Value::String(_) if name == "version" => text(meaning),
            value => json!({ "const": value, "description": meaning }),
        };
        object.with(name, schema)
    })
}

fn noted(object: Object) -> Object {
    object.with("notes", list("What a reader should know, a sentence each", text("A sentence")))
}

fn titled(object: Object) -> Object {
    object.may("title", text("The name given to it")).with("strands", whole("n, the number of strands", 1))
}

fn scaled(object: Object) -> Object {
    object
        .may("strand_radius_m", number("r, where it is known", "m"))
        .may("bending_stiffness_N_m2", number("B, where it is known", "N m²"))
}

fn balance() -> Value {
    words("Which balance was taken", Balance::BOTH.map(Balance::name))
}

/// One of several kinds of report.
fn kinds<const N: usize>(kinds: [(&str, Value); N]) -> Value {
    let titled = kinds.map(|(title, mut schema)| {
        schema["title"] = json!(title);
        schema
    });
    json!({ "anyOf": titled.to_vec() })
}

/// The unit of a number in JSON, where nothing has a size.
fn unit(measure: Measure) -> String {
    match measure {
        Measure::AnglePerForce => "rad r²/B".to_owned(),
        Measure::AnglePerMoment => "rad r/B".to_owned(),
        other => other.reading(Known::default(), &crate::PreferredUnits::default(), 1.0).unit,
    }
}

fn of_number(named: &Named) -> Value {
    let meaning = meaning::of(named.name, named.label);
    let mut schema = or_null(number(meaning, &unit(named.measure)));
    schema["title"] = json!(named.name.replace('_', " "));
    schema
}

/// All numbers of a thing, and the same in SI.
fn numbers(object: Object, of: Of) -> Object {
    let all = of.numbers();
    let object = object.all(all.iter().map(|named| (named.name.to_owned(), of_number(named))));
    object.may("si", si(&all))
}

fn si(all: &[Named]) -> Value {
    let mut properties = Object::new("The same in SI, where the scale is known");
    for named in all {
        if let Some((_, unit)) = named.measure.si(Known::sample(true, true)) {
            properties = properties.may(named.name, or_null(number(meaning::of(named.name, named.label), unit)));
        }
    }
    properties.open()
}

/// Per name the unit of the numbers in `si`.
fn units(object: Object) -> Object {
    let units = json!({
        "type": "object",
        "additionalProperties": { "type": "string" },
        "description": "Per name the unit of the numbers in `si`, where the scale is known",
    });
    object.may("si_units", units)
}

fn hand(object: Object) -> Object {
    object
        .with("handedness", json!({ "enum": [1, -1], "description": "1 right-handed (Z), −1 left-handed (S)" }))
        .with("lay", words("The letter of the hand", ["Z", "S"]))
}

fn verdict(meaning: &str) -> Value {
    or_null(words(meaning, [Stability::Stable, Stability::Unstable, Stability::Marginal].map(Stability::name)))
}

fn holdings(stretched: bool) -> Value {
    let all = listed::holdings(stretched).into_iter();
    let each = all.map(|(name, words)| (name.to_owned(), verdict(&format!("{words}; none where nothing can be said"))));
    Object::new("Stable or not, by what is held").all(each).open()
}

fn carried() -> Value {
    let all = [Support::Neighbours, Support::Core, Support::Both, Support::Free].map(Support::name);
    words("What carries the strands: neighbours, the core, both, or nothing (free helices)", all)
}

fn question() -> Value {
    let find = ["states", "moment", "force", "pretwist", "separation", "supported_states"];
    let given = [
        ("pretwist", "φ̄a", ""),
        ("strand_twist", "r u₃", ""),
        ("force", "f", "B/r²"),
        ("moment", "m", "B/r"),
        ("rotation", "a d_m, of ends that cannot turn", ""),
        ("extension", "a d_f, of a length that is held", ""),
        ("core_radius", "the core's radius", "r"),
    ];
    let given = given
        .into_iter()
        .fold(Object::new("The data that were given, dimensionless"), |object, (name, meaning, unit)| {
            object.may(name, number(meaning, unit))
        });
    Object::new("What was asked").with("find", words("What is looked for", find)).with("given", given.open()).open()
}

fn margins() -> Value {
    let causes = [Cause::Separation, Cause::Fold, Cause::MostTurns, Cause::Straight, Cause::Rings].map(Cause::name);
    let limit = |change: Change| {
        let measure = listed::margin(change);
        let unit = unit(measure);
        let mut si = Object::new("The same in SI, where the scale is known");
        for (name, measure) in [("change", measure), ("force", Measure::Force), ("moment", Measure::Moment)] {
            if let Some((_, unit)) = measure.si(Known::sample(true, true)) {
                si = si.may(name, or_null(number(format!("{name}, in SI"), unit)));
            }
        }
        let object = Object::new("The limit that is met on this side")
            .with("change", or_null(number("the datum at the limit less the datum now", &unit)))
            .with("cause", words("What is met there", causes))
            .with("helical_angle_deg", number("θ at the limit", "deg"))
            .with("force", or_null(number("the force at the limit", "B/r²")))
            .with("moment", or_null(number("the moment at the limit; none at the most turns", "B/r")))
            .may("si", si.open());
        let object = if change == Change::Turns {
            object.with("change_total", or_null(number("the change over the strand length", "turns")))
        } else {
            object
        };
        or_null(object.open())
    };
    let of = |change: Change| {
        let sides =
            Object::new("How far it can fall and rise").with("below", limit(change)).with("above", limit(change));
        (change.name().to_owned(), or_null(sides.open()))
    };
    Object::new("How far a datum can change, the rest held").all(Change::ALL.map(of)).open()
}

fn flexibility(meaning: &str) -> Value {
    or_null(tuple(meaning, 2, tuple("A row: ∂/∂f, ∂/∂m", 2, number("An entry", ""))))
}

fn touching() -> Value {
    let state = numbers(hand(Object::new("A state in equilibrium")), Of::Touching)
        .with("separated", flag("Whether touching neighbours would have to pull (p₁ < 0)"))
        .with(
            "stability",
            or_null(text("stable, unstable or marginal among uniform plies under dead loads, the given twist held")),
        )
        .with("stability_by_holding", holdings(false))
        .with("fold", flag("Whether two states meet here"))
        .with("helical_angle", number("θ", "rad"))
        .with("margins", margins())
        .with("flexibility", flexibility("[[∂d_f/∂f, ∂d_f/∂m], [∂d_m/∂f, ∂d_m/∂m]] times a, (60)"))
        .with("flexibility_as_published", flexibility("(63) as printed; radial balance only"));
    let top = scaled(titled(report("Every state in equilibrium")))
        .with("balance", balance())
        .with("stiffness_ratio", number("γ = C/B", ""))
        .may("external_pressure", number("p_e r³/B, if it was given", "B/r³"))
        .with("question", question())
        .with("straight_holds", or_null(flag("Whether straight strands are in equilibrium too")))
        .with("states", list("The states, right-handed first, then by angle", state.open()));
    noted(units(top)).open()
}

/// What `nply solve` says of every kind of strand.
pub(super) fn solve() -> Value {
    kinds([
        ("of touching strands", touching()),
        ("of strands on their supports", supported(false)),
        ("of strands that stretch", supported(true)),
    ])
}

/// `nply support`.
pub(super) fn support() -> Value {
    kinds([("of strands on their supports", supported(false)), ("of strands that stretch", supported(true))])
}

fn supported(stretched: bool) -> Value {
    let of = if stretched { Of::Stretched } else { Of::Supported };
    let state = numbers(hand(Object::new("A state in which all closed contacts push")), of)
        .with("support", carried())
        .with("stability", verdict("Stable or not under dead loads"))
        .with("stability_by_holding", holdings(stretched))
        .with("helical_angle", number("θ", "rad"));
    let wedge = numbers(
        hand(Object::new("The loads under which neighbours and core both carry, between two edges from a tip")),
        Of::Wedge,
    );
    let opening = numbers(hand(Object::new("Where a contact lets go, and opened strands close")), Of::Opening)
        .with("kept", words("Which load is as it was given", ["force", "moment"]))
        .with("lets_go", words("What lets go", [Support::Neighbours, Support::Core].map(Support::name)));
    let top = scaled(titled(report("What carries the strands")))
        .with("stiffness_ratio", number("γ = C/B", ""))
        .with("core_radius", or_null(number("radius of the core", "r")))
        .with("question", question())
        .with("straight_holds", or_null(flag("Whether straight strands are in equilibrium too")))
        .with("states", list("The states, right-handed first, then by angle", state.open()))
        .with("wedges", list("One a hand; none without a core that both can carry", wedge.open()))
        .with("openings", list("Where contacts let go, with one of the given loads kept", opening.open()));
    noted(units(top)).open()
}

/// `nply trace`.
pub(super) fn trace() -> Value {
    kinds([
        ("of strands that keep their length", traced(Of::Station)),
        ("of strands that stretch", traced(Of::StretchStation)),
    ])
}

fn traced(of: Of) -> Value {
    let marks = [
        Mark::Arrival,
        Mark::Fold,
        Mark::ContactChange(Support::Free),
        Mark::Separation,
        Mark::Diagonal,
        Mark::MostTurns,
        Mark::CurvatureLimit,
        Mark::StrainLimit,
        Mark::Straight,
        Mark::Buckling,
    ];
    let ends = [
        End::Arrival,
        End::LeftWindow,
        End::FlatRings,
        End::Apart,
        End::UnboundedLoad,
        End::Overstretched,
        End::Stalled,
    ];
    let station = numbers(hand(Object::new("A state on the way")), of)
        .with("along", number("Share of its leg, 0 at the beginning, 1 at the end", ""))
        .with("support", carried())
        .with("separated", flag("Whether neighbours would have to pull"))
        .with("stability", verdict("Stable or not, the ends held as on the leg"))
        .with("helical_angle", number("θ", "rad"))
        .open();
    let refer = || station.clone();
    let event = Object::new("What happens on the way")
        .with("event", words("What it is", marks.map(Mark::name)))
        .with("before_station", whole("The first station behind it, from 0", 0))
        .with("station", refer())
        .with("jump", or_null(list("Where stable states end: the stable ones the ply can jump to", refer())));
    let held = Holding::ALL.map(Holding::name).into_iter().chain(["both_held"]);
    let leg = Object::new("One leg of the path")
        .with("holding", words("What its ends hold", held))
        .with("end", words("Why it ends", ends.map(End::name)))
        .with("events", list("In the order of the walk", event.open()))
        .with("stations", list("The states, in the order of the walk", refer()));
    let top = titled(report("A ply followed along a path"))
        .with("balance", balance())
        .with("contacts", words("Whether neighbours push only, or are kept together", ["unilateral", "kept"]))
        .with("starts", list("The states with which the path can begin", refer()))
        .with("start", or_null(whole("Which of them is followed, from 1", 1)))
        .with("legs", list("What was walked", leg.open()));
    noted(units(top)).open()
}

/// `nply locus`.
pub(super) fn locus() -> Value {
    let loads =
        |object: Object| object.with("force", number("end force", "B/r²")).with("moment", number("end moment", "B/r"));
    let si = Object::new("The same in SI")
        .with("force", number("end force", "N"))
        .with("moment", number("end moment", "N m"));
    let names = ["straight", "diagonal", "rings", "force_turns", "moment_turns"];
    let point = loads(hand(Object::new("A point that has a name")))
        .with("name", words("Which it is", names))
        .with("helical_angle_deg", number("θ", "deg"))
        .may("si", si.open());
    let values = |meaning: &str, unit: &str| list(meaning, number("At a point", unit));
    let curve = hand(Object::new("The loads at which strands of one hand part"))
        .with("helical_angle_deg", values("θ, from 0 to 90°", "deg"))
        .with("force", values("The force at each", "B/r²"))
        .with("moment", values("The moment at each", "B/r"));
    let top = scaled(titled(report("The loads at which touching strands part")))
        .with("stiffness_ratio", number("γ = C/B", ""))
        .may("pretwist", number("φ̄a, if that was given", ""))
        .may("strand_twist", number("r u₃, if that was given", ""))
        .with("special_points", list("Points that have a name", point.open()))
        .with("curves", list("One a hand, right first", curve.open()));
    units(top).open()
}

/// `nply contact`.
pub(super) fn contact() -> Value {
    let branch = Object::new("A solution of the contact condition")
        .with("kind", words("Which", ["main", "trivial", "satellite"]))
        .with("arclength_shift", number("x, (6)", ""))
        .with("radius_ratio", number("ρ", ""))
        .with("local_minimum", flag("Whether the distance is least there"))
        .with("self_penetrating", flag("Whether the strands go through each other elsewhere"))
        .with("curvature", number("r κ", "1/r"))
        .with("keeps_curvature", flag("Whether strands so curved do not penetrate themselves"))
        .open();
    let of = |of: Of| {
        let top = report("How neighbouring strands touch")
            .with("strands", whole("n", 1))
            .may("strand_radius_m", number("r, where it is known", "m"))
            .may("packing_fraction", number("Share of a strand that is fibre, where a titre gave its size", ""));
        let top = units(numbers(top, of));
        if of == Of::Single {
            return top.open();
        }
        top.with("convex_cut", flag("Whether the cut of a strand across the ply is convex"))
            .may("branches", list("Nearest first, where they were asked for", branch.clone()))
            .open()
    };
    kinds([("of several strands", of(Of::Contact)), ("of one", of(Of::Single))])
}

/// `nply lays`.
pub(super) fn lays() -> Value {
    let mut top = report("The distinguished lays").with("strands", whole("n", 1));
    for (name, words, extreme) in listed::lays() {
        let mut lay = Object::new(words)
            .with("helical_angle_deg", number("θ", "deg"))
            .with("radius_ratio", number("ρ = R/r", ""));
        if let Some((name, words)) = extreme {
            lay = lay.with(name, number(words, ""));
        }
        top = top.may(name, or_null(lay.open()));
    }
    top.open()
}

/// `nply spin`.
pub(super) fn spin() -> Value {
    let names = ["balanced", "two_thirds", "given"];
    let ply = numbers(hand(Object::new("A ply of these singles")), Of::Plied)
        .with("name", words("Which", names))
        .with("balance", balance());
    let ratio = Object::new("The ratio at one angle").with("helical_angle_deg", number("θ", "deg")).with(
        "twist_ratio",
        or_null(number("Ply twist per ply length over singles twist; none beyond the steepest", "")),
    );
    let rules = Object::new("Ratios of the twists of balanced plies")
        .with("balance", balance())
        .with("two_thirds_angle_deg", number("The one angle at which two thirds balance", "deg"))
        .with("steepest_balanced_deg", number("The steepest angle at which a ply can be balanced", "deg"))
        .with("by_angle", list("The ratio, angle by angle", ratio.open()));
    let top = titled(report("Singles and the ply they make"))
        .with("stiffness_ratio", number("γ = C/B", ""))
        .may("strand_radius_m", number("r, where it is known", "m"))
        .with("plies", list("The plies, balance by balance", ply.open()))
        .with("twist_ratios", list("By balance", rules.open()));
    noted(units(top)).open()
}

/// `nply actuator`.
pub(super) fn actuator() -> Value {
    let most = |meaning: &str| {
        Object::new(meaning)
            .with("motor_turns", number("Turns of the motor", "turns"))
            .with("helical_angle_deg", number("θ there", "deg"))
            .open()
    };
    let mut step = Object::new("A step of the motor, in SI");
    for named in Of::Step.numbers() {
        let unit = named
            .measure
            .si(Known::sample(true, true))
            .map_or_else(|| unit(named.measure), |(_, unit)| unit.to_owned());
        step = step.may(named.name, or_null(number(named.label, &unit)));
    }
    let step = step.may("separated", flag("Whether stiff strings would have to pull on each other"));
    let top = hand(titled(report("Strings twisted by a motor")))
        .with("strand_radius_m", number("Radius of a string", "m"))
        .with("strand_length_m", number("Length of a string", "m"))
        .with("force_N", number("The pull of the load", "N"))
        .with("most_turns", most("The most turns that go in"))
        .with("constant_radius_most_turns", most("What the formula of a constant radius says of that"))
        .with("steps", list("From no turns on", step.open()));
    noted(units(top)).open()
}

fn sized(object: Object, all: &[Sized]) -> Object {
    all.iter().fold(object, |object, one| {
        let bare = one.name.as_str();
        let label =
            if one.label.is_empty() { meaning::of(bare, bare.replace('_', " ").as_str()) } else { one.label.clone() };
        let unit = one.unit.unwrap_or("unit of the input");
        let schema = or_null(number(label, unit));
        if one.measured_only || one.bare_only { object.may(bare, schema) } else { object.with(bare, schema) }
    })
}

/// `nply fit-check`.
pub(super) fn fit_check() -> Value {
    let layer = |object: Object| {
        let object = object
            .with("wires", whole("How many wires the layer has", 2))
            .with("contact", words("What they lie on", ["core", "neighbours", "both"]))
            .with("lay", or_null(words("The letter of the hand", ["Z", "S"])));
        sized(object, &listed::of_layer())
    };
    let one = layer(Object::new("A layer, as laid and as its wires lie"));
    let found = words("What was not given", ["core_diameter", "wire_diameter", "lay_length"]);
    let top = report("Whether wires fit beside each other")
        .may("title", text("The name given to it"))
        .with("length_unit", or_null(text("The unit that was written first; lengths without `_m` are in it")))
        .with("found", list("What was found, as it was not given", found))
        .with("layers", list("From the inside", one.open()));
    let mut top = noted(sized(top, &listed::of_strand())).open();
    // a single layer's numbers stand at the top as well
    if let (Value::Object(of_layer), Some(properties)) =
        (layer(Object::new("")).open(), top.get_mut("properties").and_then(Value::as_object_mut))
        && let Some(Value::Object(of_layer)) = of_layer.get("properties")
    {
        for (name, schema) in of_layer {
            properties.entry(name.clone()).or_insert_with(|| schema.clone());
        }
    }
    top
}

/// `nply stiffness`.
pub(super) fn stiffness() -> Value {
    let carried = [LayerSupport::Below, LayerSupport::Neighbours, LayerSupport::Both].map(LayerSupport::name);
    let member = Object::new("The core, or a layer")
        .with("lay", or_null(words("The letter of the hand", ["Z", "S"])))
        .with("wires", whole("How many wires; 1 of a core", 1))
        .with("support", or_null(words("What the wires lie on", carried)))
        .with("greatest_stress_at", or_null(words("Where a wire is pulled most", ["outer", "inner", "all"])));
    let member = sized(member, &listed::of_member()).open();
    let lays = list(
        "Lay lengths of the layer that have the torque factor that is wanted and at which its wires fit, longest first",
        number("A lay length", "m"),
    );
    let crowded = list(
        "Lay lengths that would have it, but at which wires do not fit beside each other on what is below, longest first",
        number("A lay length", "m"),
    );
    let twist = or_null(number("Twist per wire length at which the cable asks for no moment", "rad/m"));
    let top = report("What a strand or rope carries")
        .may("title", text("The name given to it"))
        .with("lifts_off", flag("Whether a contact would have to pull"))
        .with("core", or_null(member.clone()))
        .with("layers", list("From the inside", member))
        .may("lay_lengths_for_torque_factor", lays.clone())
        .may("lay_lengths_for_torque_factor_m", lays)
        .may("lay_lengths_that_do_not_fit", crowded.clone())
        .may("lay_lengths_that_do_not_fit_m", crowded)
        .may("pretwist_for_no_moment", twist.clone())
        .may("pretwist_for_no_moment_rad_per_m", twist);
    noted(sized(top, &listed::of_cable())).open()
}

fn curve(about: &str) -> Object {
    Object::new(about)
        .with("name", text("Its name"))
        .with("file", text("The file it stands in"))
        .with("points", whole("How many points it has", 2))
        .with("closed", flag("Whether it is closed"))
        .with("length", number("Its length", "unit of the coordinates"))
}

fn unit_of_curves(object: Object) -> Object {
    object.with("unit", or_null(text("The unit of the coordinates, where it is known")))
}

fn extension() -> Value {
    let object = Object::new("By how much either end of an open curve is prolonged")
        .with("length", number("By how much", "unit of the coordinates"))
        .with("along", words("Along what", ["tangents", "chord"]));
    or_null(object.open())
}

/// `nply writhe`.
pub(super) fn writhe() -> Value {
    let quantities = |mut object: Object| {
        for (name, label, is_whole) in listed::of_curves() {
            let meaning = meaning::of(name, if label.is_empty() { name } else { label }).replace('_', " ");
            let schema =
                if is_whole { json!({ "type": "integer", "description": meaning }) } else { number(meaning, "turns") };
            object = object.with(name, or_null(schema));
        }
        object
    };
    let one = quantities(curve("A curve, or the centreline of a ribbon"))
        .with(
            "crossings",
            or_null(tuple("How often it crosses itself, seen along two directions", 2, whole("Seen along one", 0))),
        )
        .with("discrepancy", or_null(number("By how much the values found along them differ", "turns")))
        .may("shares", list("What each segment has of the writhe", number("Of one segment", "turns")));
    let axis = or_null(tuple("The axis of the polar writhe", 3, number("A component", "")));
    let top = unit_of_curves(report("The writhe of curves, the twist of ribbons"))
        .with("method", words("How the writhe was found", ["crossings and twist", "tree"]))
        .with("extension", extension())
        .with("axis", axis)
        .with("curves", list("Each curve", one.open()));
    noted(quantities(top)).open()
}

/// `nply link`.
pub(super) fn link() -> Value {
    let square = |meaning: &str| list(meaning, list("A row", number("Of two curves", "")));
    let top = unit_of_curves(report("How curves are linked"))
        .with("method", words("How it was found", ["crossings"]))
        .with("extension", extension())
        .with(
            "linking_numbers",
            square("Whole numbers of closed curves, Gauss integrals where one is open; 0 of a curve with itself"),
        )
        .with("error_bounds", square("What can be wrong with each at most"))
        .with("curves", list("Each curve", curve("A curve").open()));
    noted(top).open()
}

/// `nply clearance`.
pub(super) fn clearance() -> Value {
    const UNIT: &str = "unit of the coordinates";
    let place = Object::new("Where two wires are near each other")
        .with("curves", tuple("Their names", 2, text("A name")))
        .with("curve_numbers", tuple("Their numbers, from 1", 2, whole("A number", 1)))
        .with(
            "segments",
            tuple("On which segment of either, from 0", 2, whole("Segment i runs from point i to the next", 0)),
        )
        .with("arclengths", tuple("How far along either", 2, number("Along the curve", UNIT)))
        .with("points", tuple("The two points", 2, tuple("A point", 3, number("A coordinate", UNIT))))
        .with("distance", number("Of the two points", UNIT))
        .with("gap", or_null(number("The distance less half of either diameter; negative: the wires overlap", UNIT)))
        .open();
    let length = |meaning: &str| or_null(number(meaning, UNIT));
    let count = |meaning: &str| or_null(whole(meaning, 0));
    let own = Object::new("The same of each wire with itself, farther along it than half a turn of its sharpest bend")
        .with("least_distance", length("The least distance"))
        .with("clearance", length("The least gap"))
        .with("overlapping_curves", count("How many overlap with themselves"))
        .with("overlapping_curves_beyond_chords", count("Of these by more than chords explain"))
        .with("where", or_null(place.clone()))
        .with("overlaps", list("Each overlap", place.clone()));
    let wire = curve("A wire")
        .with("diameter", length("Its diameter"))
        .with(
            "chord_sagitta",
            number("Height of the arc through three of its points above the longer chord, at most", UNIT),
        )
        .with(
            "least_bend_radius",
            length("Radius of the sharpest circle through three points; none of a straight wire"),
        );
    let top = unit_of_curves(report("How near wires come to each other"))
        .with("curves", list("Each wire", wire.open()))
        .with("least_distance", length("Of two different wires"))
        .with("clearance", length("The least gap of two different wires"))
        .with("overlapping_pairs", count("How many pairs overlap"))
        .with("overlapping_pairs_beyond_chords", count("Of these by more than chords explain"))
        .with("where", or_null(place.clone()))
        .with("nearest", or_null(place.clone()))
        .with("overlaps", list("Each pair that overlaps", place))
        .with("itself", own.open());
    noted(top).open()
}

/// `nply nodes`.
pub(super) fn nodes() -> Value {
    kinds([
        ("of a ply", of_all_elements(layer_of_elements(report("Start geometry of straight elements"))).open()),
        (
            "of a strand of layers",
            noted(of_all_elements(report("Start geometry of straight elements, layer by layer")))
                .with(
                    "elements_per_shortest_lay_length",
                    whole("How many elements the layer with the shortest lay length has to one", 2),
                )
                .with("layers", list("From the inside", layer_of_elements(Object::new("A layer")).open()))
                .open(),
        ),
    ])
}

/// What holds for every wire.
fn of_all_elements(object: Object) -> Object {
    object
        .with("stagger", or_null(number("By how many elements each wire stands farther along; none: any", "")))
        .with("element_type", words("Beams of two nodes or of three", Element::ALL.map(Element::name)))
        .with("clear", flag("Whether the elements are as far apart as is wanted"))
}

/// A layer of straight elements.
fn layer_of_elements(object: Object) -> Object {
    let lengths = [
        ("helix_radius", "helix radius", true),
        ("laid_helix_radius", "helix radius of the wires of a layer as they are laid", false),
        ("lay_length", "lay length", true),
        ("wanted_distance", "distance that is wanted: diameter and coatings", true),
        ("smooth_distance", "least distance of the helices", true),
        ("element_distance", "least distance of the straight elements", true),
        ("geometric_gap", "gap of the helices", true),
        ("chord_share", "of this lost to chords", true),
        ("gap", "gap of the elements", true),
        ("core_radius", "radius of the core, or of the layers below over their wires", false),
        ("core_geometric_gap", "gap of the helices to what is below", false),
        ("core_chord_share", "of this lost to chords", false),
        ("core_gap", "gap of the elements to what is below, wherever their nodes stand", false),
        ("least_helix_radius", "least helix radius that clears", false),
        ("any_stagger_helix_radius", "least helix radius, nodes at any stagger", true),
    ];
    let mut layer = object
        .with("strands", whole("n", 2))
        .with("handedness", json!({ "enum": [1, -1], "description": "1 right-handed (Z), −1 left-handed (S)" }))
        .with("elements_per_lay_length", number("How many straight elements a lay length has", ""))
        .with("helical_angle_deg", number("θ", "deg"));
    let mut si = Object::new("The same in m, where r is known");
    for (name, meaning, always) in lengths {
        let schema = number(meaning, "r");
        layer = if always { layer.with(name, schema) } else { layer.may(name, schema) };
        si = si.may(name, number(meaning, "m"));
    }
    layer.may("si", si.open())
}

/// `nply fit`.
pub(super) fn fit() -> Value {
    const UNIT: &str = "the unit beside it";
    let estimate = Object::new("A number that was estimated")
        .with("name", text("Which"))
        .with("unit", text("Its unit"))
        .with("value", or_null(number("The estimate; none: not determined", UNIT)))
        .with("standard_error", or_null(number("Its standard error; none: not determined", UNIT)))
        .with("start", number("Where the search began", UNIT))
        .with("known_to", or_null(number("The standard error to which the start was known", UNIT)));
    let compared = Object::new("A measured number beside that of the ply")
        .with("name", text("Its column"))
        .with("measured", number("As measured", UNIT))
        .with("fitted", number("Of the ply", UNIT))
        .with("residual", number("Measured less fitted", UNIT))
        .with("error", or_null(number("Its standard error", UNIT)))
        .with("standardised", or_null(number("The residual over the error", "")));
    let row = Object::new("A row of the data")
        .with("line", whole("The line of the file", 1))
        .with("handedness", json!({ "enum": [1, -1], "description": "1 right-handed (Z), −1 left-handed (S)" }))
        .with("helical_angle_deg", number("θ of the state nearest to what was measured", "deg"))
        .with("force", number("f", ""))
        .with("moment", number("m", ""))
        .with("interstrand_pressure", number("p₁ r³/B", "B/r³"))
        .with("separated", flag("Whether neighbours would have to pull"))
        .with("states", whole("How many states are in equilibrium", 0))
        .with("next_state_chi_squared", or_null(number("The sum of squares of the next nearest state", "")))
        .with("compared", list("Number by number", compared.open()));
    let names = |meaning: &str| list(meaning, text("A column"));
    let top = titled(report("Numbers of the strands, from measurements"))
        .with("balance", balance())
        .with("held", names("Columns taken as they are"))
        .with(
            "taken_as_zero",
            names("Loads in no column and not in the description, but for the moment where turns are held"),
        )
        .with("measured", names("Columns with errors"))
        .with("estimates", list("What was estimated", estimate.open()))
        .with(
            "correlation",
            or_null(list("Correlations of the estimates", list("A row", or_null(number("Of two estimates", ""))))),
        )
        .with("chi_squared", or_null(number("The sum of squares over the errors; none without errors", "")))
        .with("degrees_of_freedom", whole("Measured numbers less estimates", 0))
        .with("probability", or_null(number("The chance of a greater sum, to about 0.01", "")))
        .with("errors_given", flag("Whether the data gave errors"))
        .with(
            "units",
            json!({ "type": "object", "additionalProperties": { "type": "string" }, "description": "By column" }),
        )
        .with("rows", list("Row by row", row.open()));
    noted(top).open()
}

/// `nply preset`.
pub(super) fn preset() -> Value {
    let one = Object::new("A document that comes with the program")
        .with("name", text("Its name"))
        .with("about", text("What it is"))
        .with("source", text("Where its numbers come from"))
        .with("command", text("The command that reads it"));
    report("Published plies and strands").with("presets", list("All of them", one.open())).open()
}
