//! Shapes read back by other people's readers, where there are such, and by plain ones where there are not.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "an independent route takes the platform's functions")]

mod command;

use std::collections::{BTreeMap, HashMap};
use std::f64::consts::PI;
use std::fs;
use std::path::PathBuf;

use command::{call, out};

type Point = [f64; 3];

fn file(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("mesh");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

/// The file that a call writes, and what it says of it.
fn written(name: &str, arguments: &[&str]) -> (Vec<u8>, String) {
    let path = file(name);
    let _ = fs::remove_file(&path);
    let said = out(&[&["mesh"], arguments, &["--output", path.to_str().unwrap()]].concat());
    (fs::read(&path).unwrap(), said)
}

/// Triangles of points.
#[derive(Default)]
struct Soup {
    points: Vec<Point>,
    faces: Vec<[usize; 3]>,
}

impl Soup {
    /// With points at the same place made one.
    fn merged(&self) -> Self {
        let mut numbers: HashMap<[u64; 3], usize> = HashMap::new();
        let mut merged = Self::default();
        let own: Vec<usize> = self
            .points
            .iter()
            .map(|point| {
                let next = numbers.len();
                let number = *numbers.entry(point.map(|x| (x + 0.0).to_bits())).or_insert(next);
                if number == next {
                    merged.points.push(*point);
                }
                number
            })
            .collect();
        merged.faces = self.faces.iter().map(|face| face.map(|i| own[i])).collect();
        merged
    }

    fn volume(&self) -> f64 {
        let origin = self.points[0];
        let corner = |i: usize| -> Point { std::array::from_fn(|k| self.points[i][k] - origin[k]) };
        let six = self.faces.iter().map(|face| {
            let [a, b, c] = face.map(corner);
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        six.sum::<f64>() / 6.0
    }

    /// Closed, outward, and V − E + F = 2 for each of so many bodies.
    #[track_caller]
    fn check(&self, bodies: usize, volume: f64) {
        let merged = self.merged();
        let mut edges: HashMap<(usize, usize), u32> = HashMap::new();
        for [a, b, c] in &merged.faces {
            for edge in [(*a, *b), (*b, *c), (*c, *a)] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        assert!(edges.iter().all(|(&(a, b), &count)| count == 1 && edges.contains_key(&(b, a))), "not closed");
        assert_eq!(merged.points.len() + merged.faces.len(), edges.len() / 2 + 2 * bodies);
        let found = merged.volume();
        assert!((found / volume - 1.0).abs() < 0.02, "{found} {volume}");
    }
}

fn stl(bytes: &[u8]) -> Soup {
    let mesh = stl_io::read_stl(&mut std::io::Cursor::new(bytes)).unwrap();
    let points = mesh.vertices.iter().map(|v| [v[0], v[1], v[2]].map(f64::from)).collect();
    Soup { points, faces: mesh.faces.iter().map(|face| face.vertices).collect() }
}

fn obj(bytes: &[u8]) -> (Soup, Vec<tobj::Model>) {
    let (models, _) = tobj::load_obj_buf(&mut &bytes[..], &tobj::LoadOptions::default(), |_| {
        Ok((Vec::new(), HashMap::new().into_iter().collect()))
    })
    .unwrap();
    let mut soup = Soup::default();
    for model in &models {
        let first = soup.points.len();
        soup.points.extend(model.mesh.positions.chunks(3).map(|p| [p[0], p[1], p[2]].map(f64::from)));
        if model.name.starts_with("contact") || model.name.starts_with("cut") {
            continue;
        }
        soup.faces.extend(model.mesh.indices.chunks(3).map(|f| [f[0], f[1], f[2]].map(|i| first + i as usize)));
    }
    (soup, models)
}

fn glb(bytes: &[u8]) -> (Soup, BTreeMap<String, usize>) {
    let gltf = gltf::Gltf::from_slice(bytes).unwrap(); // with its own checks of the whole document
    let blob = gltf.blob.as_ref().unwrap();
    let (mut soup, mut lines) = (Soup::default(), BTreeMap::new());
    for node in gltf.nodes() {
        let mesh = node.mesh().unwrap();
        for primitive in mesh.primitives() {
            let reader = primitive.reader(|_| Some(blob));
            let first = soup.points.len();
            let positions: Vec<Point> = reader.read_positions().unwrap().map(|p| p.map(f64::from)).collect();
            if primitive.mode() == gltf::mesh::Mode::LineStrip {
                lines.insert(node.name().unwrap().to_owned(), positions.len());
                continue;
            }
            let limits = primitive.bounding_box();
            for (i, (low, high)) in limits.min.into_iter().zip(limits.max).enumerate() {
                assert!(positions.iter().all(|p| p[i] >= f64::from(low) && p[i] <= f64::from(high)));
            }
            let normals = reader.read_normals().unwrap();
            assert!(normals.into_iter().all(|n| (n.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-5));
            soup.points.extend(positions);
            let indices: Vec<usize> = reader.read_indices().unwrap().into_u32().map(|i| first + i as usize).collect();
            soup.faces.extend(indices.chunks(3).map(|f| [f[0], f[1], f[2]]));
        }
    }
    (soup, lines)
}

/// Corners of 27 bytes, faces of 16.
fn ply(bytes: &[u8]) -> Soup {
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let head = std::str::from_utf8(&bytes[..end]).unwrap();
    let count = |what: &str| -> usize {
        let line = head.lines().find_map(|line| line.strip_prefix(&format!("element {what} "))).unwrap();
        line.parse().unwrap()
    };
    assert!(head.starts_with("ply\nformat binary_little_endian 1.0\n"));
    let (corners, faces) = bytes[end..].split_at(27 * count("vertex"));
    assert_eq!(faces.len(), 16 * count("face"));
    let four = |bytes: &[u8], i: usize| <[u8; 4]>::try_from(&bytes[i..i + 4]).unwrap();
    let float = |bytes: &[u8], i: usize| f64::from(f32::from_le_bytes(four(bytes, i)));
    Soup {
        points: corners.chunks(27).map(|row| [0, 4, 8].map(|i| float(row, i))).collect(),
        faces: faces.chunks(16).map(|row| [1, 5, 9].map(|i| i32::from_le_bytes(four(row, i)) as usize)).collect(),
    }
}

/// Numbers behind a word of legacy VTK.
fn after(text: &str, word: &str, count: usize) -> Vec<f64> {
    let (_, rest) = text.split_once(word).unwrap_or_else(|| panic!("no {word}"));
    let rest = rest.split_once('\n').unwrap().1;
    rest.split_whitespace().take(count).map(|x| x.parse().unwrap()).collect()
}

fn vtk(text: &str) -> Soup {
    let count = |word: &str| -> usize {
        let line = text.lines().find_map(|line| line.strip_prefix(word)).unwrap();
        line.split_whitespace().next().unwrap().parse().unwrap()
    };
    let points = after(text, "\nPOINTS ", 3 * count("POINTS "));
    let faces = after(text, "\nPOLYGONS ", 4 * count("POLYGONS "));
    Soup {
        points: points.chunks(3).map(|p| [p[0], p[1], p[2]]).collect(),
        faces: faces.chunks(4).map(|f| [f[1] as usize, f[2] as usize, f[3] as usize]).collect(),
    }
}

/// The bytes of a list of numbers in VTK's XML.
fn array(text: &str, name: &str) -> Vec<u8> {
    let (_, rest) = text.split_once(&format!("Name=\"{name}\"")).unwrap_or_else(|| panic!("no {name}"));
    let text = rest.split_once('>').unwrap().1.split_once('<').unwrap().0;
    let digit =
        |c: u8| b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/".iter().position(|d| *d == c);
    let mut bytes = Vec::new();
    for four in text.as_bytes().chunks(4) {
        let digits: Vec<usize> = four.iter().map_while(|c| digit(*c)).collect();
        let number = digits.iter().fold(0, |number, d| number << 6 | d) << (6 * (4 - digits.len()));
        bytes.extend((0..digits.len() - 1).map(|i| (number >> (16 - 8 * i)) as u8));
    }
    let size = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
    assert_eq!(bytes.len(), size + 4);
    bytes.split_off(4)
}

fn floats(text: &str, name: &str) -> Vec<f64> {
    array(text, name).chunks(4).map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap()))).collect()
}

fn integers(text: &str, name: &str) -> Vec<usize> {
    array(text, name).chunks(4).map(|b| i32::from_le_bytes(b.try_into().unwrap()) as usize).collect()
}

const YARN: [&str; 3] = ["examples/three-ply-yarn.toml", "--lay-lengths", "1"];

/// πr²L of the yarn's three strands in mm³: L = lay length/cos θ of the README's second state.
fn yarn_volume() -> f64 {
    3.0 * PI * 0.1375_f64.powi(2) * 2.70824 / 20.5812_f64.to_radians().cos()
}

#[test]
fn every_format_of_a_surface_is_a_closed_surface() {
    let striped = [&YARN[..], &["--stripes", "2"]].concat();
    stl(&written("yarn.stl", &YARN).0).check(3, yarn_volume());
    ply(&written("yarn.ply", &striped).0).check(3, yarn_volume());
    obj(&written("yarn.obj", &striped).0).0.check(3, yarn_volume());
    // glTF counts in metres, unless another unit is asked for
    glb(&written("yarn.glb", &striped).0).0.check(3, yarn_volume() * 1e-9);
    glb(&written("yarn.glb", &[&striped[..], &["--unit", "um"]].concat()).0).0.check(3, yarn_volume() * 1e9);
    vtk(&String::from_utf8(written("yarn.vtk", &striped).0).unwrap()).check(3, yarn_volume());
}

#[test]
fn a_coarse_or_fitted_surface_is_closed_too() {
    for more in [
        &["--facets", "5", "--segments", "7"][..],
        &["--chord-error", "2 um", "--fit", "outside"],
        &["--chord-error", "0.05", "--fit", "volume", "--ends", "square"],
        &["--core", "--fit", "inside"],
    ] {
        let (bytes, said) = written("yarn.stl", &[&YARN[..], more].concat());
        let soup = stl(&bytes);
        let core = more.contains(&"--core");
        let hole = if core { PI * 0.0243519_f64.powi(2) * 2.70824 } else { 0.0 };
        if more[0] == "--facets" {
            soup.check(3, soup.volume());
        } else {
            soup.check(3 + usize::from(core), yarn_volume() + hole);
        }
        assert!(said.contains("Three-ply yarn, state 2 of 3: left-handed (S), helical angle 20.5812°"), "{said}");
        assert!(said.contains("coordinates in") && said.contains("mm"));
    }
}

/// Lines on the surface, cuts in their plane, fields with their values.
#[test]
fn lines_and_fields_stand_beside_the_surface() {
    let arguments =
        ["examples/birdcage.toml", "--length", "30 mm", "--contact-lines", "--cut", "10 mm", "--cut", "0.02 m"];
    let (bytes, _) = written("strand.obj", &arguments);
    let (_, models) = obj(&bytes);
    let named = |start: &str| models.iter().filter(|model| model.name.starts_with(start)).collect::<Vec<_>>();
    // six wires on a core, clear of each other; seven outlines in each plane
    assert_eq!((named("contact").len(), named("cut-1").len(), named("cut-2").len()), (6, 7, 7));
    for (planes, height) in [("cut-1", 10.0), ("cut-2", 20.0)] {
        for model in named(planes) {
            let z = model.mesh.positions.chunks(3).map(|p| f64::from(p[2]));
            assert!(z.into_iter().all(|z| (z - height).abs() < 1e-5));
        }
    }
    for model in named("contact") {
        // on the core, 1.55 mm thick
        let off = model.mesh.positions.chunks(3).map(|p| f64::from(p[0]).hypot(f64::from(p[1])));
        let first = off.clone().next().unwrap();
        assert!(off.into_iter().all(|r| (r - first).abs() < 1e-5));
    }
    let (_, lines) = glb(&written("strand.glb", &arguments).0);
    assert_eq!(lines.len(), 20);
    let text = String::from_utf8(written("strand.vtu", &arguments).0).unwrap();
    let (strand, types) = (floats(&text, "strand"), array(&text, "types"));
    assert_eq!(strand.len(), types.len());
    assert_eq!(types.iter().filter(|kind| **kind == 4).count(), 20);
    let points = floats(&text, "Points").len() / 3;
    let ends = integers(&text, "offsets");
    assert_eq!((*ends.last().unwrap(), ends.len()), (integers(&text, "connectivity").len(), types.len()));
    assert!(integers(&text, "connectivity").into_iter().all(|i| i < points));
    let solved = command::json(&["solve", "examples/birdcage.toml", "--json"]);
    let state = &command::states(&solved)[0];
    for (field, key) in
        [("core_pressure_N_per_m", "core_pressure"), ("interstrand_pressure_N_per_m", "interstrand_pressure")]
    {
        let values = floats(&text, field);
        let expected = command::number(&state["si"], key);
        for (value, strand) in values.iter().zip(&strand) {
            // core and lines have none
            if *strand > 0.0 {
                assert!((value - expected).abs() <= 1e-6 * expected.abs())
            } else {
                assert!(value.is_nan())
            }
        }
    }
}

#[test]
fn centrelines_in_every_format_are_the_same() {
    let arguments = |name: &str| {
        let (bytes, said) = written(name, &[&YARN[..], &["--centrelines", "--elements-per-pitch", "24"]].concat());
        assert!(said.contains("75, 72"), "{said}"); // 3 times 25 nodes
        String::from_utf8(bytes).unwrap()
    };
    let csv = arguments("yarn.csv");
    let mut rows = csv.lines();
    assert_eq!(rows.next().unwrap(), "wire,node,arclength_mm,x_mm,y_mm,z_mm,tangent_x,tangent_y,tangent_z,radius_mm");
    let nodes: Vec<(String, Vec<f64>)> = rows
        .map(|row| {
            let mut cells = row.split(',');
            (cells.next().unwrap().to_owned(), cells.map(|cell| cell.parse().unwrap()).collect())
        })
        .collect();
    assert_eq!(nodes.len(), 75);
    for (_, node) in &nodes {
        assert!((node[2].hypot(node[3]) - 0.161852).abs() < 1e-6);
    }
    // a lay length up, and round
    assert!((nodes[24].1[4] - 2.70824).abs() < 1e-5 && (nodes[24].1[2] - nodes[0].1[2]).abs() < 1e-12);
    let xyz = arguments("yarn.xyz");
    assert_eq!(xyz.lines().next().unwrap(), "75");
    for (line, (_, node)) in xyz.lines().skip(2).zip(&nodes) {
        let place: Vec<f64> = line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect();
        assert_eq!(place, node[2..5].to_vec());
    }
    let inp = arguments("yarn.inp");
    let (mut place, mut elements, mut sets) = (String::new(), BTreeMap::new(), Vec::new());
    let mut count = 0;
    for line in inp.lines().skip(2) {
        if line.starts_with("**") {
        } else if let Some(keyword) = line.strip_prefix('*') {
            keyword.clone_into(&mut place);
            sets.extend(keyword.strip_prefix("ELEMENT, TYPE=B31, ELSET=").map(str::to_owned));
        } else if place == "NODE" {
            let cells: Vec<f64> = line.split(", ").map(|x| x.parse().unwrap()).collect();
            // sixteen digits of the greatest, 2.7
            assert!(cells[1..].iter().zip(&nodes[count].1[2..5]).all(|(inp, csv)| (inp - csv).abs() <= 5.1e-16));
            count += 1;
            assert_eq!(cells[0] as usize, count);
        } else if place.starts_with("ELEMENT") {
            let cells: Vec<usize> = line.split(", ").map(|x| x.parse().unwrap()).collect();
            assert!(cells[2] == cells[1] + 1 && nodes[cells[1] - 1].0 == nodes[cells[2] - 1].0);
            *elements.entry(place.clone()).or_insert(0) += 1;
        }
    }
    assert_eq!((count, sets), (75, ["STRAND-1", "STRAND-2", "STRAND-3"].map(str::to_owned).to_vec()));
    assert!(elements.values().all(|count| *count == 24));
    let vtp = arguments("yarn.vtp");
    let points: Vec<f64> = array(&vtp, "Points").chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect();
    assert!(points.chunks(3).zip(&nodes).all(|(point, (_, node))| *point == node[2..5]));
    assert_eq!(integers(&vtp, "offsets"), [25, 50, 75]);
}

#[test]
fn a_trace_of_atoms_is_in_angstroms() {
    let (bytes, _) = written("dna.pdb", &["examples/dna-supercoil.toml", "--centrelines"]);
    let text = String::from_utf8(bytes).unwrap();
    let atoms: Vec<&str> = text.lines().filter(|line| line.starts_with("ATOM")).collect();
    for atom in &atoms {
        let [x, y] = [30, 38].map(|i| atom[i..i + 8].trim().parse::<f64>().unwrap());
        assert!((x.hypot(y) - 10.0).abs() < 1e-3, "{atom}"); // two strands of radius 1 nm in line contact
        assert_eq!((&atom[12..16], &atom[21..22].len(), atom.len()), (" CA ", &1, 80));
    }
    assert_eq!(text.lines().filter(|line| line.starts_with("CONECT")).count(), atoms.len() - 2);
    // a yarn has no room in its columns
    let path = file("refused.pdb");
    let refused = call(&["mesh", YARN[0], "--centrelines", "--output", path.to_str().unwrap()]);
    assert_eq!(refused.code, 1);
    assert!(refused.err.contains("--unit") && !path.exists(), "{}", refused.err);
    assert!(
        written("yarn.pdb", &[YARN[0], "--centrelines", "--unit", "um"])
            .1
            .contains("coordinates in                              um")
    );
}

#[test]
fn what_cannot_be_drawn_is_refused_in_one_sentence() {
    let lay = ["mesh", "--strands", "3", "--helical-angle", "20 deg"];
    for (more, code, part) in [
        (&["--output", "a.docx"][..], 2, "tells no format"),
        (&[], 2, "say where to write it"),
        (&["--format", "stl", "--contact-lines"], 2, "has no place for this"),
        (&["--format", "stl", "--centrelines"], 2, "has no place for this"),
        (&["--format", "obj", "--length", "2 mm"], 2, "no size to measure it by"),
        (&["--format", "obj", "--length", "-2"], 1, "greater than 0"),
        (&["--format", "obj", "--length", "nan"], 2, "--length"),
        (&["--format", "obj", "--lay-lengths", "nan"], 1, "greater than 0"),
        (&["--format", "obj", "--lay-lengths", "1", "--length", "3"], 2, "both say how much"),
        (&["--format", "obj", "--core", "0.9"], 1, "overlaps the strands"),
        (&["--format", "obj", "--cut", "1000"], 1, "passes by the ply"),
        (&["--format", "obj", "--chord-error", "1e-12"], 1, "--chord-error"),
        (&["--format", "obj", "--chord-error", "0.1", "--facets", "9"], 2, "both say how fine"),
        (&["--format", "obj", "--facets", "2"], 1, "at least 3"),
        (&["--format", "obj", "--state", "1"], 2, "the lay alone is given"),
        (&["--format", "obj", "--unit", "mm"], 2, "no size"),
        (&["--format", "obj", "--diameter", "1 mm", "--unit", "N"], 2, "no unit of length"),
        (&["--format", "obj", "--diameter", "1 mm", "--length", "3"], 2, "has no unit"),
    ] {
        let found = call(&[&lay[..], more].concat());
        assert_eq!((found.code, found.out.as_str()), (code, ""), "{more:?}: {}", found.err);
        assert!(found.err.contains(part) && found.err.starts_with("error: "), "{more:?}: {}", found.err);
        assert_eq!(found.err.trim_end().lines().count(), 1, "{}", found.err);
    }
    // what would be without effect is not taken
    for more in [
        &["--centrelines", "--stripes", "2"][..],
        &["--centrelines", "--fit", "inside"],
        &["--elements-per-pitch", "9"],
    ] {
        let found = call(&[&lay[..], &["--format", "csv"], more].concat());
        assert_eq!((found.code, found.out.as_str()), (2, ""), "{more:?}: {}", found.err);
    }
    let straight = call(&["mesh", "--strands", "3", "--helical-angle", "0 deg", "--format", "obj"]);
    assert!(straight.code == 1 && straight.err.contains("straight strands have no lay length"), "{}", straight.err);
    let state = call(&["mesh", YARN[0], "--state", "7", "--format", "obj"]);
    assert!(state.code == 1 && state.err.contains("there are 3 states"), "{}", state.err);
}

/// Without a file, the file itself goes to the pipe.
#[test]
fn a_pipe_gets_the_bytes() {
    let arguments = ["mesh", "--strands", "2", "--helical-angle", "30 deg", "--length", "4", "--format", "stl"];
    let piped = command::command(&arguments).output().unwrap();
    assert!(piped.status.success() && piped.stderr.is_empty());
    stl(&piped.stdout).check(2, 2.0 * PI * 4.0 / 30_f64.to_radians().cos());
    let header = String::from_utf8(piped.stdout[..80].to_vec()).unwrap();
    assert!(header.contains("2 touching strands; coordinates in strand radii"), "{header}");
}

/// A rope from its file: a body for each wire, named by layer, strand and wire; what belongs to a ply is refused.
#[test]
fn a_rope_is_written_wire_by_wire() {
    let rope = "examples/rope-6x7.toml";
    let (bytes, said) = written("rope.obj", &[rope, "--length", "20 mm", "--chord-error", "0.02", "--unit", "mm"]);
    let (soup, models) = obj(&bytes);
    let names: Vec<&str> = models.iter().map(|model| model.name.as_str()).collect();
    assert!(names.len() == 43 && names[0] == "layer1-strand1-wire1" && names[42] == "core", "{names:?}");
    assert!(said.contains("layer 1: 6 strands, Z") && said.contains("20 mm"), "{said}");
    // six wires and a core wire a strand, each longer than the rope by its lay, and the fibre core
    let strand = 6.0 * 0.625_f64.powi(2) / (14.05_f64.to_radians().cos()) + 0.65_f64.powi(2);
    let volume = PI * 20.0 * (6.0 * strand / 18.55_f64.to_radians().cos() + 2.1_f64.powi(2));
    soup.check(43, volume);
    let heights = soup.points.iter().map(|point| point[2]);
    let [low, high] = heights.fold([f64::MAX, f64::MIN], |[low, high], z| [low.min(z), high.max(z)]);
    assert!(low.abs() < 1e-6 && (high - 20.0).abs() < 1e-5);
    let (bytes, _) = written("rope.csv", &[rope, "--centrelines", "--elements-per-pitch", "12"]);
    let table = String::from_utf8(bytes).unwrap();
    assert!(table.contains("\nlayer1-strand4-wire6,") && table.contains("\nlayer1-strand4-core,"));
    // what is known of wires that are helices: cos θ sin θ / R and sin² θ / R, and signs
    let (bytes, _) = written("spiral.vtu", &["examples/spiral-strand-1x19.toml", "--facets", "6", "--segments", "6"]);
    let text = String::from_utf8(bytes).unwrap();
    let (strand, curvature, torsion) =
        (floats(&text, "strand"), floats(&text, "curvature_per_mm"), floats(&text, "torsion_per_mm"));
    for (number, radius, pitch, hand) in [(1.0, 2.05, 60.0, -1.0), (7.0, 4.05, 110.0, 1.0)] {
        let at = strand.iter().position(|strand| (strand - number).abs() < 0.1).unwrap();
        let rise = pitch / std::f64::consts::TAU;
        let square = radius * radius + rise * rise;
        assert!((curvature[at] * square / radius - 1.0).abs() < 1e-6, "{}", curvature[at]);
        assert!((torsion[at] * square / rise - hand).abs() < 1e-6, "{}", torsion[at]);
    }
    assert!(strand.iter().zip(&curvature).all(|(strand, value)| (strand.abs() < 0.1) == value.is_nan()));
    for (arguments, part) in [
        (&["mesh", rope, "--format", "stl", "--strands", "4"][..], "describes a layered strand"),
        (&["mesh", rope, "--format", "stl", "--state", "2"], "has no states"),
        (&["nodes", rope], "describes a rope"),
    ] {
        let found = call(arguments);
        assert!(found.code != 0 && found.err.contains(part), "{arguments:?}: {}", found.err);
    }
}
