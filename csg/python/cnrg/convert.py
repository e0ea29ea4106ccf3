"""Results for other packages, and their meshes. None of them is needed unless it is asked for: each is imported in its
function, and their meshes are known by what they have."""

from __future__ import annotations

import importlib
import warnings
from functools import partial
from typing import Any, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from .errors import Notice
from .place import fault, site_of_caller

# VTK's numbers of cells, of straight and of curved simplices by dimension.
VERTEX, LINE, TRIANGLE, QUAD, TETRA = 1, 3, 5, 9, 10
_STRAIGHT = (VERTEX, LINE, TRIANGLE, TETRA)
_CURVED = (VERTEX, 21, 22, 24)
_MESHIO = {VERTEX: "vertex", LINE: "line", TRIANGLE: "triangle", QUAD: "quad", TETRA: "tetra",
           21: "line3", 22: "triangle6", 24: "tetra10"}
# In a file of VTK the middles of a tetrahedron's edges come in the order 01 12 20 03 13 23; ours are 01 12 20 03 23 13.
_TETRA10 = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]


def imported(module: str, package: str, method: str) -> Any:
    """A module; an ImportError that names its package."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(f"{method} needs the package {package}, which is not here ({error}); install it: "
                          f"pip install {package}") from error


def is_mesh(value: Any) -> bool:
    """A mesh of trimesh (vertices, faces), PyVista (points, faces) or meshio (points, cells)."""
    has = partial(hasattr, value)
    return (has("faces") and (has("vertices") or has("points"))) or (has("points") and has("cells_dict"))


def arrays_of(mesh: Any) -> tuple[Any, Any]:
    """Points and faces of such a mesh. InputError for one whose faces do not say all of it."""
    if not is_mesh(mesh):
        raise TypeError("mesh: give points and faces, or a mesh of trimesh, PyVista or meshio")
    if hasattr(mesh, "cells_dict"):
        return mesh.points, _faces_of_meshio(mesh)
    if hasattr(mesh, "vertices"):
        return mesh.vertices, mesh.faces
    others = [kind for kind in ("lines", "strips", "verts") if getattr(mesh, "n_" + kind, 0)]
    if others:
        raise fault(f"mesh: the mesh has {' and '.join(others)} beside faces; take the faces alone, such as by "
                    ".extract_surface().triangulate()")
    return mesh.points, _faces_of_vtk(np.asarray(mesh.faces))


def _faces_of_vtk(row: NDArray[np.int64]) -> Any:
    """Faces one after the other, each behind the number of its corners."""
    if len(row) and len(row) % (row[0] + 1) == 0:
        table = row.reshape(-1, row[0] + 1)
        if (table[:, 0] == row[0]).all():
            return table[:, 1:]
    faces, at = [], 0
    while at < len(row):
        faces.append(row[at + 1 : at + 1 + row[at]])
        at += 1 + row[at]
    return faces


def _faces_of_meshio(mesh: Any) -> list[Any]:
    taken = [block for block in mesh.cells if block.type in ("triangle", "quad", "polygon")]
    left = sorted({block.type for block in mesh.cells} - {block.type for block in taken})
    if not taken:
        raise fault(f"mesh: cells of meshio that are triangle, quad or polygon are wanted, not {', '.join(left)}; give "
                    "the surface of the mesh")
    if left:
        warnings.warn_explicit(f"mesh: cells {', '.join(left)} are left out; faces are taken", Notice, *site_of_caller())
    if len(taken) == 1:
        return taken[0].data
    return [face for block in taken for face in block.data]


class Block:
    """Cells of one kind: their points, and the cell of the result that each is a part of."""

    def __init__(self, dimension: int, kind: int, points: Any, cells: Any, data: Mapping[str, Any]):
        self.dimension = dimension
        self.kind = kind
        self.points = points
        self.cells = cells
        self.data = data


def curved_kind(dimension: int, curved: bool) -> int:
    """VTK's number of a simplex."""
    return (_CURVED if curved else _STRAIGHT)[dimension]


def _first_groups(blocks: Sequence[Block], groups: Sequence[Mapping[str, Any]]) -> list[Any]:
    """Of each cell the number of its first group, from 1; 0: none."""
    out = []
    for block in blocks:
        numbers = np.zeros(int(block.cells.max()) + 1 if len(block.cells) else 0, dtype=np.int32)
        for number, cells in reversed(list(enumerate(groups[block.dimension].values(), 1))):
            numbers[cells[cells < len(numbers)]] = number
        out.append(numbers[block.cells])
    return out


