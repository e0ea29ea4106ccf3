"""Walks over a complex from use to use: around an edge, around a vertex, over the skins of regions.

Two sides of a face see each edge of it, so the face makes two uses of the edge (Weiler 1986). From a use there are
three steps: to its mate on the other side of the face, over the wedge to the next use about the edge (radial), and on
along the loop. Every walk is made of these.
"""
from pathlib import Path

import cnrg

MODELS = Path(__file__).resolve().parents[3] / "papers/weiler1986"


class Walker:
    """A use is (h, s): h is 2 * edge, + 1 where the loop of the face runs against the edge, s is 2 * face + side."""

    def __init__(self, file, node):
        self.result = cnrg.read(MODELS / file)[node].evaluate()
        self.vertices, self.edges, self.faces = self.result.vertices, self.result.edges, self.result.faces
        self.loop = {}  # of a half-edge in a face: the loop, and where it is in it
        for f, loops in enumerate(self.faces.loop_edges):
            for loop in loops:
                self.loop.update({(h, f): (loop.tolist(), i) for i, h in enumerate(loop.tolist())})

    def uses(self):
        return [(h, 2 * f + side) for h, f in self.loop for side in (0, 1)]

    def mate(self, use):
        return use[0], use[1] ^ 1

    def radial(self, use):
        """The other use that looks into the same wedge."""
        around = self.edges.around[use[0] // 2].tolist()  # each face by the side that is met first
        first = use[1] in around
        s = around[around.index(use[1]) - 1] ^ 1 if first else around[(around.index(use[1] ^ 1) + 1) % len(around)]
        return next(h for h in (use[0] & ~1, use[0] | 1) if (h, s // 2) in self.loop), s

    def along(self, use, step=1):
        loop, i = self.loop[use[0], use[1] // 2]
        return loop[(i + step) % len(loop)], use[1]

    def leaves(self, use, v):
        return self.edges.vertices[use[0] // 2][use[0] % 2] == v

    def turn(self, use, v):
        """To the other edge of the corner at v, and over the wedge."""
        return self.radial(self.along(use, -1 if self.leaves(use, v) else 1))

    def corner(self, use, v):
        return use if self.leaves(use, v) else self.along(use)

    def vertex(self, p):
        return self.result.points[self.vertices.point].tolist().index(p)

    def face(self, use):
        return " and ".join(self.result.leaves[leaf] for leaf in self.faces.origin_leaves[use[1] // 2])

    def region(self, use):
        r = self.faces.regions[use[1] // 2][use[1] % 2]
        return self.result.regions.origin(r)[0][0] if r >= 0 else "outside"


def walk_around_edge(walker, e):
    """Mate and radial in turn, until the first use is met again."""
    first = use = next(use for use in walker.uses() if use[0] // 2 == e and use[1] in walker.edges.around[e])
    while True:
        print(f"  a face of {walker.face(use)}, then {walker.region(walker.mate(use))}")
        use = walker.radial(walker.mate(use))
        if use == first:
            return


def walk_around_vertex(walker, v):
    """A walk for each circle in which a region meets the vertex, and one around each wire."""
    seen = set()
    for start in walker.uses():
        if not walker.leaves(start, v) or start in seen:
            continue
        use, names = start, []
        while not names or walker.corner(use, v) != start:
            seen.add(walker.corner(use, v))
            names.append(walker.face(use))
            use = walker.turn(use, v)
        print(f"  {walker.region(start)}: past corners of {', '.join(names)}")
    for _ in filter(lambda e: walker.edges.wire[e], walker.vertices.edges[v]):
        print("  around a wire")


def walk_over_skins(walker):
    """Loop and radial from each use that no walk has reached: the sides of faces that see each other."""
    print(f"  {len(walker.uses())} uses of edges")
    seen = set()
    for start in walker.uses():
        reached, skin = [start], set()
        while reached:
            use = reached.pop()
            if use not in seen:
                seen.add(use)
                skin.add(use[1])
                reached += [walker.along(use), walker.radial(use)]
        if skin:
            print(f"  {walker.region(start)}: {len(skin)} sides of faces")


walker = Walker("edge.yaml", "around")
bottom, top = walker.vertex([0, 0, 0]), walker.vertex([0, 0, 1])
print("about the edge from 0 0 0 to 0 0 1")
walk_around_edge(walker, walker.edges.vertices.tolist().index([bottom, top]))
print("skins")
walk_over_skins(walker)
walker = Walker("corner.yaml", "corner")
print("about the vertex 1 1 1")
walk_around_vertex(walker, walker.vertex([1, 1, 1]))

# Output:
# about the edge from 0 0 0 to 0 0 1
#   a face of north and west, then west
#   a face of west, then outside
#   a face of sheet, then outside
#   a face of east, then east
#   a face of east and north, then north
# skins
#   136 uses of edges
#   outside: 16 sides of faces
#   west: 6 sides of faces
#   north: 6 sides of faces
#   east: 6 sides of faces
# about the vertex 1 1 1
#   outside: past corners of east, east, east
#   east: past corners of east, east, east
#   outside: past corners of flap, flap
#   outside: past corners of far, far, far
#   far: past corners of far, far, far
#   around a wire
