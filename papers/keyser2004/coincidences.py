#!/usr/bin/env python3
"""coincidences.py PROGRAM: surfaces that coincide or touch, in the program `cnrg` and in four others, as a table.

Each case is described once, as shapes and one expression of them, and written as a tree, as scripts for OpenCASCADE's
DRAW, Manifold and OpenSCAD, and as meshes for CGAL. Shapes of triangles have the same number of segments everywhere.
What is not there is a column of dashes, and a line on standard error says what to install:
  --draw COMMAND      DRAW of OpenCASCADE (occt-draw-7.6; Debian: occt-draw and libocct-draw-dev)
  --openscad COMMAND  OpenSCAD (openscad)
  --manifold FOLDER   the npm package manifold-3d, such as node_modules/manifold-3d
  --cgal COMMAND      coincidences_cgal.cpp of this folder, compiled: c++ -std=c++20 -O2 FILE -o NAME -lgmp -lmpfr
  --only TEXT         cases with this text in their names;  --keep FOLDER  for what is written (default: gone after)"""
import argparse
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

LIMIT = 60  # seconds of one run

# --- shapes


class Shape:
    """`kind` and its parameters; `turn` is (axis, degrees, centre)."""

    def __init__(self, kind, turn=None, **parameters):
        self.kind, self.turn = kind, turn
        self.__dict__.update(parameters)


def box(low, high):
    return Shape("box", low=low, high=high)


def ball(centre, radius, n, turn=None):
    return Shape("ball", turn and (*turn, centre), centre=centre, radius=radius, n=n)


def cone(a, b, radius, top, n, turn=None):
    return Shape("cone", turn and (*turn, a), a=a, b=b, radius=radius, top=top, n=n)


def cylinder(a, b, radius, n, turn=None):
    return cone(a, b, radius, radius, n, turn)


def torus(radius, tube, n, turn=None):
    return Shape("torus", turn and (*turn, (0, 0, 0)), radius=radius, tube=tube, n=n)


def frame(a, b):
    """Columns x, y, z of unit length, z from a to b, and the distance."""
    z = [q - p for p, q in zip(a, b)]
    length = math.dist(a, b)
    z = [c / length for c in z]
    other = (1, 0, 0) if abs(z[0]) < 0.5 else (0, 1, 0)
    y = cross(z, other)
    y = [c / math.hypot(*y) for c in y]
    return cross(y, z), y, z, length


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def numbers(*values):
    return " ".join(repr(float(v)) for v in values)


# --- cases: shapes by letter, an expression in the order of a calculator (+ union, - difference, x intersection), and
# what it is: solids, voids and volume, or where A x B has no volume `face`, `line` (also a circle) or `point`.
TILT = ((1, 2, 3), 10)
AROUND = ((0, 0, 1), 10)
BLOCK = box((-2, -2, 0), (2, 2, 4))
PATCH = [[(0, 0, 0), (1, 0, 1), (2, 0, 0)], [(0, 1, 1), (1, 1, 3), (2, 1, 1)], [(0, 2, 0), (1, 2, 1), (2, 2, 0)]]


def first_half(patch):
    """The half of a Bezier patch of degree 2 where u, along its rows, is up to 1/2."""
    middle = lambda p, q: tuple((a + b) / 2 for a, b in zip(p, q))
    halves = []
    for a, b, c in patch:
        left, right = middle(a, b), middle(b, c)
        halves.append([a, left, middle(left, right)])
    return halves


def shapes(*values):
    return dict(zip("ABCDE", values))


