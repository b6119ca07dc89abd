//! One number in a sentence: `nply solve … --json | states[0].helical_angle_deg | 2`.

use serde_json::Value;

use crate::command::{Bench, Runner};

/// The number as it stands in the sentence.
pub(crate) fn expand(wish: &str, bench: &mut Bench, runner: &Runner) -> Result<String, String> {
    let usage = "wanted is COMMAND | path in its JSON | digits";
    let (rest, digits) = wish.rsplit_once(" | ").ok_or(usage)?;
    let (command, path) = rest.rsplit_once(" | ").ok_or(usage)?;
    let (path, factor) = match path.split_once(" * ") {
        Some((path, factor)) => (path, factor.trim().parse().map_err(|_| format!("`{factor}` is no number"))?),
        None => (path, 1.0),
    };
    let said = runner.run(&bench.place(command))?;
    if said.code != Some(0) {
        return Err(format!("`{command}` ended with {:?}\n{}", said.code, said.error.trim_end()));
    }
    let json: Value =
        serde_json::from_str(&said.output).map_err(|error| format!("`{command}` gives no JSON: {error}"))?;
    let found = find(&json, path.trim()).map_err(|why| format!("`{command}`: {why}"))?;
    match (found, digits.trim()) {
        (Value::String(text), _) => Ok(text.clone()),
        (Value::Bool(said), _) => Ok(said.to_string()),
        (Value::Number(number), digits) => {
            let value = number.as_f64().ok_or_else(|| format!("{number} is no number"))? * factor;
            written(value, digits)
        }
        (other, _) => Err(format!("`{command}`: {path} is {other}, no number")),
    }
}

/// The value at a path such as `states[0].helical_angle_deg`.
fn find<'a>(json: &'a Value, path: &str) -> Result<&'a Value, String> {
    let mut at = json;
    for part in path.split('.') {
        let (name, indices) = part.split_once('[').map_or((part, ""), |(name, rest)| (name, rest));
        if !name.is_empty() {
            at = at.get(name).ok_or_else(|| format!("there is no `{name}` of `{path}` in it, {}", has(at)))?;
        }
        for index in indices.split('[').filter(|index| !index.is_empty()) {
            let number: usize =
                index.trim_end_matches(']').parse().map_err(|_| format!("`[{index}` of `{path}` is no index"))?;
            at = at.get(number).ok_or_else(|| format!("there is no [{number}] of `{path}` in it, {}", has(at)))?;
        }
    }
    Ok(at)
}

fn has(value: &Value) -> String {
    match value {
        Value::Object(map) => format!("only {}", map.keys().map(String::as_str).collect::<Vec<_>>().join(", ")),
        Value::Array(list) => format!("only {} of them", list.len()),
        other => format!("only {other}"),
    }
}

/// A number with `2` digits after the point, or `3s` significant ones; its minus is a minus.
fn written(value: f64, digits: &str) -> Result<String, String> {
    let wrong = || format!("`{digits}`: wanted are digits after the point, or such as 3s");
    let text = match digits.strip_suffix('s') {
        Some(count) => significant(value, count.parse().ok().filter(|&count| count > 0).ok_or_else(wrong)?),
        None => format!("{value:.*}", digits.parse::<usize>().map_err(|_| wrong())?),
    };
    // no minus before nothing
    let text = if text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.')) { text.replace('-', "") } else { text };
    Ok(text.replace('-', "−"))
}

fn significant(value: f64, count: usize) -> String {
    let rounded = format!("{value:.*e}", count - 1);
    let Some((mantissa, exponent)) = rounded.split_once('e') else { return rounded };
    let Ok(power) = exponent.parse::<i32>() else { return rounded };
    if (-4..6).contains(&power) {
        let Ok(value) = rounded.parse::<f64>() else { return rounded };
        let after = usize::try_from(i64::try_from(count).unwrap_or(0) - 1 - i64::from(power)).unwrap_or(0);
        return format!("{value:.after$}");
    }
    let raised: String = exponent.chars().map(raised).collect();
    format!("{mantissa} × 10{raised}")
}

fn raised(digit: char) -> char {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    digit.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_for_a_reader() {
        assert_eq!(written(-1.005, "1").unwrap(), "−1.0");
        assert_eq!(written(-0.001, "2").unwrap(), "0.00");
        assert_eq!(written(20.5812, "3s").unwrap(), "20.6");
        assert_eq!(written(9.996, "3s").unwrap(), "10.0");
        assert_eq!(written(123_456.0, "3s").unwrap(), "123000");
        assert_eq!(written(0.000_012_34, "3s").unwrap(), "1.23 × 10⁻⁵");
        assert_eq!(written(-2.5e7, "2s").unwrap(), "−2.5 × 10⁷");
        assert!(written(1.0, "two").is_err());
    }

    #[test]
    fn a_path_leads_to_its_value_or_says_what_is_there() {
        let json: Value = serde_json::from_str(r#"{"states": [{"a": 1, "b": [[5]]}]}"#).unwrap();
        assert_eq!(find(&json, "states[0].b[0][0]").unwrap(), 5);
        assert_eq!(find(&json, "states[0].c").unwrap_err(), "there is no `c` of `states[0].c` in it, only a, b");
        assert_eq!(find(&json, "states[3]").unwrap_err(), "there is no [3] of `states[3]` in it, only 1 of them");
    }
}
