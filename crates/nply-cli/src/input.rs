//! A ply from a file, from flags, or from both.

use std::fs::File;
use std::io::{self, Read as _};
use std::iter;
use std::path::Path;

use clap::ArgMatches;
use clap::parser::ValueSource;
use nply_sheet::construction::{CONSTRUCTION_KEYS, ConstructionSpec, is_layered};
use nply_sheet::{ErrorKind, KEYS, Place, Spec, SpecError};

use crate::failure::Failure;
use crate::output::shown;

/// What was written, and the text of the file for messages.
pub(crate) struct Input<S = Spec> {
    pub(crate) spec: S,
    pub(crate) text: String,
}

/// A ply is some lines; what is larger than this (1 MiB) is some other file.
const LARGEST: u64 = 1 << 20;

impl<S> Input<S> {
    pub(crate) fn refused(&self, error: SpecError) -> Failure {
        Failure::Refused(error, self.text.clone())
    }
}

/// The description of a shape: of a ply, or of a layered strand.
pub(crate) enum Described {
    Ply(Spec),
    Layered(ConstructionSpec),
}

/// Reads the file, if one is named, and lays the flags over it.
pub(crate) fn read(arguments: &ArgMatches) -> Result<Input, Failure> {
    let flags = flags(arguments);
    let Some(path) = arguments.get_one::<String>("file") else {
        return over(None, &flags);
    };
    let (name, bytes) = contents(path)?;
    over(Some((name, &bytes)), &flags)
}

/// As [`read`], or a layered strand, if the file describes one; flags of a ply have no place there.
pub(crate) fn read_described(arguments: &ArgMatches) -> Result<Input<Described>, Failure> {
    let flags = flags(arguments);
    let file = arguments.get_one::<String>("file").map(|path| contents(path)).transpose()?;
    if let Some((name, bytes)) = &file {
        let text = String::from_utf8_lossy(bytes).into_owned();
        if is_layered(&text) {
            if let Some((flag, _)) = flags.first() {
                let message = format!(
                    "it says something of a ply of one layer, and {name} describes a layered strand: change it there"
                );
                let error = SpecError::new(ErrorKind::Contradiction, Place::Flag((*flag).to_owned()), message);
                return Err(Failure::Refused(error, text));
            }
            return match ConstructionSpec::from_bytes(name, bytes) {
                Ok(spec) => Ok(Input { spec: Described::Layered(spec), text }),
                Err(error) => Err(Failure::Refused(error, text)),
            };
        }
    }
    let Input { spec, text } = over(file.as_ref().map(|(name, bytes)| (*name, bytes.as_slice())), &flags)?;
    Ok(Input { spec: Described::Ply(spec), text })
}

/// The flags of a ply that were given.
fn flags(arguments: &ArgMatches) -> Vec<(&'static str, &str)> {
    KEYS.iter()
        .flat_map(|key| iter::once(key.flag).chain(key.other_flag()))
        .filter(|flag| matches!(arguments.try_contains_id(flag), Ok(true)))
        .filter(|flag| arguments.value_source(flag) == Some(ValueSource::CommandLine))
        .filter_map(|flag| Some((flag, arguments.get_one::<String>(flag)?.as_str())))
        .collect()
}

/// Flags laid over a file.
fn over(file: Option<(&str, &[u8])>, flags: &[(&str, &str)]) -> Result<Input, Failure> {
    let flags = Spec::from_flags(flags.iter().copied()).map_err(|error| Failure::Refused(error, String::new()))?;
    let Some((name, bytes)) = file else {
        return Ok(Input { spec: flags, text: String::new() });
    };
    let text = String::from_utf8_lossy(bytes).into_owned();
    match Spec::from_bytes(name, bytes) {
        Ok(spec) => Ok(Input { spec: spec.overridden_by(&flags), text }),
        Err(error) => Err(Failure::Refused(error, text)),
    }
}

