"""What goes wrong, by who can mend it. Each error is one sentence that says what is wrong and what to do."""

from __future__ import annotations

import re

_PLACED = re.compile(r"([^\n]+?):(?:(\d+):)?(?:(\d+):)? error: ", re.DOTALL)


class Error(Exception):
    """Of all errors that cnrg raises by itself.

    file, line, column: where the fault is, counted from 1: in a file that was read, or in the script, at the call
        that made the node; None where it has no place.
    message: the same without the place.
    more: errors like this one for the other faults of the same tree.
    """

    more: tuple[Error, ...] = ()

    def __init__(self, message: str, file: str | None = None, line: int | None = None, column: int | None = None):
        placed = _PLACED.match(message) if file is None else None
        if placed:  # of a file that a leaf reads, and where the system refuses one
            message = message[placed.end() :]
            file = placed[1]
            line = int(placed[2]) if placed[2] else None
            column = int(placed[3]) if placed[3] else None
        # What a file has may be shown in a terminal, which obeys control characters.
        self.message = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in message)
        self.file = file
        self.line = line
        self.column = column
        super().__init__(self.message, file, line, column)

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        line = f"{place}: {self.message}" if place else self.message
        return "\n".join((line, *map(str, self.more)))


class InputError(Error, ValueError):
    """Input that cannot be evaluated: a shape, a tree, a file, an option."""


class FileError(Error, OSError):
    """A file that cannot be read or written, or a system without memory, threads or processes."""

    __str__ = Error.__str__


class InvariantError(Error, RuntimeError):
    """A bug of cnrg: please send the message with the tree."""


class Stopped(Error):
    """Work that was stopped, since a progress function or a handler of a signal asked for it."""


class Notice(UserWarning):
    """Something about a tree that people should know and that stops nothing, as `warnings` shows it."""
