"""Evaluation: one exact refinement of all leaves, then a value for each node."""

from __future__ import annotations

import warnings
import weakref
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context
from fractions import Fraction
from typing import Any, Iterator, Sequence

from . import _cnrg
from .errors import Notice
from .nodes import Node, Number
from .place import site_of_caller
from .progress import Progress, Shown, threads_of
from .result import Result
from .tree import Tree


@dataclass(frozen=True)
class Row:
    """What became of one node, in numbers."""

    name: str
    """of the node; `name#2` of its second instance"""
    operator: str
    cells: tuple[int, int, int, int]
    """vertices, edges, faces, 3-cells after simplification"""
    removed: int
    """how many pieces of the refinement the rows of the tables removed"""
    regions: int
    components: int
    """of a value that is no group; else 0"""
    is_group: bool
    volume: Fraction | None
    """exact, of all regions together (cubic units of the model); None: unbounded"""
    volume_bound: float | None
    """how far `volume` may be from that between the true surfaces, 0 without curved ones; None: unknown, or unbounded"""
    seconds: float


@dataclass(frozen=True)
class Diagnostic:
    """Something that people should know and that stops nothing."""

    level: str
    """"notice" or "warning\""""
    message: str
    file: str | None
    line: int | None
    column: int | None = None

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        return f"{place}: {self.level}: {self.message}" if place else f"{self.level}: {self.message}"


@dataclass(frozen=True)
class UncertainPlace:
    """Where it is not proven that curved surfaces meet as their facets do."""

    names: tuple[str, ...]
    """leaves, each with its patch in brackets"""
    at: tuple[float, float, float]
    size: float
    """nothing nearer to `at` than this length was decided"""
    why: str
    """`near`: they touch, or are too near to it; `facets`: these are too coarse and cannot be finer; `budget`: of steps
    none were left"""


@dataclass(frozen=True)
class Certificate:
    """What is proven of pairs of facets near each other, and of the surfaces that they stand for."""

    asked: int
    apart: int
    crossing: int
    contacts: int
    left: int
    """questions that were not answered within the budget"""
    places: tuple[UncertainPlace, ...]
    unknown: tuple[str, ...]
    """leaves of whose curved faces only facets are known, such as CAD models"""

    @property
    def certified(self) -> bool:
        """All surfaces meet as their facets do."""
        return not self.places and not self.unknown and self.left == 0


class Evaluation(Sequence[Row]):
    """An evaluated tree.

    ev.result: of the tree's result. ev["split"], ev[node]: of another node that was asked for. As a sequence it is
    the rows of all nodes, operands before users; as a text their table.
    """

    def __init__(self, tree: Tree, evaluation: Any, kept: list[int]):
        self._tree = tree
        self._evaluation = evaluation
        self._kept = kept
        self._rows: list[Row] | None = None
        # A result holds its evaluation: if that held the result, too, both would stay until Python looks for cycles.
        self._results: weakref.WeakValueDictionary[int, Result] = weakref.WeakValueDictionary()
        self.refine_seconds: float = evaluation.refine_seconds
        """of the refinement of all leaves"""

    @property
    def tree(self) -> Tree:
        """What was evaluated."""
        return self._tree

    @property
    def rows(self) -> list[Row]:
        """A row for each instance of each node."""
        if self._rows is None:
            self._rows = [Row(**row) for row in self._evaluation.rows()]
        return list(self._rows)

    @property
    def notices(self) -> list[Diagnostic]:
        """Notices and warnings, each with its place."""
        out = []
        for level, file, line, column, message in self._evaluation.diagnostics(list(dict.fromkeys(self._kept))):
            out.append(Diagnostic(level, self._tree.translated(message), *self._tree.site(file, line, column)))
        return out

    @property
    def certificate(self) -> Certificate | None:
        """Whether curved surfaces meet as their facets do, for all that was asked for; None with `certify=False`."""
        data = self._evaluation.certificate()
        if data is None:
            return None
        places = tuple(UncertainPlace(**place) for place in data.pop("places"))
        return Certificate(places=places, **data)

    @property
    def result(self) -> Result:
        """The value of the tree's result."""
        return self._result(self._kept[0])

    def _result(self, number: int) -> Result:
        if number not in self._kept:
            raise KeyError("this node was not kept; give it to evaluate(...), too")
        result = self._results.get(number)
        if result is None:
            result = self._results[number] = Result._of(self._evaluation.result(number), self)
        return result

    def __getitem__(self, which: Any) -> Any:
        if isinstance(which, (str, Node)):
            return self._result(self._tree.number_of(which))
        return self.rows[which]

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.rows)

    def __str__(self) -> str:
        head = ("node", "operator", "vertices", "edges", "faces", "3-cells", "removed", "regions", "seconds", "within", "volume")
        lines: list[tuple[str, ...]] = [head]
        for r in self.rows:
            volume = "unbounded" if r.volume is None else str(r.volume)
            if len(volume) > 24:
                volume = f"{float(r.volume):.12g}"  # type: ignore[arg-type]
            lines.append((r.name, r.operator, *map(str, r.cells), str(r.removed), str(r.regions), f"{r.seconds:.3f}", _within(r), volume))
        widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
        left = {0, 1, 10}
        text = ""
        for line in lines:
            cells = (c.ljust(w) if i in left else c.rjust(w) for i, (c, w) in enumerate(zip(line, widths)))
            text += "  ".join(cells).rstrip() + "\n"
        return text.rstrip("\n")

    def __repr__(self) -> str:
        return f"<cnrg.Evaluation of {self._tree!r}>"


