//! A large table on its way to its name: `NAME.part` until it is whole, and `NAME.part.log` beside it, which tells what stands in it.
//!
//! The log has a line for each block of which every byte is on the disk. Whatever ends the command (Ctrl-C, a full disk, a kill, a power
//! cut), the file up to the last line of the log is whole, and a later run goes on from there.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufRead as _, BufReader, BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use nply_sheet::table::{Block, BlockFile, Encoder, Mark, TableError};

use crate::failure::Failure;
use crate::output::shown;

/// How long what was written may be lost by a kill or a power cut, besides the block that is being worked on.
const BETWEEN: Duration = Duration::from_millis(1000);

/// The table that is being written.
pub(crate) struct Part {
    name: PathBuf,
    table: BlockFile<BufWriter<File>>,
    log: File,
    /// lines whose blocks may not be on the disk yet
    waiting: String,
    last: Instant,
    /// rows of the study that are done
    done: u64,
}

/// What is found beside a name.
enum Left {
    Nothing,
    /// a part with its marks: rows of the study done, and where the file stands
    Part(Vec<(u64, Mark)>),
}

fn beside(name: &Path, ending: &str) -> PathBuf {
    let mut path = name.as_os_str().to_owned();
    path.push(ending);
    PathBuf::from(path)
}

fn cannot(what: &str, path: &Path, error: io::Error) -> Failure {
    Failure::File { what: format!("cannot {what} {}", shown(path)), error }
}

fn refused(name: &Path, why: &str) -> Failure {
    Failure::File { what: format!("cannot write {}", shown(name)), error: io::Error::other(why.to_owned()) }
}