CASES = [
    ("shaft in its bore, both of 32 segments", shapes(BLOCK, cylinder((0, 0, 0), (0, 0, 4), 1, 32),
     cylinder((0, 0, 0), (0, 0, 4), 1, 32)), "AB-C+", dict(solids=1, volume=64)),
    ("shaft of 24 segments, turned, in its bore of 32", shapes(BLOCK, cylinder((0, 0, 0), (0, 0, 4), 1, 32),
     cylinder((0, 0, 0), (0, 0, 4), 1, 24, AROUND)), "AB-C+", dict(solids=1, volume=64)),
    ("ball less the same ball turned", shapes(ball((0, 0, 0), 1, 32), ball((0, 0, 0), 1, 32, TILT)), "AB-",
     dict(solids=0)),
    ("a cylinder less two that overlap in it", shapes(cylinder((0, 0, 0), (0, 0, 3), 1, 32),
     cylinder((0, 0, 0), (0, 0, 2), 1, 24), cylinder((0, 0, 1), (0, 0, 3), 1, 40)), "AB-C-", dict(solids=0)),
    ("ball less the pin that it ends: half a ball", shapes(ball((0, 0, 0), 1, 32, TILT),
     cylinder((0, 0, -2), (0, 0, 0), 1, 24)), "AB-", dict(solids=1)),
    ("ball less three rounded edges that end in it: an eighth", shapes(ball((0, 0, 0), 1, 32),
     cylinder((-2, 0, 0), (0, 0, 0), 1, 32), cylinder((0, -2, 0), (0, 0, 0), 1, 32),
     cylinder((0, 0, -2), (0, 0, 0), 1, 32)), "AB-C-D-", dict(solids=1)),
    ("torus less its two halves, one turned", shapes(torus(2, 0.5, 32), box((-3, 0, -1), (3, 3, 1)),
     torus(2, 0.5, 24, AROUND), box((-3, -3, -1), (3, 0, 1))), "AABx-CDx-", dict(solids=0)),
    ("cone in its countersink", shapes(BLOCK, cone((0, 0, 4), (0, 0, 1), 1.5, 0, 32),
     cone((0, 0, 4), (0, 0, 1), 1.5, 0, 24, AROUND)), "AB-C+", dict(solids=1, volume=64)),
    ("ball, tilted, on a box", shapes(ball((0, 0, 1), 1, 32, TILT), box((-2, -2, -1), (2, 2, 0))), "ABx",
     dict(contact="point")),
    ("ball, not tilted, on a box", shapes(ball((0, 0, 1), 1, 32), box((-2, -2, -1), (2, 2, 0))), "ABx",
     dict(contact="point")),
    ("torus on a box", shapes(torus(2, 0.5, 32), box((-3, -3, -2), (3, 3, -0.5))), "ABx", dict(contact="line")),
    ("two balls, one tilted", shapes(ball((0, 0, 0), 5, 32), ball((2, 10, 11), 10, 24, TILT)), "ABx",
     dict(contact="point")),
    ("two cylinders side by side", shapes(cylinder((0, 0, 0), (0, 0, 4), 3, 32),
     cylinder((3, 4, 1), (3, 4, 3), 2, 24)), "ABx", dict(contact="line")),
    ("ball, tilted, in a pipe of its radius", shapes(ball((0, 0, 2), 1, 32, TILT), BLOCK,
     cylinder((0, 0, 0), (0, 0, 4), 1, 24)), "ABC-x", dict(contact="line")),
    ("boxes that share part of a face", shapes(box((0, 0, 0), (1, 1, 1)), box((1, 0.5, 0.3), (2, 2, 2))), "ABx",
     dict(contact="face")),
    ("boxes that share part of an edge", shapes(box((0, 0, 0), (1, 1, 1)), box((1, 1, 0.3), (2, 2, 2))), "ABx",
     dict(contact="line")),
    ("boxes that share a vertex", shapes(box((0, 0, 0), (1, 1, 1)), box((1, 1, 1), (2, 2, 2))), "ABx",
     dict(contact="point")),
    ("boxes that are 1e-8 apart", shapes(box((0, 0, 0), (1, 1, 1)), box((1.00000001, 0, 0), (2, 1, 1))), "ABx",
     dict(contact=None)),
    ("boxes that overlap by 1e-8", shapes(box((0, 0, 0), (1, 1, 1)), box((0.99999999, 0, 0), (2, 1, 1))), "ABx",
     dict(solids=1)),
    ("shaft in a bore that is 1e-8 wider: a gap", shapes(BLOCK, cylinder((0, 0, 0), (0, 0, 4), 1.00000001, 32),
     cylinder((0, 0, 0), (0, 0, 4), 1, 32)), "AB-C+", dict(solids=2)),
    ("box less a sheet: two solids", shapes(box((0, 0, 0), (2, 2, 2)), Shape("sheet", corners=[
        (1, -1, -1), (1, 3, -1), (1, 3, 3), (1, -1, 3)])), "AB-", dict(solids=2, volume=8)),
    ("Bezier patch and a half of it", shapes(Shape("patch", rows=PATCH), Shape("patch", rows=first_half(PATCH))), "ABx",
     dict(contact="face")),
    ("bolt in its hole, two solids of one STEP file", shapes(Shape("step", number=1), Shape("step", number=2)), "AB+",
     dict(solids=1, volume=48)),
]
# The STEP file: a block with a stepped hole, and the bolt in it, each made of its own cylinders.
STEP = """box k -2 -2 -1 4 4 3
pcylinder h1 .8 2; ttranslate h1 0 0 -1.; pcylinder h2 1.4 1; ttranslate h2 0 0 1; bcut k1 k h1; bcut k2 k1 h2
pcylinder s1 .8 2; ttranslate s1 0 0 -1.; trotate s1 0 0 0 0 0 1 10; pcylinder s2 1.4 1; ttranslate s2 0 0 1
trotate s2 0 0 0 0 0 1 25; bfuse b s1 s2
explode k2 So; explode b So; compound k2_1 b_1 all; stepwrite a all {file}
"""


