"""What is shown while long work goes on."""

from __future__ import annotations

import operator
import sys
from typing import Any, Callable, Union

Progress = Union[None, bool, Callable[[str, int, int], Any]]
"""None or False: nothing is shown. True: a bar, by tqdm if that is installed, else lines on standard error. Or a
function that is called as f(stage, done, total), up to twenty times a second; total is 0 where it is not known. What
it raises stops the work."""


def threads_of(threads: Any) -> int:
    """How many threads long work may have; 0: one per core."""
    threads = operator.index(threads)
    if not 0 <= threads <= 4096:
        raise ValueError(f"threads: a number from 0 to 4096 is wanted, not {threads}")
    return int(threads)


class _Bar:
    """A bar per stage."""

    def __init__(self) -> None:
        self._stage = ""
        self._bar: Any = None

    def __call__(self, stage: str, done: int, total: int) -> None:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            if stage != self._stage:
                print(f"cnrg: {stage}", file=sys.stderr)
            self._stage = stage
            return
        if stage != self._stage:
            self.close()
            self._stage = stage
            self._bar = tqdm(total=total or None, desc=stage, leave=False)
        if self._bar is not None and done > self._bar.n:
            self._bar.update(done - self._bar.n)

    def close(self) -> None:
        """Removes the bar."""
        if self._bar is not None:
            self._bar.close()
        self._bar = None


class Shown:
    """with Shown(progress) as f: f is None or a function for the library."""

    def __init__(self, progress: Progress):
        if progress is not None and not isinstance(progress, bool) and not callable(progress):
            raise TypeError("progress: None, True, or a function f(stage, done, total) is wanted")
        self._bar = _Bar() if progress is True else None
        self._function = self._bar or (progress if callable(progress) else None)

    def __enter__(self) -> Callable[[str, int, int], Any] | None:
        return self._function

    def __exit__(self, *error: Any) -> None:
        if self._bar is not None:
            self._bar.close()
