"""Trees: expressions as the text of a tree file, and tree files as expressions.

An expression is a graph of nodes; a tree file is a list of them by name. The text has a node per line, operands
before their users, so that the place of a fault in it is the node that it is about: faults are told with the place
in the script where that node was made.
"""

from __future__ import annotations

import difflib
import os
import re
from itertools import chain
from typing import Any, Callable, Iterable, Iterator, Mapping

from . import _cnrg
from .errors import Error, InputError
from .named import (
    mixed, named_regions, of_regions, own_material, own_materials, picked_materials, region_names, sources,
)
from .nodes import (
    Exact, Material, MeshArrays, Node, Number, Picked, Text, criterion, data_of, exact, quoted, text_of,
)
from .operands import StoredResult
from .place import Site

_EXPRESSION = "<expression>"
_PLACE = re.compile(re.escape(_EXPRESSION) + r":(\d+):(\d+)")
_LINE = re.compile(r" \(line \d+\)")


def _operator_value(node: Node, operand: Callable[[Node], Any], path: Callable[[str], str]) -> Iterator[Any]:
    """The value of the operator's key in pieces: texts, and what `operand` makes of operands."""
    if isinstance(node.value, StoredResult):
        yield node.value.leaf
    elif isinstance(node.value, MeshArrays):
        keys = "".join(f", {key}: {text_of(value)}" for key, value in node.value.keys.items())
        yield node.value.arrays
        yield keys + "}"
    elif not node.operands:
        value = node.value
        if node.operator in ("cnrg", "csg"):
            value = path(value)
        elif isinstance(value, dict) and isinstance(value.get("file"), str):
            value = {**value, "file": path(value["file"])}
        yield text_of(value)
    elif node.operator in ("complement", "interior", "closure", "boundary", "regularize", "unify", "simplify"):
        if node.value is None:
            yield operand(node.operands[0])
        else:
            yield "{of: "
            yield operand(node.operands[0])
            yield "".join(f", {key}: {text_of(value)}" for key, value in node.value.items()) + "}"
    elif isinstance(node.value, Picked):
        yield "{of: "
        yield operand(node.operands[0])
        yield "".join(f", {key}: {text_of(value)}" for key, value in node.value.criteria.items())
        places = node.operands[1:]
        nodes = {
            **node.value.sources,
            "inside": places[: node.value.inside],
            "touching": places[node.value.inside :],
        }
        for key, listed in nodes.items():
            for i, below in enumerate(listed):
                yield ", " if i else f", {key}: ["
                yield operand(below)
            yield "]" if listed else ""
        yield "}"
    elif node.operator in ("below", "above"):
        yield operand(node.operands[0])
        yield ", within: "
        yield operand(node.operands[1])
    else:
        yield "["
        for i, below in enumerate(node.operands):
            yield ", " if i else ""
            yield operand(below)
        yield "]"


def _attribute_text(node: Node) -> str:
    text = ""
    for name, value in node.attributes:
        text += f", {name}: " + (quoted(value.name) if isinstance(value, Material) else text_of(value))
    return text


def _in_place_of(leaf: Any) -> str:
    """What stands in a text for what is handed over in memory."""
    return "{points: [], faces: []" if isinstance(leaf, _cnrg.MeshData) else "memory"


def check_form(node: Node) -> None:
    """Raises InputError if the reader of tree files does not take the node. Operands are not looked at again: points
    stand in their place, two of them for a list of any length."""
    names = {name for name in of_regions(node)}
    own = own_material(node)
    if own is not None:
        names.add(own.name)
    names.update(picked_materials(node))
    is_short = len(node.operands) <= 2 or isinstance(node.value, Picked)
    short = node if is_short else Node(node.operator, node.operands[:2], node.value, node.attributes)
    value = "".join(
        piece if isinstance(piece, str) else _in_place_of(piece)
        for piece in _operator_value(short, lambda below: "p", lambda path: path)
    )
    text = "cnrg: 1\n" + (f"materials: {{{', '.join(quoted(name) + ': {}' for name in sorted(names))}}}\n" if names else "")
    text += f"nodes:\n  node: {{{node.operator}: {value}{_attribute_text(node)}}}\n  p: {{points: [[0, 0, 0]]}}\n"
    _checked_text(text + "result: node\n", node.site)


