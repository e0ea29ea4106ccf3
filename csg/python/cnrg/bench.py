"""Other systems on own models, judged against the exact result: the benchmark program for scripts.

    import cnrg, cnrg.bench

    rows = cnrg.bench.run(ball - slab, systems=["ours", "nef", "mantyla-double"])
    print(rows["system"], rows["verdict"])

Everything is done by the program `bench_sweep`, which is a part of a build with CNRG_BENCH=ON and not of packages: it
is looked for where the environment's CNRG_BENCH_PROGRAM says, in the build folder that this module is in, and on PATH.
Experiments, systems and verdicts are those of bench/README.md.
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator

import numpy

from .errors import FileError, InputError
from .nodes import Node, difference, intersection, union
from .shapes import mesh
from .tree import Tree, read

__all__ = ["Kept", "Rows", "System", "judge", "mantyla", "program", "run", "systems"]

_OPERATIONS: dict[str, Callable[..., Node]] = {"union": union, "difference": difference, "intersection": intersection}
_PROGRAM = "bench_sweep"
# Columns: a name, where it is in a row, and its type.
_COLUMNS = (
    ("problem", ("problem",), object), ("experiment", ("family",), object), ("operation", ("operation",), object),
    ("operands", ("operands",), "u8"), ("triangles", ("triangles",), "u8"), ("system", ("system",), object),
    ("verdict", ("verdict",), object), ("stage", ("stage",), object), ("message", ("message",), object),
    ("confirmed_by", ("confirmation", "by"), object), ("truth", ("truth", "confirmed"), object),
    ("seconds", ("seconds",), "f8"), ("own_bytes", ("own_bytes",), "u8"), ("peak_bytes", ("peak_bytes",), "u8"),
    ("excess", ("excess",), "f8"), ("missing", ("missing",), "f8"), ("load", ("load",), "f8"),
    ("command", ("command",), object),
)


@dataclass(frozen=True)
class System:
    """A system that problems can be given to."""

    name: str
    title: str
    guarantee: str
    """what it takes and promises"""
    version: str
    rounding: float
    """how far its points may be off, as a part of the largest coordinate; 0: exact"""
    regularized: bool
    """its results are solids alone"""
    absent: str
    """why it cannot run here; empty: it can"""


class Rows(Sequence[Mapping[str, Any]]):
    """Runs, judged. As a sequence: the rows as their files have them (bench/sweep/row.h). `rows["verdict"]` is a
    column, `rows.array` all columns as a structured array, with a column `value:NAME` for each parameter."""

    def __init__(self, records: Iterable[Mapping[str, Any]]):
        self._records = list(records)
        values = list(dict.fromkeys(name for row in self._records for name in row["values"]))
        columns = [*_COLUMNS, *((f"value:{name}", ("values", name), object) for name in values)]
        self.array = numpy.empty(len(self._records), [(name, kind) for name, _, kind in columns])
        for name, path, kind in columns:
            for i, row in enumerate(self._records):
                value: Any = row
                for key in path:
                    value = value.get(key)
                self.array[name][i] = numpy.nan if value is None and kind == "f8" else value
        self.array.flags.writeable = False

    def __len__(self) -> int:
        return len(self._records)

    def __getitem__(self, which: Any) -> Any:
        return self.array[which] if isinstance(which, str) else self._records[which]

    def __iter__(self) -> Iterator[Mapping[str, Any]]:
        return iter(self._records)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame of the columns; needs pandas."""
        import pandas

        return pandas.DataFrame({name: self.array[name] for name in self.array.dtype.names or ()})

    def __repr__(self) -> str:
        return f"<cnrg.bench.Rows: {len(self)}>"


@dataclass(frozen=True)
class Kept:
    """One run with its result."""

    row: Mapping[str, Any]
    """as its file has it"""
    result: Node | None
    """what the system gave, exactly; None if it gave nothing that bounds a solid"""


def program() -> str:
    """The path of the benchmark program. Raises FileError if there is none."""
    given = os.environ.get("CNRG_BENCH_PROGRAM")
    if given is not None:
        if os.access(given, os.X_OK) and os.path.isfile(given):
            return given
        raise FileError(f"CNRG_BENCH_PROGRAM is {given}, which is no program; give the path of {_PROGRAM}")
    built = Path(__file__).resolve().parents[3] / "bench" / _PROGRAM
    found = str(built) if os.access(built, os.X_OK) else shutil.which(_PROGRAM)
    if found is None:
        raise FileError(f"{_PROGRAM} was not found; build it (CNRG_BENCH=ON, target {_PROGRAM}) and give its path in the "
                        "environment's CNRG_BENCH_PROGRAM")
    return found


def systems() -> list[System]:
    """Those built in, ours first. `mantyla-double:1e-8` is one, too, with another epsilon, for any epsilon."""
    with tempfile.TemporaryDirectory() as folder:
        _ask(["turned", "--describe", "--out", folder])
        return [System(**data) for data in json.loads(Path(folder, "rows", "systems.json").read_bytes())]


