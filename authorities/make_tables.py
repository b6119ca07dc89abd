"""Makes the golden tables of this folder, by a route that shares nothing with the crates.

    python authorities/make_tables.py --check    remake every table, compare with the files here, touch nothing
    python authorities/make_tables.py --write    remake every table into the files here
    ... NAME ...                                 only these tables (contact_geometry_more, loaded_plies, ...)

The crates solve Kepler's equation and walk along its root. Here contact is the lowest point of the squared distance (4)
in x, found by a scan and refined on equation (5); a balance is the slope of the strand's energy (52)-(55); its roots are
sought on a dense grid of angles, at every sign change and at every extremum that comes near zero; derivatives with
respect to the loads are differences between equilibria. All with 50 digits.
"""
import argparse
import csv
import io
import math
import pathlib
import random
import sys
from fractions import Fraction

import mpmath as mp

mp.mp.dps = 50
HERE = pathlib.Path(__file__).parent
BALANCES = ("radial", "contact")
HANDS = (1, -1)


# ---------------------------------------------------------------------------------------------------------------- geometry


def stationary(n, theta, x):
    """Left side of (5), and its slope in x."""
    s, c = mp.sin(theta), mp.cos(theta)
    beta = x * s - 2 * mp.pi / n
    return x * c * c + s * mp.sin(beta), c * c + s * s * mp.cos(beta)


def polish(n, theta, low, high):
    """Root of (5) in x between two values where its left side is negative and positive: Newton, kept inside by bisection."""
    low, high = mp.mpf(low), mp.mpf(high)
    x = (low + high) / 2
    for _ in range(400):
        value, slope = stationary(n, theta, x)
        low, high = (x, high) if value < 0 else (low, x)
        step = value / slope if slope > 0 else mp.inf
        new = x - step if low < x - step < high else (low + high) / 2
        if abs(new - x) <= mp.eps * 16 * abs(new):
            return new
        x = new
    raise SystemExit(f"no contact found for n = {n}, theta = {theta}")


def shift_by_scan(n, theta):
    """x of the global minimum of (4): every sample of a scan is looked at, so no branch is preferred beforehand.

    Where (4) is below its value at x = 0, at most 4, |x| cos(theta) < 2; and a trough further than one turn from x = 0
    lies higher than the one within it, because only the term x^2 cos^2 grows. For n = 2 the two signs of x are equally
    good and the positive one is taken.
    """
    t = float(theta)
    s, c, turn = math.sin(t), math.cos(t), 2 * math.pi / n
    reach = min(2 / c, 4 * math.pi / s)
    steps = 4000
    xs = [reach * i / steps for i in range(0 if n == 2 else -steps, steps + 1)]
    distance = [(x * c) ** 2 + 4 * math.sin((x * s - turn) / 2) ** 2 for x in xs]
    i = min(range(len(xs)), key=distance.__getitem__)
    if n == 2 and i == 0:
        i = 1
    return polish(n, theta, xs[i - 1] if i else xs[0], xs[i + 1])


def shift_by_bracket(n, theta):
    """The same x without the scan: (5) is negative at x = 0 and positive where x sin(theta) = 2 pi/n."""
    low = 2 * mp.pi / n * mp.mpf("1e-12") if n == 2 else 0
    return polish(n, theta, low, 2 * mp.pi / n / mp.sin(theta))


class Contact:
    """Touching strands at one angle: x, rho and the slope of rho, by (4) and its derivative at the minimum."""

    def __init__(self, n, theta, shift=shift_by_bracket):
        self.n, self.theta = n, theta
        self.s, self.c = mp.sin(theta), mp.cos(theta)
        line = n == 2 and theta <= mp.pi / 4
        self.x = mp.mpf(0) if line else shift(n, theta)
        self.beta = self.x * self.s - 2 * mp.pi / n
        self.rho = mp.mpf(1) if line else 2 / mp.sqrt((self.x * self.c) ** 2 + 4 * mp.sin(self.beta / 2) ** 2)
        # x sits at a minimum of the distance, so only the explicit dependence of (4) on theta counts
        slope = 2 * self.x * self.c * (mp.sin(self.beta) - self.x * self.s)
        self.drho = -(self.rho**3) * slope / 8
        self.contact_radius = mp.mpf(0) if line else self.rho * abs(mp.cos(self.beta / 2))


# --------------------------------------------------------------------------------------------------------------- mechanics


