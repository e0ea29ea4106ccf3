"""The faces of a result as triangles or quadrilaterals, its edges and wires as segments, without volumes."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import convert
from .cells import SaidTable
from .tetrahedra import Mesh, Simplices


@dataclass(frozen=True)
class Meshed:
    """What was made of the faces with one name."""

    name: str
    """of their first group"""
    triangles: int
    quads: int
    area: float
    """of both together, in square units of the model"""
    least_angle: float
    """of its triangles, in degrees; 180 without any"""
    least_quality: float
    """of its quadrilaterals: 1 of a rectangle, less what its angle farthest from 90 degrees misses, in parts of 90; 1
    without any"""


class SurfaceMesh(Mesh):
    """A conforming mesh of all faces, edges, wires and points, which was proven to be that of the result.

    Arrays show memory of the library: they are read-only and keep it alive.
    """

    def __init__(self, mesh: Any, result: Any):
        data = mesh.data()
        self._mesh = mesh
        self._result = result
        self.points: NDArray[np.float64] = data["points"]
        """(n, 3) float64, in units of the model"""
        self.vertices, self.segments, self.triangles, _ = (Simplices(of) for of in data["simplices"])
        self.quads = Simplices(data["quads"])
        """quadrilaterals in place of triangles: `points` is (n, 4), counter-clockwise as seen from the front; `cell` is
        a face; none unless they were asked for"""
        self.groups: list[dict[str, NDArray[np.int32]]] = data["groups"]
        """by dimension: names such as "wall rock | ore", with the cells of the result that have them; an element is in
        the group of its `cell`"""
        self.faces: list[Meshed] = [Meshed(*of) for of in data["faces"]]
        """what was made of the faces of each name"""
        self.materials: tuple[str, ...] = tuple(data["materials"])
        self.leaves: tuple[str, ...] = tuple(data["leaves"])
        self.said = SaidTable(data["said"])
        """what is said of the cells that elements lie in: name, material, attributes, each different thing once"""
        self.moved: int = data["moved"]
        """how many vertices of the result are no doubles and were rounded"""
        self.kept: int = data["kept"]
        """how many facets keep the triangles that they have, since smaller ones of doubles would cross what is near"""
        self.curved: bool = data["curved"]
        """elements of second order, with a node in the middle of each straight side"""

    def _elements(self) -> list[tuple[int, int, Simplices]]:
        simplices = (self.vertices, self.segments, self.triangles)
        return [*((d, convert.curved_kind(d, self.curved), of) for d, of in enumerate(simplices)),
                (2, convert.QUAD, self.quads)]

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes .msh .msh2 .vtu .inp .bdf .med .xdmf, .mesh .f3grid unless it is of second order, and .h5m if it is of first order
        without quadrilaterals. InputError for another extension; FileError."""
        self._mesh.write(os.fspath(path))

    def __repr__(self) -> str:
        quads = f"{len(self.quads)} quadrilaterals and " if len(self.quads) else ""
        return f"<cnrg.SurfaceMesh: {quads}{len(self.triangles)} triangles, {len(self.points)} points>"