def described(found, should):
    """A cell: `right`, or what was found. `contact` is what a program says where there is no solid."""
    solids, voids, volume, contact = (found.get(key) for key in ("solids", "voids", "volume", "contact"))
    if "contact" in should:
        if solids:
            return f"overlap: {solids} slivers, {volume:.2g}" if solids > 1 else f"overlap: 1 sliver, {volume:.2g}"
        if contact == should["contact"]:
            return "right"
        return f"a {contact}" if contact else "no overlap" if found.get("regular") else "apart"
    right = solids == should["solids"] and not voids and (
        "volume" not in should or abs(volume - should["volume"]) <= 1e-9 * should["volume"])
    if right:
        return "right"
    words = [f"{solids} solid{'s' * (solids != 1)}"] + [f"{voids} void{'s' * (voids != 1)}"] * (voids > 0)
    return ", ".join(words) + (f", {volume:.7g}" if "volume" in should else f", {volume:.3g}")


class Failure(Exception):
    """What a program says instead of a result."""


def run(arguments, **more):
    try:
        return subprocess.run([str(a) for a in arguments], capture_output=True, text=True, timeout=LIMIT, **more)
    except subprocess.TimeoutExpired:
        raise Failure(f"nothing in {LIMIT} s") from None


def folded(expression, operand, operate):
    stack = []
    for letter in expression:
        if letter in "+-x":
            b = stack.pop()
            stack[-1] = operate(letter, stack[-1], b)
        else:
            stack.append(operand(letter))
    return stack.pop()


def number_of(text, name):
    match = re.search(rf"{name}\s*: *([-+.\de]+)", text)
    return float(match.group(1)) if match else 0.0


# --- the programs: absent() is what to install, or nothing; evaluate(case's shapes, expression, should) what was found


