//! Following a state as its data change: through folds, over contacts that open and close.

mod course;
mod encounter;
mod regime;
mod station;
mod step;
mod stiff;
mod walk;

pub(in crate::mechanics) use course::{Course, Stop, hand, touch};
pub(in crate::mechanics) use regime::{FLATTEST, Regime};
pub(in crate::mechanics) use walk::Walk;

pub use station::{Event, Mark, Station};
pub use walk::{End, Trace};

use super::support::check_core;
use super::{Balance, Ends, Equilibrium, Holding, Load, Ply, SupportedState, Twist};
use crate::DomainError;
use crate::numerics::linear::Vector;

/// Everything that fixes the states of given strands, dimensionless (r = B = 1).
///
/// ```
/// use nply::mechanics::{Data, Ends, Load, Twist};
/// let released = Data { stiffness_ratio: 0.75, twist: Twist::Pretwist(-0.2), ends: Load::NONE.into(), core_radius: None };
/// let pulled = Data { ends: Load { force: 1.0, moment: 0.0 }.into(), ..released };
/// assert_ne!(released, pulled);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Data {
    /// γ = C/B.
    pub stiffness_ratio: f64,
    /// Pretwist, or the strands' own twist.
    pub twist: Twist,
    /// How the ends are held.
    pub ends: Ends,
    /// Radius of a core, units of r.
    pub core_radius: Option<f64>,
}

/// What contacts may do on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Contacts {
    /// Push only: they open where they would have to pull, and close where strands meet again.
    Unilateral,
    /// Neighbours are kept together whatever it takes, as the paper does, in the given balance; separation is a mark on the way.
    Kept(Balance),
}

/// A straight line from one set of data to another, in any of them together.
///
/// ```
/// use nply::mechanics::{Contacts, Data, Load, Mark, Path, Route, Twist};
/// // a three-ply under a moment: as the pull becomes a thrust it winds on, past 45°, and stays stable
/// let at = |force| Data {
///     stiffness_ratio: 0.75,
///     twist: Twist::Pretwist(-0.2),
///     ends: Load { force, moment: 3.0 }.into(),
///     core_radius: None,
/// };
/// let path = Path::new(3, at(0.5), at(-0.2), Contacts::Unilateral)?;
/// let start = path.starts()?[0];
/// let trace = path.trace(&start, &Route::default())?;
/// let diagonal = trace.events.iter().find(|event| event.mark == Mark::Diagonal).expect("it passes 45°");
/// assert!((diagonal.station.load.force + 0.10875).abs() < 1e-5);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    strands: u32,
    from: Data,
    to: Data,
    contacts: Contacts,
}

/// How far to go, and in which steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Route {
    /// Stop at the first arrival at the far end; otherwise go on through it, until the branch ends or leaves `window`.
    pub stop_at_arrival: bool,
    /// The stretch of the path that may be walked on: 0 is its beginning, 1 its end.
    pub window: (f64, f64),
    /// The longest step along the branch, in rad of the angle, in rotation, or in the share of the path.
    pub step: f64,
    /// r κ, the strain of the outer fibre by bending, beyond which strands would be hurt; passing it is an event. Of strands formed
    /// beforehand what counts is the change of curvature.
    pub curvature_limit: Option<f64>,
    /// Strain of the outermost fibre, from stretch and bending together, beyond which strands would be hurt; passing it is an event.
    pub strain_limit: Option<f64>,
}

impl Default for Route {
    /// To the far end, in steps that draw a smooth curve.
    fn default() -> Self {
        Self { stop_at_arrival: true, window: (0.0, 1.0), step: 0.02, curvature_limit: None, strain_limit: None }
    }
}

impl Route {
    fn check(&self) -> Result<(), DomainError> {
        let (low, high) = self.window;
        let allowed = "from at most 0 to at least 1";
        DomainError::check(low <= 0.0 && high >= 1.0 && high - low < 1e9, "window", low, allowed)?;
        DomainError::check((1e-6..=0.2).contains(&self.step), "step", self.step, "between 1e-6 and 0.2")?;
        for (name, limit) in [("curvature_limit", self.curvature_limit), ("strain_limit", self.strain_limit)] {
            if let Some(limit) = limit {
                DomainError::check(limit > 0.0, name, limit, "greater than 0")?;
            }
        }
        Ok(())
    }
}