/// As [`read`], of a layered strand.
pub(crate) fn read_construction(arguments: &ArgMatches) -> Result<Input<ConstructionSpec>, Failure> {
    let flags = CONSTRUCTION_KEYS.iter().flat_map(|key| {
        let given = arguments.try_get_many::<String>(key.flag).ok().flatten().into_iter().flatten();
        given.map(|value| (key.flag, value.as_str()))
    });
    let flags = ConstructionSpec::from_flags(flags).map_err(|error| Failure::Refused(error, String::new()))?;
    let Some(path) = arguments.get_one::<String>("file") else {
        return Ok(Input { spec: flags, text: String::new() });
    };
    let (name, bytes) = contents(path)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    match ConstructionSpec::from_bytes(name, &bytes).and_then(|spec| spec.overridden_by(&flags)) {
        Ok(spec) => Ok(Input { spec, text }),
        Err(error) => Err(Failure::Refused(error, text)),
    }
}

/// What a file says of a ply.
#[cfg(feature = "explore")]
#[derive(Default)]
pub(crate) struct Written {
    /// datum by datum: the flag and what is written
    pub(crate) data: Vec<(&'static str, String)>,
    /// whether it also says what changes
    pub(crate) is_study: bool,
}

/// Reads a file as it is written.
#[cfg(feature = "explore")]
pub(crate) fn read_written(path: &str) -> Result<Written, Failure> {
    let (name, bytes) = contents(path)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let spec = Spec::from_bytes(name, &bytes).and_then(|spec| Ok((Spec::written(name, &text)?, spec.is_study())));
    let (written, is_study) = spec.map_err(|error| Failure::Refused(error, text))?;
    Ok(Written { data: written.into_iter().map(|(key, text)| (key.flag, text)).collect(), is_study })
}

/// A file's name for messages, and what is in it.
fn contents(path: &str) -> Result<(&str, Vec<u8>), Failure> {
    let (name, bytes) =
        if path == "-" { ("standard input", load(io::stdin())) } else { (path, File::open(path).and_then(load)) };
    Ok((name, bytes.map_err(|error| Failure::File { what: format!("cannot read {}", shown(Path::new(name))), error })?))
}

/// The same of a file that may be larger, and what is said of one that is larger still.
pub(crate) fn contents_of<'p>(path: &'p str, largest: u64, larger: &str) -> Result<(&'p str, Vec<u8>), Failure> {
    let load = |file| load_up_to(file, largest, larger);
    let (name, bytes) = if path == "-" {
        ("standard input", load(Box::new(io::stdin()) as Box<dyn io::Read>))
    } else {
        (path, File::open(path).and_then(|file| load(Box::new(file))))
    };
    Ok((name, bytes.map_err(|error| Failure::File { what: format!("cannot read {}", shown(Path::new(name))), error })?))
}

/// What changes at a corner of a study, by flags with a prefix, in the order in which they were given; `None` without any.
pub(crate) fn corner(arguments: &ArgMatches, prefix: &str) -> Result<Option<Spec>, Failure> {
    let mut flags: Vec<(usize, &str, &str)> = KEYS
        .iter()
        .filter(|key| key.may_change())
        .filter_map(|key| {
            let name = format!("{prefix}{}", key.flag);
            let value = arguments.try_get_one::<String>(&name).ok().flatten()?;
            Some((arguments.index_of(&name)?, key.flag, value.as_str()))
        })
        .collect();
    flags.sort_by_key(|(index, ..)| *index);
    if flags.is_empty() {
        return Ok(None);
    }
    let flags = flags.into_iter().map(|(_, flag, value)| (flag, value));
    Spec::from_prefixed_flags(prefix, flags).map(Some).map_err(|error| Failure::Refused(error, String::new()))
}

fn load(file: impl io::Read) -> io::Result<Vec<u8>> {
    load_up_to(file, LARGEST, "it is larger than 1 MiB and can hardly be the description of a ply")
}

fn load_up_to(file: impl io::Read, largest: u64, larger: &str) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(largest + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > largest {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, larger.to_owned()));
    }
    Ok(bytes)
}
