//! VTK: legacy text, and XML for surfaces with fields and for lines.

use core::fmt::Write as _;

use base64::Engine as _;

use super::{Chain, FileUnit, Surface, chain, field, said, single};

/// Numbers of a field: one or three to a point or cell.
struct Field {
    name: String,
    components: usize,
    values: Vec<f64>,
}

/// Everything in one list of points and one of cells: lines, then triangles.
struct Grid {
    points: Vec<[f64; 3]>,
    lines: Vec<Vec<u32>>,
    triangles: Vec<[u32; 3]>,
    point_fields: Vec<Field>,
    cell_fields: Vec<Field>,
}

/// What the fields are, for whoever opens the file as a text.
const FIELDS: &str =
    "strand counts from 1, 0 is the core, -1 a contact line, -2 a cut; angles in rad; NaN where a value has no meaning";

impl Grid {
    fn of(surface: &Surface<'_>, unit: &FileUnit) -> Self {
        let scalar = |name: &str| Field { name: name.to_owned(), components: 1, values: Vec::new() };
        let mut points = Vec::new();
        let mut normals = Field { components: 3, ..scalar("Normals") };
        let [mut arclength, mut alpha, mut mu] = ["arclength", "section_angle", "material_angle"].map(scalar);
        let (mut strand, mut stripe) = (scalar("strand"), scalar("stripe"));
        let mut triangles = Vec::new();
        let count = |points: &Vec<[f64; 3]>| u32::try_from(points.len()).unwrap_or(u32::MAX);
        // cells of a kind stand together, lines first
        let mut lines = Vec::new();
        let mut line_points = Vec::new();
        for line in &surface.assembly.lines {
            let first = count(&line_points);
            line_points.extend(line.points.iter().map(|point| unit.point(*point)));
            lines.push((first..count(&line_points)).collect::<Vec<u32>>());
            strand.values.push(match line.kind {
                super::LineKind::Contact => -1.0,
                super::LineKind::Cut => -2.0,
            });
            stripe.values.push(0.0);
        }
        let names: Vec<String> = values(surface, unit);
        let mut cell_values: Vec<Field> = names.iter().map(|name| scalar(name)).collect();
        cell_values.iter_mut().for_each(|field| field.values.resize(lines.len(), f64::NAN));
        for (number, part) in surface.parts.iter().enumerate() {
            let first = count(&points);
            points.extend(part.mesh.positions.iter().map(|point| unit.point(*point)));
            normals.values.extend(part.mesh.normals.iter().flatten());
            let per_t = unit.per_radius;
            let arclengths = chain::arclengths(part.wire.tube.course(), part.mesh.parameters.iter().map(|[t, _]| *t));
            arclength.values.extend(arclengths.into_iter().map(|s| s * per_t));
            alpha.values.extend(part.mesh.parameters.iter().map(|[t, b]| part.wire.tube.section_angle(*t, *b)));
            mu.values.extend(part.mesh.parameters.iter().map(|[_, b]| *b));
            triangles.extend(part.mesh.triangles.iter().map(|t| t.map(|i| first + i)));
            let core = part.wire.values.is_empty() && part.wire.name == "core";
            let cells = part.mesh.triangles.len();
            let own = if core { 0.0 } else { number as f64 + 1.0 };
            strand.values.extend(core::iter::repeat_n(own, cells));
            stripe.values.extend((0..cells).map(|i| f64::from(u8::from(part.is_striped(i)))));
            for (i, field_of) in cell_values.iter_mut().enumerate() {
                let known = part.wire.values.get(i).map(|value| field(*value, unit, surface.scale).1);
                field_of.values.extend(core::iter::repeat_n(known.unwrap_or(f64::NAN), cells));
            }
        }
        let shift = count(&points);
        for line in &mut lines {
            line.iter_mut().for_each(|i| *i += shift);
        }
        points.extend(&line_points);
        normals.values.resize(3 * points.len(), 0.0);
        for scalar in [&mut arclength, &mut alpha, &mut mu] {
            scalar.values.resize(points.len(), f64::NAN);
        }
        let cell_fields = [strand, stripe].into_iter().chain(cell_values).collect();
        Self { points, lines, triangles, point_fields: vec![normals, arclength, alpha, mu], cell_fields }
    }
}

/// The names of the wires' values, which are the same of all that have any.
fn values(surface: &Surface<'_>, unit: &FileUnit) -> Vec<String> {
    let Some(part) = surface.parts.iter().find(|part| !part.wire.values.is_empty()) else { return Vec::new() };
    part.wire.values.iter().map(|value| field(*value, unit, surface.scale).0).collect()
}

fn numbers(out: &mut String, values: impl Iterator<Item = f64>) {
    for (i, value) in values.enumerate() {
        let _ = write!(out, "{}{}", if i == 0 { "" } else { " " }, single(value));
    }
    out.push('\n');
}

