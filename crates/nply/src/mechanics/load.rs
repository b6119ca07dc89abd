//! The loads at the ends of the ply.

/// End force and end moment on the whole ply, dimensionless by (39): f = r²F₀/B, m = rM₀/B.
///
/// The force is positive in tension; the moment is positive where it turns the ply right-handed.
///
/// ```
/// use nply::mechanics::Load;
/// let pull = Load { force: 0.5, moment: 0.0 };
/// assert_eq!(Load::NONE, Load { force: 0.0, ..pull });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// f = r²F₀/B, tension positive.
    pub force: f64,
    /// m = rM₀/B, right-handed positive.
    pub moment: f64,
}

impl Load {
    /// The balanced ply's loads: none.
    pub const NONE: Self = Self { force: 0.0, moment: 0.0 };
}
