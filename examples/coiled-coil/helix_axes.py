"""Axes of the alpha-helices of a coiled coil, their superhelix radius and pitch, from the CA atoms of a PDB file.

python3 examples/coiled-coil/helix_axes.py [FILE.pdb [AXES.csv]]
"""

import csv
import math
import sys


def chains(path):
    """The CA atoms of each chain, in order."""
    found = {}
    for line in open(path, encoding="ascii"):
        if line.startswith("ATOM") and line[12:16].strip() == "CA":
            point = tuple(float(line[at : at + 8]) for at in (30, 38, 46))
            found.setdefault(line[21], []).append(point)
    return found


def axis(points):
    """Points on a helix's axis, one between each four residues: the bisectors of two bends meet on it."""
    line = []
    for a, b, c, d in zip(points, points[1:], points[2:], points[3:]):
        v = [x - 2 * y + z for x, y, z in zip(a, b, c)]
        w = [x - 2 * y + z for x, y, z in zip(b, c, d)]
        long, wide = math.hypot(*v), math.hypot(*w)
        turn = sum(x * y for x, y in zip(v, w)) / (long * wide)
        radius = math.sqrt(long * wide) / (2 * (1 - turn))
        line.append([(x + radius * p / long + y + radius * q / wide) / 2 for x, p, y, q in zip(b, v, c, w)])
    return line


def superhelix(lines):
    """Mean radius about the middle line of all axes, and pitch; negative where it is left-handed."""
    middle = [[sum(part) / len(lines) for part in zip(*points)] for points in zip(*lines)]
    along = [b - a for a, b in zip(middle[0], middle[-1])]
    length = math.hypot(*along)
    along = [x / length for x in along]
    radii, turned = [], 0.0
    for line in lines:
        arms = [[p - m for p, m in zip(point, centre)] for point, centre in zip(line, middle)]
        radii += [math.hypot(*arm) for arm in arms]
        for u, v in zip(arms, arms[1:]):
            cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            turned += math.atan2(sum(x * y for x, y in zip(cross, along)), sum(x * y for x, y in zip(u, v)))
    return sum(radii) / len(radii), 2 * math.pi * length / (turned / len(lines))


pdb = sys.argv[1] if len(sys.argv) > 1 else "examples/coiled-coil/trimer.pdb"
found = chains(pdb)
axes = {name: axis(points) for name, points in found.items()}
radius, pitch = superhelix(list(axes.values()))
hand = "left" if pitch < 0 else "right"
print(f"{len(axes)} helices, superhelix radius {radius:.3f} Å, pitch {abs(pitch):.1f} Å, {hand}-handed")
if len(sys.argv) > 2:
    with open(sys.argv[2], "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["chain", "x [Å]", "y [Å]", "z [Å]"])
        rows.writerows([name, *(f"{x:.3f}" for x in point)] for name, line in axes.items() for point in line)