def energy(ply, eps, theta, rho):
    """Per unit strand length, r = B = 1: (52), (53), (55) divided by n L."""
    n, gamma, pretwist, f, m = ply
    u3 = pretwist + eps * mp.sin(theta) * mp.cos(theta) / rho
    bend = mp.sin(theta) ** 4 / (2 * rho**2)
    return bend + gamma * u3**2 / 2 - f * mp.cos(theta) / n - eps * m * mp.sin(theta) / (n * rho)


def slopes(ply, eps, s, c, rho):
    """The energy's partial slopes in theta and in rho; works on floats and on mpmath numbers alike."""
    n, gamma, pretwist, f, m = ply
    twisting = eps * gamma * (pretwist + eps * s * c / rho)
    in_theta = 2 * s**3 * c / rho**2 + twisting * (c * c - s * s) / rho + f * s / n - eps * m * c / (n * rho)
    in_rho = -(s**4) / rho**3 - twisting * s * c / rho**2 + eps * m * s / (n * rho**2)
    return in_theta, in_rho


def residual(ply, eps, balance, at):
    in_theta, in_rho = slopes(ply, eps, at.s, at.c, at.rho)
    return in_theta if balance == "radial" else in_theta + in_rho * at.drho


class Point:
    """One angle of the grid, in doubles."""

    def __init__(self, at):
        self.theta, self.s, self.c = at.theta, float(at.s), float(at.c)
        self.rho, self.drho = float(at.rho), float(at.drho)


GRIDS = {}


def grid(n):
    """Angles from 1e-9 to pi/2 - 1e-10: even steps of 0.03 degrees, steps of a few percent of the distance to either end."""
    if n not in GRIDS:
        right = mp.pi / 2
        angles = {right * i / 3000 for i in range(1, 3000)} | {mp.pi / 4}
        angles |= {mp.mpf(10) ** (mp.mpf(i) / 60) for i in range(-540, -170)}
        angles |= {right - mp.mpf(10) ** (mp.mpf(i) / 60) for i in range(-600, -170)}
        mp.mp.dps = 34
        GRIDS[n] = [Point(Contact(n, theta)) for theta in sorted(angles)]
        mp.mp.dps = 50
    return GRIDS[n]


def refine(function, a, b):
    """Root in a bracket, 45 digits: Newton by differences would need a slope; Illinois does without."""
    fa, fb = function(a), function(b)
    if fa == 0 or fb == 0:
        return a if fa == 0 else b
    assert fa * fb < 0, "the bracket holds in doubles only"
    side = 0
    for _ in range(500):
        t = (a * fb - b * fa) / (fb - fa)
        if not min(a, b) < t < max(a, b):
            t = (a + b) / 2
        ft = function(t)
        if ft == 0 or abs(b - a) < mp.mpf(10) ** -45 * min(abs(t), mp.pi / 2 - t) or abs(ft) < mp.mpf(10) ** -49:
            return t
        if ft * fb > 0:
            b, fb, fa, side = t, ft, (fa / 2 if side == -1 else fa), -1
        else:
            a, fa, fb, side = t, ft, (fb / 2 if side == 1 else fb), 1
    raise SystemExit("a bracketed root did not converge")


def extremum(function, a, b, sign):
    """Where sign * function is least between a and b; stops as soon as it is negative there."""
    golden = (mp.sqrt(5) - 1) / 2
    p, q = b - golden * (b - a), a + golden * (b - a)
    fp, fq = sign * function(p), sign * function(q)
    while fp > 0 and fq > 0 and b - a > mp.mpf(10) ** -18 * b:
        if fp < fq:
            b, q, fq = q, p, fp
            p = b - golden * (b - a)
            fp = sign * function(p)
        else:
            a, p, fp = p, q, fq
            q = a + golden * (b - a)
            fq = sign * function(q)
    return (p, fp) if fp < fq else (q, fq)


def equilibria(ply, eps, balance):
    """Every angle in (0, pi/2) at which the balance holds, ascending."""
    n = ply[0]
    points = grid(n)
    value = [residual(ply, eps, balance, p) for p in points]

    def exact(theta):
        return residual(ply, eps, balance, Contact(n, theta))

    found = []
    for i in range(1, len(points)):
        if value[i - 1] * value[i] < 0:
            found.append(refine(exact, points[i - 1].theta, points[i].theta))
        elif i + 1 < len(points) and value[i] * value[i + 1] > 0:
            here, left, right = abs(value[i]), abs(value[i - 1]), abs(value[i + 1])
            if here <= left and here <= right and here <= 2 * max(left - here, right - here):
                a, b = points[i - 1].theta, points[i + 1].theta
                theta, lowest = extremum(exact, a, b, 1 if value[i] > 0 else -1)
                if lowest < 0:
                    found += [refine(exact, a, theta), refine(exact, theta, b)]
    return sorted(found)


