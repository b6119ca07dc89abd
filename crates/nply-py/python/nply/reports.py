"""One question each, as the commands of ``nply`` ask them: a document in, a report out.

A *document* is a dictionary nested as the TOML is, a text in TOML, or a path (a ``str`` without a line's end or ``=``, or a
``pathlib.Path``). Single data are keyword arguments, named as the command's flags with underscores; they replace what the document says.
Values are numbers, texts with a unit (``"0.5 mm"``), or quantities of pint.
"""

from __future__ import annotations

import html
import json
import os
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Union

from . import _nply
from .pictures import Picture

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .data import ConstructionData, Data

Document = Union[Mapping[str, Any], str, bytes, "os.PathLike[str]"]

__all__ = [
    "Document",
    "Record",
    "Report",
    "actuator",
    "fit_check",
    "lays",
    "locus",
    "preset",
    "presets",
    "shape",
    "solve",
    "spin",
    "stiffness",
    "support",
    "trace",
]


class Record(Mapping[str, Any]):
    """An object of a report: a mapping that is not changed, whose entries are attributes too."""

    __slots__ = ("_entries",)

    def __init__(self, entries: dict[str, Any]) -> None:
        self._entries = entries

    def __getitem__(self, name: str) -> Any:
        return self._entries[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._entries:
            raise AttributeError(f"there is no {name!r} here; there are {', '.join(self._entries)}")
        return self._entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._entries]

    def __repr__(self) -> str:
        return repr(self._entries)

    def __reduce__(self) -> tuple[Any, ...]:
        return Record, (self._entries,)


class Report:
    """An answer. Its attributes are the names of ``nply ... --json`` (docs/json.md): ``report.states[0].helical_angle_deg``.

    ``print(report)`` shows the command's table, and so does a notebook.
    """

    def __init__(self, answer: _nply.Answer) -> None:
        self._answer = answer
        self._json: str | None = None
        self._data: Record | None = None

    def to_json(self) -> str:
        """JSON, to the last byte what the command writes with ``--json``."""
        if self._json is None:
            self._json = self._answer.json()
        return self._json

    def to_dict(self) -> dict[str, Any]:
        """The same as plain dictionaries and lists (a new copy)."""
        found: dict[str, Any] = json.loads(self.to_json())
        return found

    def to_csv(self) -> str:
        """CSV, to the last byte what the command writes with ``--format csv``.

        Raises:
            AttributeError: this report has no such form.
        """
        csv = self._answer.csv()
        if csv is None:
            raise AttributeError("this report has no CSV")
        return csv

    @property
    def picture(self) -> Picture:
        """The report as a picture; :func:`trace` and :func:`locus` have one.

        Raises:
            AttributeError: this report has none.
        """
        if self._answer.svg() is None:
            raise AttributeError("this report has no picture")
        return Picture(lambda dark: self._answer.svg(dark) or "")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name == "picture":  # its own refusal ends here
            raise AttributeError("this report has no picture")
        if self._data is None:
            self._data = json.loads(self.to_json(), object_hook=Record)
        return getattr(self._data, name)

    def __getitem__(self, name: str) -> Any:
        try:
            return getattr(self, name)
        except AttributeError:
            raise KeyError(name) from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *json.loads(self.to_json())]

    def __repr__(self) -> str:
        return self._answer.text().rstrip("\n")

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.to_json(), repr(self), self._answer.csv(), self._answer.svg(), self._answer.svg(True))

    def _repr_html_(self) -> str:
        svg = self._answer.svg() or ""
        return f'{svg}<pre style="line-height: 1.2">{html.escape(repr(self))}</pre>'


class _Written:
    """An answer that has been written already, in another process."""

    def __init__(self, json: str, text: str, csv: str | None, svg: str | None, dark: str | None) -> None:
        self._forms = (json, text, csv, svg, dark)

    def json(self) -> str:
        return self._forms[0]

    def text(self) -> str:
        return self._forms[1]

    def csv(self) -> str | None:
        return self._forms[2]

    def svg(self, dark: bool = False) -> str | None:
        return self._forms[4 if dark else 3]


def _again(*forms: Any) -> Report:
    return Report(_Written(*forms))  # type: ignore[arg-type]


def solve(document: Document | None = None, /, **data: Unpack[Data]) -> Report:
    """Every state in which a ply is in equilibrium, of both hands (``nply solve``).

    Give the twist of the strands and the end loads (none: the balanced ply); or the lay and two of twist, force and moment, and the third is
    found; or the lay alone, and the pretwist that balances it is found; or ends that are held.

    Args:
        document: the ply, see :mod:`nply.reports`.
        **data: single data, such as ``strands=3, pretwist=-1, force="1.2 kN"``.

    Returns:
        :class:`Report` with ``states``, one object a state, right-handed first, then by angle; numbers are dimensionless (r = B = 1; angles
        ending in ``_deg`` in degrees), in SI units under ``si`` where the scale is known. An empty list where nothing is in equilibrium.

    Raises:
        SpecError: the document is refused, with its place; kind ``"domain"`` where no such ply can be.
        OSError: the file cannot be read.

    Source: Neukirch & van der Heijden, J. Elasticity 69 (2002) 41-72; see docs/json.md for every name.

    >>> import nply
    >>> report = nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-1)
    >>> round(report.states[0].helical_angle_deg, 4)
    30.613
    >>> nply.solve({"ply": {"strands": 2}, "strand": {"stiffness_ratio": 1}, "lay": {"helical_angle": "20 deg"}}).states[0].handedness
    1
    """
    return Report(_nply.solve(document, dict(data)))


