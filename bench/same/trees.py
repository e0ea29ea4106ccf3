"""Random trees: every operator, attribute and leaf, in shared nodes, so that whatever the program does is done often.

A tree is made from its seed and number alone. Its leaves stand on one lattice and echo one another (leaves.py); half
of the trees are of flat leaves on whole coordinates, where everything coincides, others have fractions, curved or
unbounded leaves, or are turned as a whole. A group Boolean takes groups only, so what it could not take gets a
`closure`, as far as the operators tell; the few trees that are faulty stay, for their messages.
"""
import json
import random
from fractions import Fraction

from leaves import GENERAL, HALVES, LATTICE, SLANTS, THIRDS, Leaf, LeafMaker, middle

GROUP_BOOLEANS = ("union", "intersection", "difference")
TOPOLOGICAL = ("interior", "closure", "boundary", "regularize")
# What a group Boolean makes of a value: it takes all but the last.
GROUP, COMPLEMENT, CLOSED, OPEN = "group", "complement", "closed", "open"
DEEPEST = 8


class Tree:
    """A tree file with what it needs: other files, and trees whose results it reads."""

    def __init__(self, name, text, path="t.yaml", files=None, before=(), nodes=(), points=(), thorough=False):
        self.name, self.text, self.path = name, text, path
        self.files = dict(files or {})   # texts by path
        self.before = list(before)       # (path of a tree, node or None, file of its result)
        self.nodes = list(nodes)         # names of `nodes`
        self.points = list(points)       # texts `x y z`, for locate and explain
        self.thorough = thorough         # files of every node, more questions
        self.turn = 0                    # what is asked of some trees only goes by this number