def follow(ply, eps, balance, theta):
    """The equilibrium next to theta, after a small change of the loads: secant steps."""
    n = ply[0]

    def exact(t):
        return residual(ply, eps, balance, Contact(n, t))

    a, b = theta, theta * (1 + mp.mpf(10) ** -14)
    fa, fb = exact(a), exact(b)
    for _ in range(60):
        if fa == fb or abs(b - a) < mp.mpf(10) ** -47:
            return b
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = exact(b)
    raise SystemExit("an equilibrium could not be followed")


def pressures(ply, eps, balance, at):
    """p and p1. In radial balance all of dE/drho is one radial force; between touching strands it is p1 that carries it."""
    p_hat = slopes(ply, eps, at.s, at.c, at.rho)[1]
    share = at.rho * (1 - mp.cos(at.beta))  # p / p1, by (30)
    if balance == "radial":
        return p_hat, p_hat / share
    p1 = at.rho * p_hat / 2
    return share * p1, p1


def flexibility(ply, eps, balance, theta):
    """a times d(d_f, d_m)/d(f, m), by central differences between equilibria; the error is of order 1e-30."""
    n, gamma, pretwist, f, m = ply
    h = mp.mpf(10) ** -15

    def displacements(df, dm):
        t = follow((n, gamma, pretwist, f + df, m + dm), eps, balance, theta)
        return mp.cos(t), eps * mp.sin(t) / Contact(n, t).rho

    by_f = [(p - q) / (2 * h) for p, q in zip(displacements(h, 0), displacements(-h, 0))]
    by_m = [(p - q) / (2 * h) for p, q in zip(displacements(0, h), displacements(0, -h))]
    return by_f[0], by_m[0], by_f[1], by_m[1]


# ------------------------------------------------------------------------------------------------------------------ writhe


def writhe(theta, turns, phase, itself):
    """Double integral (A.4) over one helical strand, or over two that run the same way, as a single integral in the lag u.

    A strand with itself counts both orders of its points; of two strands the table holds one order, strand 1 with 2.
    """
    mu, length = mp.cot(theta), 2 * mp.pi * turns

    def g(u):
        v = u - phase
        chord = 4 * mp.sin(v / 2) ** 2
        return mu * (chord - u * mp.sin(v)) / (chord + (mu * u) ** 2) ** mp.mpf(1.5)

    cuts = sorted({mp.pi * i / 2 for i in range(-4 * turns, 4 * turns + 1)} | {mp.mpf(0)})
    if itself:
        cuts = [u for u in cuts if u >= 0]
    value = mp.quad(lambda u: (length - abs(u)) * (g(u) if u else 0), cuts)
    return value * (2 if itself else 1) / (4 * mp.pi)


def writhe_remainder(theta, turns, phase):
    """The same for any length, less the term of (A.15) or (A.23) that grows with it, to some 20 digits.

    The weight and the kernel are those of `writhe`; the lag is cut wherever the chord is short, ever finer towards it.
    """
    mu, length, itself = mp.cot(theta), 2 * mp.pi * turns, phase == 0

    def g(u):
        v = u - phase
        chord = 4 * mp.sin(v / 2) ** 2
        return (length - abs(u)) * mu * (chord - u * mp.sin(v)) / (chord + (mu * u) ** 2) ** mp.mpf(1.5)

    reach = int(mp.ceil(turns)) + 1
    cuts = {mp.pi * i / 2 for i in range(-4 * reach, 4 * reach + 1)} | {-length, mp.mpf(0), length}
    for k in range(-reach, reach + 1):
        dip = phase + 2 * mp.pi * k
        cuts |= {dip + sign * scale * mu * abs(dip) for sign in (-1, 0, 1) for scale in (1, 4, 16) if scale * mu * abs(dip) < 2}
    if not itself:
        near = 2 * mp.sin(phase / 2) / mu
        cuts |= {sign * scale * near for sign in (-1, 1) for scale in (1, 4, 16) if scale * near < 2}
    low = 0 if itself else -length
    cuts = [low] + sorted(u for u in cuts if low < u < length) + [length]
    value = mp.fsum(mp.quad(g, [a, b]) for a, b in zip(cuts, cuts[1:]) if b - a > mp.mpf(10) ** -15 * length)
    return value * (2 if itself else 1) / (4 * mp.pi) - turns * (2 * mp.sin(theta / 2) ** 2 if itself else 1)


