"""Tetrahedra that fill the regions of a result."""

from __future__ import annotations

import os
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np
from numpy.typing import NDArray

from . import convert
from .cells import SaidTable
from .habits import missing

_DATA = ("cell", "component", "region", "region_front", "region_back", "material", "source_leaf", "source_face")


@dataclass(frozen=True)
class Filled:
    """What was made of one region."""

    name: str
    """of its group"""
    tetrahedra: int
    volume: Fraction
    """of these together, exactly; of curved ones to the accuracy of doubles"""


class Simplices:
    """Simplices of one dimension, n of them."""

    def __init__(self, data: Mapping[str, Any]):
        self.points: NDArray[np.int32] = data["points"]
        """(n, d + 1) int32: rows of Tetrahedra.points; of second order then the middles of the edges, in the order of
        Gmsh. Triangles are counter-clockwise as seen from the front of their face"""
        self.cell: NDArray[np.int32] = data["cell"]
        """(n,) int32: the cell of the result, of the same dimension, that the simplex lies in"""
        self.component: NDArray[np.int32] = data["component"]
        """(n,) int32, from 1"""
        self.region: NDArray[np.int32] = data["region"]
        """(n,) int32: the component of the region that it lies in, that is behind it or in front; 0: none"""
        self.region_front: NDArray[np.int32] = data["region_front"]
        """(n,) int32: of triangles the component of the region in front; 0: none"""
        self.region_back: NDArray[np.int32] = data["region_back"]
        """(n,) int32: behind"""
        self.material: NDArray[np.int32] = data["material"]
        """(n,) int32: a place in Tetrahedra.materials plus 1; 0: none"""
        self.said: NDArray[np.int32] = data["said"]
        """(n,) int32: what is said of that cell, a place in Tetrahedra.said; -1: nothing"""
        self.source_leaf: NDArray[np.int32] = data["source_leaf"]
        """(n,) int32: the leaf that it came from, a place in Tetrahedra.leaves; -1: none"""
        self.source_face: NDArray[np.int32] = data["source_face"]
        """(n,) int32: the face of that leaf; -1: none"""

    def __len__(self) -> int:
        return len(self.cell)


class Mesh(convert.ForPyVista):
    """What tetrahedra and surface meshes have in common."""

    _mesh: Any
    _result: Any
    points: NDArray[np.float64]
    groups: list[dict[str, NDArray[np.int32]]]
    materials: tuple[str, ...]
    leaves: tuple[str, ...]
    said: SaidTable

    def _elements(self) -> list[tuple[int, int, Simplices]]:
        """The dimension, the kind and the elements of each block."""
        raise NotImplementedError

    def _blocks(self) -> list[convert.Block]:
        blocks = []
        for d, kind, of in self._elements():
            data = {name: getattr(of, name) for name in _DATA}
            data = {"dimension": np.full(len(of), d, dtype=np.int32), **data, **self.said._tags(of.said, d)}
            blocks.append(convert.Block(d, kind, of.points, of.cell, data))
        return [block for block in blocks if len(block.cells)]

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            raise missing("a mesh", name, type(self))

    def to_meshio(self) -> Any:
        """A meshio.Mesh: groups are cell_sets and, by number and dimension, field_data. ImportError without meshio."""
        return convert.to_meshio(self.points, self._blocks(), self.groups)

    def to_vtk(self) -> Any:
        """A vtkUnstructuredGrid (for PyVista: pyvista.wrap(...)), with cell data as of a .vtu. ImportError without
        vtk."""
        names = {"RegionNames": ["outside", *(c.name for c in self._result.components)],
                 "MaterialNames": ["none", *self.materials], "LeafNames": list(self.leaves),
                 **{f"{array} texts": texts for array, texts in self.said.texts.items()}}
        return convert.blocks_to_vtk(self.points, self._blocks(), names)


class Tetrahedra(Mesh):
    """A mesh that conforms to every region, wall, sheet, wire and point, which was proven exactly.

    Arrays show memory of the library: they are read-only and keep it alive.
    """

    def __init__(self, mesh: Any, result: Any):
        data = mesh.data()
        self._mesh = mesh
        self._result = result
        self.points: NDArray[np.float64] = data["points"]
        """(n, 3) float64"""
        self.vertices, self.segments, self.triangles, self.tetrahedra = (Simplices(of) for of in data["simplices"])
        self.groups: list[dict[str, NDArray[np.int32]]] = data["groups"]
        """by dimension: names such as "rock" or "boundary of rock", with the cells of the result that have them; a
        simplex is in the group of its `cell`"""
        self.regions: list[Filled] = [Filled(*region) for region in data["regions"]]
        """what was made of each region"""
        self.materials: tuple[str, ...] = tuple(data["materials"])
        self.leaves: tuple[str, ...] = tuple(data["leaves"])
        self.said = SaidTable(data["said"])
        """what is said of the cells that simplices lie in: name, material, attributes, each different thing once"""
        self.fields: dict[str, NDArray[np.float64]] = data["fields"]
        """(tetrahedra, 4) float64 at corners: `fraction of steel` of graded materials"""
        self.moved: int = data["moved"]
        """how many vertices of the result are no doubles and were rounded"""
        self.expected: float = mesh.expected()
        """how many tetrahedra were expected before any was made: mostly within a factor of two where sizes or volumes
        are asked for; 0 where that is not foretold"""
        self.curved: bool = data["curved"]
        """elements of second order, on true surfaces or with straight edges"""

    def _elements(self) -> list[tuple[int, int, Simplices]]:
        simplices = (self.vertices, self.segments, self.triangles, self.tetrahedra)
        return [(d, convert.curved_kind(d, self.curved), of) for d, of in enumerate(simplices)]

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes .msh .msh2 .vtu .inp .bdf .med .xdmf, and .mesh .h5m .f3grid if it is of first order. InputError for another
        extension; FileError."""
        self._mesh.write(os.fspath(path))

    def __repr__(self) -> str:
        return f"<cnrg.Tetrahedra: {len(self.tetrahedra)} in {len(self.regions)} regions, {len(self.points)} points>"
