"""The value of one node, as files show it."""

from __future__ import annotations

import os
from typing import Any


class Result:
    """An exact result. It never changes and needs neither the tree nor the evaluation any more."""

    def __init__(self) -> None:
        raise TypeError("a Result comes from node.evaluate()")

    @classmethod
    def _of(cls, result: Any, evaluation: Any) -> Result:
        self = object.__new__(cls)
        self._result = result
        self._evaluation = evaluation
        return self

    @property
    def name(self) -> str:
        """Of the node."""
        return self._result.name

    def write(self, path: str | os.PathLike[str], *, parameters: bool = False) -> None:
        """Writes a file in the format of its extension."""
        self._result.write(os.fspath(path), parameters)
