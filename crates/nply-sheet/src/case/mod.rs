//! One ply, dimensionless, and the one question asked about it.

mod check;
mod ends;
mod estimated;
mod fibre;
mod helix;
mod lay;
mod measure;
mod origin;
mod plying;
mod question;
mod relative;
mod strand;
mod stretch;
mod strings;
mod support;
mod twist;

use nply::mechanics::{Balance, Ends, ExtensiblePly, Grips, Load, Twist};
use nply::{DomainError, Handedness, Scale};

use lay::GivenLay;
use measure::Measure;
use origin::Origins;

use crate::key::Group;
use crate::spec::{Entry, Spec, Value};
pub(crate) use estimated::EstimatedPly;
pub use strings::{StringStiffness, Strings};

use crate::{Datum, ErrorKind, PreferredUnits, SpecError};

/// A ply in which everything is known that the theory needs; lengths over r, forces over B/r², moments over B/r.
///
/// ```
/// use nply_sheet::{Question, Spec};
/// let text = r#"
/// ply.strands = 2
/// strand = { radius = "1 nm", bending_stiffness = "200 pN nm^2", stiffness_ratio = 1.5 }
/// twist = { pretwist = -0.3 }
/// load = { force = "20 pN" }
/// "#;
/// let case = Spec::from_toml("dna.toml", text)?.check()?;
/// let Question::States { load, .. } = case.question else { unreachable!() };
/// assert!((load.force - 0.1).abs() < 1e-15); // F r²/B
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Case {
    /// The name given to it, for the report.
    pub title: Option<String>,
    /// n, 2 to a million.
    pub strands: u32,
    /// γ = C/B, greater than 0.
    pub stiffness_ratio: f64,
    /// Which balance is asked for.
    pub balance: Balance,
    /// Radial force per strand length from outside, times r³/B, outward positive; with [`Balance::Contact`] only.
    pub external_pressure: Option<f64>,
    /// What is to be found.
    pub question: Question,
    /// r in m and B in N m², where both are given; then results can be given in units of force and length.
    pub scale: Option<Scale>,
    /// r in m, where it is given; without `scale`, lengths (and only they) can be given in units.
    pub strand_radius: Option<f64>,
    /// L/r, where the strand length is given.
    pub strand_length: Option<f64>,
    /// Mass per length of one strand, kg/m, where it is given.
    pub linear_density: Option<f64>,
    /// Share of a strand's cross-section that is fibre, where its titre gives its size.
    pub packing_fraction: Option<f64>,
    /// The units the input was written in.
    pub units: PreferredUnits,
    origins: Origins,
}

/// What is to be found. Twist, force and moment as in [`nply::mechanics`], all dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Question {
    /// Every angle, of both hands, in equilibrium with a given twist and load.
    States {
        /// The twist given.
        twist: Twist,
        /// The load given.
        load: Load,
    },
    /// The moment that holds a given lay.
    MomentAt {
        /// The shape given.
        lay: Lay,
        /// Which way it winds; both are answered if not given.
        hand: Option<Handedness>,
        /// The twist given.
        twist: Twist,
        /// f given.
        force: f64,
    },
    /// The force that holds a given lay.
    ForceAt {
        /// The shape given.
        lay: Lay,
        /// Which way it winds; both are answered if not given.
        hand: Option<Handedness>,
        /// The twist given.
        twist: Twist,
        /// m given.
        moment: f64,
    },
    /// The pretwist that makes a given lay.
    PretwistAt {
        /// The shape given.
        lay: Lay,
        /// Which way it winds; both are answered if not given.
        hand: Option<Handedness>,
        /// The load given.
        load: Load,
    },
    /// The states, and their moment, in which the strands just stop pressing on each other under a given force.
    SeparationAtForce {
        /// The twist given.
        twist: Twist,
        /// f given.
        force: f64,
    },
    /// The states, and their force, in which the strands just stop pressing on each other under a given moment.
    SeparationAtMoment {
        /// The twist given.
        twist: Twist,
        /// m given.
        moment: f64,
    },
    /// The touching states with the ply's ends held, and the load that holds them there.
    Held {
        /// The twist given.
        twist: Twist,
        /// Rotation and force, or length and moment.
        ends: Ends,
    },
    /// Every state in which all closed contacts push: touching neighbours, on the core, on both, or free.
    Supported {
        /// The twist given.
        twist: Twist,
        /// Dead loads, or what is held.
        ends: Ends,
        /// Core radius over r, if there is a core.
        core_radius: Option<f64>,
    },
    /// The same of strands that stretch.
    Stretched {
        /// The strands, their core and the lay in which they were made.
        ply: ExtensiblePly,
        /// The twist given.
        twist: Twist,
        /// A load or a displacement along and around.
        grips: Grips,
    },
}