def check_material(m: Material) -> None:
    """Raises InputError for a material that the reader of tree files does not take."""
    materials = [f"{quoted(name)}: {{}}" for name in sorted(set(mixed(m.data)) - {m.name})]
    materials.append(f"{quoted(m.name)}: {_material_text(m, 'p')}")
    text = f"cnrg: 1\nmaterials: {{{', '.join(materials)}}}\nnodes: {{p: {{points: [[0, 0, 0]]}}}}\nresult: p\n"
    _checked_text(text, m.site)


def _checked_text(text: str, site: Site) -> None:
    try:
        _cnrg.Tree.parse(text, _EXPRESSION, {}, "", {})
    except InputError as e:
        message = e.message.replace("the node `node`", "this node")
        raise InputError(message, *site) from None


def _material_text(m: Material, to: str | None) -> str:
    data = dict(m.data)
    if to is not None and m.to is not None:
        data["distance"] = {"to": to, **data["distance"]}
    return text_of(data)


def _text_for_file(piece: Any, leaf: Node) -> str:
    """The mesh or result of a leaf in the text of a file."""
    if isinstance(piece, _cnrg.MeshData):
        return "{" + piece.text()
    raise InputError(f"the result {leaf.value.name!r} stands in no file, and a tree names a file: write it, "
                     'result.write("part.json"), and build on cnrg.load("part.json")', *leaf.site)


