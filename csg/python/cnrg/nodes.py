"""Nodes of a tree as Python values.

A node is an expression: a shape, or an operator on nodes, with attributes. It never changes, so it may be used in any
number of trees and by any number of users; what would change it makes another one. What a tree file can say an
expression can, by the same words, since it is turned into the text of such a file and read by the same reader. That
reader looks at each node as soon as it is made, so a fault is raised where the mistake is, not where the tree is
evaluated.
"""

from __future__ import annotations

import difflib
import os
import re
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Sequence, Union

from . import _cnrg
from .errors import InputError
from .habits import missing
from .operands import Operand, as_nodes
from .place import Site, fault, site_of_caller

if TYPE_CHECKING:
    from .evaluation import Evaluation
    from .result import Result

Number = Union[int, float, str, Fraction, Decimal]
"""Exact: a float is that double, a str is a decimal or a fraction such as "0.1" or "1/3". Numbers of numpy, too."""
Point = Sequence[Number]
"""Three numbers: a tuple, a list, an array of numpy."""

_PLAIN = re.compile(r"(?:[A-Za-z_][A-Za-z0-9_]*|[-+]?\.?[0-9][0-9A-Za-z./+-]*)\Z")
_WORDS = {"true", "false", "null", "yes", "no", "on", "off", "y", "n"}  # some reader of YAML takes these for no text


class Exact(str):
    """The text of a number, which stands in a tree without quotes."""

    __slots__ = ()


class Text(str):
    """A text that stands in a tree in quotes, since without them it might be a number."""

    __slots__ = ()


def quoted(text: str) -> str:
    """A text as YAML has it; InputError for one that is not Unicode."""
    try:
        text.encode()
    except UnicodeEncodeError:
        raise fault(f"the text {text!a} is not Unicode: it has half of a character; mend it") from None
    if not isinstance(text, Text) and _PLAIN.match(text) and text.lower() not in _WORDS:
        return text
    escaped = []
    for c in text.replace("${", "$${"):  # no expression
        if c in '"\\':
            escaped.append("\\" + c)
        elif c.isprintable() or c == " ":
            escaped.append(c)
        else:
            code = ord(c)
            escaped.append(f"\\x{code:02x}" if code < 256 else f"\\u{code:04x}" if code < 65536 else f"\\U{code:08x}")
    return '"' + "".join(escaped) + '"'


def exact(value: Any) -> Exact:
    """The exact text of a number: the shortest decimal of a float where that is the same number, else a fraction."""
    if type(value) is float and value == value and abs(value) != float("inf"):
        text = repr(value)
        if Fraction(text) == Fraction(value):
            return Exact(text[:-2] if text.endswith(".0") else text)
    try:
        return Exact(_cnrg.number_text(value))
    except InputError as e:
        raise fault(e.message) from None


