//! Plies and strands that others have published, as documents with their sources: data, not code.

/// A document that comes with the program: TOML, with what it is, where it is from and the command that reads it in its first lines.
///
/// ```
/// use nply_sheet::{PRESETS, Preset, Spec};
/// let preset = Preset::named("collagen").expect("it is listed");
/// assert!(preset.source().contains("s41598-017-12398-0") && preset.command() == "contact");
/// assert!(Spec::from_toml(preset.name, preset.text)?.check_shape().is_ok());
/// assert!(PRESETS.len() > 10);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// What to ask for it by.
    pub name: &'static str,
    /// The document.
    pub text: &'static str,
}

macro_rules! presets {
    ($($name:literal),* $(,)?) => {
        /// Every preset, trade by trade.
        pub static PRESETS: &[Preset] =
            &[$(Preset { name: $name, text: include_str!(concat!("../presets/", $name, ".toml")) }),*];
    };
}

presets![
    "prestressing-strand-9.53",
    "prestressing-strand-12.70",
    "prestressing-strand-15.24",
    "prestressing-strand-3-wire",
    "strand-utting-jones",
    "conductor-cardinal",
    "rope-6x7",
    "zero-twist-rope",
    "three-ply-yarn",
    "tyre-cord-840d-2",
    "tyre-cord-1260d-2",
    "tyre-cord-1680d-2",
    "rubber-rods",
    "twisted-string-actuator",
    "coiled-coil-2",
    "coiled-coil-3",
    "coiled-coil-4",
    "coiled-coil-5",
    "coiled-coil-6",
    "coiled-coil-7",
    "collagen",
    "dna-plectoneme",
    "dna-braid",
];

impl Preset {
    /// By its name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        PRESETS.iter().find(|preset| preset.name == name).copied()
    }

    /// The comment lines at its head, without their marks.
    fn comment(&self) -> impl Iterator<Item = &'static str> {
        self.text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim)
    }

    /// What it is, in a sentence.
    #[must_use]
    pub fn about(&self) -> &'static str {
        self.comment().next().unwrap_or("")
    }

    /// Where its numbers are from.
    #[must_use]
    pub fn source(&self) -> String {
        let lines = self.comment().skip_while(|line| !line.starts_with("Source: ")).take_while(|line| !line.is_empty());
        let whole = lines.collect::<Vec<_>>().join(" ");
        whole.strip_prefix("Source: ").unwrap_or("").to_owned()
    }

    /// The command of `nply` that reads it: `solve`, `contact`, `fit-check`, `actuator`.
    #[must_use]
    pub fn command(&self) -> &'static str {
        let line = self.comment().find_map(|line| line.strip_prefix("Command: nply "));
        line.and_then(|line| line.split_whitespace().next()).unwrap_or("")
    }
}

/// All, a line each, as text or as JSON.
///
/// ```
/// assert!(nply_sheet::list_presets(false).contains("nply preset collagen | nply contact -"));
/// let json: serde_json::Value = serde_json::from_str(&nply_sheet::list_presets(true))?;
/// assert_eq!(json["presets"][0]["command"], "fit-check");
/// # Ok::<(), serde_json::Error>(())
/// ```
#[must_use]
pub fn list_presets(json: bool) -> String {
    if json {
        let one = |preset: &Preset| {
            serde_json::json!({
                "name": preset.name,
                "about": preset.about(),
                "source": preset.source(),
                "command": preset.command(),
            })
        };
        let mut top = crate::report::header();
        top.insert("presets".into(), PRESETS.iter().map(one).collect());
        return format!("{:#}\n", serde_json::Value::Object(top));
    }
    let call = |preset: &Preset| format!("nply preset {} | nply {} -", preset.name, preset.command());
    let width = PRESETS.iter().map(|preset| call(preset).len()).max().unwrap_or(0);
    PRESETS.iter().map(|preset| format!("{:width$}  {}\n", call(preset), preset.about())).collect()
}
