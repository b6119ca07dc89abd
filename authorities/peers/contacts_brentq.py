"""x and rho of touching strands, a bracketing root for each: scipy.optimize.brentq on (5) in E = 2 pi/n - x sin(theta)."""

from math import acos, cos, pi, sin, sqrt, tan

from inputs import angles, report, strands
from scipy.optimize import brentq

ROWS = 2_000


def touch(n, theta):
    step, steep = 2 * pi / n, tan(theta) ** 2
    if n == 2 and steep <= 1:
        return 0.0, 1.0
    # the branch without overlap is the first root, before the sum turns back
    top = step if steep < 1 else min(step, acos(-1 / steep))
    low = 0.0 if n > 2 else 1e-12
    e = brentq(lambda e: e + steep * sin(e) - step, low, top, xtol=1e-15, rtol=1e-14)
    return (step - e) / sin(theta), 1 / (sin(e / 2) * sqrt(1 + steep * cos(e / 2) ** 2))


cases = list(zip(strands(ROWS).tolist(), angles(ROWS).tolist()))
report(lambda: [touch(n, theta) for n, theta in cases], ROWS, lambda all: sum(1 / rho for _, rho in all), 5)
