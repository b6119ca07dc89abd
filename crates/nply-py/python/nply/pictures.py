"""Pictures, as SVG or PNG, shown by a notebook as they are."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from . import _nply

__all__ = ["Picture"]


class Picture:
    """A picture: a drawing (SVG, and PNG made of it), or a rendered one (PNG alone).

    A notebook shows it; :meth:`save` writes it to a file. Nothing is drawn before it is asked for.
    """

    def __init__(
        self,
        draw: Callable[[bool], str] | None = None,
        *,
        png: bytes | None = None,
        csv: Callable[[], str] | None = None,
        dark: bool = False,
    ) -> None:
        self._draw = draw
        self._png = png
        self._csv = csv
        self._dark = dark
        self._svg: str | None = None

    @property
    def svg(self) -> str:
        """The picture as SVG text.

        Raises:
            AttributeError: it is a rendered one, which has PNG alone.
        """
        if self._draw is None:
            raise AttributeError("a rendered picture has no SVG: take .png")
        if self._svg is None:
            self._svg = self._draw(self._dark)
        return self._svg

    @property
    def png(self) -> bytes:
        """The picture as PNG, two pixels to one of the SVG; :meth:`to_png` takes other sizes."""
        return self.to_png()

    @property
    def csv(self) -> str:
        """The numbers that are drawn, as CSV.

        Raises:
            AttributeError: it has none beside it.
        """
        if self._csv is None:
            raise AttributeError("this picture has no numbers beside it")
        return self._csv()

    def to_png(self, zoom: float = 2.0) -> bytes:
        """The picture as PNG, *zoom* pixels (0.1 to 20) to one of the SVG; a rendered picture is as large as it was asked for."""
        if self._png is not None:
            return self._png
        if not 0.1 <= zoom <= 20.0:
            raise ValueError(f"pictures are drawn 0.1 to 20 times as large, not {zoom}")
        return _nply.rasterise(self.svg, zoom)

    @property
    def dark(self) -> Picture:
        """The same on dark ground."""
        return self if self._draw is None else Picture(self._draw, csv=self._csv, dark=True)

    def save(self, path: str | os.PathLike[str], *, zoom: float = 2.0) -> None:
        """Writes it to a file: SVG, PNG, or the numbers as CSV, by the end of its name. The file gets its name when it is whole.

        Raises:
            ValueError: the name ends in something else.
            OSError: the file cannot be written.
        """
        ending = Path(path).suffix.lower()
        if ending == ".svg":
            content = self.svg.encode()
        elif ending == ".png":
            content = self.to_png(zoom)
        elif ending == ".csv" and self._csv is not None:
            content = self.csv.encode()
        else:
            raise ValueError(f"pictures are SVG or PNG, by the end of the file's name: {os.fspath(path)} is neither")
        write_whole(path, content)

    def __repr__(self) -> str:
        return "<rendered picture>" if self._draw is None else "<picture>"

    def _repr_svg_(self) -> str | None:
        return None if self._draw is None else self.svg

    def _repr_png_(self) -> bytes | None:
        return self._png


def write_whole(path: str | os.PathLike[str], content: bytes) -> None:
    """Writes a file beside its place and gives it its name when it is whole."""
    target = Path(path)
    if target.exists() and not target.is_file():
        target.write_bytes(content)  # a pipe, a device
        return
    target = target.resolve()
    draft = target.with_name(f"{target.name}.{os.getpid()}.part")
    try:
        draft.write_bytes(content)
        os.replace(draft, target)
    except BaseException:
        draft.unlink(missing_ok=True)
        raise
