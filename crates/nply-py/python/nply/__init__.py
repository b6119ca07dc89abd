"""Geometry and mechanics of ropes, yarns, cords, DNA: n elastic strands coiled round each other, touching.

Arrays
    :func:`contact`, :func:`equilibria` take and give NumPy's, with broadcasting.
One ply
    :func:`solve`, :func:`support`, :func:`trace`, :func:`locus`, :func:`shape`, :func:`lays`, :func:`spin`, :func:`actuator`; documents with
    their sources: :func:`preset`, :func:`presets`.
Strands and ropes of layers
    :func:`fit_check`, :func:`stiffness`.
Measurements
    :func:`fit`.
Studies
    :func:`plot`, :func:`map`, :func:`sweep` with :class:`Study`, :func:`solve_batch` and :mod:`nply.dask`; and the paper's :func:`figure`.
Shapes
    :func:`mesh`, :func:`centrelines`, :func:`nodes`, :func:`render`.
Curves
    :func:`writhe`, :func:`twist`, :func:`link`, :func:`clearance`.

Angles in arrays are in rad; positive is right-handed (Z); without units r = B = 1. After Neukirch & van der Heijden, J. Elasticity 69 (2002) 41-72.
"""

from __future__ import annotations

from ._nply import __version__, jobs, set_jobs
from .arrays import Contacts, Equilibria, Refusals, States, contact, equilibria
from .curves import clearance, link, twist, writhe
from .errors import CurveError, DomainError, NplyError, ReadError, SpecError
from .fits import fit
from .pictures import Picture
from .reports import (
    Record,
    Report,
    actuator,
    fit_check,
    lays,
    locus,
    preset,
    presets,
    shape,
    solve,
    spin,
    stiffness,
    support,
    trace,
)
from .shapes import Centreline, Centrelines, Mesh, Nodes, centrelines, mesh, nodes, render
from .studies import Map, Plot, figure, figures, map, plot
from .sweeps import Study, solve_batch, sweep
from .tables import Table

__all__ = [
    "Centreline",
    "Centrelines",
    "Contacts",
    "CurveError",
    "DomainError",
    "Equilibria",
    "Map",
    "Mesh",
    "Nodes",
    "NplyError",
    "Picture",
    "Plot",
    "ReadError",
    "Record",
    "Refusals",
    "Report",
    "SpecError",
    "States",
    "Study",
    "Table",
    "__version__",
    "actuator",
    "centrelines",
    "clearance",
    "contact",
    "equilibria",
    "figure",
    "figures",
    "fit",
    "fit_check",
    "jobs",
    "lays",
    "link",
    "locus",
    "map",
    "mesh",
    "nodes",
    "plot",
    "preset",
    "presets",
    "render",
    "set_jobs",
    "shape",
    "solve",
    "solve_batch",
    "spin",
    "stiffness",
    "support",
    "sweep",
    "trace",
    "twist",
    "writhe",
]
