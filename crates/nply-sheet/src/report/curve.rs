//! What reports on curves have in common.

use serde_json::{Map, Value, json};

use crate::curves::Member;

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
