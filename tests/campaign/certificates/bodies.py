"""Leaves with rational numbers, the frames that they are placed in, and the tree file that they make."""
from dataclasses import dataclass, field
from fractions import Fraction

#: Cosine and sine of angles whose both are rational.
TURNS = [(Fraction(a, c), Fraction(b, c)) for a, b, c in
         [(4, 3, 5), (3, 4, 5), (12, 5, 13), (5, 12, 13), (15, 8, 17), (8, 15, 17), (24, 7, 25), (21, 20, 29)]]
OPERATORS = ("union", "intersection", "difference", "reversed")


def fraction(rng, low, high, parts=12):
    """A random multiple of 1/parts from `low` to `high`."""
    return Fraction(rng.randint(-(-low * parts // 1), high * parts // 1), parts)


def unit(rng):
    """A random rational point of the unit sphere, by stereographic projection."""
    a, b, c = rng.randint(-3, 3), rng.randint(-3, 3), rng.randint(1, 3)
    n = a * a + b * b + c * c
    x = [Fraction(2 * a * c, n), Fraction(2 * b * c, n), Fraction(a * a + b * b - c * c, n)]
    rng.shuffle(x)
    return x


def quaternion_matrix(a, b, c, d):
    """The rotation of a quaternion of whole numbers: rational and exactly orthogonal."""
    n = a * a + b * b + c * c + d * d
    rows = [[a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d]]
    return [[Fraction(x, n) for x in row] for row in rows]


@dataclass
class Leaf:
    """`kind` of the tree file; `points` move with the frame, `vectors` turn with it, `numbers` stay."""
    kind: str
    points: dict
    vectors: dict = field(default_factory=dict)
    numbers: dict = field(default_factory=dict)
    spin: tuple = ()  # axis (a vector, or none for that of the leaf) and degrees: moves lines, not the surface
    fineness: dict = field(default_factory=dict)


def ball(center, radius):
    return Leaf("sphere", {"center": center}, {}, {"radius": radius})


def rod(start, end, radius):
    return Leaf("cylinder", {"from": start, "to": end}, {}, {"radius": radius})


def cone(start, end, radius):
    return Leaf("cone", {"from": start, "to": end}, {}, {"radius": radius})


def ring(center, axis, radius, tube):
    return Leaf("torus", {"center": center}, {"axis": axis}, {"radius": radius, "tube": tube})


def half(point, normal):
    return Leaf("halfspace", {"point": point}, {"normal": normal})


def plane(point, normal):
    return Leaf("plane", {"point": point}, {"normal": normal})


def block(low, high):
    return Leaf("box", {"min": low, "max": high})


def net(rows):
    """A Bézier patch of these rows of control points."""
    return Leaf("bezier", {"patch": rows})


def written(x):
    """A number, point or list of points as the tree file has it."""
    if isinstance(x, (list, tuple)):
        return [written(y) for y in x]
    return str(x) if isinstance(x, Fraction) else x


@dataclass
class Frame:
    """x -> matrix x + move; then `rotate` (axis, degrees), if there is one, by the tree file."""
    name: str = "as it is"
    matrix: list = None
    move: list = None
    rotate: tuple = None

    def vector(self, v):
        if self.matrix is None:
            return list(v)
        return [sum(m * x for m, x in zip(row, v)) for row in self.matrix]

    def point(self, p):
        if isinstance(p[0], (list, tuple)):
            return [self.point(q) for q in p]
        turned = self.vector(p)
        return turned if self.move is None else [x + m for x, m in zip(turned, self.move)]


FRAMES = ("as it is", "moved", "3-4-5", "rational", "rotate")


def frame(name, rng):
    """A random frame of one of these kinds. `3-4-5` turns about an axis of coordinates, after a change of axes, so
    that lengths and frames of circles are rational; `rational` is any rational rotation."""
    move = [Fraction(rng.randint(-40, 40), 7) for _ in range(3)]
    if name == "as it is":
        return Frame(name)
    if name == "moved":
        return Frame(name, None, move)
    if name == "3-4-5":
        order, (c, s) = rng.randrange(3), rng.choice(TURNS)
        turn = [[c, -s, Fraction(0)], [s, c, Fraction(0)], [Fraction(0), Fraction(0), Fraction(1)]]
        shift = rng.randrange(3)
        rows = [[turn[i][(j + order) % 3] for j in range(3)] for i in range(3)]
        return Frame(name, rows[shift:] + rows[:shift], move)
    if name == "rational":
        whole = [1, 0, 0, 0]
        while sum(1 for x in whole if x) < 2:
            whole = [rng.randint(-2, 3) for _ in range(4)]
        return Frame(name, quaternion_matrix(*whole), move)
    axis = [0, 0, 0]
    while not any(axis):
        axis = [rng.randint(-3, 3) for _ in range(3)]
    return Frame(name, None, None, (axis, rng.randint(1, 179)))


def placed(leaf, where, segments=None):
    """The node of a leaf in a frame, as a map; `segments` overrides the fineness of curved leaves."""
    points = {key: where.point(p) for key, p in leaf.points.items()}
    value = {key: written(p) for key, p in points.items()}
    value |= {key: written(where.vector(v)) for key, v in leaf.vectors.items()}
    value |= {key: written(x) for key, x in leaf.numbers.items()}
    kind = leaf.kind
    if kind == "box" and where.matrix is not None:
        (ax, ay, az), (bx, by, bz) = leaf.points["min"], leaf.points["max"]
        base = [[ax, ay, az], [bx, ay, az], [bx, by, az], [ax, by, az]]
        kind, value = "prism", {"base": written(where.point(base)), "vector": written(where.vector([0, 0, bz - az]))}
    fineness = dict(leaf.fineness)
    if fineness and segments:
        fineness = {"segments": segments} | ({"rings": max(3, segments // 2)} if "rings" in fineness else {})
    node = {kind: value | fineness}
    if leaf.spin:
        axis, degrees = leaf.spin
        middle = points["center"] if "center" in points else points["from"]
        if axis is None:
            axis = leaf.vectors["axis"] if "axis" in leaf.vectors else [
                b - a for a, b in zip(leaf.points["from"], leaf.points["to"])]
            axis = where.vector(axis)
        node["rotate"] = {"axis": written(axis), "degrees": degrees, "center": written(middle)}
    return node


CURVED = ("sphere", "cylinder", "cone", "torus", "bezier")


def draw_fineness(leaves, rng):
    """Gives curved leaves random steps, or all the same, and turns half of them about themselves."""
    same = rng.choice([8, 12, 16, 32]) if rng.random() < 0.4 else None
    for leaf in leaves:
        if leaf.kind not in CURVED:
            continue
        leaf.fineness = {"segments": same or rng.choice([7, 9, 12, 15, 16, 20, 24, 32, 33, 48])}
        if leaf.kind in ("sphere", "torus"):
            leaf.fineness["rings"] = same or rng.choice([4, 5, 8, 11, 16])
        if leaf.kind == "bezier":
            leaf.fineness = {"segments": rng.choice([4, 5, 8, 13, 16, 24])}
        elif not same and rng.random() < 0.5:
            leaf.spin = (unit(rng) if leaf.kind == "sphere" else None, rng.randint(1, 179))


@dataclass
class Case:
    """A constellation: leaves by name, the expression over them, and the counts of the true result."""
    kind: str
    leaves: dict
    expression: tuple  # (operator, operand, ...), or the name of a leaf
    truth: tuple  # vertices, edges, faces, 3-cells
    situation: str  # how they lie, in words
    gap: str = "general"  # "general", "contact", or the power of ten of the distance from the contact
    where: Frame = field(default_factory=Frame)
    files: dict = field(default_factory=dict)  # what leaves read: name, tree whose result is to be written there

    def tree(self, segments=None, where=None):
        """The tree file, as a map."""
        where = where or self.where
        nodes = {name: placed(leaf, where, segments) for name, leaf in self.leaves.items()}
        nodes["result"] = operation(self.expression)
        if where.rotate:
            nodes["result"]["rotate"] = {"axis": where.rotate[0], "degrees": where.rotate[1]}
        return {"cnrg": 1, "nodes": nodes, "result": "result"}


def operation(expression):
    """The node of an expression; `parts` is a union in which the left operand dominates, so that walls stay."""
    operator, *operands = expression
    operands = [x if isinstance(x, str) else operation(x) for x in operands]
    if operator == "parts":
        return {"union": operands, "dominance": "left"}
    if operator == "reversed":
        return {"difference": operands[::-1]}
    return {operator: operands}


def table(text):
    """Truth of a pair: per line a situation and v e f c of union, intersection, A - B and B - A."""
    found = {}
    for line in text.strip().splitlines():
        name, *numbers = line.split()
        counts = [int(x) for x in numbers]
        assert len(counts) == 16, line
        found[name] = {op: tuple(counts[4 * i:4 * i + 4]) for i, op in enumerate(OPERATORS)}
    return found


def discs(square, a, b):
    """How discs (or balls) of radii a, b lie whose centres are the root of `square` apart: exact signs."""
    if square > (a + b) ** 2:
        return "apart"
    if square == (a + b) ** 2:
        return "touch"
    if square == 0 and a == b:
        return "same"
    if square > (a - b) ** 2:
        return "cross"
    inner = "a-in-b" if a < b else "b-in-a"
    return inner + ("-touch" if square == (a - b) ** 2 else "")


def near(rng, gap, contact, low, high):
    """A parameter `gap` beyond its value in a contact, or in general anything between the bounds."""
    return low + (high - low) * Fraction(rng.randint(1, 66), 67) if gap is None else contact + gap


def pair(kind, rng, a, b, tables, situation):
    """A random operator on two leaves."""
    operator = rng.choice(OPERATORS)
    return Case(kind, {"a": a, "b": b}, (operator, "a", "b"), tables[situation][operator], situation)
