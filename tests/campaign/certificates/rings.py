"""Tori with planes, balls and cylinders, and graphs of polynomials with planes: as quadrics.py."""
from fractions import Fraction as F
from math import comb

from bodies import TURNS, Case, ball, cone, discs, fraction, half, near, net, pair, ring, rod, table

NOTHING = (0, 0, 0, 0)
WHOLE = (0, 0, 1, 1)


def radii(rng):
    radius = fraction(rng, F(3, 2), F(3), 4)
    return radius, radius * rng.choice([F(1, 4), F(1, 3), F(3, 5), F(2, 5)])


def torus_plane(rng, gap):
    """A torus about z below a plane. Along a normal at the angle with sine s to z, the torus has four critical
    levels, -R s - r, R s + r and the saddles r - R s and R s - r; for s = 0 they are two circles, for R s = r the
    saddles are of one level and the plane cuts the torus in Villarceau's circles."""
    radius, tube = radii(rng)
    c, s = rng.choice([(F(1), F(0)), (F(0), F(1)), *TURNS])
    if rng.random() < 0.15:
        tube = radius * s if s not in (0, 1) else tube
    ends, saddle = radius * s + tube, radius * s - tube
    levels = [-ends, -abs(saddle), abs(saddle), ends]
    level = near(rng, gap, rng.choice(levels), -ends - F(1, 4), ends + F(1, 4))
    below = sum(level > x for x in levels)
    if s == 0:
        truth = NOTHING if below == 0 else (0, 2, 2, 1) if below < 4 else WHOLE
        truth = (0, 1, 0, 0) if level == -ends else WHOLE if level == ends else truth
    elif level in levels:
        flat = (1, 2, 2, 1) if saddle < 0 else (1, 2, 3, 1)  # the section: a ring that touches itself, or two lobes
        truth = {0: (1, 0, 0, 0), 1: flat, 2: flat, 3: WHOLE}[below]
        if saddle == 0 and level == 0:
            truth = (2, 4, 3, 1)
    else:
        between = (0, 2, 2, 1) if saddle < 0 else (0, 2, 3, 1)
        truth = [NOTHING, (0, 1, 2, 1), between, (0, 1, 2, 1), WHOLE][below]
    normal = [s, F(0), c]
    leaves = {"a": ring([0, 0, 0], [0, 0, 1], radius, tube), "b": half([level * x for x in normal], normal)}
    shape = "level" if s == 0 else "Villarceau" if saddle == 0 else "steep" if saddle > 0 else "flat"
    where = f"{shape}, {'touch' if level in levels else 'beyond'} {below} of 4"
    return Case("torus and plane", leaves, ("intersection", "a", "b"), truth, where)


# a: the torus, b: a ball about a point of its axis, by the circles in a half-plane of the axis.
COAXIAL = table("""
apart         0 0 2 2   0 0 0 0   0 0 1 1   0 0 1 1
touch         0 1 3 2   0 1 0 0   0 0 1 1   0 0 1 1
cross         0 2 3 1   0 2 2 1   0 2 2 1   0 2 3 1
a-in-b-touch  0 0 1 1   0 0 1 1   0 0 0 0   0 1 3 1
a-in-b        0 0 1 1   0 0 1 1   0 0 0 0   0 0 2 1
""")
# A ball off the axis that meets one side of the torus, by the circles in the half-plane that has its centre.
BESIDE = table("""
apart         0 0 2 2   0 0 0 0   0 0 1 1   0 0 1 1
touch         1 0 2 2   1 0 0 0   0 0 1 1   0 0 1 1
cross         0 1 2 1   0 1 2 1   0 1 2 1   0 1 2 1
a-in-b-touch  1 2 2 1   1 2 3 1   1 2 3 1   1 2 2 1
a-in-b        0 2 2 1   0 2 3 1   0 2 3 1   0 2 2 1
b-in-a-touch  0 0 1 1   0 0 1 1   1 0 2 1   0 0 0 0
b-in-a        0 0 1 1   0 0 1 1   0 0 2 1   0 0 0 0
same          0 0 1 1   0 0 1 1   0 1 3 1   0 0 0 0
""")