class Ours:
    title = "cnrg"

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def absent(self):
        return ""

    def node(self, s):
        p = lambda v: "[" + ", ".join(repr(x) for x in v) + "]"
        leaf = {
            "box": lambda: f"box: {{min: {p(s.low)}, max: {p(s.high)}}}",
            "ball": lambda: f"sphere: {{center: {p(s.centre)}, radius: {s.radius}, segments: {s.n}}}",
            "cone": lambda: f"cone: {{from: {p(s.a)}, to: {p(s.b)}, radius: {s.radius}, top: {s.top}, "
                            f"segments: {s.n}}}",
            "torus": lambda: f"torus: {{center: [0, 0, 0], axis: [0, 0, 1], radius: {s.radius}, tube: {s.tube}, "
                             f"segments: {s.n}}}",
            "sheet": lambda: f"polygon: [{', '.join(map(p, s.corners))}]",
            "patch": lambda: f"bezier: {{patch: [{', '.join('[' + ', '.join(map(p, r)) + ']' for r in s.rows)}]}}",
            "step": lambda: f"step: {{file: {self.folder / 'bolt.step'}, solids: [{s.number}]}}",
        }[s.kind]()
        turn = s.turn and f", rotate: {{axis: {p(s.turn[0])}, degrees: {s.turn[1]}, center: {p(s.turn[2])}}}"
        return f"{{{leaf}{turn or ''}}}"

    def evaluate(self, shapes, expression, should):
        if any(s.kind == "step" for s in shapes.values()) and not (self.folder / "bolt.step").exists():
            return None
        words = {"+": "union", "-": "difference", "x": "intersection"}
        split = any(s.kind == "sheet" for s in shapes.values())  # cl(A - B) is A again: the sheet parts the box instead
        root = folded(expression, lambda letter: letter, lambda op, a, b: f"{{union: [{b}, {a}], dominance: left}}"
                      if split else f"{{{words[op]}: [{a}, {b}]}}")
        nodes = "".join(f"  {letter}: {self.node(s)}\n" for letter, s in shapes.items())
        tree = self.folder / "case.yaml"
        tree.write_text(f"cnrg: 1\nnodes:\n{nodes}  result: {root}\n  around: {{complement: result}}\nresult: result\n")
        done = run([self.program, "eval", tree, "--node", "result", "--node", "around"])
        if done.returncode:
            raise Failure(next(line for line in done.stderr.splitlines() if "error: " in line))
        rows = {line.split()[0]: line.split() for line in done.stdout.splitlines()}
        head, row = rows["node"], rows["result"]
        value = dict(zip(head, row))
        dims = [("face", "faces"), ("line", "edges"), ("point", "vertices")]
        contact = next((kind for kind, column in dims if int(value[column])), None)
        return {"solids": int(value["regions"]), "voids": int(dict(zip(head, rows["around"]))["3-cells"]) - 1,
                "volume": fraction(row[-1].strip("()")), "contact": contact}

    def off(self, shape, file):
        """The shape by itself, as a mesh in `file`."""
        if shape.kind == "sheet":
            corners = "\n".join(numbers(*c) for c in shape.corners)
            file.write_text(f"OFF\n4 1 0\n{corners}\n4 0 1 2 3\n")
            return file
        tree = self.folder / "leaf.yaml"
        tree.write_text(f"cnrg: 1\nnodes:\n  leaf: {self.node(shape)}\nresult: leaf\n")
        run([self.program, "eval", tree, "--quiet", "-o", file], check=True)
        return file


def fraction(text):
    top, _, bottom = text.partition("/")
    return float(top) / float(bottom or 1)


class Cgal:
    def __init__(self, program, how, ours):
        self.program, self.how, self.ours, self.folder = program, how, ours, ours.folder
        self.title = "CGAL " + ("Nef" if how == "nef" else "corefinement")

    def absent(self):
        there = shutil.which(self.program)
        return "" if there else "compile coincidences_cgal.cpp (Debian: libcgal-dev) and give --cgal"

    def evaluate(self, shapes, expression, should):
        kinds = {s.kind for s in shapes.values()}
        if kinds & {"patch", "step"} or (self.how != "nef" and "sheet" in kinds):
            return None
        files = {letter: self.ours.off(s, self.folder / (letter + ".off")) for letter, s in shapes.items()}
        return measured(run([self.program, self.how] + [files.get(w, w) for w in expression]), self.how != "nef")


