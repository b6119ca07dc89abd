"""Arrays of plies: geometry of contact, and all states of equilibrium."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

import numpy as np

from . import _nply
from .errors import DomainError
from .tables import Table

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]

__all__ = ["Contacts", "Equilibria", "Refusals", "States", "contact", "equilibria"]


class Refusals(Sequence[DomainError]):
    """The elements of an array that the theory refuses, in order, each as the exception it would raise.

    Empty, and false, where none is refused.
    """

    def __init__(self, refused: _nply.Refusals, shape: tuple[int, ...]) -> None:
        self._refused = refused
        self._shape = shape

    def __len__(self) -> int:
        return len(self._refused)

    @overload
    def __getitem__(self, place: int) -> DomainError: ...
    @overload
    def __getitem__(self, place: slice) -> list[DomainError]: ...
    def __getitem__(self, place: int | slice) -> DomainError | list[DomainError]:
        if isinstance(place, slice):
            return [self[i] for i in range(*place.indices(len(self)))]
        error = self._refused.error(range(len(self))[place])
        row: int = error._row  # type: ignore[assignment]
        error.index = tuple(int(i) for i in np.unravel_index(row, self._shape)) if self._shape else ()
        return error

    @property
    def rows(self) -> NDArray[np.int64]:
        """Which elements, by their place in the flat array (int64)."""
        return np.asarray(self._refused.rows(), dtype=np.int64)

    def __repr__(self) -> str:
        return f"<{len(self)} refused{': ' + str(self[0]) if self else ''}>"


@dataclass(frozen=True)
class Contacts:
    """How neighbouring strands touch: what :func:`contact` gives. Unpacks as ``shift, radius = nply.contact(...)``."""

    arclength_shift: Any
    """x, (6): by how much the touching points of neighbours are shifted along their centrelines, over the helix radius; >= 0."""
    radius_ratio: Any
    """rho = R/r, (4): helix radius of the centrelines over strand radius; >= 1."""
    refused: Refusals
    """The elements that are NaN, and why; empty unless ``errors="nan"``."""

    def __iter__(self) -> Iterator[Any]:
        return iter((self.arclength_shift, self.radius_ratio))

    def to_dict(self) -> dict[str, Any]:
        """Both arrays by their names."""
        return {"arclength_shift": self.arclength_shift, "radius_ratio": self.radius_ratio}


class States(NamedTuple):
    """The states of one ply; right-handed first, then by angle."""

    handedness: NDArray[np.int8]
    """1 right-handed (Z), -1 left-handed (S)."""
    helical_angle: Floats
    """theta in rad, in (0, pi/2)."""
    pitch_angle: Floats
    """pi/2 - theta in rad, with its own digits."""
    fold: NDArray[np.bool_]
    """Whether two states have met here, to within rounding."""


@dataclass(frozen=True)
class Equilibria:
    """Every state of every ply of an array: what :func:`equilibria` gives.

    The states of all plies stand one behind the other; those of ply *i* (by its place in the flat array) from ``offsets[i]`` to
    ``offsets[i + 1]``, right-handed first, then by angle.
    """

    shape: tuple[int, ...]
    """The shape of the broadcast arguments; ``()`` for single numbers."""
    offsets: NDArray[np.int64]
    """Where each ply's states begin, and where the last ones end (int64, one more than there are plies)."""
    handedness: NDArray[np.int8]
    """1 right-handed (Z), -1 left-handed (S), of every state."""
    helical_angle: Floats
    """theta of every state in rad, in (0, pi/2)."""
    pitch_angle: Floats
    """pi/2 - theta of every state in rad, with its own digits."""
    fold: NDArray[np.bool_]
    """Whether a state is a limit point: two states that have met, to within rounding."""
    refused: Refusals
    """The plies without states because their data are outside the theory, and why; empty unless ``errors="nan"``."""

    def row(self, place: int | tuple[int, ...] = 0) -> States:
        """The states of one ply, by its place in the flat array or by its index (views, no copies).

        >>> import nply
        >>> found = nply.equilibria(3, 0.75, pretwist=[[-1.0, 1.0]])
        >>> found.row((0, 1)).handedness
        array([ 1, -1], dtype=int8)
        """
        rows = len(self.offsets) - 1
        if isinstance(place, tuple):
            row = int(np.ravel_multi_index(tuple(range(n)[i] for i, n in zip(place, self.shape, strict=True)), self.shape)) if place else 0
        else:
            row = range(rows)[place]
        here = slice(int(self.offsets[row]), int(self.offsets[row + 1]))
        return States(self.handedness[here], self.helical_angle[here], self.pitch_angle[here], self.fold[here])

    def __len__(self) -> int:
        """How many states there are in all."""
        return len(self.helical_angle)

    @property
    def count(self) -> NDArray[np.int64]:
        """How many states each ply has (int64, of the broadcast shape)."""
        return np.diff(self.offsets).reshape(self.shape)

    @property
    def rows(self) -> NDArray[np.int64]:
        """Whose each state is: the place of its ply in the flat array (int64, one for each state)."""
        return np.repeat(np.arange(len(self.offsets) - 1, dtype=np.int64), np.diff(self.offsets))

    def to_dict(self) -> dict[str, Any]:
        """One array for each column, a row a state: ``row``, ``handedness``, ``helical_angle``, ``pitch_angle``, ``fold``."""
        return {
            "row": self.rows,
            "handedness": self.handedness,
            "helical_angle": self.helical_angle,
            "pitch_angle": self.pitch_angle,
            "fold": self.fold,
        }

    def to_table(self) -> Table:
        """The same as a table of Arrow (a copy), angles with their unit."""
        columns = {**self.to_dict(), "handedness": self.handedness.astype(np.int64)}
        return Table.of(columns, units={"helical_angle": "rad", "pitch_angle": "rad"})

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        return self.to_table().__arrow_c_stream__(requested_schema)

    def __repr__(self) -> str:
        plies = len(self.offsets) - 1
        return f"<{len(self)} states of {plies} {'ply' if plies == 1 else 'plies'}>"


