"""Places in the script of a user, for messages."""

from __future__ import annotations

import os
import sys
from typing import Any, Tuple

from .errors import InputError

Site = Tuple[Any, ...]
"""Where something was made, for messages: file, line, and the column where it is known."""


def site_of_caller() -> Site:
    """File and line of the innermost call from outside of this package."""
    here = os.path.dirname(__file__)
    frame = sys._getframe(1)
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == here:
        frame = frame.f_back
    return frame.f_code.co_filename, frame.f_lineno


def fault(message: str) -> InputError:
    """An error at the caller's place."""
    return InputError(message, *site_of_caller())