def measured(done, regular):
    words = done.stdout.split()
    if done.returncode or len(words) != 6 or not words[0].isdigit():
        raise Failure(done.stdout.strip() or f"ended by signal {-done.returncode}")
    solids, voids, faces, edges, vertices = (int(words[i]) for i in (0, 1, 3, 4, 5))
    contact = "face" if faces else "line" if edges else "point" if vertices else None
    return {"solids": solids, "voids": voids, "volume": float(words[2]), "contact": contact, "regular": regular}


class OpenScad:
    title = "OpenSCAD"

    def __init__(self, program, cgal, folder):
        self.program, self.cgal, self.folder = program, cgal, folder

    def absent(self):
        if not shutil.which(self.program):
            return "install OpenSCAD (Debian: openscad)"
        return "" if shutil.which(self.cgal) else "needs --cgal, which reads its results"

    def shape(self, s):
        p = lambda v: "[" + ",".join(repr(float(x)) for x in v) + "]"
        text = {
            "box": lambda: f"translate({p(s.low)}) cube({p([b - a for a, b in zip(s.low, s.high)])});",
            "ball": lambda: f"translate({p(s.centre)}) sphere(r={s.radius},$fn={s.n});",
            "cone": lambda: scad_cone(s),
            "torus": lambda: f"rotate_extrude($fn={s.n}) translate([{s.radius},0]) circle(r={s.tube},$fn=16);",
        }[s.kind]()
        if s.turn:
            axis, degrees, centre = s.turn
            text = f"translate({p(centre)}) rotate({degrees},{p(axis)}) translate({p([-c for c in centre])}) {text}"
        return text

    def evaluate(self, shapes, expression, should):
        if {s.kind for s in shapes.values()} & {"patch", "step", "sheet"}:
            return None
        words = {"+": "union", "-": "difference", "x": "intersection"}
        text = folded(expression, lambda letter: self.shape(shapes[letter]),
                      lambda op, a, b: f"{words[op]}() {{\n{a}\n{b}\n}}")
        source, result = self.folder / "case.scad", self.folder / "case.nef3"
        source.write_text(text + "\n")
        result.unlink(missing_ok=True)
        done = run([self.program, source, "-o", result])
        if "Current top level object is empty" in done.stderr:
            return {"solids": 0, "voids": 0, "volume": 0.0}
        if not result.exists():
            raise Failure(done.stderr.strip().splitlines()[-1])
        return measured(run([self.cgal, "nef", result]), False)


def scad_cone(s):
    x, y, z, length = frame(s.a, s.b)
    rows = ",".join("[" + ",".join(repr(float(v)) for v in (x[i], y[i], z[i], s.a[i])) + "]" for i in range(3))
    return f"multmatrix([{rows},[0,0,0,1]]) cylinder(h={length},r1={s.radius},r2={s.top},$fn={s.n});"


class Manifold:
    title = "Manifold"

    def __init__(self, package, folder):
        self.package, self.folder = package, folder

    def absent(self):
        if not self.package or not (pathlib.Path(self.package) / "manifold.js").exists():
            return "fetch it with `npm install manifold-3d` and give its folder with --manifold"
        return "" if shutil.which("node") else "install Node.js (Debian: nodejs)"

    def shape(self, s):
        list_of = lambda v: "[" + ",".join(repr(float(x)) for x in v) + "]"
        text = {
            "box": lambda: f"M.cube({list_of([b - a for a, b in zip(s.low, s.high)])}).translate({list_of(s.low)})",
            "ball": lambda: f"M.sphere({s.radius},{s.n}).translate({list_of(s.centre)})",
            "cone": lambda: js_cone(s),
            "torus": lambda: f"C.circle({s.tube},16).translate([{s.radius},0]).revolve({s.n})",
        }[s.kind]()
        if s.turn:
            axis, degrees, centre = s.turn
            move = ",".join(repr(v) for v in column_major(rotation(axis, degrees)))
            back = list_of([-c for c in centre])
            text = f"{text}.translate({back}).transform([{move}]).translate({list_of(centre)})"
        return text

    def evaluate(self, shapes, expression, should):
        if {s.kind for s in shapes.values()} & {"patch", "step", "sheet"}:
            return None
        words = {"+": "add", "-": "subtract", "x": "intersect"}
        text = folded(expression, lambda letter: self.shape(shapes[letter]), lambda op, a, b: f"{a}.{words[op]}({b})")
        source = self.folder / "case.mjs"
        source.write_text(
            f"import Module from '{pathlib.Path(self.package).resolve()}/manifold.js';\n"
            "const w = await Module(); w.setup(); const M = w.Manifold, C = w.CrossSection;\n"
            f"const r = {text};\nif (r.status() !== 'NoError') console.log(r.status()); else {{\n"
            "const v = r.decompose().map(p => p.volume());\n"
            "console.log(v.filter(x => x >= 0).length, v.filter(x => x < 0).length, r.volume(), 0, 0, 0); }\n")
        return measured(run(["node", source]), True)


