//! Binary glTF 2.0.

use serde_json::{Value, json};

use super::{FileUnit, LineKind, Surface, said, single, surface::pale};

/// Numbers of the format.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const VERTEX_BUFFER: u32 = 34_962;
const INDEX_BUFFER: u32 = 34_963;
const LINE_STRIP: u32 = 3;

#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    materials: Vec<Value>,
}

impl Buffer {
    fn view(&mut self, bytes: Vec<u8>, target: u32) -> usize {
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(), "target": target
        }));
        self.bytes.extend(bytes);
        self.views.len() - 1
    }

    fn vectors(&mut self, vectors: &[[f32; 3]], with_limits: bool) -> usize {
        let view = self.view(vectors.iter().flatten().flat_map(|x| x.to_le_bytes()).collect(), VERTEX_BUFFER);
        let mut accessor = json!({"bufferView": view, "componentType": FLOAT, "count": vectors.len(), "type": "VEC3"});
        if with_limits {
            let limit = |start: f32, choose: fn(f32, f32) -> f32| -> [f32; 3] {
                core::array::from_fn(|i| vectors.iter().map(|v| v[i]).fold(start, choose))
            };
            accessor["min"] = json!(limit(f32::INFINITY, f32::min));
            accessor["max"] = json!(limit(f32::NEG_INFINITY, f32::max));
        }
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn indices(&mut self, indices: &[u32]) -> usize {
        let view = self.view(indices.iter().flat_map(|i| i.to_le_bytes()).collect(), INDEX_BUFFER);
        let accessor =
            json!({"bufferView": view, "componentType": UNSIGNED_INT, "count": indices.len(), "type": "SCALAR"});
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn material(&mut self, name: &str, colour: [u8; 3]) -> usize {
        let [red, green, blue] = colour.map(linear);
        self.materials.push(json!({
            "name": name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [red, green, blue, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.55
            }
        }));
        self.materials.len() - 1
    }
}

/// The format counts colours by their light, not by their look (sRGB, IEC 61966-2-1).
fn linear(byte: u8) -> f64 {
    let x = f64::from(byte) / 255.0;
    if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) }
}

/// A mesh and a node for each wire and each line. Ends have corners of their own, so that their edges are shown sharp.
pub(super) fn write(surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
    let mut buffer = Buffer::default();
    let (mut meshes, mut nodes) = (Vec::new(), Vec::new());
    let mut add = |name: &str, primitives: Vec<Value>| {
        nodes.push(json!({"name": name, "mesh": meshes.len()}));
        meshes.push(json!({"name": name, "primitives": primitives}));
    };
    for part in &surface.parts {
        let mesh = &part.mesh;
        let point = |i: u32| unit.point(mesh.positions[i as usize]).map(single);
        let body = buffer.material(&part.wire.name, part.wire.colour);
        let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        let mut positions: Vec<[f32; 3]> = (0..count(mesh.positions.len())).map(point).collect();
        let mut normals: Vec<[f32; 3]> = mesh.normals.iter().map(|n| n.map(single)).collect();
        let mut faces: [Vec<u32>; 2] = [Vec::new(), Vec::new()];
        for (number, triangle) in mesh.triangles[..mesh.sides].iter().enumerate() {
            faces[usize::from(part.is_striped(number))].extend(triangle);
        }
        let ends = mesh.triangles[mesh.sides..].chunks((mesh.triangles.len() - mesh.sides).div_ceil(2).max(1));
        for (end, normal) in ends.zip(mesh.end_normals) {
            let mut own = std::collections::BTreeMap::new();
            for i in end.iter().flatten() {
                let next = count(positions.len());
                let number = *own.entry(*i).or_insert(next);
                if number == next {
                    positions.push(point(*i));
                    normals.push(normal.map(single));
                }
                faces[0].push(number);
            }
        }
        let attributes =
            json!({"POSITION": buffer.vectors(&positions, true), "NORMAL": buffer.vectors(&normals, false)});
        let mut primitives =
            vec![json!({"attributes": attributes, "indices": buffer.indices(&faces[0]), "material": body})];
        if !faces[1].is_empty() {
            let stripe = buffer.material(&format!("{}-stripe", part.wire.name), pale(part.wire.colour));
            primitives
                .push(json!({"attributes": attributes, "indices": buffer.indices(&faces[1]), "material": stripe}));
        }
        add(&part.wire.name, primitives);
    }
    for kind in [LineKind::Contact, LineKind::Cut] {
        let of_kind = || surface.assembly.lines.iter().filter(|line| line.kind == kind);
        if of_kind().next().is_none() {
            continue;
        }
        let (name, colour) = match kind {
            LineKind::Contact => ("contact", [0x20, 0x20, 0x20]),
            LineKind::Cut => ("cut", [0xf0, 0xe4, 0x42]),
        };
        let material = buffer.material(name, colour);
        for line in of_kind() {
            let points: Vec<[f32; 3]> = line.points.iter().map(|p| unit.point(*p).map(single)).collect();
            let attributes = json!({"POSITION": buffer.vectors(&points, true)});
            add(&line.name, vec![json!({"attributes": attributes, "mode": LINE_STRIP, "material": material})]);
        }
    }
    let text = json!({
        "asset": {
            "version": "2.0",
            "generator": concat!("nply ", env!("CARGO_PKG_VERSION")),
            "extras": {"title": said(&surface.assembly.title, unit), "unit": unit.name}
        },
        "scene": 0,
        "scenes": [{"nodes": (0..nodes.len()).collect::<Vec<_>>()}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": buffer.materials,
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": buffer.bytes.len()}]
    })
    .to_string();
    framed(text.into_bytes(), buffer.bytes)
}

/// 12 bytes of header, then text and numbers, each with its length and kind, filled up to fours.
fn framed(mut text: Vec<u8>, mut numbers: Vec<u8>) -> Vec<u8> {
    text.resize(text.len().next_multiple_of(4), b' ');
    numbers.resize(numbers.len().next_multiple_of(4), 0);
    let size = |n: usize| u32::try_from(n).unwrap_or(u32::MAX).to_le_bytes();
    let mut out = b"glTF\x02\0\0\0".to_vec();
    out.extend(size(12 + 8 + text.len() + 8 + numbers.len()));
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", numbers)] {
        out.extend(size(chunk.len()));
        out.extend(kind);
        out.extend(chunk);
    }
    out
}
