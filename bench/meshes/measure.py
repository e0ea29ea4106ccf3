"""What a file of tetrahedra is worth, whoever made it: nothing but its points and elements is looked at.

Covered is what of a polygon are faces of tetrahedra, and of a segment edges: their corners lie on it, but for
rounding (TOLERANCE of the model's extent), and their middle is inside of it.
"""
import numpy

TOLERANCE = 1e-6
CORNERS = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
ENDS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))


class Tetrahedra:
    def __init__(self, mesh):
        """mesh: of meshio; entities of Gmsh's file are regions."""
        self.points = mesh.points
        blocks = [(c.data, tags) for c, tags in zip(mesh.cells, mesh.cell_data["gmsh:geometrical"])
                  if c.type == "tetra"]
        if not blocks:
            raise ValueError("no tetrahedra in it")
        self.corners = numpy.concatenate([data for data, _ in blocks])
        self.region = numpy.concatenate([tags for _, tags in blocks])
        self.extent = float((self.points.max(axis=0) - self.points.min(axis=0)).max())
        p = self.points[self.corners]
        self.volume = numpy.einsum("ij,ij->i", numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]),
                                   p[:, 3] - p[:, 0]) / 6

    def volumes(self):
        """Of each region."""
        return {int(r): float(numpy.abs(self.volume[self.region == r]).sum()) for r in numpy.unique(self.region)}

    def shape(self):
        """12 (3V)^(2/3) / sum of l^2 of each: 1 for the regular one, 0 for flat ones."""
        squares = sum(((self.points[self.corners[:, a]] - self.points[self.corners[:, b]]) ** 2).sum(axis=1)
                      for a, b in ENDS)
        return 12 * numpy.cbrt(3 * numpy.abs(self.volume)) ** 2 / squares

    def least_dihedral(self):
        """Degrees, over all."""
        normals = []
        for f in CORNERS:
            a, b, c = (self.points[self.corners[:, k]] for k in f)
            n = numpy.cross(b - a, c - a)
            normals.append(n / numpy.maximum(numpy.linalg.norm(n, axis=1), 1e-300)[:, None])
        least = 180.0
        for a, b in ENDS:
            cosine = -numpy.einsum("ij,ij->i", normals[a], normals[b])
            least = min(least, float(numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1))).min()))
        return least

    def covered_area(self, polygons):
        """Of all polygons; each is a list of loops, which are arrays of points."""
        faces = numpy.unique(numpy.sort(numpy.concatenate([self.corners[:, f] for f in CORNERS]), axis=1), axis=0)
        return self._covered(faces, polygons, _on_polygon)

    def covered_length(self, segments):
        """Of all segments, arrays of two points."""
        edges = numpy.unique(numpy.sort(numpy.concatenate([self.corners[:, e] for e in ENDS]), axis=1), axis=0)
        return self._covered(edges, [[s] for s in segments], _on_segment)

    def _covered(self, simplices, shapes, on):
        room = TOLERANCE * self.extent
        middle = self.points[simplices].mean(axis=1)
        order = numpy.argsort(middle[:, 0])
        simplices, middle = simplices[order], middle[order]
        total = 0.0
        for loops in shapes:
            every = numpy.concatenate(loops)
            low, high = every.min(axis=0) - room, every.max(axis=0) + room
            first, last = numpy.searchsorted(middle[:, 0], [low[0], high[0]])
            part = middle[first:last]
            near = first + numpy.nonzero(((part >= low) & (part <= high)).all(axis=1))[0]
            if len(near):
                total += on(loops, self.points[simplices[near]], middle[near], room)
        return total


def _on_polygon(loops, triangles, middle, room):
    outer = loops[0]
    center = outer.mean(axis=0)
    normal = numpy.cross(outer - center, numpy.roll(outer, -1, axis=0) - center).sum(axis=0)
    size = numpy.linalg.norm(normal)
    if size == 0:
        return 0.0
    normal /= size
    flat = (numpy.abs((triangles - center) @ normal) <= room).all(axis=1)
    u, v = [k for k in range(3) if k != int(numpy.argmax(numpy.abs(normal)))]
    inside = numpy.zeros(len(middle), dtype=bool)
    x, y = middle[:, u], middle[:, v]
    for loop in loops:
        for p, q in zip(loop, numpy.roll(loop, -1, axis=0)):
            if p[v] != q[v]:
                inside ^= ((p[v] > y) != (q[v] > y)) & (x < (q[u] - p[u]) * (y - p[v]) / (q[v] - p[v]) + p[u])
    t = triangles[flat & inside]
    return float(numpy.linalg.norm(numpy.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]), axis=1).sum() / 2)


def _on_segment(ends, edges, middle, room):
    a, b = ends[0]
    way = (b - a) / numpy.linalg.norm(b - a)
    off = edges - a
    off = numpy.linalg.norm(off - (off @ way)[..., None] * way, axis=2)
    on = edges[(off <= room).all(axis=1)]
    return float(numpy.linalg.norm(on[:, 1] - on[:, 0], axis=1).sum())
