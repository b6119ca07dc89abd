//! A map: every state over a rectangle of two data.

mod axis;
mod cell;
mod picture;
mod rows;
mod tally;

pub use axis::{Axis, MapDatum};
pub use cell::{Cell, MapState, Verdict};
pub use picture::MapPicture;
pub use tally::Tally;

use nply::mechanics::{Along, Balance, Data, Ends, Ply, Twist};

use crate::report::data_of;
use crate::spec::{MapSpec, Spec};
use crate::{Case, ErrorKind, Question, SpecError};

/// Two data over a rectangle; everything else is held.
///
/// Rows are worked out one by one and independently, so that a door can share them out among threads.
///
/// ```
/// use nply_sheet::Spec;
/// let text = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -0.2\n\
///     [map]\nfrom.load = { force = -2, moment = -3 }\nto.load = { force = 2, moment = 3 }\ncolumns = 5\nrows = 3\n";
/// let map = Spec::from_toml("map.toml", text)?.check_map(None)?;
/// let row = map.row(1)?; // moment 0
/// assert_eq!(row.len(), 5);
/// assert!((row[2].states[0].helical_angle_deg - 12.1369).abs() < 5e-5); // no force: the balanced ply
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    case: Case,
    corner: Data,
    /// Across, from left to right.
    pub x: Axis,
    /// Up, from the first row to the last.
    pub y: Axis,
}

/// A map's corners and fineness as given by flags; what is `None` is taken from the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapFlags {
    /// What one corner of the rectangle changes, in the order in which it was given.
    pub from: Option<Spec>,
    /// What the opposite corner changes; the first datum runs across, the second up.
    pub to: Option<Spec>,
    /// Points across.
    pub columns: Option<u32>,
    /// Points up.
    pub rows: Option<u32>,
}

/// Points across and up where nobody says how many.
const POINTS: u32 = 200;
/// The most points across or up.
pub(crate) const MOST: u32 = 100_000;

impl Spec {
    /// The map that `[map]` of the file describes, or flags, or both.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`], and unless exactly two data run from one number to another, of a ply whose twist and loads
    /// (or held ends, or a core) are given.
    pub fn check_map(&self, flags: Option<&MapFlags>) -> Result<Map, SpecError> {
        let given = self.map.as_deref();
        let flags = flags.cloned().unwrap_or_default();
        let missing = || {
            let message = "the rectangle is missing: say from where to where two data run, such as --from-force -2 --to-force 2 \
                           --from-moment -3 --to-moment 3, or by `from` and `to` in [map]";
            let place = given.map_or_else(|| self.head(), |map: &MapSpec| map.place.clone());
            SpecError::new(ErrorKind::Missing, place, message)
        };
        let to = flags.to.or_else(|| given.map(|map| map.to.clone())).ok_or_else(missing)?;
        let from = flags.from.or_else(|| given.map(|map| map.from.clone())).unwrap_or_else(|| to.without_data());
        let [across, up] = &to.entries[..] else {
            let message = match to.entries.len() {
                0 => return Err(missing()),
                1 => format!("a map has two data that run, and only {} is given: give another", to.entries[0].said()),
                _ => {
                    let said: Vec<String> = to.entries.iter().map(crate::spec::Entry::said).collect();
                    format!("a map has two data that run, and {} are given: {}; leave two", said.len(), said.join(", "))
                }
            };
            return Err(to.entries[to.entries.len() - 1].error(ErrorKind::Contradiction, message));
        };
        let one = |entry| to.only(entry);
        self.keeps_flags_beside(&from)?;
        let corner = self.onward(&from);
        let case = corner.check()?;
        let (start, right, top) = (
            data_of(&case)?,
            data_of(&corner.onward(&one(across)).check()?)?,
            data_of(&corner.onward(&one(up)).check()?)?,
        );
        type Given = Option<(f64, crate::Place)>;
        let points = |flag: Option<u32>, file: Given, name: &'static str| {
            let flag = flag.map(|count| (f64::from(count), crate::Place::Flag(name.to_owned())));
            let (count, place) = flag.or(file).unwrap_or((f64::from(POINTS), crate::Place::Flag(name.to_owned())));
            if (1.0..=f64::from(MOST)).contains(&count) {
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most")]
                return Ok(count as u32);
            }
            let message = format!("a map has 1 to {MOST} {name}, and {count} were asked for");
            Err(SpecError::new(ErrorKind::Domain, place, message).of_key(name))
        };
        let axis = |end: Data, entry: &crate::spec::Entry, count| Axis::between(&start, &end, entry, count);
        let x = axis(right, across, points(flags.columns, given.and_then(|map| map.columns.clone()), "columns")?)?;
        let y = axis(top, up, points(flags.rows, given.and_then(|map| map.rows.clone()), "rows")?)?;
        if x.datum == y.datum {
            let message =
                format!("{} and {} change the same: a map needs two different data", across.said(), up.said());
            return Err(up.error(ErrorKind::Contradiction, message));
        }
        let map = Map { case, corner: start, x, y };
        map.check_corners()?;
        Ok(map)
    }

    /// The same places with nothing given.
    fn without_data(&self) -> Self {
        let mut empty = self.clone();
        empty.entries.clear();
        empty
    }

    /// This with one datum only.
    fn only(&self, entry: &crate::spec::Entry) -> Self {
        let mut one = self.without_data();
        one.entries.push(entry.clone());
        one
    }
}