fn hex(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn unhex(text: &str) -> Option<Vec<u8>> {
    let digit = |at: usize| text.get(at..at + 2).and_then(|pair| u8::from_str_radix(pair, 16).ok());
    text.len().is_multiple_of(2).then(|| (0..text.len()).step_by(2).map(digit).collect())?
}

/// A line of the log.
fn line(rows: u64, mark: &Mark) -> String {
    let said = format!("{rows} {} {}", mark.bytes, hex(&mark.tail));
    let sum = checksum(said.as_bytes());
    format!("{said} {sum:016x}\n")
}

/// The mark of a line, if the line is whole.
fn mark(line: &str) -> Option<(u64, Mark)> {
    let (said, sum) = line.strip_suffix('\n')?.rsplit_once(' ')?;
    if u64::from_str_radix(sum, 16).ok()? != checksum(said.as_bytes()) {
        return None;
    }
    let mut words = said.split(' ');
    let rows = words.next()?.parse().ok()?;
    let bytes = words.next()?.parse().ok()?;
    Some((rows, Mark { bytes, tail: unhex(words.next()?)? }))
}

/// Fowler, Noll and Vo's hash, 1a, of 64 bits: it tells slips, not attacks.
pub(crate) fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

impl Part {
    /// The table of this name, from its beginning or from where it was left: `resume` says which is wanted. `identity` is what makes it this
    /// table and no other. `None` where the table is whole already.
    pub(crate) fn open(name: &Path, encoder: &Encoder, identity: &str, resume: bool) -> Result<Option<Self>, Failure> {
        let (part, log_path) = (beside(name, ".part"), beside(name, ".part.log"));
        let head =
            format!("nply {} {:016x} {}\n", encoder.format().name(), checksum(identity.as_bytes()), quoted(identity));
        let log = File::options().read(true).append(true).create(true).open(&log_path);
        let log = log.map_err(|error| cannot("write", name, error))?;
        match log.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(refused(name, "another run is writing it")),
            Err(TryLockError::Error(_)) => {} // a file system without locks
        }
        let old = beside(name, ".part.old");
        match left(&log, &part, &old, &head, name, resume) {
            Ok(Left::Nothing) if resume && name.exists() => {
                let _ = fs::remove_file(&log_path);
                Ok(None)
            }
            Ok(Left::Nothing) => Self::start(name, encoder, log, &head).map(Some).map_err(|failure| {
                // nothing is done yet, and nothing is left
                let _ = fs::remove_file(&part);
                let _ = fs::remove_file(&log_path);
                match failure {
                    Failure::File { error, .. } => cannot("write", name, error),
                    other => other,
                }
            }),
            Ok(Left::Part(marks)) => Self::take_up(name, encoder, log, &head, &marks).map(Some),
            Err(failure) => {
                if log.metadata().is_ok_and(|about| about.len() == 0) {
                    let _ = fs::remove_file(&log_path);
                }
                Err(failure)
            }
        }
    }

    /// Begins. What the part will be stands in the log before there is a part, so that none is ever met of which nobody knows what it is.
    fn start(name: &Path, encoder: &Encoder, mut log: File, head: &str) -> Result<Self, Failure> {
        let cannot = |error| cannot("write", name, error);
        log.write_all(head.as_bytes()).and_then(|()| log.sync_data()).map_err(cannot)?;
        let file = File::create(beside(name, ".part")).map_err(cannot)?;
        Self::begin(name, BlockFile::new(encoder, BufWriter::new(file)), log, 0)
    }

    /// Goes on where a part was left: what is in it is copied, so that until then nothing is lost whatever happens.
    fn take_up(name: &Path, encoder: &Encoder, log: File, head: &str, marks: &[(u64, Mark)]) -> Result<Self, Failure> {
        let (part, old) = (beside(name, ".part"), beside(name, ".part.old"));
        let cannot = |error| cannot("write", &part, error);
        if !old.exists() {
            fs::rename(&part, &old).map_err(cannot)?;
        }
        let from = File::open(&old).map_err(cannot)?;
        let write = BufWriter::new(File::create(&part).map_err(cannot)?);
        let list: Vec<Mark> = marks.iter().map(|(_, mark)| mark.clone()).collect();
        let (mut table, whole) = BlockFile::resumed(encoder, write, from, &list)
            .map_err(|error| Failure::of_table_in(&part.display().to_string(), error))?;
        let copied = |error| Failure::of_table_in(&part.display().to_string(), error);
        table.flush().map_err(copied)?;
        table.get_mut().get_ref().sync_all().map_err(cannot)?;
        let marks = &marks[..whole];
        let done = marks.last().map_or(0, |(rows, _)| *rows);
        // the log is what it was up to the last block that is whole: cut, and never without what it says
        let said: usize = head.len() + marks.iter().map(|(rows, mark)| line(*rows, mark).len()).sum::<usize>();
        log.set_len(said as u64).map_err(cannot)?;
        let this = Self::begin(name, Ok(table), log, done)?;
        fs::remove_file(&old).map_err(cannot)?;
        Ok(this)
    }

    fn begin(
        name: &Path,
        table: Result<BlockFile<BufWriter<File>>, TableError>,
        log: File,
        done: u64,
    ) -> Result<Self, Failure> {
        let table = table.map_err(|error| Failure::of_table_in(&shown(name), error))?;
        let mut this = Self { name: name.to_owned(), table, log, waiting: String::new(), last: Instant::now(), done };
        this.settle()?;
        Ok(this)
    }

    /// Rows of the study that are done.
    pub(crate) const fn done(&self) -> u64 {
        self.done
    }

    /// Puts a block behind the others, behind which so many rows of the study are done.
    pub(crate) fn append(&mut self, done: u64, block: Block) -> Result<(), Failure> {
        let mark = self.table.append(block).map_err(|error| self.lost(error))?;
        self.waiting.push_str(&line(done, &mark));
        self.done = done;
        if self.last.elapsed() >= BETWEEN {
            self.settle()?;
        }
        Ok(())
    }

    /// Brings everything to the disk, and then says so in the log.
    fn settle(&mut self) -> Result<(), Failure> {
        self.table.flush().map_err(|error| self.lost(error))?;
        let file = self.table.get_mut().get_ref();
        let synced = file.sync_data().and_then(|()| self.log.write_all(self.waiting.as_bytes()));
        synced.map_err(|error| self.lost(TableError::Write(error)))?;
        self.waiting.clear();
        self.last = Instant::now();
        Ok(())
    }

    /// What a failed write is said to be; what was settled stands.
    fn lost(&self, error: TableError) -> Failure {
        match Failure::of_table_in(&shown(&self.name), error) {
            Failure::File { what, error } => {
                let part = beside(&self.name, ".part");
                let what = format!("{what} (what was done is in {}, and --resume goes on with it)", shown(&part));
                Failure::File { what, error }
            }
            other => other,
        }
    }

    /// Ends the part as a file that can be read, to be gone on with another time; says where it is.
    pub(crate) fn leave(mut self) -> Result<String, Failure> {
        self.settle()?;
        let part = beside(&self.name, ".part");
        let Self { name, table, done, .. } = self;
        let written =
            table.finish().and_then(|write| Ok(write.into_inner().map_err(io::IntoInnerError::into_error)?));
        let synced = written.and_then(|file| Ok(file.sync_all()?));
        synced.map_err(|error| Failure::of_table_in(&shown(&name), error))?;
        Ok(format!("{done} rows are in {}, and --resume goes on with them", shown(&part)))
    }

    /// Takes everything away, as if nothing had been done.
    pub(crate) fn discard(self) {
        let Self { name, table, log, .. } = self;
        drop((table, log));
        for ending in [".part", ".part.log", ".part.old"] {
            let _ = fs::remove_file(beside(&name, ending));
        }
    }

    /// Ends the table and gives it its name.
    pub(crate) fn keep(mut self) -> Result<(), Failure> {
        self.settle()?;
        let (part, log) = (beside(&self.name, ".part"), beside(&self.name, ".part.log"));
        let Self { name, table, .. } = self;
        let written =
            table.finish().and_then(|write| Ok(write.into_inner().map_err(io::IntoInnerError::into_error)?));
        let named = written.and_then(|file| {
            file.sync_all()?;
            Ok(fs::rename(&part, &name)?)
        });
        named.map_err(|error| Failure::of_table_in(&shown(&name), error))?;
        let _ = fs::remove_file(log);
        Ok(())
    }
}

