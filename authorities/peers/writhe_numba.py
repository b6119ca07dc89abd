"""Writhe of a closed polygon: the solid angle of every pair of segments, in a compiled loop: numba."""

import math

import numba
from inputs import report, trefoil

POINTS = 10_000


@numba.njit
def minus(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


@numba.njit
def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


@numba.njit
def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


@numba.njit
def triangle(p, q, r, volume):
    """The solid angle of a triangle, by its corners."""
    a, b, c = math.sqrt(dot(p, p)), math.sqrt(dot(q, q)), math.sqrt(dot(r, r))
    return 2 * math.atan2(volume, a * b * c + dot(p, q) * c + dot(q, r) * a + dot(r, p) * b)


@numba.njit
def writhe(points):
    n, total = len(points), 0.0
    for i in range(n):
        a, b = points[i], points[(i + 1) % n]
        for j in range(i + 2, n if i > 0 else n - 1):
            c, d = points[j], points[(j + 1) % n]
            u, v, w, t = minus(c, a), minus(c, b), minus(d, b), minus(d, a)
            # the parallelogram that the directions from one segment to the other sweep, as two triangles
            volume = dot(u, cross(v, w))
            total += triangle(u, v, w, volume) + triangle(u, w, t, volume)
    return total / (2 * math.pi)


points = trefoil(POINTS)
writhe(points[:100])  # compiled here
report(lambda: writhe(points), 1, lambda value: value, 1)
