//! Following a state of strands that stretch, as twist, loads and displacements change.

use super::course::Stretching;
use super::grips::{Axial, Grips, Turning};
use super::ply::ExtensiblePly;
use super::response::Clamped;
use super::state::ExtensibleState;
use crate::DomainError;
use crate::mechanics::path::{Regime, Stop, Walk};
use crate::mechanics::{Load, Route, Stability, Trace, Twist};

/// What is given besides strands and core: the twist, and how the ends are held.
///
/// ```
/// use nply::mechanics::{Load, StretchData, Twist};
/// let pulled = StretchData { twist: Twist::Pretwist(0.0), grips: Load { force: 1.0, moment: 0.0 }.into() };
/// assert_ne!(pulled, StretchData { grips: Load::NONE.into(), ..pulled });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchData {
    /// Pretwist, or the strands' own twist.
    pub twist: Twist,
    /// A load or a displacement along and around, each by itself.
    pub grips: Grips,
}

/// A straight line from one set of data to another, for one ply whose strands stretch; contacts push only.
///
/// ```
/// use nply::mechanics::{
///     Event, ExtensiblePly, FormedLay, Load, Mark, Route, StretchData, StretchPath, StretchingStrand, Support, Twist, WorkingCore,
/// };
/// use nply::{Handedness, geometry::HelicalAngle};
/// // a seven-wire strand, half preformed, from tension to thrust: its wires lift off the king wire while it is still pulled
/// let lay = FormedLay {
///     handedness: Handedness::Right,
///     angle: HelicalAngle::new(0.25)?,
///     radius_ratio: 2.1,
///     preforming: 0.5,
/// };
/// let strand = ExtensiblePly::new(6, StretchingStrand::solid_round(0.3)?)?
///     .with_core(WorkingCore::new(1.1, 4.84, 1.126, 0.3)?)?
///     .formed_in(lay)?;
/// let at = |force| StretchData { twist: Twist::Pretwist(0.0), grips: Load { force, moment: 0.0 }.into() };
/// let path = StretchPath::new(&strand, at(1.0), at(-0.1))?;
/// let starts = path.starts()?;
/// let start = starts.iter().find(|start| start.state.support() == Support::Core).expect("on the core");
/// let trace = path.trace(start, &Route::default())?;
/// let lifts = |event: &&Event<_>| event.mark == Mark::ContactChange(Support::Free);
/// let event = trace.events.iter().find(lifts).expect("wires lift off");
/// let verge = strand.parting_at_moment(Support::Core, Twist::Pretwist(0.0), 0.0)?;
/// let force = event.station.state.load().force;
/// assert!(verge.iter().any(|state| (state.load().force - force).abs() < 1e-9));
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchPath {
    ply: ExtensiblePly,
    from: StretchData,
    to: StretchData,
}

/// A state on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchStation {
    /// The share of the path: 0 at its beginning, 1 at its end.
    pub along: f64,
    /// The state; straight strands have the angle 0 and an infinite lay length.
    pub state: ExtensibleState,
    /// Among uniform plies with the ends held as on this path.
    pub stability: Stability,
}

impl Stop for StretchStation {
    fn along(&self) -> f64 {
        self.along
    }

    fn put_along(&mut self, along: f64) {
        self.along = along;
    }

    fn signed_angle(&self) -> f64 {
        self.state.handedness().sign() * self.state.angle().radians()
    }

    fn turned(&self) -> f64 {
        self.state.rotation()
    }

    fn stability(&self) -> Option<Stability> {
        Some(self.stability)
    }
}

impl StretchPath {
    /// From data to data.
    ///
    /// # Errors
    /// [`DomainError`] on `axial_stiffness` if the strands do not stretch, whose paths are [`Path`](crate::mechanics::Path)s; on data out
    /// of range; and on `path` unless both ends give the same kinds of data: the same kind of twist, ends held in the same way.
    pub fn new(ply: &ExtensiblePly, from: StretchData, to: StretchData) -> Result<Self, DomainError> {
        let alpha = ply.strand().axial_stiffness();
        DomainError::check(
            ply.strand().stretches(),
            "axial_stiffness",
            alpha,
            "finite on a path of strands that stretch",
        )?;
        for StretchData { twist, grips } in [from, to] {
            let (Twist::Pretwist(given) | Twist::StrandTwist(given)) = twist;
            DomainError::check(given.is_finite(), "twist", given, "finite")?;
            match grips.turning {
                // no rotation at all may be passed on the way
                Turning::Rotation(rotation) => {
                    DomainError::check(rotation.is_finite(), "rotation", rotation, "finite")?;
                    Grips { turning: Turning::Moment(0.0), ..grips }.check(true)?;
                }
                Turning::Moment(_) => grips.check(true)?,
            }
        }
        let same_twist = matches!(
            (from.twist, to.twist),
            (Twist::Pretwist(_), Twist::Pretwist(_)) | (Twist::StrandTwist(_), Twist::StrandTwist(_))
        );
        let same_grips = from.clamped() == to.clamped();
        let allowed = "between data of the same kinds: twist, holding of the ends";
        DomainError::check(same_twist && same_grips, "path", f64::NAN, allowed)?;
        Ok(Self { ply: *ply, from, to })
    }

