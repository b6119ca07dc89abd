"""Data that run: plots, maps, sweeps; and the paper's figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

from . import _nply
from .pictures import Picture
from .reports import Document
from .tables import Table

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .data import Data

__all__ = ["Map", "Plot", "figure", "figures", "map", "plot"]


class Plot(Picture):
    """Curves of every state while one datum runs: what :func:`plot` gives. A :class:`Picture`, with its numbers as ``csv``."""

    def __init__(self, plot: _nply.Plot) -> None:
        super().__init__(plot.svg, csv=plot.csv)
        self._plot = plot

    def to_text(self, width: int = 80, height: int = 24) -> str:
        """The picture in characters, for a terminal of so many."""
        return self._plot.text(width, height)

    def __repr__(self) -> str:
        return self.to_text()


def plot(
    document: Document | None = None,
    /,
    *,
    sweep: str,
    ask: str | Sequence[str],
    against: str | None = None,
    strands: int | Sequence[int] | None = None,
    balance: Literal["contact", "radial", "both"] | None = None,
    hand: Literal["right", "left", "Z", "S", "both"] | None = None,
    touching: bool = False,
    log_x: bool = False,
    log_y: bool = False,
    **data: Any,
) -> Plot:
    """Draws what is asked of every state while one datum runs: whole curves with their folds (``nply plot``).

    Args:
        document: the ply, see :mod:`nply.reports`.
        sweep: what runs, and from where to where: ``"pretwist=-3..3"``, ``"load.force=0..2 kN"``.
        ask: what is asked of each state, one name or several; columns of ``solve(...).to_csv()``, with or without their unit.
        against: what stands on the axis below, if not what runs.
        strands: one number of strands or several, if not that of the document.
        balance: which balance, or both.
        hand: which hand, Z for right and S for left; both if absent.
        touching: leave out the states on which neighbours would have to pull on each other.
        log_x, log_y: equal lengths for equal ratios.
        **data: single data.

    Returns:
        :class:`Plot`, which a notebook shows; ``.svg``, ``.png``, ``.csv``, ``.dark``, ``.save(path)``.

    Raises:
        SpecError: as :func:`nply.solve`; a datum that cannot run, a name that cannot be asked.

    >>> import nply
    >>> picture = nply.plot(strands=[2, 3], stiffness_ratio=0.75, sweep="pretwist=-3..3", ask="helical_angle")
    >>> picture.svg.startswith("<svg"), picture.csv.splitlines()[0].split(",")[0]
    (True, 'strands')
    """

    def several(words: Any) -> list[Any]:
        if words is None:
            return []
        return words.split(",") if isinstance(words, str) else list(words) if isinstance(words, Sequence) else [words]

    running = {
        "sweep": sweep,
        "ask": [name.strip() for name in several(ask)],
        "against": against,
        "strands": several(strands),
        "balances": several(balance),
        "hands": several(hand),
        "touching": touching,
        "log_x": log_x,
        "log_y": log_y,
    }
    return Plot(_nply.plot(document, dict(data), running))


class Map:
    """Every state over a rectangle of two data: what :func:`map` gives."""

    def __init__(self, table: Table, picture: Picture, summary: str) -> None:
        self.table = table
        """One row a state: :class:`Table`, which Arrow's libraries take as it is."""
        self.picture = picture
        """The map as a :class:`Picture`."""
        self._summary = summary

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        return self.table.__arrow_c_stream__(requested_schema)

    def __repr__(self) -> str:
        return self._summary.rstrip("\n")

    def _repr_svg_(self) -> str | None:
        return self.picture._repr_svg_()


def map(
    document: Document | None = None,
    /,
    *,
    from_: Mapping[str, Any] | None = None,
    to: Mapping[str, Any] | None = None,
    columns: int | None = None,
    rows: int | None = None,
    **data: Unpack[Data],
) -> Map:
    """Every state over a rectangle of two data, on all cores (``nply map``; see :func:`nply.set_jobs`).

    Args:
        document: the ply, see :mod:`nply.reports`; its ``[map]`` says the rectangle.
        from_, to: the rectangle's corners, instead: ``to={"force": 1, "moment": 2}``; the first runs across, the second up. What *from_* does not
            say begins at what the document says.
        columns, rows: points across and up; 200 if absent.
        **data: single data.

    Returns:
        :class:`Map` with ``table`` (docs/json.md has its columns) and ``picture``.

    Raises:
        SpecError: as :func:`nply.solve`; and unless exactly two data run.

    >>> import nply
    >>> found = nply.map(strands=3, stiffness_ratio=0.75, pretwist=-0.2, to={"force": 2, "moment": 3}, columns=4, rows=4)
    >>> found.table.columns[:3], len(found.table) >= 16
    (['force', 'moment', 'states'], True)
    """
    begin, end = (None if corner is None else dict(corner) for corner in (from_, to))
    batches, svg, summary = _nply.map(document, dict(data), begin, end, columns, rows)
    return Map(Table(batches), Picture(lambda _: svg), summary)


def figure(name: str | int) -> Picture:
    """A figure or table of Neukirch and van der Heijden's paper, worked out anew (``nply figure``).

    Args:
        name: 1 to 15, ``"table1"`` or ``"table2"``.

    Returns:
        :class:`Picture`, with the numbers drawn as ``csv``.

    Raises:
        KeyError: there is no such figure.

    >>> import nply
    >>> nply.figure(12).csv.splitlines()[0]
    'quantity,straight,let_go'
    """
    found = _nply.figure(str(name))
    return Picture(found.svg, csv=found.csv)


def figures() -> list[str]:
    """The names of the paper's figures and tables, for :func:`figure`."""
    return _nply.figures()
