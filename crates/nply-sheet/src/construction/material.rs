//! Densities by name.

/// A material whose density a standard states.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// As it is written: `galvanised steel`.
    pub name: &'static str,
    /// kg/m³.
    pub density: f64,
    /// Who says so.
    pub source: &'static str,
}

const fn material(name: &'static str, density: f64, source: &'static str) -> Material {
    Material { name, density, source }
}

/// The materials that are known by name.
///
/// ```
/// use nply_sheet::construction::MATERIALS;
/// assert!(MATERIALS.iter().any(|material| material.name == "copper" && material.density == 8890.0));
/// ```
pub static MATERIALS: [Material; 4] = [
    material("steel", 7850.0, "EN 1992-1-1, 3.2.7"),
    material("galvanised steel", 7780.0, "IEC 60888"),
    material("aluminium", 2703.0, "IEC 60889"),
    material("copper", 8890.0, "IEC 60028"),
];

/// The material that is meant, however it is spelled.
pub(super) fn named(written: &str) -> Option<&'static Material> {
    let plain = written.trim().to_lowercase().replace(['-', '_'], " ").replace("galvanized", "galvanised");
    let plain = if plain == "aluminum" { "aluminium" } else { &plain };
    MATERIALS.iter().find(|material| material.name == plain)
}
