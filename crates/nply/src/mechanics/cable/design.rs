//! The lay, or the pretwist, that a cable should have.

use core::f64::consts::TAU;

use super::{Cable, CableState, Layer, LayerSupport};
use crate::DomainError;
use crate::geometry::WireLay;

/// A lay that a layer could have, and what the cable is then.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DesignedLay {
    /// Of the layer that gives way.
    pub lay_length: f64,
    /// The cable laid so, free of load.
    pub laid: CableState,
    /// Whether that layer, and every one above it, lies on what is below. Where one does not, its rods would overlap there and carry each other
    /// instead, about something loose: a balance on paper, and no cable that a machine lays.
    pub fits: bool,
}

impl Cable {
    /// Lays of one layer (0 the innermost) at which the cable has a wanted torque factor as laid (0: a pull asks for no moment), longest
    /// first; layers above are laid on what that layer becomes. Empty where no lay does. Of each is told whether it [fits](DesignedLay::fits).
    ///
    /// Lays are looked at from 1000 outer diameters down to the shortest the layer can have, in 400 steps of equal ratio of tan θ; two lays
    /// closer to each other than that may be missed together.
    ///
    /// # Errors
    /// [`DomainError`] on `layer` unless the cable has it, and on `torque_factor` unless finite.
    ///
    /// ```
    /// use nply::mechanics::{Cable, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let wire = Rod::solid_round(1.0, 200e3, 0.3)?;
    /// let layer = |strands, handedness, lay_length| Layer {
    ///     strands,
    ///     rod: wire,
    ///     handedness,
    ///     lay: WireLay::Length(lay_length),
    ///     preforming: 1.0,
    ///     pretwist: 0.0,
    /// };
    /// let king = Rod::solid_round(1.05, 200e3, 0.3)?;
    /// let cable = Cable::new(Some(king), &[layer(6, Handedness::Left, 60.0), layer(12, Handedness::Right, 60.0)])?;
    /// let lays = cable.lays_for_torque_factor(1, 0.0)?;
    /// assert!(lays[0].laid.torque_factor().is_some_and(|factor| factor.abs() < 1e-12));
    /// assert!(lays[0].fits && !lays[1].fits); // the second is so steep that twelve wires do not go round
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn lays_for_torque_factor(&self, layer: usize, torque_factor: f64) -> Result<Vec<DesignedLay>, DomainError> {
        DomainError::check(torque_factor.is_finite(), "torque_factor", torque_factor, "finite")?;
        let laid = self.layer(layer)?;
        let outer = 2.0 * self.outer_radius();
        let laid_at = |lay_length: f64| {
            let cable = self.with_layer(layer, Layer { lay: WireLay::Length(lay_length), ..laid })?;
            cable.laid().ok()
        };
        let excess = |lay_length: f64| Some(laid_at(lay_length)?.torque_factor()? - torque_factor);
        const STEPS: i32 = 400;
        let (long, short) = (1e3 * outer, 2.0 * f64::from(laid.strands) * laid.rod.radius());
        let ratio = libm::exp(libm::log(short / long) / f64::from(STEPS));
        let mut found = Vec::new();
        let mut before: Option<(f64, f64)> = None;
        let mut lay_length = long;
        for _ in 0..STEPS {
            let here = excess(lay_length).filter(|value| value.is_finite()).map(|value| (lay_length, value));
            if let (Some((above, a)), Some((below, b))) = (before, here)
                && (a > 0.0) != (b > 0.0)
            {
                let lay_length = halved(above, below, a > 0.0, &excess);
                // the factor jumps where a layer leaves what is below: a change of sign there is no root
                if excess(lay_length).is_some_and(|rest| rest.abs() <= 1e-6 * (a - b).abs())
                    && let Some(laid) = laid_at(lay_length)
                {
                    let fits = laid.lies_from(layer);
                    found.push(DesignedLay { lay_length, laid, fits });
                }
            }
            before = here;
            lay_length *= ratio;
        }
        Ok(found)
    }

    /// The pretwist of one layer (rad per rod length, right-handed positive) at which the cable as laid asks for no moment to hold it: no residual
    /// torque. What that layer had been given is replaced.
    ///
    /// # Errors
    /// [`DomainError`] on `layer` unless the cable has it.
    ///
    /// ```
    /// use nply::mechanics::{Cable, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let straight = Layer {
    ///     strands: 3,
    ///     rod: Rod::solid_round(1.0, 200e3, 0.3)?,
    ///     handedness: Handedness::Left,
    ///     lay: WireLay::Length(30.0),
    ///     preforming: 0.0,
    ///     pretwist: 0.0,
    /// };
    /// let cable = Cable::new(None, &[straight])?;
    /// let pretwist = cable.pretwist_for_no_moment(0)?;
    /// let balanced = Cable::new(None, &[Layer { pretwist, ..straight }])?;
    /// assert!(balanced.laid()?.moment().abs() < 1e-9 * cable.laid()?.moment().abs());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn pretwist_for_no_moment(&self, layer: usize) -> Result<f64, DomainError> {
        let laid = self.layer(layer)?;
        // the moment is linear in what was put in: the shape as laid does not change
        let unit = 1.0 / laid.rod.radius();
        let moment = |pretwist: f64| {
            let cable = self.with_layer(layer, Layer { pretwist, ..laid });
            cable.and_then(|cable| cable.laid().ok()).map_or(f64::NAN, |state| state.moment())
        };
        let (without, with) = (moment(0.0), moment(unit));
        Ok(-without / (with - without) * unit)
    }

    fn layer(&self, index: usize) -> Result<Layer, DomainError> {
        let found = self.layers().nth(index).copied();
        found.ok_or(DomainError {
            quantity: "layer",
            value: index as f64,
            allowed: "the number of a layer, 0 the innermost",
        })
    }

    /// Lay length of a layer as it was laid.
    ///
    /// # Errors
    /// [`DomainError`] on `layer` unless the cable has it.
    pub fn lay_length(&self, layer: usize) -> Result<f64, DomainError> {
        self.layer(layer)?;
        let laid = &self.layers[layer];
        Ok(TAU * laid.radius / laid.angle.tan())
    }
}

impl CableState {
    /// Whether a layer (0 the innermost) and all above it lie on what is below; the innermost may have nothing below.
    fn lies_from(&self, layer: usize) -> bool {
        let cored = self.cable().core().is_some();
        let lies = |at: usize, support| support != LayerSupport::Neighbours || (at == 0 && !cored);
        self.layers().iter().enumerate().skip(layer).all(|(at, layer)| lies(at, layer.support))
    }
}

/// Between two lay lengths on either side.
fn halved(mut above: f64, mut below: f64, positive_above: bool, excess: &impl Fn(f64) -> Option<f64>) -> f64 {
    for _ in 0..100 {
        let middle = 0.5 * (above + below);
        if middle <= below || middle >= above {
            break;
        }
        if excess(middle).is_some_and(|value| (value > 0.0) == positive_above) {
            above = middle;
        } else {
            below = middle;
        }
    }
    0.5 * (above + below)
}
