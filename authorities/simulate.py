"""Free elastic rods in contact, for every case of CASES: a witness for the theory of uniform plies that knows nothing of it.

    python authorities/simulate.py --write       # every case: simulation.csv, simulation_flexibility.csv, simulation.md, simulation.svg
    python authorities/simulate.py --case 4      # one case, told as it goes; nothing is written
    python authorities/simulate.py --check       # a few cases with few spans, from other starts, against simulation.csv

The rods are those of free_rods.py. Each case starts from strands laid apart at some wrong angle and bent at random, anew for every number of
spans, and goes down to the least energy. The angle is then taken to the limit: springs ever stiffer, doubled twice, then shorter spans (fourth
order). The error told is the sum of what the last step of either limit changed, and of 1e-6 degrees for where the descent stops.
Only the columns named contact and radial come from the theory, by make_tables.py, and are put beside the result after it stands.
"""

import argparse
import csv
import pathlib
import sys
import time

import numpy as np

from free_rods import Cell, least

HERE = pathlib.Path(__file__).parent
SPRINGS = (10.0, 100.0, 500.0, 1000.0, 2000.0)  # one after the other; the last three go to the limit
LENGTH = 12.0
SPANS = (24, 32, 40)  # in a cell of that length
BALANCES = ("contact", "radial")
# added to every error, for where the descent stops and for the digits written
FLOOR_DEG, FLOOR = 1e-6, 1e-8


def case(n, pretwist, gamma=0.75, force=0.0, moment=0.0, core=None, **run):
    one = {"n": n, "gamma": gamma, "pretwist": pretwist, "force": force, "moment": moment, "core": core}
    return one | {"length": LENGTH, "starts": (0.0, 45.0, 20.0), "noise": 0.25, "springs": SPRINGS} | run


CASES = [
    case(2, -1.0),
    case(2, -1.0, force=0.4, moment=1.0),
    # beyond 45 degrees two strands touch along two lines close to each other, which soft springs would run into one, and such a ply under
    # such a moment loops if it is bent much
    case(2, -1.0, force=2.0, moment=5.0, starts=(43.0, 50.0, 47.0), noise=0.02, springs=(2000.0, 4000.0, 8000.0)),
    case(3, -1.0),
    case(3, -0.8),
    case(3, -0.5),
    case(3, -2.0),
    case(3, -1.0, gamma=1.0),
    case(3, -1.0, force=0.5, moment=0.6),
    case(3, 1.2, force=0.6, moment=0.3, starts=(0.0, -45.0, -20.0)),
    case(4, -1.0),
    case(6, -1.0),
    case(3, -1.0, length=18.0),
    case(3, -1.0, core=0.6),
]
PICTURED = CASES[3]
FLEXIBLE = [CASES[4]]
COLUMNS = (
    "n,gamma,pretwist,force,moment,theta_simulated_deg,error_deg,theta_contact_deg,theta_radial_deg,nodes,contact_stiffness,"
    "cell_length,core_radius,handedness,uneven_deg,helix_radius,helix_radius_error,contact_force,contact_force_error"
).split(",")
FLEXIBILITY_COLUMNS = "n,gamma,pretwist,displacement,load,simulated,error,contact,radial".split(",")
QUANTITIES = ("theta", "radius", "contact_force", "extension", "rotation")


# ---------------------------------------------------------------- the limit


def in_stiffness(values):
    """Limit of values at stiffnesses that double each time, and what its last step changed."""
    a, b, c = values
    first, second = 2 * b - a, 2 * c - b
    limit = (4 * second - first) / 3
    return limit, abs(limit - second)


def in_spans(spans, values, errors):
    """Limit of values whose error falls with the fourth power of the span, and how sure it is."""
    limits = [b + (b - a) / ((q / p) ** 4 - 1) for p, q, a, b in zip(spans, spans[1:], values, values[1:])]
    return limits[-1], abs(limits[-1] - limits[-2]) + max(errors)


# ---------------------------------------------------------------- one case


