"""Words that people bring from other packages, and what says the same here: an attribute that does not exist is told
with its remedy."""

from __future__ import annotations

import difflib

_SHOWN = "result.plot(), result.view() as a page, result.picture()"
_WRITTEN = "result.write(path)"
_TAKEN = "cnrg.mesh(mesh), or the mesh itself as an operand"
_POINTS = "of a result that is convex, points are result.exact_points"
_REMEDIES = {
    "apply_transform": "a.transform(matrix)",
    "ball": "cnrg.sphere(center, radius)",
    "chamfer": "no operator; subtract what is to go, or cnrg.load a CAD model",
    "cube": "cnrg.box(size=..., center=...)",
    "cut": "a - b",
    "euler_number": "result.topology().euler",
    "export": _WRITTEN,
    "fillet": "no operator; give the profile of cnrg.extrude or cnrg.revolve arcs, or cnrg.load a CAD model",
    "from_meshio": _TAKEN,
    "from_pyvista": _TAKEN,
    "from_trimesh": _TAKEN,
    "fuse": "a | b",
    "genus": "result.topology().betti[1], of a solid",
    "hull": "cnrg.hull(points); " + _POINTS,
    "is_manifold": "result.topology().manifold",
    "is_watertight": "result.topology().manifold; regions are closed always",
    "minkowski_sum": "cnrg.minkowski(points, points); " + _POINTS,
    "move": "a.translate(vector)",
    "offset": "cnrg.minkowski(points, points), of what is convex",
    "open": "cnrg.read(path) of a tree, cnrg.load(path) of a mesh, a CAD model or a result",
    "save": _WRITTEN,
    "show": _SHOWN,
    "symmetric_difference": "a ^ b",
    "to_dolfinx": '.write("model.xdmf")',
    "to_gmsh": '.write("model.msh")',
    "wrap": _TAKEN,
}


def missing(owner: str, name: str, known: type | list[str], other: type | None = None, by: str = "") -> AttributeError:
    """The error of `owner` for a word that is none of `known`; `other` may have it, which one comes to `by` that."""
    if name.startswith("__"):
        return AttributeError(f"{owner} has no {name!r}")
    names = known if isinstance(known, list) else dir(known)
    near = difflib.get_close_matches(name, names, 1)
    if other is not None and hasattr(other, name):
        remedy = by + name
    elif name in _REMEDIES:
        remedy = _REMEDIES[name]
    else:
        remedy = f"did you mean {near[0]!r}?" if near else "see its help()"
    return AttributeError(f"{owner} has no {name!r}: {remedy}")