class _Text:
    """The text of a tree, with the place of each node in it."""

    def __init__(self, roots: Iterable[Node], order: Iterable[Node], materials: Iterable[Material], weld: Exact | None):
        self._weld = weld
        self.nodes = self._listed(list(roots), list(order))
        self.keys = self._named()
        self.materials = self._declared(materials)
        self.in_memory: dict[str, Any] = {}
        self._places: list[tuple[int, int, int, Node]] = []  # line, columns from and to, node

    def _listed(self, roots: list[Node], order: list[Node]) -> list[Node]:
        """Those in `order`, then all below the roots; operands before users."""
        seen: set[int] = set()
        listed = []
        for root in order + roots:
            stack: list[tuple[Node, bool]] = [(root, False)]
            while stack:
                node, done = stack.pop()
                if done:
                    listed.append(node)
                elif id(node) not in seen:
                    seen.add(id(node))
                    stack.append((node, True))
                    stack.extend((own.to, False) for own in own_materials(node) if own.to is not None)
                    stack.extend((source, False) for source in sources(node))
                    stack.extend((below, False) for below in reversed(node.operands))
        place = {id(node): i for i, node in enumerate(order)}
        known = [node for node in listed if id(node) in place]
        self._inline = {id(node) for node in listed if node.is_inline and all(node is not root for root in roots)}
        for node in listed:  # what a distance is measured to, or a selection is from, needs a name
            named = [own.to for own in own_materials(node)] + list(sources(node))
            self._inline -= {id(other) for other in named if other is not None}
        return sorted(known, key=lambda node: place[id(node)]) + [n for n in listed if id(n) not in place]

    def _named(self) -> dict[int, str]:
        keys: dict[int, str] = {}
        taken: dict[str, Node] = {}
        for node in self.nodes:
            if node.key is None or id(node) in self._inline or node.is_inline:
                continue
            if node.key in taken:
                raise InputError(f"two nodes of this tree are called {node.key!r}; give each its own name", *node.site)
            taken[node.key] = node
            keys[id(node)] = node.key
        counts: dict[str, int] = {}
        for node in self.nodes:
            if id(node) in keys or id(node) in self._inline:
                continue
            while True:
                n = counts[node.operator] = counts.get(node.operator, 0) + 1
                key = node.operator if n == 1 else f"{node.operator}{n}"
                if key not in taken:
                    break
            taken[key] = node
            keys[id(node)] = key
        return keys

    def _declared(self, given: Iterable[Material]) -> list[Material]:
        """Materials in the order in which they are given, then that in which nodes name them."""
        declared: dict[str, Material] = {}

        def declare(m: Material) -> None:
            known = declared.get(m.name)
            if known is None or (not known.data and known is not m):
                declared[m.name] = m
            elif m.data and (m.data != known.data or m.to is not known.to):
                raise InputError(f"two materials of this tree are called {m.name!r}; give each its own name", *m.site)

        for m in given:
            declare(m)
        for node in self.nodes:
            for m in own_materials(node) + [Material(name, {}, None, node.site) for name in of_regions(node)]:
                declare(m)
        for node in self.nodes:
            if isinstance(node.value, StoredResult):
                for name, color in node.value.materials:
                    declared.setdefault(name, Material(name, {"color": color} if color else {}, None, node.site))
        for m in list(declared.values()):
            for name in mixed(m.data):
                if name not in declared:
                    declared[name] = Material(name, {}, None, m.site)
        for node in self.nodes:
            for name in picked_materials(node):
                if name not in declared:
                    near = difflib.get_close_matches(name, declared, 1)
                    hint = f"did you mean {near[0]!r}?" if near else f"if a file has it, give cnrg.material({str(name)!r})"
                    raise InputError(f"select: no node has the material {str(name)!r}; {hint}", *node.site)
        return list(declared.values())

    def check_regions(self) -> None:
        """InputError where a node picks a region by a name that none can have."""
        known = region_names(self.nodes, self.keys.values())
        if known is None:
            return
        for node in self.nodes:
            for name in named_regions(node):
                if name not in known:
                    near = difflib.get_close_matches(name, known, 1)
                    hint = f"did you mean {near[0]!r}?" if near else "result.selectables() lists what there is"
                    hint = "a number is no text" if name.isdecimal() else hint
                    raise InputError(f"select: no region can have the name {name!r}; {hint}", *node.site)

    def write(self, result: Node, path: Callable[[str], str], for_file: bool) -> str:
        """The text. For a file meshes stand in it; otherwise they are in `in_memory`, as results are."""
        lines = ["cnrg: 1"]
        if self._weld is not None:
            lines.append(f"weld: {self._weld}")
        if self.materials:
            lines.append("materials:")
            for m in self.materials:
                lines.append(f"  {quoted(m.name)}: {_material_text(m, None if m.to is None else self.keys[id(m.to)])}")
                self._places.append((len(lines), 0, len(lines[-1]), Node("material", site=m.site)))
        lines.append("nodes:")
        uses: dict[int, int] = {}
        for node in self.nodes:
            for below in node.operands:
                uses[id(below)] = uses.get(id(below), 0) + 1
        anchors: dict[int, str] = {}
        for node in self.nodes:
            if id(node) in self.keys:
                lines.append(self._line(node, len(lines) + 1, uses, anchors, path, for_file))
        lines.append(f"result: {quoted(self.keys[id(result)])}")
        return "\n".join(lines) + "\n"

    def _line(
        self,
        node: Node,
        line: int,
        uses: Mapping[int, int],
        anchors: dict[int, str],
        path: Callable[[str], str],
        for_file: bool,
    ) -> str:
        """The node, and those that stand in it: without recursion, since these nest deeper than Python likes."""
        texts = [f"  {quoted(self.keys[id(node)])}: "]
        column = len(texts[0])
        stack: list[Any] = [node]
        open_: list[tuple[int, Node]] = []
        while stack:
            piece = stack.pop()
            if isinstance(piece, Node):
                if piece is not node and id(piece) in self.keys:
                    piece = quoted(self.keys[id(piece)])
                elif id(piece) in anchors:
                    piece = f"*{anchors[id(piece)]}"
                else:
                    anchor = ""
                    if piece is not node and uses[id(piece)] > 1:
                        anchors[id(piece)] = f"n{len(anchors) + 1}"
                        anchor = f"&{anchors[id(piece)]} "
                    pieces = [anchor + "{" + piece.operator + ": ", *_operator_value(piece, lambda n: n, path)]
                    pieces += [_attribute_text(piece) + "}", None]
                    open_.append((column, piece))
                    stack.extend(reversed(pieces))
                    continue
            elif piece is None:
                begin, made = open_.pop()
                self._places.append((line, begin, column, made))
                continue
            elif not isinstance(piece, str):
                leaf = open_[-1][1]
                if for_file:
                    piece = _text_for_file(piece, leaf)
                else:
                    self.in_memory[self.keys[id(leaf)]] = piece
                    piece = _in_place_of(piece)
            texts.append(piece)
            column += len(piece)
        return "".join(texts)

    def node_at(self, line: int, column: int) -> Node | None:
        """The innermost node at a place of the text, both from 1."""
        inside = [p for p in self._places if p[0] == line and p[1] < column <= p[2]]
        if not inside:
            inside = [p for p in self._places if p[0] == line]
        return min(inside, key=lambda p: p[2] - p[1])[3] if inside else None