def torus_ball(rng, gap):
    radius, tube = radii(rng)
    p, q = rng.choice(TURNS)
    a = ring([0, 0, 0], [0, 0, 1], radius, tube)
    if rng.random() < 0.4:  # a centre on the axis
        t, away = radius * q / p, radius / p  # the latter from the middle of the tube
        around = near(rng, gap, rng.choice([away - tube, away + tube]), F(1, 4), away + 2 * tube)
        where = discs(away ** 2, tube, around)
        if around <= 0 or where not in COAXIAL:
            return None
        found = pair("torus and ball", rng, a, ball([0, 0, t], around), COAXIAL, where)
        found.situation = f"one axis, {found.situation}"
        return found
    around = fraction(rng, F(1, 4), F(1), 8) * tube
    if rng.random() < 0.3:
        around = tube * F(3, 2)
    away = near(rng, gap, rng.choice([tube + around, abs(tube - around)]), 0, tube + around + F(1, 4))
    p, q = p * rng.choice([1, -1]), q * rng.choice([1, -1])
    x, z = radius + away * p, away * q
    # Along each circle of the torus about its axis the distance from the centre grows up to the opposite side, which
    # the ball must not reach: so the half-plane of the centre and its circles tell all.
    if x <= 0 or (radius + x) ** 2 + z ** 2 <= (tube + around) ** 2:
        return None
    return pair("torus and ball", rng, a, ball([x, 0, z], around), BESIDE, discs(away ** 2, tube, around))


# a: the torus, b: a cylinder about its axis, by the disc of the cylinder and the ring from above.
ROUND = table("""
in-hole      0 2 4 2   0 0 0 0   0 0 1 1   0 2 3 1
fills-hole   0 3 5 2   0 1 0 0   0 0 1 1   0 2 3 1
cut          0 4 5 1   0 2 2 1   0 2 2 1   0 4 5 1
just-around  0 2 3 1   0 0 1 1   0 0 0 0   0 3 5 1
around       0 2 3 1   0 0 1 1   0 0 0 0   0 2 4 1
""")


def torus_rod(rng, gap):
    """Axes are parallel; `low` and `high` are the least and the greatest distance of the cylinder from the axis."""
    radius, tube = radii(rng)
    inner, outer = radius - tube, radius + tube
    p, q = rng.choice(TURNS)
    operator = rng.choice(["difference", "intersection"])
    a = ring([0, 0, 0], [0, 0, 1], radius, tube)
    if rng.random() < 0.3:
        thick = near(rng, gap, rng.choice([inner, outer]), inner / 2, outer + F(1, 2))
        if thick <= 0:
            return None
        where = ("in-hole" if thick < inner else "fills-hole" if thick == inner else "cut" if thick < outer
                 else "just-around" if thick == outer else "around")
        found = pair("torus and cylinder", rng, a, rod([0, 0, -2], [0, 0, 2], thick), ROUND, where)
        found.situation = f"one axis, {found.situation}"
        return found
    thick = fraction(rng, F(1, 4), radius, 8)
    contact = rng.choice([outer + thick, abs(outer - thick), abs(inner - thick), inner + thick])
    away = near(rng, gap, contact, F(1, 16), outer + thick + F(1, 4))
    if away <= 0 or away == thick:
        return None
    low, high, holds = abs(away - thick), away + thick, away < thick
    less, common, where = around_axis(low, high, inner, outer, holds)
    b = rod([away * p, away * q, -2], [away * p, away * q, 2], thick)
    truth = less if operator == "difference" else common
    return Case("torus and cylinder", {"a": a, "b": b}, (operator, "a", "b"), truth, where)


# a: a torus, b: a cylinder across its outer circle, at right angles to both axes' directions.
ACROSS = table("""
apart         0 2 4 2   0 0 0 0   0 0 1 1   0 2 3 1
touch         1 2 4 2   1 0 0 0   0 0 1 1   0 2 3 1
cross         0 3 4 1   0 1 2 1   0 1 2 1   0 3 4 1
""")


def beside(rng, gap, first, second):
    """A distance of two things of these widths that overlap by less than their widths, and how they lie."""
    limit = min(first, second)
    away = near(rng, gap, 0, -limit, F(1, 2))
    return (away, "apart" if away > 0 else "touch" if away == 0 else "cross") if away > -limit else (None, None)


