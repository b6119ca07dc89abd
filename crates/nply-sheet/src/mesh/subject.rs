//! Which ply is meant: a lay that is given, or one of the states that are found.

use nply::geometry::{Centreline, Contact, DensestHelix, HelicalAngle};
use nply::mechanics::{Equilibrium, SupportedState};
use nply::{Handedness, Scale};

use crate::spec::Value;
use crate::{Case, Datum, ErrorKind, Place, PreferredUnits, Shape, Spec, SpecError, Table};

/// A ply as a shape, with what is known of its strands; lengths in units of r.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Subject {
    /// The name given to it, or what it is.
    pub title: String,
    /// n.
    pub strands: u32,
    /// θ.
    pub angle: HelicalAngle,
    /// ρ = R/r.
    pub radius_ratio: f64,
    /// Which way it winds.
    pub handedness: Handedness,
    /// The contact of neighbours, where they touch.
    pub contact: Option<Contact>,
    /// The core's radius over r, where one is given.
    pub core_radius: Option<f64>,
    /// φ̄a, where it is known: by it material lines turn round the strands.
    pub pretwist: f64,
    /// What is known of every strand: name, dimension and value.
    pub values: Vec<(&'static str, crate::Measure, f64)>,
    /// Which of the states this is, from 1, and of how many; none for a lay that was given.
    pub state: Option<(usize, usize)>,
    /// r in m, where it is known.
    pub strand_radius: Option<f64>,
    /// r and B, where both are known.
    pub scale: Option<Scale>,
    /// The units the input was written in.
    pub units: PreferredUnits,
    /// The layers of a layered strand, from the inside; none of a ply.
    pub layers: Vec<LayerLine>,
    /// Where no units are known, how much r is in the input's bare unit of length: 1 of a ply, whose lengths are bare in strand radii.
    pub bare_radius: f64,
}

/// What a layer of a layered strand is, in a line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LayerLine {
    /// How many wires, or strands.
    pub rods: u32,
    /// Whether they are strands.
    pub strands: bool,
    /// Which way it winds.
    pub handedness: Handedness,
    /// Their lay angle, as they lie.
    pub angle: HelicalAngle,
    /// The gap between neighbours, in units of r: 0 where they touch.
    pub gap: f64,
    /// Whether no lay was given, and the one was taken at which neighbours touch or have the gap that is wanted.
    pub lay_is_found: bool,
}

impl LayerLine {
    /// Whether neighbours touch, to rounding.
    pub(super) fn is_touching(&self) -> bool {
        self.gap.abs() < 1e-9
    }
}