impl Map {
    /// The case at the corner the map begins in.
    #[must_use]
    pub const fn case(&self) -> &Case {
        &self.case
    }

    /// What is held all over the map: the dimensionless data that do not run.
    ///
    /// ```
    /// use nply_sheet::{Spec, map::MapDatum};
    /// let text = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -0.2\nmap.to.load = { force = 2, moment = 3 }\n";
    /// let map = Spec::from_toml("map.toml", text)?.check_map(None)?;
    /// assert_eq!(map.held(), [(MapDatum::Pretwist, -0.2), (MapDatum::StiffnessRatio, 0.75)]);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn held(&self) -> Vec<(MapDatum, f64)> {
        let runs = [self.x.datum, self.y.datum];
        let still = MapDatum::ALL.into_iter().filter(|datum| !runs.contains(datum));
        still.filter_map(|datum| Some((datum, datum.get(&self.corner)?))).collect()
    }

    /// The data at a column and a row.
    fn data(&self, column: usize, row: usize) -> Data {
        self.y.datum.set(self.x.datum.set(self.corner, self.x.value(column)), self.y.value(row))
    }

    /// What the theory would refuse, before anything is worked out.
    fn check_corners(&self) -> Result<(), SpecError> {
        let (last_column, last_row) = (self.x.count as usize - 1, self.y.count as usize - 1);
        for (column, row) in [(0, 0), (last_column, 0), (0, last_row), (last_column, last_row)] {
            let data = self.data(column, row);
            let checked = self.states(data).map(drop);
            checked.map_err(|error| self.case.locate(&error))?;
        }
        Ok(())
    }

    /// Every cell of a row, from left to right.
    ///
    /// # Errors
    /// [`nply::DomainError`] where a premise is broken that no corner broke.
    pub fn row(&self, row: usize) -> Result<Vec<Cell>, nply::DomainError> {
        let count = self.x.count as usize;
        let mut cells = vec![Cell::default(); count];
        let data = self.y.datum.set(self.corner, self.y.value(row));
        let touching = matches!(self.case.question, Question::States { .. });
        let along = self.x.datum.along().filter(|_| touching);
        if let (Some(along), Ends::Loads(load)) = (along, data.ends) {
            let gamma = if along == Along::StiffnessRatio { self.x.value(0) } else { data.stiffness_ratio };
            let ply = Ply::with_balance(self.case.strands, gamma, self.case.balance)?;
            // the kernel wants rising values
            let values: Vec<f64> = (0..count).map(|column| self.x.value(column)).collect();
            let falling = self.x.to < self.x.from;
            let rising: Vec<f64> = if falling { values.iter().rev().copied().collect() } else { values };
            ply.each_equilibrium_along(along, &rising, data.twist, load, |i, state| {
                let column = if falling { count - 1 - i } else { i };
                cells[column].states.push(MapState::of_row(&state));
            })?;
        } else {
            for (column, cell) in cells.iter_mut().enumerate() {
                cell.states = self.states(self.data(column, row))?;
            }
        }
        cells.iter_mut().for_each(Cell::sort);
        Ok(cells)
    }

    /// The states of one cell by themselves.
    fn states(&self, data: Data) -> Result<Vec<MapState>, nply::DomainError> {
        let strands = self.case.strands;
        if let Question::Supported { .. } = self.case.question {
            let ply = Ply::new(strands, data.stiffness_ratio)?;
            let states = ply.supported_states(data.twist, data.ends, data.core_radius)?;
            return Ok(states.iter().map(|state| MapState::of_supported(state, data.ends.holding())).collect());
        }
        let ply = Ply::with_balance(strands, data.stiffness_ratio, self.case.balance)?;
        let states = match data.ends {
            Ends::Loads(load) => ply.equilibria(data.twist, load)?,
            // a displacement that no ply has is a cell without a state
            held => ply.equilibria_held(data.twist, held).unwrap_or_default(),
        };
        Ok(states.iter().map(|state| MapState::of_touching(state, data.ends.holding())).collect())
    }

    /// Whether the map is of force and moment at a held twist, over which the locus p = 0 can be drawn.
    fn has_locus(&self) -> bool {
        let loads = [self.x.datum, self.y.datum];
        loads.contains(&MapDatum::Force)
            && loads.contains(&MapDatum::Moment)
            && matches!(self.case.question, Question::States { .. } | Question::Supported { .. })
    }

    /// A verdict in words.
    pub(super) const fn words(&self, verdict: Verdict) -> &'static str {
        match (verdict, self.case.balance) {
            (Verdict::NoState, _) => "no state",
            (Verdict::Separated, _) => "separated only",
            (Verdict::Unstable, _) => "unstable only",
            (Verdict::One, Balance::Contact) => "one stable",
            (Verdict::Several, Balance::Contact) => "several stable",
            (Verdict::One, Balance::Radial) => "one that presses",
            (Verdict::Several, Balance::Radial) => "several that press",
        }
    }

    const fn twist(&self) -> Twist {
        self.corner.twist
    }

    const fn balance(&self) -> Balance {
        self.case.balance
    }
}
