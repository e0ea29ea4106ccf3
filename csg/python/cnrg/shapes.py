"""Leaves: shapes with the keys that they have in a tree file.

All of them take attributes, too: material, name, size, dominance, translate, rotate, scale, mirror, regularize, simplify
(see Node.with_). Lengths are in the unit of the model, angles in degrees. Numbers are exact (nodes.Number). A key that
is not given has the default of the tree file.
"""

from __future__ import annotations

import os
from fractions import Fraction
from typing import Any, Mapping, Sequence, overload

from . import _cnrg, convert
from .errors import InputError
from .operands import Operand
from .nodes import MeshArrays, Node, Number, Point, _attributes, _exactly, data_of, exact, fault, leaf, made

Loop = Sequence[Point]


def _optional(value: Any) -> Any:
    return None if value is None else _exactly(value)


def _line(value: Any) -> Any:
    """A line of corners and curves: points are numbers, the words of curves are their keys."""
    return _optional(value)


@overload
def box(min: Point, max: Point, **attributes: Any) -> Node: ...  # noqa: A002
@overload
def box(
    min: Point | None = None, *, size: Number | Point, center: Point | bool | None = None, **attributes: Any  # noqa: A002
) -> Node: ...
def box(
    min: Point | None = None,  # noqa: A002
    max: Point | None = None,  # noqa: A002
    *,
    size: Number | Point | None = None,
    center: Point | bool | None = None,
    **attributes: Any,
) -> Node:
    """A box from its least to its greatest corner. Faces 0 to 5: least x, greatest x, least y, ..., greatest z.

    Or by its size, one number or three: from `min`, else from the origin; with a `center` around that point, with
    center=True around the origin.
    """
    if size is None:
        if min is None or max is None or center is not None:
            raise TypeError("box: give min and max, or size and where wanted min or center")
        return leaf("box", {"min": _exactly(min), "max": _exactly(max)}, attributes)
    if max is not None or (min is not None and center is not None):
        raise TypeError("box: with a size give min or center, or none of them")
    sides = _exactly(size)
    sides = [Fraction(x) for x in (sides if isinstance(sides, list) else [sides] * 3)]
    about = None if center is None or center is False else [0, 0, 0] if center is True else _exactly(center)
    corner = [Fraction(x) for x in (about if about is not None else [0, 0, 0] if min is None else _exactly(min))]
    if len(sides) != 3 or len(corner) != 3:
        raise fault("box: three numbers are wanted, or one for the size of a cube")
    if about is not None:
        corner = [x - s / 2 for x, s in zip(corner, sides)]
    return leaf("box", {"min": _exactly(corner), "max": _exactly([x + s for x, s in zip(corner, sides)])}, attributes)


def prism(
    base: Loop,
    vector: Point,
    *,
    holes: Sequence[Loop] | None = None,
    fit: Number | None = None,
    **attributes: Any,
) -> Node:
    """A simple polygon in a plane (face 0), with holes, moved along a vector out of that plane (face 1).

    `fit`: corners that lie between two planes this far apart move onto one.
    """
    keys = {"base": _exactly(base), "holes": _optional(holes), "vector": _exactly(vector), "fit": _optional(fit)}
    return leaf("prism", keys, attributes)


def pyramid(base: Loop, apex: Point, *, fit: Number | None = None, **attributes: Any) -> Node:
    """A simple polygon in a plane (face 0) and a point off it; `fit` as of a prism."""
    return leaf("pyramid", {"base": _exactly(base), "apex": _exactly(apex), "fit": _optional(fit)}, attributes)


def tetrahedron(a: Point, b: Point, c: Point, d: Point, **attributes: Any) -> Node:
    """Four points that are not in one plane."""
    return leaf("tetrahedron", _exactly([a, b, c, d]), attributes)


def hull(points: Loop, *others: Any, **attributes: Any) -> Node:
    """The convex hull of points that are not all in one plane, a face for each of its planes."""
    if others or isinstance(points, Operand):
        raise TypeError("hull: a list of points is wanted; those of nodes: cnrg.hull([*a.evaluate().exact_points, ...])")
    return leaf("hull", _exactly(points), attributes)


def minkowski(*summands: Loop, **attributes: Any) -> Node:
    """All sums of a point of the convex hull of each list of points; two lists or more."""
    return leaf("minkowski", _exactly(list(summands)), attributes)


def polygon(
    outer: Loop, *, holes: Sequence[Loop] | None = None, fit: Number | None = None, **attributes: Any
) -> Node:
    """A surface: a simple polygon, exactly in a plane, with holes; `fit` as of a prism."""
    return leaf("polygon", {"outer": _exactly(outer), "holes": _optional(holes), "fit": _optional(fit)}, attributes)


