//! The formats, by the ends of their names.

use super::{Chain, FileUnit, Surface, abaqus, glb, obj, pdb, ply, stl, vtk, xyz};
use crate::SpecError;

/// A format for surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SurfaceFormat {
    /// Binary STL: triangles alone.
    Stl,
    /// Wavefront OBJ: a group a strand, colours at the corners, lines.
    Obj,
    /// Binary glTF 2.0: a coloured material a strand and its stripe, lines; in metres, as it asks.
    Glb,
    /// Binary PLY: colours at corners and faces.
    Ply,
    /// Legacy VTK in text: fields, lines.
    Vtk,
    /// VTK's XML for unstructured grids: fields, lines.
    Vtu,
}

impl SurfaceFormat {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Stl, Self::Obj, Self::Glb, Self::Ply, Self::Vtk, Self::Vtu];

    /// The end of a file's name.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Stl => "stl",
            Self::Obj => "obj",
            Self::Glb => "glb",
            Self::Ply => "ply",
            Self::Vtk => "vtk",
            Self::Vtu => "vtu",
        }
    }

    /// Whether it is no text.
    #[must_use]
    pub const fn is_binary(self) -> bool {
        matches!(self, Self::Stl | Self::Glb | Self::Ply)
    }

    /// Whether lines have a place in it.
    #[must_use]
    pub const fn takes_lines(self) -> bool {
        !matches!(self, Self::Stl | Self::Ply)
    }

    /// Whether painted stripes have a place in it.
    #[must_use]
    pub const fn takes_stripes(self) -> bool {
        !matches!(self, Self::Stl)
    }

    /// The unit it asks for, if it does.
    #[must_use]
    pub const fn own_unit(self) -> Option<&'static str> {
        match self {
            Self::Glb => Some("m"),
            _ => None,
        }
    }

    /// The file.
    #[must_use]
    pub fn write(self, surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
        match self {
            Self::Stl => stl::write(surface, unit),
            Self::Obj => obj::write(surface, unit),
            Self::Glb => glb::write(surface, unit),
            Self::Ply => ply::write(surface, unit),
            Self::Vtk => vtk::legacy(surface, unit),
            Self::Vtu => vtk::unstructured(surface, unit),
        }
    }
}

/// A format for centrelines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LineFormat {
    /// A row a node.
    Csv,
    /// A line a node, as molecular viewers read it.
    Xyz,
    /// A trace of atoms, a chain a strand; in Å, as it asks.
    Pdb,
    /// VTK's XML for polygons and lines.
    Vtp,
    /// Abaqus' and CalculiX' nodes and beam elements, with a set of elements for each wire.
    Inp,
}

impl LineFormat {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Csv, Self::Xyz, Self::Pdb, Self::Vtp, Self::Inp];

    /// The end of a file's name.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Xyz => "xyz",
            Self::Pdb => "pdb",
            Self::Vtp => "vtp",
            Self::Inp => "inp",
        }
    }

    /// The unit it asks for, if it does.
    #[must_use]
    pub const fn own_unit(self) -> Option<&'static str> {
        match self {
            Self::Pdb => Some("Å"),
            _ => None,
        }
    }

    /// The file.
    ///
    /// # Errors
    /// [`SpecError`] where a format has no room for a coordinate or a name.
    pub fn write(self, title: &str, chains: &[Chain], unit: &FileUnit) -> Result<Vec<u8>, SpecError> {
        Ok(match self {
            Self::Csv => xyz::table(chains, unit),
            Self::Xyz => xyz::write(title, chains, unit),
            Self::Pdb => pdb::write(title, chains, unit)?,
            Self::Vtp => vtk::lines(title, chains, unit),
            Self::Inp => abaqus::write(title, chains, unit),
        })
    }
}
