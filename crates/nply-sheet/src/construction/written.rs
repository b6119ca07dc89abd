//! A layered strand as it was written: the same from a file as from flags.

use core::ops::Range;
use std::sync::Arc;

use nply::DomainError;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::CONSTRUCTION_KEYS;
use crate::key::{Group, nearest};
use crate::spec::Entry;
use crate::spec::file::{in_order, parse, read_toml, ticked, utf8};
use crate::spec::read_text;
use crate::{Datum, ErrorKind, Key, Place, SpecError, Table};

/// A description of one layered strand, each datum with its place; understood word by word, but not yet as a whole.
///
/// A file has `[construction]` (a title), `[core]` and a `[[layer]]` for each layer, from the inside. Flags of a layer are
/// repeated once for each; one that is given once holds for all.
///
/// ```
/// use nply_sheet::construction::ConstructionSpec;
/// let flags = [
///     ("core-diameter", "3.34 mm"), ("strands", "6"), ("strands", "12"), ("wire-diameter", "3.34 mm"),
///     ("lay-ratio", "21"), ("lay-ratio", "13"), ("hand", "right"), ("hand", "left"),
/// ];
/// let strand = ConstructionSpec::from_flags(flags)?.check()?;
/// assert_eq!((strand.layers[1].wires, strand.layers[1].wire_diameter), (12, 3.34e-3));
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ConstructionSpec {
    /// `[construction]` and `[core]`.
    pub(super) head: Vec<Entry>,
    /// `[[layer]]`, from the inside.
    pub(super) layers: Vec<Part>,
    /// `[core.strand]`: what the core is made of, where it is a strand itself.
    pub(super) core_strand: Option<Box<Self>>,
    /// The beginning of the file; `None` where all came from flags.
    pub(super) start: Option<Place>,
}

/// One `[[layer]]`, and where it begins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    pub(super) entries: Vec<Entry>,
    /// `[layer.strand]`: what each of its rods is made of, where it is a strand itself.
    pub(super) strand: Option<Box<ConstructionSpec>>,
    place: Place,
}

/// The table of a strand within.
const STRAND: &str = "strand";

/// Wires in strands in ropes in cables: no deeper.
pub(crate) const DEEPEST: usize = 3;

/// A strand of more layers than this is no strand.
pub(crate) const MOST_LAYERS: usize = 100;

impl ConstructionSpec {
    /// Reads a file's text. `file_name` is used in messages only.
    ///
    /// # Errors
    /// [`SpecError`] with line and column: no TOML, an unknown key or table, a value of the wrong sort or unit, NaN or infinity.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// let error = ConstructionSpec::from_toml("strand.toml", "[[layer]]\nwire = 6\n").unwrap_err();
    /// assert_eq!(error.to_string(), "strand.toml:2:1: `wire` is no key of [[layer]]; did you mean `wires`?");
    /// ```
    pub fn from_toml(file_name: &str, text: &str) -> Result<Self, SpecError> {
        let name: Arc<str> = Arc::from(file_name);
        let place = |bytes: Range<usize>| Place::in_file(&name, text, bytes);
        let document = parse(text, &place)?;
        // what is about the whole is said at its first table, below any comment
        let first = in_order(document.get_ref()).into_iter().next().map_or(0..0, |(header, _)| header.span());
        Self::read(document.get_ref(), text, &place, place(first), 0)
    }

