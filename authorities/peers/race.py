"""Our programs and the scripts beside this file in turn, on the same inputs; writes authorities/speed.json and speed.md.

    cargo xtask race [rounds]

Standard library only; the scripts need numpy, scipy and numba. Each round runs ours and theirs once each, one after the other. Of a program the
fastest piece over all rounds counts: on a machine that does other work it is what the program needs. Pieces of ours are timed by the clock, and are so
short that the fastest of many is not interrupted; those of the scripts, some of which take seconds, in processor time, which leaves out what other
programs took from them. Whole runs are in processor time as well, but for the table, which takes all cores. speed.json has the medians too.
"""

import datetime
import json
import os
import pathlib
import platform
import resource
import statistics
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RELEASE = ROOT / "target" / "release"

# what is done; unit of an item; our program; scripts with their names
JOBS = [
    ("contacts of arrays (x and ρ, n = 2 … 12, any angle)", "a contact", "contacts",
     [("numba, Newton's iteration", "contacts_numba.py"), ("scipy `brentq`", "contacts_brentq.py")]),
    ("one contact after the other", "a contact", "one-contact",
     [("numba, Newton's iteration", "contacts_numba.py"), ("scipy `brentq`", "contacts_brentq.py")]),
    ("all states of arrays of plies, both hands, radial balance", "a ply", "states",
     [("numba, scan of 400 angles", "states_numba.py"), ("scipy scan and nested `brentq`", "states_brentq.py")]),
    ("one ply after the other, radial balance", "a ply", "one-ply",
     [("numba, scan of 400 angles", "states_numba.py"), ("scipy scan and nested `brentq`", "states_brentq.py")]),
    ("all states of arrays of plies, contact balance", "a ply", "states-contact", []),
    ("writhe of a closed trefoil of 10 000 points", "a curve", "writhe", [("numba, all pairs", "writhe_numba.py")]),
]

# scripts that take the rows that ours takes, all of them
SAME_ROWS = {"contacts_numba.py", "writhe_numba.py"}


def timed_inside(command):
    """Best and middle piece in seconds, and the number to compare."""
    said = subprocess.run(command, capture_output=True, text=True, check=True, cwd=HERE).stdout.split()
    return float(said[0]) * 1e-9, float(said[1]) * 1e-9, float(said[2])


def processor_time():
    """Of all programs started here that have ended, in seconds."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed_whole(command, runs, clock=processor_time):
    """Whole runs of a command, in seconds."""
    times = []
    for _ in range(runs):
        start = clock()
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True, cwd=ROOT)
        times.append(clock() - start)
    times.sort()
    return times[0], times[len(times) // 2], None


def agree(results, names):
    """Programs that take the same rows must come to the same number."""
    for name in names:
        if abs(results[name][2] / results["nply"][2] - 1) > 1e-9:
            raise SystemExit(f"{name} comes to {results[name][2]}, nply to {results['nply'][2]}")


def in_turn(programs, rounds):
    """{name: (best, median, check)} of programs called one after the other, round after round."""
    seen = {name: [] for name, _ in programs}
    for _ in range(rounds):
        for name, call in programs:
            seen[name].append(call())
    of = lambda name, which: [one[which] for one in seen[name]]
    return {name: (min(of(name, 0)), statistics.median(of(name, 1)), seen[name][-1][2]) for name, _ in programs}


def races(rounds):
    nply, ours = RELEASE / "nply", RELEASE / "examples" / "race"
    for job, unit, mine, scripts in JOBS:
        programs = [("nply", lambda: timed_inside([ours, mine]))]
        programs += [(name, lambda script=script: timed_inside([sys.executable, script])) for name, script in scripts]
        results = in_turn(programs, rounds)
        agree(results, [name for name, script in scripts if script in SAME_ROWS])
        yield job, unit, results
    start = [("nply", lambda: timed_whole([nply, "solve", "examples/three-ply-yarn.toml"], 15)),
             ("`import numpy, scipy.optimize`", lambda: timed_whole([sys.executable, "-c", "import numpy, scipy.optimize"], 3))]
    yield "the command `nply solve`, start to finish", "a run", in_turn(start, rounds)
    table = ROOT / "target" / "race.parquet"
    study = [nply, "sweep", HERE / "million.toml", "--output", table]
    yield "a table of a million contacts as Parquet (`nply sweep`), all cores, by the clock", "a run", in_turn([("nply", lambda: timed_whole(study, 3, time.perf_counter))], rounds)
    table.unlink(missing_ok=True)


def size(seconds):
    for unit, scale in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= scale:
            return f"{seconds / scale:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def machine():
    name = platform.processor() or platform.machine()
    cores = os.cpu_count()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    return f"{name}, {cores} cores, {platform.system()}"


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    import numba
    import numpy
    import scipy

    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else None
    jobs = []
    for job, unit, results in races(rounds):
        best, middle, check = results["nply"]
        entry = {"job": job, "unit": unit, "nply": {"best_s": best, "median_s": middle, "check": check}, "peers": []}
        for name, (their_best, their_middle, their_check) in results.items():
            if name != "nply":
                entry["peers"].append({"name": name, "best_s": their_best, "median_s": their_middle, "check": their_check,
                                       "ratio": their_best / best})
        jobs.append(entry)
        print(json.dumps(entry, ensure_ascii=False), flush=True)
    about = {"date": datetime.date.today().isoformat(), "machine": machine(), "load_before": load, "rounds": rounds,
             "python": platform.python_version(), "numpy": numpy.__version__, "scipy": scipy.__version__, "numba": numba.__version__,
             "jobs": jobs}
    (HERE.parent / "speed.json").write_text(json.dumps(about, ensure_ascii=False, indent=2) + "\n")
    (HERE.parent / "speed.md").write_text(page(about))


def page(about):
    quiet = about["load_before"] is None or about["load_before"] < 1
    lines = [
        "# Speed", "",
        f"Measured on {about['date']}: {about['machine']}; Python {about['python']}, numpy {about['numpy']}, scipy {about['scipy']}, "
        f"numba {about['numba']}. {about['rounds']} rounds, ours and theirs in turn, one core each. "
        + ("The machine did nothing else." if quiet else
           f"The machine did other work at the time (load {about['load_before']:.0f}); each figure is the best piece of all rounds."),
        "", "| job | for | nply | the same in Python | ratio |", "|---|---|---|---|---|"]
    best = lambda one: size(one["best_s"])
    for entry in about["jobs"]:
        first = f"| {entry['job']} | {entry['unit']} | {best(entry['nply'])} |"
        if not entry["peers"]:
            lines.append(f"{first} – | |")
        for peer in entry["peers"]:
            ratio = float(f"{peer['ratio']:.2g}")
            lines.append(f"{first} {peer['name']}: {best(peer)} | {ratio:g} |")
            first = "| | | |"
    found = {entry["job"]: entry for entry in about["jobs"]}
    for job, entry in found.items():
        for peer in entry["peers"]:
            if job.startswith("all states") and peer["name"].startswith("numba"):
                lines += ["", f"Of the same 20 000 plies nply finds {entry['nply']['check']:.4f} states each, the scan in numba {peer['check']:.4f}: it misses pairs of "
                          "states that stand closer than its grid."]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