def js_cone(s):
    x, y, z, length = frame(s.a, s.b)
    rows = [[x[i], y[i], z[i], s.a[i]] for i in range(3)]
    move = ",".join(repr(float(v)) for v in column_major(rows))
    return f"M.cylinder({length},{s.radius},{s.top},{s.n}).transform([{move}])"


def rotation(axis, degrees):
    length = math.hypot(*axis)
    n = [c / length for c in axis]
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    skew = [[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]]
    return [[(1 - c) * n[i] * n[j] + c * (i == j) + s * skew[i][j] for j in range(3)] + [0.0] for i in range(3)]


def column_major(rows):
    return [rows[i][j] if i < 3 else float(j == 3) for j in range(4) for i in range(4)]


class Occt:
    title = "OpenCASCADE"

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def absent(self):
        return "" if shutil.which(self.program) else "install its test program (Debian: occt-draw libocct-draw-dev)"

    def draw(self, text):
        source = self.folder / "case.tcl"
        source.write_text("pload MODELING XDE\n" + text + "exit\n")
        done = run([self.program, "-b", "-f", source])
        if done.returncode:
            raise Failure(f"ended by signal {-done.returncode}" if done.returncode < 0 else "failed")
        if "An exception was caught" in done.stdout + done.stderr or "Error:" in done.stdout + done.stderr:
            raise Failure("exception")
        return done.stdout

    def shape(self, s, name):
        text = {
            "box": lambda: f"box {name} {numbers(*s.low)} {numbers(*(b - a for a, b in zip(s.low, s.high)))}",
            "ball": lambda: f"psphere {name} {s.radius}; ttranslate {name} {numbers(*s.centre)}",
            "cone": lambda: occt_cone(s, name),
            "torus": lambda: f"ptorus {name} {s.radius} {s.tube}",
            "sheet": lambda: f"polyline w {' '.join(numbers(*c) for c in s.corners + s.corners[:1])}; mkplane {name} w",
            "patch": lambda: f"beziersurf b{name} {len(s.rows[0])} {len(s.rows)} "
                             f"{' '.join(numbers(*p) for row in s.rows for p in row)}; mkface {name} b{name}",
            "step": lambda: f"stepread {self.folder / 'bolt.step'} all{name} *; explode all{name}_1 So; "
                            f"copy all{name}_1_{s.number} {name}",
        }[s.kind]()
        if s.turn:
            axis, degrees, centre = s.turn
            text += f"; trotate {name} {numbers(*centre)} {numbers(*axis)} {degrees}"
        return text + "\n"

    def evaluate(self, shapes, expression, should):
        if any(s.kind == "step" for s in shapes.values()):
            self.draw(STEP.format(file=self.folder / "bolt.step"))
        text = "".join(self.shape(s, letter.lower()) for letter, s in shapes.items())
        words, made = {"+": "bfuse", "-": "bcut", "x": "bcommon"}, iter("mnopqr")

        def operate(op, a, b):
            nonlocal text
            name = next(made)
            text += f"{words[op]} {name} {a} {b}\n"
            return name

        contact, split = "contact" in should, any(s.kind == "sheet" for s in shapes.values())
        operands = []
        if split:
            text += "bclearobjects; bcleartools; baddobjects a; baddtools b; bfillds; bsplit m\n"
            result = "m"
        else:
            result = folded(expression, str.lower, lambda op, a, b: operands.extend([[a, b]]) or operate(op, a, b))
        text += (f"puts \"result\"; puts [nbshapes {result}]; puts [vprops {result} 1.e-12]\n"
                 f"puts [checkshape {result}]\n")
        if contact:
            text += f"bsection s {' '.join(operands[-1])}\nputs \"section\"; puts [nbshapes s]\n"
        said = self.draw(text)
        after = said[said.rindex("result"):]
        of_result, _, of_section = after.partition("section")
        if "Faulty" in of_result or "faulty" in of_result:
            raise Failure("not valid")
        solids = int(number_of(of_result, "SOLID"))
        kind = next((k for k, n in (("line", "EDGE"), ("point", "VERTEX")) if number_of(of_section, n)), None)
        if contact and should["contact"] == "face":
            kind = "face" if self.shared_faces(shapes) else kind
        return {"solids": solids, "voids": int(number_of(of_result, "SHELL")) - solids,
                "volume": number_of(of_result, "Mass"), "contact": kind}

    def shared_faces(self, shapes):
        """How many faces the general fuse of A and B has that are in both."""
        text = "".join(self.shape(s, letter.lower()) for letter, s in shapes.items())
        said = self.draw(text + "bclearobjects; bcleartools; baddobjects a; baddtools b; bfillds; bbuild r\n"
                         "explode r; puts \"all\"; puts [nbshapes r]; puts \"one\"; puts [nbshapes r_1]\n"
                         "if {[isdraw r_2]} {puts \"two\"; puts [nbshapes r_2]}\n")
        alone = [number_of(said[said.index(word):], "FACE") for word in ("all", "one", "two") if word in said]
        if any(s.kind == "patch" for s in shapes.values()):
            return alone[0] == 2  # the whole patch in two pieces, of which one is the half
        return len(alone) == 3 and alone[1] + alone[2] > alone[0]