    /// The tables of a strand, of the file or of a strand within.
    fn read(
        tables: &DeTable<'_>,
        text: &str,
        place: &impl Fn(Range<usize>) -> Place,
        start: Place,
        depth: usize,
    ) -> Result<Self, SpecError> {
        let mut spec = Self { head: Vec::new(), layers: Vec::new(), core_strand: None, start: Some(start) };
        for (header, value) in in_order(tables) {
            let here = place(header.span());
            match (&**header.get_ref(), value.get_ref()) {
                ("construction", DeValue::Table(_)) => {
                    spec.head.extend(entries(Table::Construction, value, text, place)?);
                }
                ("load", DeValue::Table(_)) if depth == 0 => {
                    spec.head.extend(entries(Table::Load, value, text, place)?)
                }
                ("core", DeValue::Table(content)) => {
                    spec.head.extend(entries(Table::Core, value, text, place)?);
                    spec.core_strand = Self::within(content, text, place, depth)?;
                }
                ("layer", DeValue::Array(layers)) if layers.len() <= MOST_LAYERS => {
                    for layer in layers.iter() {
                        let DeValue::Table(content) = layer.get_ref() else {
                            return Err(no_layer(place(layer.span())));
                        };
                        let entries = entries(Table::Layer, layer, text, place)?;
                        let strand = Self::within(content, text, place, depth)?;
                        spec.layers.push(Part { entries, strand, place: place(layer.span()) });
                    }
                }
                ("layer", DeValue::Array(_)) => {
                    let message = format!("a strand of more than {MOST_LAYERS} layers is not taken");
                    return Err(SpecError::new(ErrorKind::Domain, here, message).of_key("layer"));
                }
                ("layer", _) => return Err(no_layer(here)),
                (written @ ("construction" | "core" | "load"), _) if depth == 0 || written != "load" => {
                    let message = format!(
                        "`{written}` is a table of its own: write `[{written}]` once, and its keys on the lines below"
                    );
                    return Err(SpecError::new(ErrorKind::WrongType, here, message).of_key(written));
                }
                (written, _) => return Err(unknown_table(written, here)),
            }
        }
        Ok(spec)
    }

    /// The strand that a core, or each rod of a layer, is made of.
    fn within(
        content: &DeTable<'_>,
        text: &str,
        place: &impl Fn(Range<usize>) -> Place,
        depth: usize,
    ) -> Result<Option<Box<Self>>, SpecError> {
        let Some((header, value)) = in_order(content).into_iter().find(|(header, _)| header.get_ref() == STRAND) else {
            return Ok(None);
        };
        let here = place(header.span());
        let refused = |message: String| Err(SpecError::new(ErrorKind::WrongType, here.clone(), message).of_key(STRAND));
        match value.get_ref() {
            DeValue::Table(_) if depth >= DEEPEST => {
                refused(format!("strands of strands are taken no deeper than {DEEPEST} times"))
            }
            DeValue::Table(tables) => Self::read(tables, text, place, here, depth + 1).map(|spec| Some(Box::new(spec))),
            _ => refused(
                "`strand` is a strand within: write its `core` and its `[[layer.strand.layer]]` below".to_owned(),
            ),
        }
    }

    /// As [`from_toml`](Self::from_toml), from bytes that may not be text at all.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml); and a syntax error at the first byte that is not UTF-8.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// assert!(ConstructionSpec::from_bytes("strand.toml", b"[core]\n\xff").is_err());
    /// ```
    pub fn from_bytes(file_name: &str, bytes: &[u8]) -> Result<Self, SpecError> {
        Self::from_toml(file_name, utf8(file_name, bytes)?)
    }