def to_meshio(points: Any, blocks: Sequence[Block], groups: Sequence[Mapping[str, Any]]) -> Any:
    """A meshio.Mesh with groups as cell_sets, as field_data (number, dimension) and as numbers of cells."""
    meshio = imported("meshio", "meshio", "to_meshio")
    blocks = [block for block in blocks if len(block.cells)]
    cells = [(_MESHIO[block.kind], np.asarray(block.points)) for block in blocks]
    cell_data = {name: [block.data[name] for block in blocks] for name in (blocks[0].data if blocks else ())}
    physical = _first_groups(blocks, groups)
    # The words under which meshio writes them to files of Gmsh: of version 2.2, since its writer of 4.1 wants a block
    # of cells for each entity, with a point of its own.
    cell_data["gmsh:physical"] = physical
    cell_data["gmsh:geometrical"] = [block.cells.astype(np.int32) + 1 for block in blocks]
    cell_sets: dict[str, Any] = {}
    field_data: dict[str, Any] = {}
    for dimension, named in enumerate(groups):
        for number, (name, members) in enumerate(named.items(), 1):
            if not any(block.dimension == dimension for block in blocks):
                continue
            field_data.setdefault(name, np.array([number, dimension]))
            sets = cell_sets.setdefault(name, [np.zeros(0, dtype=np.int64) for _ in blocks])
            for i, block in enumerate(blocks):
                if block.dimension == dimension:
                    sets[i] = np.flatnonzero(np.isin(block.cells, members))
    return meshio.Mesh(np.asarray(points), cells, cell_data=cell_data, cell_sets=cell_sets, field_data=field_data)


def to_vtk(points: Any, kinds: Any, offsets: Any, connectivity: Any, cell_data: Mapping[str, Any],
           names: Mapping[str, Sequence[str]]) -> Any:
    """A vtkUnstructuredGrid; names are field data of strings."""
    core = imported("vtkmodules.vtkCommonCore", "vtk", "to_vtk")
    model = imported("vtkmodules.vtkCommonDataModel", "vtk", "to_vtk")
    support = imported("vtkmodules.util.numpy_support", "vtk", "to_vtk")
    grid = model.vtkUnstructuredGrid()
    corners = core.vtkPoints()
    corners.SetDataTypeToDouble()
    corners.SetData(support.numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=True))
    grid.SetPoints(corners)
    cells = model.vtkCellArray()
    cells.SetData(support.numpy_to_vtkIdTypeArray(np.ascontiguousarray(offsets, dtype=np.int64), deep=True),
                  support.numpy_to_vtkIdTypeArray(np.ascontiguousarray(connectivity, dtype=np.int64), deep=True))
    types = support.numpy_to_vtk(np.ascontiguousarray(kinds, dtype=np.uint8), deep=True,
                                 array_type=core.vtkUnsignedCharArray().GetDataType())
    grid.SetCells(types, cells)
    for name, values in cell_data.items():
        array = support.numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    for name, texts in names.items():
        strings = core.vtkStringArray()
        strings.SetName(name)
        for text in texts:
            strings.InsertNextValue(text)
        grid.GetFieldData().AddArray(strings)
    return grid


def blocks_to_vtk(points: Any, blocks: Sequence[Block], names: Mapping[str, Sequence[str]]) -> Any:
    """As a vtkUnstructuredGrid."""
    kinds, lengths, connectivity = [], [], []
    data: dict[str, list[Any]] = {name: [] for name in (blocks[0].data if blocks else ())}
    for block in blocks:
        nodes = np.asarray(block.points)
        if block.kind == 24:
            nodes = nodes[:, _TETRA10]
        kinds.append(np.full(len(nodes), block.kind, dtype=np.uint8))
        lengths.append(np.full(len(nodes), nodes.shape[1], dtype=np.int64))
        connectivity.append(nodes.ravel())
        for name in data:
            data[name].append(block.data[name])
    offsets = np.concatenate([[0], np.cumsum(np.concatenate(lengths))]) if blocks else np.zeros(1, dtype=np.int64)
    return to_vtk(points, np.concatenate(kinds) if blocks else np.zeros(0, dtype=np.uint8), offsets,
                  np.concatenate(connectivity) if blocks else np.zeros(0, dtype=np.int64),
                  {name: np.concatenate(parts) for name, parts in data.items()}, names)


class ForPyVista:
    """What has `to_vtk`, for PyVista."""

    def to_vtk(self) -> Any:
        raise NotImplementedError

    def to_pyvista(self) -> Any:
        """A pyvista.UnstructuredGrid, as `to_vtk`. ImportError without pyvista."""
        return imported("pyvista", "pyvista", "to_pyvista").wrap(self.to_vtk())

    def plot(self, **options: Any) -> Any:
        """A window by PyVista, `to_pyvista().plot(**options)`; `Result.picture` and `.view` need no other package."""
        return self.to_pyvista().plot(**options)