def occt_cone(s, name):
    x, _, z, length = frame(s.a, s.b)
    size = f"{s.radius} {s.top}" if s.radius != s.top else f"{s.radius}"
    made = "pcone" if s.radius != s.top else "pcylinder"
    return f"plane f{name} {numbers(*s.a)} {numbers(*z)} {numbers(*x)}; {made} {name} f{name} {size} {length}"


# --- the table


def cell(program, case):
    _, shapes, expression, should = case
    if program.absent():
        return "-"
    try:
        found = program.evaluate(shapes, expression, should)
    except Failure as failure:
        return str(failure)
    return "-" if found is None else described(found, should)


def wanted(should):
    if "contact" in should:
        return f"a {should['contact']}" if should["contact"] else "nothing"
    words = "nothing" if should["solids"] == 0 else f"{should['solids']} solid{'s' * (should['solids'] > 1)}"
    return words + (f", {should['volume']}" if "volume" in should else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--draw", default="occt-draw-7.6")
    parser.add_argument("--openscad", default="openscad")
    parser.add_argument("--manifold")
    parser.add_argument("--cgal", default="./coincidences_cgal")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(options.keep or temporary).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        ours = Ours(options.program, folder)
        occt = Occt(options.draw, folder)
        if not occt.absent():
            occt.draw(STEP.format(file=folder / "bolt.step"))
        programs = [ours, occt, Cgal(options.cgal, "nef", ours), Cgal(options.cgal, "corefinement", ours),
                    Manifold(options.manifold, folder), OpenScad(options.openscad, options.cgal, folder)]
        for program in programs:
            if program.absent():
                print(f"{program.title}: {program.absent()}", file=sys.stderr)
        print("| case | is | " + " | ".join(p.title for p in programs) + " |")
        print("|---|---|" + "---|" * len(programs))
        for case in CASES:
            if options.only in case[0]:
                cells = " | ".join(cell(p, case) for p in programs)
                print(f"| {case[0]} | {wanted(case[3])} | {cells} |", flush=True)


main()
