"""The cells of a result as arrays of numpy.

What is known of a kind of cells is one array, by number of the cell. The arrays show memory of the library: they are
read-only, cost nothing, and keep that memory alive by themselves, whatever becomes of the result. Numbers are those of
all files: points, cells, patches and leaves from 0, components from 1; a component of 0 says that the cell is no part
of the result but bounds a part of it. Elsewhere -1 stands for "none".

A side of a face is one number, 2 * face + side, where side 0 is its front and 1 its back.
"""

from __future__ import annotations

import operator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Iterator, Mapping, Sequence, overload

import numpy as np
from numpy.typing import NDArray

from .convert import imported

Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]
_KINDS = ("point", "wire", "face", "region")


def doubles_of(points: Sequence[Any]) -> Floats:
    """(n, 3) float64: the nearest doubles."""
    return np.array([[float(x) for x in p] for p in points], dtype=np.float64).reshape(-1, 3)


class Lists(Sequence[Any]):
    """Lists of different lengths, end to end.

    offsets: (n + 1,) int64. values: an array, or other Lists. List i is values[offsets[i]:offsets[i + 1]]; it is what
    lists[i] gives, a view. lists[a:b] are some of them, on the same values.
    """

    __slots__ = ("offsets", "values")

    def __init__(self, offsets: NDArray[np.int64], values: Any):
        self.offsets = offsets
        self.values = values

    @staticmethod
    def _of(pair: Any) -> Any:
        """From (offsets, values), where values may be such a pair."""
        return Lists(pair[0], Lists._of(pair[1])) if isinstance(pair, tuple) else pair

    def __len__(self) -> int:
        return len(self.offsets) - 1

    @overload
    def __getitem__(self, i: int) -> Any: ...
    @overload
    def __getitem__(self, i: slice) -> Lists: ...
    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            start, stop, step = i.indices(len(self))
            if step != 1:
                raise ValueError("Lists: a slice takes neighbours, so its step is 1")
            return Lists(self.offsets[start : max(start, stop) + 1], self.values)
        i = _number(i, len(self))
        return self.values[int(self.offsets[i]) : int(self.offsets[i + 1])]

    def __iter__(self) -> Iterator[Any]:
        return (self[i] for i in range(len(self)))

    @property
    def lengths(self) -> NDArray[np.int64]:
        """(n,) int64: of each list."""
        return np.diff(self.offsets)

    @property
    def owners(self) -> NDArray[np.int64]:
        """The number of the list that each value is in: (k,) int64, for the values of these lists."""
        return np.repeat(np.arange(len(self)), self.lengths)

    def tolist(self) -> list[Any]:
        """As lists of Python."""
        return [part.tolist() for part in self]

    def __repr__(self) -> str:
        return f"<cnrg.Lists: {len(self)} with {int(self.offsets[-1] - self.offsets[0])} values>"


class ExactPoints(Sequence[Any]):
    """Exact coordinates, each point made when it is asked for: three Fractions."""

    __slots__ = ("_arrays", "_size")

    def __init__(self, arrays: Any, size: int):
        self._arrays = arrays
        self._size = size

    def __len__(self) -> int:
        return self._size

    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(self._size))]
        return self._arrays.exact_point(_number(i, self._size))


