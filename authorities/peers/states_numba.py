"""Every state of a ply in radial balance: (47) summed on a grid of 400 angles, changes of sign refined by the Illinois method, in a compiled loop: numba."""

import math

import numba
import numpy as np
from inputs import plies, report

ROWS, ANGLES, MOST = 20_000, 400, 8


@numba.njit
def radius(n, theta):
    step, steep = 2 * math.pi / n, math.tan(theta) ** 2
    if n == 2 and steep <= 1:
        return 1.0
    e = step / (1 + steep)
    for _ in range(100):
        move = (step - e - steep * math.sin(e)) / (1 + steep * math.cos(e))
        e += move
        if abs(move) < 4e-16 * e:
            break
    return 1 / (math.sin(e / 2) * math.sqrt(1 + steep * math.cos(e / 2) ** 2))


@numba.njit
def balance(theta, n, gamma, twist, force, moment):
    rho, s, c = radius(n, theta), math.sin(theta), math.cos(theta)
    double = 1 - 2 * s * s
    return 2 * n * s**3 * c + n * gamma * double * (s * c + twist * rho) + rho * (rho * force * s - moment * c)


@numba.njit
def all_rows(n, gamma, twist, force, moment, grid, terms, found, count):
    for i in range(len(n)):
        table, have, before = terms[n[i] - 2], 0, 0.0
        for j in range(ANGLES):
            here = (
                table[0, j] + gamma[i] * (table[1, j] + twist[i] * table[2, j]) + force[i] * table[3, j] + moment[i] * table[4, j]
            )
            if j > 0 and before * here < 0 and have < MOST:
                a, b, low, high = grid[j - 1], grid[j], before, here
                for _ in range(60):
                    t = b - high * (b - a) / (high - low)
                    y = balance(t, n[i], gamma[i], twist[i], force[i], moment[i])
                    if y * high < 0:
                        a, low = b, high
                    else:
                        low *= 0.5
                    moved, b, high = abs(t - b), t, y
                    if moved < 1e-14 or y == 0:
                        break
                found[i, have] = b
                have += 1
            before = here
        count[i] = have


grid = (np.arange(ANGLES) + 0.5) / ANGLES * np.pi - np.pi / 2
terms = np.empty((11, 5, ANGLES))
for n in range(2, 13):
    rho = np.array([radius(n, abs(theta)) for theta in grid])
    s, c = np.sin(grid), np.cos(grid)
    terms[n - 2] = 2 * n * s**3 * c, n * np.sin(4 * grid) / 4, n * rho * np.cos(2 * grid), rho**2 * s, -rho * c
columns = plies(ROWS)
found, count = np.empty((ROWS, MOST)), np.zeros(ROWS, np.int64)
report(lambda: all_rows(*columns, grid, terms, found, count), ROWS, lambda _: count.sum() / ROWS, 10)
