//! Wavefront OBJ.

use core::fmt::Write as _;

use super::{FileUnit, Surface, said, single};

/// A group a strand, and one for its stripes; colours stand behind the corners, as most programs read them. Numbers count from 1.
pub(super) fn write(surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
    let mut out = format!("# {}\n", said(&surface.assembly.title, unit));
    let (mut corner, mut normal) = (1_u64, 1_u64);
    for part in &surface.parts {
        let _ = writeln!(out, "o {}", part.wire.name);
        let colour = part.wire.colour.map(|x| f32::from(x) / 255.0);
        for position in &part.mesh.positions {
            let [x, y, z] = unit.point(*position).map(single);
            let _ = writeln!(out, "v {x} {y} {z} {:.4} {:.4} {:.4}", colour[0], colour[1], colour[2]);
        }
        for n in part.mesh.normals.iter().chain(&part.mesh.end_normals) {
            let _ = writeln!(out, "vn {:.6} {:.6} {:.6}", n[0], n[1], n[2]);
        }
        let corners = part.mesh.positions.len() as u64;
        let ends = (part.mesh.triangles.len() - part.mesh.sides) / 2;
        for striped in [false, true] {
            if striped && part.wire.stripes == 0 {
                continue;
            }
            let _ = writeln!(out, "g {}{}", part.wire.name, if striped { "-stripe" } else { "" });
            for (number, triangle) in part.mesh.triangles.iter().enumerate() {
                if part.is_striped(number) != striped {
                    continue;
                }
                out.push('f');
                for i in triangle {
                    let own = u64::from(*i);
                    // ends look along the wire, up to their edge
                    let n = match number.checked_sub(part.mesh.sides) {
                        None => own,
                        Some(beyond) => corners + u64::from(beyond >= ends),
                    };
                    let _ = write!(out, " {}//{}", corner + own, normal + n);
                }
                out.push('\n');
            }
        }
        corner += corners;
        normal += corners + 2;
    }
    for line in &surface.assembly.lines {
        let _ = writeln!(out, "o {}", line.name);
        for point in &line.points {
            let [x, y, z] = unit.point(*point).map(single);
            let _ = writeln!(out, "v {x} {y} {z} 0 0 0");
        }
        out.push('l');
        for _ in &line.points {
            let _ = write!(out, " {corner}");
            corner += 1;
        }
        out.push('\n');
    }
    out.into_bytes()
}
