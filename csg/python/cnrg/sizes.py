"""How large a result is, and where: exact numbers, and the nearest doubles under shorter names."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt
from typing import Any

import numpy as np

from .cells import Floats, doubles_of


class Sizes:
    """Of what has cells."""

    # Of the class that has these sizes.
    points: Any
    frame_points: Any
    exact_points: Any
    faces: Any
    regions: Any
    volume: Any

    @property
    def exact_bounds(self) -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]] | None:
        """The least and the greatest coordinates; None of what is empty or has no bounds."""
        if not len(self.points) or len(self.frame_points) or (self.regions.component[~self.regions.bounded] != 0).any():
            return None
        parts = list(zip(*self.exact_points))
        return tuple(map(min, parts)), tuple(map(max, parts))

    @property
    def bounds(self) -> Floats | None:
        """(2, 3) float64: `exact_bounds`, the nearest doubles."""
        exact = self.exact_bounds
        return None if exact is None else doubles_of(exact)

    @property
    def area(self) -> float:
        """Of all faces that are part of it, walls between regions once, in square units; inf for what has no end."""
        return float(np.sum(self.faces.areas[self.faces.active]))

    @property
    def exact_area(self) -> Fraction | None:
        """`area` where that of each face is a fraction and each is flat; else None."""
        roots = [_root(self.faces.squared_area(int(i))) for i in self.faces.active]
        known = [root for root in roots if root is not None]
        return sum(known, Fraction(0)) if len(known) == len(roots) else None

    @property
    def exact_centroid(self) -> tuple[Fraction, ...] | None:
        """The centre of mass of all regions; None where there is none or one has no bounds."""
        volume = self.volume
        if not volume:
            return None
        moments = [[r.volume * x for x in r.centroid] for r in self.regions]  # type: ignore[union-attr,operator]
        return tuple(sum(parts, Fraction(0)) / volume for parts in zip(*moments))

    @property
    def centroid(self) -> Floats | None:
        """(3,) float64: `exact_centroid`, the nearest doubles."""
        exact = self.exact_centroid
        return None if exact is None else doubles_of([exact])[0]


def _root(square: Fraction | None) -> Fraction | None:
    """The root of a square, if it is a fraction."""
    if square is None:
        return None
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root * root == square else None
