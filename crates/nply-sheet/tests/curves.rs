//! Files of curves: the same curves from every format, and one sentence for every mistake.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "helpers of tests; coordinates come back to the last bit"
)]

use nply_sheet::curves::{Curves, Format, ReadError};
use proptest::prelude::*;

fn read(name: &str, bytes: &[u8]) -> Curves {
    Curves::read(name, bytes, None).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(name: &str, bytes: &[u8]) -> ReadError {
    Curves::read(name, bytes, None).unwrap_err()
}

/// Two curves that every format can hold.
const CURVES: [&[[f64; 3]]; 2] =
    [&[[0.0, 0.0, 0.0], [1.0, 0.5, -2.0], [3.0, 1.25, 4.0]], &[[9.0, 0.0, 0.0], [9.0, 1.0, 0.0], [9.0, 0.0, 1.0]]];

fn ascii(points: &[[f64; 3]], before: &str) -> String {
    points.iter().map(|[x, y, z]| format!("{before}{x} {y} {z}\n")).collect()
}

fn big(scalars: impl IntoIterator<Item = i32>) -> Vec<u8> {
    scalars.into_iter().flat_map(i32::to_be_bytes).collect()
}

fn npy(descr: &str, fortran: bool, shape: &str, data: &[u8]) -> Vec<u8> {
    let fortran = if fortran { "True" } else { "False" };
    let mut header = format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}");
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(u16::try_from(header.len()).unwrap().to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

fn all_numbers() -> impl Iterator<Item = f64> {
    CURVES.concat().into_iter().flatten()
}

fn pdb_atom(
    record: &str,
    atom: &str,
    alternate: char,
    chain: char,
    residue: i64,
    p: [f64; 3],
    occupancy: &str,
) -> String {
    let [x, y, z] = p;
    format!("{record:<6}    1 {atom}{alternate}ALA {chain}{residue:>4}    {x:8.3}{y:8.3}{z:8.3}{occupancy:>6}\n")
}

fn pdb() -> String {
    let mut text = "HEADER    MADE FOR A TEST\n".to_owned();
    for (chain, points) in ['A', 'B'].into_iter().zip(CURVES) {
        for (residue, point) in (1..).zip(points) {
            let [x, y, z] = *point;
            text += &pdb_atom("ATOM", " N  ", ' ', chain, residue, [x - 1.0, y, z], "1.00");
            text += &pdb_atom("ATOM", " CA ", ' ', chain, residue, *point, "1.00");
        }
        text += "TER\n";
    }
    text + "END\n"
}

fn legacy(binary: bool) -> Vec<u8> {
    let mut bytes = format!(
        "# vtk DataFile Version 3.0\ntwo curves\n{}\nDATASET POLYDATA\n",
        if binary { "BINARY" } else { "ASCII" }
    )
    .into_bytes();
    bytes.extend(b"POINTS 6 double\n");
    if binary {
        bytes.extend(all_numbers().flat_map(f64::to_be_bytes));
        bytes.extend(b"\nLINES 2 8\n");
        bytes.extend(big([3, 0, 1, 2, 3, 3, 4, 5]));
        bytes.push(b'\n');
    } else {
        bytes.extend(ascii(&CURVES.concat(), "").bytes());
        bytes
            .extend(b"LINES 2 8\n3 0 1 2\n3 3 4 5\nPOINT_DATA 6\nSCALARS p float\nLOOKUP_TABLE default\n0 0 0 0 0 0\n");
    }
    bytes
}

fn vtp() -> Vec<u8> {
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n\
         <Piece NumberOfPoints=\"6\" NumberOfLines=\"2\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n{}\
         </DataArray></Points>\n<Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5</DataArray>\n\
         <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6</DataArray></Lines>\n</Piece></PolyData></VTKFile>\n",
        ascii(&CURVES.concat(), "")
    )
    .into_bytes()
}

/// The curves as the beams of a finite-element input.
fn inp(end: &str, kind: &str, first: &[&str], second: &[&str]) -> Vec<u8> {
    let nodes =
        CURVES.concat().iter().zip(1..).map(|([x, y, z], i)| format!("{i}, {x}, {y}, {z}\n")).collect::<String>();
    let (first, second) = (first.join("\n"), second.join("\n"));
    let text = format!(
        "*Heading\n two curves\n  *NODE, NSET=ALL\n{nodes}** radius 0.5\n*ELEMENT, TYPE={kind}, ELSET=FIRST\n{first}\n** another\n\
         *Element , elset=SECOND, type={kind}\n{second}\n*NSET, NSET=START\n1, 4\n*BEAM SECTION, SECTION=CIRC, ELSET=FIRST\n3.\n"
    );
    text.replace('\n', end).into_bytes()
}

/// Each format's text of the two curves.
fn good() -> Vec<(&'static str, Vec<u8>)> {
    let [first, second] = CURVES;
    let doubles: Vec<u8> = all_numbers().flat_map(f64::to_le_bytes).collect();
    let csv = |separator: &str, head: &str| -> Vec<u8> {
        let rows = [("a", first), ("b", second)].into_iter().flat_map(|(name, points)| {
            points.iter().map(move |[x, y, z]| {
                [name.to_owned(), x.to_string(), y.to_string(), z.to_string()].join(separator) + "\n"
            })
        });
        (head.to_owned() + &rows.collect::<String>()).into_bytes()
    };
    vec![
        ("a.csv", csv(",", "strand,x,y,z\n")),
        ("a.csv", csv(";", "\"curve\";\"x [mm]\";\"y [mm]\";\"z [mm]\"\r\n")),
        ("a.tsv", csv("\t", "wire_id\tX\tY\tZ\n")),
        ("a.txt", csv(" ", "")),
        ("a.txt", csv("  ", "# curve x y z\n")),
        ("a.dat", format!("{}\n\n{}", ascii(first, " "), ascii(second, "\t")).into_bytes()),
        ("a.xyz", format!("3\nfirst\n{}3\n\n{}", ascii(first, "C "), ascii(second, "C ")).into_bytes()),
        ("a.pdb", pdb().into_bytes()),
        ("a.vtk", legacy(false)),
        ("a.vtk", legacy(true)),
        ("a.vtp", vtp()),
        (
            "a.obj",
            format!("o first\n{}l 1 2 3\no second\n{}l -3 -2 -1\n", ascii(first, "v "), ascii(second, "v "))
                .into_bytes(),
        ),
        ("a.obj", format!("{}l 3 2\nl 1 2\nl 4/1 5/2 \\\n 6/3\nf 1 2 3\n", ascii(&CURVES.concat(), "v ")).into_bytes()),
        ("a.inp", inp("\n", "B31", &["7, 1, 2", "8, 2, 3"], &["9, 4, 5", "10, 5, 6"])),
        ("beams", inp("\r\n", "b32", &["1, 1, 2, 3,"], &["2, 4, 5, 6"])),
        ("a.inp", inp("\n", "T3D2", &["8, 2, 3", "7, 1, 2"], &["9, 4, 5", "10, 5, 6"])),
        ("a.npy", npy("<f8", false, "(2, 3, 3)", &doubles)),
    ]
}

#[test]
fn the_same_curves_come_from_every_format() {
    for (name, bytes) in good() {
        let found = read(name, &bytes);
        let text = String::from_utf8_lossy(&bytes);
        assert_eq!(found.curves.len(), 2, "{text}");
        let mut points: Vec<Vec<[f64; 3]>> = found.curves.iter().map(|curve| curve.points.clone()).collect();
        if points[0] != CURVES[0] {
            points[0].reverse(); // joined pieces run from an end
        }
        assert_eq!(points, CURVES.map(<[_]>::to_vec), "{text}");
        // and without its ending, where a beginning tells them apart
        let nameless = Curves::read("standard input", &bytes, Some(found.format)).unwrap();
        assert_eq!(nameless.curves, found.curves);
        assert_eq!(read("standard input", &bytes).format, found.format, "{text}");
    }
}

#[test]
fn names_units_and_what_was_left_out_are_said() {
    let good = good();
    let names = |at: usize| -> Vec<String> {
        read(good[at].0, &good[at].1).curves.into_iter().map(|curve| curve.name).collect()
    };
    assert_eq!(names(0), ["a", "b"]);
    assert_eq!(names(6), ["first", "2"]);
    assert_eq!(names(7), ["A", "B"]);
    assert_eq!(names(11), ["first", "second"]);
    assert_eq!(read(good[1].0, &good[1].1).unit.as_deref(), Some("mm"));
    assert_eq!(read(good[7].0, &good[7].1).unit.as_deref(), Some("Å"));
    let beams = read(good[13].0, &good[13].1);
    let said: Vec<_> = beams.curves.iter().map(|curve| (curve.name.as_str(), curve.diameter)).collect();
    assert_eq!(said, [("FIRST", Some(1.0)), ("SECOND", None)]);
    // twice the greatest radius is no number, and no diameter
    let text = b"** radius 1e308\n*NODE\n1, 0\n2, 1\n** radius 1e308\n*ELEMENT, TYPE=B31\n1, 1, 2\n";
    assert_eq!(read("a.inp", text).curves[0].diameter, None);
    let joined = read(good[12].0, &good[12].1);
    assert_eq!(joined.notes, ["2 pieces of two points are joined end to end.", "1 face is left out."]);
    let twice = read("a.csv", b"0,0,0\n1,1,1\n\n0,0,0\n1,1,1\n");
    assert_eq!(twice.curves.iter().map(|curve| curve.line).collect::<Vec<_>>(), [Some(1), Some(4)]);
    let spreadsheet = read("a.csv", b"x;y;z\n0;0;0\n1;1;1\n;;\n5;0;0\n5;1;1\n;;\n");
    assert_eq!(spreadsheet.curves.len(), 2);
    let header_again = read("a.csv", b"x,y,z\n0,0,0\n1,1,1\nx,y,z\n5,0,0\n5,1,1\n");
    assert_eq!(header_again.curves.len(), 2);
    let wide = read("a.csv", b"curve,x,y,z,diameter\na,0,0,0,2\na,0,0,1,2\nb,9,0,0,4\nb,9,0,1,4\n");
    assert_eq!(wide.curves.iter().map(|curve| curve.diameter).collect::<Vec<_>>(), [Some(2.0), Some(4.0)]);
    assert_eq!(read("a.csv", b"x,y,z,radius\n0,0,0,2\n0,0,1,2\n").curves[0].diameter, Some(4.0));
}

/// Two curves that nothing stands between look like one: that is not passed over in silence.
#[test]
fn a_step_that_stands_out_is_pointed_out() {
    let line = |from: f64| (0..9).map(|k| format!("{from} 0 {k}\n")).collect::<String>();
    let joined = read("a.txt", (line(0.0) + &line(3.0)).as_bytes());
    assert_eq!(joined.notes, ["Curve \"1\": the step behind point 9 is 9 times the usual one; are these two curves?"]);
    assert!(read("a.txt", (line(0.0) + "\n" + &line(3.0)).as_bytes()).notes.is_empty());
    let woven = read("a.csv", b"curve,x,y,z\na,0,0,0\nb,9,0,0\na,0,0,1\nb,9,0,1\n");
    assert_eq!((woven.curves.len(), woven.curves[1].points[1]), (2, [9.0, 0.0, 1.0]));
    assert!(woven.notes[0].contains("first in line 4"), "{:?}", woven.notes);
    assert!(read("a.csv", b"curve,x,y,z\na,0,0,0\na,9,0,0\nb,0,0,1\nb,9,0,1\n").notes.is_empty());
    let radii = read("a.csv", b"wire,node,x_r,y_r,z_r,radius_r\n1,0,0,0,0,1\n1,1,0,0,1,1\n");
    assert_eq!((radii.unit.as_deref(), radii.curves[0].diameter), (Some("r"), Some(2.0)));
}

#[test]
fn arrays_in_every_order_are_the_same() {
    let at = |fortran: bool| -> Vec<f64> {
        // element (k, i, j) of shape (2, 3, 3)
        let all: Vec<f64> = all_numbers().collect();
        if !fortran {
            return all;
        }
        let mut out = Vec::new();
        for j in 0..3 {
            for i in 0..3 {
                for k in 0..2 {
                    out.push(all[(k * 3 + i) * 3 + j]);
                }
            }
        }
        out
    };
    for fortran in [false, true] {
        let values = at(fortran);
        for (descr, data) in [
            ("<f8", values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>()),
            (">f8", values.iter().flat_map(|v| v.to_be_bytes()).collect()),
            ("<f4", values.iter().flat_map(|v| (*v as f32).to_le_bytes()).collect()),
            (">f4", values.iter().flat_map(|v| (*v as f32).to_be_bytes()).collect()),
        ] {
            let found = read("a.npy", &npy(descr, fortran, "(2, 3, 3)", &data));
            assert_eq!(found.curves[0].points, CURVES[0], "{descr} {fortran}");
            assert_eq!(found.curves[1].points, CURVES[1], "{descr} {fortran}");
        }
    }
    let whole: Vec<u8> = [-1_i32, 2, 3, 4, 5, 6].iter().flat_map(|v| v.to_be_bytes()).collect();
    assert_eq!(
        read("a.npy", &npy(">i4", false, "(2, 3)", &whole)).curves[0].points,
        [[-1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]
    );
    assert_eq!(
        read("a.npy", &npy("|u1", true, "(2, 3)", &[1, 2, 3, 4, 5, 6])).curves[0].points,
        [[1.0, 3.0, 5.0], [2.0, 4.0, 6.0]]
    );
}

#[test]
fn a_protein_is_its_alpha_carbons_and_what_was_chosen_is_said() {
    let at = |z: f64| [0.0, 0.0, z];
    let mut text = "MODEL        1\n".to_owned();
    text += &pdb_atom("ATOM", " CA ", ' ', 'A', 1, at(0.0), "1.00");
    text += &pdb_atom("ATOM", " CA ", 'A', 'A', 2, at(3.0), "0.40");
    text += &pdb_atom("ATOM", " CA ", 'B', 'A', 2, at(3.5), "0.60");
    // a modified amino acid within the chain, and a gap
    for (atom, z) in [(" N  ", 6.0), (" CA ", 7.0), (" C  ", 8.0)] {
        text += &pdb_atom("HETATM", atom, ' ', 'A', 5, at(z), "1.00");
    }
    text += "TER\n";
    // an ion of calcium, a phosphate, and another chain of one residue
    text += &pdb_atom("HETATM", "CA  ", ' ', 'A', 6, at(20.0), "1.00");
    text += &pdb_atom("HETATM", " P  ", ' ', 'A', 7, at(30.0), "1.00");
    text += &pdb_atom("ATOM", " CA ", ' ', 'B', 1, at(40.0), "1.00");
    text += "ENDMDL\nMODEL        2\n";
    text += &pdb_atom("ATOM", " CA ", ' ', 'A', 1, at(90.0), "1.00");
    text += "ENDMDL\nEND\n";
    let found = read("a.pdb", text.as_bytes());
    assert_eq!(found.curves.len(), 1);
    assert_eq!(found.curves[0].points, [at(0.0), at(3.5), at(7.0)]);
    let notes = found.notes.join(" ");
    for said in ["The first of 2 models is read.", "1 residue has alternate positions", "(HETATM)", "jump from 2 to 5"]
    {
        assert!(notes.contains(said), "{notes}");
    }
    // a selenomethionine in a file of Cα alone
    let mut trace = String::new();
    for (record, residue) in [("ATOM", 1), ("ATOM", 2), ("HETATM", 3), ("ATOM", 4), ("HETATM", 5)] {
        trace += &pdb_atom(record, " CA ", ' ', 'A', residue, at(residue as f64), "1.00");
    }
    let found = read("a.pdb", trace.as_bytes());
    assert_eq!(found.curves[0].points, [1.0, 2.0, 3.0, 4.0].map(at));
    assert!(found.notes.join(" ").contains("1 residue among hetero atoms (HETATM) is taken in"), "{:?}", found.notes);
    // nucleic acids: the phosphorus of each nucleotide, and no 5' end without one
    let mut dna = pdb_atom("ATOM", " O5'", ' ', 'C', 1, at(0.0), "1.00");
    for residue in 2..4 {
        dna += &pdb_atom("ATOM", " P  ", ' ', 'C', residue, at(residue as f64), "1.00");
    }
    assert_eq!(read("a.pdb", dna.as_bytes()).curves[0].points, [at(2.0), at(3.0)]);
}

/// What makes or moves nodes or elements is not followed, and a model without it is another: it is refused, as what stands twice is.
#[test]
fn what_makes_moves_or_repeats_nodes_and_elements_is_refused() {
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("a.inp", inp("\n", "B31", &["7, 1, 2"], &["7, 4, 5"]), "a.inp:15: there is an element 7 above already"),
        ("a.inp", b"*NODE\n1, 0\n*Ngen\n1, 9\n".to_vec(), "a.inp:3: `*NGEN` makes nodes"),
        ("a.inp", b"*NFILL\n".to_vec(), "a.inp:1: `*NFILL` makes nodes"),
        ("a.inp", b"*NCOPY, CHANGE NUMBER=9\n".to_vec(), "a.inp:1: `*NCOPY` makes nodes"),
        ("a.inp", b"*ELGEN, ELSET=A\n1, 9\n".to_vec(), "a.inp:1: `*ELGEN` makes elements"),
        ("a.inp", b"*ELCOPY\n".to_vec(), "a.inp:1: `*ELCOPY` makes elements"),
        ("a.inp", b"*NMAP, NSET=A\n".to_vec(), "a.inp:1: `*NMAP` moves nodes"),
        ("a.inp", b"*SYSTEM\n** moved\n10, 0, 0\n".to_vec(), "a.inp:3: `*SYSTEM` moves the nodes below it"),
        ("a.inp", b"*NODE, SYSTEM=C\n1, 0\n".to_vec(), "a.inp:1: its nodes are in cylindrical or spherical coord"),
        ("a.inp", b"*NODE,\nsystem=s\n1, 0\n".to_vec(), "a.inp:1: its nodes are in cylindrical or spherical coord"),
    ];
    let said = |(name, bytes, wanted): (&str, Vec<u8>, &'static str)| {
        let said = Curves::read(name, &bytes, None).map_or_else(|error| error.to_string(), |_| "it is read".to_owned());
        (!said.starts_with(wanted)).then(|| format!("{said}\nand not: {wanted}"))
    };
    let wrong: Vec<String> = cases.into_iter().filter_map(said).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// How many nodes lie along an element follows from its type; one more orients the section, and is no point of the wire.
#[test]
fn a_node_that_orients_an_element_is_no_point_of_the_wire() {
    let all = [
        ("B31", ["7, 1, 2, 6", "8, 2, 3"], ["9, 4, 5", "10, 5, 6, 1"]),
        ("B31H", ["7, 1, 2, 6", "8, 2, 3"], ["9, 4, 5", "10, 5, 6, 1"]),
        ("b33", ["7, 1, 2, 6", "8, 2, 3"], ["9, 4, 5", "10, 5, 6, 1"]),
        ("T3D2", ["7, 1, 2, 6", "8, 2, 3"], ["9, 4, 5", "10, 5, 6, 1"]),
    ];
    for (kind, first, second) in all {
        let found = read("a.inp", &inp("\n", kind, &first, &second));
        let points: Vec<_> = found.curves.iter().map(|curve| curve.points.clone()).collect();
        assert_eq!(points, CURVES.map(<[_]>::to_vec), "{kind}");
        assert_eq!(found.notes, ["The orientation nodes of 2 elements are left out."], "{kind}");
    }
    for kind in ["B32", "B32R", "B32OS", "T3D3"] {
        let found = read("a.inp", &inp("\n", kind, &["7, 1, 2, 3, 6"], &["9, 4, 5, 6"]));
        let points: Vec<_> = found.curves.iter().map(|curve| curve.points.clone()).collect();
        assert_eq!(points, CURVES.map(<[_]>::to_vec), "{kind}");
        assert_eq!(found.notes, ["The orientation node of 1 element is left out."], "{kind}");
    }
    let plain = read("a.inp", &inp("\n", "B32", &["7, 1, 2, 3"], &["9, 4, 5, 6"]));
    assert!(plain.notes.is_empty(), "{:?}", plain.notes);
}

/// A keyword line that ends in a comma goes on in the next that is no comment; coordinates after it are none of its parameters.
#[test]
fn a_keyword_line_goes_on_behind_a_comma() {
    let whole = String::from_utf8(inp("\n", "B31", &["7, 1, 2", "8, 2, 3"], &["9, 4, 5", "10, 5, 6"])).unwrap();
    let apart = whole
        .replace("*ELEMENT, TYPE=B31, ELSET=FIRST", "*ELEMENT, \n** a set\n TYPE=B31,\nELSET=FIRST")
        .replace("*Element , elset=SECOND, type=B31", "*Element ,elset=SECOND,\ntype=B31,")
        .replace("*NODE, NSET=ALL", "*NODE, NSET=ALL,");
    for text in [apart.clone(), apart.replace('\n', "\r\n")] {
        let found = read("a.inp", text.as_bytes());
        let said: Vec<_> = found.curves.iter().map(|curve| (curve.name.as_str(), curve.diameter)).collect();
        assert_eq!(said, [("FIRST", Some(1.0)), ("SECOND", None)]);
        let points: Vec<_> = found.curves.iter().map(|curve| curve.points.clone()).collect();
        assert_eq!(points, CURVES.map(<[_]>::to_vec));
    }
}

/// What neither makes nor moves a node is passed over: directions of degrees of freedom, a system that is the global one.
#[test]
fn keywords_that_move_no_node_are_passed_over() {
    let text = String::from_utf8(inp("\n", "B31", &["7, 1, 2", "8, 2, 3"], &["9, 4, 5", "10, 5, 6"])).unwrap();
    let text =
        text.replace("*NODE, NSET", "*TRANSFORM, NSET=ALL, TYPE=C\n0, 0, 0, 0, 0, 1\n*SYSTEM\n*NODE, SYSTEM=R, NSET");
    assert_eq!(read("a.inp", text.as_bytes()).curves.len(), 2);
}

#[test]
fn a_ring_repeats_its_first_point() {
    let ring = read("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 3 1\nl 2 3\n");
    assert_eq!((ring.curves.len(), ring.curves[0].ring().map(<[_]>::len)), (1, Some(3)));
    // three pieces that meet are no curve: each stands by itself
    let star = read("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 2\nl 1 3\nl 1 4\n");
    assert_eq!((star.curves.len(), star.curves[0].ring()), (3, None));
}

/// The sentence of each mistake, and where it points to.
#[test]
fn every_mistake_is_one_sentence_with_its_place() {
    let binary = legacy(true);
    let cut = |bytes: &[u8], by: usize| bytes[..bytes.len() - by].to_vec();
    let vtp_text = String::from_utf8(vtp()).unwrap();
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("a.csv", b"".to_vec(), "a.csv: nothing is in it"),
        ("a.csv", b"\xff\xfe0\0".to_vec(), "UTF-16"),
        ("a.csv", b"x,y,z\n0,0,0\n0,abc,0\n".to_vec(), "a.csv:3:3: \"abc\" is no number; y is wanted here"),
        ("a.csv", b"x,y,z\n0,0,0\n0,0,NaN\n".to_vec(), "a.csv:3:5: \"NaN\" is not finite; z is wanted here"),
        ("a.csv", b"0,0,0\n0,0,1e999\n".to_vec(), "a.csv:2:5: \"1e999\" is too large"),
        ("a.csv", b"x;y;z\n0;0;0\n0,5;0;0\n".to_vec(), "a.csv:3:1: \"0,5\" has a decimal comma"),
        ("a.csv", b"0,0,0\n0,0\n".to_vec(), "a.csv:2: it has 2 columns, the first line 3"),
        ("a.csv", b"1,0,0,0\n1,0,0,1\n".to_vec(), "a.csv:1: 4 columns and no header"),
        ("a.csv", b"0,0\n1,1\n".to_vec(), "a.csv:1: it has two columns"),
        ("a.csv", b"time,value\n0,0\n".to_vec(), "a.csv:1: \"time,value\" names no columns x, y, z"),
        ("a.csv", b"x,y\n0,0\n".to_vec(), "a.csv:1: the header names x and y and no z"),
        ("a.csv", b"x [mm],y [mm],z [m]\n0,0,0\n".to_vec(), "x, y and z have different units"),
        ("a.csv", b"x,y,z,x\n0,0,0,0\n".to_vec(), "a.csv:1: column 4 is named \"x\" once more"),
        ("a.csv", b"x,y,z\n".to_vec(), "a.csv: it has no row"),
        ("a.csv", b"0,0,0\n1,1,1\n\n2,2,2\n".to_vec(), "a.csv:4: curve \"2\" has 1 point"),
        ("a.csv", b"x,y,z,diameter\n0,0,0,1\n0,0,1,2\n".to_vec(), "a.csv:3: the diameter changes"),
        ("a.csv", b"x,y,z,diameter\n0,0,0,-1\n".to_vec(), "a.csv:2:7: a diameter of -1"),
        ("a.csv", b"0,0,0\n\xc3\x28,0,0\n".to_vec(), "a.csv:2:1: this is no text in UTF-8"),
        ("a.csv", b"0,0,0\n0,0,1e301\n".to_vec(), "a.csv: curve \"1\" has a coordinate beyond 1e300"),
        ("a.xyz", b"3\n\nC 0 0 0\n".to_vec(), "a.xyz:1: 3 points are announced here, and the file ends after 1"),
        ("a.xyz", b"99999999999999\n\nC 0 0 0\n".to_vec(), "the file ends after 1"),
        ("a.xyz", b"2\n\nC 0 0 0\nC 0 0\n".to_vec(), "a.xyz:4: \"C 0 0\" has no z"),
        ("a.xyz", b"2\n\nC 0 0 0\nC 0 0 1\nC 0 0 2\n".to_vec(), "a.xyz:5: \"C 0 0 2\" is no count"),
        ("a.inp", b"*HEADING\n".to_vec(), "a.inp: it has no `*NODE`"),
        ("a.inp", b"*NODE\n1, 0\n*ELEMENT, TYPE=C3D8\n1, 1\n".to_vec(), "a.inp: it has no beams or trusses"),
        ("a.inp", b"*NODE\n1, 0, x\n".to_vec(), "a.inp:2:7: \"x\" is no number; y is wanted here"),
        ("a.inp", b"*NODE\n1, 0\n1, 1\n".to_vec(), "a.inp:3: there is a node 1 above already"),
        ("a.inp", b"*NODE\n1, 0\n*ELEMENT, TYPE=B31\n1, 1, 2\n".to_vec(), "a.inp:4:7: there is no node 2 above"),
        ("a.inp", b"*NODE\n1, 0\n*ELEMENT, TYPE=B31\n1, 1\n".to_vec(), "a.inp:4: element 1 has 1 node; a B31 has 2"),
        ("a.inp", inp("\n", "B32", &["1, 1, 2"], &["2, 4, 5, 6"]), "a.inp:12: element 1 has 2 nodes; a B32 has 3"),
        ("a.inp", inp("\n", "B31", &["1, 1, 2, 3, 4"], &["2, 4, 5"]), "a.inp:12: element 1 has 4 nodes; a B31 has 2"),
        ("a.inp", b"*NODE\n1.5, 0\n".to_vec(), "a.inp:2:1: \"1.5\" is no whole number"),
        ("a.inp", b"*NODE, INPUT=n.inp\n".to_vec(), "a.inp:1: its lines are in another file"),
        ("a.inp", b"*INCLUDE, INPUT=n.inp\n".to_vec(), "a.inp:1: another file is included"),
        ("a.inp", b"*Instance, name=a, part=b\n".to_vec(), "a.inp:1: parts are put together here"),
        ("a.pdb", b"HEADER\n".to_vec(), "a.pdb: no chain has two"),
        (
            "a.pdb",
            pdb().replace("   1.250", "   1.2S0").into_bytes(),
            "a.pdb:7:39: \"1.2S0\" is no number; y (columns 39",
        ),
        ("a.obj", b"v 0 0 0\nv 0 0\n".to_vec(), "a.obj:2: there is no z"),
        ("a.obj", b"v 0 0 0\nv 0 0 1\nl 1 3\n".to_vec(), "a.obj:3:5: there is no point 3; 2 points stand above"),
        ("a.obj", b"v 0 0 0\nv 0 0 1\nl 1 0\n".to_vec(), "a.obj:3:5: there is no point 0"),
        ("a.obj", b"v 0 0 0\nv 0 0 1\nf 1 2 1\n".to_vec(), "a.obj: it has faces and no `l` lines"),
        ("a.npy", b"\x93NUMPY\x01\0\xff\xff{".to_vec(), "the file ends within its header"),
        ("a.npy", npy("<f8", false, "(2, 3)", &[0; 47]), "47 bytes follow; the shape (2, 3) asks for 48 bytes"),
        ("a.npy", npy("<f8", false, "(4611686018427387904, 3)", &[0; 8]), "more than any machine's memory"),
        ("a.npy", npy("<f8", false, "(4, 2)", &[0; 64]), "its shape is (4, 2)"),
        ("a.npy", npy("<c16", false, "(2, 3)", &[0; 96]), "numbers are of type \"<c16\""),
        (
            "a.npy",
            npy("<f8", false, "(2, 3)", &f64::NAN.to_le_bytes().repeat(6)),
            "point 1 has a coordinate that is not finite",
        ),
        ("a.npy", npy("<f8", false, "(9223372036854775807, 0, 3)", &[]), "curve \"1\" has 0 points"),
        ("a.vtk", cut(&binary, 4), "8 numbers of 4 bytes are announced here, and 29 bytes are left"),
        (
            "a.vtk",
            b"# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 0 0 z".to_vec(),
            "\"z\" is no number",
        ),
        (
            "a.vtk",
            b"# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 99999999999 float\n0 0 0".to_vec(),
            "the file ends where a coordinate is wanted",
        ),
        (
            "a.vtk",
            b"# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\n".to_vec(),
            "POLYDATA or UNSTRUCTURED_GRID",
        ),
        (
            "a.vtk",
            b"# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 0 0 1\nLINES 1 3\n2 0 2\n"
                .to_vec(),
            "point 2; the file has 2 points",
        ),
        ("a.vtp", vtp_text.replace("</Lines>", "").into_bytes(), "this is not XML"),
        ("a.vtp", vtp_text.replace("3 6<", "3 7<").into_bytes(), "the offsets do not rise"),
        ("a.vtp", vtp_text.replace("3 4 5<", "3 4 6<").into_bytes(), "a cell has point 6"),
        ("a.vtp", vtp_text.replace("NumberOfPoints=\"6\"", "NumberOfPoints=\"7\"").into_bytes(), "7 points"),
        ("a.npz", b"PK".to_vec(), "numpy.save"),
        ("a.csv.gz", b"\x1f\x8b".to_vec(), "unpack it first"),
    ];
    for (name, bytes, said) in cases {
        let error = refused(name, &bytes).to_string();
        assert!(error.contains(said), "{error}\nand not: {said}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert!(error.starts_with(name), "{error}");
    }
}

/// Files with packed and appended data, as VTK writes them.
const WRITTEN: [(&str, &[u8]); 5] = [
    ("a.vtp", include_bytes!("curves/appended-zlib.vtp")),
    ("a.vtp", include_bytes!("curves/inline-zlib.vtp")),
    ("a.vtp", include_bytes!("curves/appended-raw.vtp")),
    ("a.vtu", include_bytes!("curves/grid.vtu")),
    ("a.vtk", include_bytes!("curves/legacy-5-binary.vtk")),
];

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config(3000))]

    /// Whatever is done to a good file, it is read or refused in one sentence, and what is read is finite.
    #[test]
    fn no_change_to_a_good_file_panics(
        at in 0..good().len() + WRITTEN.len(),
        changes in proptest::collection::vec((any::<u16>(), any::<u8>(), 0..5_u8), 1..6),
        as_what in 0..24_usize,
    ) {
        let mut all = good();
        all.extend(WRITTEN.map(|(name, bytes)| (name, bytes.to_vec())));
        let (name, mut bytes) = all.swap_remove(at);
        for (place, byte, kind) in changes {
            let place = usize::from(place) % bytes.len().max(1);
            match kind {
                0 if place < bytes.len() => bytes[place] = byte,
                1 if place < bytes.len() => { bytes.remove(place); }
                2 => bytes.insert(place, b"0123456789-.e \n,"[usize::from(byte % 16)]),
                3 => bytes.truncate(place),
                4 => { let tail = bytes[place..].to_vec(); bytes.extend(tail); }
                _ => {}
            }
        }
        match Curves::read(name, &bytes, Format::ALL.get(as_what).copied()) {
            Ok(found) => {
                prop_assert!(!found.curves.is_empty());
                for curve in &found.curves {
                    prop_assert!(curve.points.len() > 1 && curve.points.iter().flatten().all(|v| v.is_finite()));
                }
            }
            Err(error) => prop_assert_eq!(error.to_string().lines().count(), 1, "{}", error),
        }
    }

    #[test]
    fn no_bytes_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300), as_what in 0..Format::ALL.len()) {
        let _ = Curves::read("a", &bytes, Some(Format::ALL[as_what]));
    }
}

/// Files written by VTK and NumPy themselves (tests/curves/make.py), against the rows of a text.
#[test]
fn files_of_the_programs_the_formats_come_from_are_read() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/curves");
    let open = |name: &str| std::fs::read(folder.join(name)).unwrap();
    let all = read("expected.txt", &open("expected.txt")).curves.swap_remove(0).points;
    let (helix, corner) = all.split_at(40);
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| [".vtk", ".vtp", ".vtu", ".npy"].iter().any(|ending| name.ends_with(ending)))
        .collect();
    names.sort();
    assert_eq!(names.len(), 15, "{names:?}");
    for name in names {
        let found = read(&name, &open(&name));
        assert_eq!(found.curves[0].points, helix, "{name}");
        if !name.ends_with(".npy") {
            assert_eq!(found.curves[1].points, corner, "{name}");
            assert_eq!(found.curves.len(), 2, "{name}");
            assert_eq!(found.notes.len(), 1, "{name}: {:?}", found.notes);
        }
    }
}