def support(document: Document | None = None, /, **data: Unpack[Data]) -> Report:
    """What carries the strands in every state: neighbours, a core, both, or nothing (``nply support``).

    Args:
        document: the ply, see :mod:`nply.reports`; a core stands in its ``[support]``. With ``stretch = true`` strands stretch.
        **data: single data, such as ``support_core_radius=1``.

    Returns:
        :class:`Report` with ``states``, ``wedges``, ``openings_at_force`` and ``openings_at_moment``.

    Raises:
        SpecError: as :func:`solve`; and where the shape is given or the balance is radial.

    >>> import nply
    >>> report = nply.support(strands=2, stiffness_ratio=0.75, pretwist=-0.2, force=-0.3, moment=0.9)
    >>> [round(state.helical_angle_deg, 2) for state in report.states if state.support == "none"]
    [50.36]
    """
    return Report(_nply.support(document, dict(data)))


def shape(document: Document | None = None, /, *, branches: int = 0, **data: Unpack[Data]) -> Report:
    """Geometry alone: how strands touch at a lay (``nply contact``; :func:`contact` takes arrays).

    Args:
        document: number of strands, lay and size, see :mod:`nply.reports`. With ``strands=1`` and no lay, the densest helix of a tube.
        branches: list solutions of the contact condition too, nearest first, at most so many.
        **data: single data, such as ``strands=6, diameter="2 mm", lay_length="40 mm"``.

    Returns:
        :class:`Report` with helix radius, arclength shift, contact line, hole, curvature, in strand radii and, under ``si``, in SI units.

    Raises:
        SpecError: as :func:`solve`.

    >>> import nply
    >>> round(nply.shape(strands=6, helical_angle="20 deg").radius_ratio, 4)
    2.0998
    """
    return Report(_nply.shape(document, dict(data), branches))


def lays(document: Document | None = None, /, **data: Unpack[Data]) -> Report:
    """The distinguished lays of n strands: zero twist, most torsion, most curvature, close packed (``nply lays``).

    Args:
        document: anything with a number of strands.
        **data: ``strands=3``.

    Returns:
        :class:`Report` with ``lays``; see docs/json.md.

    >>> import nply
    >>> nply.lays(strands=2).strands
    2
    """
    return Report(_nply.lays(document, dict(data)))


def locus(document: Document | None = None, /, *, points: int | None = None, **data: Unpack[Data]) -> Report:
    """The loads at which touching strands just part (p = 0), both hands, from straight strands to flat rings (``nply locus``).

    Args:
        document: the ply, see :mod:`nply.reports`; only the twist of its strands is looked at.
        points: angles on each curve; 200 if absent.
        **data: single data.

    Returns:
        :class:`Report` with ``special_points`` and ``curves``, and a ``picture``.

    >>> import nply
    >>> report = nply.locus(strands=3, stiffness_ratio=0.75, pretwist=-1, points=50)
    >>> len(report.curves), len(report.curves[0].force)
    (2, 50)
    """
    return Report(_nply.locus(document, dict(data), points))


def spin(document: Document | None = None, /, **data: Unpack[Data]) -> Report:
    """Singles twist and ply twist in balance, for spinners and twisters (``nply spin``).

    Args:
        document: singles with size and twist, or a wanted lay, or both; see :mod:`nply.reports`.
        **data: single data, such as ``turns_per_length="8 tpi Z"`` or ``ply_turns_per_length="5 tpi S"``.

    Returns:
        :class:`Report` with ``plies`` and ``twist_ratios``.

    >>> import nply
    >>> report = nply.spin(strands=2, stiffness_ratio=1, diameter="0.5 mm", turns_per_length="8 tpi Z")
    >>> report.plies[0].handedness
    -1
    """
    return Report(_nply.spin(document, dict(data)))


