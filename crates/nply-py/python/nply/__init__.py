"""Geometry and mechanics of ropes, yarns, cords, DNA: n elastic strands coiled round each other."""

from __future__ import annotations

from ._nply import __version__, jobs, set_jobs
from .arrays import Contacts, Equilibria, Refusals, States, contact, equilibria
from .errors import CurveError, DomainError, NplyError, ReadError, SpecError
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
from .tables import Table