impl Path {
    /// From data to data.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, on data out of range, and on `path` unless both ends hold the same kinds of data: the same kind
    /// of twist, ends held in the same way, a core at both or at none; a core only where contacts may open.
    pub fn new(strands: u32, from: Data, to: Data, contacts: Contacts) -> Result<Self, DomainError> {
        for data in [from, to] {
            data.check(strands)?;
        }
        let same_twist = matches!(
            (from.twist, to.twist),
            (Twist::Pretwist(_), Twist::Pretwist(_)) | (Twist::StrandTwist(_), Twist::StrandTwist(_))
        );
        let same_ends = from.ends.holding() == to.ends.holding();
        let same_core = from.core_radius.is_some() == to.core_radius.is_some();
        let allowed = "between data of the same kinds: twist, holding of the ends, core or none";
        DomainError::check(same_twist && same_ends && same_core, "path", f64::NAN, allowed)?;
        let kept_on_core = matches!(contacts, Contacts::Kept(_)) && from.core_radius.is_some();
        let allowed = "absent where neighbours are kept together: a core needs contacts that open and close";
        DomainError::check(!kept_on_core, "core_radius", from.core_radius.unwrap_or(f64::NAN), allowed)?;
        Ok(Self { strands, from, to, contacts })
    }

    /// Every state at the beginning of the path from which it can be followed, straight strands last where they hold.
    ///
    /// # Errors
    /// [`DomainError`] where no ply can have the displacement that is held.
    pub fn starts(&self) -> Result<Vec<Station>, DomainError> {
        let Data { stiffness_ratio, twist, ends, core_radius } = self.from;
        let mut starts: Vec<Station> = match self.contacts {
            Contacts::Unilateral => {
                let ply = Ply::new(self.strands, stiffness_ratio)?;
                let states = ply.supported_states(twist, ends, core_radius)?;
                let place = |s: &SupportedState| [s.handedness().sign() * s.angle().radians(), s.rotation()];
                let station =
                    |s: &SupportedState| self.station(Regime::On(s.support()), self.coordinates(place(s), s.load()));
                states.iter().map(station).collect()
            }
            Contacts::Kept(balance) => {
                let states = Ply::with_balance(self.strands, stiffness_ratio, balance)?.equilibria_held(twist, ends)?;
                let place = |s: &Equilibrium| [s.handedness().sign() * s.contact().helical_angle(), s.rotation()];
                let station =
                    |s: &Equilibrium| self.station(Regime::Kept(balance), self.coordinates(place(s), s.load()));
                states.iter().map(station).collect()
            }
        };
        if let (Ends::Loads(load), None) = (ends, core_radius)
            && Ply::new(self.strands, stiffness_ratio)?.straight_holds(twist, load)
        {
            starts.push(self.station(Regime::start(self.contacts), [0.0; 4]));
        }
        Ok(starts)
    }

    /// Signed angle and rotation, the load that is found, and the beginning of the path.
    fn coordinates(&self, [angle, rotation]: [f64; 2], load: Load) -> Vector {
        let found = match self.from.ends {
            Ends::Loads(_) => 0.0,
            Ends::Rotation { .. } => load.moment,
            Ends::Length { .. } => load.force,
        };
        [angle, rotation, found, 0.0]
    }

    /// What is held along the path.
    #[must_use]
    pub const fn holding(&self) -> Holding {
        self.from.ends.holding()
    }

    /// The data at a share of the path.
    #[must_use]
    pub fn data(&self, along: f64) -> Data {
        let (a, b) = (&self.from, &self.to);
        let between = |x: f64, y: f64| x + along * (y - x);
        let twist = match (a.twist, b.twist) {
            (Twist::Pretwist(x), Twist::Pretwist(y)) => Twist::Pretwist(between(x, y)),
            (Twist::StrandTwist(x), Twist::StrandTwist(y)) => Twist::StrandTwist(between(x, y)),
            (twist, _) => twist,
        };
        let ends = match (a.ends, b.ends) {
            (Ends::Loads(x), Ends::Loads(y)) => {
                Ends::Loads(Load { force: between(x.force, y.force), moment: between(x.moment, y.moment) })
            }
            (Ends::Rotation { rotation: x, force: f }, Ends::Rotation { rotation: y, force: g }) => {
                Ends::Rotation { rotation: between(x, y), force: between(f, g) }
            }
            (Ends::Length { extension: x, moment: m }, Ends::Length { extension: y, moment: l }) => {
                Ends::Length { extension: between(x, y), moment: between(m, l) }
            }
            (ends, _) => ends,
        };
        Data {
            stiffness_ratio: between(a.stiffness_ratio, b.stiffness_ratio),
            twist,
            ends,
            core_radius: a.core_radius.zip(b.core_radius).map(|(x, y)| between(x, y)),
        }
    }
}

impl Data {
    fn check(&self, strands: u32) -> Result<(), DomainError> {
        Ply::new(strands, self.stiffness_ratio)?.check(self.twist, self.ends.given())?;
        if let Ends::Rotation { rotation, .. } = self.ends {
            DomainError::check(rotation.is_finite(), "rotation", rotation, "finite")?; // 0 may be passed
        } else {
            self.ends.check()?;
        }
        self.core_radius.map_or(Ok(()), |radius| check_core(radius).map(drop))
    }
}