    /// Reads flags with their values, named as in [`CONSTRUCTION_KEYS`].
    ///
    /// # Errors
    /// [`SpecError`] naming the flag: unknown, given too often, or with a value of the wrong sort or unit.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// let error = ConstructionSpec::from_flags([("wire-diametr", "2 mm")]).unwrap_err();
    /// assert_eq!(error.to_string(), "--wire-diametr: this flag is not known; did you mean `--wire-diameter`?");
    /// ```
    pub fn from_flags<'f>(flags: impl IntoIterator<Item = (&'f str, &'f str)>) -> Result<Self, SpecError> {
        let mut head: Vec<Entry> = Vec::new();
        let mut of_layers: Vec<Vec<Entry>> = Vec::new();
        for (flag, value) in flags {
            let flag = flag.strip_prefix("--").unwrap_or(flag);
            let place = Place::Flag(flag.to_owned());
            let Some(key) = CONSTRUCTION_KEYS.iter().find(|key| key.flag == flag) else {
                let help = nearest(flag, CONSTRUCTION_KEYS.iter().map(|key| key.flag))
                    .map(|name| format!("did you mean `--{name}`?"));
                return Err(SpecError::new(ErrorKind::UnknownKey, place, "this flag is not known")
                    .of_key(flag)
                    .with_help(help));
            };
            let entry = Entry { key, value: read_text(key, value, &place)?, place, written: crate::quoted(value) };
            if key.table != Table::Layer {
                if head.iter().any(|other| other.key.datum == key.datum) {
                    return Err(entry.error(ErrorKind::Contradiction, "this flag is given twice; give it once"));
                }
                head.push(entry);
            } else if let Some(same) =
                of_layers.iter_mut().find(|same| same.first().is_some_and(|first| first.key.datum == key.datum))
            {
                same.push(entry);
            } else {
                of_layers.push(vec![entry]);
            }
        }
        let count = of_layers.iter().map(Vec::len).max().unwrap_or(0).min(MOST_LAYERS);
        let mut layers = Vec::new();
        for at in 0..count {
            let mut entries = Vec::new();
            for same in &of_layers {
                match same.as_slice() {
                    [once] => entries.push(once.clone()),
                    all if all.len() == count => entries.extend(all.get(at).cloned()),
                    all => {
                        let Some(entry) = all.last() else { continue };
                        let message = format!(
                            "this flag is given {} times where there are {count} layers: give it once for each, from the inside, or once for all",
                            all.len()
                        );
                        return Err(entry.error(ErrorKind::Contradiction, message));
                    }
                }
            }
            layers.push(Part { entries, strand: None, place: Place::Flag("strands".to_owned()) });
        }
        Ok(Self { head, layers, core_strand: None, start: None })
    }

    /// This description with `flags` laid over it, layer by layer; flags of one layer replace what every layer of a file says.
    ///
    /// # Errors
    /// [`SpecError`] where flags are given for another number of layers than the file has, and more than one.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// let text = "core.diameter = 2\n[[layer]]\nwires = 6\nwire_diameter = 2\nlay_length = 60\n";
    /// let flags = ConstructionSpec::from_flags([("lay-ratio", "9")])?;
    /// let strand = ConstructionSpec::from_toml("strand.toml", text)?.overridden_by(&flags)?.check()?;
    /// assert_eq!(strand.layers[0].lay, nply::geometry::WireLay::Ratio(9.0));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn overridden_by(&self, flags: &Self) -> Result<Self, SpecError> {
        let mut merged = self.clone();
        lay_over(&mut merged.head, &flags.head);
        match (merged.layers.len(), flags.layers.as_slice()) {
            (_, []) => {}
            (0, layers) => merged.layers = layers.to_vec(),
            (_, [every]) => merged.layers.iter_mut().for_each(|layer| lay_over(&mut layer.entries, &every.entries)),
            (own, layers) if own == layers.len() => {
                merged.layers.iter_mut().zip(layers).for_each(|(own, over)| lay_over(&mut own.entries, &over.entries));
            }
            (own, layers) => {
                let message = format!(
                    "flags are given for {} layers where the file has {own}: give them once for each, or once for all",
                    layers.len()
                );
                let place = layers.first().and_then(|part| part.entries.first()).map(|entry| entry.place.clone());
                let place = place.unwrap_or_else(|| Place::Flag("strands".to_owned()));
                return Err(SpecError::new(ErrorKind::Contradiction, place, message));
            }
        }
        Ok(merged)
    }

    /// A datum of `[construction]` or `[core]`.
    pub(super) fn head(&self, datum: Datum) -> Option<&Entry> {
        self.head.iter().find(|entry| entry.key.datum == datum)
    }

    /// Every datum, the sizes of wires first: what is written of them sets the units of the answer.
    pub(super) fn all(&self) -> impl Iterator<Item = &Entry> {
        let of_layers = || self.layers.iter().flat_map(|part| &part.entries);
        let is_size = |entry: &&Entry| entry.key.datum == Datum::LayerWireDiameter;
        let rest = of_layers().filter(move |entry| !is_size(entry));
        let own = of_layers().filter(is_size).chain(&self.head).chain(rest);
        let within: Vec<&Entry> =
            self.within_it().flat_map(|spec| Box::new(spec.all()) as Box<dyn Iterator<Item = &Entry>>).collect();
        own.chain(within)
    }

    /// The strands within.
    fn within_it(&self) -> impl Iterator<Item = &Self> {
        self.core_strand
            .iter()
            .chain(self.layers.iter().filter_map(|part| part.strand.as_ref()))
            .map(|strand| &**strand)
    }

    /// How to ask for a datum: `diameter` in [core], or `--core-diameter` where all is flags.
    pub(super) fn ask_for(&self, datum: Datum) -> String {
        let Some(key) = Key::of(datum) else { return String::new() };
        match (&self.start, key.table) {
            (Some(_), Table::Layer) => format!("`{}` in [[layer]]", key.name),
            (Some(_), table) => format!("`{}` in [{}]", key.name, table.name()),
            (None, _) => format!("`--{}`", key.flag),
        }
    }

    /// What is missing, at the layer or beside the keys of the table it is missing in, else at the head of the input.
    pub(crate) fn missing(&self, layer: Option<usize>, datum: Datum, message: impl Into<String>) -> SpecError {
        let key = Key::of(datum);
        let (name, flag) = key.map_or(("", ""), |key| (key.name, key.flag));
        let beside = || {
            self.head
                .iter()
                .find(|entry| key.is_some_and(|key| key.table == entry.key.table))
                .map(|entry| entry.place.clone())
        };
        let part = layer.and_then(|layer| self.layers.get(layer)).map(|part| part.place.clone()).or_else(beside);
        let in_file = part.filter(|place| matches!(place, Place::File { .. })).or_else(|| self.start.clone());
        let place = in_file.unwrap_or_else(|| Place::Flag(flag.to_owned()));
        SpecError::new(ErrorKind::Missing, place, message).of_key(name)
    }

    /// That a command has no use for a layered strand, said at the head of its description.
    #[must_use]
    pub fn not_taken(&self, message: &str) -> SpecError {
        let place = self.start.clone().unwrap_or_else(|| Place::Flag("strands".to_owned()));
        SpecError::new(ErrorKind::Contradiction, place, message)
    }

    /// See [`Construction::locate`](super::Construction::locate).
    pub(crate) fn locate(&self, layer: usize, error: &DomainError) -> SpecError {
        let DomainError { quantity, value, allowed } = *error;
        let entries = self.layers.get(layer).map_or(&[][..], |part| &part.entries);
        let named = |datum| entries.iter().chain(&self.head).find(|entry| entry.key.datum == datum);
        let lay = entries.iter().find(|entry| entry.key.group == Some(Group::LayerLay));
        let origin = match quantity {
            "wires" | "strands" => named(Datum::LayerWires),
            "wire_radius" => named(Datum::LayerWireDiameter).or_else(|| named(Datum::StrandOuterDiameter)),
            "core_radius" => self.head.iter().find(|entry| entry.key.group == Some(Group::CoreSize)),
            "outer_radius" => named(Datum::StrandOuterDiameter),
            "gap" => named(Datum::LayerGap),
            _ => lay,
        };
        let which = if self.layers.len() > 1 { format!(" of layer {}", layer + 1) } else { String::new() };
        let size = if value.is_finite() && (value == 0.0 || (1e-4..1e7).contains(&value.abs())) {
            format!("{value}")
        } else {
            format!("{value:e}")
        };
        match origin.or(lay).or_else(|| named(Datum::LayerWires)) {
            Some(entry) => {
                let message = format!(
                    "{} is {quantity} = {size}{which}, and no wires can be laid so: it must be {allowed}",
                    entry.said()
                );
                entry.error(ErrorKind::Domain, message)
            }
            None => {
                let place = self.start.clone().unwrap_or_else(|| Place::Flag("strands".to_owned()));
                let message = format!("no wires can be laid so: {quantity} = {size}{which} must be {allowed}");
                SpecError::new(ErrorKind::Domain, place, message)
            }
        }
    }
}