/// What an earlier run left.
fn left(log: &File, part: &Path, old: &Path, head: &str, name: &Path, resume: bool) -> Result<Left, Failure> {
    // a copy that was not ended stands back behind what it was made from
    let kept = if old.exists() { old } else { part };
    if !kept.exists() {
        log.set_len(0).map_err(|error| cannot("write", name, error))?;
        return Ok(Left::Nothing);
    }
    if !resume {
        let why =
            format!("{} is there, the beginning of a table: go on with it by --resume, or remove it", shown(kept));
        return Err(refused(name, &why));
    }
    let mut reader = BufReader::new(log);
    let mut first = String::new();
    let read = |error| cannot("read", part, error);
    reader.read_line(&mut first).map_err(read)?;
    if first != head {
        let why = if first.is_empty() {
            format!("nothing says what {} is the beginning of: remove it", shown(kept))
        } else {
            format!(
                "{} is the beginning of another table (other data, another question, another version of nply): remove it, or give another name",
                shown(kept)
            )
        };
        return Err(refused(name, &why));
    }
    let mut marks = Vec::new();
    loop {
        let mut text = String::new();
        // a line that a cut left half is none
        if reader.read_line(&mut text).map_err(read)? == 0 {
            break;
        }
        let Some(mark) = mark(&text) else { break };
        marks.push(mark);
    }
    Ok(Left::Part(marks))
}

/// On one line.
fn quoted(text: &str) -> String {
    text.escape_default().to_string()
}