def torus_beside(rng, gap):
    """A torus about z, and beside its outer circle another one about a parallel axis, or a cylinder along y. In each
    plane of z their sections are a ring and another ring or a strip; these overlap in a lens that does not reach
    the holes, so the curve of crossing has two points in each such plane, and closes above and below."""
    radius, tube = radii(rng)
    a = ring([0, 0, 0], [0, 0, 1], radius, tube)
    if rng.random() < 0.5:
        thick = fraction(rng, F(1, 4), F(1), 8)
        away, where = beside(rng, gap, tube, thick)
        if away is None:
            return None
        x = radius + tube + thick + away
        return pair("torus across cylinder", rng, a, rod([x, -4, 0], [x, 5, 0], thick), ACROSS, where)
    other, thin = radii(rng)
    away, where = beside(rng, gap, tube, thin)
    if away is None:
        return None
    p, q = rng.choice(TURNS)
    x = radius + tube + thin + other + away
    return pair("two tori", rng, a, ring([x * p, x * q, 0], [0, 0, 1], other, thin), BESIDE, where)


def bend(rng, gap):
    """Half a torus that goes on as a pipe, or as half of another torus: of the same radius, or by `gap` wider."""
    radius, tube = radii(rng)
    wide = tube if gap == 0 else near(rng, gap, tube, tube / 2, tube * F(5, 4))
    if wide <= 0 or wide >= radius:
        return None
    leaves = {"ring": ring([0, 0, 0], [0, 0, 1], radius, tube), "cut": half([0, 0, 0], [0, 1, 0])}
    half_ring = ("difference", "ring", "cut")
    # One circle where they go on, else two, and a flat ring between them.
    truth, where = ((0, 3, 4, 1), "touch") if wide == tube else ((0, 4, 5, 1), "step")
    if rng.random() < 0.5:
        leaves["pipe"] = rod([radius, 0, 0], [radius, -3, 0], wide)
        return Case("bend", leaves, ("union", half_ring, "pipe"), truth, f"pipe, {where}")
    leaves["next"] = ring([2 * radius, 0, 0], [0, 0, 1], radius, wide)
    return Case("bend", leaves, ("union", half_ring, ("intersection", "next", "cut")), truth, f"next bend, {where}")


def rim(rng, gap):
    """A cylinder and, from its end on, a cone or a part of a ball: of the same rim, or by `gap` wider."""
    rod_radius = fraction(rng, F(1, 2), F(2), 8)
    wide = rod_radius if gap == 0 else near(rng, gap, rod_radius, rod_radius / 2, rod_radius * F(5, 4))
    if wide <= 0:
        return None
    leaves = {"rod": rod([0, 0, -2], [0, 0, 0], rod_radius)}
    # One circle where they go on, else two, and a flat ring between them.
    truth, where = ((0, 2, 3, 1), "touch") if wide == rod_radius else ((0, 3, 4, 1), "step")
    if rng.random() < 0.5:
        leaves["cone"] = cone([0, 0, 0], [0, 0, 3], wide)
        return Case("rim", leaves, ("union", "rod", "cone"), truth, f"cone, {where}")
    p, q = rng.choice(TURNS)
    leaves["ball"] = ball([0, 0, rng.choice([1, -1]) * wide * p / q], wide / q)
    leaves["cut"] = half([0, 0, 0], [0, 0, 1])
    return Case("rim", leaves, ("union", "rod", ("difference", "ball", "cut")), truth, f"ball, {where}")


def around_axis(low, high, inner, outer, holds):
    """Counts of torus - cylinder and of both; `holds`: the cylinder holds the axis. Seen from above, the circle runs
    from `low` to `high`, and from each of its points that lies in the ring a curve goes up and one goes down; they
    meet above the ring's borders."""
    one = (0, 1, 2, 1)  # one curve, which bounds a disc of the torus
    at_low, at_high = low in (inner, outer), high in (inner, outer)
    if low > outer or high < inner or (low == outer and not holds) or high == inner:
        if holds and low > outer:
            return NOTHING, WHOLE, "around"
        touch = low == outer or high == inner
        return WHOLE, ((1, 0, 0, 0) if touch else NOTHING), "touch" if touch else "apart"
    if low == outer:
        return NOTHING, WHOLE, "around, touch"
    cut = (low < inner) + (high > outer)  # borders that the circle passes
    if not at_low and not at_high:
        two = {0: ((0, 2, 2, 1), (0, 2, 2, 1) if holds else (0, 2, 3, 1)), 2: ((0, 2, 3, 1), (0, 2, 3, 1))}
        less, common = two.get(cut, (one, one))
        return less, common, ("through the ring", "over a border", "across")[cut]
    if at_low and at_high:
        return None, None, "both"
    # A figure of eight: between one curve and two that part the ring across, or two above each other.
    if cut == 1:
        return (1, 2, 3, 1), (1, 2, 3, 1), "across, touch"
    return (1, 2, 2, 1), ((1, 2, 2, 1) if holds else (1, 2, 3, 1)), "through the ring, touch"


