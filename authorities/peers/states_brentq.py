"""Every state of a ply in radial balance: (47) on a grid, then scipy.optimize.brentq between changes of sign, with rho by its own brentq inside."""

from math import acos, cos, pi, sin, sqrt, tan

import numpy as np
from inputs import plies, report
from scipy.optimize import brentq

ROWS, ANGLES = 200, 800


def radius(n, theta):
    step, steep = 2 * pi / n, tan(theta) ** 2
    if n == 2 and steep <= 1:
        return 1.0
    top = step if steep < 1 else min(step, acos(-1 / steep))
    e = brentq(lambda e: e + steep * sin(e) - step, 0.0 if n > 2 else 1e-12, top, xtol=1e-15)
    return 1 / (sin(e / 2) * sqrt(1 + steep * cos(e / 2) ** 2))


def balance(theta, rho, n, gamma, twist, force, moment, lib=np):
    """(47), both hands in one: left-handed plies at negative angles."""
    s, c = lib.sin(theta), lib.cos(theta)
    turned = n * gamma * (lib.sin(4 * theta) / 4 + twist * rho * lib.cos(2 * theta))
    return 2 * n * s**3 * c + turned + rho**2 * force * s - rho * moment * c


grid = (np.arange(ANGLES) + 0.5) / ANGLES * pi - pi / 2
radii = {n: np.array([radius(n, abs(theta)) for theta in grid]) for n in range(2, 13)}


class Scalars:
    sin, cos = staticmethod(sin), staticmethod(cos)


def states(n, *rest):
    values = balance(grid, radii[n], n, *rest)
    found = np.nonzero(values[1:] * values[:-1] < 0)[0]
    at = lambda theta: balance(theta, radius(n, abs(theta)), n, *rest, lib=Scalars)
    return [brentq(at, grid[i], grid[i + 1], xtol=1e-14) for i in found]


cases = list(zip(*(column.tolist() for column in plies(ROWS))))
report(lambda: [states(*case) for case in cases], ROWS, lambda all: sum(map(len, all)) / ROWS, 5)