def text_of(value):
    """A value in YAML's flow style."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Fraction):
        return str(value) if value.denominator == 1 else f'"{value}"'
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}: {text_of(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(text_of(v) for v in value) + "]"
    return str(value)


def plain(value):
    """The same value for JSON."""
    if isinstance(value, dict):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    if isinstance(value, Fraction):
        return int(value) if value.denominator == 1 else str(value)
    return value


class TreeMaker:
    """Makes one tree: leaves, then nodes over them; operands come before users."""

    def __init__(self, seed, number):
        self.random = r = random.Random(f"{seed}/{number}")
        self.style = r.choice((LATTICE,) * 5 + (HALVES, THIRDS, GENERAL))
        self.curved = r.randrange(5) == 0
        self.unbounded = r.randrange(10) == 0
        self.tilt = None
        if r.randrange(8) == 0:
            self.tilt = {"axis": r.choice(SLANTS[3:]), "degrees": r.choice((30, 31, 45, 90))}
        self.graded = r.randrange(5) == 0
        self.maker = LeafMaker(r, self.style)
        self.names, self.nodes, self.standing, self.depth, self.uses, self.made_of = [], [], [], [], [], []
        self.leaves, self.files, self.before = [], {}, []

    # Leaves.

    def add_leaf(self, leaf):
        r = self.random
        node = {leaf.kind: leaf.value}
        self.files.update(leaf.files)
        if r.randrange(3) == 0:
            node["material"] = r.choice(self.materials())
        if r.randrange(4) == 0:
            node["name"] = r.choice(("body", "core", "the layer", f"leaf {len(self.nodes)}"))
        if r.randrange(6) == 0:
            node["dominance"] = r.choice((-1, 1, 2, Fraction(1, 2)))
        if self.tilt:
            node["rotate"] = self.tilt
        elif r.randrange(10) == 0:
            node.update(self.motion())
            leaf = Leaf(leaf.kind, leaf.value)  # what was known of it is elsewhere
        self.leaves.append(leaf)
        self.push(node, GROUP, [])

    def twin(self):
        """A leaf that is there, once more, moved along the lattice or not at all."""
        leaf = self.random.choice(self.leaves)
        node = {leaf.kind: leaf.value}
        if self.tilt:
            node["rotate"] = self.tilt
        elif self.random.randrange(3):
            node["translate"] = [self.random.choice((0, 0, 1, -1)) for _ in range(3)]
        if self.random.randrange(2):
            node["material"] = self.random.choice(self.materials())
        self.leaves.append(leaf if "translate" not in node else Leaf(leaf.kind, leaf.value))
        self.push(node, GROUP, [])

    def materials(self):
        return ("rock", "sand", "ore") + (("blend", "crust", "crust") if self.graded else ())

    def motion(self):
        r = self.random
        kind = r.randrange(5)
        if kind == 4:
            return {"matrix": [[1, r.choice((0, Fraction(1, 2))), 0, 1], [0, r.choice((1, -1)), 0, 0], [0, 1, 2, -1]]}
        if kind == 0:
            return {"translate": [r.choice((0, 1, -1, Fraction(1, 2))) for _ in range(3)]}
        if kind == 1:
            return {"scale": r.choice((2, Fraction(1, 2), [1, 2, 1], [-1, 1, 1]))}
        if kind == 2:
            return {"mirror": {"normal": r.choice(SLANTS[:5]), "point": [1, 1, 1]}}
        return {"rotate": {"axis": r.choice(SLANTS[:4]), "degrees": r.choice((90, 180, 45, 37)),
                           "center": [1, 1, 1]}}

    # Nodes.

    def push(self, node, standing, operands):
        for i in operands:
            self.uses[i] += 1
        self.depth.append(1 + max((self.depth[i] for i in operands), default=-1))
        self.names.append(("n" if operands else "a") + str(len(self.nodes)))
        self.nodes.append(node)
        self.standing.append(standing)
        self.made_of.append(set(operands))
        self.uses.append(0)
        return len(self.nodes) - 1

    def pick(self):
        """More often one that nobody uses, the latest first; not too deep."""
        r = self.random
        if r.randrange(3):
            for i in reversed(range(len(self.nodes))):
                if self.uses[i] == 0 and self.depth[i] < DEEPEST - 1 and r.randrange(3):
                    return i
        return r.choice([i for i, d in enumerate(self.depth) if d < DEEPEST - 1])

    def result_of(self, op, operands, each, regularize):
        below = [self.standing[i] for i in operands]
        all_closed = all(s in (GROUP, CLOSED) for s in below)
        of_group = below[0] == GROUP and not each
        value = OPEN
        if op in GROUP_BOOLEANS:
            return GROUP
        if op == "simplify" or (op == "select" and below[0] == GROUP):
            value = below[0]
        elif op in ("closure", "regularize"):
            value = GROUP if of_group else CLOSED
        elif op == "boundary":
            value = CLOSED
        elif op in ("aggregate", "unify", "sum", "product"):
            value = CLOSED if all_closed else OPEN
        elif op == "complement":
            value = COMPLEMENT if below[0] == GROUP else OPEN
        return CLOSED if regularize and value != GROUP else value

    def apply(self, op, operands, **attributes):
        r = self.random
        names = [self.names[i] for i in operands]
        several = op in GROUP_BOOLEANS or op in ("aggregate", "sum", "product", "subtract")
        value = names if several else names[0]
        node = {op: value}
        if op == "simplify" and attributes.pop("points", False):
            node = {op: {"of": value, "mode": "points"}}
        if op == "select":
            node = {op: {"of": value, **self.criteria(operands[0])}}
        node.update(attributes)
        if op not in ("simplify", "regularize") and r.randrange(12) == 0:
            node["regularize"] = True
        if op != "simplify" and r.randrange(15) == 0:
            node["simplify"] = "points"
        if r.randrange(8) == 0:
            node["material"] = r.choice(self.materials())
        if r.randrange(12) == 0:
            node["name"] = r.choice(("joined", "rest", f"of {op}"))
        if r.randrange(12) == 0:
            node["attributes"] = {"n": r.randrange(3)}
        if r.randrange(12) == 0:
            node.update(self.motion())
        if op in GROUP_BOOLEANS and "dominance" not in node and r.randrange(6) == 0:
            node["dominance"] = r.choice((1, 3, Fraction(3, 2)))
        standing = self.result_of(op, operands, node.get("each"), node.get("regularize"))
        return self.push(node, standing, operands)

    def criteria(self, of):
        """What `select` picks of a node: one or two things."""
        r = self.random
        given = {"dimension": r.choice((1, 2, 2, 3, [2, 3]))} if r.randrange(3) else {}
        leaves = sorted(i for i in self.below(of) if self.depth[i] == 0)
        number = r.choice(leaves)
        leaf = self.names[number]
        self.uses[number] += 1  # so that it keeps its name
        kind = r.randrange(7)
        if kind == 0:
            given["region"] = r.choice((1, 2, leaf))
        elif kind == 1:
            given["material"] = r.choice(("rock", "sand", "ore"))
        elif kind == 2:
            given["from"] = leaf
            if r.randrange(2):
                given["source face"] = r.randrange(3)
        elif kind == 3:
            given["between"] = r.choice((["rock", "null"], ["rock", "ore"], [leaf, "null"]))
        elif kind < 6:
            place = r.randrange(of + 1)
            self.uses[place] += 1
            given[("inside", "touching")[kind - 4]] = self.names[place]
        else:
            given["attributes"] = {"n": r.randrange(3)}
        return given

    def below(self, i):
        """A node and all that it is made of, by number."""
        found = {i}
        stack = [i]
        while stack:
            for k in self.made_of[stack.pop()] - found:
                found.add(k)
                stack.append(k)
        return found

    def add_many(self):
        r = self.random
        op = r.choice(("union", "union", "union", "intersection", "intersection", "difference", "difference", "sum",
                       "sum", "product", "subtract"))
        operands = []
        for _ in range(r.choice((2, 2, 2, 3, 4))):
            i = self.pick()
            if i in operands and r.randrange(8):
                continue
            if op in GROUP_BOOLEANS and self.standing[i] == OPEN and r.randrange(20):
                i = self.apply("closure", [i])
            operands.append(i)
        if len(operands) < 2:
            return
        attributes = {}
        if op not in ("difference", "subtract") and r.randrange(2):
            attributes["dominance"] = r.choice(("left", "right", "equal", "equal"))
        self.apply(op, operands, **attributes)

    def add_fold(self):
        """Three leaves or more at once: they touch in more places than what is made of them."""
        r = self.random
        if len(self.leaves) < 3:
            return self.add_many()
        operands = r.sample(range(len(self.leaves)), min(len(self.leaves), r.choice((3, 3, 4, 5))))
        operands.sort(key=lambda i: not self.leaves[i].walls)  # what others may lie in comes first
        op = r.choice(("union", "union", "union", "difference", "difference", "sum", "subtract", "product"))
        if r.randrange(3) == 0:
            operands[0] = len(self.nodes) - 1  # what is made so far first
            operands = list(dict.fromkeys(operands))
            if len(operands) < 3:
                return None
            if op in GROUP_BOOLEANS and self.standing[operands[0]] == OPEN:
                operands[0] = self.apply("closure", operands[:1])
        attributes = {}
        if op not in ("difference", "subtract") and r.randrange(4):
            attributes["dominance"] = r.choice(("left", "right", "equal", "equal"))
        return self.apply(op, operands, **attributes)

    def add_one(self):
        r = self.random
        op = r.choice(("unify", "complement", "interior", "interior", "closure", "boundary", "boundary",
                       "regularize", "simplify", "select", "select"))
        attributes = {}
        if op in TOPOLOGICAL and r.randrange(3) == 0:
            attributes["each"] = True
        if op == "simplify" and r.randrange(2):
            attributes["points"] = True
        self.apply(op, [self.pick()], **attributes)

    def add_aggregate(self):
        """Of operands that are disjoint by the way in which they are made; rarely of any."""
        x, y = self.pick(), self.pick()
        kind = self.random.randrange(6)
        if kind == 0:
            self.apply("aggregate", [self.apply("subtract", [x, y]), y])
        elif kind == 1:
            self.apply("aggregate", [self.apply("subtract", [y, x]), self.apply("product", [x, y])])
        elif kind == 2:
            self.apply("aggregate", [self.apply("interior", [x]), self.apply("boundary", [x])])
        elif kind == 3:
            self.apply("aggregate", [x, self.apply("complement", [x])])
        elif kind == 4:
            self.apply("aggregate", [x])
        else:
            self.apply("aggregate", [x, y])

    # The whole.

    def make(self, part=False):
        """The text; `part`: a small tree, whose result another one reads."""
        r = self.random
        if r.randrange(4) == 0:  # around all that is whole
            low, high = r.choice(((-1, 4), (-1, 4), (0, 3)))
            self.add_leaf(Leaf("box", {"min": [low] * 3, "max": [high] * 3}))
        for _ in range(2 if part else r.choice((2, 3, 3, 4))):
            self.add_leaf(self.maker.leaf(self.curved, self.unbounded and not part))
        for _ in range(r.randrange(4)):
            if r.randrange(2):
                self.add_leaf(self.maker.echo(self.leaves))
            else:
                self.twin()
        most = len(self.nodes) + (r.randrange(1, 4) if part else r.randrange(3, 11))
        while len(self.nodes) < most:
            kind = r.randrange(12)
            if kind < 3:
                self.add_fold()
            elif kind < 7:
                self.add_many()
            elif kind < 11:
                self.add_one()
            else:
                self.add_aggregate()
        return self.text()

    def text(self):
        r = self.random
        materials = {"rock": {"color": '"#998877"'}, "sand": {}, "ore": {}}
        if self.graded:
            stops = [[0, "rock"], [Fraction(1, 2), {"rock": Fraction(1, 4), "ore": Fraction(3, 4)}], [1, "sand"]]
            materials["blend"] = {"linear": {"from": [0, 0, 0], "to": [0, 1, 3], "stops": stops}}
            materials["crust"] = {"distance": {"to": self.names[r.randrange(len(self.leaves))],
                                               "stops": [[0, "ore"], [2, "rock"]]}}
        self.put_inline()
        listed = [(name, node) for name, node in zip(self.names, self.nodes) if node is not None]
        self.listed = [name for name, _ in listed]
        result = listed[-1][0]
        if r.randrange(12) == 0:
            listed.reverse()  # users before operands
        if r.randrange(15) == 0:
            materials["rock"] = {}
            return json.dumps(plain({"cnrg": 1, "materials": materials, "nodes": dict(listed), "result": result}),
                              indent=1) + "\n"
        text = "cnrg: 1\n"
        text += f"materials: {text_of(materials)}\nnodes:\n"
        text += "".join(f"  {name}: {text_of(node)}\n" for name, node in listed)
        return text + f"result: {result}\n"

    def put_inline(self):
        """A few leaves stand where they are used instead of in the list."""
        r = self.random
        for i, name in enumerate(self.names):
            if self.uses[i] != 1 or r.randrange(8) or self.graded:
                continue
            for node in self.nodes[i + 1:]:
                for op, value in (node or {}).items():
                    if isinstance(value, list) and name in value:
                        value[value.index(name)] = self.nodes[i]
                        self.nodes[i] = None
                    elif value == name:
                        node[op] = self.nodes[i]
                        self.nodes[i] = None
                    if self.nodes[i] is None:
                        break
                if self.nodes[i] is None:
                    break

    def points_to_ask(self):
        """Points of the lattice, and some that are known to be special."""
        points = [self.maker.point() for _ in range(10)]
        points += [middle(points[k], points[k + 1]) for k in range(6)]
        for leaf in self.leaves:
            if leaf.faces:
                loop = self.random.choice(leaf.faces)
                points += [loop[0], middle(loop[0], loop[1]), middle(loop[0], loop[len(loop) // 2])]
            points += leaf.points[:2]
        return [" ".join(str(Fraction(x)) for x in p) for p in points]


def random_tree(seed, number, cad_files=None):
    """Tree `number` of a seed; `cad_files`: texts of models that a leaf may name."""
    maker = TreeMaker(seed, number)
    r = maker.random
    if r.randrange(6) == 0:  # the result of another tree, read back
        other = TreeMaker(seed, f"{number}, first")
        maker.files["first.yaml"] = other.make(part=True)
        maker.files.update(other.files)
        maker.before.append(("first.yaml", None, "first.json"))
        maker.push({"cnrg": "first.json"}, GROUP, [])
        maker.leaves.append(Leaf("cnrg", "first.json"))
    if cad_files and r.randrange(30) == 0:
        file = r.choice(sorted(cad_files))
        maker.files[file] = cad_files[file]
        value = {"file": file, "segments": 4}
        if r.randrange(3) == 0:
            value["fill"] = r.choice(("solids", "winding", "cells", "none"))
        maker.add_leaf(Leaf(file.rpartition(".")[2], value))
    text = maker.make()
    tree = Tree(f"random/{number}", text, "t.json" if text.startswith("{") else "t.yaml", maker.files, maker.before,
                maker.listed, maker.points_to_ask())
    tree.turn = number
    return tree
