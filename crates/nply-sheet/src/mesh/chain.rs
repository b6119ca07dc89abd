//! Centrelines as chains of nodes.

use nply::geometry::{Course, Vector};

use super::subject::{Subject, flag};
use super::{Assembly, Element};
use crate::{ErrorKind, SpecError};

/// The nodes of one centreline.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Its name: `strand-1`, `core`.
    pub name: String,
    /// The strand's number from 1; 0 for a core.
    pub number: u32,
    /// The wire's radius, in units of r.
    pub radius: f64,
    /// The nodes, in units of r.
    pub points: Vec<Vector>,
    /// Unit tangents of the centreline at the nodes.
    pub tangents: Vec<Vector>,
    /// Arclengths of the centreline at the nodes, in units of r.
    pub arclengths: Vec<f64>,
    /// The beams between the nodes: of one chord each, or of two.
    pub element: Element,
}

/// How far apart nodes stand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spacing {
    /// Elements per lay length: 48, if nothing is said.
    pub per_lay_length: Option<u32>,
    /// Of how many nodes they are.
    pub element: Element,
}

/// More nodes than this are refused.
const MOST_NODES: f64 = 20_000_000.0;

/// The nodes of every wire of an assembly, on its centreline, from end to end.
///
/// # Errors
/// [`SpecError`] for too many nodes.
///
/// ```
/// use nply_sheet::Spec;
/// use nply_sheet::mesh::{Assembly, Spacing, Subject, Wanted, chains};
/// let ply = Subject::of(&Spec::from_flags([("strands", "3"), ("helical-angle", "20 deg")])?, None)?;
/// let assembly = Assembly::of(&ply, &Wanted { lay_lengths: Some(2.0), ..Wanted::default() })?;
/// let chains = chains(&ply, &assembly, Spacing { per_lay_length: Some(16), ..Spacing::default() })?;
/// assert_eq!((chains.len(), chains[0].points.len()), (3, 33));
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
pub fn chains(ply: &Subject, assembly: &Assembly, spacing: Spacing) -> Result<Vec<Chain>, SpecError> {
    const PER_LAY_LENGTH: u32 = 48;
    let [low, high] = assembly.heights();
    let per = f64::from(spacing.per_lay_length.unwrap_or(PER_LAY_LENGTH));
    // straight strands have one turn, however long they are
    let turns = Some((high - low) / ply.lay_length()).filter(|turns| *turns > 0.0).unwrap_or(1.0);
    // of layers each wire has its own, and no fewer than the outermost
    let most = assembly.wires.iter().map(|wire| {
        let [start, end] = wire.tube.parameters();
        let own = (end - start) * wire.tube.course().turning() / core::f64::consts::TAU;
        if ply.layers.is_empty() { turns } else { turns.max(own) }
    });
    let counts: Vec<f64> = most.map(|turns| libm::ceil(turns * per - 1e-9).max(1.0)).collect();
    let chords = spacing.element.chords();
    if counts.iter().sum::<f64>() * f64::from(chords) > MOST_NODES {
        let message = format!("more than {MOST_NODES} nodes would be needed: give a shorter length, or fewer elements");
        return Err(flag("elements-per-pitch", ErrorKind::Domain, message));
    }
    let mut count = 0;
    Ok(assembly
        .wires
        .iter()
        .zip(counts)
        .map(|(wire, elements)| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held below twenty million")]
            let elements = elements as u32 * chords;
            let [start, end] = wire.tube.parameters();
            let at = |k: u32| start + (end - start) * f64::from(k) / f64::from(elements);
            let places = (0..=elements).map(|k| wire.tube.course().place(at(k)));
            let core = wire.name == "core";
            count += u32::from(!core);
            Chain {
                name: wire.name.clone(),
                number: if core { 0 } else { count },
                radius: wire.tube.radius(),
                points: places.clone().map(|place| place.position).collect(),
                tangents: places.map(|place| place.tangent).collect(),
                arclengths: arclengths(wire.tube.course(), (0..=elements).map(at)),
                element: spacing.element,
            }
        })
        .collect())
}

/// Arclengths of a course at parameters, counted from t = 0 of a helix, and from the first of them of a helix about a helix.
pub(super) fn arclengths(course: &Course, parameters: impl Iterator<Item = f64>) -> Vec<f64> {
    if course.is_uniform() {
        return parameters.collect();
    }
    let mut last: Option<(f64, f64)> = None;
    let next = parameters.map(|t| {
        let s = last.map_or(0.0, |(before, s)| s + course.length(before, t));
        last = Some((t, s));
        s
    });
    next.collect()
}
