"""What the program wrote: a result as JSON, exactly, and a mesh of tetrahedra as Gmsh 4.1."""
import json
import math
from collections import defaultdict
from fractions import Fraction
from itertools import combinations

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
        self.region_names = {i: data["regions"][i]["name"] for i in self.regions}
        self.volume = sum(self.regions.values(), Fraction(0))
        self.faces, self.edges, self.rims = {}, {}, {}
        self.vertices, self.wire_parts = [], []
        self.area_by_leaf = defaultdict(lambda: ZERO)
        self.length_by_leaf = defaultdict(lambda: ZERO)
        self.face_leaves, self.length_of_wires = {}, 0.0
        for i, face in enumerate(data["faces"]):
            if not face["component"]:
                continue
            self.faces[i] = area_of([[self.points[p] for p in loop] for loop in face["loops"]])
            self.rims[i] = sum(math.dist(*(tuple(map(float, self.points[p])) for p in side))
                               for loop in face["loops"] for side in zip(loop, loop[1:] + loop[:1]))
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
                    self.wire_parts.append((name, chain))
                    self.length_by_leaf[name] = plus(self.length_by_leaf[name], length)
        self.vertices = [self.points[v["point"]] for v in data["vertices"] if v["component"]]
        bent = [i for i, f in enumerate(data["faces"]) if "facets" in f and f["component"]]
        if bent:
            raise ValueError("faces of curved patches, whose area is not that of their loops: " + str(bent[:5]))

    def sheets(self):
        """Area by the name of a leaf with faces, and the length around them all."""
        areas, rims = defaultdict(float), defaultdict(float)
        for i, leaves in self.face_leaves.items():
            for leaf in leaves:
                areas[self.leaves[leaf]] += size(self.faces[i])
                rims[self.leaves[leaf]] += self.rims[i]
        return areas, rims

    def wires(self):
        """Chains of points by the name of a leaf with edges."""
        wires = defaultdict(list)
        for name, chain in self.wire_parts:
            wires[name].append([tuple(map(float, p)) for p in chain])
        return wires

    def corners(self):
        return self.vertices

    def ends(self):
        """Of wires: what is joined or snapped keeps them, and may lose corners from where wires go straight on."""
        ways = defaultdict(list)
        for _, chain in self.wire_parts:
            for end, to in (chain[:2], chain[:-3:-1]):
                way = [float(y - x) for x, y in zip(end, to)]
                ways[end].append([w / math.hypot(*way) for w in way])
        return [end for end, all_of in ways.items()
                if not any(sum(x * y for x, y in zip(v, w)) < 1e-9 - 1 for v, w in combinations(all_of, 2))]


class Tetrahedra:
    """Volumes of regions (exact), areas of faces and lengths of edges, by the number of the cell in the result."""

    def __init__(self, path):
        points, self.count = {}, 0
        names, groups_of = {}, {}           # of physical groups by (dimension, number); of entities likewise
        tetrahedra, triangles, segments = defaultdict(list), defaultdict(list), defaultdict(list)
        by_dimension = {1: segments, 2: triangles, 3: tetrahedra}
        with open(path) as stream:
            lines = iter(stream.read().split("\n"))
        for line in lines:
            if line == "$PhysicalNames":
                for _ in range(int(next(lines))):
                    dimension, tag, name = next(lines).split(" ", 2)
                    names[int(dimension), int(tag)] = name.strip('"')
            elif line == "$Entities":
                for dimension, count in enumerate(map(int, next(lines).split())):
                    at = 4 if dimension == 0 else 7     # a point, or the corners of a box, are before the groups
                    for _ in range(count):
                        words = next(lines).split()
                        groups = map(int, words[at + 1:at + 1 + int(words[at])])
                        groups_of[dimension, int(words[0]) - 1] = [names[dimension, g] for g in groups]
            elif line == "$Nodes":
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
        self.places = list(points.values())

        def by_group(dimension, values):
            """Sums of the values of entities."""
            sums = defaultdict(int)
            for entity, value in values.items():
                for name in groups_of.get((dimension, entity), ()):
                    sums[name] += value
            return sums
        self.volumes_by_group = defaultdict(list)
        for region, volume in self.volumes.items():
            for name in groups_of.get((3, region), ()):
                self.volumes_by_group[name].append(volume)
        self.area_by_group, self.rim_by_group = by_group(2, self.areas), by_group(2, self.perimeters)
        self.segments = [(points[a], points[b]) for cells in segments.values() for a, b in cells]


def triangle_area(a, b, c, bits):
    """Of integers over 2^bits: rounded at the end only, so that slivers are as good as others."""
    u = [y - x for x, y in zip(a, b)]
    v = [y - x for x, y in zip(a, c)]
    whole = 2 << 2 * bits
    return math.hypot((u[1] * v[2] - u[2] * v[1]) / whole, (u[2] * v[0] - u[0] * v[2]) / whole,
                      (u[0] * v[1] - u[1] * v[0]) / whole)
