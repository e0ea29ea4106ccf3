"""Random leaves of trees: every leaf that a tree file knows, of every dimension.

Coordinates are few on purpose: leaves that stand on one small lattice lie in each other's planes, share corners and
touch, which is where a Boolean has most to decide. A leaf keeps the corners, edges and facets that are known without
computing anything, so that `echo` can take some of them as points, wires and sheets of their own: what lies in
another leaf exactly.
"""
from fractions import Fraction

LATTICE, HALVES, THIRDS, GENERAL = "lattice", "halves", "thirds", "general"
NORMALS = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1), (1, 1, 0), (1, 0, -1), (1, 1, 1), (1, -2, 2))
SLANTS = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, -1), (1, 2, 0), (2, -1, 1))


class Leaf:
    """The name of a leaf, its value, and what is known of its geometry: loops of facets, pairs of ends, points."""

    def __init__(self, kind, value, faces=(), wires=(), points=(), files=None):
        self.kind, self.value, self.files = kind, value, files or {}
        self.faces, self.wires, self.points = list(faces), list(wires), list(points)
        self.walls = []  # those of the facets that have a region on both sides


def plus(p, q, factor=1):
    return tuple(a + factor * b for a, b in zip(p, q))


def middle(p, q):
    return tuple(Fraction(a + b) / 2 for a, b in zip(p, q))


def minus(p, q):
    return plus(p, q, -1)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def sides_of(base, top):
    """The facets of what lies between a loop and its copy."""
    n = len(base)
    sides = [(base[i], base[(i + 1) % n], top[(i + 1) % n], top[i]) for i in range(n)]
    return [tuple(reversed(base)), tuple(top)] + sides


def box_faces(low, high):
    base = [(x, y, low[2]) for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))]
    return sides_of(base, [(x, y, high[2]) for x, y, _ in base])


