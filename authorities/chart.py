"""The contact solve to 36 digits, and functions cut into short polynomials: what the charts of the branch are made with.

Used by kepler_chart.py and contact_chart.py.      pip install mpmath
"""
import mpmath as mp

mp.mp.dps = 40


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


def chebyshev(values):
    count = len(values)
    angle = [mp.pi * (i + mp.mpf(1) / 2) / count for i in range(count)]
    c = [2 * mp.fsum(v * mp.cos(m * a) for v, a in zip(values, angle)) / count for m in range(count)]
    c[0] /= 2
    return c


def monomial(c):
    """Chebyshev to powers of u."""
    before, here = [mp.mpf(1)], [mp.mpf(0), mp.mpf(1)]
    total = [mp.mpf(0)] * len(c)
    for m, coefficient in enumerate(c):
        polynomial = before if m == 0 else here
        if m > 1:
            following = [mp.mpf(0)] + [2 * a for a in here]
            for i, a in enumerate(before):
                following[i] -= a
            before, here = here, following
            polynomial = here
        for i, a in enumerate(polynomial):
            total[i] += coefficient * a
    return total


def fit(functions, a, b, degree, nodes):
    """Polynomials in u on (-1, 1) of the functions that `functions` gives together, and their greatest relative error."""
    points = [a + (b - a) * (mp.cos(mp.pi * (i + mp.mpf(1) / 2) / nodes) + 1) / 2 for i in range(nodes)]
    rows, error = [], mp.mpf(0)
    for values in zip(*[functions(point) for point in points]):
        c = chebyshev(values)
        error = max(error, mp.fsum(abs(v) for v in c[degree + 1 :]) / min(abs(v) for v in values))
        rows.append(monomial(c[: degree + 1]))
    return rows, error


def show(row, indent):
    print(" " * indent + "[" + ", ".join(repr(float(c)) for c in row) + "],")
