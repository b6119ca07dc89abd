"""Makes crates/nply/src/geometry/contact_chart.rs: arclength shift x and radius ratio rho, charted for whole arrays.

    python authorities/contact_chart.py > crates/nply/src/geometry/contact_chart.rs && cargo fmt

For n = 3 ... 12 and on each of 24 equal pieces of (0, pi/2) in theta, two smooth functions are polynomials of degree 11 in
u from -1 to 1, cut from Chebyshev interpolants on 18 nodes, to below the rounding of a double: x/theta, and rho below pi/4
or rho (pi/2 - theta) above.  For n = 2 the pieces are those of (pi/4, pi/2), and the first function is
x/sqrt(theta - pi/4), which is smooth; below, x = 0 and rho = 1.      pip install mpmath
"""
import mpmath as mp

from chart import anomaly, fit, sinc_inverse

PIECES, DEGREE = 24, 11


def at(n, flat):
    def functions(theta):
        s, c = mp.sin(theta), mp.cos(theta)
        w = c * c
        E = mp.pi - sinc_inverse(w / (1 - w)) if n == 2 and w > 0.25 else anomaly(n, w)
        x = (2 * mp.pi / n - E) / s
        rho = c / (mp.sin(E / 2) * mp.sqrt(w + s * s * mp.cos(E / 2) ** 2))
        return x / (mp.sqrt(theta - mp.pi / 4) if n == 2 else theta), rho * (mp.pi / 2 - theta if flat else 1)

    return functions


def charted(n):
    start = mp.pi / 4 if n == 2 else mp.mpf(0)
    step = (mp.pi / 2 - start) / PIECES
    ends = [start + k * step for k in range(PIECES + 1)]
    return [fit(at(n, n == 2 or k >= PIECES // 2), ends[k], ends[k + 1], DEGREE, 18) for k in range(PIECES)]


charts = {n: charted(n) for n in range(2, 13)}
worst = ", ".join(mp.nstr(max(error for _, error in chart), 1) for chart in charts.values())
print("//! Made by `authorities/contact_chart.py`; do not edit.\n")
print("/// Most strands with a chart of their own.\npub(super) const LAST: u32 = 12;\n")
print("/// Pieces of a chart, equal in helical angle: of (0, π/2), and for n = 2 of (π/4, π/2).\npub(super) const PIECES: usize = %d;\n" % PIECES)
print("/// Two polynomials of degree 11 in u: four numbers are their coefficients of two powers, aᵢ, bᵢ, aᵢ₊₁, bᵢ₊₁.")
print(f"pub(super) type Pair = [[f64; 4]; {(DEGREE + 1) // 2}];\n")
print("/// On a border of a cache line, which a pair fills three times.\n#[repr(align(64))]\npub(super) struct Charts(pub(super) [[Pair; PIECES]; 11]);\n")
print("/// n = 2 … 12, piece by piece, from one end to the other as u from −1 to 1: x/θ (n = 2: x/√(θ − π/4)), and ρ or, above π/4, ρ(π/2 − θ).")
print(f"/// Relative errors below {worst}.")
print("#[rustfmt::skip] // a table: one pair of polynomials a line")
print("pub(super) static CHARTS: Charts = Charts([")
for chart in charts.values():
    print("    [")
    for (a, b), _ in chart:
        rows = [[a[i], b[i], a[i + 1], b[i + 1]] for i in range(0, DEGREE + 1, 2)]
        print("        [" + ", ".join("[" + ", ".join(repr(float(v)) for v in row) + "]" for row in rows) + "],")
    print("    ],")
print("]);")
