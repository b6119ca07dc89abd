"""The same inputs as crates/nply/examples/race.rs, and how pieces of work are timed."""

import sys
import time

import numpy as np

GOLDEN = 0.6180339887498949
STEPS = (0.41421356237309515, 0.7320508075688772, 0.23606797749979025, 0.6457513110645906)


def spread(rows, step):
    return ((np.arange(rows) + 1) * step) % 1.0


def strands(rows):
    return 2 + np.arange(rows) % 11


def angles(rows):
    return 1e-3 + (np.pi / 2 - 2e-3) * spread(rows, GOLDEN)


def plies(rows):
    """n, C/B, pretwist, force, moment; each second row without loads."""
    gamma, twist, force, moment = (spread(rows, step) for step in STEPS)
    force, moment = -1 + 2 * force, -4 + 8 * moment
    force[::2], moment[::2] = 0, 0
    return strands(rows), 0.6 + 0.4 * gamma, -2 + 4 * twist, force, moment


def trefoil(points):
    t = 2 * np.pi * np.arange(points) / points
    r = 2 + np.cos(3 * t)
    return np.stack([r * np.cos(2 * t), r * np.sin(2 * t), np.sin(3 * t)], 1)


def report(work, items, check, pieces):
    """Prints `best median check`, nanoseconds an item of processor time; the first piece warms up and is not counted."""
    answer = work()
    times = []
    for _ in range(pieces):
        start = time.process_time()
        answer = work()
        times.append((time.process_time() - start) / items)
    times.sort()
    sys.stdout.write(f"{1e9 * times[0]:.4f} {1e9 * times[len(times) // 2]:.4f} {check(answer):.12f}\n")