    /// Every state at the beginning of the path from which it can be followed, straight strands last where they hold.
    ///
    /// # Errors
    /// As [`ExtensiblePly::states`].
    pub fn starts(&self) -> Result<Vec<StretchStation>, DomainError> {
        let StretchData { twist, grips } = self.from;
        let station =
            |state: ExtensibleState| StretchStation { along: 0.0, state, stability: state.stability(self.held()) };
        let mut starts: Vec<_> = self.ply.states(twist, grips)?.into_iter().map(station).collect();
        starts.extend(Stretching::new(self).straight());
        Ok(starts)
    }

    /// Follows the branch from a start on it, by pseudo-arclength continuation in angle, rotation, strain and share of the path; as
    /// [`Path::trace`](crate::mechanics::Path::trace), whose walk it is.
    ///
    /// Strands stretched to less than half or more than double their length end it, and so do held displacements that leave no motion:
    /// where no more turns fit in at the length that is held, the loads grow without bound.
    ///
    /// # Errors
    /// [`DomainError`] on `step`, `window`, `curvature_limit`, `strain_limit`, and on `start` if it is no state of this path.
    pub fn trace(&self, start: &StretchStation, route: &Route) -> Result<Trace<StretchStation>, DomainError> {
        let course = Stretching::new(self);
        Walk::from(&course, route, Regime::On(start.state.support()), course.place(&start.state))
    }

    /// The ply.
    #[must_use]
    pub const fn ply(&self) -> &ExtensiblePly {
        &self.ply
    }

    /// Which displacements are held along the path.
    #[must_use]
    pub const fn held(&self) -> Clamped {
        self.from.clamped()
    }

    /// The data at a share of the path.
    #[must_use]
    pub fn data(&self, along: f64) -> StretchData {
        let between = |x: f64, y: f64| x + along * (y - x);
        let [a, b] = [self.from, self.to].map(StretchData::numbers);
        self.from.with([0, 1, 2].map(|i| between(a[i], b[i])))
    }

    /// What the data's three numbers change by from one end to the other: twist, along, around.
    pub(super) fn change(&self) -> [f64; 3] {
        let [a, b] = [self.from, self.to].map(StretchData::numbers);
        [0, 1, 2].map(|i| b[i] - a[i])
    }

    /// The same path from a share of it on.
    pub(super) fn past(&self, along: f64) -> Self {
        Self { from: self.data(along), ..*self }
    }
}

impl StretchData {
    const fn clamped(&self) -> Clamped {
        Clamped {
            length: matches!(self.grips.axial, Axial::Extension(_)),
            rotation: matches!(self.grips.turning, Turning::Rotation(_)),
        }
    }

    /// Twist, force or extension, moment or rotation.
    const fn numbers(self) -> [f64; 3] {
        let (Twist::Pretwist(twist) | Twist::StrandTwist(twist)) = self.twist;
        let (Axial::Force(along) | Axial::Extension(along)) = self.grips.axial;
        let (Turning::Moment(around) | Turning::Rotation(around)) = self.grips.turning;
        [twist, along, around]
    }

    /// The same kinds of data, of other size.
    const fn with(self, [twist, along, around]: [f64; 3]) -> Self {
        Self {
            twist: match self.twist {
                Twist::Pretwist(_) => Twist::Pretwist(twist),
                Twist::StrandTwist(_) => Twist::StrandTwist(twist),
            },
            grips: Grips {
                axial: match self.grips.axial {
                    Axial::Force(_) => Axial::Force(along),
                    Axial::Extension(_) => Axial::Extension(along),
                },
                turning: match self.grips.turning {
                    Turning::Moment(_) => Turning::Moment(around),
                    Turning::Rotation(_) => Turning::Rotation(around),
                },
            },
        }
    }

    /// The loads given; one that has to be found is 0.
    pub(super) const fn load(&self) -> Load {
        self.grips.given()
    }
}
