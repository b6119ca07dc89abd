//! What is said by another quantity: energies in kT, forces in cN/tex.

use super::{Entry, Spec, Value};
use crate::{Dimension, Quantity};

impl Entry {
    /// The number and its dimension, if the datum is said by another quantity.
    pub(crate) fn relative(&self) -> Option<(f64, Dimension)> {
        match &self.value {
            Value::Quantity(Quantity::Measured { si, unit }) if self.key.kind.is_relative(unit.dimension()) => {
                Some((*si, unit.dimension()))
            }
            _ => None,
        }
    }
}

impl Spec {
    /// Whether any datum is said in kT.
    pub(crate) fn is_thermal(&self) -> bool {
        self.entries.iter().filter_map(Entry::relative).any(|(_, dimension)| dimension != Dimension::SPECIFIC_STRESS)
    }
}
