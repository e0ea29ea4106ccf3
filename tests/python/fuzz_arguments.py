#!/usr/bin/env python3
"""Calls everything public of the module with arguments that nobody should give.

Only what is documented may come out: an error of cnrg, TypeError, ValueError and the like, or what an argument raised
itself. A crash, a call without an end, and any other exception is a bug. Calls are made by processes of their own, so
that a crash is told with the call that made it; each call follows from the seed and its number alone.

  PYTHONPATH=build/release/csg/python tests/python/fuzz_arguments.py --calls 100000 --seed 7
  ... --seed 7 --only 4711     one call again, with what it raised
"""

import argparse
import inspect
import os
import random
import subprocess
import sys
import tempfile
import time
import traceback
import warnings
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy

import cnrg

LONGEST_CALL = 30  # seconds
CALLS_OF_A_PROCESS = 5000


class Mine(Exception):
    """Raised by an argument: it may come out."""


ALLOWED = (cnrg.Error, TypeError, ValueError, ArithmeticError, KeyError, IndexError, AttributeError, RecursionError,
           NotImplementedError, OSError, ImportError, Mine)


# --- values

class FailingFloat(float):
    def __float__(self):
        raise Mine

    def as_integer_ratio(self):
        raise Mine


class FailingIndex:
    def __index__(self):
        raise Mine


class FailingText(str):
    def __str__(self):
        raise Mine

    def __eq__(self, other):
        raise Mine

    __hash__ = str.__hash__


class FailingIterator:
    def __iter__(self):
        return self

    def __next__(self):
        raise Mine


class FailingRatio:
    numerator = property(lambda self: (_ for _ in ()).throw(Mine()))
    denominator = 1


class FailingPath:
    def __fspath__(self):
        raise Mine


class StrangePath:
    def __fspath__(self):
        return b"bytes.vtu"


class FailingSequence:
    def __len__(self):
        return 3

    def __getitem__(self, i):
        raise Mine


class LyingSequence:
    """Says that it has three items, and has one."""

    def __len__(self):
        return 3

    def __getitem__(self, i):
        if i:
            raise IndexError(i)
        return 0


class LyingRatio:
    numerator, denominator = 1, 0


class LyingIndex:
    def __index__(self):
        return "three"


def closed_generator():
    generator = (i for i in range(3))
    generator.close()
    return generator


def recursive_list():
    out = [0, 1]
    out.append(out)
    return out


def recursive_map():
    out = {"a": 1}
    out["b"] = out
    return out


def deep_list(depth):
    out = []
    for _ in range(depth):
        out = [out]
    return out


def an_array(r):
    shape = r.choice([(3,), (0,), (4, 3), (0, 3), (4, 2), (3, 4), (2, 2, 3), (), (1,)])
    kind = r.choice(["f8", "f4", "f2", ">f8", "<i4", ">i8", "u1", "u8", "c16", "?", "O", "U3", "S3", "g", "M8[s]", "V4"])
    array = numpy.zeros(shape, dtype=kind)
    if array.dtype.kind in "fiu" and array.size:
        flat = numpy.array([r.randrange(-3, 9) for _ in range(array.size)]).astype("f8")
        array = numpy.abs(flat).reshape(shape).astype(kind)
    how = r.randrange(6)
    if how == 0 and array.ndim:
        array = array[::-1]
    elif how == 1 and array.ndim > 1:
        array = numpy.asfortranarray(array)
    elif how == 2:
        array.setflags(write=False)
    elif how == 3 and array.dtype.kind == "f" and array.size:
        array.flat[r.randrange(array.size)] = r.choice([numpy.nan, numpy.inf, -numpy.inf])
    elif how == 4 and array.ndim:
        array = numpy.repeat(array, 2, axis=-1)[..., ::2]
    elif how == 5:
        array = numpy.ma.masked_array(array) if array.dtype.kind in "fiu" else array
    return array


NUMBERS = [0, 1, 2, 3, 7, -1, 255, 2**31, 2**63, -2**63, 2**64, 10**30, 0.5, 1.0, -0.0, 1e300, -1e300, 5e-324,
           float("nan"), float("inf"), -float("inf"), "1/3", "0.1", "1e9", "1/0", "nan", "1e999999999", "٣", "0x10",
           Fraction(1, 3), Fraction(-7, 2), Decimal("0.1"), Decimal("NaN"), Decimal("Infinity"), Decimal("1e-30"),
           Decimal("1E+1000000"), True, False, numpy.float32(0.1), numpy.float64(2.5), numpy.int8(-3),
           numpy.uint64(2**64 - 1), numpy.longdouble(1) / 3, numpy.float16("nan"), numpy.bool_(True),
           numpy.datetime64(0, "s"), 1j]
