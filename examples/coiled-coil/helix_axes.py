"""Axes of the alpha-helices of a coiled coil, their superhelix radius and pitch, from the CA atoms of a PDB file.

python3 examples/coiled-coil/helix_axes.py [FILE.pdb [AXES.csv [CHAINS]]]

Each chain is one helix; CHAINS, such as AB, says which of them belong together. They may be parallel or antiparallel and begin at any residue.
Chains without a letter end at their TER and are named 1, 2, 3 in the order of the file.
"""

import csv
import itertools
import math
import sys


def chains(path):
    """The CA atoms of each chain by residue: the first model, the first of alternate positions, modified residues (HETATM) with the others."""
    found = {}
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            lines = file.read().split("\n")
    except OSError as error:
        sys.exit(f"{path} cannot be read: {error.strerror}")
    if any(line.startswith(("data_", "_atom_site.")) for line in lines):
        sys.exit(f"{path}: it is mmCIF; save it as PDB")
    ended = 0
    for number, line in enumerate(lines, 1):
        if line.startswith("ENDMDL"):
            break
        ended += line[:6].strip() == "TER"
        # among HETATM, CA in the next column is calcium
        if (line.startswith("ATOM") and line[12:16].strip() == "CA") or (line.startswith("HETATM") and line[12:16] == " CA "):
            try:
                point = [float(line[at : at + 8]) for at in (30, 38, 46)]
            except ValueError:
                point = [math.nan]
            # a line that is cut off within the last coordinate may still read as a number
            if len(line) < 54 or not all(map(math.isfinite, point)):
                sys.exit(f"{path}, line {number}: this atom's x, y and z are not three numbers in columns 31 to 54")
            letter = line[21].strip()
            found.setdefault(letter or ended, {}).setdefault(line[22:27].strip(), point)
    if len(found) == 1 and not isinstance(next(iter(found)), str):
        sys.exit(f"{path} is one chain: its atoms have no letter of a chain (column 22), and no TER stands between chains; write either")
    return named(found)


def named(found):
    """The chains under their letters; those that have none, and are told apart by how many TER stand before them, under the numbers no chain has."""
    free = (str(number) for number in itertools.count(1) if str(number) not in found)
    return {chain if isinstance(chain, str) else next(free): points for chain, points in found.items()}


def chosen(path, found, wanted):
    """The chains that are wanted: letters one behind the other, or names between commas; all if nothing is said."""
    if not wanted:
        return found
    names = [name for part in wanted.split(",") for name in ([part] if part in found else part)]
    missing = [name for name in dict.fromkeys(names) if name not in found]
    if missing:
        there = f"its chains are {', '.join(found)}" if found else "it has no CA atom of any chain"
        sys.exit(f"{path} has no chain {' and no chain '.join(missing)}: {there}")
    return {name: points for name, points in found.items() if name in names}


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return [x / math.hypot(*a) for x in a]


def mean(points):
    return [sum(part) / len(points) for part in zip(*points)]


def runs(names, some):
    """Those of the names that are among some, each run of them by its ends."""
    together = [list(run) for among, run in itertools.groupby(names, key=some.__contains__) if among]
    return [run[0] if len(run) == 1 else f"{run[0]} to {run[-1]}" for run in together]


def axis(chain, points):
    """Points on a helix's axis, one between each four residues: the bisectors of two bends meet on it."""
    line, left_out = [], []
    names, points = list(points), list(points.values())
    for name, a, b, c, d in zip(names, points, points[1:], points[2:], points[3:]):
        v = [x - 2 * y + z for x, y, z in zip(a, b, c)]
        w = [x - 2 * y + z for x, y, z in zip(b, c, d)]
        long, wide = math.hypot(*v), math.hypot(*w)
        turn = dot(v, w) / (long * wide) if long * wide > 0 else 1
        # CA atoms lie 3.8 Å apart, and the helix turns by 100° between them: where it does not there is a gap, a loop or an end
        if max(math.dist(a, b), math.dist(b, c), math.dist(c, d)) > 4.3 or not -0.5 < turn < 0.2:
            left_out.append(name)
            continue
        radius = math.sqrt(long * wide) / (2 * (1 - turn))
        line.append([(x + radius * p / long + y + radius * q / wide) / 2 for x, p, y, q in zip(b, v, c, w)])
    if left_out:
        firsts = ", ".join(runs(names, left_out))
        print(f"chain {chain}: no alpha-helix in four residues in a row, by the first of the four: {firsts}; left out", file=sys.stderr)
    return line


