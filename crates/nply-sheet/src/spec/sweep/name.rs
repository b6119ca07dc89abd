//! What a name in `[sweep]` or at the head of a column stands for: a key, and the unit behind it.

use super::refused;
use crate::key::nearest;
use crate::{ErrorKind, KEYS, Key, Kind, SpecError, Unit, quoted};

/// The key of a name: `table.name`, a flag, or a name that only one key has.
pub(crate) fn key(name: &str, flag: &str) -> Result<&'static Key, SpecError> {
    if let Some(key) = find_key(name) {
        return Ok(key);
    }
    let full: Vec<String> = KEYS.iter().map(|key| format!("{}.{}", key.table.name(), key.name)).collect();
    let near = nearest(name, full.iter().map(String::as_str).chain(KEYS.iter().map(|key| key.flag)));
    let help = near.map(|name| format!("did you mean `{name}`?"));
    Err(refused(ErrorKind::UnknownKey, flag, format!("{} is no datum of a ply", quoted(name))).with_help(help))
}

/// The same, if there is one.
pub(crate) fn find_key(name: &str) -> Option<&'static Key> {
    let flag = name.trim_start_matches("--").replace('_', "-");
    let full = |key: &&'static Key| {
        name.split_once('.').is_some_and(|(table, rest)| table == key.table.name() && rest == key.name)
    };
    let prefixed = |key: &&'static Key| key.column_name() == name;
    let only = || {
        let mut named = KEYS.iter().filter(|key| key.name == name);
        named.next().filter(|_| named.next().is_none())
    };
    let found = KEYS.iter().find(full).or_else(|| KEYS.iter().find(|key| key.flag == flag));
    found.or_else(|| KEYS.iter().find(prefixed)).or_else(only)
}

/// The unit that a name has behind a key's: `lay_length_mm`, `force_kN`, `turns_per_length_turns_per_m`.
pub(crate) fn unit_behind(key: &Key, suffix: &str) -> Option<Unit> {
    let unit = unit_of(suffix)?;
    let fits = key.kind.dimension() == Some(unit.dimension()) || key.kind.is_relative(unit.dimension());
    (fits && key.kind != Kind::Count && key.kind != Kind::Number).then_some(unit)
}

/// The unit that a suffix stands for.
pub(crate) fn unit_of(suffix: &str) -> Option<Unit> {
    let spaced = suffix.replace("_per_", "/").replace('_', " ");
    let spaced = spaced.strip_prefix("per ").map_or(spaced.clone(), |rest| format!("1/{rest}"));
    // N m2 stands for N m^2
    let mut written = String::new();
    let mut before = ' ';
    for c in spaced.chars() {
        if c.is_ascii_digit() && before.is_alphabetic() {
            written.push('^');
        }
        written.push(c);
        before = c;
    }
    Unit::parse(&written).ok()
}
