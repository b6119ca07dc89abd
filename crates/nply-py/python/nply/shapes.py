"""A ply as a shape: surfaces in triangles, centrelines in nodes, rendered pictures.

The ply is described as for :mod:`nply.reports`; by a lay, or by what holds it in equilibrium, and then ``state`` says which of its states is
meant (the first whose strands need not pull on each other, if nothing is said). A document with ``[[layer]]`` is a layered strand or rope.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Union

import numpy as np

from . import _nply
from .pictures import Picture, write_whole
from .reports import Document, Report

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from .data import Data

Length = Union[float, str]

__all__ = ["Centreline", "Centrelines", "Mesh", "Nodes", "centrelines", "mesh", "nodes", "render"]


class Mesh:
    """Closed surfaces in triangles: what :func:`mesh` gives. ``trimesh.Trimesh(mesh.vertices, mesh.faces)`` and ``meshio`` take it."""

    def __init__(self, mesh: _nply.Mesh) -> None:
        self._mesh = mesh
        vertices, normals, faces, wires, colours = mesh.triangles()
        self.vertices: NDArray[np.float64] = vertices
        """Corners, in ``unit``: float64 of shape (V, 3). The axis of the ply is z."""
        self.normals: NDArray[np.float64] = normals
        """Unit normals at the corners: float64 of shape (V, 3)."""
        self.faces: NDArray[np.int64] = faces
        """Triangles by the numbers of their corners, counter-clockwise from outside: int64 of shape (F, 3)."""
        self.wire: NDArray[np.int64] = wires
        """Which wire each triangle is of, an index into ``wires``: int64 of shape (F,)."""
        self.colours: NDArray[np.uint8] = colours
        """Red, green, blue of each triangle: uint8 of shape (F, 3)."""

    @property
    def wires(self) -> list[str]:
        """The wires' names: ``"strand-1"``, ..., ``"core"``."""
        return self._mesh.wires()

    @property
    def unit(self) -> str:
        """The unit of the coordinates: ``"mm"``; ``"r"`` for strand radii."""
        return self._mesh.unit()

    @property
    def lines(self) -> dict[str, NDArray[np.float64]]:
        """Contact lines and cuts, where they were asked for, by name: float64 of shape (N, 3)."""
        return dict(self._mesh.lines())

    @property
    def volume(self) -> float:
        """The volume enclosed, in cubes of ``unit``; wires that overlap count twice."""
        a, b, c = (self.vertices[self.faces[:, k]] for k in range(3))
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)

    def to_bytes(self, format: Literal["stl", "obj", "glb", "ply", "vtk", "vtu"]) -> bytes:
        """A file's bytes, to the last what ``nply mesh --format`` writes."""
        return self._mesh.write(format)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a file: STL, OBJ, GLB (coloured, in metres), PLY, VTK or VTU, by the end of its name."""
        write_whole(path, self._mesh.write(Path(path).suffix.lower().removeprefix(".")))

    def __repr__(self) -> str:
        return self._mesh.summary().rstrip("\n")


@dataclass(frozen=True)
class Centreline:
    """The nodes of one wire."""

    name: str
    """``"strand-1"``, ..., ``"core"``."""
    radius: float
    """The wire's radius, in the unit of the coordinates."""
    points: NDArray[np.float64]
    """The nodes: float64 of shape (N, 3)."""
    tangents: NDArray[np.float64]
    """Unit tangents at the nodes: float64 of shape (N, 3)."""
    arclengths: NDArray[np.float64]
    """Arclengths at the nodes, in the unit of the coordinates: float64 of shape (N,)."""


