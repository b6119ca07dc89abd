"""A study on a cluster of processes: the same rows as in one process, and none lost when a worker is killed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from distributed import Client, LocalCluster

import nply
import nply.dask

ROWS = 4000


@pytest.fixture(scope="module")
def study() -> nply.Study:
    return nply.Study(strands=3, stiffness_ratio=0.75, outputs=["helical_angle", "interstrand_pressure"])


@pytest.fixture(scope="module")
def rows() -> pd.DataFrame:
    draw = np.random.default_rng(7)
    frame = pd.DataFrame({"batch": np.arange(ROWS) % 7, "pretwist": draw.uniform(-2, 2, ROWS), "force": draw.uniform(-0.5, 0.5, ROWS)})
    frame.loc[::501, "pretwist"] = np.inf  # rows that no ply can be
    return frame


@pytest.fixture
def client(tmp_path: Path) -> Iterator[Client]:
    here = str(tmp_path / "dask")
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, host="127.0.0.1", local_directory=here
    ) as cluster, Client(cluster) as client:
        yield client


def written(rows: pd.DataFrame, folder: Path, parts: int) -> str:
    folder.mkdir()
    for part, piece in enumerate(np.array_split(np.arange(len(rows)), parts)):
        rows.iloc[piece].to_parquet(folder / f"rows-{part:03}.parquet", index=False)
    return str(folder / "*.parquet")


def test_a_cluster_gives_what_one_process_gives(client: Client, study: nply.Study, rows: pd.DataFrame, tmp_path: Path) -> None:
    alone = nply.sweep(study, rows).to_pandas()
    assert alone["reason"].notna().sum() >= ROWS // 501 and len(alone) > ROWS
    nply.dask.sweep(written(rows, tmp_path / "rows", 9), study).to_parquet(tmp_path / "answers")
    there = pd.concat([pd.read_parquet(part) for part in sorted((tmp_path / "answers").glob("*.parquet"), key=number)])
    pd.testing.assert_frame_equal(there.reset_index(drop=True), alone)
    kept = nply.dask.sweep(rows, study, client=client).compute()
    pd.testing.assert_frame_equal(kept.reset_index(drop=True), alone)


def number(part: Path) -> int:
    return int("".join(letter for letter in part.stem if letter.isdigit()) or 0)


@pytest.mark.skipif(os.name == "nt", reason="signals are Unix's")
def test_a_killed_worker_loses_nothing(client: Client, study: nply.Study, rows: pd.DataFrame, tmp_path: Path) -> None:
    """One of two workers is killed while it works; its partitions are worked out again."""
    many = pd.concat([rows] * 50, ignore_index=True)
    alone = nply.sweep(study, many).to_pandas()
    answers = nply.dask.sweep(written(many, tmp_path / "rows", 60), study, client=client)
    deadline = time.monotonic() + 60
    while not any(client.has_what().values()) and time.monotonic() < deadline:
        time.sleep(0.01)  # until a first part is done
    victim = next(pid for address, pid in client.run(os.getpid).items() if client.has_what()[address])
    os.kill(victim, signal.SIGKILL)
    there = answers.compute()
    assert victim not in client.run(os.getpid).values()
    pd.testing.assert_frame_equal(there.reset_index(drop=True), alone)


def test_the_recipe_s_program_runs(study: nply.Study, rows: pd.DataFrame, root: Path, tmp_path: Path) -> None:
    """The program of docs/dask.md, as it stands there, as a user would run it."""
    text = (root / "docs" / "dask.md").read_text()
    program = text.split("```python\n")[1].split("```")[0]
    (tmp_path / "recipe.py").write_text(program)
    written(rows, tmp_path / "rows", 3)
    done = subprocess.run([sys.executable, "recipe.py"], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    there = pd.concat([pd.read_parquet(part) for part in sorted((tmp_path / "answers").glob("*.parquet"), key=number)])
    pd.testing.assert_frame_equal(there.reset_index(drop=True), nply.sweep(study, rows).to_pandas())
