"""Makes crates/nply/src/numerics/kepler_chart.rs: the contact solve, charted.

    python authorities/kepler_chart.py > crates/nply/src/numerics/kepler_chart.rs && cargo fmt

With lambda = 2 pi/n and E = lambda - x sin(theta), contact is E + tan(theta)^2 sin E = lambda.  For n = 3 ... 12 its
solution is charted by the pitch angle t = pi/2 - theta, which is known before any sine: on each of 24 equal pieces of
(0, pi/2), sin(E/2)/t² and cos(E/2) are polynomials of degree 11, cut from Chebyshev interpolants on 18 nodes, to below the
rounding of a double.  n = 2 has a square root at theta = pi/4 and gets two starters: E/w in w = cos(theta)^2 < 1/4, and
(pi - E)/sqrt(1 - v) in v = cot(theta)^2.      pip install mpmath
"""
import mpmath as mp

from chart import anomaly, fit, show, sinc_inverse

PIECES, DEGREE, STARTER_DEGREE = 24, 11, 12


def charted(n):
    def at(t):
        E = anomaly(n, mp.sin(t) ** 2)
        return mp.sin(E / 2) / t**2, mp.cos(E / 2)

    step = mp.pi / 2 / PIECES
    return [fit(at, k * step, (k + 1) * step, DEGREE, 18) for k in range(PIECES)]


print("//! Made by `authorities/kepler_chart.py`; do not edit.\n")
for name, doc, f, a, b in [
    ("PITCHFORK", "n = 2: (π − E)/√(1 − v), v = cot²θ = (1 + u)/2.", lambda v: [sinc_inverse(v) / mp.sqrt(1 - v)], mp.mpf(0), mp.mpf(1)),
    ("TALL", "n = 2, w < 1/4: E/w, w = cos²θ = (1 + u)/8.", lambda w: [anomaly(2, w) / w], mp.mpf(0), mp.mpf(1) / 4),
]:
    [row], error = fit(f, a, b, STARTER_DEGREE, 48)
    print(f"/// {doc} Relative error below {mp.nstr(error, 2)}.")
    print("#[rustfmt::skip]")
    print(f"pub(super) const {name}: [f64; {STARTER_DEGREE + 1}] =")
    print("    [" + ", ".join(repr(float(c)) for c in row) + "];\n")
charts = {n: charted(n) for n in range(3, 13)}
worst = ", ".join(mp.nstr(max(error for _, error in chart), 1) for chart in charts.values())
print("/// Most strands with a chart of their own.\npub(super) const LAST: usize = 12;\n")
print("/// Pieces of a chart, equal in pitch angle.\npub(super) const PIECES: usize = %d;\n" % PIECES)
print("/// n = 3 … 12, piece by piece: sin(E/2)/t² and cos(E/2), t = π/2 − θ from one end of the piece to the other as u from −1 to 1.")
print(f"/// Relative errors below {worst}.")
print("#[rustfmt::skip] // a table: one polynomial a line")
print(f"pub(super) static CHARTS: [[[[f64; {DEGREE + 1}]; 2]; PIECES]; 10] = [")
for chart in charts.values():
    print("    [")
    for (sine, cosine), _ in chart:
        print("        [")
        show(sine, 12)
        show(cosine, 12)
        print("        ],")
    print("    ],")
print("];")
