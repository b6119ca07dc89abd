//! S and Z, written behind a twist or before it.

use nply::Handedness;

use crate::Quantity;

/// A text without its S or Z, and the hand that letter says: `470 turns/m Z`, `Z 470`, `S470 tpm`.
pub(crate) fn split(text: &str) -> (&str, Option<Handedness>) {
    let text = text.trim();
    let letter = |c: char| match c {
        'Z' => Some(Handedness::Right),
        'S' => Some(Handedness::Left),
        _ => None,
    };
    // a letter that is part of a unit's name says nothing
    let apart =
        |c: Option<char>| c.is_some_and(|c| c.is_whitespace() || c.is_ascii_digit() || "+-\u{2212}.".contains(c));
    let mut behind = text.chars();
    if let Some(hand) = behind.next_back().and_then(letter)
        && apart(behind.as_str().chars().next_back())
    {
        return (behind.as_str().trim_end(), Some(hand));
    }
    let mut before = text.chars();
    if let Some(hand) = before.next().and_then(letter)
        && apart(before.as_str().chars().next())
    {
        return (before.as_str().trim_start(), Some(hand));
    }
    (text, None)
}

/// The quantity with the sign of the hand: right-handed, Z, is positive.
///
/// A sign that was written as well must say the same.
pub(crate) fn signed(quantity: Quantity, written: &str, hand: Option<Handedness>) -> Result<Quantity, String> {
    let Some(hand) = hand else { return Ok(quantity) };
    let sign = match written.trim_start().chars().next() {
        Some('+') => Some(Handedness::Right),
        Some('-' | '\u{2212}') => Some(Handedness::Left),
        _ => None,
    };
    if sign.is_some_and(|sign| sign != hand) {
        let (letter, other) = match hand {
            Handedness::Right => ("Z (right-handed, positive)", "minus"),
            Handedness::Left => ("S (left-handed, negative)", "plus"),
        };
        return Err(format!(
            "the letter {letter} and the {other} sign of {} say opposite hands: leave one of them out",
            crate::quoted(written)
        ));
    }
    let turned = |value: f64| {
        if hand == Handedness::Left && value > 0.0 { -value } else { value }
    };
    Ok(match quantity {
        Quantity::Bare(value) => Quantity::Bare(turned(value)),
        Quantity::Measured { si, unit } => Quantity::Measured { si: turned(si), unit },
    })
}