/// Entries that replace the same data, and those of which only one can be given.
fn lay_over(own: &mut Vec<Entry>, over: &[Entry]) {
    own.retain(|entry| {
        !over.iter().any(|flag| {
            flag.key.datum == entry.key.datum || (flag.key.group.is_some() && flag.key.group == entry.key.group)
        })
    });
    own.extend(over.iter().cloned());
}

/// The keys of one table.
fn entries(
    table: Table,
    value: &Spanned<DeValue<'_>>,
    text: &str,
    place: &impl Fn(Range<usize>) -> Place,
) -> Result<Vec<Entry>, SpecError> {
    let DeValue::Table(content) = value.get_ref() else { return Ok(Vec::new()) };
    let mut found = Vec::new();
    for (key, value) in in_order(content) {
        let written: &str = key.get_ref();
        if written == STRAND && matches!(table, Table::Core | Table::Layer) {
            continue; // read as a strand of its own
        }
        let Some(known) = CONSTRUCTION_KEYS.iter().find(|known| known.table == table && known.name == written) else {
            return Err(unknown_key(table, written, place(key.span())));
        };
        found.push(read_toml(known, value, text, place(value.span()))?);
    }
    Ok(found)
}

fn header(table: Table) -> String {
    if table == Table::Layer { "[[layer]]".to_owned() } else { format!("[{}]", table.name()) }
}

