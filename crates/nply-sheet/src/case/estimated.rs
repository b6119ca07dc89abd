//! A ply of which some numbers are to be estimated: what is known of it, and where estimates start from.

use nply::mechanics::{Balance, Twist};
use nply::{Handedness, Scale};

use super::{relative, strand, strands, stretch, twist};
use crate::key::Group;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, ErrorKind, PreferredUnits, SpecError, Table};

/// What `nply fit` takes of a description. Dimensionless as a [`Case`](crate::Case) is.
#[derive(Clone, Debug)]
pub(crate) struct EstimatedPly {
    pub(crate) title: Option<String>,
    pub(crate) strands: u32,
    pub(crate) balance: Balance,
    pub(crate) hand: Option<Handedness>,
    pub(crate) radius: Option<f64>,
    pub(crate) scale: Option<Scale>,
    pub(crate) stiffness_ratio: f64,
    /// which data give B, C and the twist
    pub(crate) bending: Option<Datum>,
    pub(crate) torsion: Option<Datum>,
    pub(crate) twist: Option<(Twist, Datum)>,
    /// EA r²/B and ν of strands that stretch; whether EA follows from that of a solid strand
    pub(crate) stretch: Option<(f64, f64, bool)>,
    /// L/r
    pub(crate) strand_length: Option<f64>,
    pub(crate) force: Option<f64>,
    pub(crate) moment: Option<f64>,
    pub(crate) units: PreferredUnits,
}

impl EstimatedPly {
    pub(crate) fn of(spec: &Spec) -> Result<Self, SpecError> {
        let spec = relative::resolved(spec)?;
        let spec = spec.as_ref();
        refuse_others(spec)?;
        let count = strands(spec, 2)?;
        let strand = strand::Strand::of(spec)?;
        let measure = strand.measure(spec);
        let strand_length = measure.strand_length()?;
        let given =
            |group| spec.entries.iter().find(|entry| entry.key.group == Some(group)).map(|entry| entry.key.datum);
        let twist = twist::of(&measure, strand_length)?.zip(given(Group::Twist));
        let stretch = if spec.stretches() {
            let (alpha, entry) = stretch::axial(&measure)?;
            let (nu, _) = stretch::thinning(spec)?;
            Some((alpha, nu, entry.key.datum == Datum::YoungsModulus))
        } else {
            stretch::none(spec)?;
            None
        };
        let balance = match spec.get(Datum::Balance) {
            Some(Entry { value: Value::Balance(balance), .. }) => *balance,
            _ => Balance::default(),
        };
        if let (Balance::Radial, Some(_), Some(entry)) = (balance, stretch, spec.get(Datum::Balance)) {
            let message = format!("{}: strands that stretch are in contact balance; remove it", entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        let hand = match spec.get(Datum::Hand) {
            Some(Entry { value: Value::Hand(hand), .. }) => Some(*hand),
            _ => None,
        };
        let title = match spec.get(Datum::Title) {
            Some(Entry { value: Value::Text(title), .. }) => Some(title.clone()),
            _ => None,
        };
        let load = |datum| spec.get(datum).map(|entry| measure.dimensionless(entry)).transpose();
        Ok(Self {
            title,
            strands: count,
            balance,
            hand,
            radius: strand.radius,
            scale: strand.scale,
            stiffness_ratio: strand.stiffness_ratio,
            bending: given(Group::Bending),
            torsion: given(Group::Torsion),
            twist,
            stretch,
            strand_length,
            force: load(Datum::Force)?,
            moment: load(Datum::Moment)?,
            units: PreferredUnits::of(spec),
        })
    }
}

/// What belongs to the rows of measurements, or to other questions.
fn refuse_others(spec: &Spec) -> Result<(), SpecError> {
    let other = |entry: &&Entry| {
        matches!(entry.key.table, Table::Lay | Table::Formed | Table::Ends | Table::Support)
            || matches!(entry.key.datum, Datum::ExternalPressure | Datum::Separation)
    };
    let Some(entry) = spec.entries.iter().find(other) else { return Ok(()) };
    let message = match entry.key.table {
        Table::Lay | Table::Ends => format!(
            "{} is a measurement: write it in a column of the data, in every row where it holds, and remove it here",
            entry.said()
        ),
        _ => format!(
            "{}: touching strands alone are fitted, straight before they were twisted, without core or pressure from outside: remove it",
            entry.said()
        ),
    };
    Err(entry.error(ErrorKind::Contradiction, message))
}
