"""Tables: columns of numbers that any library of Arrow takes without a copy."""

from __future__ import annotations

import html
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _nply

if TYPE_CHECKING:
    import pandas
    import pyarrow

__all__ = ["Table"]


class Table:
    """A table of columns, each with its name and unit.

    Polars, pyarrow, pandas, DuckDB and whatever else speaks Arrow's C data interface take it as it is: ``polars.DataFrame(table)``,
    ``pyarrow.table(table)``. Without any of them, ``table["force"]`` is an array of NumPy's.

    >>> import nply
    >>> table = nply.Table.read(nply.equilibria(3, 0.75, pretwist=-1.0))
    >>> table.columns, len(table)
    (['row', 'handedness', 'helical_angle', 'pitch_angle', 'fold'], 2)
    >>> table["handedness"]
    array([ 1, -1])
    >>> table.unit("helical_angle")
    'rad'
    """

    __slots__ = ("_batches",)

    def __init__(self, batches: _nply.Batches) -> None:
        self._batches = batches

    @classmethod
    def of(cls, columns: Mapping[str, Any], *, units: Mapping[str, str] | None = None) -> Table:
        """A table of flat arrays of float64, int64 or bool, all of one length (copied)."""
        return cls(_nply.Batches.of(dict(columns), dict(units or {})))

    @classmethod
    def read(cls, table: Any) -> Table:
        """A table of whatever has ``__arrow_c_stream__`` or ``__arrow_c_array__``, without a copy.

        Raises:
            TypeError: it has neither.
        """
        return cls(_nply.Batches.read(table))

    @property
    def columns(self) -> list[str]:
        """The columns' names."""
        return self._batches.names()

    @property
    def metadata(self) -> dict[str, str]:
        """What the table says of itself: program, version, study, balance."""
        return self._batches.metadata()

    def unit(self, column: str) -> str | None:
        """The unit of a column's numbers; None for plain numbers and for what is no number."""
        return self._batches.unit(column)

    def __getitem__(self, column: str) -> Any:
        """A column: an array of NumPy's (NaN for an empty cell), or a list where it holds texts, or empty cells among integers or truths."""
        return self._batches.column(column)

    def __contains__(self, column: object) -> bool:
        return column in self.columns

    def __len__(self) -> int:
        return len(self._batches)

    def to_dict(self) -> dict[str, Any]:
        """Every column by its name, as ``table[name]`` gives it."""
        return {name: self[name] for name in self.columns}

    def to_arrow(self) -> pyarrow.Table:
        """As pyarrow's table, without a copy (needs pyarrow)."""
        import pyarrow

        return pyarrow.table(self)

    def to_pandas(self) -> pandas.DataFrame:
        """As a data frame of pandas (needs pandas and pyarrow)."""
        return self.to_arrow().to_pandas()

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        return self._batches.__arrow_c_stream__(requested_schema)

    def __repr__(self) -> str:
        return f"<table of {len(self)} rows: {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        most = 10
        rows = min(len(self), most)
        columns = [list(self[name][:rows]) for name in self.columns]

        def cell(value: Any) -> str:
            text = f"{value:.6g}" if isinstance(value, float) else "" if value is None else str(value)
            return f"<td>{html.escape(text)}</td>"

        def head(name: str) -> str:
            unit = self.unit(name)
            return f"<th>{html.escape(name)}{f' ({html.escape(unit)})' if unit else ''}</th>"

        body = "".join(f"<tr>{''.join(cell(column[row]) for column in columns)}</tr>" for row in range(rows))
        more = f"<p>{len(self)} rows</p>" if len(self) > most else ""
        return f"<table><thead><tr>{''.join(head(name) for name in self.columns)}</tr></thead><tbody>{body}</tbody></table>{more}"