def crossing(line, along, level):
    """Where a line passes a height along the superhelix axis."""
    for a, b in zip(line, line[1:]):
        low, high = dot(a, along), dot(b, along)
        if low <= level <= high and low < high:
            return [x + (level - low) / (high - low) * (y - x) for x, y in zip(a, b)]
    return line[-1]


def superhelix(axes):
    """Mean radius about the middle line of all axes, pitch, negative where it is left-handed, and the chains that run against the first.

    Axes are compared where they pass the same height, whichever residues those are; the heights are along the middle line itself.
    """
    names, lines = list(axes), list(axes.values())
    for name, line in axes.items():
        if math.dist(line[0], line[-1]) < 0.7 * sum(math.dist(a, b) for a, b in zip(line, line[1:])):
            sys.exit(f"chain {name} turns back: each chain is to be one helix; cut the file into helices")
    ends = [less(line[-1], line[0]) for line in lines]
    against = [name for name, end in zip(names, ends) if dot(end, ends[0]) < 0]
    lines = [line[::-1] if name in against else line for name, line in zip(names, lines)]
    along = unit(mean([less(line[-1], line[0]) for line in lines]))
    for _ in range(8):
        low = max(dot(line[0], along) for line in lines)
        high = min(dot(line[-1], along) for line in lines)
        if high - low < 10:
            sys.exit("the helices lie beside each other over less than 10 Å: name those that belong together, such as AB")
        levels = [low + (high - low) * i / 40 for i in range(41)]
        cuts = [[crossing(line, along, level) for line in lines] for level in levels]
        along = unit(less(mean(cuts[-1]), mean(cuts[0])))
    aside = unit(less(cuts[0][0], mean(cuts[0])))
    up = [along[1] * aside[2] - along[2] * aside[1], along[2] * aside[0] - along[0] * aside[2], along[0] * aside[1] - along[1] * aside[0]]
    radii, slopes, places = [], [], []
    for k in range(len(lines)):
        arms = [less(cut[k], mean(cut)) for cut in cuts]
        radii.append(sum(math.hypot(*arm) for arm in arms) / len(arms))
        angles = [math.atan2(dot(arm, up), dot(arm, aside)) for arm in arms]
        for i in range(1, len(angles)):
            angles[i] -= math.tau * round((angles[i] - angles[i - 1]) / math.tau)
        middle, height = sum(angles) / len(angles), (low + high) / 2
        slopes.append(sum((a - middle) * (z - height) for a, z in zip(angles, levels)) / sum((z - height) ** 2 for z in levels))
        places.append(middle % math.tau)
    radius, slope = sum(radii) / len(radii), sum(slopes) / len(slopes)
    places.sort()
    gaps = [(b - a) * len(lines) / math.tau for a, b in zip(places, [*places[1:], places[0] + math.tau])]
    if max(radii) > 1.3 * min(radii) or min(gaps) < 0.6 or max(gaps) > 1.4:
        sys.exit("the helices do not stand evenly about one axis: name those that belong together, such as AB")
    if any(abs(one - slope) > 0.5 * abs(slope) for one in slopes) or slope == 0:
        sys.exit("the helices do not wind about one axis alike: there is no pitch to be said")
    return radius, math.tau / slope, against


def write(path, axes):
    try:
        with open(path, "w", newline="", encoding="utf-8") as file:
            rows = csv.writer(file)
            rows.writerow(["chain", "x [Å]", "y [Å]", "z [Å]"])
            rows.writerows([name, *(f"{x:.3f}" for x in point)] for name, line in axes.items() for point in line)
    except OSError as error:
        sys.exit(f"{path} cannot be written: {error.strerror}")


pdb, table, wanted = [*sys.argv[1:4], "", "", ""][:3]
pdb = pdb or "examples/coiled-coil/trimer.pdb"
if table and not table.lower().endswith(".csv"):
    sys.exit(f"{table}: the axes are written as CSV, to a name that ends in .csv; chains stand behind it: {pdb} axes.csv AB")
axes = {name: axis(name, points) for name, points in chosen(pdb, chains(pdb), wanted).items()}
axes = {name: line for name, line in axes.items() if len(line) > 1}
if len(axes) < 2:
    sys.exit(f"{pdb}: two or more chains that are alpha-helices are wanted, and {len(axes)} found")
radius, pitch, against = superhelix(axes)
if table:
    write(table, axes)
hand = "left" if pitch < 0 else "right"
turned = f"; {', '.join(against)} against {next(iter(axes))}" if against else ""
print(f"{len(axes)} helices (chains {', '.join(axes)}{turned}), superhelix radius {radius:.3f} Å, pitch {abs(pitch):.1f} Å, {hand}-handed")
if table:
    print(f"axes written to {table}")
