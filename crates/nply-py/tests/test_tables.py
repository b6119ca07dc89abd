"""Tables go out and come in by Arrow's C data interface, without a copy and without any library that need not be there."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest

import nply

RODS = {"strands": 3, "stiffness_ratio": 0.75, "pretwist": -0.2}


@pytest.fixture(scope="module")
def found() -> nply.Map:
    return nply.map(**RODS, from_={"force": -1, "moment": -3}, to={"force": 1, "moment": 2}, columns=31, rows=17)


def test_a_map_is_the_command_s(command, found: nply.Map, tmp_path: Path) -> None:
    words = ["--strands=3", "--stiffness-ratio=0.75", "--pretwist=-0.2", "--columns=31", "--rows=17"]
    words += ["--from-force=-1", "--from-moment=-3", "--to-force=1", "--to-moment=2"]
    out, _ = command("map", *words)
    rows = list(csv.DictReader(io.StringIO(out.decode())))
    assert len(rows) == len(found.table) and list(rows[0]) == found.table.columns
    for name in found.table.columns:
        column = found.table[name]
        for row, cell in zip(rows, column):
            text = "" if cell is None or cell != cell else cell
            if isinstance(text, (bool, np.bool_)):
                text = str(bool(text)).lower()
            assert row[name] == text or float(row[name]) == text
    said, _ = command("map", *words, "--plot", str(tmp_path / "map.svg"), "--quiet")
    assert repr(found) + "\n" == said.decode()
    assert found.picture.svg == (tmp_path / "map.svg").read_text()


def test_columns_are_handed_over_not_copied(found: nply.Map) -> None:
    import pyarrow as pa

    table = pa.table(found)
    assert table.num_rows == len(found.table) and table.column_names == found.table.columns
    assert table.schema.field("helical_angle_deg").metadata == {b"unit": b"deg"}
    assert table.schema.metadata[b"balance"] == b"contact"
    again = nply.Table.read(table)
    back = pa.table(again)
    assert back.equals(table)
    for name in ("force", "states", "support"):
        there = [buffer.address for chunk in table[name].chunks for buffer in chunk.buffers() if buffer]
        here = [buffer.address for chunk in back[name].chunks for buffer in chunk.buffers() if buffer]
        assert there == here


def test_columns_are_numpy_s(found: nply.Map) -> None:
    import pyarrow as pa

    table = pa.table(found)
    assert found.table["force"].dtype == np.float64 and found.table["states"].dtype == np.int64
    assert np.array_equal(found.table["force"], table["force"].to_numpy())
    assert found.table["support"] == table["support"].to_pylist()
    assert np.array_equal(found.table["helical_angle_deg"], table["helical_angle_deg"].to_numpy(), equal_nan=True)
    assert found.table.to_pandas().shape == (len(found.table), len(found.table.columns))
    assert "force" in found.table and "angle" not in found.table
    with pytest.raises(KeyError):
        _ = found.table["angle"]
    assert "<th>helical_angle_deg (deg)</th>" in found.table._repr_html_()


def test_one_batch_is_a_table_too() -> None:
    import pyarrow as pa

    batch = pa.record_batch({"x": [1.0, 2.0], "name": ["a", None]})
    table = nply.Table.read(batch)
    assert table["x"].tolist() == [1.0, 2.0] and table["name"] == ["a", None]
    with pytest.raises(TypeError, match="__arrow_c_stream__ or __arrow_c_array__; dict has neither"):
        nply.Table.read({"x": [1.0]})
    with pytest.raises(ValueError):
        nply.Table.of({"x": np.zeros(2), "y": np.zeros(3)})
    with pytest.raises(TypeError):
        nply.Table.of({"x": np.zeros(2, dtype=np.float32)})


def test_states_are_a_table() -> None:
    import pyarrow as pa

    states = nply.equilibria([2, 3], 0.75, pretwist=[[-1.0], [1.0]])
    table = pa.table(states)
    assert table["row"].to_pylist() == states.rows.tolist()
    assert np.array_equal(table["helical_angle"].to_numpy(), states.helical_angle)


def test_no_library_of_tables_or_charts_is_needed(python) -> None:
    """With pyarrow, pandas, polars, matplotlib and dask out of reach everything else works."""
    program = """
import sys
for name in ("pyarrow", "pandas", "polars", "matplotlib", "dask", "IPython"):
    sys.modules[name] = None
import nply
found = nply.map(strands=3, stiffness_ratio=0.75, pretwist=-0.2, to={"force": 1, "moment": 2}, columns=3, rows=3)
copy = nply.Table.read(found.table)
assert len(copy) == len(found.table) and (copy["force"] == found.table["force"]).all()
nply.equilibria(3, 0.75, pretwist=[1.0, 2.0]).to_table().to_dict()
nply.plot(strands=3, stiffness_ratio=0.75, sweep="pretwist=-3..3", ask="helical_angle").svg
try:
    copy.to_arrow()
except ImportError:
    print("needs pyarrow")
"""
    assert python(program) == "needs pyarrow\n"