def actuator(
    document: Document | None = None,
    /,
    *,
    steps: int | None = None,
    motor_turns: object | None = None,
    stroke: object | None = None,
    torque: object | None = None,
    tension: object | None = None,
    **data: Unpack[Data],
) -> Report:
    """Strings that a motor twists together under a load: stroke, torque, tension, greatest turns (``nply actuator``).

    Args:
        document: number, diameter, length and load, see :mod:`nply.reports`.
        steps: equal steps from no turns to the last; 10 if absent.
        motor_turns: how far the motor turns, another name of ``ply_turns``; the most that go in if absent.
        stroke, torque, tension: one of them in place of turns: how far the load comes, what the motor holds, the pull in each string.
        **data: single data, such as ``strand_length="0.5 m", force="20 N"``.

    Returns:
        :class:`Report` with ``steps`` and ``most_turns``, in SI units.

    >>> import nply
    >>> report = nply.actuator(strands=2, diameter="1 mm", strand_length="0.5 m", force="20 N")
    >>> len(report.steps)
    11
    >>> half = nply.actuator(strands=2, diameter="1 mm", strand_length="0.5 m", force="20 N", stroke="0.1 m")
    >>> round(half.steps[-1].motor_turns, 3)
    95.493
    """
    given = dict(data)
    if motor_turns is not None:
        given["ply_turns"] = motor_turns
    goals = [(name, goal) for name, goal in (("stroke", stroke), ("torque", torque), ("tension", tension)) if goal is not None]
    if len(goals) > 1:
        raise ValueError(f"{goals[0][0]} and {goals[1][0]} both say how far the motor turns: leave one of them out")
    return Report(_nply.actuator(document, given, steps, goals[0] if goals else None))


def trace(
    document: Document | None = None,
    /,
    *,
    to: Mapping[str, Any] | None = None,
    start: int | None = None,
    kept: bool = False,
    curvature_limit: float | None = None,
    strain_limit: float | None = None,
    **data: Unpack[Data],
) -> Report:
    """Follows a ply along a path, through folds and over contacts that open and close (``nply trace``).

    Args:
        document: the ply as it begins, see :mod:`nply.reports`; ``[[path]]`` in it has one table a leg.
        to: where the path leads, instead: ``{"force": "-20 kN"}``.
        start: the number of the state to start from, of those listed; the first stable one if absent.
        kept: keep neighbours together even where they would have to pull.
        curvature_limit: say where the bending strain of the outer fibre passes this.
        strain_limit: say where the strain of the outermost fibre passes this (strands that stretch).
        **data: single data.

    Returns:
        :class:`Report` with the stations and events of each leg, and a ``picture``.

    Raises:
        SpecError: as :func:`solve`; and where no path is given.

    >>> import nply
    >>> report = nply.trace(strands=3, stiffness_ratio=0.75, pretwist=-1, to={"force": -1})
    >>> len(report.legs)
    1
    """
    return Report(_nply.trace(document, dict(data), None if to is None else dict(to), start, kept, curvature_limit, strain_limit))


def fit_check(document: Document | None = None, /, **data: Unpack[ConstructionData]) -> Report:
    """Whether wires fit beside each other on a core, layer by layer, exactly and in three dimensions (``nply fit-check``).

    Args:
        document: the strand: ``[core]`` and one ``[[layer]]`` for each layer (in a dictionary, ``"layer"`` is a list).
        **data: single data, such as ``core_diameter=5.1, wire_diameter=5, strands=6, lay_length=210``; data of a layer may be lists, one value
            for each layer from the inside.

    Returns:
        :class:`Report` with ``layers``: gaps (negative: overlap), king wire, diameters, fill factor, mass.

    >>> import nply
    >>> nply.fit_check(core_diameter=5.1, wire_diameter=5, strands=6, lay_length=210).contact
    'core'
    """
    return Report(_nply.fit_check(document, dict(data)))


def stiffness(document: Document | None = None, /, **data: Unpack[ConstructionData]) -> Report:
    """What a strand or rope of layers carries, and how stiffly: EA, GJ, torque, stresses, load shares (``nply stiffness``).

    Args:
        document: the strand, as for :func:`fit_check`, with ``[load]``.
        **data: single data, such as ``force="100 kN"``.

    Returns:
        :class:`Report` with the stiffnesses, ``core`` and ``layers``; in SI units where the input has units.

    >>> import nply
    >>> report = nply.stiffness(nply.preset("rope-6x7"), force="10 kN")
    >>> report.axial_stiffness_N > report.axial_stiffness_free_N
    True
    """
    return Report(_nply.stiffness(document, dict(data)))


def presets() -> Report:
    """Published plies and strands that come with the package (``nply preset``).

    Returns:
        :class:`Report` with ``presets``: ``name``, ``about``, ``source``, ``command``.

    >>> import nply
    >>> [preset.name for preset in nply.presets().presets if "DNA" in preset.about]
    ['dna-plectoneme', 'dna-braid']
    """
    return Report(_nply.presets())


def preset(name: str) -> str:
    """A published ply or strand as a document (TOML, with the source of its numbers), to be solved or changed.

    Args:
        name: one of those that :func:`presets` lists.

    Raises:
        KeyError: there is none of this name.

    >>> import nply
    >>> nply.shape(nply.preset("collagen")).strands
    3
    """
    return _nply.preset(name)
