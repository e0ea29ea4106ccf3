"""A result for other packages: for meshio, VTK, PyVista and trimesh, with the cell data of a .vtu."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import convert
from .cells import Cells, Edges, Faces
from .errors import InputError


class Exported(convert.ForPyVista):
    """Of what has the cells of a result."""

    # Of the class that is exported.
    points: Any
    frame_points: Any
    vertices: Any
    edges: Any
    faces: Any
    regions: Any
    components: Any
    materials: Any
    leaves: Any
    said: Any
    groups: Any

    def _blocks(self) -> list[convert.Block]:
        """What is part of the result, in simplices: vertices, straight pieces of edges, triangles of faces."""
        vertices, edges, faces = self.vertices, self.edges, self.faces
        cells = vertices.active
        blocks = [convert.Block(0, convert.VERTEX, vertices.point[cells][:, None], cells, self._tags(0, vertices, cells))]
        pieces, of = _pieces(edges)
        blocks.append(convert.Block(1, convert.LINE, pieces, of, self._tags(1, edges, of)))
        of = faces.triangles.owners.astype(np.int32)
        shown = faces.component[of] != 0
        of = of[shown]
        blocks.append(convert.Block(2, convert.TRIANGLE, faces.triangles.values[shown], of, self._tags(2, faces, of)))
        return blocks

    def _tags(self, dimension: int, cells: Cells, numbers: NDArray[np.int32]) -> dict[str, NDArray[np.int32]]:
        """Cell data as of a .vtu."""
        regions = self.regions
        tags = {
            "dimension": np.full(len(numbers), dimension, dtype=np.int32),
            "cell": numbers,
            "component": cells.component[numbers],
            "region": cells.holder[numbers],
        }
        sides: NDArray[np.int32] = np.zeros((len(numbers), 2), dtype=np.int32)
        bounded: NDArray[np.int32] = np.full(len(numbers), -1, dtype=np.int32)
        if isinstance(cells, Faces):
            of = cells.regions[numbers]
            component = np.append(regions.component, np.int32(0))  # of region -1, too
            sides = component[of].astype(np.int32)
            bounded = np.where(of[:, 0] == of[:, 1], 0, np.count_nonzero(sides, axis=1)).astype(np.int32)
        tags["region_front"], tags["region_back"] = sides[:, 0].copy(), sides[:, 1].copy()
        tags["regions_bounded"] = bounded
        tags["material"] = cells.material[numbers] + np.int32(1)
        tags["source_leaf"] = cells.leaf[numbers]
        tags["source_face"] = cells.leaf_face[numbers]
        tags.update(self.said._tags(cells.said[numbers], dimension))
        return tags

    def _bounded_points(self) -> NDArray[np.float64]:
        if len(self.frame_points):
            raise InputError("the result reaches infinity, and a mesh cannot; intersect it with a box first")
        return self.points

    def to_meshio(self) -> Any:
        """A meshio.Mesh of vertices, lines and triangles, with cell data as of a .vtu. The groups are cell_sets and, by
        number and dimension, field_data. (A .msh by meshio: file_format="gmsh22"; `write` knows more of it.)
        ImportError without meshio; InputError for what reaches infinity."""
        return convert.to_meshio(self._bounded_points(), self._blocks(), self.groups)

    def to_vtk(self) -> Any:
        """A vtkUnstructuredGrid, as a .vtu has it: vertices, lines of edges, triangles of faces, and for each region
        the triangles of its boundary once more, normals outward. For PyVista: pyvista.wrap(result.to_vtk()).
        ImportError without vtk; InputError for what reaches infinity."""
        points = self._bounded_points()
        vertices, edges, faces, regions = self.vertices, self.edges, self.faces, self.regions
        parts: list[tuple[int, Any, Any, dict[str, Any]]] = []  # kind, lengths, points, tags
        cells = vertices.active
        parts.append((convert.VERTEX, np.ones(len(cells)), vertices.point[cells], self._tags(0, vertices, cells)))
        cells = edges.active
        lines = [np.append(edges.points[i], edges.points[i][:1] if edges.closed[i] else []) for i in cells]
        pieces = [np.column_stack([line[:-1], line[1:]]).ravel() for line in lines]
        counts = np.array([len(line) - 1 for line in lines], dtype=np.int64)
        parts.append((convert.LINE, np.full(counts.sum(), 2), np.concatenate(pieces) if pieces else np.zeros(0),
                      self._tags(1, edges, np.repeat(cells, counts))))
        of = faces.triangles.owners.astype(np.int32)
        of = of[faces.component[of] != 0]
        triangles = faces.triangles.values[faces.component[faces.triangles.owners] != 0]
        parts.append((convert.TRIANGLE, np.full(len(of), 3), triangles.ravel(), self._tags(2, faces, of)))
        for i in regions.active:
            outward = self._boundary(int(i))
            tags = self._tags(3, regions, np.full(len(outward), i, dtype=np.int32))
            parts.append((convert.TRIANGLE, np.full(len(outward), 3), outward.ravel(), tags))
        kinds = np.concatenate([np.full(len(lengths), kind) for kind, lengths, _, _ in parts])
        offsets = np.concatenate([[0], np.cumsum(np.concatenate([lengths for _, lengths, _, _ in parts]))])
        data = {name: np.concatenate([tags[name] for *_, tags in parts]) for name in parts[0][3]}
        names = {
            "RegionNames": ["outside", *(c.name for c in self.components)],
            "MaterialNames": ["none", *(name for name, _ in self.materials)],
            "LeafNames": list(self.leaves),
            **{f"{array} texts": texts for array, texts in self.said.texts.items()},
        }
        return convert.to_vtk(points, kinds, offsets, np.concatenate([p for *_, p, _ in parts]), data, names)

    def _boundary(self, region: int) -> NDArray[np.int32]:
        """The triangles of a region's boundary, seen from outside counter-clockwise."""
        triangles = [np.zeros((0, 3), dtype=np.int32)]
        for shell in self.regions.shells[region]:
            for side in shell:
                of = self.faces.triangles[side >> 1]
                # From its front a face is seen counter-clockwise: a region in front of it is left through its back.
                triangles.append(of[:, ::-1] if side & 1 == 0 else of)
        return np.concatenate(triangles)

    def to_trimesh(self, region: int | str | None = None) -> Any:
        """A trimesh.Trimesh: of a region (by number or by the name of its component) the closed boundary, normals
        outward; without one all faces of the result as they are.

        ImportError without trimesh; InputError for a region that is none, is not bounded, or whose boundary is no part
        of the result.
        """
        trimesh = convert.imported("trimesh", "trimesh", "to_trimesh")
        if region is None:
            triangles = self._blocks()[2].points
            points = self._bounded_points()
        else:
            number = self._region(region)
            if not self.regions.bounded[number]:
                raise InputError(f"region {number} has no bounds; intersect it with a box first")
            triangles, points = self._boundary(number), self.points
        used, numbers = np.unique(triangles, return_inverse=True)
        return trimesh.Trimesh(vertices=points[used], faces=numbers.reshape(-1, 3), process=False)

    def _region(self, region: int | str) -> int:
        active = self.regions.active
        if isinstance(region, str):
            names = [c.name for c in self.components]
            found = [int(i) for i in active if names[self.regions.component[i] - 1] == region]
            if len(found) != 1:
                known = ", ".join(sorted({names[self.regions.component[i] - 1] for i in active}))
                many = "several regions have" if found else "no region has"
                raise InputError(f"{many} the name {region!r}; names are: {known}; numbers: {active.tolist()}")
            return found[0]
        number = operator.index(region)
        numbers: Any = active.tolist()
        if number not in numbers:
            raise InputError(f"the result has no region of this number; there are {numbers}")
        return number


def _pieces(edges: Edges) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """The straight pieces of the edges that are part of the result: (k, 2) points, and the edge of each."""
    values, owners = edges.points.values, edges.points.owners
    following = np.roll(values, -1)
    last = edges.points.offsets[1:] - 1
    following[last] = values[edges.points.offsets[:-1]]
    kept = edges.component[owners] != 0
    kept[last[~edges.closed]] = False
    return np.stack([values, following], axis=1)[kept], owners[kept].astype(np.int32)
