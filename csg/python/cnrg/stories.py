"""What is told of a result: as text, and as data.

Each of these is a text for people, str(x), the same as the program `cnrg` prints, and the same facts as data, x.data:
dicts and lists with exact numbers as Fractions.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Callable, NamedTuple

_EXACT = {"u", "v", "t", "volume"}


def _facts(value: Any, key: str = "") -> Any:
    """JSON as data: exact numbers, which are texts there, become Fractions."""
    if isinstance(value, dict):
        return {k: _facts(v, k) for k, v in value.items()}
    if isinstance(value, list):
        if key == "point":
            return tuple(Fraction(x) for x in value)
        if key == "normal":
            return tuple(int(x) for x in value)
        return [_facts(item) for item in value]
    return Fraction(value) if key in _EXACT and isinstance(value, str) else value


class Told:
    """A text with its facts."""

    def __init__(self, text: str, data: dict[str, Any]):
        self.data = data
        self._text = text

    def __str__(self) -> str:
        return self._text

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        printer.text(self._text)

    def __repr__(self) -> str:
        return f"<cnrg.{type(self).__name__}>"


@dataclass(frozen=True)
class Step:
    """What one node made of a cell."""

    node: str
    operator: str
    component: int
    """in the value of the node; 0: not in it"""
    component_name: str
    entity: bool
    """a face, edge or vertex of a group"""
    rows: tuple[str, ...]
    """the rows of the tables that were asked, such as "union.edge.AoutB.dominant\""""
    removed: bool
    """one of them removed it"""
    data: dict[str, Any]
    """all that is known"""


class Explanation(Told):
    """Why a cell is where it is: its life at every node.

    data: node, cell (None: an inactive region that is not listed), dimension, state, pieces (cells of the refinement
    that it unites), point (if one was asked about), lives. A life is told once for all pieces that have it: pieces,
    point (in one of them and in no other cell), normal, origins, patches, curves, steps.
    """

    @property
    def cell(self) -> str | None:
        """Such as "f12"."""
        return self.data["cell"]

    @property
    def lives(self) -> list[list[Step]]:
        """Each way in which pieces of the cell lived, by nodes, operands before users."""
        return [[_step(step) for step in life["steps"]] for life in self.data["lives"]]

    @property
    def steps(self) -> list[Step]:
        """The first of these."""
        return self.lives[0]


def _step(data: dict[str, Any]) -> Step:
    asked = [b for b in data.get("booleans", []) if b.get("asked")]
    state = data["state"]
    return Step(
        data["node"], data["operator"], state["component"], state["name"], state["entity"],
        tuple(b["row"] for b in asked), any(b["removed"] for b in asked), data,
    )


class Selectable(NamedTuple):
    """One criterion of `Node.select`, and for how many cells it holds: key and value as in a tree. source_faces: of
    `from`, the faces of that leaf in which faces of the result lie."""

    key: str
    value: str
    regions: int
    faces: int
    edges: int
    vertices: int
    source_faces: list[int]


class Topology(Told):
    """The topology of a point set, counted exactly.

    data: empty, closed, bounded; euler (None if not bounded): the terms of Masuda's formula, v - (e - eh) + (f - r +
    fc) - (V - Vh + Vc) = C - Ch + Cc; betti: of the point set (component 0) and of each component, over Z/2 and Q;
    shapes: how many vertices and edges of each local shape; reasons: what is no manifold, and where; sheets; adjacent:
    components (0: the outside) with a wall between, and its faces.
    """

    @property
    def euler(self) -> dict[str, int] | None:
        """The terms of the formula by their letters."""
        return self.data.get("euler")

    @property
    def betti(self) -> tuple[int, int, int]:
        """Of the point set over Z/2: pieces, independent loops, enclosed cavities."""
        return self.betti_of(0)

    def betti_of(self, component: int, field: str = "z2") -> tuple[int, int, int]:
        """Of one component (0: of all), over Z/2 ("z2") or Q ("q")."""
        if field not in ("z2", "q"):
            raise ValueError(f'field: "z2" or "q" is wanted, not {field!r}')
        for entry in self.data.get("betti", []):
            if entry["component"] == component:
                return tuple(entry[field])  # type: ignore[return-value]
        return (0, 0, 0)

    @property
    def manifold(self) -> bool:
        """No edge and no vertex is anything else than a manifold there, with or without a border."""
        return bool(self.data.get("manifold", True))

    @property
    def adjacent(self) -> list[tuple[int, int, int]]:
        """Two components (0: the outside) and how many faces are between them."""
        return [(a, b, entry["faces"]) for entry in self.data.get("adjacent", []) for a, b in [entry["components"]]]


class Comparison(Told):
    """In what two results differ; true if they are the same.

    data: same; components (what they are called, of A and of B); only_a, only_b: pieces that only one has, each with
    dimension, counts, volume (None: unbounded), area, length and a point in it; regrouped, mostly: components that
    correspond; moved; attributes: names and materials; features_a, features_b: cells of their own.
    """

    def __init__(self, text: str, data: dict[str, Any]):
        super().__init__(text, data)
        self.same: bool = data["same"]
        """they mean the same"""

    def __bool__(self) -> bool:
        return self.same

    def __repr__(self) -> str:
        return f"<cnrg.Comparison: {'the same' if self.same else 'different'}>"


def explanation(text: str, facts: str, line_of: Callable[[int], int]) -> Explanation:
    """From what the library tells. `line_of` a line of the tree's text is the line that people know."""
    data = _facts(json.loads(facts))
    for life in data["lives"]:
        for step in life["steps"]:
            step["line"] = line_of(step["line"])

    def told(row: re.Match[str]) -> str:
        return row[1] + f"line {line_of(int(row[2]))}".ljust(len(row[0]) - len(row[1]) - 2) + "  "

    # A row of a node begins its line; what decided there is indented.
    return Explanation(re.sub(r"^(\S.*?  )line (\d+) *  (?=\S)", told, text, flags=re.M), data)


def topology(text: str, facts: str) -> Topology:
    """From what the library tells."""
    # "v" is a number of vertices here
    return Topology(text, json.loads(facts))


def comparison(text: str, facts: str) -> Comparison:
    """From what the library tells."""
    data = _facts(json.loads(facts))
    return Comparison(text or "the same\n", data)
