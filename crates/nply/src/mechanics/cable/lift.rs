//! How far a cable is from a layer that lifts off: the onset of birdcaging.

use super::layer::LayerSupport;
use super::state::CableState;
use super::{Cable, CableGrips};
use crate::Handedness;

/// Which contact lets go.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LetsGo {
    /// A layer lifts off what is below it.
    Below,
    /// Neighbours part.
    Neighbours,
}

/// The load at which a layer stops pressing.
#[derive(Clone, Debug, PartialEq)]
pub struct LiftOff {
    /// Which layer, 0 the innermost.
    pub layer: usize,
    /// What lets go.
    pub lets_go: LetsGo,
    /// The cable there.
    pub state: CableState,
}

/// Strains further down than this are not looked at: cables are long past linear there.
const LEAST_STRAIN: f64 = -0.1;

impl CableState {
    /// The layer that presses least for its share, and its pressing force in units of the cable's EA over its radius.
    fn least_pressing(&self) -> Option<(usize, LetsGo, f64)> {
        let unit = self.unchecked_stiffness().axial / self.outer_radius();
        let of = |(i, layer): (usize, &super::LayerState)| match layer.support {
            LayerSupport::Below => (i, LetsGo::Below, layer.pressure_below / unit),
            LayerSupport::Neighbours => (i, LetsGo::Neighbours, layer.interstrand_pressure / unit),
            LayerSupport::Both if layer.interstrand_pressure < layer.pressure_below => {
                (i, LetsGo::Neighbours, layer.interstrand_pressure / unit)
            }
            LayerSupport::Both => (i, LetsGo::Below, layer.pressure_below / unit),
        };
        self.layers().iter().enumerate().map(of).min_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// Where a layer first lifts off, or its rods part, as the force falls from here on: with ends that cannot turn, or under the moment of
    /// now. `None` where none does before a strain of −0.1, and where one has done so already.
    ///
    /// Wires that were preformed lie on the core with nothing at no load and lift off under the least thrust; wires that were not press by
    /// themselves and stand some of it. Friction, wrapping and jackets, which hold real cables together, are not in it.
    ///
    /// ```
    /// use nply::mechanics::{Cable, CableGrips, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let six = |preforming| Layer {
    ///     strands: 6,
    ///     rod: Rod::solid_round(2.5, 200e3, 0.3).unwrap(),
    ///     handedness: Handedness::Right,
    ///     lay: WireLay::Length(120.0),
    ///     preforming,
    ///     pretwist: 0.0,
    /// };
    /// let king = Rod::solid_round(2.7, 200e3, 0.3)?;
    /// let opens = |preforming| {
    ///     let strand = Cable::new(Some(king), &[six(preforming)])?;
    ///     let pulled = strand.loaded(CableGrips::Turned { force: 50e3, turning: 0.0 })?;
    ///     Ok::<_, nply::DomainError>(pulled.lift_off(true).map(|lift| lift.state.force()))
    /// };
    /// assert!(opens(1.0)?.is_some_and(|force| force.abs() < 1e-3)); // at no load
    /// assert!(opens(0.9)?.is_some_and(|force| force < -1e3)); // straighter wires stand some thrust
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn lift_off(&self, ends_cannot_turn: bool) -> Option<LiftOff> {
        let (layer, lets_go, pressing) = self.least_pressing().filter(|(.., pressing)| *pressing >= 0.0)?;
        if pressing == 0.0 {
            return Some(LiftOff { layer, lets_go, state: self.clone() }); // right here
        }
        let turned = |strain: f64, turning: f64| self.cable().loaded(CableGrips::Clamped { strain, turning }).ok();
        let at = |strain: f64| {
            let mut here = turned(strain, self.turning())?;
            for _ in 0..30 {
                if ends_cannot_turn {
                    break;
                }
                let change = (self.moment() - here.moment()) / here.unchecked_stiffness().torsional;
                here = turned(strain, here.turning() + change)?;
                if change.abs() <= 1e-14 * (1e-3 / here.outer_radius() + here.turning().abs()) {
                    break;
                }
            }
            Some(here)
        };
        // the same contact as at first: where another closes on the way it presses
        let presses = |state: &CableState| state.least_pressing().is_some_and(|(.., pressing)| pressing > 0.0);
        let (mut above, mut step) = (self.strain(), 1e-5);
        let mut below = loop {
            let strain = above - step;
            if strain < LEAST_STRAIN {
                return None;
            }
            if !presses(&at(strain)?) {
                break strain;
            }
            (above, step) = (strain, 1.5 * step);
        };
        for _ in 0..100 {
            let middle = 0.5 * (above + below);
            if middle <= below || middle >= above {
                break;
            }
            if presses(&at(middle)?) {
                above = middle;
            } else {
                below = middle;
            }
        }
        let state = at(below)?;
        let (layer, lets_go, _) = state.least_pressing()?;
        Some(LiftOff { layer, lets_go, state })
    }

    /// Where a layer first lifts off, or its rods part, as the ends are turned from here on, the force kept: right-handed for
    /// [`Handedness::Right`]. `None` where none does before a layer is nearly unlaid or no state holds the force, and where one has done so
    /// already.
    ///
    /// ```
    /// use nply::mechanics::{Cable, CableGrips, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let six = Layer {
    ///     strands: 6,
    ///     rod: Rod::solid_round(2.5, 200e3, 0.3)?,
    ///     handedness: Handedness::Right,
    ///     lay: WireLay::Length(220.0),
    ///     preforming: 1.0,
    ///     pretwist: 0.0,
    /// };
    /// let strand = Cable::new(Some(Rod::solid_round(2.6, 200e3, 0.3)?), &[six])?;
    /// let pulled = strand.loaded(CableGrips::Turned { force: 20e3, turning: 0.0 })?;
    /// // unlaid, its wires come off the king wire; laid up further they press the more
    /// let unlaid = pulled.lift_off_by_turning(Handedness::Left).expect("it opens");
    /// assert!(unlaid.state.turning() < 0.0 && (unlaid.state.force() - 20e3).abs() < 1e-9);
    /// assert!(unlaid.state.layers()[0].pressure_below.abs() < 1e-6);
    /// assert!(pulled.lift_off_by_turning(Handedness::Right).is_none());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn lift_off_by_turning(&self, sense: Handedness) -> Option<LiftOff> {
        let (layer, lets_go, pressing) = self.least_pressing().filter(|(.., pressing)| *pressing >= 0.0)?;
        if pressing == 0.0 {
            return Some(LiftOff { layer, lets_go, state: self.clone() }); // right here
        }
        let force = self.force();
        let at = |turning: f64| self.cable().loaded(CableGrips::Turned { force, turning }).ok();
        let presses = |state: &CableState| state.least_pressing().is_some_and(|(.., pressing)| pressing > 0.0);
        // turns that would lay the straightest layer straight, and as many more; the first step is small against what cables stand
        let most = self.layers().iter().map(|layer| layer.angle.tan() / layer.radius).fold(f64::INFINITY, f64::min);
        let (mut pressed, mut step) = (self.turning(), 1e-4 * most);
        let mut lifted = loop {
            let turning = pressed + sense.sign() * step;
            if (turning - self.turning()).abs() > most {
                return None;
            }
            if !presses(&at(turning)?) {
                break turning;
            }
            (pressed, step) = (turning, 1.5 * step);
        };
        for _ in 0..100 {
            let middle = 0.5 * (pressed + lifted);
            if (middle - pressed).abs().min((lifted - middle).abs()) <= 0.0 {
                break; // the two are neighbouring numbers
            }
            if presses(&at(middle)?) {
                pressed = middle;
            } else {
                lifted = middle;
            }
        }
        let state = at(lifted)?;
        let (layer, lets_go, _) = state.least_pressing()?;
        Some(LiftOff { layer, lets_go, state })
    }
}

impl Cable {
    /// The same cable with another lay or pretwist of one layer.
    pub(super) fn with_layer(&self, index: usize, layer: super::Layer) -> Option<Self> {
        let mut layers: Vec<super::Layer> = self.layers().copied().collect();
        *layers.get_mut(index)? = layer;
        Self::new(self.core, &layers).ok()
    }
}