def settle(one, spans, x, tell, springs):
    """The states of least energy next to x, springs ever stiffer."""
    states = []
    for stiffness in springs:
        cell = Cell(one, spans, one["length"], stiffness)
        x, gradient, steps = least(cell, x)
        seen = cell.seen(x)
        tell(
            f"    spring {stiffness:6.0f}: {steps:3d} steps, gradient {gradient:.0e}, {seen['theta']:.7f} deg, uneven {seen['uneven']:.1e} deg, touching {seen['touching']}"
        )
        if gradient > 1e-7:
            raise SystemExit(f"no state of least energy was reached: {one}")
        if seen["steepest"] > 150.0:
            raise SystemExit(
                f"a strand turns back on itself, where its twist is not to be had from its tangents: {one}"
            )
        states.append((x, seen))
    return states


def descend(one, spans, start, seed, tell):
    """From a start that is not the answer down to the state of least energy."""
    soft = Cell(one, spans, one["length"], one["springs"][0])
    x = soft.start(start, one["noise"], seed)
    tell(f"  {spans} spans, from {start} deg, seed {seed}")
    first = (soft, x)
    states = settle(one, spans, x, tell, one["springs"])[-3:]
    return first, states


def simulate(one, tell, seed=1):
    spans = [round(s * one["length"] / LENGTH) for s in SPANS]
    limits = {quantity: [] for quantity in QUANTITIES}
    for number, (count, start) in enumerate(zip(spans, one["starts"])):
        _, states = descend(one, count, start, seed + number, tell)
        for quantity in QUANTITIES:
            limits[quantity].append(in_stiffness([seen[quantity] for _, seen in states]))
    result = {q: in_spans(spans, [v for v, _ in limits[q]], [e for _, e in limits[q]]) for q in QUANTITIES}
    last, seen = states[-1]
    cell = Cell(one, spans[-1], one["length"], one["springs"][-1])
    soft = np.linalg.eigvalsh(cell.energy(last)[2])
    tell(f"  lowest curvatures of the energy {soft[:8]}")
    result.update(uneven=seen["uneven"], hand=int(np.sign(last[-1])), spans=spans[-1])
    tell(f"  angle {result['theta'][0]:.7f} deg, error {result['theta'][1] + FLOOR_DEG:.1e}")
    return result


def flexibility(one, tell):
    """How h/L and phi/L answer small changes of force and moment: differences of states found anew under each."""
    counts = SPANS[-2:]
    table = {}
    for count in counts:
        _, states = descend(one, count, 20.0, 7, tell)
        for load in ("force", "moment"):
            for change in (0.01, 0.02):
                for sign in (-1, 1):
                    changed = dict(one, **{load: one[load] + sign * change})
                    moved = settle(changed, count, states[0][0], tell, one["springs"][-3:])
                    for shown in ("extension", "rotation"):
                        table[count, load, change, sign, shown] = in_stiffness([seen[shown] for _, seen in moved])[0]
    rows = []
    for shown, displacement in (("extension", "d_f"), ("rotation", "d_m")):
        for load in ("force", "moment"):
            slopes = []
            for count in counts:
                near, far = (
                    (table[count, load, c, 1, shown] - table[count, load, c, -1, shown]) / (2 * c) for c in (0.01, 0.02)
                )
                slopes.append(((4 * near - far) / 3, abs(near - far) / 3))
            (coarse, _), (fine, step) = slopes
            limit = fine + (fine - coarse) / ((counts[1] / counts[0]) ** 4 - 1)
            rows.append((displacement, load[0], limit, abs(limit - fine) + step))
    return rows


# ---------------------------------------------------------------- the theory beside it


def theory(one, theta, hand):
    """Angles of contact balance and of radial balance next to theta, in degrees; on a core with gaps the radius is given."""
    import make_tables as made

    ply = (one["n"], *(made.mp.mpf(repr(one[k])) for k in ("gamma", "pretwist", "force", "moment")))
    start = made.mp.radians(made.mp.mpf(theta))
    if one["core"] is not None:
        rho = 1 + made.mp.mpf(repr(one["core"]))
        balanced = made.mp.findroot(lambda t: made.slopes(ply, hand, made.mp.sin(t), made.mp.cos(t), rho)[0], start)
        return None, balanced
    return tuple(made.follow(ply, hand, balance, start) for balance in BALANCES)


