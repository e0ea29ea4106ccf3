"""What the program wrote: a result as JSON, exactly, and a mesh of tetrahedra as Gmsh 4.1."""
import json
import math
from collections import defaultdict
from fractions import Fraction

from exact import ZERO, area_of, integers, length_of, plus, size, tetrahedron


class Result:
    def __init__(self, path):
        with open(path) as stream:
            data = json.load(stream)
        self.points = [tuple(Fraction(x) for x in p) for p in data["points"]]
        self.leaves = [leaf["name"] for leaf in data["leaves"]]
        self.cells = [sum(1 for c in data[what] if c["component"]) for what in ("vertices", "edges", "faces")]
        self.regions = {i: Fraction(r["volume"]) for i, r in enumerate(data["regions"])
                        if r and r["component"] and r["bounded"]}
        self.volume = sum(self.regions.values(), Fraction(0))
        self.faces, self.edges = {}, {}
        self.area_by_leaf = defaultdict(lambda: ZERO)
        self.length_by_leaf = defaultdict(lambda: ZERO)
        self.face_leaves, self.length_of_wires = {}, 0.0
        for i, face in enumerate(data["faces"]):
            if not face["component"]:
                continue
            self.faces[i] = area_of([[self.points[p] for p in loop] for loop in face["loops"]])
            self.face_leaves[i] = {o["leaf"] for o in face["origin"] if o.get("faces")}
            for leaf in self.face_leaves[i]:
                name = self.leaves[leaf]
                self.area_by_leaf[name] = plus(self.area_by_leaf[name], self.faces[i])
        for i, edge in enumerate(data["edges"]):
            if not edge["component"]:
                continue
            chain = [self.points[p] for p in edge["points"]]
            if edge["closed"]:
                chain.append(chain[0])
            pieces = [length_of(p, q) for p, q in zip(chain, chain[1:])]
            length = ZERO
            for piece in pieces:
                length = plus(length, piece)
            self.edges[i] = (length, sum(map(size, pieces)))
            if any(o.get("edges") for o in edge["origin"]):
                self.length_of_wires += self.edges[i][1]
            for o in edge["origin"]:
                if o.get("edges"):
                    name = self.leaves[o["leaf"]]
                    self.length_by_leaf[name] = plus(self.length_by_leaf[name], length)
        bent = [i for i, f in enumerate(data["faces"]) if "facets" in f and f["component"]]
        if bent:
            raise ValueError("faces of curved patches, whose area is not that of their loops: " + str(bent[:5]))


class Tetrahedra:
    """Volumes of regions (exact), areas of faces and lengths of edges, by the number of the cell in the result."""

    def __init__(self, path):
        points, self.count = {}, 0
        tetrahedra, triangles, segments = defaultdict(list), defaultdict(list), defaultdict(list)
        by_dimension = {1: segments, 2: triangles, 3: tetrahedra}
        with open(path) as stream:
            lines = iter(stream.read().split("\n"))
        for line in lines:
            if line == "$Nodes":
                blocks = int(next(lines).split()[0])
                for _ in range(blocks):
                    count = int(next(lines).split()[3])
                    tags = [int(next(lines)) for _ in range(count)]
                    for tag in tags:
                        points[tag] = tuple(map(float, next(lines).split()[:3]))
            elif line == "$Elements":
                blocks = int(next(lines).split()[0])
                for _ in range(blocks):
                    dimension, entity, _, count = map(int, next(lines).split())
                    for _ in range(count):
                        corners = tuple(map(int, next(lines).split()[1:]))
                        if dimension:
                            by_dimension[dimension][entity - 1].append(corners)
        tags = list(points)
        scaled, bits = integers([points[t] for t in tags])
        at = dict(zip(tags, scaled))
        self.largest = max((abs(x) for p in points.values() for x in p), default=0.0)
        self.volumes = {}
        for region, cells in tetrahedra.items():
            parts = [tetrahedron(*(at[c] for c in cell)) for cell in cells]
            if min(parts) <= 0:
                raise ValueError("a tetrahedron is turned inside out")
            self.volumes[region] = Fraction(sum(parts), 6 << 3 * bits)
            self.count += len(cells)
        self.areas, self.perimeters, self.lengths, self.pieces = {}, {}, {}, {}
        for face, cells in triangles.items():
            corners = [[points[c] for c in cell] for cell in cells]
            self.areas[face] = math.fsum(triangle_area(*(at[c] for c in cell), bits) for cell in cells)
            self.perimeters[face] = math.fsum(math.dist(a, b) for c in corners for a, b in zip(c, c[1:] + c[:1]))
        for edge, cells in segments.items():
            self.lengths[edge] = math.fsum(math.dist(points[a], points[b]) for a, b in cells)
            self.pieces[edge] = len(cells)


def triangle_area(a, b, c, bits):
    """Of integers over 2^bits: rounded at the end only, so that slivers are as good as others."""
    u = [y - x for x, y in zip(a, b)]
    v = [y - x for x, y in zip(a, c)]
    whole = 2 << 2 * bits
    return math.hypot((u[1] * v[2] - u[2] * v[1]) / whole, (u[2] * v[0] - u[0] * v[2]) / whole,
                      (u[0] * v[1] - u[1] * v[0]) / whole)
