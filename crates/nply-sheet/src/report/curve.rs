//! What reports on curves have in common.

use nply::topology::{Along, Curve, CurveError};
use serde_json::{Map, Value, json};

use crate::curves::{Closing, CurveSet, Member};
use crate::quoted;

/// By how much open curves are prolonged at both ends, and along what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extension {
    /// The length added at either end, in the curves' unit; above 0.
    pub length: f64,
    /// Along what.
    pub along: Along,
}

/// The theory's curves of a set, prolonged where that is wanted.
///
/// # Errors
/// A sentence with the curve's name and what is wrong with it.
pub(super) fn theory(set: &CurveSet, extension: Option<Extension>) -> Result<Vec<Curve>, String> {
    let curve = |(i, member): (usize, &Member)| {
        let made =
            if member.closed { Curve::closed(member.points.clone()) } else { Curve::open(member.points.clone()) };
        let made = match extension {
            None => made,
            Some(_) if member.closed => {
                let name = quoted(&member.name);
                return Err(format!(
                    "{}: curve {name} is closed and has no ends to prolong; with --open it is taken as open",
                    member.file
                ));
            }
            Some(Extension { length, along }) => {
                let curve = made.map_err(|error| refusal(set, None, &error, [i, i]))?;
                return curve.extended(length, along).map_err(|_| {
                    format!(
                        "{}: curve {} cannot be prolonged by {length:e}: that must be more than 1e-40 of its size, and lead nowhere beyond 1e300",
                        member.file,
                        quoted(&member.name)
                    )
                });
            }
        };
        made.map_err(|error| refusal(set, extension, &error, [i, i]))
    };
    set.members.iter().enumerate().map(curve).collect()
}

/// What is wrong with one or two curves, by their names.
pub(super) fn refusal(set: &CurveSet, extension: Option<Extension>, error: &CurveError, curves: [usize; 2]) -> String {
    let [one, other] = curves.map(|i| &set.members[i]);
    let names = if curves[0] == curves[1] {
        format!("curve {}", quoted(&one.name))
    } else {
        format!("curves {} and {}", quoted(&one.name), quoted(&other.name))
    };
    let line = match one.line {
        Some(line) if curves[0] == curves[1] => format!(" (from line {line})"),
        _ => String::new(),
    };
    let counted = matches!(error, CurveError::Touch { .. } | CurveError::Level { .. }) && extension.is_some();
    let first = if counted { "; the first prolongation is segment 0" } else { "" };
    format!("{}: {names}{line}: {error}{first}", one.file)
}

/// Which curves were taken as closed, in a sentence.
pub(super) fn closing_note(set: &CurveSet) -> String {
    let closed = set.members.iter().filter(|member| member.closed).count();
    let all = set.members.len();
    let which = match (closed, all) {
        (1, 1) => "The curve is taken as closed".to_owned(),
        (0, 1) => "The curve is taken as open".to_owned(),
        (0, _) => "All curves are taken as open".to_owned(),
        _ if closed == all => "All curves are taken as closed".to_owned(),
        _ => format!("{closed} of {all} curves are taken as closed"),
    };
    let why = match (set.closing, closed == 0) {
        (Closing::AsWritten, false) => ": the last point repeats the first",
        (Closing::AsWritten, true) => ": no last point repeats the first (--closed joins them)",
        (Closing::Closed, _) => ", as --closed says",
        (Closing::Open, _) => ", as --open says",
    };
    format!("{which}{why}.")
}

/// What was done to the ends, for programs.
pub(super) fn extension_json(extension: Option<Extension>) -> Value {
    extension.map_or(Value::Null, |Extension { length, along }| json!({ "length": length, "along": along_name(along) }))
}

/// What was done to the ends, for a reader.
pub(super) fn extension_note(extension: Option<Extension>, unit: Option<&str>) -> Option<String> {
    extension.map(|Extension { length, along }| {
        let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
        let along = match along {
            Along::Tangents => "along its end segments",
            Along::Chord => "along the line through its ends",
        };
        format!("Either end of a curve is prolonged by {}{unit} {along}.", crate::preferred::six_digits(length))
    })
}

fn along_name(along: Along) -> &'static str {
    match along {
        Along::Tangents => "tangents",
        Along::Chord => "chord",
    }
}

/// "closed" or "open".
pub(super) const fn closed(member: &Member) -> &'static str {
    if member.closed { "closed" } else { "open" }
}

/// What a curve is, before anything is said of it.
pub(super) fn described(member: &Member) -> Map<String, Value> {
    let mut curve = Map::new();
    curve.insert("name".into(), json!(member.name));
    curve.insert("file".into(), json!(member.file));
    curve.insert("points".into(), json!(member.points.len()));
    curve.insert("closed".into(), json!(member.closed));
    curve.insert("length".into(), json!(member.length()));
    curve
}

/// Rows as CSV.
pub(super) fn csv(rows: &[Vec<String>]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // a text in memory takes them all
        let _ = writer.write_record(row);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}