def _within(row: Row) -> str:
    if row.volume is None or row.volume_bound == 0:
        return ""
    if row.volume_bound is None:
        return "unknown"
    return f"±{float(Context(prec=3, rounding=ROUND_CEILING).create_decimal(row.volume_bound)):.3g}"


def evaluate(
    model: Node | Tree,
    *nodes: Node | str,
    threads: int = 0,
    rows: bool = True,
    raw: bool = False,
    validate: bool = False,
    certify: bool | None = None,
    weld: Number | None = None,
    progress: Progress = None,
) -> Evaluation:
    """Evaluates a node, or the result of a tree, and any other nodes with it, exactly.

    model: what `Evaluation.result` is of. nodes: others that are wanted, nodes or names.
    threads: 0 for one per core. rows: counts and volumes of all nodes; without them only of those that are asked for.
    raw: cells stay as the refinement has them, nothing is simplified. validate: checks all invariants, slowly.
    certify: facets get finer where it is not proven that surfaces meet as they do, see `Evaluation.certificate`; True:
    with twenty times the steps, False: not at all.
    weld: what is nearer than that is made to coincide, in all leaves together (units of the model).
    progress: None, True for a bar, or a function f(stage, done, total).

    Raises InputError with the place of the node in the script or the file, FileError; KeyboardInterrupt ends it at
    once. Other threads run meanwhile. Warnings and notices, such as that a mesh is open, go to
    `warnings` as cnrg.Notice, and are in `Evaluation.notices`.
    """
    if isinstance(model, Tree):
        if weld is not None:
            raise TypeError("evaluate: a tree says itself what is welded")
        return evaluate_tree(
            model, nodes, threads=threads, rows=rows, raw=raw, validate=validate, certify=certify, progress=progress
        )
    if not isinstance(model, Node):
        raise TypeError(f"evaluate: a node or a tree is wanted, not {type(model).__name__}")
    others = tuple(node for node in nodes if isinstance(node, Node))
    tree = Tree.of(model, *others, weld=weld)
    return evaluate_tree(
        tree, nodes, threads=threads, rows=rows, raw=raw, validate=validate, certify=certify, progress=progress
    )


def evaluate_tree(
    tree: Tree,
    nodes: Sequence[Node | str] = (),
    *,
    threads: int = 0,
    rows: bool = True,
    raw: bool = False,
    validate: bool = False,
    certify: bool | None = None,
    progress: Progress = None,
) -> Evaluation:
    """`evaluate` for a tree."""
    threads = threads_of(threads)
    kept = [tree.number_of(tree.result)] + [tree.number_of(node) for node in nodes]
    with Shown(progress) as shown, tree.placed():
        evaluation = _cnrg.evaluate(
            tree._tree, kept[1:], threads, bool(rows), bool(raw), bool(validate), None if certify is None else bool(certify), shown
        )
    made = Evaluation(tree, evaluation, kept)
    for notice in made.notices:
        warnings.warn_explicit(str(notice), Notice, *site_of_caller())
    return made