TEXTS = ["", "a", "rock", "a b", "ä€𝄞", "\ud800", "x\0y", "a" * 5000, "true", "null", "- a", "{", "&a", "*a", "a: b", "'",
         '"', "\\", "\n", "\t", "\u202e", "#c", "%", "!t", "union", "f0", "v0", "e0", "r0", "r1", "f99999999999999999999", "c1",
         "points", "features", "left", "#ff0000", "winding", "parity", "cells", "none", "region", "x=0"]
PATHS = ["out.vtu", "out.json", "out.stl", "out.msh", "out.obj", "out.ply", "out.off", "out.svg", "out.png", "out.html", "out",
         "", ".", "/", "no/such/folder/x.vtu", "no.off", "no.step", "no.yaml", "tree.yaml", "mesh.off", "heights.asc",
         "\0", "a" * 300 + ".vtu", "\ud800.vtu", b"bytes.off", Path("out.mesh"), Path("mesh.off"), StrangePath(),
         FailingPath(), 3, None]


TREES = ["cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n", "cnrg: 1\nnodes: {a: {union: [b, b]}, "
         "b: {mesh: {points: [[0, 0, 0]], faces: []}}}\nresult: a\n", "cnrg: 1\nnodes: {a: {mesh: {file: mesh.off}}}\nresult: a\n",
         "{}", "cnrg: 1", "a: &a [*a]", "cnrg: 1\nnodes: {\"\\uD800\": {points: [[0, 0, 0]]}}\nresult: b\n"]
# What attributes take.
KEYS = {"material": lambda r: r.choice(TEXTS), "name": lambda r: r.choice(TEXTS), "dominance": lambda r: number(r),
        "translate": lambda r: point(r), "mirror": lambda r: {"normal": point(r)}, "scale": lambda r: r.choice([number(r), point(r)]),
        "rotate": lambda r: {"axis": point(r), "degrees": number(r)}, "regularize": lambda r: r.choice([True, False, 1]),
        "simplify": lambda r: r.choice(TEXTS)}


def strange(r):
    """Of any kind at all."""
    make = r.choice([
        lambda: None, lambda: object(), lambda: r.choice(NUMBERS), lambda: r.choice(NUMBERS), lambda: r.choice(TEXTS),
        lambda: r.choice(TEXTS), lambda: r.choice(PATHS), lambda: an_array(r), lambda: an_array(r),
        lambda: [r.choice(NUMBERS) for _ in range(r.randrange(5))], lambda: tuple(TEXTS[:3]), lambda: {}, lambda: set(),
        lambda: {r.choice(TEXTS): r.choice(NUMBERS)}, lambda: {1: 2, None: 3}, lambda: [[1, 2], [3]], lambda: b"bytes",
        lambda: bytearray(3), lambda: memoryview(b"abc"), lambda: FailingFloat(1), FailingIndex, lambda: FailingText("a"),
        FailingIterator, FailingRatio, FailingSequence, LyingSequence, LyingRatio, LyingIndex, closed_generator,
        recursive_list, recursive_map, lambda: deep_list(50), lambda: deep_list(3000), lambda: 10**200000,
        lambda: range(4), lambda: int, lambda: len, lambda: Ellipsis, lambda: slice(0, 1, 2),
        lambda: (i for i in range(3)), lambda: iter([[0, 0, 0], [1, 0, 0]]), lambda: type("T", (), {})(),
        lambda: r.choice(World.values)])
    return make()


def point(r):
    """Mostly a good one."""
    if r.random() < 0.1:
        return strange(r)
    values = [r.choice([0, 1, 2, 3, -1, 0.5, "1/3", Fraction(5, 7), Decimal("0.1"), numpy.float64(0.25)]) for _ in range(3)]
    if r.random() < 0.1:
        values[r.randrange(3)] = r.choice(NUMBERS)
    return r.choice([list, tuple, lambda v: v])(values)


def points(r):
    return [point(r) for _ in range(r.randrange(2, 6))]


def number(r):
    return r.choice([1, 2, 3, 0.5, "1/3", Fraction(3, 2)]) if r.random() < 0.8 else r.choice(NUMBERS)


def node(r):
    return r.choice(World.nodes) if r.random() < 0.9 else strange(r)


def small(r):
    return r.choice([None, 3, 4, 8, 12, 0, -1, 2**40, "5", 4.0, 4.5, numpy.int64(6), True, float("nan")])


