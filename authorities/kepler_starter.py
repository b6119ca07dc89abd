"""Makes crates/nply/src/numerics/kepler_starter.rs: polynomials that start the contact solve.

    python authorities/kepler_starter.py > crates/nply/src/numerics/kepler_starter.rs

With lambda = 2 pi/n and E = lambda - x sin(theta), contact is E + tan(theta)^2 sin E = lambda.  E/t^2 is smooth in t^2,
t = pi/2 - theta, which is known before any sine; each row holds the monomial coefficients, in u on (-1, 1), of its
Chebyshev interpolant on 64 nodes, cut.  n = 2 has a square root at theta = pi/4 and gets two rows of its own: E/w in
w = cos(theta)^2 < 1/4, and (pi - E)/sqrt(1 - v) in v = cot(theta)^2.      pip install mpmath numpy
"""
import numpy as np, mpmath as mp
from numpy.polynomial import chebyshev as C

mp.mp.dps = 40
DEGREE, MAIN_DEGREE, NODES = 12, 14, 64


def anomaly(n, w):
    lam = 2 * mp.pi / n
    e = (1 - w) / w
    E = lam / (1 + e)  # below the root, where the left side is concave: Newton climbs and cannot overshoot
    for _ in range(300):
        step = (lam - E - e * mp.sin(E)) / (1 + e * mp.cos(E))
        E += step
        if abs(step) < mp.mpf(10) ** -36 * E:
            return E
    raise SystemExit(f"no convergence at n = {n}, w = {w}")


def sinc_inverse(v):
    return mp.findroot(lambda z: mp.sin(z) / z - v, mp.sqrt(6 * (1 - v)) * (1 + (1 - v) * mp.mpf("0.28")), tol=1e-34)


def row(f, a, b, degree=DEGREE):
    x = np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
    y = np.array([float(f(mp.mpf(a) + (mp.mpf(b) - a) * (mp.mpf(t) + 1) / 2)) for t in x])
    c = C.chebfit(x, y, NODES - 1)[: degree + 1]
    error = np.abs(C.chebval(x, c) / y - 1).max()
    return C.cheb2poly(c), error


def show(name, doc, coefficients):
    print(f"/// {doc}")
    print(f"pub(super) const {name}: [f64; {DEGREE + 1}] = [")
    for c in coefficients:
        print(f"    {float(c)!r},")
    print("];\n")


print("//! Made by `authorities/kepler_starter.py`; do not edit.\n")
print(f"/// How far the starters reach: n = 3 to {{}} strands have a row of their own.".format(12))
print("pub(super) const LAST: usize = 12;\n")
c, err = row(lambda v: sinc_inverse(v) / mp.sqrt(1 - v), 0, 1)
show("PITCHFORK", f"n = 2: (π − E)/√(1 − v), v = cot²θ = (1 + u)/2. Relative error {err:.1e}.", c)
c, err = row(lambda w: anomaly(2, w) / w, 0, mp.mpf(1) / 4)
show("TALL", f"n = 2, w < 1/4: E/w, w = (1 + u)/8. Relative error {err:.1e}.", c)
print("/// n = 3 … 12: E/t², t = π/2 − θ, t² = (1 + u)π²/8.")
quarter = mp.pi**2 / 4
rows = [row(lambda v: anomaly(n, mp.sin(mp.sqrt(v)) ** 2) / v, 0, quarter, MAIN_DEGREE) for n in range(3, 13)]
print("/// Relative errors " + ", ".join(f"{e:.0e}" for _, e in rows) + ".")
print(f"pub(super) const MAIN: [[f64; {MAIN_DEGREE + 1}]; 10] = [")
for c, _ in rows:
    print("    [")
    for k in c:
        print(f"        {float(k)!r},")
    print("    ],")
print("];")
