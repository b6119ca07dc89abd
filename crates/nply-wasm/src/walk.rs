//! From one set of data to another, along the branch that the ply is on.

use nply::DomainError;
use nply::mechanics::{Contacts, Data, End, Ends, Event, Load, Mark, Path, Route, Station, Support};
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::refusal;
use crate::strands::{balance, twist};

/// The most jumps of one walk.
const MOST_JUMPS: usize = 8;

/// Follows a state as its data change, and jumps where it ends, to the stable state nearest in angle, as `nply trace` says it might.
///
/// `holding` is `dead_loads`, `rotation_held` or `length_held`; `from` and `to` hold five numbers each: γ, the twist (of `twist_kind`), the two data of
/// the ends (force and moment; force and rotation; moment and extension), the core's radius (NaN without one). `start` is the angle of the state
/// in degrees, negative of a left-handed one. `kept`: neighbours stay together whatever it takes; else contacts only push. `step` is the
/// longest step, in rad.
///
/// JSON: `stations` (six numbers each, in one list: hand, θ in degrees, R/r, force, moment, p₁), `events` (`event`, `angle` signed in degrees, `force`,
/// `moment`, `jump`: null, or the signed angle it jumps to, or `"none"`), `arrived`, and `end` in a word; null where there is no such state.
#[wasm_bindgen]
#[must_use]
#[expect(clippy::too_many_arguments, reason = "plain numbers come over the border one by one")]
pub fn walk(
    strands: u32,
    balance_name: &str,
    kept: bool,
    holding: &str,
    twist_kind: &str,
    from: &[f64],
    to: &[f64],
    start: f64,
    step: f64,
) -> String {
    let contacts = if kept { Contacts::Kept(balance(balance_name)) } else { Contacts::Unilateral };
    let (Some(from), Some(to)) = (data(holding, twist_kind, from), data(holding, twist_kind, to)) else {
        return Value::Null.to_string();
    };
    match walked(strands, contacts, from, to, start, step) {
        Ok(walk) => walk.to_string(),
        Err(error) => refusal::of_numbers(&error),
    }
}

fn data(holding: &str, twist_kind: &str, numbers: &[f64]) -> Option<Data> {
    let &[stiffness_ratio, value, first, second, core] = numbers else { return None };
    let ends = match holding {
        "rotation_held" => Ends::Rotation { rotation: second, force: first },
        "length_held" => Ends::Length { extension: second, moment: first },
        _ => Ends::Loads(Load { force: first, moment: second }),
    };
    let core_radius = (core > 0.0).then_some(core);
    Some(Data { stiffness_ratio, twist: twist(twist_kind, value), ends, core_radius })
}

fn walked(strands: u32, contacts: Contacts, from: Data, to: Data, start: f64, step: f64) -> Result<Value, DomainError> {
    let route = Route { step, ..Route::default() };
    let mut here = from;
    let mut path = Path::new(strands, here, to, contacts)?;
    let mut at = nearest(&path.starts()?, start);
    let (mut stations, mut events) = (Vec::new(), Vec::new());
    let mut end = None;
    for _ in 0..MOST_JUMPS {
        let Some(station) = at else { break };
        let trace = path.trace(&station, &route)?;
        let ended = trace.events.iter().find(|event| event.jump.is_some());
        let walked = ended.map_or(trace.stations.len(), |event| event.before);
        stations.extend(trace.stations.iter().take(walked).flat_map(numbers));
        // what happens behind the place where stable states end is not seen by a ply that jumps
        let seen = trace.events.iter().take_while(|event| ended.is_none_or(|ended| !core::ptr::eq(*event, ended)));
        events.extend(seen.filter(|event| event.mark != Mark::Arrival).map(told));
        end = Some(trace.end);
        let Some(event) = ended else { break };
        stations.extend(numbers(&event.station));
        events.push(told(event));
        let next = event.jump.as_ref().and_then(|jump| jump.first()).copied();
        let Some(next) = next else {
            return Ok(told_walk(stations, events, "no_state"));
        };
        stations.extend(numbers(&next));
        here = path.data(event.station.along);
        path = Path::new(strands, here, to, contacts)?;
        at = nearest(&path.starts()?, signed(&next));
    }
    let _ = here;
    Ok(match end {
        None => Value::Null,
        Some(end) => told_walk(stations, events, end.name()),
    })
}

fn told_walk(stations: Vec<f64>, events: Vec<Value>, end: &str) -> Value {
    json!({ "stations": stations, "events": events, "arrived": end == End::Arrival.name(), "end": end })
}

fn signed(station: &Station) -> f64 {
    station.handedness.sign() * station.angle.degrees()
}

fn nearest(stations: &[Station], to: f64) -> Option<Station> {
    let off = |station: &Station| (signed(station) - to).abs();
    stations.iter().min_by(|a, b| off(a).total_cmp(&off(b))).copied()
}

fn numbers(station: &Station) -> [f64; 6] {
    [
        station.handedness.sign(),
        station.angle.degrees(),
        station.radius_ratio,
        station.load.force,
        station.load.moment,
        station.interstrand_pressure,
    ]
}

fn told(event: &Event) -> Value {
    let carried = match event.mark {
        Mark::ContactChange(support) => Some(match support {
            Support::Neighbours => "neighbours",
            Support::Core => "core",
            Support::Both => "both",
            Support::Free => "none",
        }),
        _ => None,
    };
    let jump = event.jump.as_ref().map(|jump| jump.first().map_or(json!("none"), |to| json!(signed(to))));
    json!({
        "event": event.mark.name(),
        "carried_by": carried,
        "angle": signed(&event.station),
        "force": event.station.load.force,
        "moment": event.station.load.moment,
        "twist": event.station.pretwist(),
        "jump": jump,
    })
}
