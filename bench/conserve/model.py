"""A model of people as data: solids, sheets and wires with exact coordinates, and the tree file made of it.

A model that has no solid is put into a box around it, so that there is something to fill with tetrahedra. The
nodes of its tree:
    domain    its solids, or the box
    sheets    all surfaces and wires as they are
    model     the domain with what of the sheets is inside
    outside   what of the sheets is not
    frame, rest   a box around everything, and what of it the domain leaves
    left, right   the model parted by an oblique plane through its middle
"""
import json
import math
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path


class Unread(Exception):
    """A file without a model that can be read; the text says why."""


@dataclass
class Solid:
    """Closed surfaces: `faces` are lists of loops of point numbers. `fill` as in a tree, or `sides` per face."""
    name: str
    points: list
    faces: list
    fill: str | None = "winding"
    sides: list | None = None
    volume: Fraction | None = None      # where the file gives it in another way


@dataclass
class Sheet:
    """Faces without thickness: lists of loops of point numbers, each in one plane."""
    name: str
    points: list
    faces: list
    overlap: bool = False               # its faces may lie on each other


@dataclass
class Wire:
    name: str
    points: list
    segments: list


@dataclass
class Model:
    name: str
    solids: list = field(default_factory=list)
    sheets: list = field(default_factory=list)
    wires: list = field(default_factory=list)
    box: tuple | None = None            # (low, high): the domain of a network
    cad: Path | None = None             # a file of solids that the program alone reads
    notes: list = field(default_factory=list)

    def points(self):
        for part in self.solids + self.sheets + self.wires:
            yield from part.points
        if self.box:
            yield from self.box


def is_closed(faces):
    """Every edge has an even number of faces."""
    return all(n % 2 == 0 for n in edge_uses(faces).values())


def edge_uses(faces):
    uses = Counter()
    for loops in faces:
        for loop in loops:
            uses.update(frozenset(e) for e in zip(loop, loop[1:] + loop[:1]))
    return uses


def merged(points, faces):
    """The same with one number for points of equal coordinates, without faces of no area or twice the same one."""
    numbers = {}
    number = [numbers.setdefault(p, len(numbers)) for p in points]
    kept, seen = [], set()
    new_points = list(numbers)
    for loops in faces:
        loops = [[number[i] for i in loop] for loop in loops]
        key = frozenset(frozenset(loop) for loop in loops)
        if key in seen or any(len(set(loop)) < 3 for loop in loops):
            continue
        if len(loops) == 1 and len(loops[0]) == 3 and not any(normal([new_points[i] for i in loops[0]])):
            continue
        seen.add(key)
        kept.append(loops)
    return new_points, kept


def normal(points):
    """Newell's vector of a loop: twice its area along each axis, exactly."""
    total = [Fraction(0)] * 3
    for p, q in zip(points, points[1:] + points[:1]):
        for k in range(3):
            total[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3]
    return total


def is_planar(points):
    n = normal(points)
    height = [sum(a * b for a, b in zip(n, p)) for p in points]
    return any(n) and len(set(height)) == 1


def planar_faces(points, faces):
    """Faces with one loop that is in no plane become triangles; how many, too."""
    result, bent = [], 0
    for loops in faces:
        if len(loops) == 1 and len(loops[0]) > 3 and not is_planar([points[i] for i in loops[0]]):
            bent += 1
            loop = loops[0]
            result += [[[loop[0], loop[i], loop[i + 1]]] for i in range(1, len(loop) - 1)]
        else:
            result.append(loops)
    return result, bent


def surface(name, points, faces, model, fill=None):
    """Adds a surface to the model: a solid when it is closed, else a sheet."""
    points, faces = merged(points, faces)
    faces, bent = planar_faces(points, faces)
    if bent:
        model.notes.append(f"{bent} faces are not planar: triangles")
    if not faces:
        raise Unread("no face with an area")
    if fill or is_closed(faces):
        many = any(n > 2 for n in edge_uses(faces).values())
        model.solids.append(Solid(name, points, faces, fill or ("cells" if many else "winding")))
    else:
        model.sheets.append(Sheet(name, points, faces, overlap=True))


def used_only(points, faces):
    used = sorted({i for loops in faces for loop in loops for i in loop})
    local = {old: new for new, old in enumerate(used)}
    return [points[i] for i in used], [[[local[i] for i in loop] for loop in loops] for loops in faces]


def bounds(points):
    points = list(points)
    if not points:
        raise Unread("no points in it")
    return tuple(tuple(f(p[k] for p in points) for k in range(3)) for f in (min, max))


