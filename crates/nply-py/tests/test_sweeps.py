"""Studies: the rows of single plies, in order, however they are cut; nothing lost."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import nply

BASE = {"strands": 3, "stiffness_ratio": 0.75}


def same(one: nply.Table, other: nply.Table) -> bool:
    return one.columns == other.columns and all(
        np.array_equal(one[name], other[name], equal_nan=True) if isinstance(one[name], np.ndarray) else one[name] == other[name]
        for name in one.columns
    )


def test_rows_are_single_plies() -> None:
    table = nply.sweep(**BASE, sweep={"pretwist": np.linspace(-2, 2, 5), "force": [-0.1, 0.2]}, outputs="helical_angle")
    at = 0
    for row, (twist, force) in enumerate((t, f) for t in np.linspace(-2, 2, 5) for f in (-0.1, 0.2)):
        states = nply.solve(**BASE, pretwist=twist, force=force).states
        for state in states:
            assert (table["row"][at], table["pretwist"][at], table["force"][at]) == (row, twist, force)
            assert table["helical_angle_deg"][at] == pytest.approx(state.helical_angle_deg, abs=1e-10)
            at += 1
    assert at == len(table)


def test_a_study_can_be_cut_anywhere() -> None:
    study = nply.Study(stiffness_ratio=BASE["stiffness_ratio"], sweep=["strands=2,3,7", "pretwist=-2:2:9001"], outputs="helical_angle")
    whole = study.solve()
    assert len(study) == 27003
    for batch, first in zip(study.batches(rows=5000), range(0, 27003, 5000)):
        here = (whole["row"] >= first) & (whole["row"] < first + 5000)
        assert np.array_equal(batch["helical_angle_deg"], whole["helical_angle_deg"][here])
    piece = study.solve(12345, 10)
    here = (whole["row"] >= 12345) & (whole["row"] < 12355)
    assert np.array_equal(piece["row"], whole["row"][here])
    assert np.array_equal(piece["helical_angle_deg"], whole["helical_angle_deg"][here])
    assert len(study.solve(30_000)) == 0
    with pytest.raises(ValueError):
        study.solve(-1)


def test_a_study_travels_as_its_text() -> None:
    study = nply.Study(**BASE, sweep="pretwist=-1:1", sample="sobol", points=64, seed=3, states="stable", outputs="helical_angle")
    again = pickle.loads(pickle.dumps(study))
    assert again.text == study.text and same(again.solve(), study.solve())
    assert nply.Study(study.text).columns == study.columns


def test_rows_that_are_handed_in_are_answered_in_their_order() -> None:
    import pandas as pd
    import pyarrow as pa

    frame = pd.DataFrame(
        {"name": ["a", "b", "c"], "pretwist": [-1.0, np.inf, 1.0], "lay": [1, 2, 3], "strands": pd.array([2, 3, None], dtype="Int64")}
    )
    study = nply.Study(**BASE, outputs="helical_angle")
    answers = nply.solve_batch(frame, study).to_pandas()
    assert answers["name"].unique().tolist() == ["a", "b", "c"] and "lay" in answers
    bad = answers[answers["name"] == "b"].iloc[0]
    assert "pretwist" in bad["reason"] and np.isnan(bad["helical_angle_deg"])
    # the empty cell is what the study says
    want = [state.helical_angle_deg for state in nply.solve(**BASE, pretwist=1).states]
    assert answers[answers["name"] == "c"]["helical_angle_deg"].tolist() == pytest.approx(want)
    for table in (pa.Table.from_pandas(frame), pa.RecordBatch.from_pandas(frame), nply.Table.read(frame)):
        assert same(nply.solve_batch(table, study), nply.sweep(study, frame))
    empty = nply.solve_batch(pa.table(frame).slice(0, 0), study)
    assert len(empty) == 0 and empty.columns == list(answers)
    chunks = pa.concat_tables([pa.table(frame).slice(k, 1) for k in range(3)])
    assert same(nply.solve_batch(chunks, study), nply.solve_batch(frame, study))


def test_what_is_no_study_is_said() -> None:
    with pytest.raises(nply.SpecError, match="no column is a datum"):
        nply.solve_batch(nply.Table.of({"x": np.zeros(2)}), **BASE)
    with pytest.raises(nply.SpecError, match="no datum of a ply"):
        nply.Study(**BASE, sweep="angle=0:1:3")
    with pytest.raises(TypeError, match="cannot be changed"):
        nply.sweep(nply.Study(**BASE, sweep="pretwist=0:1:3"), outputs="helical_angle")


def test_the_table_is_the_command_s(root: Path, command, tmp_path: Path) -> None:
    import pyarrow as pa
    import pyarrow.parquet

    for name in ("yarn-twist", "yarn-tolerance"):
        document = f"examples/studies/{name}.toml"
        _, said = command("sweep", document, "--output", str(tmp_path / f"{name}.parquet"), "--quiet")
        written = pa.parquet.read_table(tmp_path / f"{name}.parquet")
        table = pa.table(nply.sweep(root / document))
        assert table.equals(written), said
        for field in table.schema:
            assert field.metadata == written.schema.field(field.name).metadata
        rows = written.select([column for column in written.column_names if column not in ("row",)])
        assert rows.num_rows > 0
    words = ["--strands=3", "--stiffness-ratio=0.75", "--sweep=pretwist=-1:1:5", "--sweep=force=0,0.1", "--outputs=helical_angle"]
    command("sweep", *words, "--output", str(tmp_path / "flags.parquet"), "--quiet")
    written = pa.parquet.read_table(tmp_path / "flags.parquet")
    assert pa.table(nply.sweep(**BASE, sweep=["pretwist=-1:1:5", "force=0,0.1"], outputs="helical_angle")).equals(written)
