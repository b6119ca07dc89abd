//! What can be wrong with a premise, said with its evidence.

use core::fmt;

/// A quantity lies outside the range in which the theory speaks of it.
///
/// "No equilibrium" is never an error (it is an empty list), nor is a contact that would have to pull (it is a negative
/// pressure). Only a broken premise is.
///
/// ```
/// use nply::geometry::Contact;
/// let error = Contact::new(3, f64::NAN).unwrap_err();
/// assert_eq!(error.quantity, "helical_angle");
/// assert!(error.to_string().contains("at least 0 and less than pi/2"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DomainError {
    /// The quantity by its public name, such as `helical_angle`.
    pub quantity: &'static str,
    /// The value that was given (dimensionless; angles in rad).
    pub value: f64,
    /// What would have been accepted, as the end of "`quantity` must be …".
    pub allowed: &'static str,
}

impl fmt::Display for DomainError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} = {} is outside the theory: it must be {}", self.quantity, self.value, self.allowed)
    }
}

impl std::error::Error for DomainError {}

impl DomainError {
    /// Accepts `value` when `holds`; a comparison with NaN is false, so NaN is refused without being named.
    #[inline]
    pub(crate) fn check(holds: bool, quantity: &'static str, value: f64, allowed: &'static str) -> Result<(), Self> {
        if holds { Ok(()) } else { Err(Self { quantity, value, allowed }) }
    }
}