impl Subject {
    /// The ply of a description: its lay, where that is all that is said, else one of its states, counted from 1; the first whose strands
    /// need not pull on each other, if none is chosen.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`] and [`Spec::check_shape`], and where there is no such state.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::mesh::Subject;
    /// let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1")];
    /// let ply = Subject::of(&Spec::from_flags(flags)?, None)?;
    /// assert!((ply.angle.degrees() - 30.613).abs() < 1e-3);
    /// assert_eq!(ply.state, Some((1, 2)));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of(spec: &Spec, state: Option<usize>) -> Result<Self, SpecError> {
        let said = |table| spec.first_of(table).is_some();
        let loaded = [Table::Twist, Table::Load, Table::Ends, Table::Support].into_iter().any(said);
        let single = crate::case::strands(spec, 1)? == 1;
        if single || (said(Table::Lay) && !loaded) {
            if let Some(number) = state {
                let message =
                    format!("the lay alone is given, and state {number} of it cannot be chosen; leave it out");
                return Err(flag("state", ErrorKind::Contradiction, message));
            }
            return Self::of_shape(spec, spec.check_shape()?);
        }
        Self::of_case(spec, spec.check()?, state)
    }

    /// Of each layer whose lay was not given, which one was taken: a sentence.
    pub(super) fn found_lays(&self) -> Vec<String> {
        let found = self.layers.iter().enumerate().filter(|(_, layer)| layer.lay_is_found);
        let sentence = |(at, layer): (usize, &LayerLine)| {
            let rods = if layer.strands { "strands" } else { "wires" };
            let so = if layer.is_touching() { "just touch" } else { "have the gap that is wanted" };
            format!("No lay was given for layer {}: the one at which its {rods} {so} is taken.", at + 1)
        };
        found.map(sentence).collect()
    }

    /// The lay of a description, whatever else it says.
    pub(super) fn of_lay(spec: &Spec) -> Result<Self, SpecError> {
        Self::of_shape(spec, spec.check_shape()?)
    }

    fn of_shape(spec: &Spec, shape: Shape) -> Result<Self, SpecError> {
        let known = |radius_ratio, angle, contact: Option<Contact>| {
            let line = Centreline::helix(radius_ratio, angle, shape.hand.unwrap_or(Handedness::Right), 0.0);
            let line = line.map_err(|error| shape.locate(&error))?;
            Ok(Self {
                title: match (spec.get(Datum::Title).map(|entry| &entry.value), shape.strands) {
                    (Some(Value::Text(title)), _) => title.clone(),
                    (_, 1) => "the densest helix of a tube".to_owned(),
                    (_, n) => format!("{n} touching strands"),
                },
                strands: shape.strands,
                angle,
                radius_ratio,
                handedness: shape.hand.unwrap_or(Handedness::Right),
                contact,
                core_radius: spec
                    .get(Datum::CoreRadius)
                    .or_else(|| spec.get(Datum::CoreDiameter))
                    .map(|_| radius_ratio - 1.0),
                pretwist: 0.0,
                values: vec![
                    ("curvature", crate::Measure::PerLength, line.curvature()),
                    ("torsion", crate::Measure::PerLength, line.torsion()),
                ],
                state: None,
                strand_radius: shape.strand_radius,
                scale: None,
                units: shape.units.clone(),
                layers: Vec::new(),
                bare_radius: 1.0,
            })
        };
        match shape.lay {
            Some(lay) => {
                let contact = lay.contact(shape.strands).map_err(|error| shape.locate(&error))?;
                known(contact.radius_ratio(), contact.angle(), Some(contact))
            }
            None => {
                let helix = DensestHelix::new();
                known(helix.radius_ratio(), helix.angle(), None)
            }
        }
    }

    fn of_case(spec: &Spec, case: Case, state: Option<usize>) -> Result<Self, SpecError> {
        let solution = case.solve().map_err(|error| case.locate(&error))?;
        if solution.stretched.is_some() {
            let message = "shapes are those of strands that do not stretch: remove `stretch` (`nply support` gives lay and radius of those that do)";
            return Err(SpecError::new(ErrorKind::Contradiction, spec.place_of_stretch(), message));
        }
        let count = solution.supported.as_ref().map_or(solution.states.len(), |supported| supported.states.len());
        if count == 0 {
            let message = "no state is in equilibrium with these data: there is no shape to show";
            return Err(SpecError::new(ErrorKind::Domain, spec.head(), message));
        }
        let first = solution.states.iter().position(|state| !state.is_separated()).unwrap_or(0);
        let number = state.unwrap_or(first + 1);
        let missing = || {
            let are = if count == 1 { "there is one state".to_owned() } else { format!("there are {count} states") };
            flag("state", ErrorKind::Domain, format!("{are}, and no number {number}"))
        };
        let at = number.checked_sub(1).ok_or_else(missing)?;
        let mut ply = match &solution.supported {
            Some(supported) => Self::supported(&case, supported.states.get(at).ok_or_else(missing)?),
            None => Self::touching(&case, solution.states.get(at).ok_or_else(missing)?),
        };
        ply.state = Some((number, count));
        Ok(ply)
    }

    fn touching(case: &Case, state: &Equilibrium) -> Self {
        use crate::Measure::{ForcePerLength, PerLength};
        let contact = *state.contact();
        Self {
            title: case.title.clone().unwrap_or_else(|| format!("{} strands", case.strands)),
            strands: case.strands,
            angle: contact.angle(),
            radius_ratio: contact.radius_ratio(),
            handedness: state.handedness(),
            contact: Some(contact),
            core_radius: None,
            pretwist: state.pretwist(),
            values: vec![
                ("curvature", PerLength, contact.curvature()),
                ("torsion", PerLength, state.handedness().sign() * contact.torsion()),
                ("strand_twist", PerLength, state.strand_twist()),
                ("resultant_pressure", ForcePerLength, state.resultant_pressure()),
                ("interstrand_pressure", ForcePerLength, state.interstrand_pressure()),
            ],
            state: None,
            strand_radius: case.strand_radius,
            scale: case.scale,
            units: case.units.clone(),
            layers: Vec::new(),
            bare_radius: 1.0,
        }
    }

    fn supported(case: &Case, state: &SupportedState) -> Self {
        use crate::Measure::{ForcePerLength, PerLength};
        Self {
            title: case.title.clone().unwrap_or_else(|| format!("{} strands", case.strands)),
            strands: case.strands,
            angle: state.angle(),
            radius_ratio: state.radius_ratio(),
            handedness: state.handedness(),
            contact: Some(*state.touching()).filter(|_| state.neighbour_gap() <= 1e-12),
            core_radius: state.core_radius(),
            pretwist: state.pretwist(),
            values: vec![
                ("curvature", PerLength, state.curvature()),
                ("torsion", PerLength, state.torsion()),
                ("strand_twist", PerLength, state.strand_twist()),
                ("resultant_pressure", ForcePerLength, state.resultant_pressure()),
                ("interstrand_pressure", ForcePerLength, state.interstrand_pressure()),
                ("core_pressure", ForcePerLength, state.core_pressure()),
            ],
            state: None,
            strand_radius: case.strand_radius,
            scale: case.scale,
            units: case.units.clone(),
            layers: Vec::new(),
            bare_radius: 1.0,
        }
    }

    /// 2πρ/tan θ: the ply length of one turn of a strand, in units of r; infinite for straight strands.
    #[must_use]
    pub fn lay_length(&self) -> f64 {
        core::f64::consts::TAU * self.radius_ratio / self.angle.tan()
    }

    /// The least gap between the surfaces of neighbours, in units of r: 0 where they touch.
    #[must_use]
    pub fn neighbour_gap(&self) -> f64 {
        match (self.contact, Contact::at_angle(self.strands, self.angle)) {
            (None, Ok(touching)) => 2.0 * (self.radius_ratio / touching.radius_ratio() - 1.0),
            _ => 0.0,
        }
    }
}

/// A refusal of a flag that is not one of the keys.
pub(super) fn flag(name: &str, kind: ErrorKind, message: impl Into<String>) -> SpecError {
    SpecError::new(kind, Place::Flag(name.to_owned()), message)
}
