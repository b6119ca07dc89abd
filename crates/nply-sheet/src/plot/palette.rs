//! Colours that people of every colour vision can tell apart.

/// Okabe and Ito's colours in an order that stands out on white; their yellow is left to areas.
pub(super) const LINES: [[u8; 3]; 7] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0xe6, 0x9f, 0x00],
    [0x56, 0xb4, 0xe9],
    [0x00, 0x00, 0x00],
];

/// For strands, which are shaded and need no black.
pub(crate) const STRANDS: [[u8; 3]; 6] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0xe6, 0x9f, 0x00],
    [0x56, 0xb4, 0xe9],
];

/// The same for areas: pale before strong, so that lines over them stay visible.
pub(super) const AREAS: [[u8; 3]; 8] = [
    [0xe4, 0xe4, 0xe4],
    [0x56, 0xb4, 0xe9],
    [0xe6, 0x9f, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0xf0, 0xe4, 0x42],
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
];

/// How numbers become colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ColourMap {
    /// Viridis, dark to light: equal steps look equal, in grey too.
    #[default]
    Sequential,
    /// Red below zero, white at zero, blue above; the limits are made symmetric.
    Diverging,
}

/// The number of steps of a colour map; with "nothing there" a byte is full.
pub(super) const STEPS: u8 = 255;

impl ColourMap {
    /// The colour at a fraction of the way from the lower limit (0) to the upper (1).
    pub(super) fn at(self, fraction: f64) -> [u8; 3] {
        use kuva::plot::ColorMap as Kuva;
        let map = match self {
            Self::Sequential => Kuva::Viridis,
            Self::Diverging => Kuva::RedBlue,
        };
        map.map_rgb(fraction.clamp(0.0, 1.0)).map_or([0; 3], |(r, g, b)| [r, g, b])
    }

    /// All steps, lower limit first.
    pub(super) fn steps(self) -> Vec<[u8; 3]> {
        (0..STEPS).map(|i| self.at(f64::from(i) / f64::from(STEPS - 1))).collect()
    }
}
