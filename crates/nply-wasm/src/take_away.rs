//! What is taken away: reports and shapes.

use nply_sheet::mesh::{Assembly, FileUnit, Fineness, Subject, Surface, SurfaceFormat, Wanted};
use nply_sheet::{Report, Spec, SpecError};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::refusal;

/// The report of a document: `text` as `nply solve` prints it, `csv` or `json`. JSON with `text`.
#[wasm_bindgen]
#[must_use]
pub fn report(name: &str, text: &str, format: &str) -> String {
    let made =
        Spec::from_toml(name, text).and_then(|spec| spec.check()).and_then(Report::of).map(|report| match format {
            "csv" => report.csv(),
            "json" => report.json(),
            _ => report.text(false),
        });
    match made {
        Ok(text) => serde_json::json!({ "text": text }).to_string(),
        Err(error) => refusal::of_document(&error, text),
    }
}

/// The ply of a document in a state (from 1) as a file for printing or drawing: `stl` or `glb`, `lay_lengths` of it, with the stripes. Empty where
/// there is none; [`report`] says why.
#[wasm_bindgen]
#[must_use]
pub fn mesh(name: &str, text: &str, state: usize, format: &str, lay_lengths: f64, stripes: u32) -> Vec<u8> {
    let format = if format == "glb" { SurfaceFormat::Glb } else { SurfaceFormat::Stl };
    let made = || -> Result<Vec<u8>, SpecError> {
        let ply = Subject::of(&Spec::from_toml(name, text)?, Some(state).filter(|state| *state > 0))?;
        let core = ply.core_radius.map(|_| "");
        let wanted = Wanted { lay_lengths: Some(lay_lengths), stripes, core, ..Wanted::default() };
        let assembly = Assembly::of(&ply, &wanted)?;
        let surface = Surface::of(&ply, &assembly, Fineness::default())?;
        Ok(format.write(&surface, &FileUnit::of(&ply, None, None)?))
    };
    made().unwrap_or_default()
}
