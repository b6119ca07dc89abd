//! Loads under which a layer lies on what is below and on its neighbours, both of which push.
//!
//! At such a strain and turning the energy has a kink: its slopes on either side are the loads at which one of the two contacts carries all.
//! Between them both carry, and the cable neither stretches nor turns as the loads change from one side to the other. The state is the least
//! energy on the kink, and what holds it there, a multiplier for each layer, is what its neighbours push apart with.

use super::state::{CableGrips, CableState, Lost};
use super::{Cable, LayerState, LayerSupport};
use crate::numerics::jet2::Jet2;
use crate::numerics::linear::solve;

/// Layers that lie on both, and what of the inward force on each its neighbours bear.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sharing {
    layers: Vec<usize>,
    pushes: [f64; 2],
}

impl Sharing {
    pub(super) const NONE: Self = Self { layers: Vec::new(), pushes: [0.0; 2] };

    /// What of the inward force on a layer its neighbours bear; `None` unless the layer lies on both.
    pub(super) fn pushes(&self, layer: usize) -> Option<f64> {
        self.layers.iter().zip(self.pushes).find_map(|(at, push)| (*at == layer).then_some(push))
    }
}

/// Where Newton's iteration on a kink ends.
enum Kink {
    /// Both contacts push.
    Shared(Box<CableState>),
    /// One would have to pull: the state lies beside the kink, the way in which this strain and turning are.
    Beside([f64; 2]),
}

/// How far beside a kink a search begins, in strain and in turning times the cable's radius: more than rounding, less than a layer's gaps.
const BESIDE: f64 = 1e-9;

impl Cable {
    /// The state on a kink of the energy or right beside it, if that is why none was found.
    pub(super) fn shared(&self, grips: CableGrips, why: Lost) -> Result<CableState, Lost> {
        let Lost::Shared { strain, turning, layers } = &why else { return Err(why) };
        let singles = layers.iter().map(|&layer| vec![layer]);
        let pairs = layers.iter().flat_map(|&a| layers.iter().filter(move |&&b| a < b).map(move |&b| vec![a, b]));
        let found = singles.chain(pairs).find_map(|which| match self.on_kink(grips, [*strain, *turning], which)? {
            Kink::Shared(state) => Some(state.under(grips)),
            Kink::Beside(place) => self.sought(grips, place).ok(),
        });
        found.ok_or(why)
    }

    /// Newton's iteration for strain, turning and what the neighbours push with, near a place where these layers change over.
    fn on_kink(&self, grips: CableGrips, near: [f64; 2], layers: Vec<usize>) -> Option<Kink> {
        let (force, moment) = match grips {
            CableGrips::Loads { force, moment } => (force, Some(moment)),
            CableGrips::Turned { force, .. } => (force, None),
            CableGrips::Clamped { .. } => return None, // at one strain and turning alone
        };
        let two = layers.len() == 2;
        if two && moment.is_none() {
            return None;
        }
        let [mut strain, mut turning] = near;
        let mut sharing = Sharing { layers, pushes: [0.0; 2] };
        for _ in 0..40 {
            let here = self.at(strain, turning, &sharing)?;
            let e = here.energy();
            let first = here.meetings().first().copied()?;
            let second = here.meetings().get(1).copied().unwrap_or(Jet2::constant(0.0));
            let free = if moment.is_some() { 1.0 } else { 0.0 };
            let step = solve(
                [
                    [e.aa, free * e.ab, first.a, second.a],
                    [free * e.ab, if moment.is_some() { e.bb } else { 1.0 }, free * first.b, free * second.b],
                    [first.a, free * first.b, 0.0, 0.0],
                    [second.a, second.b, 0.0, if two { 0.0 } else { 1.0 }],
                ],
                [force - e.a, moment.map_or(0.0, |moment| moment - e.b), -first.value, -second.value],
            )?;
            strain += step[0];
            turning += step[1];
            sharing.pushes[0] += step[2];
            sharing.pushes[1] += step[3];
            // turns over the cable's own length
            let moved = step[0].abs().max(step[1].abs() * here.outer_radius());
            if moved <= 1e-14 {
                return self.end(strain, turning, &sharing, free);
            }
        }
        None
    }

    /// Whether the layers that share push both ways and all others lie as they would by themselves; or, of one layer, on which side it lies.
    fn end(&self, strain: f64, turning: f64, sharing: &Sharing, free: f64) -> Option<Kink> {
        let (state, beside) = (self.at(strain, turning, sharing)?, self.at(strain, turning, &Sharing::NONE)?);
        let alike = |(i, (layer, alone)): (usize, (&LayerState, &LayerState))| {
            sharing.pushes(i).is_some() || layer.support == alone.support
        };
        if !state.layers().iter().zip(beside.layers()).enumerate().all(alike) {
            return None;
        }
        let mut sharers = state.layers().iter().filter(|layer| layer.support == LayerSupport::Both);
        if sharers.clone().all(|layer| layer.pressure_below >= 0.0 && layer.interstrand_pressure >= 0.0) {
            return Some(Kink::Shared(Box::new(state)));
        }
        let ([meeting], Some(layer), None) = (state.meetings(), sharers.next(), sharers.next()) else { return None };
        // neighbours that would have to pull stand apart, on the side where the meeting is negative
        let side = if layer.interstrand_pressure < 0.0 { -1.0 } else { 1.0 };
        let (a, b) = (meeting.a, free * meeting.b / state.outer_radius());
        let length = libm::hypot(a, b);
        let (a, b) = (a / length, b / length / state.outer_radius());
        Some(Kink::Beside([strain + side * BESIDE * a, turning + side * BESIDE * b]))
    }
}
