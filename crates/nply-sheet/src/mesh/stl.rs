//! Binary STL.

use super::{FileUnit, Surface, said, single};

/// 80 bytes of text, the number of triangles, and 50 bytes each: normal, corners, nothing.
pub(super) fn write(surface: &Surface<'_>, unit: &FileUnit) -> Vec<u8> {
    let [_, count] = surface.counts();
    let mut out = said(&surface.assembly.title, unit).into_bytes();
    out.resize(80, b' ');
    out.extend(u32::try_from(count).unwrap_or(u32::MAX).to_le_bytes());
    for part in &surface.parts {
        for triangle in &part.mesh.triangles {
            let [a, b, c] = triangle.map(|i| unit.point(part.mesh.positions[i as usize]));
            let (u, v): ([f64; 3], [f64; 3]) =
                (core::array::from_fn(|i| b[i] - a[i]), core::array::from_fn(|i| c[i] - a[i]));
            let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let size = libm::sqrt(normal.iter().map(|x| x * x).sum::<f64>());
            let normal = normal.map(|x| if size > 0.0 { x / size } else { 0.0 });
            for vector in [normal, a, b, c] {
                vector.iter().for_each(|x| out.extend(single(*x).to_le_bytes()));
            }
            out.extend([0; 2]);
        }
    }
    out
}