def contact(strands: ArrayLike, helical_angle: ArrayLike, *, errors: Literal["raise", "nan"] = "raise") -> Contacts:
    """How neighbouring strands touch at a helical angle, (4)-(6).

    Args:
        strands: n, whole numbers >= 2.
        helical_angle: theta in rad, in [0, pi/2): 0 straight strands, towards pi/2 flat rings.
        errors: what to do with elements outside of these ranges, NaN among them: ``"raise"`` a :class:`DomainError` that names the first, or
            ``"nan"``: give NaN there, and the reasons in ``refused``.

    Returns:
        :class:`Contacts`: ``arclength_shift`` and ``radius_ratio``, float64 arrays of the broadcast shape, or floats where both arguments are
        single numbers. Exact to 4 units in the last place; the last digits may depend on the processor (fused multiply-add).

    Raises:
        DomainError: an element outside the theory, unless ``errors="nan"``.
        TypeError: strands that are no whole numbers.

    Source: Neukirch & van der Heijden, J. Elasticity 69 (2002) 41-72, section 2, exact where neighbours touch at different heights.

    >>> import numpy as np, nply
    >>> shift, radius = nply.contact(6, np.radians(20))       # the paper's Figure 11
    >>> round(radius, 4)
    2.0998
    >>> nply.contact([2, 3, 6], [[0.2], [0.4]]).radius_ratio.shape
    (2, 3)
    >>> nply.contact(3, [0.5, np.nan], errors="nan").refused[0].index
    (1,)
    """
    _check_errors(errors)
    n, theta = _whole("strands", strands), np.asarray(helical_angle, dtype=np.float64)
    shape = np.broadcast_shapes(n.shape, theta.shape)
    shift, radius, rows = _nply.contact(_size(shape), _flat(n, shape), _flat(theta, shape))
    refused = Refusals(rows, shape)
    if refused and errors == "raise":
        raise refused[0]
    if not shape:
        return Contacts(float(shift[0]), float(radius[0]), refused)
    return Contacts(shift.reshape(shape), radius.reshape(shape), refused)