# ------------------------------------------------------------------------------------------------------------------ tables


def digits(value, count=17):
    return mp.nstr(value, count)


def radians(text):
    return mp.mpf(text) * mp.pi / 180


def degrees(theta):
    return digits(theta * 180 / mp.pi)


def numbers(texts):
    return tuple(mp.mpf(t) for t in texts)


def rows_of(name):
    with open(HERE / f"{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def given(name, keys):
    """Inputs of a table as they stand in it, each once, in order."""
    return list(dict.fromkeys(tuple(row[k] for k in keys) for row in rows_of(name)))


CONTACT = "n,theta_deg,x,rho,drho_dtheta,contact_helix_radius_over_r,curvature_times_r,hole_radius_over_r"
BALANCED = "n,gamma,pretwist,handedness,balance,theta_deg,rho,r_u3,p_r3_over_B,p1_r3_over_B,dG_dtheta"
LOADED = "case,n,gamma,pretwist,f,m,handedness,balance,theta_deg,rho,p_r3_over_B"
FLEXIBILITY = "n,gamma,pretwist,handedness,balance,theta_deg,a_ddf_df,a_ddf_dm,a_ddm_df,a_ddm_dm"


def contact_rows(pairs):
    for n, text in pairs:
        at = Contact(int(n), radians(text), shift_by_scan)
        values = at.x, at.rho, at.drho, at.contact_radius, at.s**2 / at.rho, at.rho - 1
        yield [n, text, *map(digits, values)]


def contact_geometry():
    return CONTACT, contact_rows(given("contact_geometry", ("n", "theta_deg")))


def contact_geometry_more():
    strands = (2, 3, 5, 8, 9, 12, 13, 20, 100, 1000)
    angles = "1e-6 1e-3 0.1 1 20 44.9 44.999 45.001 45.1 51 60 75 85 89.9 89.999".split()
    return CONTACT, contact_rows((str(n), a) for n in strands for a in angles)


def balanced_plies():
    def rows():
        for n, gamma, pretwist in given("balanced_plies", ("n", "gamma", "pretwist")):
            ply = (int(n), *numbers((gamma, pretwist, 0, 0)))
            for eps in HANDS:
                for balance in BALANCES:
                    for theta in equilibria(ply, eps, balance):
                        at = Contact(ply[0], theta)
                        u3 = ply[2] + eps * at.s * at.c / at.rho

                        def g(t):
                            near = Contact(ply[0], t)
                            return ply[0] * near.rho**2 * residual(ply, eps, balance, near)

                        h = mp.mpf(10) ** -15
                        slope = (g(theta + h) - g(theta - h)) / (2 * h)
                        values = at.rho, u3, *pressures(ply, eps, balance, at)
                        yield [n, gamma, pretwist, str(eps), balance, degrees(theta), *map(digits, values), digits(slope, 12)]

    return BALANCED, rows()


def loaded_rows(cases):
    for case, n, *rest in cases:
        ply = (int(n), *numbers(rest))
        for eps in HANDS:
            for balance in BALANCES:
                for theta in equilibria(ply, eps, balance):
                    at = Contact(ply[0], theta)
                    values = at.rho, pressures(ply, eps, balance, at)[0]
                    yield [case, n, *rest, str(eps), balance, degrees(theta), *map(digits, values)]


def loaded_plies():
    return LOADED, loaded_rows(given("loaded_plies", ("case", "n", "gamma", "pretwist", "f", "m")))


CASES = "case,kind,n,gamma,pretwist,f,m"


def loaded_plies_more_cases():
    """Inputs of loaded_plies_more, kept apart so that a case without any state is a case all the same."""
    dice = random.Random(20020715)

    def between(low, high):
        return f"{dice.uniform(low, high):.3f}"

    def strand():
        return str(dice.choice([*range(2, 13), 20])), between(0.3, 1.5), between(-3, 3)

    def rows():
        kinds = ["random"] * 85 + ["tiny force"] * 20 + ["no force"] * 15 + ["no moment"] * 10 + ["no load"] * 8
        case = 0
        for case, kind in enumerate(kinds):
            f = {"tiny force": dice.choice(["1e-6", "-1e-6"]), "no force": "0", "no load": "0"}.get(kind) or between(-2, 2)
            m = "0" if kind in ("no moment", "no load") else between(-6, 6)
            yield [str(case), kind, *strand(), f, m]
        folds = 0
        while folds < 12:  # a force one ten-millionth beside the one at which two states become one
            n, gamma, pretwist = strand()
            m, eps, balance = between(-6, 6), dice.choice(HANDS), dice.choice(BALANCES)
            fold = fold_force(int(n), *numbers((gamma, pretwist, m)), eps, balance)
            if fold is not None and abs(fold) < 2:
                case, folds = case + 1, folds + 1
                offset = mp.mpf("1e-7") * (1 if folds % 2 else -1)
                yield [str(case), "fold", n, gamma, pretwist, mp.nstr(fold + offset, 10), m]

    return CASES, rows()


def fold_force(n, gamma, pretwist, m, eps, balance):
    """The force as a function of the angle, by solving the balance for f, has an extremum: its value, or None."""
    points = grid(n)

    def force(at):
        # the balance is linear in f, with slope sin(theta)/n
        return -residual((n, gamma, pretwist, mp.mpf(0), m), eps, balance, at) * n / at.s

    plain = (n, float(gamma), float(pretwist), 0.0, float(m))
    values = [-residual(plain, eps, balance, p) * n / p.s for p in points]
    for i in range(400, len(points) - 500):
        bend = (values[i] - values[i - 1]) * (values[i + 1] - values[i])
        if bend < 0 and abs(points[i].theta - mp.pi / 4) > 0.01:
            sign = 1 if values[i] < values[i - 1] else -1
            a, b = points[i - 1].theta, points[i + 1].theta
            shift = sign * values[i] - abs(values[i]) - 1  # keeps the sought value positive, so that the search runs on
            theta, _ = extremum(lambda t: sign * force(Contact(n, t)) - shift, a, b, 1)
            return force(Contact(n, theta))
    return None


def loaded_plies_more():
    return LOADED, loaded_rows(given("loaded_plies_more_cases", ("case", "n", "gamma", "pretwist", "f", "m")))


def flexibility_rows(inputs, loads):
    for n, gamma, pretwist, f, m in inputs:
        ply = (int(n), *numbers((gamma, pretwist, f, m)))
        for eps in HANDS:
            for balance in BALANCES:
                for theta in equilibria(ply, eps, balance):
                    values = flexibility(ply, eps, balance, theta)
                    yield [n, gamma, pretwist, *((f, m) if loads else ()), str(eps), balance, degrees(theta), *map(digits, values)]


def flexibility_table():
    """Only the low-angle state of the hand that the pretwist asks for is in this table."""
    wanted = set(given("flexibility", ("n", "gamma", "pretwist", "handedness", "balance")))
    inputs = [(*key, "0", "0") for key in given("flexibility", ("n", "gamma", "pretwist"))]

    def rows():
        seen = set()
        for row in flexibility_rows(inputs, False):
            if tuple(row[:5]) in wanted and tuple(row[:5]) not in seen:
                seen.add(tuple(row[:5]))
                yield row

    return FLEXIBILITY, rows()


def flexibility_more():
    loads = [("0.75", "-0.4", "0.3", "-0.5"), ("0.55", "1.2", "-0.05", "2.5"), ("1.2", "-2.5", "0.8", "1.5"), ("0.9", "0.3", "0.001", "0")]
    inputs = [(n, *load) for n in ("2", "3", "5", "8", "12") for load in loads]
    return FLEXIBILITY.replace("pretwist,", "pretwist,f,m,"), flexibility_rows(inputs, True)


def strand_writhe():
    def rows():
        for theta, turns, phase in given("strand_writhe", ("theta_deg", "turns", "alpha_over_2pi")):
            with mp.workdps(25):
                share = Fraction(phase)
                angle = 2 * mp.pi * share.numerator / share.denominator
                value = writhe(radians(theta), int(turns), angle, share == 0)
            yield [theta, turns, phase, digits(value, 10)]

    return "theta_deg,turns,alpha_over_2pi,writhe", rows()


def strand_writhe_more():
    def rows():
        for theta in ("1", "10", "35", "70", "80", "86"):
            for turns in ("0.25", "4.625", "6.5", "20.75"):
                for phase in ("0", "1/2", "2/7", "1/12"):
                    with mp.workdps(28):
                        share = Fraction(phase)
                        angle = 2 * mp.pi * share.numerator / share.denominator
                        value = writhe_remainder(radians(theta), mp.mpf(turns), angle)
                    yield [theta, turns, phase, digits(value, 15)]

    return "theta_deg,turns,alpha_over_2pi,remainder", rows()


TABLES = {
    "contact_geometry": contact_geometry,
    "contact_geometry_more": contact_geometry_more,
    "balanced_plies": balanced_plies,
    "loaded_plies": loaded_plies,
    "loaded_plies_more_cases": loaded_plies_more_cases,
    "loaded_plies_more": loaded_plies_more,
    "flexibility": flexibility_table,
    "flexibility_more": flexibility_more,
    "strand_writhe": strand_writhe,
    "strand_writhe_more": strand_writhe_more,
}


def same(made, kept, column):
    """Equal text, or equal to the table's digits: two units in the last of 17, 15, 12 or 10; zero is zero to 30 places."""
    if made == kept:
        return True
    try:
        a, b = mp.mpf(made), mp.mpf(kept)
    except ValueError:
        return False
    count = {"dG_dtheta": 12, "writhe": 10, "remainder": 15}.get(column, 17)
    return abs(a - b) <= 2 * mp.mpf(10) ** (1 - count) * abs(b) or max(abs(a), abs(b)) < mp.mpf(10) ** -30


def self_test():
    """The two contact searches agree; the slopes typed above are those of the energy."""
    for n in (2, 3, 7, 20):
        for text in ("3", "44.9", "46", "80"):
            theta, eps = radians(text), -1
            at, scanned = Contact(n, theta), Contact(n, theta, shift_by_scan)
            assert abs(at.x - scanned.x) < mp.mpf(10) ** -44, (n, text)
            h = mp.mpf(10) ** -16
            slope = (Contact(n, theta + h).rho - Contact(n, theta - h).rho) / (2 * h)
            assert abs(slope - at.drho) < mp.mpf(10) ** -27 * (1 + abs(slope)), (n, text)
            ply = (n, *numbers(("0.8", "-0.7", "0.3", "1.1")))
            total = (energy(ply, eps, theta + h, Contact(n, theta + h).rho) - energy(ply, eps, theta - h, Contact(n, theta - h).rho)) / (2 * h)
            partial = (energy(ply, eps, theta + h, at.rho) - energy(ply, eps, theta - h, at.rho)) / (2 * h)
            assert abs(total - residual(ply, eps, "contact", at)) < mp.mpf(10) ** -26, (n, text)
            assert abs(partial - residual(ply, eps, "radial", at)) < mp.mpf(10) ** -26, (n, text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    mode = parser.add_mutually_exclusive_group(required=True)
    mode.add_argument("--check", action="store_true")
    mode.add_argument("--write", action="store_true")
    parser.add_argument("tables", nargs="*", metavar="NAME")
    options = parser.parse_args()
    unknown = set(options.tables) - set(TABLES)
    if unknown:
        parser.error(f"no such table: {', '.join(sorted(unknown))}; there are {', '.join(TABLES)}")
    self_test()
    wrong = 0
    for name in options.tables or TABLES:
        header, rows = TABLES[name]()
        made = [header.split(","), *rows]
        path = HERE / f"{name}.csv"
        if options.write:
            text = io.StringIO()
            csv.writer(text, lineterminator="\n").writerows(made)
            path.write_text(text.getvalue())
            print(f"{name}: {len(made) - 1} rows written", flush=True)
            continue
        with open(path, newline="") as file:
            kept = list(csv.reader(file))
        faults = [] if len(made) == len(kept) else [f"{len(made) - 1} rows made, {len(kept) - 1} kept"]
        for i, (a, b) in enumerate(zip(made, kept)):
            for column, p, q in zip(made[0], a, b):
                if not same(p, q, column):
                    faults.append(f"line {i + 1}, {column}: made {p}, kept {q}")
        wrong += bool(faults)
        print(f"{name}: {len(made) - 1} rows, {'the same' if not faults else 'DIFFERENT'}", flush=True)
        for fault in faults[:10]:
            print(f"    {fault}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