def theory_flexibility(one, theta, hand):
    import make_tables as made

    ply = (one["n"], *(made.mp.mpf(repr(one[k])) for k in ("gamma", "pretwist", "force", "moment")))
    both = {}
    for balance in BALANCES:
        at = made.follow(ply, hand, balance, made.mp.radians(made.mp.mpf(theta)))
        both[balance] = [float(v) for v in made.flexibility(ply, hand, balance, at)]
    return both


# ---------------------------------------------------------------- what is written


def row(one, result):
    contact, radial = theory(one, result["theta"][0], result["hand"])
    degrees = lambda theta: "" if theta is None else f"{float(theta) * 180 / np.pi:.10f}"
    with_error = lambda q: (f"{result[q][0]:.8f}", f"{result[q][1] + FLOOR:.1e}")
    core = "" if one["core"] is None else repr(one["core"])
    force = with_error("contact_force") if one["core"] is None else ("", "")
    return [
        one["n"], one["gamma"], one["pretwist"], one["force"], one["moment"],
        f"{result['theta'][0]:.7f}", f"{result['theta'][1] + FLOOR_DEG:.1e}", degrees(contact), degrees(radial),
        result["spans"], f"{one['springs'][-1]:.0f}", one["length"], core, result["hand"], f"{result['uneven']:.1e}",
        *with_error("radius"), *force,
    ]  # fmt: skip


def read_rows(name):
    with open(HERE / name, newline="") as file:
        return list(csv.DictReader(file))


def markdown():
    """Both tables, for the book, from the files as they stand."""
    sign = lambda text: text.replace("-", "−")
    lines = [
        "| n | γ | φ̄a | f | m | simulated | error | contact balance | radial balance |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for r in read_rows("simulation.csv"):
        note = f", piece of {r['cell_length']} r" if float(r["cell_length"]) != LENGTH else ""
        note += f", apart, on a core of radius {r['core_radius']} r" if r["core_radius"] else ""
        place = lambda text: f"{float(text):.6f}°" if text else "–"
        given = " | ".join(sign(r[k]) for k in ("gamma", "pretwist", "force", "moment"))
        result = f"{float(r['theta_simulated_deg']):.6f}° | {float(r['error_deg']):.6f}°"
        both = " | ".join(place(r[f"theta_{balance}_deg"]) for balance in BALANCES)
        lines.append(f"| {r['n']}{note} | {given} | {result} | {both} |")
    lines += ["", "| | simulated | error | contact balance | radial balance |", "|---|---|---|---|---|"]
    for r in read_rows("simulation_flexibility.csv"):
        ply = f"n = {r['n']}, γ = {r['gamma']}, φ̄a = {sign(r['pretwist'])}"
        numbers = " | ".join(sign(f"{float(r[k]):.7f}") for k in ("simulated", "error", *BALANCES))
        lines.append(f"| a ∂{r['displacement']}/∂{r['load']}, {ply} | {numbers} |")
    return "\n".join(lines) + "\n"


def picture(panels):
    """Side views, two cells long, as SVG; near pieces are drawn over far ones."""
    scale, colours = 26.0, ("#c8553d", "#2d7dd2", "#e0a030", "#5a9367", "#8d6a9f", "#777777")
    out, top, width = [], 0.0, 0.0
    for title, cell, x in panels:
        pieces, low, high = [], 0.0, 0.0
        places = np.arange(-0.25 * cell.spans, 1.5 * cell.spans + 0.01, 0.4)
        for k in range(cell.n):
            p = cell.points(x, np.full(places.shape, k), places)[0]
            low, high = min(low, p[:, 0].min()), max(high, p[:, 0].max())
            # each piece reaches into the next ones, so that no seam shows
            pieces += [(p[i + 3, 1], k, p[i : i + 7]) for i in range(0, len(places) - 6, 2)]
        start = min(piece[2][0, 2] for piece in pieces)
        middle = top + 26 + (high + 1.2) * scale
        out.append(f'<text x="6" y="{top + 16:.0f}">{title}</text>')
        for _, k, p in sorted(pieces, key=lambda piece: -piece[0]):
            px, py = (p[:, 2] - start + 1.2) * scale, middle - p[:, 0] * scale
            at = [f"{i:.0f} {j:.1f}" for i, j in zip(px, py)]
            line = "L".join(at), "L".join(at[1:6])
            out.append(f'<path class="o" d="M{line[1]}"/><path stroke="{colours[k % 6]}" d="M{line[0]}"/>')
            width = max(width, px.max() + 1.2 * scale)
        top = middle + (1.2 - low) * scale
    rules = f"path{{stroke-width:{1.84 * scale:.0f};fill:none;stroke-linejoin:round}}.o{{stroke:#222;stroke-width:{2 * scale:.0f}}}text{{font:15px sans-serif;fill:#222}}"
    rules = "".join(
        "#free-rods " + rule + "}" for rule in rules.split("}") if rule
    )  # inside the book no other picture is touched
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" id="free-rods" role="img" aria-label="Strands at the start and at the end" viewBox="0 0 {width:.0f} {top:.0f}">',
            f"<style>{rules}</style>",
            '<rect width="100%" height="100%" fill="#fff"/>',
            *out,
            "</svg>\n",
        ]
    )