def disk(
    center: Point,
    radii: Sequence[Number],
    *,
    normal: Point | None = None,
    along: Point | None = None,
    dip: Number | None = None,
    strike: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """A flat ellipse of `segments` corners (32), by its normal, or by dip and strike in degrees.

    The first radius is along `along`, or the strike; dip goes down to the right of the strike, an angle from y to x.
    """
    keys = {"center": _exactly(center), "radii": _exactly(list(radii)), "normal": _optional(normal)}
    keys.update(along=_optional(along), dip=_optional(dip), strike=_optional(strike), segments=_optional(segments))
    return leaf("disk", keys, attributes)


def polyline(points: Loop, *, closed: bool | None = None, **attributes: Any) -> Node:
    """A wire through two points or more; closed: it goes back to the first."""
    return leaf("polyline", {"points": _exactly(points), "closed": closed}, attributes)


def points(points: Sequence[Point], **attributes: Any) -> Node:
    """Points by themselves, one or more."""
    return leaf("points", _exactly(points), attributes)


def plane(point: Point, normal: Point, **attributes: Any) -> Node:
    """A whole plane as a surface; its front looks along the normal."""
    return leaf("plane", {"point": _exactly(point), "normal": _exactly(normal)}, attributes)


def halfspace(point: Point, normal: Point, **attributes: Any) -> Node:
    """All that is behind a plane, away from its normal."""
    return leaf("halfspace", {"point": _exactly(point), "normal": _exactly(normal)}, attributes)


def sphere(
    center: Point, radius: Number, *, segments: int | None = None, rings: int | None = None, **attributes: Any
) -> Node:
    """A ball with `segments` meridians (32) and `rings` bands from pole to pole (half of that)."""
    keys = {"center": _exactly(center), "radius": exact(radius), "segments": _optional(segments)}
    return leaf("sphere", {**keys, "rings": _optional(rings)}, attributes)


def cylinder(from_: Point, to: Point, radius: Number, *, segments: int | None = None, **attributes: Any) -> Node:
    """Between the centres of its caps (faces 0 and 1); the side is face 2, of `segments` (32) facets."""
    keys = {"from": _exactly(from_), "to": _exactly(to), "radius": exact(radius), "segments": _optional(segments)}
    return leaf("cylinder", keys, attributes)


def cone(
    from_: Point,
    to: Point,
    radius: Number,
    *,
    top: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """Faces as of a cylinder, `radius` at `from_` and `top` (0) at `to`; where a radius is 0 there is no cap."""
    keys = {"from": _exactly(from_), "to": _exactly(to), "radius": exact(radius), "top": _optional(top)}
    return leaf("cone", {**keys, "segments": _optional(segments)}, attributes)


def torus(
    center: Point,
    axis: Point,
    radius: Number,
    tube: Number,
    *,
    segments: int | None = None,
    rings: int | None = None,
    **attributes: Any,
) -> Node:
    """A ring: `radius` from the centre to the middle of the tube, `tube` the tube's own, less than that."""
    keys = {"center": _exactly(center), "axis": _exactly(axis), "radius": exact(radius), "tube": exact(tube)}
    return leaf("torus", {**keys, "segments": _optional(segments), "rings": _optional(rings)}, attributes)


def extrude(
    vector: Point,
    *,
    profile: Any = None,
    curve: Any = None,
    twist: Number | None = None,
    scale: Number | None = None,
    center: Point | None = None,
    chord: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """A profile (closed line, or {"outer": line, "holes": [line]}: a solid) or a curve (open line: a surface) swept
    along a vector, meanwhile turned by `twist` degrees and scaled to `scale` about the axis through `center`.

    A line is a list of corners, and between two of them may stand {"bezier": [inner control points], "weights": [...]}.
    The scaling here is that of the sweep; to scale the node use .scale(...).
    """
    keys = {"profile": _line(profile), "curve": _line(curve), "vector": _exactly(vector), "twist": _optional(twist)}
    keys.update(scale=_optional(scale), center=_optional(center), chord=_optional(chord), segments=_optional(segments))
    return leaf("extrude", keys, attributes)


def revolve(
    *,
    profile: Any = None,
    curve: Any = None,
    center: Point | None = None,
    axis: Point | None = None,
    degrees: Number | None = None,
    chord: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """A profile or a curve of points [r, z], r from the axis and z along it, turned about the axis by `degrees` (360)."""
    keys = {"profile": _line(profile), "curve": _line(curve), "center": _optional(center), "axis": _optional(axis)}
    keys.update(degrees=_optional(degrees), chord=_optional(chord), segments=_optional(segments))
    return leaf("revolve", keys, attributes)


def sweep(
    profile: Any,
    path: Sequence[Point],
    *,
    radius: Number | None = None,
    chord: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """A profile (as of `extrude`) along a path at right angles to it, its bends round with a radius, else mitred."""
    keys = {"profile": _line(profile), "path": _exactly(path), "radius": _optional(radius)}
    return leaf("sweep", {**keys, "chord": _optional(chord), "segments": _optional(segments)}, attributes)


def loft(profiles: Sequence[Any], *, chord: Number | None = None, segments: int | None = None, **attributes: Any) -> Node:
    """Straight lines from each profile to the next; all have equal numbers of segments."""
    keys = {"profiles": _exactly(list(profiles)), "chord": _optional(chord), "segments": _optional(segments)}
    return leaf("loft", keys, attributes)


def _net(operator: str, keys: Mapping[str, Any], fill: str | None, attributes: Mapping[str, Any]) -> Node:
    return leaf(operator, {**{key: _optional(value) for key, value in keys.items()}, "fill": fill}, attributes)


def bezier(
    *,
    patch: Any = None,
    patches: Any = None,
    curve: Any = None,
    curves: Any = None,
    fill: str | None = None,
    chord: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """Bézier patches (rows of control points, or {"points": rows, "weights": rows}) and curves (control points, or a
    map). With fill "winding", "parity" or "cells" patches that share sides make a solid."""
    keys = {"patch": patch, "patches": patches, "curve": curve, "curves": curves, "chord": chord, "segments": segments}
    return _net("bezier", keys, fill, attributes)


def bspline(
    *,
    patch: Any = None,
    patches: Any = None,
    curve: Any = None,
    curves: Any = None,
    fill: str | None = None,
    chord: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """B-spline patches and curves: maps with "points", "degree", and "knots" and "weights" if wanted."""
    keys = {"patch": patch, "patches": patches, "curve": curve, "curves": curves, "chord": chord, "segments": segments}
    return _net("bspline", keys, fill, attributes)


def coons(
    *,
    patch: Any = None,
    patches: Any = None,
    fill: str | None = None,
    chord: Number | None = None,
    segments: int | None = None,
    **attributes: Any,
) -> Node:
    """Coons patches: four Bézier curves each, that go round."""
    return _net("coons", {"patch": patch, "patches": patches, "chord": chord, "segments": segments}, fill, attributes)


def heightfield(
    heights: Any = None,
    *,
    file: str | os.PathLike[str] | None = None,
    origin: Sequence[Number] | None = None,
    spacing: Sequence[Number] | None = None,
    base: Number | None = None,
    within: Number | None = None,
    **attributes: Any,
) -> Node:
    """A terrain from rows of heights (rows along y, entries along x; an array of shape (ny, nx)), or from an ESRI
    ASCII grid. base: the solid down to that level; without it a surface. within: fewer points and larger triangles,
    nowhere farther than that above or below the surface over all points (units of the model)."""
    keys = {"heights": _optional(heights), "file": _path(file), "origin": _optional(origin)}
    return leaf("heightfield", {**keys, "spacing": _optional(spacing), "base": _optional(base), "within": _optional(within)}, attributes)


def _path(path: Any) -> str | None:
    if path is None:
        return None
    name = os.fspath(path)
    if not isinstance(name, str):
        raise TypeError("a path is wanted, a text")
    return data_of(os.path.abspath(name)) if name else ""


def mesh(
    points: Any,
    faces: Any = None,
    *,
    fill: str | None = None,
    weld: Number | None = None,
    fit: Number | None = None,
    **attributes: Any,
) -> Node:
    """A mesh from arrays, or from one object: of trimesh (`.vertices`, `.faces`), PolyData of PyVista, or a mesh of
    meshio, of whose cells triangles, quadrilaterals and polygons are taken.

    points: (n, 3), of any float or integer type; each is taken exactly. faces: (m, 3) or (m, k) numbers of points from
        0, or a list of polygons of different sizes; counter-clockwise as seen from outside.
    fill: "winding" (closed and oriented alike; the default where it is so), "parity", "cells" or "none" (a surface).
    weld: what is nearer is made to coincide; fit: corners of faces, and faces, that lie between two planes this far
        apart move onto one.

    The arrays are copied, since a node never changes. Equal points are one.
    """
    import numpy

    if isinstance(points, Operand):
        raise TypeError("mesh: a result is an operand itself, and result.node the leaf of it")
    if faces is None:
        points, faces = convert.arrays_of(points)
    xyz = numpy.asarray(points)
    if xyz.dtype.kind not in "iuf":
        raise TypeError(f"mesh: points must be an array of numbers, not of {xyz.dtype}")
    doubles = numpy.ascontiguousarray(xyz, dtype=numpy.float64)
    if xyz.dtype.itemsize > 8 or (xyz.dtype.kind != "f" and xyz.dtype.itemsize == 8):
        if not (doubles.astype(xyz.dtype) == xyz).all():
            raise fault("mesh: a coordinate has more digits than a double; give the mesh in a file, as decimals")
    if doubles.size == 0:
        doubles = doubles.reshape(0, 3)
    corners, offsets = _corners(numpy, faces)
    keys: dict[str, Any] = {}
    if fill is not None:
        keys["fill"] = data_of(fill)
    if weld is not None:
        keys["weld"] = exact(weld)
    if fit is not None:
        keys["fit"] = exact(fit)
    try:
        arrays = _cnrg.MeshData(doubles, corners, offsets)
    except InputError as e:
        raise fault(e.message) from None
    return made("mesh", (), MeshArrays(arrays, keys), _attributes(attributes, ("fill", "weld", "fit")))


def _corners(numpy: Any, faces: Any) -> tuple[Any, Any]:
    """Corners of all faces in a row, and where each begins."""
    array = faces if isinstance(faces, numpy.ndarray) else None
    if array is None:
        try:
            array = numpy.asarray(faces)
        except ValueError:  # polygons of different sizes
            array = None
    if array is not None and array.ndim == 2 and array.dtype.kind in "iu":
        m, k = array.shape
        flat, offsets = array.reshape(-1), numpy.arange(m + 1, dtype=numpy.int64) * k
    elif array is not None and array.size == 0:
        flat, offsets = numpy.zeros(0, numpy.int64), numpy.zeros(1, numpy.int64)
    else:
        rows = [numpy.asarray(face) for face in faces]
        if any(row.ndim != 1 or (row.size > 0 and row.dtype.kind not in "iu") for row in rows):
            raise TypeError("mesh: faces must be an array of whole numbers, or a list of lists of them")
        offsets = numpy.concatenate([[0], numpy.cumsum([row.size for row in rows])]).astype(numpy.int64)
        flat = numpy.concatenate(rows) if rows else numpy.zeros(0, numpy.int64)
    if flat.dtype.kind == "u" and flat.size > 0 and flat.max() > 2**62:
        raise fault(f"mesh: a face names the point {flat.max()}, which is not there")
    return numpy.ascontiguousarray(flat, dtype=numpy.int64), numpy.ascontiguousarray(offsets, dtype=numpy.int64)


_CAD = {".step": "step", ".stp": "step", ".brep": "brep"}
_NUMBERS = ("chord", "segments", "weld", "fit", "base")


def load(path: str | os.PathLike[str], **keys: Any) -> Node:
    """A leaf from a file, by its extension: meshes (.off .obj .stl .ply .vtp .vtu .vtk .msh .glb .3mf .ts .pl .wl), CAD models (.step .stp
    .brep), grids of heights (.asc), results (.json of `Result.write`), OpenSCAD (.csg). The path is relative to the current folder. keys:
    those of the leaf in a tree file (fill, weld, fit, chord, segments, unit, solids, seams, coordinates, base), and
    attributes."""
    name = _path(path)
    if not name:
        raise fault("load: the name of the file is empty")
    extension = os.path.splitext(name)[1].lower()
    own = {}
    for key in ("fill", "weld", "fit", "chord", "segments", "unit", "solids", "seams", "coordinates", "base"):
        value = keys.pop(key, None)
        if value is not None:
            own[key] = exact(value) if key in _NUMBERS else data_of(value)
    if extension in (".json", ".csg"):
        if own:
            raise TypeError(f"load: a {extension} file has no {next(iter(own))!r}")
        return leaf("cnrg" if extension == ".json" else "csg", name, keys)
    operator = _CAD.get(extension) or ("heightfield" if extension == ".asc" else "mesh")
    return leaf(operator, {"file": name, **own}, keys)


def group(
    vertices: Sequence[Point],
    *,
    faces: Sequence[Any] | None = None,
    edges: Sequence[Sequence[int]] | None = None,
    points: Sequence[int] | None = None,
    regions: Mapping[Any, Any] | None = None,
    fill: str | None = None,
    **attributes: Any,
) -> Node:
    """Regions, faces, wires and points one by one.

    faces: {"loops": [[0, 1, 2]], "sides": [front, back]}, by numbers of vertices; or just a list of numbers, a face
    with one loop. regions: {1: {"name": "a", "material": "rock"}}, by the numbers that `sides` have.
    """
    keys: dict[str, Any] = {"vertices": _exactly(vertices)}
    if faces is not None:
        keys["faces"] = [
            _exactly(face) if isinstance(face, Mapping) else {"loops": [_exactly(face)]} for face in faces
        ]
    if regions is not None:
        keys["regions"] = {str(number): data_of(region) for number, region in regions.items()}
    keys.update(edges=_optional(edges), points=_optional(points), fill=fill)
    return leaf("group", keys, attributes)