def data_of(value: Any) -> Any:
    """A value of a key as maps, lists, bools, texts and exact numbers. TypeError for what a tree cannot say."""
    if isinstance(value, (bool, Exact)) or value is None:
        return value
    if isinstance(value, str):
        quoted(value)
        return str(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {str(key): data_of(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [data_of(item) for item in value]
    if hasattr(value, "tolist") and hasattr(value, "dtype"):  # of numpy
        if value.ndim == 0:
            return exact(value[()])
        is_long = value.dtype.kind == "f" and value.dtype.itemsize > 8  # as a list it would lose digits
        return data_of(list(value) if is_long else value.tolist())
    if isinstance(value, Iterable) and not isinstance(value, (bytes, bytearray)):
        return [data_of(item) for item in value]
    return exact(value)


def text_of(data: Any) -> str:
    """Data as YAML, on one line."""
    if data is True:
        return "true"
    if data is False:
        return "false"
    if data is None:
        return "null"
    if isinstance(data, Exact):
        return str(data)
    if isinstance(data, str):
        return quoted(data)
    if isinstance(data, dict):
        return "{" + ", ".join(f"{quoted(key)}: {text_of(item)}" for key, item in data.items()) + "}"
    return "[" + ", ".join(text_of(item) for item in data) + "]"


class Material:
    """A material, constant or graded; `material` makes one. Two of one name in one tree must say the same."""

    __slots__ = ("name", "data", "to", "site", "mixed")

    def __init__(self, name: str, data: dict[str, Any], to: Node | None, site: Site, mixed: Iterable[Material] = ()):
        self.name = name
        self.data = data  # without the node in `distance`, which is `to`
        self.to = to
        self.site = site
        self.mixed = tuple(mixed)  # the materials that stops name as such, not by a text

    def __repr__(self) -> str:
        return f"cnrg.material({self.name!r})"


def material(
    name: str,
    color: str | None = None,
    *,
    linear: Mapping[str, Any] | None = None,
    distance: Mapping[str, Any] | None = None,
    dominance: Number | None = None,
) -> Material:
    """A material of regions.

    color: "#rrggbb", for pictures and files.
    linear: {"from": point, "to": point, "stops": [[0, "a"], [1, {"a": "1/2", "b": "1/2"}]]}: graded along a line.
    distance: {"to": node, "stops": [...]}: graded by the distance to the faces, wires and points of a node.
    dominance: who wins where two materials meet and the numbers of the operands are equal; 0 without it.
    In stops a material is a name or another `material(...)`, which may be graded itself.
    """
    if not isinstance(name, str):
        raise TypeError(f"material: a name is wanted, not {type(name).__name__}")
    data: dict[str, Any] = {}
    to = None
    mixed: list[Material] = []

    def named(item: Any) -> Any:
        """Materials in stops by their names."""
        if isinstance(item, Material):
            mixed.append(item)
            return item.name
        if isinstance(item, Mapping):
            return {named(key): named(part) for key, part in item.items()}
        return [named(part) for part in item] if isinstance(item, (list, tuple)) else item

    if color is not None:
        data["color"] = data_of(color)
    if dominance is not None:
        data["dominance"] = exact(dominance)
    if linear is not None:
        data["linear"] = data_of(named(linear))
    if distance is not None:
        if not isinstance(distance, Mapping) or not isinstance(distance.get("to"), Node):
            raise TypeError('material: distance is a map {"to": node, "stops": [...]}')
        to = distance["to"]
        data["distance"] = data_of(named({key: item for key, item in distance.items() if key != "to"}))
    from .tree import check_material

    made = Material(name, data, to, site_of_caller(), mixed)
    check_material(made)
    return made


class MeshArrays:
    """The arrays of a mesh in a tree: `mesh: {points, faces, ...}`."""

    __slots__ = ("arrays", "keys")

    def __init__(self, arrays: Any, keys: dict[str, Any]):
        self.arrays = arrays
        self.keys = keys


class Picked:
    """What `select` picks: criteria by their keys in a tree; the nodes below that it names, by key, too (`from`, `front
    of`, `behind`); and how many operands behind the first one are those of `inside`; the others are those of
    `touching`. `materials`: those that are given as such, and not by name."""

    __slots__ = ("criteria", "sources", "inside", "materials")

    def __init__(
        self,
        criteria: Mapping[str, Any],
        sources: Mapping[str, Iterable[Node]],
        inside: int,
        materials: Iterable[Material] = (),
    ):
        self.criteria = dict(criteria)
        self.materials = tuple(materials)
        self.sources = {key: tuple(nodes) for key, nodes in sources.items()}
        self.inside = inside


class Node(Operand):
    """A node of a tree: a leaf or an operator, with its attributes.

    Operators: `a | b` union, `a & b` intersection, `a - b` difference (of groups, by the tables of Pereira et al.),
    `~a` complement; functions `union`, `sum` and the others take more operands and `dominance`. Transforms and
    attributes make a new node.
    """

    __slots__ = ("operator", "operands", "value", "attributes", "key", "is_inline", "site", "__weakref__")

    operator: str
    operands: tuple[Node, ...]
    value: Any  # of a leaf: data, or MeshArrays; of `simplify`: `mode` and `within`, or None
    attributes: tuple[tuple[str, Any], ...]  # in their order: transforms act one after the other
    key: str | None  # in a tree; None: any
    is_inline: bool  # it stands in the place of its user, as it did in a file
    site: Site  # where it was made

    def __init__(
        self,
        operator: str,
        operands: Iterable[Node] = (),
        value: Any = None,
        attributes: Iterable[tuple[str, Any]] = (),
        *,
        key: str | None = None,
        is_inline: bool = False,
        site: Site | None = None,
    ):
        put = super().__setattr__
        put("operator", operator)
        put("operands", tuple(operands))
        put("value", value)
        put("attributes", tuple(attributes))
        put("key", key)
        put("is_inline", is_inline)
        put("site", site or site_of_caller())

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("a node does not change; make another one, such as by .with_(...)")

    def __delattr__(self, name: str) -> None:
        self.__setattr__(name, None)

    def __repr__(self) -> str:
        words = f"{self.operator} of {len(self.operands)}" if self.operands else self.operator
        return f"<cnrg.Node {self.key!r}: {words}>" if self.key else f"<cnrg.Node: {words}>"

    def __reduce__(self) -> Any:
        return _again, (self.operator, self.operands, self.value, self.attributes, self.key, self.is_inline, self.site)

    def __copy__(self) -> Node:
        return self

    def __deepcopy__(self, memo: Any) -> Node:
        return self

    if not TYPE_CHECKING:  # a checker knows itself what there is

        def __getattr__(self, name):
            from .result import Result

            raise missing("a node", name, Node, Result, "it is of the result, node.evaluate().")

    def __invert__(self) -> Node:
        """The complement."""
        return self.complement()

    # Operators on one value.

    def complement(self) -> Node:
        """All of space that is not in it."""
        return made("complement", (self,))

    def interior(self, each: bool = False) -> Node:
        """The interior of the point set; with `each`, of every component by itself."""
        return made("interior", (self,), attributes=_each(each))

    def closure(self, each: bool = False) -> Node:
        """The closure; with `each`, of every component by itself."""
        return made("closure", (self,), attributes=_each(each))

    def boundary(self, each: bool = False) -> Node:
        """The boundary; with `each`, of every component by itself."""
        return made("boundary", (self,), attributes=_each(each))

    def regularize(self, each: bool = False) -> Node:
        """The closure of the interior: no sheets, wires, points, cracks; with `each`, of every component by itself."""
        return made("regularize", (self,), attributes=_each(each))

    def unify(self) -> Node:
        """One component of all."""
        return made("unify", (self,))

    def simplify(self, mode: str = "features", *, within: Number | None = None) -> Node:
        """Fewest cells; mode "points" forgets features, too: what is coplanar or collinear is one.

        within: what does not touch and is nearer than this (units, above 0) is joined; what met and how far it moved
        is told by the notices of the evaluation.
        """
        if mode not in ("features", "points"):
            raise fault(f"simplify: the mode is features or points, not {mode!r}")
        keys: dict[str, Any] = {"mode": "points"} if mode == "points" else {}
        if within is not None:
            keys["within"] = exact(within)
        return made("simplify", (self,), keys or None)

    def select(
        self,
        *,
        dimension: int | Iterable[int] | None = None,
        name: str | Iterable[str] | None = None,
        material: str | Material | Iterable[str | Material] | None = None,
        attributes: Mapping[str, Any] | None = None,
        region: str | int | Iterable[str | int] | None = None,
        front_of: Node | Iterable[Node] | None = None,
        behind: Node | Iterable[Node] | None = None,
        from_: Node | Iterable[Node] | None = None,
        source_face: int | Iterable[int] | None = None,
        between: Iterable[Any] | None = None,
        inside: Node | Iterable[Node] | None = None,
        touching: Node | Iterable[Node] | None = None,
    ) -> Node:
        """What of it is picked: cells for which all that is given holds; of several values one suffices.

        dimension: 3 regions, 2 faces, 1 edges, 0 vertices. name, material, attributes: of regions and of what stands
        for itself, sheets, wires, points; a material that only a file has is given as `cnrg.material(NAME)`. region: the cell is, bounds or lies in a region of that name or number.
        front_of, behind: that region is on this side of each of these surfaces, and not on the other side, too.
        from_: it came from that leaf, or from one below that node; source_face: from that face of the leaf. between:
        ("rock", "clay"), or several such pairs: a wall between regions of these names or materials; None is no region.
        inside: all of it is in that node's points; touching: it or its boundary has a point there.
        """
        criteria = {
            "dimension": dimension,
            "name": name,
            "material": material,
            "attributes": attributes,
            "region": region,
            "source face": source_face,
            "between": between,
        }
        below = {"from": ("from_", from_), "front of": ("front_of", front_of), "behind": ("behind", behind)}
        sources = {key: _listed(*nodes) for key, nodes in below.items()}
        within = _listed("inside", inside)
        one = material is None or isinstance(material, (str, Material))
        given = [m for m in ([material] if one else material) if isinstance(m, Material)]  # type: ignore[union-attr]
        picked = Picked({k: criterion(k, v) for k, v in criteria.items() if v is not None}, sources, len(within), given)
        return made("select", (self, *within, *_listed("touching", touching)), picked)

    # Attributes and transforms, as in a tree file.

    def with_(self, **attributes: Any) -> Node:
        """The same node with more attributes: material, name, attributes, size, dominance, translate, rotate, scale,
        mirror, matrix.

        material: a name or a `material(...)`. name: of its regions, sheets, wires and points. attributes: numbers and
        texts by keys of your own, `{"diameter": 25}`. size: how long edges of a mesh are to be on what comes from the
        leaves below (units of the model as it stands). dominance: a number, or of an operator "left", "right" or
        "equal". Transforms act after those that it has; any other attribute replaces the one of its name.
        """
        more = _attributes(attributes)
        if not more:
            return self
        mine = list(self.attributes)
        # A map has each key once, a named node goes on being itself, and a file is read once for all its places.
        costly = self.operator in _FILES or isinstance(self.value, MeshArrays)
        twice = any(name in _TRANSFORMS and any(n == name for n, _ in mine) for name, _ in more)
        if self.key is not None or self.is_inline or costly or twice:
            return made("simplify", (self,), None, more)
        replaced = {name for name, _ in more}
        kept = [(name, value) for name, value in mine if name not in replaced]
        return made(self.operator, self.operands, self.value, kept + more)

    def translate(self, vector: Point) -> Node:
        """Moved by a vector (units of the model)."""
        return self.with_(translate=vector)

    def rotate(self, axis: Point, degrees: Number | None = None, center: Point | None = None) -> Node:
        """Turned about an axis through `center` (the origin) by the right-hand rule. About coordinate axes multiples
        of 90 degrees are exact; any other angle is off by less than 1e-15, the rotation exactly orthogonal."""
        if degrees is None:
            raise TypeError("rotate: an axis and degrees are wanted, such as .rotate([0, 0, 1], 45); three angles are "
                            "three of these")
        turn: dict[str, Any] = {"axis": axis, "degrees": degrees}
        if center is not None:
            turn["center"] = center
        return self.with_(rotate=turn)

    def transform(self, matrix: Sequence[Sequence[Number]]) -> Node:
        """Moved by an affine map as other packages have it: four rows of four numbers, the last 0, 0, 0, 1; points are
        columns. InputError for a perspective."""
        rows = _exactly(matrix)
        if len(rows) == 4 and [Fraction(x) for x in rows[3]] == [0, 0, 0, 1]:
            return self.matrix(rows[:3])
        raise fault("transform: four rows of four numbers are wanted, the last [0, 0, 0, 1]; three rows: .matrix(rows)")

    def scale(self, factor: Number | Point) -> Node:
        """Scaled from the origin by a number or by three; none is 0."""
        return self.with_(scale=factor)

    def mirror(self, normal: Point, point: Point | None = None) -> Node:
        """Reflected in the plane through `point` (the origin) at right angles to `normal`."""
        plane: dict[str, Any] = {"normal": normal}
        if point is not None:
            plane["point"] = point
        return self.with_(mirror=plane)

    def matrix(self, rows: Sequence[Sequence[Number]]) -> Node:
        """Moved by an affine map: three rows of four numbers, the last of each added."""
        return self.with_(matrix=rows)

    def named(self, key: str) -> Node:
        """The same node under this name in trees: rows, messages and `Evaluation[...]` call it so, and so are the
        regions of a leaf that has no attribute `name`."""
        if not isinstance(key, str) or not key:
            raise TypeError("named: a name is wanted, a text that is not empty")
        quoted(key)
        return Node(self.operator, self.operands, self.value, self.attributes, key=key, site=site_of_caller())

    # What it means.

    def evaluate(self, **options: Any) -> Result:
        """The node's value, exactly: `cnrg.evaluate(self, **options).result`, and see there."""
        from .evaluation import evaluate

        return evaluate(self, **options).result

    def check(self) -> list[str]:
        """Checks all that can be checked without evaluating: leaves, the files that they read. Returns notices;
        raises InputError and FileError."""
        from .tree import Tree

        return Tree.of(self).check()

    def to_yaml(self, folder: str | os.PathLike[str] | None = None, *, weld: Number | None = None) -> str:
        """A tree file with this node as its result. Files that leaves read are named relative to `folder`, where the
        text is to lie; without it by absolute paths. The text gives the same result files, byte for byte."""
        from .tree import Tree

        return Tree.of(self, weld=weld).to_yaml(folder)


def _again(operator: str, operands: Any, value: Any, attributes: Any, key: Any, is_inline: bool, site: Site) -> Node:
    """A node that was pickled."""
    return Node(operator, operands, value, attributes, key=key, is_inline=is_inline, site=site)


_TRANSFORMS = ("translate", "rotate", "scale", "mirror", "matrix")
_FILES = ("mesh", "heightfield", "step", "brep", "cnrg", "csg")  # leaves that may read one
_ATTRIBUTES = (
    "material", "name", "attributes", "size", "dominance", "blend", "regularize", "simplify", "each",
) + _TRANSFORMS


def _each(each: bool) -> tuple[tuple[str, Any], ...]:
    return (("each", True),) if each else ()


def _attributes(given: Mapping[str, Any], keys: Iterable[str] = ()) -> list[tuple[str, Any]]:
    """Attributes as data, in their order; None is as if it were not given. `keys`: what else one could have meant."""
    out: list[tuple[str, Any]] = []
    for name, value in given.items():
        if name not in _ATTRIBUTES:
            known = (*keys, *_ATTRIBUTES)
            near = difflib.get_close_matches(name, known, 1)
            hint = f"; did you mean {near[0]!r}?" if near else "; there are " + ", ".join(known)
            raise TypeError(f"there is no {name!r}{hint}")
        if value is None:
            continue
        if name == "material":
            if not isinstance(value, Material):
                value = material(value)
        elif name in ("name", "simplify", "blend"):
            if not isinstance(value, str):
                raise TypeError(f"{name}: a text is wanted, not {type(value).__name__}")
            value = data_of(value)
        elif name == "dominance":
            if isinstance(value, str) and value.isalpha() and value not in ("left", "right", "equal"):
                raise fault(f"dominance: left, right, equal or a number is wanted, not {value!r}")
            value = value if isinstance(value, str) and value.isalpha() else exact(value)
        elif name == "attributes":
            value = _properties(value)
        elif name == "scale" and isinstance(value, str):
            value = exact(value)
        elif name in ("each", "regularize"):
            if isinstance(value, str):
                raise TypeError(f"{name}: True or False is wanted, not {value!r}")
            value = bool(value)
        else:
            value = _exactly(value)
        out.append((name, value))
    return out


def _properties(value: Any) -> dict[str, Any]:
    """Numbers, which are exact, and texts by key."""
    if not isinstance(value, Mapping):
        raise TypeError(f"attributes: keys with numbers or texts are wanted, not {type(value).__name__}")
    properties: dict[str, Any] = {}
    for key, item in value.items():
        properties[data_of(str(key))] = _property(item)
    return properties


def _property(value: Any) -> Any:
    is_text = isinstance(data_of(value), str) and not isinstance(value, Exact)
    return Text(value) if is_text and isinstance(value, str) else exact(value)


def _listed(what: str, given: Node | Iterable[Node] | None) -> tuple[Node, ...]:
    if given is None:
        return ()
    return as_nodes(what, (given,))


def criterion(key: str, value: Any) -> Any:
    """One criterion of `select` as data: texts in quotes, since a region may be given by number, too."""
    if key == "attributes":
        if not isinstance(value, Mapping):
            raise TypeError(f"attributes: keys with numbers or texts are wanted, not {type(value).__name__}")
        several = {k: isinstance(v, Iterable) and not isinstance(v, str) for k, v in value.items()}
        return {
            data_of(str(k)): [_property(item) for item in v] if several[k] else _property(v) for k, v in value.items()
        }

    def visit(item: Any) -> Any:
        if isinstance(item, Material):
            return Text(item.name)
        if isinstance(item, str) and not isinstance(item, Exact):
            return Text(item)
        if isinstance(item, Iterable) and not isinstance(item, str):
            return [visit(sub) for sub in item]
        return data_of(item)

    return visit(value)


def _exactly(value: Any) -> Any:
    """Data whose texts are numbers, too."""
    data = data_of(value)

    def visit(item: Any) -> Any:
        if isinstance(item, dict):
            return {key: visit(sub) for key, sub in item.items()}
        if isinstance(item, list):
            return [visit(sub) for sub in item]
        return item if item is None or isinstance(item, (bool, Exact)) else exact(item)

    return visit(data)


def made(
    operator: str,
    operands: Iterable[Node] = (),
    value: Any = None,
    attributes: Iterable[tuple[str, Any]] = (),
) -> Node:
    """A new node, its form checked."""
    return checked(Node(operator, operands, value, attributes))


def leaf(operator: str, value: Any, attributes: Mapping[str, Any]) -> Node:
    """A leaf with the keys of the tree file; those that are None are left out."""
    keys = tuple(value) if isinstance(value, dict) else ()
    if isinstance(value, dict):
        value = {key: item for key, item in value.items() if item is not None}
    return made(operator, (), value, _attributes(attributes, keys))


def checked(node: Node) -> Node:
    """The node, if the reader of tree files takes it; InputError at the caller's place if not."""
    from .tree import check_form

    check_form(node)
    return node


def union(
    *nodes: Node, dominance: Number | str | None = None, blend: str | None = None, **attributes: Any
) -> Node:
    """The union of groups, from left to right. dominance: "left", "right" or "equal" says which operand dominates; a
    number is that of the value; without it the operand with the larger number dominates. blend: "linear" mixes the
    materials of regions that overlap."""
    given = _attributes({"dominance": dominance, "blend": blend, **attributes})
    return made("union", as_nodes("union", nodes), attributes=given)


def intersection(*nodes: Node, dominance: Number | str | None = None, **attributes: Any) -> Node:
    """The intersection of groups, from left to right; dominance as of `union`."""
    return made(
        "intersection",
        as_nodes("intersection", nodes),
        attributes=_attributes({"dominance": dominance, **attributes}),
    )


def difference(*nodes: Node, dominance: Number | str | None = None, **attributes: Any) -> Node:
    """The first group without the others, from left to right; dominance as of `union`."""
    return made(
        "difference",
        as_nodes("difference", nodes),
        attributes=_attributes({"dominance": dominance, **attributes}),
    )


def sum(*nodes: Node, dominance: Number | str | None = None, **attributes: Any) -> Node:  # noqa: A001
    """The sum of components (Rossignac and Requicha): where operands overlap are components of their own."""
    return made("sum", as_nodes("sum", nodes), attributes=_attributes({"dominance": dominance, **attributes}))


def product(*nodes: Node, dominance: Number | str | None = None, **attributes: Any) -> Node:
    """The product of components: what all operands have in common."""
    return made("product", as_nodes("product", nodes), attributes=_attributes({"dominance": dominance, **attributes}))


def subtract(*nodes: Node, **attributes: Any) -> Node:
    """The components of the first operand without the point sets of the others."""
    return made("subtract", as_nodes("subtract", nodes), attributes=_attributes(attributes))


def aggregate(*nodes: Node, **attributes: Any) -> Node:
    """Values that do not overlap, side by side: each stays a component."""
    return made("aggregate", as_nodes("aggregate", nodes), attributes=_attributes(attributes))


def below(surface: Node, within: Node, **attributes: Any) -> Node:
    """What of the solid `within` lies below an open surface that parts it."""
    return made("below", as_nodes("below", (surface, within)), attributes=_attributes(attributes))


def above(surface: Node, within: Node, **attributes: Any) -> Node:
    """What of the solid `within` lies above an open surface that parts it."""
    return made("above", as_nodes("above", (surface, within)), attributes=_attributes(attributes))


def layers(
    within: Node,
    surfaces: Iterable[Node],
    *,
    names: Iterable[str] | None = None,
    materials: Iterable[Material] | None = None,
    **attributes: Any,
) -> Node:
    """What surfaces, from the lowest up, part the solid `within` into: each layer is below its surface in what the layers
    before it leave, the last one all that is left. names, materials: of the layers, one more than surfaces."""
    listed = tuple(surfaces)
    given: list[dict[str, Any]] = [{} for _ in range(len(listed) + 1)]
    for key, values in (("name", names), ("material", materials)):
        if values is None:
            continue
        of_layers = tuple(values)
        if len(of_layers) != len(given):
            raise InputError(f"layers: {len(given)} {key}s are needed, one more than surfaces, not {len(of_layers)}")
        for of_layer, value in zip(given, of_layers):
            of_layer[key] = value
    parts, rest = [], within
    for surface, of_layer in zip(listed, given):
        parts.append(below(surface, rest, **of_layer))
        rest = above(surface, rest)
    parts.append(made("simplify", (rest,), attributes=_attributes(given[-1])))
    return union(*parts, dominance="left", **attributes)


def complement(node: Node) -> Node:
    """All of space that is not in it."""
    return as_nodes("complement", (node,))[0].complement()
