"""Exact Booleans of solids with several regions, surfaces, wires and points in one model.

    import cnrg

    ground = cnrg.box([0, 0, 0], [100, 100, 60], material="rock")
    fault = cnrg.polygon([[20, -5, -5], [70, -5, 65], [70, 105, 65], [20, 105, -5]])
    tunnel = cnrg.cylinder([60, -5, 30], [60, 105, 30], 6, segments=48)
    model = cnrg.union(fault & ground, ground, dominance="left") - tunnel
    result = model.evaluate()
    result.write("slope.vtu")

A node is an expression, as a tree file has it, and means the same. Everything is computed in exact arithmetic.
"""

import typing as _typing

from . import habits as _habits
from ._cnrg import __version__
from .cells import Cells, Component, Edges, Faces, Lists, Region, Regions, Said, SaidTable, Vertices
from .errors import Error, FileError, InputError, InvariantError, Notice, Stopped
from .evaluation import Certificate, Diagnostic, Evaluation, Row, UncertainPlace, evaluate
from .nodes import (
    Material,
    Node,
    aggregate,
    above,
    below,
    complement,
    difference,
    intersection,
    layers,
    material,
    product,
    subtract,
    union,
)
from .nodes import sum as sum
from .pictures import View
from .result import Places, Result
from .shapes import (
    bezier,
    box,
    bspline,
    cone,
    coons,
    cylinder,
    disk,
    extrude,
    group,
    halfspace,
    heightfield,
    hull,
    load,
    loft,
    mesh,
    minkowski,
    plane,
    points,
    polygon,
    polyline,
    prism,
    pyramid,
    revolve,
    sphere,
    sweep,
    tetrahedron,
    torus,
)
from .stories import Comparison, Explanation, Selectable, Step, Topology
from .surface import Meshed, SurfaceMesh
from .tetrahedra import Filled, Simplices, Tetrahedra
from .tree import Tree, parse, read

# Name by name: checkers of types take no other names for those of users. `import *` hides nothing of Python: cnrg.sum.
__all__ = [
    "__version__",
    "Cells",
    "Certificate",
    "Comparison",
    "Component",
    "Diagnostic",
    "Edges",
    "Error",
    "Evaluation",
    "Explanation",
    "Faces",
    "FileError",
    "Filled",
    "InputError",
    "InvariantError",
    "Lists",
    "Material",
    "Meshed",
    "Node",
    "Notice",
    "Places",
    "Region",
    "Regions",
    "Result",
    "Row",
    "Said",
    "SaidTable",
    "Simplices",
    "Step",
    "Stopped",
    "SurfaceMesh",
    "Tetrahedra",
    "Selectable",
    "Topology",
    "Tree",
    "UncertainPlace",
    "Vertices",
    "View",
    "aggregate",
    "bezier",
    "box",
    "bspline",
    "above",
    "below",
    "complement",
    "cone",
    "coons",
    "cylinder",
    "difference",
    "disk",
    "evaluate",
    "extrude",
    "group",
    "halfspace",
    "heightfield",
    "hull",
    "intersection",
    "layers",
    "load",
    "loft",
    "material",
    "mesh",
    "minkowski",
    "parse",
    "plane",
    "points",
    "polygon",
    "polyline",
    "prism",
    "product",
    "pyramid",
    "read",
    "revolve",
    "sphere",
    "subtract",
    "sweep",
    "tetrahedron",
    "torus",
    "union",
]


if not _typing.TYPE_CHECKING:  # a checker knows itself what there is

    def __getattr__(name):
        raise _habits.missing("cnrg", name, __all__)
