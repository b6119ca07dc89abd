"""Curves from arrays are those from files, and link, twist and writhe keep their laws."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nply


def torus_knot(p: int, q: int, n: int) -> np.ndarray:
    t = np.linspace(0, 2 * np.pi, n + 1)
    radius = 2 + np.cos(q * t)
    curve = np.stack([radius * np.cos(p * t), radius * np.sin(p * t), np.sin(q * t)], axis=1)
    curve[-1] = curve[0]
    return curve


def test_arrays_are_files(tmp_path: Path) -> None:
    knot = torus_knot(2, 3, 500)
    text = "x,y,z\n" + "\n".join(",".join(map(repr, point)) for point in knot.tolist()) + "\n"
    (tmp_path / "knot.csv").write_text(text)
    np.save(tmp_path / "knot.npy", knot)
    values = {nply.writhe(curve).writhe for curve in (knot, knot.tolist(), tmp_path / "knot.csv", str(tmp_path / "knot.npy"))}
    assert len(values) == 1
    assert nply.writhe(knot[:, :] * [1, 1, -1]).writhe == -values.pop()
    several = nply.writhe(np.stack([knot, 2 * knot]))
    assert len(several.curves) == 2 and several.writhe is None
    assert several.curves[0].writhe == pytest.approx(several.curves[1].writhe, abs=1e-12)


def test_the_tree_and_the_count_agree() -> None:
    knot = torus_knot(3, 4, 800)
    count = nply.writhe(knot)
    tree = nply.writhe(knot, method="tree", tolerance=1e-8)
    assert tree.writhe == pytest.approx(count.writhe, abs=1e-8)
    assert sum(tree.curves[0].shares) == pytest.approx(count.writhe, abs=1e-8)
    assert nply.writhe(knot, average_crossings=True).average_crossing_number > abs(count.writhe)


def test_link_is_twist_and_writhe() -> None:
    knot = torus_knot(2, 3, 2000)
    t = np.linspace(0, 2 * np.pi, 2001)
    tangent = np.gradient(knot[:-1], axis=0)
    tangent = np.r_[tangent, tangent[:1]]
    normal = np.cross(tangent, [0.3, 0.2, 1.0])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    binormal = np.cross(tangent, normal)
    binormal /= np.linalg.norm(binormal, axis=1)[:, None]
    edge = knot + 0.05 * (np.cos(5 * t)[:, None] * normal + np.sin(5 * t)[:, None] * binormal)
    edge[-1] = edge[0]
    report = nply.twist(knot, edge)
    ribbon = report.curves[0]
    assert ribbon.twist + ribbon.writhe == pytest.approx(ribbon.linking_number, abs=1e-3)
    assert nply.link([knot, edge]).linking_numbers[0][1] == ribbon.linking_number


def test_the_chain_of_two_rings_and_wires_apart(root: Path, command) -> None:
    file = sorted((root / "examples" / "curves").iterdir())[0]
    ask = str(file.relative_to(root))
    out, _ = command("writhe", ask, "--json", "--quiet")
    import os

    here = os.getcwd()
    os.chdir(root)
    try:
        assert nply.writhe(ask).to_json().encode() == out
    finally:
        os.chdir(here)
    wires = np.array([[[0, 0, 0], [0, 0, 9]], [[3, 0, 0], [3, 0, 9]], [[0, 1.5, 0], [0, 1.5, 9]]], dtype=float)
    report = nply.clearance(wires, [2, 2, 2])
    assert (report.least_distance, report.overlapping_pairs) == (1.5, 1)
    assert nply.clearance(wires, "1 mm", unit="mm").clearance == 0.5


def test_what_cannot_be_is_said(tmp_path: Path) -> None:
    crossing = [[[0, 0, 0], [1, 0, 0]], [[0.5, -1, 0], [0.5, 1, 0]]]
    with pytest.raises(nply.CurveError):
        nply.link(crossing)
    (tmp_path / "bad.csv").write_text("x,y,z\n0,0,0\n0,0,one\n")
    with pytest.raises(nply.ReadError, match='bad.csv:3:5: "one" is no number') as refused:
        nply.writhe(tmp_path / "bad.csv")
    assert refused.value.line == 3
    with pytest.raises(ValueError, match="array of shape"):
        nply.writhe([[0, 0], [1, 1]])
    with pytest.raises(nply.NplyError):
        nply.writhe([[0, 0, 0], [1, 0, float("nan")]])
    with pytest.raises(ValueError, match="tree"):
        nply.writhe([[0, 0, 0], [1, 0, 0], [1, 1, 1]], tolerance=1e-3)
    with pytest.raises(FileNotFoundError):
        nply.writhe(tmp_path / "none.csv")
    with pytest.raises(nply.SpecError, match="^diameter: .* say theirs with unit"):
        nply.clearance([[0, 0, 0], [1, 0, 0]], "1 mm")


def test_a_curve_read_backwards_turns_the_sign_of_its_link(tmp_path):
    t = np.linspace(0, 2 * np.pi, 101)
    one = np.stack([np.cos(t), np.sin(t), 0 * t], axis=1)
    other = np.stack([1 + np.cos(t), 0 * t, np.sin(t)], axis=1)
    path = tmp_path / "rings.csv"
    rows = [f"{name},{x},{y},{z}" for name, ring in (("a", one), ("b", other)) for x, y, z in ring]
    path.write_text("curve,x,y,z\n" + "\n".join(rows) + "\n")
    as_written = nply.link(path, closed=True).linking_numbers[0][1]
    assert abs(as_written) == 1
    assert nply.link(path, closed=True, reverse=["b"]).linking_numbers[0][1] == -as_written
    assert nply.link(path, closed=True, reverse="b").linking_numbers[0][1] == -as_written