/// Legacy text: polygons and lines.
pub(super) fn legacy(surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
    let grid = Grid::of(surface, unit);
    let mut out = format!(
        "# vtk DataFile Version 3.0\n{}\nASCII\nDATASET POLYDATA\nPOINTS {} float\n",
        said(&surface.assembly.title, unit),
        grid.points.len()
    );
    for point in &grid.points {
        numbers(&mut out, point.iter().copied());
    }
    if !grid.lines.is_empty() {
        let size: usize = grid.lines.iter().map(|line| line.len() + 1).sum();
        let _ = writeln!(out, "LINES {} {size}", grid.lines.len());
        for line in &grid.lines {
            let _ = write!(out, "{}", line.len());
            line.iter().for_each(|i| {
                let _ = write!(out, " {i}");
            });
            out.push('\n');
        }
    }
    let _ = writeln!(out, "POLYGONS {} {}", grid.triangles.len(), 4 * grid.triangles.len());
    for [a, b, c] in &grid.triangles {
        let _ = writeln!(out, "3 {a} {b} {c}");
    }
    let cells = grid.lines.len() + grid.triangles.len();
    for (place, count, fields) in
        [("POINT_DATA", grid.points.len(), &grid.point_fields), ("CELL_DATA", cells, &grid.cell_fields)]
    {
        let _ = writeln!(out, "{place} {count}");
        for field in fields {
            if field.components == 3 {
                let _ = writeln!(out, "NORMALS {} float", field.name);
            } else {
                let _ = writeln!(out, "SCALARS {} float 1\nLOOKUP_TABLE default", field.name);
            }
            for values in field.values.chunks(field.components) {
                numbers(&mut out, values.iter().copied());
            }
        }
    }
    out.into_bytes()
}

/// A list of numbers of the XML formats, as base64 behind its number of bytes.
fn array(out: &mut String, kind: &str, name: &str, components: usize, bytes: Vec<u8>) {
    let mut all = u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_le_bytes().to_vec();
    all.extend(bytes);
    let text = base64::engine::general_purpose::STANDARD.encode(all);
    let _ = writeln!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">{text}</DataArray>"
    );
}

fn floats(out: &mut String, field: &Field) {
    let bytes = field.values.iter().flat_map(|x| single(*x).to_le_bytes()).collect();
    array(out, "Float32", &field.name, field.components, bytes);
}

fn integers(out: &mut String, name: &str, values: impl Iterator<Item = u32>) {
    array(out, "Int32", name, 1, values.flat_map(u32::to_le_bytes).collect());
}

/// Where each cell's list of points ends.
fn ends<'c>(sizes: impl Iterator<Item = usize> + 'c) -> impl Iterator<Item = u32> + 'c {
    sizes.scan(0_usize, |end, size| {
        *end += size;
        Some(u32::try_from(*end).unwrap_or(u32::MAX))
    })
}

fn head(kind: &str, title: &str, unit: &FileUnit) -> String {
    // two dashes would end the comment
    let said = said(title, unit).replace("--", "-");
    format!(
        "<?xml version=\"1.0\"?>\n<!-- {said}; {FIELDS} -->\n\
         <VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<{kind}>\n"
    )
}

fn points(out: &mut String, points: &[[f64; 3]], precise: bool) {
    out.push_str("<Points>\n");
    let values = points.iter().flatten();
    if precise {
        array(out, "Float64", "Points", 3, values.flat_map(|x| x.to_le_bytes()).collect());
    } else {
        array(out, "Float32", "Points", 3, values.flat_map(|x| single(*x).to_le_bytes()).collect());
    }
    out.push_str("</Points>\n");
}

/// XML: an unstructured grid of lines and triangles.
pub(super) fn unstructured(surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
    const LINE: u8 = 4;
    const TRIANGLE: u8 = 5;
    let grid = Grid::of(surface, unit);
    let cells = grid.lines.len() + grid.triangles.len();
    let mut out = head("UnstructuredGrid", &surface.assembly.title, unit);
    let _ = writeln!(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">", grid.points.len());
    points(&mut out, &grid.points, false);
    out.push_str("<Cells>\n");
    integers(&mut out, "connectivity", grid.lines.iter().flatten().chain(grid.triangles.iter().flatten()).copied());
    let sizes = grid.lines.iter().map(Vec::len).chain(grid.triangles.iter().map(|_| 3));
    integers(&mut out, "offsets", ends(sizes));
    let types = grid.lines.iter().map(|_| LINE).chain(grid.triangles.iter().map(|_| TRIANGLE)).collect();
    array(&mut out, "UInt8", "types", 1, types);
    out.push_str("</Cells>\n<PointData Normals=\"Normals\">\n");
    grid.point_fields.iter().for_each(|field| floats(&mut out, field));
    out.push_str("</PointData>\n<CellData Scalars=\"strand\">\n");
    grid.cell_fields.iter().for_each(|field| floats(&mut out, field));
    out.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    out.into_bytes()
}

/// XML: centrelines as lines.
pub(super) fn lines(title: &str, chains: &[Chain], unit: &FileUnit) -> Vec<u8> {
    let mut out = head("PolyData", title, unit);
    let all: Vec<[f64; 3]> = chains.iter().flat_map(|chain| &chain.points).map(|point| unit.point(*point)).collect();
    let _ = writeln!(
        out,
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">",
        all.len(),
        chains.len()
    );
    points(&mut out, &all, true);
    out.push_str("<Lines>\n");
    integers(&mut out, "connectivity", 0..u32::try_from(all.len()).unwrap_or(u32::MAX));
    integers(&mut out, "offsets", ends(chains.iter().map(|chain| chain.points.len())));
    out.push_str("</Lines>\n<PointData>\n");
    let tangents = chains.iter().flat_map(|chain| &chain.tangents).flatten().copied().collect();
    floats(&mut out, &Field { name: "tangent".to_owned(), components: 3, values: tangents });
    out.push_str("</PointData>\n<CellData>\n");
    let scalar = |name: &str, value: fn(&Chain) -> f64| Field {
        name: name.to_owned(),
        components: 1,
        values: chains.iter().map(value).collect(),
    };
    floats(&mut out, &scalar("strand", |chain| f64::from(chain.number)));
    let mut radius = scalar("radius", |chain| chain.radius);
    radius.values.iter_mut().for_each(|r| *r *= unit.per_radius);
    floats(&mut out, &radius);
    out.push_str("</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n");
    out.into_bytes()
}