class Tree:
    """A tree: nodes by name, one of them the result. `read` makes one of a file, `Tree.of` of an expression.

    tree["ground"]: the node of that name, as an expression. tree.result: that of the result. len, iteration and `in`
    go over the names of nodes.
    """

    def __init__(self, nodes: Mapping[str, Node], result: Node, text: _Text | None, tree: Any, materials: list[Material]):
        self._nodes = dict(nodes)
        self._result = result
        self._text = text  # of an expression
        self._tree = tree
        self._materials = materials
        self._numbers: dict[int, int] | None = None

    @staticmethod
    def of(*nodes: Node, weld: Number | None = None) -> Tree:
        """The tree of these nodes and all below them; the first is the result. weld: what is nearer is made to
        coincide, in all leaves together."""
        if not nodes or not all(isinstance(node, Node) for node in nodes):
            raise TypeError("a tree is made of one node or more")
        text = _Text(nodes, (), (), None if weld is None else exact(weld))
        text.check_regions()
        return Tree._parsed(text, nodes[0])

    @staticmethod
    def _parsed(text: _Text, result: Node, inside: str = "") -> Tree:
        # In memory paths are absolute; the folder of `file` is that of the process.
        words = text.write(result, os.path.abspath, False)
        tree = Tree({text.keys[id(n)]: n for n in text.nodes if id(n) in text.keys}, result, text, None, text.materials)
        with tree.placed():
            tree._tree = _cnrg.Tree.parse(words, _EXPRESSION, text.in_memory, inside, {})
        return tree

    @property
    def result(self) -> Node:
        """What is evaluated."""
        return self._result

    def __getitem__(self, name: str) -> Node:
        try:
            return self._nodes[name]
        except (KeyError, TypeError):
            raise KeyError(f"the tree has no node called {name!r}; it has {', '.join(map(repr, self._nodes))}") from None

    def __contains__(self, name: object) -> bool:
        return name in self._nodes

    def __iter__(self) -> Iterator[str]:
        return iter(self._nodes)

    def __len__(self) -> int:
        return len(self._nodes)

    def __repr__(self) -> str:
        return f"<cnrg.Tree of {len(self)} nodes, result {self.name_of(self._result)!r}>"

    def name_of(self, node: Node) -> str:
        """The name of one of its nodes."""
        for name, known in self._nodes.items():
            if known is node:
                return name
        raise KeyError("this node is not in the tree")

    def number_of(self, node: Node | str) -> int:
        """The number by which the library knows a node."""
        if isinstance(node, str):
            node = self[node]
        if not isinstance(node, Node):
            raise TypeError(f"a node or its name is wanted, not {type(node).__name__}")
        if self._numbers is None:
            records = self._tree.records() if self._text is None else None
            names = {r.name: i for i, r in enumerate(records)} if records else {}
            self._numbers = {}
            for i, (name, known) in enumerate(self._nodes.items()):
                self._numbers[id(known)] = names.get(name, i)
        if id(node) not in self._numbers:
            raise KeyError("this node is not in the tree")
        return self._numbers[id(node)]

    def evaluate(self, *nodes: Node | str, **options: Any) -> Any:
        """The result and these nodes, as `cnrg.evaluate` has it."""
        from .evaluation import evaluate_tree

        return evaluate_tree(self, nodes, **options)

    def check(self) -> list[str]:
        """Checks all that can be checked without evaluating; returns notices."""
        with self.placed():
            return [self.translated(text) for text in self._tree.check()]

    def to_yaml(self, folder: str | os.PathLike[str] | None = None) -> str:
        """The text of a tree file with the same nodes, names and materials. Files that leaves read are named relative
        to `folder`, where the text is to lie; without it by absolute paths."""
        base = None if folder is None else os.fspath(folder)

        def path(name: str) -> str:
            return os.path.abspath(name) if base is None else os.path.relpath(name, base)

        weld = self._tree.weld
        text = _Text(
            [self._result],
            [] if self._text else list(self._nodes.values()),
            self._materials,
            None if weld is None else Exact(weld),
        )
        return text.write(self._result, path, True)

    # Places: a fault in the text of an expression is told at the node's place in the script.

    def placed(self) -> _Placed:
        """with tree.placed(): errors from within come out with places in the script."""
        return _Placed(self)

    def site(self, file: str | None, line: int | None, column: int | None) -> Site:
        """The place of a fault for people."""
        if file != _EXPRESSION or self._text is None:
            return (file, line, column)
        node = self._text.node_at(line or 1, column or 1)
        return (node or self._result).site

    def line_of(self, line: int) -> int:
        """The line of the script, or of the file, in which the node at a line of the tree's text was made."""
        site = self.site(self._tree.file, line, None)
        return site[1] or line

    def translated(self, message: str) -> str:
        """A message with places in the script."""
        if self._text is None:
            return message

        def place(match: re.Match[str]) -> str:
            return ":".join(str(part) for part in self.site(_EXPRESSION, int(match[1]), int(match[2])))

        return _LINE.sub("", _PLACE.sub(place, message))


