"""Long work: other threads go on, Ctrl-C is heard, forked processes and other interpreters' threads work."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import nply

LONG = """
import sys, time, nply, numpy as np
print("begins", flush=True)
try:
    {work}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(7)
print("done", flush=True)
"""
WORK = {
    "equilibria": "nply.equilibria(5, 0.75, pretwist=np.linspace(-3, 3, 30_000_000), force=0.1)",
    "contact": "[nply.contact(np.full(20_000_000, 40), 0.5) for _ in range(1000)]",
    "map": 'nply.map(strands=3, stiffness_ratio=0.75, pretwist=-0.2, support_core_radius=0.2, to={"force": 1, "moment": 1}, columns=4000, rows=4000)',
    "render": 'nply.render(strands=7, helical_angle="20 deg", width=8000, lay_lengths=8)',
    "writhe": "nply.writhe(np.random.default_rng(1).normal(size=(60_000, 3)).cumsum(axis=0), average_crossings=True)",
}


@pytest.mark.skipif(os.name == "nt", reason="signals are Unix's")
@pytest.mark.parametrize("work", WORK)
def test_ctrl_c_ends_long_work(work: str) -> None:
    child = subprocess.Popen([sys.executable, "-c", LONG.format(work=WORK[work])], stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None and child.stdout.readline() == "begins\n"
    time.sleep(0.7)
    child.send_signal(signal.SIGINT)
    try:
        out, _ = child.communicate(timeout=30)
    finally:
        child.kill()
    assert (out, child.returncode) == ("interrupted\n", 7)


def test_other_threads_go_on() -> None:
    """While one thread works in the theory, another counts: the lock is not held."""
    counted, done = 0, threading.Event()

    def work() -> None:
        nply.equilibria(5, 0.75, pretwist=np.linspace(-3, 3, 300_000), force=0.1)
        done.set()

    worker = threading.Thread(target=work)
    worker.start()
    while not done.wait(0.001):
        counted += 1
    worker.join()
    assert counted > 3


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_child_has_threads_of_its_own() -> None:
    here = nply.equilibria(3, 0.75, pretwist=np.linspace(-2, 2, 40_000))  # the parent's threads stand
    with multiprocessing.get_context("fork").Pool(2) as pool:
        there = pool.map_async(_states, [40_000, 40_000]).get(timeout=60)
    assert all(np.array_equal(angles, here.helical_angle) for angles in there)


def _states(rows: int) -> np.ndarray:
    return nply.equilibria(3, 0.75, pretwist=np.linspace(-2, 2, rows)).helical_angle


def test_threads_may_ask_at_once() -> None:
    want = nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-1).to_json()
    found: list[str] = []

    def ask() -> None:
        for _ in range(20):
            found.append(nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-1).to_json())
            nply.equilibria(3, 0.75, pretwist=np.linspace(-2, 2, 1000))

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [want] * 80
