"""Shapes: the command's files, closed surfaces of the right volume, nodes, pictures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nply

ROPE = {"strands": 3, "helical_angle": "20 deg", "diameter": "2 mm", "length": "20 mm"}
WORDS = ["--strands=3", "--helical-angle=20 deg", "--diameter=2 mm", "--length=20 mm"]


def test_files_are_the_command_s(command, tmp_path: Path) -> None:
    for ending in ("stl", "obj", "glb", "ply", "vtk", "vtu"):
        out, _ = command("mesh", *WORDS, "--format", ending)
        mesh = nply.mesh(**ROPE)
        assert mesh.to_bytes(ending) == out
        mesh.save(tmp_path / f"rope.{ending.upper()}")
        assert (tmp_path / f"rope.{ending.upper()}").read_bytes() == out
    for ending in ("csv", "xyz", "pdb", "vtp", "inp"):
        out, _ = command("mesh", *WORDS, "--centrelines", "--unit=mm", "--format", ending)
        assert nply.centrelines(**ROPE, unit="mm").to_bytes(ending) == out
    with pytest.raises(ValueError, match='one of "stl"'):
        nply.mesh(**ROPE).save(tmp_path / "rope.step")
    assert not (tmp_path / "rope.step").exists()
    with pytest.raises(ValueError):
        nply.mesh(**ROPE, contact_lines=True).to_bytes("stl")  # no place for lines


def test_surfaces_are_closed_and_hold_the_volume() -> None:
    for fit in ("inside", "volume", "outside"):
        mesh = nply.mesh(**ROPE, core=True, fit=fit, chord_error=0.003)
        assert mesh.wires == ["strand-1", "strand-2", "strand-3", "core"]
        edges = np.concatenate([mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]])
        there = {tuple(edge) for edge in edges.tolist()}
        assert len(there) == len(edges) and all((b, a) in there for a, b in there)  # each once, and once the other way
        hole = nply.shape(strands=3, helical_angle="20 deg").hole_radius
        whole = 3 * np.pi * 20 / np.cos(np.radians(20)) + np.pi * hole**2 * 20
        off = mesh.volume / whole - 1
        assert abs(off) < (1e-4 if fit == "volume" else 0.01) and (off < 0 if fit == "inside" else off > -1e-4)
        assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1)
        assert set(mesh.wire.tolist()) == {0, 1, 2, 3} and mesh.colours.dtype == np.uint8


def test_lines_and_states() -> None:
    mesh = nply.mesh(**ROPE, contact_lines=True, cuts=["10 mm"])
    assert {name.split("-")[0] for name in mesh.lines} == {"contact", "cut"}
    assert all(line.shape[1] == 3 for line in mesh.lines.values())
    cut = next(line for name, line in mesh.lines.items() if name.startswith("cut"))
    assert np.allclose(cut[:, 2], cut[0, 2])
    state = nply.mesh(strands=3, stiffness_ratio=0.75, pretwist=-1, state=2, ends="square")
    assert "state 2 of 2" in repr(state)
    with pytest.raises(nply.SpecError, match="state"):
        nply.mesh(strands=3, stiffness_ratio=0.75, pretwist=-1, state=9)
    with pytest.raises(nply.SpecError, match="unit"):
        nply.mesh(strands=3, helical_angle="20 deg", unit="mm")


def test_nodes_of_elements_do_not_overlap(root: Path) -> None:
    """By another route: the clearance of the very nodes, as polylines."""
    found = nply.nodes(strands=6, helical_angle="17.44 deg", core=True, lay_lengths=1)
    assert found["clear"] is True
    wires = [wire.points for wire in found.centrelines]
    apart = nply.clearance(wires, 2.0)
    assert abs(apart.clearance) < 1e-12 and apart.overlapping_pairs == 0
    assert found.centrelines[0].radius == 1.0 and found.centrelines.unit == "r"
    layered = nply.nodes(root / "examples" / "spiral-strand-1x19.toml", element_type="B32", lay_lengths=1)
    assert layered.clear is True and len(layered.layers) == 2 and len(layered.centrelines) == 19
    wires = [wire.points for wire in layered.centrelines]
    apart = nply.clearance(wires, [2 * wire.radius for wire in layered.centrelines])
    assert apart.overlapping_pairs == 0 and apart.clearance < 1e-12
    # 24 elements of two chords to 60 mm, over 110 mm
    assert len(wires[0]) == 2 * 44 + 1
    with pytest.raises(nply.SpecError, match="describes a rope"):
        nply.nodes(root / "examples" / "rope-6x7.toml")


def test_pictures(command, tmp_path: Path) -> None:
    out, _ = command("render", *WORDS, "--width=200", "--tilt=30 deg", "--output=-", "--quiet")
    picture = nply.render(**ROPE, width=200, tilt="30 deg")
    assert picture.png == out == picture._repr_png_() and picture._repr_svg_() is None
    with pytest.raises(AttributeError, match="no SVG"):
        _ = picture.svg
    with pytest.raises(nply.SpecError, match="^tilt: what is wanted is an angle"):
        nply.render(**ROPE, tilt=30)
    words = ["--strands=2,3", "--stiffness-ratio=0.75", "--sweep=pretwist=-3..3", "--ask=helical_angle", "--balance=both"]
    plot = nply.plot(strands=[2, 3], stiffness_ratio=0.75, sweep="pretwist=-3..3", ask="helical_angle", balance="both")
    for name, content in [("p.svg", lambda: plot.svg.encode()), ("p.png", lambda: plot.png), ("p.csv", lambda: plot.csv.encode())]:
        command("plot", *words, "--output", str(tmp_path / name))
        assert (tmp_path / name).read_bytes() == content()
        plot.save(tmp_path / f"own-{name}")
        assert (tmp_path / f"own-{name}").read_bytes() == content()
    command("plot", *words, "--dark", "--output", str(tmp_path / "d.svg"))
    assert plot.dark.svg == (tmp_path / "d.svg").read_text() and plot._repr_svg_() == plot.svg
    with pytest.raises(ValueError, match="SVG or PNG"):
        plot.save(tmp_path / "p.pdf")
    assert plot.to_png(1.0) != plot.png
    with pytest.raises(ValueError):
        plot.to_png(100)
    with pytest.raises(OSError):
        plot.save(tmp_path / "no" / "p.svg")
    assert sorted(path.name for path in tmp_path.glob("*.part")) == []


def test_reports_have_pictures(command, root: Path, tmp_path: Path) -> None:
    command("locus", "examples/rubber-rods.toml", "--plot", str(tmp_path / "l.svg"))
    assert nply.locus(root / "examples" / "rubber-rods.toml").picture.svg == (tmp_path / "l.svg").read_text()
    command("trace", "examples/letting-go.toml", "--plot", str(tmp_path / "t.svg"))
    report = nply.trace(root / "examples" / "letting-go.toml")
    assert report.picture.svg == (tmp_path / "t.svg").read_text()
    assert report._repr_html_().startswith("<svg")


def test_the_paper_s_figures(command) -> None:
    assert nply.figures()[0] == "1" and len(nply.figures()) == 17
    out, _ = command("figure", "1")
    assert nply.figure(1).svg.encode() == out
    out, _ = command("figure", "table1", "--csv")
    assert nply.figure("table1").csv.encode() == out
    with pytest.raises(KeyError, match="no such figure"):
        nply.figure(16)