class LeafMaker:
    """Makes leaves with coordinates of one style; `random` is a random.Random."""

    def __init__(self, random, style):
        self.random, self.style = random, style

    # Coordinates.

    def coordinate(self):
        r = self.random
        if self.style == LATTICE or (self.style != GENERAL and r.randrange(3) == 0):
            return r.randrange(4)
        if self.style == HALVES:
            return Fraction(r.randrange(7), 2)
        if self.style == THIRDS:
            return Fraction(r.randrange(10), 3)
        return Fraction(r.randrange(-300, 3300), r.choice((970, 1000, 1024)))

    def point(self):
        return (self.coordinate(), self.coordinate(), self.coordinate())

    def points_apart(self, count):
        points = []
        while len(points) < count:
            p = self.point()
            if p not in points:
                points.append(p)
        return points

    def span(self):
        """Two coordinates that ascend."""
        while True:
            a, b = sorted((self.coordinate(), self.coordinate()))
            if a < b:
                return a, b

    def radius(self):
        return self.random.choice((1, 1, Fraction(1, 2), Fraction(3, 2), 2))

    def outline(self):
        """A plane loop (u, v) and its holes."""
        r = self.random
        (u0, u1), (v0, v1) = self.span(), self.span()
        kind = r.randrange(6)
        if kind == 0:
            return [(u0, v0), (u1, v0), (r.choice((u0, u1)), v1)], []
        if kind == 1:
            u, v = Fraction(u0 + u1) / 2, v0 + Fraction(v1 - v0) / 3
            return [(u0, v0), (u1, v0), (u1, v), (u, v), (u, v1), (u0, v1)], []
        if kind == 2:
            u, v = Fraction(u1 - u0) / 4, Fraction(v1 - v0) / 4
            hole = [(u0 + u, v0 + v), (u1 - u, v0 + v), (u1 - u, v1 - v), (u0 + u, v1 - v)]
            return [(u0, v0), (u1, v0), (u1, v1), (u0, v1)], [hole]
        return [(u0, v0), (u1, v0), (u1, v1), (u0, v1)], []

    def lift(self, loops, axis, level):
        """Loops of a plane at right angles to an axis."""
        place = {0: lambda u, v: (level, u, v), 1: lambda u, v: (v, level, u), 2: lambda u, v: (u, v, level)}[axis]
        return [[place(u, v) for u, v in loop] for loop in loops]

    # Flat leaves.

    def box(self):
        spans = [self.span() for _ in range(3)]
        low, high = [s[0] for s in spans], [s[1] for s in spans]
        return Leaf("box", {"min": low, "max": high}, box_faces(low, high))

    def prism(self):
        axis = self.random.randrange(3)
        outer, holes = self.outline()
        outer, *holes = self.lift([outer] + holes, axis, self.coordinate())
        vector = [0, 0, 0]
        vector[axis] = self.random.choice((1, 1, 2, 3, -1))
        if self.random.randrange(4) == 0:
            vector[(axis + 1) % 3] = 1
        value = {"base": outer, "vector": vector}
        if holes:
            value["holes"] = holes
        return Leaf("prism", value, sides_of(outer, [plus(p, vector) for p in outer]))

    def pyramid(self):
        axis, level = self.random.randrange(3), self.coordinate()
        base, = self.lift([self.outline()[0]], axis, level)
        while True:
            apex = self.point()
            if apex[axis] != level:
                break
        faces = [tuple(base)] + [(base[i - 1], base[i], apex) for i in range(len(base))]
        return Leaf("pyramid", {"base": base, "apex": apex}, faces)

    def corners_of_tetrahedron(self):
        while True:
            a, b, c, d = self.points_apart(4)
            if dot(cross(minus(b, a), minus(c, a)), minus(d, a)) > 0:
                return [a, b, c, d]

    def hull(self):
        a, b, c, d = corners = self.corners_of_tetrahedron()
        inside = [Fraction(p + q) / 2 for p, q in zip(a, b)]
        return Leaf("hull", corners + [inside], [(a, c, b), (a, b, d), (b, c, d), (c, a, d)])

    def minkowski(self):
        a, b, c, d = corners = self.corners_of_tetrahedron()
        step = self.random.choice(([1, 0, 0], [0, 1, 1], [0, 0, Fraction(1, 2)]))
        return Leaf("minkowski", [corners, [[0, 0, 0], step]], [(a, c, b), (a, b, d), (b, c, d), (c, a, d)])

    def tetrahedron(self):
        a, b, c, d = corners = self.corners_of_tetrahedron()
        return Leaf("tetrahedron", corners, [(a, c, b), (a, b, d), (b, c, d), (c, a, d)])

    def disk(self):
        value = {"center": self.point(), "radii": [2, self.random.choice((1, 2))], "segments": 4}
        if self.random.randrange(2):
            value["normal"] = self.random.choice(SLANTS)
        else:
            value.update(dip=self.random.choice((0, 30, 90)), strike=self.random.choice((0, 45, 270)))
        return Leaf("disk", value)

    def polygon(self):
        r = self.random
        kind = r.randrange(4)
        if kind == 0:
            while True:
                corners = self.points_apart(3)
                if any(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))):
                    return Leaf("polygon", corners, [tuple(corners)])
        if kind == 1:
            while True:
                p, u, v = self.point(), r.choice(SLANTS), r.choice(SLANTS)
                if any(cross(u, v)):
                    break
            k = r.choice((1, 2, 3))
            corners = [p, plus(p, u, k), plus(plus(p, u, k), v, 2), plus(p, v, 2)]
            return Leaf("polygon", corners, [tuple(corners)])
        outer, holes = self.outline()
        outer, *holes = self.lift([outer] + holes, r.randrange(3), self.coordinate())
        return Leaf("polygon", {"outer": outer, "holes": holes} if holes else outer, [tuple(outer)])

    def polyline(self):
        r = self.random
        points = [self.point()]
        for _ in range(r.randrange(1, 4)):
            if r.randrange(3):
                p = list(points[-1])
                p[r.randrange(3)] = self.coordinate()
                p = tuple(p)
            else:
                p = self.point()
            if p not in points:
                points.append(p)
        if len(points) < 2:
            points.append(plus(points[0], (1, 0, 0)))
        wires = list(zip(points, points[1:]))
        if len(points) > 2 and r.randrange(3) == 0:
            return Leaf("polyline", {"points": points, "closed": True}, (), wires, points)
        return Leaf("polyline", points, (), wires, points)

    def points(self):
        points = self.points_apart(self.random.randrange(1, 5))
        return Leaf("points", points, (), (), points)

    def plane(self):
        p = self.point()
        return Leaf("plane", {"point": p, "normal": self.random.choice(NORMALS)}, (), (), [p])

    def halfspace(self):
        p = self.point()
        return Leaf("halfspace", {"point": p, "normal": self.random.choice(NORMALS)}, (), (), [p])

    def heightfield(self):
        r = self.random
        rows, columns = r.randrange(2, 4), r.randrange(2, 4)
        origin, spacing = (self.coordinate(), self.coordinate()), (r.choice((1, 2)), r.choice((1, Fraction(3, 2))))
        heights = [[self.coordinate() for _ in range(columns)] for _ in range(rows)]
        value = {"origin": origin, "spacing": spacing, "heights": heights}
        if r.randrange(2):
            value["base"] = -1
        return Leaf("heightfield", value)

    def group(self):
        """Cells of a grid with regions of their own or in common; walls, sheets, wires and points besides."""
        r = self.random
        counts = (r.randrange(1, 4), r.randrange(1, 3), r.randrange(1, 3))
        grid = []
        for n in counts:
            start, step = self.coordinate(), r.choice((1, 1, 2, Fraction(1, 2)))
            grid.append([start + step * k for k in range(n + 1)])
        cells = [(i, j, k) for i in range(counts[0]) for j in range(counts[1]) for k in range(counts[2])]
        slabs = r.randrange(2)
        region = {}
        for cell in cells:
            region[cell] = cell[0] + 1 if slabs else (0 if r.randrange(4) == 0 else len(region) + 1)
        vertices, number, faces, edges = [], {}, [], []

        def vertex(at):
            if at not in number:
                number[at] = len(vertices)
                vertices.append(tuple(grid[axis][at[axis]] for axis in range(3)))
            return number[at]

        def square(at, axis):
            u, v = [0, 0, 0], [0, 0, 0]
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1
            return [vertex(p) for p in (at, plus(at, u), plus(plus(at, u), v), plus(at, v))]

        for axis in range(3):
            for at in [(i, j, k) for i in range(counts[0] + 1) for j in range(counts[1] + 1)
                       for k in range(counts[2] + 1)]:
                if any(at[k] >= counts[k] for k in range(3) if k != axis):
                    continue
                back = list(at)
                back[axis] -= 1
                front, behind = region.get(at, 0), region.get(tuple(back), 0)
                if front != behind or (r.randrange(12) == 0):
                    face = {"loops": [square(at, axis)]}
                    if front or behind:
                        face["sides"] = [front, behind]
                    faces.append(face)
        used = sorted({n for n in region.values() if n})
        for _ in range(r.randrange(3)):
            at = tuple(r.randrange(n + 1) for n in counts)
            end = list(at)
            axis = r.randrange(3)
            end[axis] = end[axis] + 1 if end[axis] < counts[axis] else end[axis] - 1
            edges.append([vertex(at), vertex(tuple(end))])
        if r.randrange(3) == 0 or not (faces or edges):
            vertices.append(self.point())
            value_points = [len(vertices) - 1]
        else:
            value_points = []
        value = {"vertices": vertices}
        if faces:
            value["faces"] = faces
        if edges:
            value["edges"] = edges
        if value_points:
            value["points"] = value_points
        regions = {}
        for n in used:
            if r.randrange(2):
                regions[n] = {"name": r.choice(("upper", "lower", f"part {n}"))}
                if r.randrange(2):
                    regions[n]["material"] = r.choice(("rock", "sand"))
        if regions:
            value["regions"] = regions
        if faces and not regions and r.randrange(6) == 0:
            value["fill"] = r.choice(("parity", "cells", "none"))
            for face in faces:
                face.pop("sides", None)
        loops = [tuple(vertices[v] for v in face["loops"][0]) for face in faces]
        leaf = Leaf("group", value, loops, [(vertices[a], vertices[b]) for a, b in edges], vertices)
        leaf.walls = [loop for loop, face in zip(loops, faces) if 0 not in face.get("sides", (0,))]
        return leaf

    # Curved leaves, coarse: a tree is about how cells meet, not about how many they are.

    def segments(self, *counts):
        return self.random.choice(counts)

    def sphere(self):
        c, radius = self.point(), self.radius()
        value = {"center": c, "radius": radius, "segments": self.segments(3, 4, 6), "rings": self.segments(2, 3, 4)}
        return Leaf("sphere", value, (), (), [plus(c, (0, 0, radius)), plus(c, (0, 0, -radius)), c])

    def axis(self):
        """Two points, mostly one behind the other along an axis."""
        p = self.point()
        q = list(p)
        q[self.random.randrange(3)] += self.random.choice((1, 2, 3))
        if self.random.randrange(5) == 0:
            q = list(plus(p, self.random.choice(SLANTS), 2))
        return p, tuple(q)

    def cylinder(self):
        p, q = self.axis()
        value = {"from": p, "to": q, "radius": self.radius(), "segments": self.segments(3, 4, 6, 8)}
        return Leaf("cylinder", value, (), [(p, q)], [p, q])

    def cone(self):
        p, q = self.axis()
        value = {"from": p, "to": q, "radius": self.radius(), "segments": self.segments(3, 4, 6)}
        if self.random.randrange(2):
            value["top"] = Fraction(1, 2)
        return Leaf("cone", value, (), [(p, q)], [p, q])

    def torus(self):
        c = self.point()
        value = {"center": c, "axis": self.random.choice(SLANTS), "radius": self.random.choice((1, 2)),
                 "tube": Fraction(1, 2), "segments": self.segments(3, 4, 5), "rings": self.segments(3, 4)}
        return Leaf("torus", value, (), (), [c])

    def corner_or_arc(self, *points):
        """Corners of a profile, one side of which may be a curve."""
        points = list(points)
        if self.random.randrange(2):
            p, q = points[0], points[1]
            inner = tuple(a + Fraction(b - a) / 2 for a, b in zip(p, q))
            out = [0] * len(inner)
            out[-1 if len(inner) == 2 else 1] = Fraction(-1, 2)
            points.insert(1, {"bezier": [plus(inner, out)]})
        return points

    def extrude(self):
        r = self.random
        (x0, x1), (y0, y1), z = self.span(), self.span(), self.coordinate()
        corners = [(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)]
        value = {"profile": self.corner_or_arc(*corners), "vector": (0, 0, r.choice((1, 2))), "segments": 2}
        if r.randrange(4) == 0:
            value = {"curve": [corners[0], corners[1], corners[2]], "vector": (0, 0, 2), "segments": 2}
        if r.randrange(2):
            value["center"] = corners[0]
            value[r.choice(("twist", "scale"))] = r.choice((Fraction(1, 2), 30, 1))
            if value.get("scale") == 30:
                value["scale"] = 2
        return Leaf("extrude", value, [tuple(corners)] if "profile" in value else (), (), corners)

    def revolve(self):
        r = self.random
        (z0, z1), r0 = self.span(), r.choice((0, 1))
        corners = [(r0, z0), (r0 + 1, z0), (r0 + 1, z1), (r0, z1)]
        value = {"center": self.point(), "axis": r.choice(SLANTS[:3]), "segments": self.segments(3, 4)}
        if r.randrange(4):
            value["profile"] = self.corner_or_arc(*corners)
        else:
            value["curve"] = corners[:3]
        if r.randrange(2):
            value["degrees"] = r.choice((90, 120, 180, 270))
        return Leaf("revolve", value)

    def sweep(self):
        r = self.random
        profile = self.corner_or_arc((0, 0, 0), (Fraction(1, 2), 0, 0), (Fraction(1, 2), Fraction(1, 2), 0))
        path = [(0, 0, 0), (0, 0, 3)]
        if r.randrange(4):
            path.append(r.choice(((-3, 0, 3), (0, -3, 6), (-2, 1, 5))))
        value = {"profile": profile, "path": path, "segments": 2}
        if r.randrange(2):
            value["radius"] = 1
        return Leaf("sweep", value)

    def loft(self):
        (x0, x1), (y0, y1), (z0, z1) = self.span(), self.span(), self.span()
        lower = self.corner_or_arc((x0, y0, z0), (x1, y0, z0), (x1, y1, z0))
        upper = self.corner_or_arc((x1, y0, z1), (x1, y1, z1), (x0, y1, z1))
        return Leaf("loft", {"profiles": [lower, upper], "segments": 2})

    def bezier(self):
        r = self.random
        kind = r.randrange(3)
        if kind == 0:
            points = self.points_apart(r.randrange(2, 5))
            return Leaf("bezier", {"curves": [points], "segments": 3}, (), (), [points[0], points[-1]])
        if kind == 1:
            (x0, x1), (y0, y1) = self.span(), self.span()
            value = {"patches": [self.net((x0, x1), (y0, y1), r.randrange(2, 4), r.randrange(2, 4))], "segments": 2}
            if r.randrange(3) == 0:
                points = value["patches"][0]
                value["patches"] = [{"points": points, "weights": [[r.choice((1, 2)) for _ in row] for row in points]}]
            return Leaf("bezier", value)
        return self.bent_cube("bezier")

    def net(self, us, vs, rows, columns):
        """Control points above a rectangle."""
        return [[(us[0] + Fraction(us[1] - us[0]) * j / (columns - 1),
                  vs[0] + Fraction(vs[1] - vs[0]) * i / (rows - 1), self.coordinate()) for j in range(columns)]
                for i in range(rows)]

    def bent_cube(self, kind):
        """Six bilinear patches that share their sides; one corner may stand elsewhere."""
        low, high = zip(*(self.span() for _ in range(3)))
        corner = {(i, j, k): ((low, high)[i][0], (low, high)[j][1], (low, high)[k][2])
                  for i in (0, 1) for j in (0, 1) for k in (0, 1)}
        corner[1, 1, 1] = plus(corner[1, 1, 1], self.random.choice(((0, 0, 0), (1, 0, 0), (1, 1, 1))))
        quads = [((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0)), ((0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)),
                 ((0, 0, 0), (1, 0, 0), (0, 0, 1), (1, 0, 1)), ((0, 1, 0), (0, 1, 1), (1, 1, 0), (1, 1, 1)),
                 ((0, 0, 0), (0, 0, 1), (0, 1, 0), (0, 1, 1)), ((1, 0, 0), (1, 1, 0), (1, 0, 1), (1, 1, 1))]
        patches = [[[corner[a], corner[b]], [corner[c], corner[d]]] for a, b, c, d in quads]
        return Leaf(kind, {"patches": patches, "fill": "winding", "segments": 2}, (), (), list(corner.values()))

    def bspline(self):
        r = self.random
        rows, columns = r.randrange(3, 5), r.randrange(3, 5)
        patch = {"points": self.net(self.span(), self.span(), rows, columns), "degree": [2, 2]}
        if r.randrange(3) == 0:
            patch["weights"] = [[r.choice((1, 1, 2)) for _ in range(columns)] for _ in range(rows)]
        return Leaf("bspline", {"patch": patch, "segments": 2})

    def coons(self):
        (x0, x1), (y0, y1) = self.span(), self.span()
        a, b, c, d = (x0, y0, self.coordinate()), (x1, y0, self.coordinate()), (x1, y1, 0), (x0, y1, 1)
        bow = tuple(plus(middle(b, c), (0, 0, 1)))
        return Leaf("coons", {"patch": [[a, b], [b, bow, c], [c, d], [d, a]], "segments": 2}, (), (), [a, b, c, d])

    # Leaves of files.

    def mesh(self):
        r = self.random
        if r.randrange(2):
            faces = self.tetrahedron().faces
        else:
            low, high = zip(*(self.span() for _ in range(3)))
            faces = [t for f in box_faces(low, high) for t in ((f[0], f[1], f[2]), (f[0], f[2], f[3]))]
        if r.randrange(6) == 0:
            faces = faces[:-1]
        kind = r.choice(("off", "obj", "stl", "ply"))
        name = f"mesh{r.randrange(10 ** 6)}.{kind}"
        value = {"file": name, "fill": "none" if r.randrange(4) == 0 else r.choice(("winding", "parity", "cells"))}
        if kind != "stl" and r.randrange(3) == 0:
            value["coordinates"] = "decimal"
        return Leaf("mesh", value, faces, files={name: mesh_text(kind, faces)})

    def echo(self, leaves):
        """Corners, middles, edges and facets of other leaves as points, wires and sheets of one group."""
        r = self.random
        known = [leaf for leaf in leaves if leaf.faces or leaf.wires or leaf.points]
        if not known:
            return self.points()
        vertices, number, faces, edges, points = [], {}, [], [], []

        def vertex(p):
            p = tuple(Fraction(x) for x in p)
            if p not in number:
                number[p] = len(vertices)
                vertices.append(p)
            return number[p]

        for _ in range(r.randrange(1, 5)):
            leaf = r.choice(known)
            if leaf.walls and r.randrange(2):
                faces.append({"loops": [[vertex(x) for x in r.choice(leaf.walls)]]})
                continue
            if leaf.faces and (not leaf.wires or r.randrange(2)):
                loop = r.choice(leaf.faces)
            elif leaf.wires:
                loop = r.choice(leaf.wires)
            else:
                points.append(vertex(r.choice(leaf.points)))
                continue
            at = r.randrange(len(loop))
            p, q = loop[at], loop[(at + 1) % len(loop)]
            kind = r.randrange(7)
            if kind == 0:
                points.append(vertex(p))
            elif kind == 1:
                points.append(vertex(middle(p, q)))
            elif kind == 2:
                edges.append([vertex(p), vertex(r.choice((q, middle(p, q))))])
            elif kind == 3 or len(loop) < 3:
                edges.append([vertex(p), vertex(q)])
            else:
                faces.append({"loops": [[vertex(x) for x in loop]]})
        edges = [e for e in edges if e[0] != e[1]]
        if not (faces or edges or points):
            points.append(vertex(p))
        value = {"vertices": vertices}
        for key, items in (("faces", faces), ("edges", edges), ("points", points)):
            if items:
                value[key] = items
        return Leaf("group", value, [tuple(vertices[v] for v in f["loops"][0]) for f in faces],
                    [(vertices[a], vertices[b]) for a, b in edges], vertices)

    def leaf(self, curved, unbounded):
        """One leaf; `curved` and `unbounded` say whether such leaves are meant, too."""
        makers = [self.box] * 5 + [self.prism] * 3 + [self.group] * 4 + [self.polygon] * 3 + [
            self.polyline] * 2 + [
                self.disk, self.points, self.pyramid, self.hull, self.minkowski, self.tetrahedron, self.mesh,
                self.heightfield]
        if curved:
            makers = makers[::2] + [self.sphere, self.cylinder, self.cylinder, self.cone, self.torus, self.extrude,
                                    self.revolve, self.sweep, self.loft, self.bezier, self.bezier, self.bspline,
                                    self.coons]
        if unbounded:
            makers = makers + [self.plane, self.halfspace] * 3
        return self.random.choice(makers)()


def mesh_text(kind, faces):
    """Triangles as a file of that kind; decimals, which the reader may take as they stand."""
    points = list(dict.fromkeys(p for f in faces for p in f))
    number = {p: i for i, p in enumerate(points)}

    def line(p):
        return " ".join(repr(float(x)) for x in p)

    if kind == "stl":
        text = "solid s\n"
        for f in faces:
            text += "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {line(p)}\n" for p in f)
            text += "endloop\nendfacet\n"
        return text + "endsolid s\n"
    if kind == "obj":
        return "".join(f"v {line(p)}\n" for p in points) + "".join(
            "f " + " ".join(str(number[p] + 1) for p in f) + "\n" for f in faces)
    rows = "".join(line(p) + "\n" for p in points) + "".join(
        f"{len(f)} " + " ".join(str(number[p]) for p in f) + "\n" for f in faces)
    if kind == "off":
        return f"OFF\n{len(points)} {len(faces)} 0\n" + rows
    header = (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\n"
              f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return header + rows
