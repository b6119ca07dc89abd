"""Studies: tables with a row for each set of data, and what is asked of its states beside them.

A study is a description of a ply with a ``[sweep]``: what varies, and what is asked. Any row can be worked out by itself, so that rows may be
shared out among threads, processes and machines: see :mod:`nply.dask`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Union

import numpy as np

from . import _nply
from .reports import Document
from .tables import Table

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .data import Data

Varying = Union[str, Sequence[str], Mapping[str, Any], None]

__all__ = ["Study", "solve_batch", "sweep"]


class Study:
    """What varies in a ply, and what is asked of its states.

    Args:
        document: the ply, see :mod:`nply.reports`; its ``[sweep]`` says what varies and what is asked, as the command's ``nply sweep`` reads it.
        sweep: what varies, instead: ``"pretwist=-1:1:1001"``, several such texts, or a dictionary:
            ``{"pretwist": np.linspace(-1, 1, 1001), "force": "0:2 kN:11", "strands": [2, 3, 6]}``; the last one varies fastest.
        order: ``"grid"`` (every combination) or ``"zip"`` (the first values together, then the second ones).
        sample: ``"sobol"`` or ``"latin"``: spread *points* sets of data over the ranges (given without a number of values).
        points, seed: how many, and what tells one sample from another.
        outputs: what is asked, by the names of ``solve(...).to_csv()``, with or without their unit.
        states: ``"all"``, ``"stable"`` alone, or the one ``"continued"`` from the neighbouring row.
        question: ``"contact"``, ``"states"`` or ``"supports"``; by what is given and asked, if absent.
        **data: single data.

    Raises:
        SpecError: the study is refused, with its place.

    A study can be pickled, and so sent to other processes.

    >>> import nply
    >>> study = nply.Study(strands=3, stiffness_ratio=0.75, sweep="pretwist=-1:0:3", outputs=["helical_angle"], states="stable")
    >>> len(study), study.columns
    (3, ['row', 'pretwist', 'state', 'helical_angle_deg', 'reason'])
    >>> study.solve(first=0, count=1)["helical_angle_deg"].round(3)
    array([30.613])
    """

    def __init__(
        self,
        document: Document | None = None,
        /,
        *,
        sweep: Varying = None,
        order: Literal["grid", "zip"] | None = None,
        sample: Literal["sobol", "latin"] | None = None,
        points: int | None = None,
        seed: int | None = None,
        outputs: str | Iterable[str] | None = None,
        states: Literal["all", "stable", "continued"] | None = None,
        question: Literal["contact", "states", "supports"] | None = None,
        **data: Unpack[Data],
    ) -> None:
        asked = {
            "sweep": _varying(sweep),
            "order": order,
            "sample": sample,
            "points": points,
            "seed": seed,
            "outputs": outputs.split(",") if isinstance(outputs, str) else list(outputs or ()),
            "states": states,
            "question": question,
        }
        self._study = _nply.study(document, dict(data), asked)

    def __len__(self) -> int:
        """How many sets of data it has (not states); 0 where rows are handed in."""
        return self._study.rows()

    @property
    def columns(self) -> list[str]:
        """The columns of its table: ``row``, what varies, ``state``, what is asked, ``reason``."""
        return self._study.names()

    @property
    def text(self) -> str:
        """The whole study as a document (TOML): two studies of one text have one table."""
        return self._study.text()

    def solve(self, first: int = 0, count: int | None = None) -> Table:
        """The answers to *count* sets of data from *first* on (all, if absent), in order, on all threads.

        Returns:
            :class:`Table`, one row a state; a set of data without any, or that no ply can be, has one row, with its sentence in ``reason``.
        """
        if first < 0 or (count is not None and count < 0):
            raise ValueError("first and count are whole numbers from 0 on")
        return Table(self._study.solve(first, len(self) if count is None else count))

    def batches(self, rows: int = 1 << 18) -> Iterator[Table]:
        """The same, *rows* sets of data at a time, so that memory stays flat however long the study is.

        >>> import nply
        >>> study = nply.Study(strands=3, stiffness_ratio=0.75, sweep="pretwist=-1:1:1000", outputs="helical_angle")
        >>> sum(len(set(batch["row"])) for batch in study.batches(rows=300))
        1000
        """
        if rows < 1:
            raise ValueError("rows is a whole number from 1 on")
        stretch = self._study.stretch()
        step = -(-rows // stretch) * stretch if rows > stretch else rows
        for first in range(0, len(self), step):
            yield self.solve(first, step)

    def solve_rows(self, rows: Any) -> Table:
        """The answers to rows that are handed in: see :func:`solve_batch`."""
        return Table(self._study.solve_rows(rows))

    def __reduce__(self) -> tuple[Any, ...]:
        return Study, (self.text,)

    def __repr__(self) -> str:
        return f"<study of {len(self)} rows>\n{self.text.rstrip()}"


def sweep(document: Document | Study | None = None, /, rows: Any = None, **asked: Any) -> Table:
    """A study worked out as a whole (``nply sweep``).

    Args:
        document: a :class:`Study`, or what one is made of.
        rows: a table whose rows are the data, instead of what varies in the study: anything with ``__arrow_c_stream__`` or
            ``__arrow_c_array__`` (pandas, polars, pyarrow, :class:`Table`); see :func:`solve_batch`.
        **asked: as for :class:`Study`.

    Returns:
        :class:`Table`, one row a state. For more rows than memory holds, take :meth:`Study.batches`.

    Raises:
        SpecError: the study is refused, with its place. A row that cannot be solved is no error: it has its sentence in ``reason``.

    >>> import nply
    >>> table = nply.sweep(strands=3, stiffness_ratio=0.75, sweep="pretwist=-1:1:3", outputs=["helical_angle", "interstrand_pressure"])
    >>> table["row"].tolist()
    [0, 0, 1, 1, 2, 2]
    """
    study = _study(document, asked)
    return study.solve() if rows is None else study.solve_rows(rows)


def solve_batch(batch: Any, study: Study | Document | None = None, /, **asked: Any) -> Table:
    """The answers to rows that are handed in: what a cluster's engine maps over its Arrow batches. No state is kept from call to call.

    Args:
        batch: a table with ``__arrow_c_array__`` or ``__arrow_c_stream__``, taken without a copy. A column is a datum by its name (``pretwist``,
            ``load.force``, ``lay_length_mm``), an empty cell one that is not given; other columns are handed on.
        study: a :class:`Study` without anything that varies, or what one is made of: what the rows have in common, and what is asked.
        **asked: as for :class:`Study`.

    Returns:
        :class:`Table`: the columns that were given, then ``state``, what is asked, and ``reason``, one row a state. A row without a state, or
        that no ply can be, stands once, with its sentence in ``reason``; none is lost.

    Raises:
        SpecError: no column is a datum, or one is not understood.

    >>> import numpy as np, nply
    >>> rows = nply.Table.of({"pretwist": np.array([-1.0, np.nan])})
    >>> answers = nply.solve_batch(rows, strands=3, stiffness_ratio=0.75, outputs="helical_angle", states="stable")
    >>> answers["helical_angle_deg"].round(3), [reason is None for reason in answers["reason"]]
    (array([30.613,    nan]), [True, False])
    """
    return _study(study, asked).solve_rows(batch)


def _study(document: Document | Study | None, asked: dict[str, Any]) -> Study:
    if isinstance(document, Study):
        if asked:
            raise TypeError(f"the study is made already: {', '.join(asked)} cannot be changed in it")
        return document
    return Study(document, **asked)


def _varying(sweep: Varying) -> list[str]:
    if sweep is None:
        return []
    if isinstance(sweep, str):
        return [sweep]
    if isinstance(sweep, Mapping):
        return [f"{name}={_values(values)}" for name, values in sweep.items()]
    return list(sweep)


def _values(values: Any) -> str:
    if isinstance(values, str):
        return values
    listed = values.tolist() if isinstance(values, np.ndarray) else list(values)
    return ",".join(value if isinstance(value, str) else repr(value) for value in listed)
