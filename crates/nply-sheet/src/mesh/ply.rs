//! Binary PLY.

use super::{FileUnit, Surface, said, single};

/// Corners with normal and colour, then faces with theirs.
pub(super) fn write(surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
    let [corners, faces] = surface.counts();
    let mut out = format!(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {corners}\n\
         property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nelement face {faces}\n\
         property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        said(&surface.assembly.title, unit),
    )
    .into_bytes();
    for part in &surface.parts {
        for (position, normal) in part.mesh.positions.iter().zip(&part.mesh.normals) {
            for x in unit.point(*position).iter().chain(normal) {
                out.extend(single(*x).to_le_bytes());
            }
            out.extend(part.wire.colour);
        }
    }
    let mut first = 0;
    for part in &surface.parts {
        for (number, triangle) in part.mesh.triangles.iter().enumerate() {
            out.push(3);
            triangle.iter().for_each(|i| out.extend((first + i).to_le_bytes()));
            out.extend(part.colour(number));
        }
        first += u32::try_from(part.mesh.positions.len()).unwrap_or(u32::MAX);
    }
    out
}