# What an argument of this name may be, so that calls get further than to its type.
BY_NAME = {
    **dict.fromkeys(("min", "max", "from_", "to", "center", "axis", "point", "normal", "vector", "base", "apex", "a", "b", "c",
                     "d", "vec"), point),
    **dict.fromkeys(("radius", "degrees", "factor", "height", "major", "minor", "weld", "top", "bottom"), number),
    "points": lambda r: r.choice([points(r), [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], numpy.eye(4, 3), an_array(r)]),
    **dict.fromkeys(("vertices", "outline", "loop", "control", "profile"), points),
    **dict.fromkeys(("self", "model", "left", "right", "node", "nodes", "operands"), node),
    "other": lambda r: r.choice([node(r), r.choice(World.results)]),
    **dict.fromkeys(("which", "what"), lambda r: r.choice(["f0", "e1", "v2", "r0", "r1", "a", "b", 0, -1, 99, point(r), node(r),
                                                           strange(r)])),
    **dict.fromkeys(("component", "i", "index", "number", "region"),
                    lambda r: r.choice([0, 1, 2, -1, 10**9, 2**70, numpy.int8(1), 0.5, "1"])),
    **dict.fromkeys(("segments", "rings", "threads", "degree", "chord"), small),
    **dict.fromkeys(("path", "file", "folder", "inside"), lambda r: r.choice(PATHS)),
    "text": lambda r: r.choice(TREES + TEXTS),
    **dict.fromkeys(("name", "key", "color", "mode", "dominance", "fill", "cell", "title", "format"), lambda r: r.choice(TEXTS)),
    "faces": lambda r: r.choice([[[0, 1, 2]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], an_array(r), [[0, 1, 99]],
                                 [[-1, 0, 1]], [[]], [[0, 1]], numpy.array([[0, 1, 2]], dtype=">i4"), strange(r)]),
    "each": lambda r: r.choice([True, False, None]),
    # What costs minutes is not tried: a mesh of a small volume, a bound that cannot be kept.
    "max_volume": lambda r: r.choice([None, 1, "1", 0, -1, float("nan"), float("inf"), "x"]),
    "size": lambda r: r.choice([None, 1, "1", 0, -1, float("nan"), float("inf"), "x"]),
    "growth": lambda r: r.choice([None, 0.3, "1/2", 0, -1, float("nan"), float("inf"), "x"]),
    "max_points": lambda r: r.choice([100, 1000, 0, -1, 2**70, "9", 1.5]),
    "order": lambda r: r.choice([1, 2, 0, 3, "2", 1.0]),
    **dict.fromkeys(("quads", "curved", "surface_first", "keep_boundary"), lambda r: r.choice([True, False, 1, None])),
    "quality": lambda r: r.choice([None, 0, 2, 1.4, -1, float("nan"), 1e9, "x"]),
    "seconds": lambda r: r.choice([None, 5, 0.5, -1, float("nan"), "x"]),
    "progress": lambda r: r.choice([None, False, lambda *a: None, failing_progress, 3, "x", len]),
}


def failing_progress(*arguments):
    raise Mine


class World:
    """Objects that calls are made on."""
    nodes, results, values, targets = [], [], [], []

    @classmethod
    def create(cls):
        Path("mesh.off").write_text("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        Path("tree.yaml").write_text("cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n")
        a = cnrg.box([0, 0, 0], [2, 2, 2], material="rock", name="a")
        b = cnrg.box([1, 1, 1], [3, 3, 3]).named("b")
        ball = cnrg.sphere([0, 0, 0], 1, segments=8)
        mesh = cnrg.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        wire = cnrg.polyline([[0, 0, 0], [1, 2, 3]])
        cls.nodes = [a, b, ball, mesh, wire, a | b, a - b, ~b, (a & b).closure(), cnrg.sum(a, wire)]
        tree = cnrg.read("tree.yaml")
        evaluation = cnrg.evaluate(a | b, b)
        results = [evaluation.result, evaluation["b"], (~b).evaluate(), wire.evaluate()]
        cls.results = results
        parts = [results[0].vertices, results[0].edges, results[0].faces, results[0].regions, results[0].explain("f0"),
                 results[0].topology(), results[0].locate([[1, 1, 1]]), results[0].tetrahedralize(),
                 results[0].mesh_surface(), results[0].mesh_surface(quads=True), results[3].mesh_surface(order=2),
                 results[0].edges.around, results[0].exact_points, results[0].compare(results[0])]
        cls.values = [*cls.nodes, tree, evaluation, *results, *parts, cnrg.material("ore")]
        # Classes other than those of errors are not for users to make something by.
        cls.targets = [("cnrg." + n, getattr(cnrg, n)) for n in cnrg.__all__
                       if not isinstance(getattr(cnrg, n), type) or issubclass(getattr(cnrg, n), Exception)]
        for value in [a | b, ball, tree, evaluation, *results, *parts]:
            for n in dir(type(value)):
                if not n.startswith("_") or n in ("__getitem__", "__contains__", "__or__", "__sub__", "__and__"):
                    cls.targets.append((f"{type(value).__name__}.{n}", (value, n)))


def arguments_for(r, function):
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):
        return [strange(r) for _ in range(r.randrange(4))], {}
    values, named = [], {}
    sane = r.choice([0.5, 0.8, 0.98])

    def value_of(name):
        make = BY_NAME.get(name, strange) if r.random() < sane else strange
        return make(r)

    for p in parameters:
        if p.kind == p.VAR_POSITIONAL:
            values += [value_of(p.name) for _ in range(r.randrange(3))]
        elif p.kind == p.VAR_KEYWORD:
            for key in r.sample(sorted(KEYS), r.choice([0, 0, 1, 2])):
                named[key] = KEYS[key](r) if r.random() < sane else strange(r)
            if r.random() < 0.05:
                named["nonsense"] = strange(r)
        elif p.default is p.empty or r.random() < 0.3:
            if p.kind == p.KEYWORD_ONLY:
                named[p.name] = value_of(p.name)
            elif named:
                named[p.name] = value_of(p.name)
            else:
                values.append(value_of(p.name))
        elif p.kind != p.KEYWORD_ONLY:
            break
    if r.random() < 0.03 and values:
        values.pop()
    if r.random() < 0.03:
        values.append(strange(r))
    return values, named