fn unknown_key(table: Table, written: &str, place: Place) -> SpecError {
    let of_table = || CONSTRUCTION_KEYS.iter().filter(move |key| key.table == table).map(|key| key.name);
    let elsewhere = CONSTRUCTION_KEYS.iter().find(|key| key.name == written);
    let help = match elsewhere {
        Some(key) => format!("it belongs below {}", header(key.table)),
        None => match nearest(written, of_table()) {
            Some(name) => format!("did you mean `{name}`?"),
            None => {
                let within = matches!(table, Table::Core | Table::Layer).then_some(STRAND);
                let keys: Vec<&str> = of_table().chain(within).collect();
                format!("its keys are {}", keys.join(", "))
            }
        },
    };
    let message = format!("{} is no key of {}", ticked(written), header(table));
    SpecError::new(ErrorKind::UnknownKey, place, message).of_key(written).with_help(Some(help))
}

fn unknown_table(written: &str, place: Place) -> SpecError {
    let help = match CONSTRUCTION_KEYS.iter().find(|key| key.name == written) {
        Some(key) => Some(format!("it belongs below {}", header(key.table))),
        None if Table::ALL.iter().any(|table| table.name() == written) => {
            Some("a ply of strands alone is described to `nply solve` and `nply contact`".to_owned())
        }
        None => nearest(written, ["construction", "core", "layer", "load"].into_iter()).map(|name| match name {
            "layer" => "did you mean `[[layer]]`?".to_owned(),
            _ => format!("did you mean `[{name}]`?"),
        }),
    };
    let message = format!(
        "{} is no table of a layered strand: the tables are [construction], [core], [load] and one [[layer]] for each layer",
        ticked(written)
    );
    SpecError::new(ErrorKind::UnknownKey, place, message).of_key(written).with_help(help)
}

fn no_layer(place: Place) -> SpecError {
    let message =
        "a strand has layers: write `[[layer]]` once for each, from the inside, and below it such as `wires = 6`";
    SpecError::new(ErrorKind::WrongType, place, message).of_key("layer")
}
