//! Beam elements: how many nodes each has.

/// A beam element by the name that solvers give it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Element {
    /// Straight, of two nodes: Abaqus'. CalculiX reads the name, but refuses a round section with it.
    #[default]
    B31,
    /// Quadratic, of three nodes, the middle one on the centreline too: Abaqus' and CalculiX'.
    B32,
}

impl Element {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::B31, Self::B32];

    /// Its name, as it stands in a file.
    ///
    /// ```
    /// use nply_sheet::mesh::Element;
    /// assert_eq!((Element::B32.name(), Element::B32.chords()), ("B32", 2));
    /// ```
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::B31 => "B31",
            Self::B32 => "B32",
        }
    }

    /// How many chords there are between its nodes: 1 or 2.
    #[must_use]
    pub const fn chords(self) -> u32 {
        match self {
            Self::B31 => 1,
            Self::B32 => 2,
        }
    }
}
