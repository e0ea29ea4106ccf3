"""Options of pictures, pages in notebooks, and files that appear whole."""

from __future__ import annotations

import html
import os
import tempfile
from typing import Any, Iterable

from . import _cnrg
from .errors import FileError


class View:
    """A page for browsers, which a notebook shows in a frame."""

    def __init__(self, text: str, height: int):
        self.text = text
        """the page, in HTML"""
        self.height = height
        """of the frame, in pixels"""

    def __repr__(self) -> str:
        return f"<cnrg.View: {len(self.text) // 1024} KB>"

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.text)}" style="width: 100%; height: {self.height}px; '
                'border: 1px solid #ccc" sandbox="allow-scripts allow-downloads"></iframe>')


def _text(number: Any) -> str:
    """A number in an option: exact."""
    return _cnrg.number_text(number)


def options_of(camera: Any, cut: Any, explode: Any, opacity: Any, ghosts: bool, color_by: str | None,
                     labels: str | Iterable[str], caption: str | None, size: Any) -> list[tuple[str, str]]:
    """As on the command line, whose rules hold: the library reads them."""
    def joined(value: Any, separator: str) -> str:
        return value if isinstance(value, str) else separator.join(_text(x) for x in value)

    options = []
    if camera is not None:
        options.append(("camera", joined(camera, ",")))
    planes = [cut] if isinstance(cut, str) or (len(cut) == 4 and not isinstance(cut[0], (str, tuple, list))) else cut
    options += [("cut", joined(plane, ",")) for plane in planes]
    for name, number in (("explode", explode), ("opacity", opacity)):
        if number is not None:
            options.append((name, _text(number)))
    if ghosts:
        options.append(("ghosts", ""))
    if color_by is not None:
        options.append(("color-by", str(color_by)))
    words = labels if isinstance(labels, str) else ",".join(str(word) for word in labels)
    if words:
        options.append(("labels", words))
    if caption is not None:
        options.append(("caption", str(caption)))
    if size is not None:
        options.append(("size", joined(size, "x")))
    return options


def replace_file(path: str | os.PathLike[str], data: bytes) -> None:
    """Writes a file that appears whole or not at all."""
    path = os.fspath(path)
    try:
        handle, draft = tempfile.mkstemp(dir=os.path.dirname(path) or ".", suffix=".tmp")
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(draft, 0o666 & ~mask)
            os.replace(draft, path)
        except BaseException:
            os.unlink(draft)
            raise
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror}") from None