def bernstein(coefficients):
    """Bernstein coefficients of a polynomial over [0, 1] that is given by its coefficients of 1, x, x^2 ..."""
    n = len(coefficients) - 1
    return [sum(coefficients[j] * F(comb(i, j), comb(n, j)) for j in range(i + 1)) for i in range(n + 1)]


def multiplied(a, b):
    product = [F(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return product


def square(at):
    """(x - at)^2"""
    return [at * at, -2 * at, F(1)]


def graph(f, g):
    """The patch z = f(x) + g(y) over the unit square, exactly."""
    f, g = bernstein(f), bernstein(g)
    return net([[[F(i, len(f) - 1), F(j, len(g) - 1), x + y] for i, x in enumerate(f)] for j, y in enumerate(g)])


def patch_plane(rng, gap):
    """A graph over the square and the half-space below or above a level near a critical one. Coordinates X, Y count
    from the middle of the critical points."""
    shape = rng.choice(["bowl", "saddle", "wells"])
    if shape == "bowl":  # X^2 + b Y^2: ellipses
        x, y, b = fraction(rng, F(1, 4), F(3, 4), 16), fraction(rng, F(1, 4), F(3, 4), 16), fraction(rng, F(1), F(2), 4)
        f, g, limit = square(x), [b * v for v in square(y)], F(0)
        border = min(x ** 2, (1 - x) ** 2, b * y ** 2, b * (1 - y) ** 2)  # least height of the border
        level = near(rng, gap, limit, -border / 2, border)
        if level >= border:
            return None
        less = [NOTHING, (1, 0, 0, 0), (0, 1, 1, 0)]
        more = [(4, 4, 1, 0), (4, 4, 1, 0), (4, 5, 1, 0)]
    elif shape == "saddle":  # X^2 - m^2 Y^2: hyperbolas that leave the square at y = 0 and y = 1
        slope = rng.choice([F(1, 2), F(3, 4), F(2, 3)])
        f, g, limit = square(F(1, 2)), [-slope ** 2 * v for v in square(F(1, 2))], F(0)
        level = near(rng, gap, limit, -slope ** 2 / 4, (1 - slope ** 2) / 4)
        if not -slope ** 2 / 4 < level < (1 - slope ** 2) / 4:
            return None
        less = [(4, 4, 2, 0), (5, 6, 2, 0), (4, 4, 1, 0)]
        more = [(8, 8, 1, 0), (9, 10, 2, 0), (8, 8, 2, 0)]
    else:  # k (X^2 - w^2)^2 + Y^2: two wells of height 0, and between them a pass of height k w^4
        w, k = F(1, 4), rng.choice([F(8), F(16), F(32)])
        inner = [v - (w ** 2 if i == 0 else 0) for i, v in enumerate(square(F(1, 2)))]
        f, g = [k * v for v in multiplied(inner, inner)], square(F(1, 2))
        limit = rng.choice([F(0), k * w ** 4])
        level = near(rng, gap, limit, F(0), min(F(1, 4), 2 * k * w ** 4))
        # At x = 0 and 1 the height is at least 9 k w^4, at y = 0 and 1 at least 1/4.
        if level >= min(F(1, 4), 9 * k * w ** 4):
            return None
        less = [NOTHING, (2, 0, 0, 0), (0, 2, 2, 0), (1, 2, 2, 0), (0, 1, 1, 0)]
        more = [(4, 4, 1, 0), (4, 4, 1, 0), (4, 6, 1, 0), (5, 6, 1, 0), (4, 5, 1, 0)]
        at = (level >= 0) + (level > 0) + (level >= k * w ** 4) + (level > k * w ** 4)
    if shape != "wells":
        at = 1 + (level > limit) - (level < limit)
    below = rng.random() < 0.5
    leaves = {"a": graph(f, g), "b": half([0, 0, level], [0, 0, 1 if below else -1])}
    truth = (less if below else more)[at]
    words = ["beyond", "touch", "cut"] if shape != "wells" else ["beyond", "touch", "cut twice", "touch pass", "cut"]
    return Case("patch and plane", leaves, ("intersection", "a", "b"), truth,
                f"{shape} {'below' if below else 'above'}, {words[at]}")


KINDS = [torus_plane, torus_ball, torus_rod, torus_beside, bend, rim, patch_plane]