def equilibria(
    strands: ArrayLike,
    stiffness_ratio: ArrayLike,
    *,
    pretwist: ArrayLike | None = None,
    strand_twist: ArrayLike | None = None,
    force: ArrayLike = 0.0,
    moment: ArrayLike = 0.0,
    balance: Literal["contact", "radial"] = "contact",
    errors: Literal["raise", "nan"] = "raise",
) -> Equilibria:
    """Every state of equilibrium of every ply, both hands, none missed. All data are dimensionless (r = B = 1) and broadcast.

    Args:
        strands: n, whole numbers >= 2.
        stiffness_ratio: gamma = C/B > 0, torsional over bending stiffness of a strand.
        pretwist: tan of the angle of surface lines on the strands before they were plied, positive right-handed, (46). Give this
        strand_twist: or the strands' twist r u3 as it is in the ply, (22); just one of the two.
        force: f = r^2 F/B along the ply's axis, on the whole ply, tension positive.
        moment: m = r M/B about the axis, on the whole ply, positive right-handed.
        balance: ``"contact"``, the stationary point of the energy; or ``"radial"``, the paper as published.
        errors: ``"raise"`` a :class:`DomainError` for the first ply outside the theory, or ``"nan"``: leave it without states, and the reason in
            ``refused``.

    Returns:
        :class:`Equilibria`: the states of all plies with offsets. A ply in no equilibrium has none; separated states, whose neighbours would
        have to pull, are among them. Angles are exact to 1e-12 rad.

    Raises:
        DomainError: an element outside the theory, unless ``errors="nan"``.
        TypeError: strands that are no whole numbers; both twists given, or none.

    Source: Neukirch & van der Heijden, J. Elasticity 69 (2002) 41-72, section 5; contact balance: docs/errata.md of nply.

    >>> import numpy as np, nply
    >>> found = nply.equilibria(3, 0.75, pretwist=-1.0)
    >>> np.degrees(found.row().helical_angle[0]).round(4)     # simulated in three dimensions: 30.6130
    np.float64(30.613)
    >>> nply.equilibria([2, 3, 6], 0.75, pretwist=[[-1.0], [1.0]]).count
    array([[3, 2, 2],
           [3, 2, 2]])
    """
    _check_errors(errors)
    given = [(name, twist) for name, twist in [("pretwist", pretwist), ("strand_twist", strand_twist)] if twist is not None]
    if len(given) != 1:
        raise TypeError("give the strands' twist: either pretwist or strand_twist")
    [(name, twist)] = given
    n = _whole("strands", strands)
    reals = [np.asarray(data, dtype=np.float64) for data in (stiffness_ratio, twist, force, moment)]
    shape = np.broadcast_shapes(n.shape, *(data.shape for data in reals))
    gamma, t, f, m = (_flat(data, shape) for data in reals)
    offsets, handedness, theta, pitch, fold, rows = _nply.equilibria(
        _size(shape), _flat(n, shape), gamma, t, name == "strand_twist", f, m, balance
    )
    refused = Refusals(rows, shape)
    if refused and errors == "raise":
        raise refused[0]
    return Equilibria(shape, offsets, handedness, theta, pitch, fold, refused)


def _check_errors(errors: str) -> None:
    if errors not in ("raise", "nan"):
        raise ValueError(f'errors is "raise" or "nan", not {errors!r}')


def _whole(name: str, numbers: ArrayLike) -> NDArray[np.int64]:
    given = np.asarray(numbers)
    if given.dtype == np.int64:
        return given
    if given.dtype.kind in "iu":
        # beyond 2^63 there is no ply either
        return np.minimum(given, np.iinfo(np.int64).max).astype(np.int64) if given.dtype == np.uint64 else given.astype(np.int64)
    if given.dtype.kind == "f" or given.size == 0:
        whole = np.isfinite(given) & (np.abs(given) < 2.0**53)
        whole &= np.floor(given) == given
        if np.all(whole):
            return given.astype(np.int64)
        raise TypeError(f"{name}: whole numbers are wanted; {given[~whole].flat[0]} is none")
    raise TypeError(f"{name}: whole numbers are wanted, not {given.dtype}")


def _size(shape: tuple[int, ...]) -> int:
    size = 1
    for n in shape:
        size *= n
    return size


def _flat(array: NDArray[Any], shape: tuple[int, ...]) -> NDArray[Any]:
    """One row behind the other, contiguous; a single number stays one."""
    if array.size == 1:
        return np.ascontiguousarray(array).reshape(1)
    full = array if array.shape == shape else np.broadcast_to(array, shape)
    return np.ascontiguousarray(full).reshape(-1)