class _Placed:
    """Errors from within come out with places in the script."""

    def __init__(self, tree: Tree):
        self._tree = tree

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(error, Error) and self._tree._text is not None:
            placed = self._placed(error)
            placed.more = tuple(map(self._placed, error.more))
            raise placed from None

    def _placed(self, error: Error) -> Error:
        return type(error)(self._tree.translated(error.message), *self._tree.site(error.file, error.line, error.column))


def read(
    path: str | os.PathLike[str] | Mapping[str, Any],
    *,
    inside: str | os.PathLike[str] | None = None,
    parameters: Mapping[str, Number] | None = None,
) -> Tree:
    """Reads a tree file (YAML or JSON), or a map that says what such a file does. inside: a folder that every file named in the tree must lie in, for trees that
    are not trusted. parameters: numbers in place of those that the tree gives its parameters. InputError with line and column for a fault, FileError for a file that cannot be read. Leaves and
    their files are looked at by `.check()` and `.evaluate()`."""
    if isinstance(path, Mapping):
        return parse(text_of(data_of(path)), inside=inside, parameters=parameters)
    name = os.fspath(path)
    tree = _cnrg.Tree.read(name, "" if inside is None else os.fspath(inside), _given(parameters))
    return _as_expressions(tree, name)


def _given(parameters: Mapping[str, Number] | None) -> dict[str, str]:
    return {name: exact(value) for name, value in (parameters or {}).items()}


