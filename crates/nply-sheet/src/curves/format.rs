//! Formats of files with curves, told by name or by how a file begins.

use super::text::starts_with_word;

/// A format in which curves come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Rows of numbers x y z, separated by commas, semicolons, tabs or blanks.
    Rows,
    /// XYZ: a count, a comment, then `label x y z` a line.
    Xyz,
    /// Protein Data Bank, fixed columns.
    Pdb,
    /// VTK legacy, text or binary.
    Vtk,
    /// VTK XML: `PolyData` (VTP) or `UnstructuredGrid` (VTU).
    VtkXml,
    /// Wavefront OBJ, `l` lines.
    Obj,
    /// Beams and trusses of Abaqus' and CalculiX' input.
    Inp,
    /// A NumPy array.
    Npy,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 8] =
        [Self::Rows, Self::Xyz, Self::Pdb, Self::Vtk, Self::VtkXml, Self::Obj, Self::Inp, Self::Npy];

    /// Its short name: `csv`, `xyz`, `pdb`, `vtk`, `vtp`, `obj`, `inp`, `npy`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rows => "csv",
            Self::Xyz => "xyz",
            Self::Pdb => "pdb",
            Self::Vtk => "vtk",
            Self::VtkXml => "vtp",
            Self::Obj => "obj",
            Self::Inp => "inp",
            Self::Npy => "npy",
        }
    }

    /// The format of this short name.
    ///
    /// ```
    /// use nply_sheet::curves::Format;
    /// assert_eq!(Format::named("pdb"), Some(Format::Pdb));
    /// assert_eq!(Format::named("step"), None);
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// By how the file begins where that is unmistakable, else by the ending of its name, else rows of numbers. An ending of another
    /// format that is known by name but not read gives that name.
    pub(super) fn guess(file_name: &str, bytes: &[u8]) -> Result<Self, &'static str> {
        let head = &bytes[..bytes.len().min(1 << 12)];
        if bytes.starts_with(b"\x93NUMPY") {
            return Ok(Self::Npy);
        }
        if bytes.starts_with(b"# vtk DataFile") {
            return Ok(Self::Vtk);
        }
        let marked = |mark: &[u8]| head.windows(mark.len()).any(|window| window == mark);
        if head.trim_ascii_start().starts_with(b"<") && marked(b"<VTKFile") {
            return Ok(Self::VtkXml);
        }
        let ending = file_name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        match ending.as_deref().unwrap_or("") {
            "csv" | "tsv" | "txt" | "dat" | "asc" => Ok(Self::Rows),
            "xyz" | "extxyz" => Ok(if counts_first(head) { Self::Xyz } else { Self::Rows }),
            "pdb" | "ent" | "brk" => Ok(Self::Pdb),
            "vtk" => Ok(Self::Vtk),
            "vtp" | "vtu" => Ok(Self::VtkXml),
            "obj" => Ok(Self::Obj),
            "inp" => Ok(Self::Inp),
            "npy" => Ok(Self::Npy),
            "npz" => Err("an archive of arrays (.npz); save the one array with numpy.save as .npy"),
            "cif" | "mmcif" => Err("mmCIF; save it as PDB"),
            "gz" | "zip" | "bz2" | "xz" | "zst" => Err("compressed; unpack it first"),
            "stl" | "ply" | "glb" | "gltf" => {
                Err("a surface; centrelines are wanted, as CSV, OBJ lines or VTP polylines")
            }
            _ => Ok(Self::sniff(head)),
        }
    }

    /// By content alone.
    fn sniff(head: &[u8]) -> Self {
        let pdb = ["HEADER", "ATOM", "HETATM", "MODEL", "CRYST1", "REMARK", "TITLE", "COMPND"];
        let mut lines = head.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii);
        if lines.clone().next().is_some_and(|line| pdb.iter().any(|word| starts_with_word(line, word))) {
            Self::Pdb
        } else if counts_first(head) {
            Self::Xyz
        } else if lines.clone().next().is_some_and(is_keyword) {
            Self::Inp
        } else if lines.any(|line| starts_with_word(line, "v")) {
            Self::Obj
        } else {
            Self::Rows
        }
    }
}

/// Whether a line is a keyword of a finite-element input, `*NODE`, or a comment there, `** …`.
fn is_keyword(line: &[u8]) -> bool {
    matches!(line, [b'*', second, ..] if second.is_ascii_alphabetic() || *second == b'*')
}

/// Whether a text begins with a line that holds one whole number alone.
fn counts_first(head: &[u8]) -> bool {
    let line = head.split(|byte| *byte == b'\n').next().unwrap_or(head).trim_ascii();
    !line.is_empty() && line.iter().all(u8::is_ascii_digit)
}
