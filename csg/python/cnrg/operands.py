"""What may stand where a node is expected, and the operators of groups that nodes and results share.

A result is a leaf without a file: a tree may go on from it, and what made it is not evaluated again. A mesh of another
package is the leaf `mesh` of its faces.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Sequence

from . import _cnrg, convert

if TYPE_CHECKING:
    from .nodes import Node


class StoredResult:
    """A result as the value of a leaf, with what its materials are called and their colors. It does not refer to the
    result as Python knows it, which holds the leaf."""

    __slots__ = ("leaf", "name", "materials", "regions")

    def __init__(self, result: Any, name: str, materials: Sequence[tuple[str, str]], regions: Sequence[str]):
        self.leaf = _cnrg.ResultLeaf(result)
        self.name = name
        self.materials = tuple(materials)
        self.regions = tuple(regions)

    def __reduce__(self) -> Any:
        return stored_again, (self.leaf.json(), self.name, self.materials, self.regions)


def stored_again(json: bytes, name: str, materials: Sequence[tuple[str, str]], regions: Sequence[str]) -> StoredResult:
    """One that was pickled."""
    return StoredResult(_cnrg.result_of_json(json, name, list(materials)), name, materials, regions)


def as_node(value: Any) -> Node | None:
    """A node itself, a result as a leaf, a mesh of another package as one; None for anything else."""
    from .nodes import Node
    from .result import Result
    from .shapes import mesh

    if isinstance(value, Node):
        return value
    if isinstance(value, Result):
        return value.node
    return mesh(value) if convert.is_mesh(value) else None


def as_nodes(operator: str, given: Sequence[Any]) -> tuple[Node, ...]:
    """Nodes, given one by one or as one list of them."""
    only = given[0] if len(given) == 1 else None
    if isinstance(only, Iterable) and not isinstance(only, str) and as_node(only) is None:
        given = tuple(only)
    nodes = []
    for value in given:
        if isinstance(value, str):
            raise TypeError(
                f"{operator}: a node is wanted, not its name {value!r}; give the variable that holds it, or tree[{value!r}]"
            )
        node = as_node(value)
        if node is None:
            raise TypeError(f"{operator}: nodes are wanted, results or meshes, not {type(value).__name__}")
        nodes.append(node)
    return tuple(nodes)


def _boolean(operator: str, left: Any, right: Any) -> Any:
    from .nodes import made

    a, b = as_node(left), as_node(right)
    if a is None or b is None:
        return NotImplemented
    # The list of operands is worked off from the left, so `a - b - c` may be one node.
    plain = a.operator == operator and not a.attributes and a.key is None and not a.is_inline
    return made(operator, a.operands + (b,) if plain else (a, b))


class Operand:
    """The operators of groups. The other operand is a node, a result, or a mesh of another package."""

    __slots__ = ()

    def __or__(self, other: Any) -> Node:
        """The union: cells of both, and which of two that coincide stays is a matter of dominance."""
        return _boolean("union", self, other)  # type: ignore[no-any-return]

    def __ror__(self, other: Any) -> Node:
        return _boolean("union", other, self)  # type: ignore[no-any-return]

    __add__ = __or__

    def __radd__(self, other: Any) -> Node:
        """The union; `sum([a, b])` begins with 0."""
        start = type(other) is int and other == 0
        return as_node(self) if start else _boolean("union", other, self)  # type: ignore[no-any-return,return-value]

    def __and__(self, other: Any) -> Node:
        """The intersection."""
        return _boolean("intersection", self, other)  # type: ignore[no-any-return]

    def __rand__(self, other: Any) -> Node:
        return _boolean("intersection", other, self)  # type: ignore[no-any-return]

    def __sub__(self, other: Any) -> Node:
        """The difference: this without the other one's regions."""
        return _boolean("difference", self, other)  # type: ignore[no-any-return]

    def __rsub__(self, other: Any) -> Node:
        return _boolean("difference", other, self)  # type: ignore[no-any-return]

    def __xor__(self, other: Any) -> Node:
        """The symmetric difference: `(a - b) | (b - a)`."""
        a, b = as_node(self), as_node(other)
        if a is None or b is None:
            return NotImplemented
        return (a - b) | (b - a)

    def __rxor__(self, other: Any) -> Node:
        a = as_node(other)
        return NotImplemented if a is None else a.__xor__(self)  # type: ignore[return-value]
