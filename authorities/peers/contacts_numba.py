"""x and rho of touching strands by Newton's iteration in a compiled loop: numba."""

import math

import numba
import numpy as np
from inputs import angles, report, strands

ROWS = 100_000


@numba.njit
def touch(n, theta):
    sine, cosine = math.sin(theta), math.cos(theta)
    step, steep = 2 * math.pi / n, (sine / cosine) ** 2
    if n == 2 and steep <= 1:
        return 0.0, 1.0
    e = step / (1 + steep)  # left of the root, from where the iteration rises to it
    for _ in range(100):
        move = (step - e - steep * math.sin(e)) / (1 + steep * math.cos(e))
        e += move
        if abs(move) < 4e-16 * e:
            break
    half = e / 2
    return (step - e) / sine, 1 / (math.sin(half) * math.sqrt(1 + steep * math.cos(half) ** 2))


@numba.njit
def all_rows(n, theta, shift, radius):
    for i in range(len(n)):
        shift[i], radius[i] = touch(n[i], theta[i])


n, theta = strands(ROWS), angles(ROWS)
shift, radius = np.empty(ROWS), np.empty(ROWS)
report(lambda: all_rows(n, theta, shift, radius), ROWS, lambda _: (1 / radius).sum(), 40)
