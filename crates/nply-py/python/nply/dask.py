"""Studies past one machine: :func:`sweep` hands the rows of a Dask data frame, or of Parquet files, to the workers of a cluster.

There is no engine here: Dask shares out the work, takes it up again where a worker dies, and writes the result. Any other engine that maps
Arrow batches (Ray, Spark's ``mapInArrow``) calls :func:`nply.solve_batch` in the same way. Needs ``pip install nply[dask]``.

One core solves millions of plies a second: a cluster is worth its trouble where rows are read from and written to more disks than one machine
has, or where each row is a question that takes long (supports, strands that stretch).
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Union

from .sweeps import Study

if TYPE_CHECKING:
    import dask.dataframe
    import pandas

Frame = Union["dask.dataframe.DataFrame", "pandas.DataFrame", str, "os.PathLike[str]"]

__all__ = ["solve_frame", "sweep"]


def solve_frame(frame: pandas.DataFrame, study: str) -> pandas.DataFrame:
    """The answers to the rows of one pandas data frame, on one thread: what a worker does with a partition.

    Args:
        frame: the rows; see :func:`nply.solve_batch`.
        study: the study's text (:attr:`nply.Study.text`).
    """
    import pyarrow

    import nply

    nply.set_jobs(1)  # the cluster's workers are the threads
    batch = pyarrow.Table.from_pandas(frame, preserve_index=False)
    answers: pandas.DataFrame = nply.Study(study).solve_rows(batch).to_pandas()
    return answers


def sweep(rows: Frame, study: Study, *, client: Any = None) -> dask.dataframe.DataFrame:
    """The answers to rows, partition by partition, as a Dask data frame that is not worked out yet.

    Args:
        rows: a Dask data frame, a pandas one, or where Parquet files are (``"rows/*.parquet"``; better than a data frame of the driver's, which
            travels with the task graph). Its columns are data by their names; see :func:`nply.solve_batch`.
        study: what the rows have in common, and what is asked.
        client: a ``distributed.Client`` whose workers do it; else Dask's default. With one, the result's tasks are started at once and kept by
            the cluster; a worker that dies loses nothing: its partitions are worked out again.

    Returns:
        A Dask data frame: ``.to_parquet(folder)`` writes it, ``.compute()`` gathers it. Partitions and rows are in the order of *rows*, each
        repeated once for each of its states.
    """
    import dask.dataframe as dd
    import pandas

    if isinstance(rows, (str, os.PathLike)):
        frame = dd.read_parquet(os.fspath(rows))
    elif isinstance(rows, pandas.DataFrame):
        frame = dd.from_pandas(rows, npartitions=max(1, len(rows) // (1 << 17)))
    else:
        frame = rows
    text = study.text
    meta = solve_frame(frame._meta_nonempty.iloc[:0], text)
    answers: dask.dataframe.DataFrame = frame.clear_divisions().map_partitions(solve_frame, text, meta=meta, enforce_metadata=False)
    if client is not None:
        answers = client.persist(answers)
    return answers