def run(
    experiment: str | os.PathLike[str] | Node | Tree,
    *,
    systems: Iterable[str] = (),
    operations: Iterable[str] = (),
    values: Mapping[str, Any] | None = None,
    programs: Mapping[str, str | os.PathLike[str]] | None = None,
    seconds: float | None = None,
    gigabytes: float | None = None,
    jobs: int = 1,
    folder: str | os.PathLike[str] | None = None,
) -> Rows:
    """Gives the problems of an experiment to systems.

    experiment: the name of one of the source, the path of a file or of a folder of meshes, or a node or a tree, whose
    result is the problem.
    systems: names; without any those of the experiment, or all. programs: further ones by name, each a path, or
    PATH:ROUNDING.
    operations: of an experiment that has them as values of its parameter `operation`. values: of other parameters, in
    place of those of the experiment: {"k": "exact,0..4", "seed": [1, 2]}.
    seconds, gigabytes: limits of each run. jobs: runs at a time.
    folder: keeps the rows, and `model.yaml` of a node; the same call goes on where it was. Only rows of this call are returned.

    Raises InputError for what the program refuses, FileError if there is no program.
    """
    given = {name: value if isinstance(value, str) else ",".join(map(str, _listed(value))) for name, value in (values or {}).items()}
    chosen = ",".join(_listed(operations))
    if chosen:
        given["operation"] = chosen
    options = [word for name, value in given.items() for word in ("-D", f"{name}={value}")]
    for name, path in (programs or {}).items():
        options += ["--system", f"{name}={os.fspath(path)}"]
    names = ",".join(_listed(systems))
    if names:
        options += ["--systems", names]
    for option, number in (("--seconds", seconds), ("--gigabytes", gigabytes)):
        if number is not None:
            options += [option, repr(number)]
    with tempfile.TemporaryDirectory() as own:
        out = Path(own if folder is None else folder)
        words = [_named(experiment, out), *options]
        planned = [line.split("\t") for line in _ask([*words, "--dry-run"]).splitlines()]
        _ask([*words, "--quiet", "--jobs", str(jobs), "--out", str(out)])
        return Rows(json.loads((out / "rows" / problem / f"{system}.json").read_bytes()) for problem, system in planned)


def judge(answer: Any, operands: Sequence[Any], operation: str, *, rounding: float = 0) -> Mapping[str, Any]:
    """The verdict on a mesh that somebody says is the Boolean of the operands: a row (`verdict`, `message`, `facts` of
    the answer, `truth`, `confirmation`, ...).

    answer: points, doubles as (n, 3), and faces, lists of places among them, counter-clockwise as seen from outside.
    operands: two or more of the same form, or nodes, whose faces are given as they are. operation: `union`,
    `difference` or `intersection`.
    rounding: how far points of the answer may be off, as a part of the largest coordinate.
    """
    model = _model(operands, operation)
    points, faces = answer
    points = numpy.asarray(points, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"judge: points of the answer are an array (n, 3), not {points.shape}")
    with tempfile.TemporaryDirectory() as own:
        off = Path(own, "answer.off")
        lines = ["OFF", f"{len(points)} {len(faces)} 0"]
        lines += [" ".join(map(repr, point)) for point in points.tolist()]
        lines += [" ".join(map(str, [len(face), *map(int, face)])) for face in faces]
        off.write_text("\n".join(lines) + "\n")
        copy = Path(own, "copy")
        copy.write_text(f'#!/bin/sh\nexec cp {shlex.quote(str(off))} "$4"\n')
        copy.chmod(0o755)
        row = _one(model, "answer", ["--system", f"answer={copy}:{rounding!r}"], Path(own)).row
    if row["verdict"] in ("refused", "crashed"):
        raise InputError(f"judge: {row['stage']}: {row['message']}")
    return row


def mantyla(a: Any, b: Any, operation: str, *, epsilon: float | None = None) -> Kept:
    """Mäntylä's Boolean of two solids, nodes or points and faces, judged: in exact fractions, or in doubles with this
    epsilon."""
    system = "mantyla-exact" if epsilon is None else f"mantyla-double:{epsilon!r}"
    with tempfile.TemporaryDirectory() as own:
        return _one(_model([a, b], operation), system, [], Path(own))


def _listed(value: Any) -> list[str]:
    return [value] if isinstance(value, str) else [str(one) for one in value] if isinstance(value, Iterable) else [str(value)]


def _model(operands: Sequence[Any], operation: str) -> Node:
    if operation not in _OPERATIONS:
        raise ValueError(f"there is no operation {operation!r}; there are " + ", ".join(_OPERATIONS))
    nodes = [one if isinstance(one, Node) else mesh(*one) for one in operands]
    if len(nodes) < 2:
        raise ValueError("two operands or more are wanted")
    return _OPERATIONS[operation](*nodes)


def _named(experiment: Any, folder: Path) -> str:
    """The word of the program for an experiment; of nodes and trees a file in the folder."""
    if isinstance(experiment, (Node, Tree)):
        text = experiment.to_yaml(folder)
        if "\nx-experiment:" not in text:
            text += "x-experiment: {title: a model of a script}\n"
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / "model.yaml"
        path.write_text(text)
        return str(path)
    return os.fspath(experiment)


def _one(model: Node, system: str, options: list[str], folder: Path) -> Kept:
    """The only problem of a model, with the result of the system."""
    words = [_named(model, folder), *options]
    problem = _ask([*words, "--systems", system, "--dry-run"]).split("\t")[0]
    kept = folder / "kept"
    row = json.loads(_ask([*words, "--one", problem, system, "--keep", str(kept)]))
    tree = read(kept / "problem.yaml")
    return Kept(row, tree["given"] if "given" in tree else None)


def _ask(words: list[str]) -> str:
    """What the program prints. Raises InputError with its message."""
    done = subprocess.run([program(), *words], capture_output=True, text=True)
    if done.returncode == 0:
        return done.stdout
    said = [line.removeprefix("bench/run: ").removeprefix("error: ") for line in done.stderr.splitlines() if "error:" in line]
    raise InputError("bench: " + (said[0] if said else f"the program ended with status {done.returncode}"))