def show(tell):
    """What the book shows: the tables, and one case's first descent, before and after."""
    (HERE / "simulation.md").write_text(markdown(), encoding="utf-8")
    (soft, x), states = descend(PICTURED, SPANS[0], PICTURED["starts"][0], 1, tell)
    cell = Cell(PICTURED, SPANS[0], PICTURED["length"], PICTURED["springs"][-1])
    panels = [
        ("Start: three strands apart, side by side, bent at random", soft, x),
        ("End: the state of least energy", cell, states[-1][0]),
    ]
    (HERE / "simulation.svg").write_text(picture(panels), encoding="utf-8")


def write_rows(name, columns, rows):
    with open(HERE / name, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)


def write(tell):
    rows, flexible = [], []
    for number, one in enumerate(CASES, 1):
        tell(f"case {number} of {len(CASES)}: {one}")
        result = simulate(one, tell)
        rows.append(row(one, result))
        if one in FLEXIBLE:
            both = theory_flexibility(one, result["theta"][0], result["hand"])
            for place, (displacement, load, value, error) in enumerate(flexibility(one, tell)):
                theirs = [f"{both[balance][place]:.10f}" for balance in BALANCES]
                ours = [displacement, load, f"{value:.7f}", f"{error + 1e-7:.1e}"]
                flexible.append([one["n"], one["gamma"], one["pretwist"], *ours, *theirs])
        write_rows("simulation.csv", COLUMNS, rows)
        write_rows("simulation_flexibility.csv", FLEXIBILITY_COLUMNS, flexible)
    show(tell)
    tell("all written")


def check(tell):
    """A coarse run of a few cases, each from another start than the table's, must come within a thousandth of a degree."""
    rows = read_rows("simulation.csv")
    failed = 0
    for number in (1, 4, 9, 14):
        one, want = CASES[number - 1], rows[number - 1]
        _, states = descend(one, 20, one["starts"][-1] / 2, 11, tell)
        theta = in_stiffness([seen["theta"] for _, seen in states])[0]
        good = abs(theta - float(want["theta_simulated_deg"])) < 1e-3
        failed += not good
        print(
            f"case {number}: {theta:.6f} deg, table {want['theta_simulated_deg']}: {'good' if good else 'NOT THE SAME'}"
        )
    sys.exit(failed > 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    task = parser.add_mutually_exclusive_group(required=True)
    task.add_argument("--write", action="store_true")
    task.add_argument("--check", action="store_true")
    task.add_argument("--show", action="store_true", help="simulation.md and simulation.svg alone")
    task.add_argument("--case", type=int, help="number of a case, from 1")
    chosen = parser.parse_args()
    began = time.time()
    tell = lambda text: print(f"[{time.time() - began:6.0f} s] {text}", flush=True)
    if chosen.write:
        write(tell)
    elif chosen.check:
        check(tell)
    elif chosen.show:
        show(tell)
    else:
        one = CASES[chosen.case - 1]
        print(dict(zip(COLUMNS, row(one, simulate(one, tell)))))


if __name__ == "__main__":
    main()
