//! A state on a path, of whatever strands: what is said of it.

use core::f64::consts::TAU;
use core::fmt::Debug;

use nply::Handedness;
use nply::geometry::HelicalAngle;
use nply::mechanics::{Stability, Station, StretchStation, Support};

use crate::report::Measure;
use crate::report::item::{Item, item};

/// A state on a path.
pub(in crate::report) trait Stop: Copy + Debug + PartialEq + 'static {
    /// Every number, in the order of the report.
    const NUMBERS: &'static [Item<Self>];
    /// Those that a reader's table has whether they change or not.
    const ALWAYS: &'static [&'static str];

    fn along(&self) -> f64;
    fn hand(&self) -> Handedness;
    fn lay_angle(&self) -> HelicalAngle;
    fn carried(&self) -> Support;
    fn verdict(&self) -> Option<Stability>;
    /// p₁, p_c and p, as far as they are known
    fn pressures(&self) -> [f64; 3];
    fn has_core(&self) -> bool;

    /// Whether neighbours would have to pull.
    fn separated(&self) -> bool {
        self.pressures()[0] < 0.0
    }

    /// The same, and not only by the rounding of a pressure that is 0.
    fn pulls(&self) -> bool {
        const NOTHING: f64 = 1e-14;
        self.pressures()[0] < -NOTHING
    }
}

impl Stop for Station {
    const NUMBERS: &'static [Item<Self>] = {
        use Measure::{Degrees, Force, ForcePerLength, Length, Moment, Number, TurnsPerLength};
        &[
            item("", "helical_angle_deg", "angle", Degrees, |s| Some(s.angle.degrees())),
            item("", "radius_ratio", "R/r", Number, |s| Some(s.radius_ratio)),
            item("", "extension", "length ratio", Number, |s| Some(s.extension())),
            item("", "rotation", "", Number, |s| Some(s.rotation())),
            item("", "turns_per_strand_length", "turns", TurnsPerLength, |s| Some(s.rotation().abs() / TAU)),
            item("", "curvature", "", Measure::PerLength, |s| Some(s.curvature())),
            item("", "pretwist", "pretwist", Number, |s| Some(s.pretwist())),
            item("", "pretwist_per_length", "pretwist", TurnsPerLength, |s| Some(s.pretwist() / TAU)),
            item("", "strand_twist", "r u₃", Number, |s| Some(s.strand_twist())),
            item("", "strand_twist_per_length", "strand twist", TurnsPerLength, |s| Some(s.strand_twist() / TAU)),
            item("", "stiffness_ratio", "C/B", Number, |s| Some(s.stiffness_ratio)),
            item("", "core_radius", "core", Length, |s| s.core_radius),
            item("", "force", "force", Force, |s| Some(s.load.force)),
            item("", "moment", "moment", Moment, |s| Some(s.load.moment)),
            item("", "resultant_pressure", "", ForcePerLength, |s| Some(s.resultant_pressure)),
            item("", "interstrand_pressure", "p₁", ForcePerLength, |s| Some(s.interstrand_pressure)),
            item("", "core_pressure", "p_c", ForcePerLength, |s| s.core_radius.map(|_| s.core_pressure)),
        ]
    };
    const ALWAYS: &'static [&'static str] =
        &["helical_angle_deg", "radius_ratio", "force", "moment", "interstrand_pressure"];

    fn along(&self) -> f64 {
        self.along
    }

    fn hand(&self) -> Handedness {
        self.handedness
    }

    fn lay_angle(&self) -> HelicalAngle {
        self.angle
    }

    fn carried(&self) -> Support {
        self.support
    }

    fn verdict(&self) -> Option<Stability> {
        self.stability
    }

    fn pressures(&self) -> [f64; 3] {
        [self.interstrand_pressure, self.core_pressure, self.resultant_pressure]
    }

    fn has_core(&self) -> bool {
        self.core_radius.is_some()
    }
}

impl Stop for StretchStation {
    const NUMBERS: &'static [Item<Self>] = {
        use Measure::{Degrees, Force, ForcePerLength, Length, Moment, Number, TurnsPerLength};
        &[
            item("", "helical_angle_deg", "angle", Degrees, |s| Some(s.state.angle().degrees())),
            item("", "radius_ratio", "R/r", Number, |s| Some(s.state.radius_ratio())),
            item("", "strain", "strain", Number, |s| Some(s.state.strain())),
            item("", "bending_strain", "bending", Number, |s| Some(s.state.bending())),
            item("", "extension", "length ratio", Number, |s| Some(s.state.extension())),
            item("", "rotation", "", Number, |s| Some(s.state.rotation())),
            item("", "turns_per_strand_length", "turns", TurnsPerLength, |s| Some(s.state.rotation().abs() / TAU)),
            item("", "neighbour_gap", "", Length, |s| Some(s.state.neighbour_gap())),
            item("", "core_gap", "gap to core", Length, |s| s.state.core_gap()),
            item("", "pretwist", "pretwist", Number, |s| Some(pretwist(s))),
            item("", "pretwist_per_length", "pretwist", TurnsPerLength, |s| Some(pretwist(s) / TAU)),
            item("", "strand_twist", "r u₃", Number, |s| Some(s.state.strand_twist())),
            item("", "strand_twist_per_length", "strand twist", TurnsPerLength, |s| Some(s.state.strand_twist() / TAU)),
            item("", "force", "force", Force, |s| Some(s.state.load().force)),
            item("", "moment", "moment", Moment, |s| Some(s.state.load().moment)),
            item("", "core_force", "", Force, |s| s.has_core().then(|| s.state.core_force())),
            item("", "core_moment", "", Moment, |s| s.has_core().then(|| s.state.core_moment())),
            item("", "interstrand_pressure", "p₁", ForcePerLength, |s| Some(s.state.interstrand_pressure())),
            item("", "core_pressure", "p_c", ForcePerLength, |s| s.has_core().then(|| s.state.core_pressure())),
        ]
    };
    const ALWAYS: &'static [&'static str] =
        &["helical_angle_deg", "radius_ratio", "strain", "force", "moment", "interstrand_pressure", "core_gap"];

    fn along(&self) -> f64 {
        self.along
    }

    fn hand(&self) -> Handedness {
        self.state.handedness()
    }

    fn lay_angle(&self) -> HelicalAngle {
        self.state.angle()
    }

    fn carried(&self) -> Support {
        self.state.support()
    }

    fn verdict(&self) -> Option<Stability> {
        Some(self.stability)
    }

    fn pressures(&self) -> [f64; 3] {
        [self.state.interstrand_pressure(), self.state.core_pressure(), 0.0]
    }

    fn has_core(&self) -> bool {
        self.state.ply().core().is_some()
    }
}

/// What was put into the strands before they were joined.
fn pretwist(station: &StretchStation) -> f64 {
    let state = &station.state;
    state.strand_twist() - state.rotation() * state.angle().cos()
}
