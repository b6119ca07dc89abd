"""Numbers of the strands from measurements."""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from . import _nply
from .reports import Document, Report
from .tables import Table

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .data import Data

Measurements = Union[str, "os.PathLike[str]", Mapping[str, Any], Any]

__all__ = ["Measurements", "fit"]


def fit(
    measurements: Measurements,
    document: Document | None = None,
    /,
    *,
    estimate: str | Iterable[str],
    measured: str | Iterable[str] = (),
    held: str | Iterable[str] = (),
    errors: Mapping[str, str | float] | None = None,
    starts: int | None = None,
    **data: Unpack[Data],
) -> Report:
    """Estimates numbers of the strands from measurements, by least squares with the errors of the data (``nply fit``).

    Args:
        measurements: a table whose columns are loads and shapes, with ``..._error`` beside what is measured: a path to CSV, CSV text (more than one
            line), a dictionary of columns, or anything with ``__arrow_c_stream__``. A unit stands behind a column's name (``"force [N]"``,
            ``"lay_length_mm"``) or is the column's own; an empty cell or NaN is not known.
        document: the ply, see :mod:`nply.reports`; what is estimated stands there too, as a rough value to start from.
        estimate: what is estimated: ``"stiffness_ratio"``, ``"bending_stiffness"``, ``"diameter"``, ``"pretwist"``, ...
        measured, held: columns that are measured though no errors are given, and held though some are.
        errors: standard errors of columns in every row: ``{"lay_length": "0.1 mm", "force": "2%"}``; or of an estimate's start that was
            measured too: ``{"diameter": "0.01 mm"}``.
        starts: starts of the search, the given one and others about it; 12 if absent.
        **data: single data.

    Returns:
        :class:`Report` with ``estimates`` (values and standard errors), ``correlation`` and ``rows`` with their residuals; ``to_csv()`` has every residual, and
        ``picture`` draws them.

    Raises:
        SpecError: the ply or the measurements are refused, with the place; kind ``"domain"`` where the data do not determine what is asked.

    >>> import numpy as np, nply
    >>> twist = np.linspace(-1.5, -0.5, 9)
    >>> angle = np.degrees([nply.equilibria(3, 0.8, pretwist=t).row().helical_angle[0] for t in twist])
    >>> table = {"pretwist": twist, "helical_angle [deg]": angle, "helical_angle_error [deg]": np.full(9, 0.01)}
    >>> report = nply.fit(table, strands=3, stiffness_ratio=1, estimate="stiffness_ratio")
    >>> round(report.estimates[0].value, 6)
    0.8
    """

    def several(words: str | Iterable[str]) -> list[str]:
        return [word.strip() for word in words.split(",")] if isinstance(words, str) else list(words)

    name, content = _read(measurements)
    estimating = {
        "name": name,
        "measurements": content,
        "estimate": several(estimate),
        "measured": several(measured),
        "held": several(held),
        "errors": [f"{column}={error}" for column, error in (errors or {}).items()],
        "starts": starts,
    }
    return Report(_nply.fit(document, dict(data), estimating))


def _read(measurements: Measurements) -> tuple[str, bytes]:
    if isinstance(measurements, str) and "\n" in measurements:
        return "measurements", measurements.encode()
    if isinstance(measurements, (str, os.PathLike)):
        return os.fspath(measurements), Path(measurements).read_bytes()
    if isinstance(measurements, Mapping):
        columns = {name: _cells(column) for name, column in measurements.items()}
    else:
        table = Table.read(measurements)
        columns = {}
        for column in table.columns:
            unit = table.unit(column)
            columns[f"{column} [{unit}]" if unit else column] = _cells(table[column])
    lengths = {len(cells) for cells in columns.values()}
    if len(lengths) != 1:
        raise ValueError("measurements: columns of one length are wanted")
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*columns.values(), strict=True))
    return "measurements", out.getvalue().encode()


def _cells(column: Any) -> list[str]:
    values = np.asarray(column).tolist() if not isinstance(column, (list, tuple)) else column
    return ["" if value is None or (isinstance(value, float) and math.isnan(value)) else str(value) for value in values]