class Centrelines(Sequence[Centreline]):
    """Centrelines in nodes: what :func:`centrelines` gives, one :class:`Centreline` a wire."""

    def __init__(self, chains: _nply.Chains) -> None:
        self._chains = chains
        self._all = [Centreline(*chain) for chain in chains.chains()]

    def __len__(self) -> int:
        return len(self._all)

    def __getitem__(self, place: Any) -> Any:
        return self._all[place]

    @property
    def unit(self) -> str:
        """The unit of the coordinates: ``"mm"``; ``"r"`` for strand radii."""
        return self._chains.unit()

    def to_bytes(self, format: Literal["csv", "xyz", "pdb", "vtp", "inp"]) -> bytes:
        """A file's bytes, to the last what ``nply mesh --centrelines --format`` writes."""
        return self._chains.write(format)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a file: CSV, XYZ, PDB, VTP or INP (Abaqus, CalculiX), by the end of its name."""
        write_whole(path, self._chains.write(Path(path).suffix.lower().removeprefix(".")))

    def __repr__(self) -> str:
        return self._chains.summary().rstrip("\n")


class Nodes(Report):
    """Start geometry for finite elements: what :func:`nodes` gives; a :class:`Report`, with the nodes as ``centrelines``."""

    def __init__(self, answer: _nply.Answer, chains: _nply.Chains) -> None:
        super().__init__(answer)
        self._chains = chains

    @property
    def centrelines(self) -> Centrelines:
        """The nodes of every wire."""
        return Centrelines(self._chains)


def mesh(
    document: Document | None = None,
    /,
    *,
    state: int | None = None,
    length: Length | None = None,
    lay_lengths: float | None = None,
    core: Length | bool | None = None,
    stripes: int = 0,
    contact_lines: bool = False,
    cuts: Sequence[Length] = (),
    ends: Literal["flush", "square"] = "flush",
    chord_error: Length | None = None,
    facets: int | None = None,
    segments: int | None = None,
    fit: Literal["surface", "inside", "outside", "volume"] = "surface",
    unit: str | None = None,
    **data: Unpack[Data],
) -> Mesh:
    """The strands of a ply, and a core, as closed surfaces in triangles (``nply mesh``).

    Args:
        document: the ply, see :mod:`nply.shapes`.
        state: which of the states that are found, from 1.
        length: how much of the ply, along its axis.
        lay_lengths: the same in lay lengths; 3 if absent (1 of a layered strand).
        core: put in a core of this radius; True: one that fills the hole.
        stripes: lines painted along the material of each strand.
        contact_lines: add the lines along which surfaces touch.
        cuts: add the outlines in the planes at these heights.
        ends: cut off across the ply, or square to each strand.
        chord_error: how far triangles may lie off the surface; a bare number is a share of the strand radius; 0.01 if absent.
        facets, segments: facets round a strand and segments per lay length, instead.
        fit: corners on the surface; all inside or outside of it; or through it, with the volume kept.
        unit: the unit of coordinates; ``"r"`` for strand radii.
        **data: single data.

    Returns:
        :class:`Mesh` with ``vertices`` (V, 3) and ``faces`` (F, 3).

    Raises:
        SpecError: as :func:`nply.solve`; and at the argument that cannot be followed.

    >>> import nply
    >>> ply = nply.mesh(strands=3, helical_angle="20 deg", diameter="2 mm", length="20 mm")
    >>> ply.unit, ply.vertices.shape[1], ply.faces.max() < len(ply.vertices)
    ('mm', 3, np.True_)
    """
    shown = _shown(state, length, lay_lengths, core, stripes, contact_lines, cuts, ends)
    fine = {"chord_error": chord_error, "facets": facets, "segments": segments, "fit": fit}
    return Mesh(_nply.mesh(document, dict(data), shown, fine, unit))


def centrelines(
    document: Document | None = None,
    /,
    *,
    state: int | None = None,
    length: Length | None = None,
    lay_lengths: float | None = None,
    core: Length | bool | None = None,
    elements_per_pitch: int | None = None,
    element_type: Literal["B31", "B32"] = "B31",
    unit: str | None = None,
    **data: Unpack[Data],
) -> Centrelines:
    """Nodes on the centrelines of a ply's strands (``nply mesh --centrelines``).

    Args:
        document, state, length, lay_lengths, core, unit: as for :func:`mesh`.
        elements_per_pitch: elements per lay length of a centreline; 48 if absent.
        element_type: beams of two nodes, or of three ("B32") with the middle one on the centreline too.
        **data: single data.

    Returns:
        :class:`Centrelines`, one a wire.

    >>> import nply
    >>> strands = nply.centrelines(strands=3, helical_angle="20 deg", lay_lengths=2, elements_per_pitch=16)
    >>> len(strands), strands[0].points.shape
    (3, (33, 3))
    """
    shown = _shown(state, length, lay_lengths, core, 0, False, (), "flush")
    return Centrelines(_nply.centrelines(document, dict(data), shown, elements_per_pitch, element_type, unit))


def nodes(
    document: Document | None = None,
    /,
    *,
    elements_per_pitch: int | None = None,
    element_type: Literal["B31", "B32"] = "B31",
    coating: Length | None = None,
    core: Length | bool | None = None,
    stagger: float | None = None,
    any_stagger: bool = False,
    lay_radius: Length | None = None,
    length: Length | None = None,
    lay_lengths: float | None = None,
    unit: str | None = None,
    **data: Unpack[Data],
) -> Nodes:
    """Start geometry of straight elements that do not overlap, for finite elements (``nply nodes``).

    Args:
        document: number, size and lay of the wires, see :mod:`nply.shapes`; or a strand of a core and layers of wires, of which each layer
            is kept clear of what is below it, too.
        elements_per_pitch: elements per lay length, of layers per that of the layer with the shortest; 24 if absent.
        element_type: beams of two nodes, or of three ("B32") with the middle one on the helix too; what is clear are the chords between nodes.
        coating: thickness of a coating on every wire.
        core: a core wire of this radius along the axis; True: one as thick as the others.
        stagger: how many elements farther along each wire's nodes stand than those of the one before.
        any_stagger: keep clear however the nodes of two wires stand to each other.
        lay_radius: take this radius of the centrelines' helices, clear or not.
        length, lay_lengths: how much, along the axis or in lay lengths (3 if absent).
        unit: the unit of coordinates; ``"r"`` for strand radii.
        **data: single data.

    Returns:
        :class:`Nodes`: a report with ``helix_radius``, ``gap``, ``chord_share``, ``clear``, and the nodes as ``centrelines``; of a strand of
        layers with these numbers for each of its ``layers``.

    >>> import nply
    >>> found = nply.nodes(strands=6, helical_angle="17.44 deg", core=True)
    >>> found.clear, len(found.centrelines)
    (True, 7)
    """
    if any_stagger and stagger is not None:
        raise ValueError("stagger and any_stagger exclude each other: give one of them")
    start = {
        "elements_per_pitch": elements_per_pitch,
        "element_type": element_type,
        "coating": coating,
        "core": _core(core),
        "stagger": stagger,
        "any_stagger": any_stagger,
        "lay_radius": lay_radius,
        "length": length,
        "lay_lengths": lay_lengths,
    }
    return Nodes(*_nply.nodes(document, dict(data), start, unit))


def render(
    document: Document | None = None,
    /,
    *,
    state: int | None = None,
    length: Length | None = None,
    lay_lengths: float | None = None,
    core: Length | bool | None = None,
    stripes: int = 0,
    width: int = 1200,
    height: int | None = None,
    turn: str | float | None = None,
    tilt: str | float | None = None,
    roll: str | float | None = None,
    background: Literal["light", "dark", "transparent"] = "light",
    shadow: bool = True,
    **data: Unpack[Data],
) -> Picture:
    """A shaded picture of a ply, by rays against the exact surfaces of its strands (``nply render``).

    Args:
        document, state, length, lay_lengths, core, stripes: as for :func:`mesh`.
        width, height: pixels across (1200 if absent) and up (fitted to the ply).
        turn: how far the ply is turned about its own axis: ``"30 deg"``.
        tilt: how far its end is turned towards the eye (20 deg if absent).
        roll: how far its axis is turned in the picture.
        background: what is behind the ply.
        shadow: whether it throws one.
        **data: single data.

    Returns:
        :class:`Picture` with ``png`` alone.

    >>> import nply
    >>> picture = nply.render(strands=3, helical_angle="20 deg", width=120)
    >>> picture.png[1:4]
    b'PNG'
    """
    shown = _shown(state, length, lay_lengths, core, stripes, False, (), "flush")
    seen = {
        "width": width,
        "height": height,
        "turn": turn,
        "tilt": tilt,
        "roll": roll,
        "background": background,
        "shadow": shadow,
    }
    return Picture(png=_nply.render(document, dict(data), shown, seen))


def _core(core: Length | bool | None) -> Length | None:
    return "" if core is True else None if core is False else core


def _shown(
    state: int | None,
    length: Length | None,
    lay_lengths: float | None,
    core: Length | bool | None,
    stripes: int,
    contact_lines: bool,
    cuts: Sequence[Length],
    ends: str,
) -> dict[str, Any]:
    return {
        "state": state,
        "length": length,
        "lay_lengths": lay_lengths,
        "core": _core(core),
        "stripes": stripes,
        "contact_lines": contact_lines,
        "cuts": list(cuts),
        "ends": ends,
    }