/// The shape of a ply, in one of the ways in which it is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Lay {
    /// θ in rad, 0 ≤ θ < π/2.
    HelicalAngle(f64),
    /// π/2 − θ in rad, greater than 0 and at most π/2.
    PitchAngle(f64),
    /// Ply length of one turn over r, greater than 0.
    LayLength(f64),
    /// Lay length over the outer diameter of the ply, greater than 0.
    LayRatio(f64),
    /// ρ = R/r, greater than 0.
    RadiusRatio(f64),
}

impl Case {
    /// With the question what carries the strands, if `supports` asks for it or a core is given.
    pub(crate) fn of(spec: &Spec, supports: bool) -> Result<Self, SpecError> {
        let spec = relative::resolved(spec)?;
        let spec = spec.as_ref();
        let strands = strands(spec, 2)?;
        let strand = strand::Strand::of(spec)?;
        let measure = strand.measure(spec);
        let strand_length = measure.strand_length()?;
        let twist = twist::of(&measure, strand_length)?;
        let lay = lay::of(&measure)?;
        let stretches = spec.stretches();
        let support = support::of(&measure, supports || stretches)?;
        let balance = match spec.get(Datum::Balance) {
            Some(Entry { value: Value::Balance(balance), .. }) => *balance,
            _ => Balance::default(),
        };
        let external_pressure = question::external_pressure(&measure, balance)?;
        let question = if stretches {
            let ply = stretch::of(&measure, strands, strand.stiffness_ratio, support)?;
            question::stretched(&measure, ply, twist, lay, support, strand_length)?
        } else {
            stretch::none(spec)?;
            question::of(&measure, twist, lay, ends::of(&measure, strand_length)?, support)?
        };
        let title = match spec.get(Datum::Title) {
            Some(Entry { value: Value::Text(title), .. }) => Some(title.clone()),
            _ => None,
        };
        Ok(Self {
            title,
            strands,
            stiffness_ratio: strand.stiffness_ratio,
            balance,
            external_pressure,
            question,
            scale: strand.scale,
            strand_radius: strand.radius,
            strand_length,
            linear_density: spec.get(Datum::LinearDensity).map(Entry::number),
            packing_fraction: fibre::given_packing(spec)?,
            units: PreferredUnits::of(spec),
            origins: Origins::of(spec),
        })
    }

    /// What the theory refuses later, said at the place of the datum it comes from.
    ///
    /// ```
    /// use nply_sheet::{ErrorKind, Spec};
    /// let text = "ply.strands = 3\nstrand.stiffness_ratio = 1\nlay.lay_length = 2\n";
    /// let case = Spec::from_toml("rope.toml", text)?.check()?;
    /// let refused = nply::DomainError { quantity: "lay_length", value: 2.0, allowed: "greater than 2 n" };
    /// let error = case.locate(&refused);
    /// assert_eq!((error.kind(), error.line(), error.exit_code()), (ErrorKind::Domain, Some(3), 1));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn locate(&self, error: &DomainError) -> SpecError {
        self.origins.displaced(self, error).unwrap_or_else(|| self.origins.locate(error))
    }

    /// Whether a datum was given, and not taken to be 0.
    pub(crate) fn gives(&self, datum: Datum) -> bool {
        self.origins.give(datum)
    }

    /// Whether the strands may be solid and round. Molecules, known by how they bend in a solvent, and bundles of fibres with room between
    /// them are not.
    pub(crate) fn may_be_solid(&self) -> bool {
        !self.gives(Datum::BendingPersistenceLength) && self.packing_fraction.is_none_or(|share| share >= 1.0)
    }

    /// A refusal of what no ply let go can be, at a datum or at any of its group.
    pub(crate) fn refuse_domain(&self, datum: Datum, why: &str) -> SpecError {
        self.origins.refuse_domain(datum, why)
    }

    /// A refusal of what goes with no study, at the first datum of those wanted, whose words begin the message.
    pub(crate) fn refuse(&self, wanted: impl Fn(&Entry) -> bool, message: impl FnOnce(&str) -> String) -> SpecError {
        self.origins.refuse(wanted, message)
    }
}

