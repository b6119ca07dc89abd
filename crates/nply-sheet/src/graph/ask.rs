//! What runs and what is asked, as it was written.

use super::refused;
use crate::key::nearest;
use crate::report::Column;
use crate::spec::Spec;
use crate::{COLUMNS, ErrorKind, KEYS, Key, SpecError, Table, quoted};

/// `table.key=from..to`, as the corners of a study.
pub(super) fn range(text: &str) -> Result<[Spec; 2], SpecError> {
    let wrong = || {
        let message =
            format!("{} is no range: write what runs, from where to where, such as `pretwist=-3..3`", quoted(text));
        refused(ErrorKind::Syntax, "sweep", &message)
    };
    let (name, ends) = text.split_once('=').ok_or_else(wrong)?;
    let (from, to) = ends.split_once("..").ok_or_else(wrong)?;
    let (from, to) = (from.trim(), to.trim().trim_start_matches('='));
    let key = key(name.trim())?;
    // a unit stands for both ends
    let from = match (from.parse::<f64>(), unit(to)) {
        (Ok(_), Some(unit)) => format!("{from} {unit}"),
        _ => from.to_owned(),
    };
    let corner = |value: &str| Spec::from_prefixed_flags("sweep ", [(key.flag, value)]);
    Ok([corner(&from)?, corner(to)?])
}

/// What follows the number.
fn unit(text: &str) -> Option<&str> {
    let number = |end: usize| text.get(..end).is_some_and(|head| head.trim().parse::<f64>().is_ok());
    let end = (1..=text.len()).rev().find(|&end| number(end))?;
    let unit = text[end..].trim();
    (!unit.is_empty()).then_some(unit)
}

/// The key of a name: `table.name`, a flag, or a name that only one key has.
fn key(name: &str) -> Result<&'static Key, SpecError> {
    let runs = |key: &&Key| key.may_change() || key.table == Table::Lay;
    let full = |key: &Key| format!("{}.{}", key.table.name(), key.name);
    let flag = name.trim_start_matches("--").replace('_', "-");
    let found = KEYS.iter().find(|key| full(key) == name).or_else(|| KEYS.iter().find(|key| key.flag == flag));
    match found {
        Some(key) if runs(&key) => Ok(key),
        Some(key) => {
            let message = format!(
                "{} does not run: only loads, twist, ends, the lay and the stiffness ratio do; several numbers of strands, hands or \
                 balances have flags of their own",
                full(key)
            );
            Err(refused(ErrorKind::Contradiction, "sweep", &message))
        }
        None => {
            let known: Vec<String> = KEYS.iter().filter(runs).map(full).collect();
            let flags = KEYS.iter().filter(runs).map(|key| key.flag);
            let near = nearest(name, known.iter().map(String::as_str).chain(flags));
            let help = near.map(|name| format!("did you mean `{name}`?"));
            let message = format!("{} is no key that can run", quoted(name));
            Err(refused(ErrorKind::UnknownKey, "sweep", &message).with_help(help))
        }
    }
}

/// The column of a name, which may leave its unit out.
pub(super) fn column(name: &str, flag: &str) -> Result<&'static Column, SpecError> {
    let written = name.trim().replace('-', "_");
    let bare = |column: &'static Column| column.name.trim_end_matches("_deg").trim_end_matches("_percent");
    let found = COLUMNS.iter().find(|column| column.name == written);
    if let Some(column) = found.or_else(|| COLUMNS.iter().find(|column| bare(column) == written)) {
        return Ok(column);
    }
    let near = nearest(&written, COLUMNS.iter().map(bare));
    let help = near.map_or_else(
        || "the names are those of `nply solve --format csv`".to_owned(),
        |name| format!("did you mean `{name}`?"),
    );
    let message = format!("{} is nothing that is known of a state", quoted(name));
    Err(refused(ErrorKind::UnknownKey, flag, &message).with_help(Some(help)))
}

/// A column's name for a reader.
pub(super) fn label(column: &Column) -> String {
    let words = || column.name.trim_end_matches("_deg").replace('_', " ");
    // what stands in brackets explains, and there is little room
    let short = column.label.split(" (").next().unwrap_or_default();
    if short.is_empty() { words() } else { short.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_stands_for_both_ends() {
        assert_eq!(unit("2 kN"), Some("kN"));
        assert_eq!(unit("1e3 pN nm"), Some("pN nm"));
        assert_eq!((unit("2"), unit("-1e-3"), unit("")), (None, None, None));
        let [from, to] = range("load.force = 0..2 kN").unwrap();
        assert_ne!(from, to);
        for wrong in ["", "pretwist", "pretwist=3", "strands=2..3", "=1..2", "pretwst=0..1", "pretwist=a..b"] {
            assert!(range(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_column_is_found_with_and_without_its_unit() {
        assert_eq!(column("helical_angle", "ask").unwrap().name, "helical_angle_deg");
        assert_eq!(column("interstrand-pressure", "ask").unwrap().name, "interstrand_pressure");
        assert!(column("interstrand_presure", "ask").unwrap_err().to_string().contains("interstrand_pressure"));
    }
}