def parse(
    text: str,
    file: str = "tree.yaml",
    *,
    inside: str | os.PathLike[str] | None = None,
    parameters: Mapping[str, Number] | None = None,
) -> Tree:
    """The same for a text; `file` is its name in messages, and paths in it are relative to the folder of that."""
    folder = "" if inside is None else os.fspath(inside)
    tree = _cnrg.Tree.parse(text, os.fspath(file), {}, folder, _given(parameters))
    return _as_expressions(tree, os.fspath(file))


def _as_expressions(tree: Any, file: str) -> Tree:
    records = tree.records()
    folder = os.path.dirname(os.path.abspath(file))
    graded = {}
    for name, data in tree.materials():
        graded[name] = data_of(data) if isinstance(data, dict) else {}
    nodes: list[Node | None] = [None] * len(records)
    materials: dict[str, Material] = {}

    def material_of(name: str) -> Material:
        if name not in materials:
            data = graded[name]
            to: Any = None
            if isinstance(data.get("distance"), dict):
                to = next(i for i, r in enumerate(records) if r.name == data["distance"]["to"] and not r.is_inline)
                data = {**data, "distance": {k: v for k, v in data["distance"].items() if k != "to"}}
            materials[name] = Material(name, data, to, (file, 1))  # a number until all are there
        return materials[name]

    def attribute(name: str, value: Any) -> Any:
        if name == "attributes":
            return {key: exact(item[0]) if isinstance(item, tuple) else Text(item) for key, item in value.items()}
        return material_of(value) if name == "material" else data_of(value)

    def picked(of: Any) -> Picked:
        criteria, sources, inside = of
        data: dict[str, Any] = {}
        for key, values in criteria.items():
            if key == "attributes":
                data[key] = {k: [exact(v[0]) if isinstance(v, tuple) else Text(v) for v in vs] for k, vs in values.items()}
            else:
                data[key] = criterion(key, values[0] if len(values) == 1 else values)
        by = {key: [nodes[k] for k in listed] for key, listed in sources.items()}
        return Picked(data, by, inside, [material_of(name) for name in criteria.get("material", [])])  # type: ignore[misc]

    def build(i: int) -> Node:
        r = records[i]
        value: Any = None
        if r.is_leaf:
            value = data_of(r.value)
            if r.operator_name == "cnrg":
                value = os.path.join(folder, value)
            elif isinstance(value, dict) and isinstance(value.get("file"), str):
                value["file"] = os.path.join(folder, value["file"])
        elif r.picked is not None:
            value = picked(r.picked)
        else:
            keys: dict[str, Any] = {}
            if r.forgets_features and all(name != "simplify" for name, _ in r.attributes):
                keys["mode"] = "points"
            if r.within is not None:
                keys["within"] = exact(r.within)
            value = keys or None
        attributes = [(n, attribute(n, v)) for n, v in r.attributes]
        below = [nodes[k] for k in r.operands]
        return Node(
            r.operator_name,
            below,
            value,
            attributes,
            key=r.name,
            is_inline=r.is_inline,
            site=(file, r.line, r.column),
        )

    stack = list(range(len(records)))[::-1]
    while stack:
        i = stack[-1]
        named = list(chain.from_iterable(records[i].picked[1].values())) if records[i].picked is not None else []
        missing = [k for k in [*records[i].operands, *named] if nodes[k] is None]
        if missing and nodes[i] is None:
            stack.extend(reversed(missing))
            continue
        stack.pop()
        if nodes[i] is None:
            nodes[i] = build(i)
    for name in graded:
        material_of(name)
    for m in materials.values():
        if m.to is not None:
            m.to = nodes[m.to]  # type: ignore[call-overload]
        m.mixed = tuple(materials[name] for name in mixed(m.data))
    ordered = [materials[name] for name in graded]
    known: dict[str, Node] = {}
    for r, n in zip(records, nodes):  # inline ones come last, and give way
        known.setdefault(r.name, n)  # type: ignore[arg-type]
    return Tree(known, nodes[tree.result], None, tree, ordered)
