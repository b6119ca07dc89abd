//! Any text as a quantity: a finite number, or one sentence.
#![no_main]

use libfuzzer_sys::fuzz_target;
use nply_sheet::{Quantity, Unit};

fuzz_target!(|text: &str| {
    match Quantity::parse(text) {
        Ok(quantity) => {
            assert!(quantity.si().is_finite());
            let _ = quantity.dimension().to_string();
            if let Quantity::Measured { si, unit } = quantity {
                let _ = unit.of_si(si);
                assert_eq!(Unit::parse(&unit.to_string()).map(|again| again.dimension()), Ok(unit.dimension()));
            }
        }
        Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    }
});
