"""Sizes without rounding.

Areas of polygons in space are roots. What is compared exactly instead are the sums of the absolute areas along each
axis, and for wires those of the lengths along each axis: three rationals, which no subdivision changes, and at
least one of which any piece that is lost or twice there does.
"""
import math
from fractions import Fraction

from model import normal

ZERO = (Fraction(0),) * 3


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def area_of(loops):
    """Along each axis, of a flat face: its loops are turned alike, so that holes count against the outer one."""
    total = [Fraction(0)] * 3
    for loop in loops:
        total = [a + b for a, b in zip(total, normal(loop))]
    return tuple(abs(x) / 2 for x in total)


def length_of(p, q):
    return tuple(abs(a - b) for a, b in zip(p, q))


def size(parts):
    """Length of a vector whose squares are exact; rounded once or twice."""
    return math.hypot(*map(float, parts))


def clip(polygon, low, high):
    """Of a polygon in a box: exact; parts of one that is not convex may be joined along the box, without area."""
    for k in range(3):
        for bound, sign in ((low[k], 1), (high[k], -1)):
            result = []
            for p, q in zip(polygon, polygon[1:] + polygon[:1]):
                a, b = (p[k] - bound) * sign, (q[k] - bound) * sign
                if a >= 0:
                    result.append(p)
                if (a > 0 > b) or (a < 0 < b):
                    t = a / (a - b)
                    result.append(tuple(x + t * (y - x) for x, y in zip(p, q)))
            polygon = result
            if not polygon:
                return []
    return polygon


def outside_of(polygon, planes):
    """The convex pieces of a convex polygon that are not inside of a convex body, exactly. planes: pairs of a point
    and a normal that points out of the body. What lies in one of the planes is not inside."""
    pieces = []
    for point, way in planes:
        height = [sum((x - c) * n for x, c, n in zip(p, point, way)) for p in polygon]
        if all(h >= 0 for h in height):
            return pieces + [polygon]
        if all(h <= 0 for h in height):
            continue
        parts = ([], [])
        for p, q, a, b in zip(polygon, polygon[1:] + polygon[:1], height, height[1:] + height[:1]):
            for part, sign in zip(parts, (1, -1)):
                if a * sign >= 0:
                    part.append(p)
            if a * b < 0:
                cut = tuple(x + a / (a - b) * (y - x) for x, y in zip(p, q))
                for part in parts:
                    part.append(cut)
        pieces.append(parts[0])
        polygon = parts[1]
    return pieces


def planes_of(points, faces):
    """Of a closed surface that bounds a convex body: a point and the outward normal of each face; else None."""
    planes = []
    for loops in faces:
        way, point = normal([points[i] for i in loops[0]]), points[loops[0][0]]
        height = [sum((x - c) * n for x, c, n in zip(p, point, way)) for p in points]
        if min(height) < 0 < max(height):
            return None
        planes.append((point, way if max(height) == 0 else [-x for x in way]))
    return planes


def clip_segment(p, q, low, high):
    begin, end = Fraction(0), Fraction(1)
    for k in range(3):
        d = q[k] - p[k]
        if d == 0:
            if not low[k] <= p[k] <= high[k]:
                return None
            continue
        a, b = sorted(((low[k] - p[k]) / d, (high[k] - p[k]) / d))
        begin, end = max(begin, a), min(end, b)
    if begin >= end:
        return None
    return tuple(tuple(x + t * (y - x) for x, y in zip(p, q)) for t in (begin, end))


def overlap(triangles):
    """Of triangles in space, pairs of which may share area: what they share, along each axis."""
    planes = {}
    for t in triangles:
        n = normal(list(t))
        k = next(i for i in range(3) if n[i])
        n = [x / n[k] for x in n]
        planes.setdefault((*n, sum(a * b for a, b in zip(n, t[0]))), []).append((t, k))
    total = ZERO
    for members in planes.values():
        for i, (a, k) in enumerate(members):
            for b, _ in members[:i]:
                common = common_part(list(a), list(b), k)
                if common:
                    total = plus(total, area_of([common]))
    return total


def common_part(a, b, drop):
    """Of two triangles in one plane, seen along an axis that is not in it."""
    i, j = [k for k in range(3) if k != drop]

    def turn(p, q, r):
        return (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i])

    if turn(*b) < 0:
        b.reverse()
    for p, q in zip(b, b[1:] + b[:1]):
        result = []
        for r, s in zip(a, a[1:] + a[:1]):
            x, y = turn(p, q, r), turn(p, q, s)
            if x >= 0:
                result.append(r)
            if (x > 0 > y) or (x < 0 < y):
                t = x / (x - y)
                result.append(tuple(u + t * (v - u) for u, v in zip(r, s)))
        a = result
        if len(a) < 3:
            return []
    return a


def tetrahedron(a, b, c, d):
    """Six times its volume, of integers."""
    ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    wx, wy, wz = d[0] - a[0], d[1] - a[1], d[2] - a[2]
    return wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx)


def integers(points):
    """Doubles as integers over one power of two; its exponent."""
    ratios = [tuple(x.as_integer_ratio() for x in p) for p in points]
    bits = max((d.bit_length() - 1 for p in ratios for _, d in p), default=0)
    return [tuple(n << (bits - d.bit_length() + 1) for n, d in p) for p in ratios], bits
