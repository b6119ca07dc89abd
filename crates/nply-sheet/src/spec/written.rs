//! A document's data as they stand in it, for a reader who changes some and writes it again.

use std::sync::Arc;

use toml::de::DeValue;

use super::Spec;
use super::file::{in_order, parse};
use crate::{KEYS, Key, Place, SpecError};

impl Spec {
    /// Every datum of a document in its order: the key, and what is written, without quotation marks. Written again as TOML, or as flags,
    /// they are the same description. What changes, `[[path]]`, `[map]` and `[sweep]`, is not among them; see [`Spec::is_study`].
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::from_toml`].
    ///
    /// ```
    /// let written = nply_sheet::Spec::written("ply.toml", "ply.strands = 0x3\nstrand.diameter = \"0.5 mm\"\n")?;
    /// let written: Vec<_> = written.iter().map(|(key, text)| (key.flag, text.as_str())).collect();
    /// assert_eq!(written, [("strands", "3"), ("diameter", "0.5 mm")]);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn written(file_name: &str, text: &str) -> Result<Vec<(&'static Key, String)>, SpecError> {
        Self::from_toml(file_name, text)?;
        let name: Arc<str> = Arc::from(file_name);
        let document = parse(text, &|bytes| Place::in_file(&name, text, bytes))?;
        let mut data = Vec::new();
        for (table, content) in in_order(document.get_ref()) {
            let DeValue::Table(content) = content.get_ref() else { continue };
            let table: &str = table.get_ref();
            for (key, value) in in_order(content) {
                let name: &str = key.get_ref();
                // all are known: the document was read
                let Some(key) = KEYS.iter().find(|key| key.table.name() == table && key.name == name) else { continue };
                let written = match value.get_ref() {
                    DeValue::String(content) => content.clone().into_owned(),
                    DeValue::Integer(whole) if whole.radix() != 10 => {
                        i64::from_str_radix(whole.as_str(), whole.radix()).unwrap_or_default().to_string()
                    }
                    DeValue::Integer(whole) => whole.as_str().to_owned(),
                    DeValue::Float(number) => number.as_str().to_owned(),
                    _ => text.get(value.span()).unwrap_or("").to_owned(),
                };
                data.push((key, written));
            }
        }
        Ok(data)
    }
}