/// A ply of which only the shape is asked: what `nply contact` needs. Twist, load and stiffnesses may be written, and are not
/// looked at.
///
/// ```
/// use nply_sheet::{Lay, Spec};
/// let shape = Spec::from_flags([("strands", "3"), ("lay-length", "30")])?.check_shape()?;
/// assert_eq!((shape.strands, shape.lay), (3, Some(Lay::LayLength(30.0))));
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Shape {
    /// n, 1 (a single tube touching its own next turn) to a million.
    pub strands: u32,
    /// The shape given; lengths over r. None for n = 1, whose densest helix is meant.
    pub lay: Option<Lay>,
    /// Which way it winds; both if not given.
    pub hand: Option<Handedness>,
    /// r in m, where it is given.
    pub strand_radius: Option<f64>,
    /// Share of a strand's cross-section that is fibre, where its titre gives its size.
    pub packing_fraction: Option<f64>,
    /// The units the input was written in.
    pub units: PreferredUnits,
    origins: Origins,
}

impl Shape {
    pub(crate) fn of(spec: &Spec) -> Result<Self, SpecError> {
        let strands = strands(spec, 1)?;
        let radius = strand::radius(spec)?;
        let measure = Measure { spec, radius, scale: None };
        let (lay, hand) = match lay::of(&measure)? {
            Some(GivenLay { entry, .. }) if strands == 1 => {
                let message = format!(
                    "{}: of a single strand only the densest helix is known, and its shape is found; remove it",
                    entry.said()
                );
                return Err(entry.error(ErrorKind::Contradiction, message));
            }
            Some(GivenLay { lay, hand, .. }) => (Some(lay), hand),
            None if strands == 1 => (None, None),
            None => {
                let message = format!(
                    "the lay is missing: give {}, or {}, {}, {} or {}",
                    spec.ask_for(Datum::HelicalAngle),
                    spec.call(Datum::PitchAngle),
                    spec.call(Datum::LayLength),
                    spec.call(Datum::LayRatio),
                    spec.call(Datum::RadiusRatio)
                );
                return Err(spec.missing(Datum::HelicalAngle, message));
            }
        };
        let units = PreferredUnits::of(spec);
        let packing_fraction = fibre::given_packing(spec)?;
        Ok(Self { strands, lay, hand, strand_radius: radius, packing_fraction, units, origins: Origins::of(spec) })
    }

    /// As [`Case::locate`].
    #[must_use]
    pub fn locate(&self, error: &DomainError) -> SpecError {
        self.origins.locate(error)
    }
}

/// The entries of a group of which only one can be given.
fn only_one<'s>(spec: &'s Spec, group: Group, gives: &str) -> Result<Option<&'s Entry>, SpecError> {
    let mut found = spec.entries.iter().filter(|entry| entry.key.group == Some(group));
    let first = found.next();
    match (first, found.next()) {
        (Some(first), Some(second)) => {
            // whoever gives a lay and a core may mean a wire to lie on
            let core = [Datum::CoreRadius, Datum::CoreDiameter].into_iter().find_map(|datum| spec.get(datum));
            let core = match core.filter(|_| group == Group::Lay) {
                Some(core) => format!(
                    " ({} is the core of strands that touch each other and it; a core wire of any size is `--core` of `nply nodes` and `nply \
                     mesh`, or [core] in a file with [[layer]])",
                    spec.call(core.key.datum)
                ),
                None => String::new(),
            };
            let message = format!("{} and {} both give {gives}: remove one of them{core}", first.said(), second.said());
            Err(second.error(ErrorKind::Contradiction, message))
        }
        _ => Ok(first),
    }
}

/// The number of strands: a whole number, not less than `least` (2 where it has to carry anything).
pub(crate) fn strands(spec: &Spec, least: u32) -> Result<u32, SpecError> {
    const MOST: f64 = 1e6;
    let Some(entry) = spec.get(Datum::Strands) else {
        let message = format!("the number of strands is missing: give {}, such as 3", spec.ask_for(Datum::Strands));
        return Err(spec.missing(Datum::Strands, message));
    };
    let number = entry.number();
    let refuse = |why: &str| Err(entry.error(ErrorKind::Domain, format!("{}: {why}", entry.said())));
    if number <= 0.0 {
        refuse("a ply needs strands: give 2 or more")
    } else if libm::trunc(number) < number {
        refuse("strands cannot be cut into parts: give a whole number, 2 or more")
    } else if number < f64::from(least) {
        refuse("a single strand has geometry only, see `nply contact`; for a ply give 2 or more")
    } else if number > MOST {
        refuse("more than a million strands are not taken")
    } else {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole and between 2 and a million"
        )]
        Ok(number as u32)
    }
}