def box_around(low, high, times=8):
    """Wider than the bounds by an eighth of the longest side, or 1/times, on a round grid."""
    longest = max(h - l for l, h in zip(low, high)) or Fraction(1)
    grid = Fraction(10) ** (math.floor(math.log10(longest)) - 2)
    room = longest / times
    return (tuple(math.floor((l - room) / grid) * grid for l in low),
            tuple(math.ceil((h + room) / grid) * grid for h in high))


def numbers(values):
    return [str(v) for v in values]


def is_double(value):
    return Fraction(float(value)) == value


class TreeWriter:
    """Writes the tree file of a model, and mesh files beside it where a surface has triangles of doubles only."""

    def __init__(self, model, folder):
        self.model, self.folder = model, folder
        self.nodes = {}
        self.sheet_leaves, self.wire_leaves, self.solid_leaves = {}, {}, []

    def write(self, checks=True):
        """checks: with the nodes that only checks need."""
        model = self.model
        if model.cad:
            kind = "brep" if model.cad.suffix.lower() == ".brep" else "step"
            self.nodes["model"] = {kind: {"file": str(model.cad.resolve()), "fill": "solids"}}
            return self.save()
        low, high = bounds(model.points())
        self.box = model.box or (None if model.solids else box_around(low, high))
        if self.box and model.solids:
            raise Unread("both a box and solids are given as the domain")
        self.frame = box_around(*bounds([low, high, *(self.box or [])]), times=5)
        for i, solid in enumerate(model.solids):
            self.solid_leaves.append(self.leaf(f"solid {i} {solid.name}", solid))
        if self.box:
            self.nodes["domain"] = self.boxed(self.box)
        elif len(model.solids) == 1:
            self.nodes["domain"] = self.nodes.pop(self.solid_leaves[0])
        else:
            self.nodes["domain"] = {"union": self.solid_leaves, "dominance": "left"}
        for i, sheet in enumerate(model.sheets):
            self.sheet_leaves[self.leaf(f"sheet {i} {sheet.name}", sheet)] = sheet
        for i, wire in enumerate(model.wires):
            name = f"wire {i} {wire.name}"
            self.nodes[name] = {"group": {"vertices": [numbers(p) for p in wire.points],
                                          "edges": [list(s) for s in wire.segments]}}
            self.wire_leaves[name] = wire
        parts = list(self.sheet_leaves) + list(self.wire_leaves)
        if parts:
            self.nodes["sheets"] = {"union": parts} if len(parts) > 1 else {"simplify": parts[0]}
            self.nodes["inside"] = {"intersection": ["domain", "sheets"]}
            if checks:
                self.nodes["outside"] = {"difference": ["sheets", "domain"]}
            self.nodes["model"] = {"union": ["domain", "inside"]}
        else:
            self.nodes["model"] = {"simplify": "domain"}
        if not checks:
            return self.save()
        self.nodes["frame"] = self.boxed(self.frame)
        self.nodes["rest"] = {"difference": ["frame", "domain"]}
        middle = [(l + h) / 2 for l, h in zip(low, high)]
        size = [max(h - l, Fraction(1, 1000)) for l, h in zip(low, high)]
        slope = [Fraction(a, b) / s.limit_denominator(1000) if s >= 1 else Fraction(a, b)
                 for a, b, s in zip((19, 11, 7), (17, 13, 23), size)]
        self.nodes["half"] = {"halfspace": {"point": numbers(middle), "normal": numbers(slope)}}
        self.nodes["left"] = {"intersection": ["model", "half"]}
        self.nodes["right"] = {"difference": ["model", "half"]}
        return self.save()

    def save(self):
        path = self.folder / "tree.json"
        path.write_text(json.dumps({"cnrg": 1, "nodes": self.nodes, "result": "model"}, indent=0))
        return path

    @staticmethod
    def boxed(box):
        return {"box": {"min": numbers(box[0]), "max": numbers(box[1])}}

    def leaf(self, name, part):
        fill = getattr(part, "fill", "none")
        sides = getattr(part, "sides", None)
        triangles = all(len(loops) == 1 and len(loops[0]) == 3 for loops in part.faces)
        if triangles and not sides and all(is_double(x) for p in part.points for x in p):
            file = self.folder / f"{len(self.nodes)}.off"
            lines = ["OFF", f"{len(part.points)} {len(part.faces)} 0"]
            lines += [" ".join(repr(float(x)) for x in p) for p in part.points]
            lines += ["3 " + " ".join(map(str, loops[0])) for loops in part.faces]
            file.write_text("\n".join(lines) + "\n")
            self.nodes[name] = {"mesh": {"file": file.name, "fill": fill}}
        else:
            faces = [{"loops": loops} for loops in part.faces]
            if sides:
                for face, pair in zip(faces, sides):
                    face["sides"] = list(pair)
            group = {"vertices": [numbers(p) for p in part.points], "faces": faces}
            if not sides:
                group["fill"] = fill
            self.nodes[name] = {"group": group}
        return name
