"""Curves, from arrays or files: writhe, link, clearance.

*Curves* are an array of shape (N, 3) (one curve) or (K, N, 3) (K curves), a path to a file the command reads (rows, XYZ, PDB, VTK, VTP, OBJ, INP,
NPY), or a list of these. A curve whose last point repeats the first is closed, unless ``closed`` says otherwise.
"""

from __future__ import annotations

import io
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Union

import numpy as np

from . import _nply
from .reports import Report

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Curves = Union["ArrayLike", str, "os.PathLike[str]", Sequence[Any]]
Length = Union[float, str]

__all__ = ["Curves", "clearance", "link", "twist", "writhe"]


def writhe(
    curves: Curves,
    *,
    closed: bool | None = None,
    extend: Length | None = None,
    extend_along: Literal["tangents", "chord"] = "tangents",
    axis: ArrayLike | None = None,
    ribbon: bool = False,
    average_crossings: bool = False,
    method: Literal["crossings", "tree"] = "crossings",
    tolerance: float | None = None,
    unit: str | None = None,
    read_as: str | None = None,
    reverse: Sequence[str] = (),
) -> Report:
    """The writhe of curves, closed or open, exact for the polygon, with a bound for its rounding error (``nply writhe``).

    Args:
        curves: see :mod:`nply.curves`.
        closed: join every curve's ends (True), take every curve as open (False), or as it is written (None).
        extend: prolong both ends of open curves by this length, straight.
        extend_along: along their end segments, or the line through the ends.
        axis: give the polar writhe along this axis too (Berger & Prior 2006).
        ribbon: curves come in twos, a centreline and the edge of its ribbon: give its twist and link too.
        average_crossings: give the average crossing number too: a sum over all pairs of segments.
        method: count crossings (exact), or sum by segments with a tree, which tells each one's share.
        tolerance: what the tree may be wrong by in all, in turns; 1e-6 if absent.
        unit: the unit of the coordinates, for lengths with a unit.
        read_as: the files' format, where name and beginning do not tell it.
        reverse: names of curves, as in the report, that are read from their last point to their first.

    Returns:
        :class:`Report` with ``writhe`` and ``error_bound`` (of one curve; None for several) and ``curves``.

    Raises:
        CurveError: a curve that has no writhe: segments touch.
        ReadError: a file is refused.

    A right-handed trefoil has positive writhe; this one is left-handed.

    >>> import numpy as np, nply
    >>> t = np.linspace(0, 2 * np.pi, 301)
    >>> trefoil = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1)
    >>> trefoil[-1] = trefoil[0]
    >>> round(nply.writhe(trefoil).writhe, 2)
    -3.35
    """
    if method not in ("crossings", "tree"):
        raise ValueError(f'method is "crossings" or "tree", not {method!r}')
    if method == "crossings" and tolerance is not None:
        raise ValueError("tolerance: crossings are counted without error; it goes with method=\"tree\"")
    wanted = 1e-6 if method == "tree" and tolerance is None else tolerance
    direction = None if axis is None else [float(x) for x in np.asarray(axis, dtype=np.float64).reshape(3)]
    given = _given(curves, closed, extend, extend_along, unit, read_as, reverse)
    return Report(_nply.writhe(given, direction, ribbon, average_crossings, wanted))


def twist(centreline: ArrayLike, edge: ArrayLike, *, closed: bool | None = None) -> Report:
    """The twist of a ribbon in turns, with its writhe and, where it is closed, its linking number (``nply writhe --ribbon``).

    Args:
        centreline: array of shape (N, 3).
        edge: array of the same shape: where the ribbon's edge runs beside each of the centreline's points.
        closed: as for :func:`writhe`.

    Returns:
        :class:`Report` with ``twist``, ``writhe``, ``twist_plus_writhe`` and ``linking_number``.

    >>> import numpy as np, nply
    >>> t = np.linspace(0, 2 * np.pi, 201)
    >>> circle = np.stack([np.cos(t), np.sin(t), 0 * t], axis=1)
    >>> edge = circle * (1 + 0.1 * np.cos(3 * t))[:, None] + np.outer(0.1 * np.sin(3 * t), [0, 0, 1])
    >>> circle[-1], edge[-1] = circle[0], edge[0]
    >>> abs(nply.twist(circle, edge).linking_number)
    3
    """
    return writhe([np.asarray(centreline), np.asarray(edge)], ribbon=True, closed=closed)


