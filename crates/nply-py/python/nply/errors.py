"""What can go wrong, in the sentences of the library and the command.

Every exception of the package is an :class:`NplyError`; those about data are a :class:`ValueError` too. Files that cannot be opened raise
Python's own :class:`OSError`.
"""

from __future__ import annotations

from typing import Any

__all__ = ["CurveError", "DomainError", "NplyError", "ReadError", "SpecError"]


class NplyError(Exception):
    """Whatever goes wrong in nply."""


class DomainError(NplyError, ValueError):
    """A quantity lies outside the range in which the theory speaks of it (``nply::DomainError``).

    Attributes:
        quantity: its public name, such as ``"helical_angle"``.
        value: what was given; dimensionless, angles in rad.
        allowed: what would have been accepted, as the end of "*quantity* must be ...".
        index: the element of the broadcast arrays it stands in; ``()`` for single numbers.

    >>> import nply
    >>> try:
    ...     nply.contact([3, 3], [0.5, 1.6])
    ... except nply.DomainError as error:
    ...     print(error.quantity, error.value, error.index)
    helical_angle 1.6 (1,)
    """

    quantity: str
    value: float
    allowed: str
    index: tuple[int, ...]

    def __init__(self, message: str, *, quantity: str, value: float, allowed: str, row: int | None = None) -> None:
        super().__init__(message)
        self.quantity = quantity
        self.value = value
        self.allowed = allowed
        self.index = ()
        self._row = row

    def __str__(self) -> str:
        place = f" (element {list(self.index)})" if self.index else ""
        return f"{self.args[0]}{place}"

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (type(self), self.args[0], self.__dict__)


class SpecError(NplyError, ValueError):
    """A document or an argument is refused: one sentence, its place, and what to do (``nply_sheet::SpecError``).

    Attributes:
        kind: ``"syntax"``, ``"unknown_key"``, ``"wrong_type"``, ``"wrong_unit"``, ``"missing"``, ``"contradiction"`` or ``"domain"`` (the
            last: understood, but no such ply can be).
        sentence: what is wrong, without its place.
        help: what to do, where the sentence does not say it; else None.
        key: the key of the document it is about, if there is one.
        argument: the keyword argument it is about, if it is about one.
        file, line, column: the place in a text or file, lines and columns counted from 1; None for dictionaries and arguments.
        rendered: several lines that show the place, as the command prints them.
        exit_code: what the command ends with: 1 for ``"domain"``, else 2.

    >>> import nply
    >>> try:
    ...     nply.solve({"ply": {"strand": 3}})
    ... except nply.SpecError as error:
    ...     print(error.kind, "-", error)
    unknown_key - `strand` is no key of [ply]; did you mean `strands`?
    """

    kind: str
    sentence: str
    help: str | None
    key: str | None
    argument: str | None
    file: str | None
    line: int | None
    column: int | None
    rendered: str
    exit_code: int

    def __init__(
        self,
        message: str,
        *,
        kind: str,
        sentence: str,
        help: str | None = None,
        key: str | None = None,
        argument: str | None = None,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        rendered: str = "",
        exit_code: int = 2,
    ) -> None:
        super().__init__(message)
        self.kind = kind
        self.sentence = sentence
        self.help = help
        self.key = key
        self.argument = argument
        self.file = file
        self.line = line
        self.column = column
        self.rendered = rendered
        self.exit_code = exit_code

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (type(self), self.args[0], self.__dict__)


class ReadError(NplyError, ValueError):
    """A file of curves is refused, in a sentence with its line or byte (``nply_sheet::curves::ReadError``).

    Attributes:
        line: the line, counted from 1; None where there are none.
    """

    line: int | None

    def __init__(self, message: str, *, line: int | None = None) -> None:
        super().__init__(message)
        self.line = line

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (type(self), self.args[0], self.__dict__)


class CurveError(NplyError, ValueError):
    """Curves are understood, and what is asked of them does not exist: segments that touch have no link (``nply::topology::CurveError``)."""


def _again(kind: type[NplyError], message: str, attributes: dict[str, Any]) -> NplyError:
    """An exception as it was, in another process."""
    error = kind.__new__(kind, message)
    error.__dict__.update(attributes)
    return error