def shown(value):
    """A value without running any of it."""
    try:
        text = object.__repr__(value) if type(value).__module__ == __name__ else repr(value)
    except Exception as e:
        text = f"<{type(value).__name__} whose repr raises {type(e).__name__}>"
    return (text if len(text) < 200 else text[:200] + "...").encode("ascii", "backslashreplace").decode()


def call(seed, i, log, raising):
    """Makes one call; what it raises that is not allowed is returned."""
    r = random.Random(f"{seed}/{i}")
    numpy.seterr(all="ignore")
    name, target = r.choice(World.targets)
    function = target
    if isinstance(target, tuple):
        value, attribute = target
        log(f"{i} {name}")
        try:
            function = getattr(value, attribute)
        except ALLOWED:
            return None
        if not callable(function):
            return None
    values, named = arguments_for(r, function)
    words = [shown(v) for v in values] + [f"{key}={shown(v)}" for key, v in named.items()]
    log(f"{i} {name}({', '.join(words)})")
    try:
        function(*values, **named)
    except ALLOWED as e:
        if raising:
            traceback.print_exc()
        if isinstance(e, (cnrg.InvariantError, cnrg.Stopped)):
            return "".join(traceback.format_exception(e))
        str(e).encode("utf-8", "backslashreplace")
    except BaseException as e:
        return "".join(traceback.format_exception(e))
    return None


def work(seed, first, count, raising=False):
    """In a process of its own: calls one after the other, each told before it is made."""
    warnings.simplefilter("ignore")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        World.create()
        for i in range(first, first + count):
            fault = call(seed, i, lambda text: print(text, flush=True), raising)
            if fault:
                print(f"FAULT {i}\n{fault}", flush=True)
        os.chdir("/")
    print("END", flush=True)


def run(seed, first, count):
    """Makes calls in a process; gives how many were made, and what was wrong with the last one."""
    with tempfile.TemporaryFile("w+") as log:
        child = subprocess.Popen([sys.executable, os.path.abspath(__file__), "--seed", str(seed), "--work", str(first), str(count)],
                                 stdout=log, stderr=subprocess.STDOUT)
        size, since = 0, time.monotonic()
        while child.poll() is None:
            time.sleep(0.2)
            now = os.fstat(log.fileno()).st_size
            if now != size:
                size, since = now, time.monotonic()
            elif time.monotonic() - since > LONGEST_CALL:
                child.kill()
                child.wait()
                break
        log.seek(0)
        lines = log.read().splitlines()
    faults = [i for i, line in enumerate(lines) if line.startswith("FAULT ")]
    said = "\n".join(lines[max(0, faults[0] - 1):][:60]) if faults else ""
    made = len({line.split()[0] for line in lines if line.split(" ")[0].isdigit()})
    if lines and lines[-1] == "END":
        return made, said
    how = f"it took more than {LONGEST_CALL} s" if child.returncode == -9 else f"the process ended with {child.returncode}"
    return made, said + f"\n{how}:\n" + "\n".join(lines[-20:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--calls", type=int, default=3000)
    parser.add_argument("--only", type=int, metavar="I", help="make this call alone, and show what it raises")
    parser.add_argument("--work", type=int, nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.work:
        return work(options.seed, *options.work)
    if options.only is not None:
        return work(options.seed, options.only, 1, True)
    made, wrong = 0, 0
    for first in range(0, options.calls, CALLS_OF_A_PROCESS):
        end = min(options.calls, first + CALLS_OF_A_PROCESS)
        while first < end:
            n, said = run(options.seed, first, end - first)
            made += n
            if said:
                wrong += 1
                print(f"seed {options.seed}: {said}\n")
            if n == 0:
                break
            first += n
    print(f"{made} calls, {wrong} faults")
    sys.exit(1 if wrong or made < options.calls else 0)


if __name__ == "__main__":
    main()