def link(
    curves: Curves,
    *,
    closed: bool | None = None,
    extend: Length | None = None,
    extend_along: Literal["tangents", "chord"] = "tangents",
    unit: str | None = None,
    read_as: str | None = None,
    reverse: Sequence[str] = (),
) -> Report:
    """The linking number of each two curves: an integer for closed ones, the Gauss integral where one is open (``nply link``).

    Args:
        curves: see :mod:`nply.curves`; at least two.
        closed, extend, extend_along, unit, read_as, reverse: as for :func:`writhe`. Strands of a duplex in a PDB file, each from 5' to 3',
            run against each other: reversing one gives the link the sign it has in the literature.

    Returns:
        :class:`Report` with the matrix ``linking_numbers`` (0 on the diagonal) and ``error_bounds``.

    Raises:
        CurveError: curves that touch have no link.

    >>> import numpy as np, nply
    >>> t = np.linspace(0, 2 * np.pi, 101)
    >>> one = np.stack([np.cos(t), np.sin(t), 0 * t], axis=1)
    >>> other = np.stack([1 + np.cos(t), 0 * t, np.sin(t)], axis=1)
    >>> abs(nply.link([one, other], closed=True).linking_numbers[0][1])
    1
    """
    return Report(_nply.link(_given(curves, closed, extend, extend_along, unit, read_as, reverse)))


def clearance(
    curves: Curves,
    diameter: Length | Sequence[Length] | None = None,
    *,
    closed: bool | None = None,
    unit: str | None = None,
    read_as: str | None = None,
    reverse: Sequence[str] = (),
) -> Report:
    """The least distance of any two different wires, where it is, and which overlap (``nply clearance``).

    Args:
        curves: centrelines, see :mod:`nply.curves`.
        diameter: the wires' diameter, or one for each; else a column ``diameter`` of the file.
        closed, unit, read_as, reverse: as for :func:`writhe`.

    Returns:
        :class:`Report` with ``least_distance``, ``clearance`` (that less the diameter), ``overlapping_pairs``, ``where``, ``itself``.

    >>> import nply
    >>> wires = [[[0, 0, 0], [0, 0, 9]], [[3, 0, 0], [3, 0, 9]]]
    >>> nply.clearance(wires, 2).clearance
    1.0
    """
    if diameter is None:
        diameters: list[Length] = []
    elif isinstance(diameter, str) or not isinstance(diameter, (Sequence, np.ndarray)):
        diameters = [diameter]
    else:
        diameters = list(diameter)
    return Report(_nply.clearance(_given(curves, closed, None, "tangents", unit, read_as, reverse), diameters))


def _given(
    curves: Curves,
    closed: bool | None,
    extend: Length | None,
    extend_along: str,
    unit: str | None,
    read_as: str | None,
    reverse: Sequence[str],
) -> dict[str, Any]:
    if _is_path(curves):
        files = [_file(curves)]
    elif isinstance(curves, (list, tuple)) and curves and (_is_path(curves[0]) or np.ndim(curves[0]) > 1):
        files = []
        for number, one in enumerate(curves, 1):
            files.append(_file(one) if _is_path(one) else _array(one, f"curve {number}"))
    else:
        files = [_array(curves, "curves")]
    return {
        "files": files,
        "read_as": read_as,
        "unit": unit,
        "closed": closed,
        "extend": extend,
        "extend_along": extend_along,
        "reverse": [reverse] if isinstance(reverse, str) else list(reverse),
    }


def _is_path(curves: object) -> bool:
    return isinstance(curves, (str, os.PathLike))


def _file(path: Any) -> tuple[str, bytes]:
    return os.fspath(path), Path(path).read_bytes()


def _array(curve: Any, name: str) -> tuple[str, bytes]:
    points = np.asarray(curve, dtype=np.float64)
    if points.ndim not in (2, 3) or points.shape[-1] != 3:
        raise ValueError(f"{name}: an array of shape (N, 3), or (K, N, 3) for several, is wanted, not {points.shape}")
    buffer = io.BytesIO()
    np.save(buffer, points)
    return f"{name}.npy", buffer.getvalue()