class Cells:
    """What all kinds of cells have; n of them."""

    _kind = ""

    def __init__(self, data: dict[str, Any], arrays: Any, leaves: tuple[str, ...]):
        self._arrays = arrays
        self._leaves = leaves
        self.component: Ints = data["component"]
        """(n,) int32, from 1; 0: no part of the result. In a group its entities are the last component"""
        self.entity: Flags = data["entity"]
        """(n,) bool: part of the result, and not just of the interior of a region of its component"""
        self.holder: Ints = data["holder"]
        """(n,) int32: the component of the region that the cell is, that is behind it, in front of it or around it; 0:
        none"""
        self.material: Ints = data["material"]
        """(n,) int32: a place in Result.materials, -1: none; a sheet, wire or point has its own, if it has one; else an
        entity of a group has that of its holder"""
        self.said: Ints = data["said"]
        """(n,) int32: what is said of the cell, a place in Result.said; -1: nothing"""
        self.leaf: Ints = data["leaf"]
        """(n,) int32: the first leaf with a face that the cell came from, else the first leaf; a place in
        Result.leaves"""
        self.leaf_face: Ints = data["leaf_face"]
        """(n,) int32: that face, by its number in the leaf; -1: from no face"""
        self.origin_leaves: Lists = Lists._of(data["origin_leaves"])
        """of each cell the leaves that it came from, ascending"""
        self.origin_cells: Lists = Lists._of(data["origin_cells"])
        """of each cell the cells of leaves that hold it: (k, 3) int32, rows of leaf; dimension (0 isolated point, 1
        wire, 2 face, 3 region); number in the leaf (regions from 1, a point has 0)"""

    def __len__(self) -> int:
        return len(self.component)

    @property
    def active(self) -> Ints:
        """The numbers of those that are part of the result."""
        return np.flatnonzero(self.component).astype(np.int32)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each cell and a column for each array that has one number of it, for each side
        of a face and end of an edge one. ImportError without pandas."""
        pandas = imported("pandas", "pandas", "to_pandas")
        columns = {}
        for name, values in vars(self).items():
            if isinstance(values, np.ndarray):
                parts = [values] if values.ndim == 1 else list(values.T)
                columns.update({name if len(parts) == 1 else f"{name}_{k}": part for k, part in enumerate(parts)})
        return pandas.DataFrame({name: part for name, part in columns.items() if name[0] != "_"})

    def origin(self, i: int) -> list[tuple[str, str, int]]:
        """Of cell i, each as (name of the leaf, "face", number); kinds are point, wire, face, region."""
        return [(self._leaves[leaf], _KINDS[d], int(n)) for leaf, d, n in self.origin_cells[_number(i, len(self))]]

    def __repr__(self) -> str:
        return f"<cnrg {self._kind}: {len(self)}, {int(np.count_nonzero(self.component))} of them part of the result>"


class Vertices(Cells):
    """Vertices."""

    _kind = "vertices"

    def __init__(self, data: dict[str, Any], arrays: Any, leaves: tuple[str, ...]):
        super().__init__(data, arrays, leaves)
        self.point: Ints = data["point"]
        """(n,) int32: where it is, a row of Result.points"""
        self.feature: Flags = data["feature"]
        """(n,) bool: kept by simplification for what it is in its leaf"""
        self.free: Flags = data["free"]
        """(n,) bool: no edge ends there"""
        self.region: Ints = data["region"]
        """(n,) int32: the region around a vertex on no edge and no face, else -1, as for the outside"""
        self.edges: Lists = Lists._of(data["edges"])
        """of each vertex the edges that end there, ascending; one with both ends there twice"""


class Edges(Cells):
    """Edges: chains of straight pieces."""

    _kind = "edges"

    def __init__(self, data: dict[str, Any], arrays: Any, leaves: tuple[str, ...]):
        super().__init__(data, arrays, leaves)
        self.points: Lists = Lists._of(data["points"])
        """of each edge its points from end to end; a closed one does not repeat the first"""
        self.vertices: Ints = data["vertices"]
        """(n, 2) int32: the ends; -1 of a closed edge and where an edge has no end"""
        self.closed: Flags = data["closed"]
        """(n,) bool: without ends"""
        self.feature: Flags = data["feature"]
        """(n,) bool, as of vertices"""
        self.wire: Flags = data["wire"]
        """(n,) bool: on the boundary of no face"""
        self.slit: Flags = data["slit"]
        """(n,) bool: a face is on both of its sides"""
        self.region: Ints = data["region"]
        """(n,) int32: the region around a wire, else -1, as for the outside"""
        self.around: Lists = Lists._of(data["around"])
        """of each edge the faces about it in radial order, counter-clockwise as seen with the edge pointing towards
        you, each by the side that is met first, 2 * face + side; a slit twice"""
        self._lengths: Floats | None = None

    @property
    def lengths(self) -> Floats:
        """(n,) float64, in units of the model; inf for what has no end."""
        if self._lengths is None:
            self._lengths = self._arrays.lengths()
        return self._lengths

    def squared_length(self, i: int) -> Fraction | None:
        """Of edge i, exactly; None if it is not straight or has no end."""
        return self._arrays.squared_length(_number(i, len(self)))


class Faces(Cells):
    """Faces, flat or of a curved patch."""

    _kind = "faces"

    def __init__(self, data: dict[str, Any], arrays: Any, leaves: tuple[str, ...]):
        super().__init__(data, arrays, leaves)
        self.loops: Lists = Lists._of(data["loops"])
        """of each face its boundary walks, each a list of points, the face to the left as seen from its front; of a
        flat face the outer walk comes first"""
        self.loop_edges: Lists = Lists._of(data["loop_edges"])
        """of each face the same walks by edges: 2 * edge, or 2 * edge + 1 where it is walked from its last point to its
        first; none where a face reaches infinity"""
        self.isolated: Lists = Lists._of(data["isolated"])
        """of each face the points in its interior that are vertices"""
        self.regions: Ints = data["regions"]
        """(n, 2) int32: the regions in front and behind; -1 for the outside, which has no bounds and is no part of the
        result"""
        self.patch: Ints = data["patch"]
        """(n,) int32: faces with one number are of one patch of a leaf"""
        self.flat: Flags = data["flat"]
        """(n,) bool: in one plane, exactly"""
        self.triangles: Lists = Lists._of(data["triangles"])
        """of each face (k, 3) int32 points, counter-clockwise as seen from its front. triangles.values has all of them,
        triangles.owners the face of each"""
        self.facets: Lists = Lists._of(data["facets"])
        """of each face that is not flat its planar pieces, each a list of loops of points"""
        self.facet_isolated: Lists = Lists._of(data["facet_isolated"])
        """of each face, by facet, the points in its interior"""
        self.facet_triangles: Lists = Lists._of(data["facet_triangles"])
        """of each face how many of its triangles each facet has; they stand facet by facet"""
        self._areas: Floats | None = None
        self._area_vectors: Floats | None = None

    @property
    def areas(self) -> Floats:
        """(n,) float64, in square units; inf for what has no end."""
        if self._areas is None:
            self._areas = self._arrays.areas()
        return self._areas

    @property
    def area_vectors(self) -> Floats:
        """(n, 3) float64: the integral of the normal of the front over the face, so of a flat face its normal as long
        as the face has area; its parts are the areas of the projections. NaN for what has no end."""
        if self._area_vectors is None:
            self._area_vectors = self._arrays.area_vectors()
        return self._area_vectors

    def squared_area(self, i: int) -> Fraction | None:
        """Of face i, exactly; None if it is not flat or has no end."""
        return self._arrays.squared_area(_number(i, len(self)))

    def area_vector(self, i: int) -> tuple[Fraction, Fraction, Fraction] | None:
        """Of face i, exactly; None if it has no end."""
        return self._arrays.area_vector(_number(i, len(self)))


@dataclass(frozen=True)
class Region:
    """A region of the result."""

    number: int
    """among the regions, as in arrays and files"""
    name: str
    material: str
    """"" if it has none"""
    volume: Fraction | None
    """exact, in cubic units; None: unbounded"""
    centroid: tuple[Fraction, Fraction, Fraction] | None
    """exact"""
    attributes: Mapping[str, Fraction | str] = field(default_factory=dict, repr=False, hash=False)


class Regions(Cells):
    """Regions: connected pieces of space. Some may be no part of the result, among them mostly the outside; iterated are
    those that are part of it, as `Region`."""

    _kind = "regions"

    def __init__(self, data: dict[str, Any], arrays: Any, leaves: tuple[str, ...], components: Sequence[Any] = ()):
        super().__init__(data, arrays, leaves)
        self._components = components
        self.bounded: Flags = data["bounded"]
        """(n,) bool"""
        self.shells: Lists = Lists._of(data["shells"])
        """of each region the connected parts of its boundary, each a list of sides of faces, 2 * face + side"""
        self._volumes: list[Fraction | None] | None = None
        self._centroids: list[Any] | None = None

    def __iter__(self) -> Iterator[Region]:
        for i in self.active.tolist():
            name, material, _, attributes = self._components[self.component[i] - 1]
            yield Region(i, name, material, self.exact_volumes[i], self.exact_centroids[i], attributes)

    @property
    def exact_centroids(self) -> list[tuple[Fraction, Fraction, Fraction] | None]:
        """Of each the centre of mass; None for one without bounds."""
        if self._centroids is None:
            self._centroids = self._arrays.centroids()
        return list(self._centroids)

    @property
    def centroids(self) -> Floats:
        """(n, 3) float64: the nearest doubles; NaN for what has no bounds."""
        return doubles_of([(np.nan,) * 3 if c is None else c for c in self.exact_centroids])

    @property
    def exact_volumes(self) -> list[Fraction | None]:
        """Of each, in cubic units; None for one without bounds."""
        if self._volumes is None:
            self._volumes = self._arrays.volumes()
        return list(self._volumes)

    @property
    def volumes(self) -> Floats:
        """(n,) float64: the nearest doubles; inf for what has no bounds."""
        return np.array([np.inf if v is None else float(v) for v in self.exact_volumes], dtype=np.float64)

    def volume(self, i: int) -> Fraction | None:
        """Of region i, exactly; None if it has no bounds."""
        return self._arrays.volume(_number(i, len(self)))


@dataclass(frozen=True)
class Component:
    """What the cells of one component have in common: a region of a group, its entities, or a component of CNRG."""

    number: int
    """from 1"""
    name: str
    material: str
    """"" if it has none"""
    leaves: tuple[str, ...]
    """with a region there"""
    volume: Fraction | None
    """exact, in cubic units; None: unbounded"""
    attributes: Mapping[str, Fraction | str] = field(default_factory=dict, repr=False, hash=False)
    """what else is said of it, numbers exactly, in the units that the tree has them in"""


@dataclass(frozen=True)
class Said:
    """What people say of a region, a component, a sheet, a wire or a point."""

    name: str
    """"" if it has none"""
    material: str
    """"" if it has none"""
    attributes: Mapping[str, Fraction | str] = field(hash=False)
    """by key: numbers exactly, in the units that the tree has them in, or texts"""


class SaidTable(Sequence[Said]):
    """All that is said of cells, each different thing once; `said` of cells has places in it."""

    __slots__ = ("_said", "_columns")

    def __init__(self, data: Any):
        said, columns = data
        self._said = tuple(Said(*one) for one in said)
        self._columns = columns

    def __len__(self) -> int:
        return len(self._said)

    @overload
    def __getitem__(self, i: int) -> Said: ...
    @overload
    def __getitem__(self, i: slice) -> tuple[Said, ...]: ...
    def __getitem__(self, i: Any) -> Any:
        return self._said[i] if isinstance(i, slice) else self._said[_number(i, len(self))]

    def values(self, key: str, said: Ints) -> list[Fraction | str | None]:
        """Of each cell the attribute of this key, exactly; None where it has none. said: of these cells."""
        of = [one.attributes.get(key) for one in self._said] + [None]  # the last for -1
        places: Any = said.tolist()
        return [of[place] for place in places]

    def _tags(self, said: Ints, dimension: Ints | int) -> dict[str, Any]:
        """Cell data as of a .vtu: numbers as (n,) float64, NaN where there is none; texts, and the names of cells of
        dimension < 3, as (n,) int32, 0 where there is none."""
        tags: dict[str, Any] = {}
        for array, texts, values in self._columns:
            none: Any = np.int32(0) if texts else np.float64(np.nan)
            of = np.append(values, none)[said]
            tags[array] = np.where(np.asarray(dimension) == 3, none, of) if array == "name" else of
        return tags

    @property
    def texts(self) -> dict[str, list[str]]:
        """Of the cell data of to_meshio and to_vtk that hold numbers of texts, by array: the text of each number; that
        of 0, where there is none, is empty."""
        return {array: ["", *texts] for array, texts, _ in self._columns if texts}

    def __repr__(self) -> str:
        return repr(self._said)


def _number(i: Any, count: int) -> int:
    i = operator.index(i)
    if not -count <= i < count:
        raise IndexError(f"there are {count} of them, numbered from 0, and this is none: {i}")
    return i % count
