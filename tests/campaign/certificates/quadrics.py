"""Balls, cylinders and cones with each other and with planes.

Each function draws a constellation: `gap` is None (general position) or the distance from a contact, 0 in it. The
situation is decided by exact comparison of what was drawn, never taken from `gap`; the counts of a situation stand in
tables. A result's counts are those of its true surfaces: a closed curve without a corner is an edge without vertices,
the tip of a cone is no vertex, and a point in which a surface touches itself is one.
"""
from fractions import Fraction as F

from bodies import TURNS, Case, ball, block, cone, discs, fraction, half, near, pair, plane, rod, table, unit

NOTHING = (0, 0, 0, 0)

# Two balls; a half-space is a ball, too.
BALLS = table("""
apart         0 0 2 2   0 0 0 0   0 0 1 1   0 0 1 1
touch         1 0 2 2   1 0 0 0   0 0 1 1   0 0 1 1
cross         0 1 2 1   0 1 2 1   0 1 2 1   0 1 2 1
a-in-b-touch  0 0 1 1   0 0 1 1   0 0 0 0   1 0 2 1
a-in-b        0 0 1 1   0 0 1 1   0 0 0 0   0 0 2 1
b-in-a-touch  0 0 1 1   0 0 1 1   1 0 2 1   0 0 0 0
b-in-a        0 0 1 1   0 0 1 1   0 0 2 1   0 0 0 0
same          0 0 1 1   0 0 1 1   0 0 0 0   0 0 0 0
""")


def two_balls(rng, gap):
    a = fraction(rng, F(1), F(2), 8)
    b = a + fraction(rng, F(1, 4), F(1), 8) * rng.choice([1, -1]) if a > F(5, 4) else a + F(1, 2)
    distance = near(rng, gap, rng.choice([a + b, abs(a - b)]), 0, a + b + 1)
    if rng.random() < 0.15:  # equal balls, nearly in one place
        b, distance = a, near(rng, gap, 0, 0, 2 * a)
    direction = unit(rng)
    middle = [distance * x for x in direction]
    return pair("two balls", rng, ball([0, 0, 0], a), ball(middle, b), BALLS, discs(distance ** 2, a, b))


def ball_plane(rng, gap):
    """A ball and a half-space or the top of a block; `height` is that of the centre above the plane z = 0."""
    radius = fraction(rng, F(1, 2), F(3, 2), 8)
    height = near(rng, gap, rng.choice([radius, -radius]), -2 * radius, 2 * radius)
    situation = ("apart" if height > radius else "touch" if height == radius else "cross" if height > -radius
                 else "a-in-b-touch" if height == -radius else "a-in-b")
    a = ball([0, 0, height], radius)
    if rng.random() < 0.5:
        return pair("ball and plane", rng, a, half([0, 0, 0], [0, 0, 1]), BALLS, situation)
    found = pair("ball and plane", rng, a, block([-4, -4, -6], [4, 4, 0]), BALLS, situation)
    if found.expression[0] in ("union", "reversed"):  # the rest of the block is there
        found.truth = tuple(x + y for x, y in zip(found.truth, (8, 12, 5, 0)))
    return found


def ball_two_planes(rng, gap):
    """Two planes cut a ball about the origin; their line is `near` from its centre."""
    kind = "ball and two planes"
    radius = F(1)
    away = near(rng, gap, radius, F(1, 8), F(5, 4))
    (p, q), (c, s), (d, t) = rng.choice(TURNS), rng.choice(TURNS), rng.choice(TURNS)
    # The normals are the way to the line, turned to both sides.
    normals = [[p * c - q * s, p * s + q * c, F(0)], [p * d + q * t, q * d - p * t, F(0)]]
    if away * max(c, d) >= radius:  # both planes must cut the ball
        return None
    point = [away * p, away * q, F(0)]
    where = "inside" if away < radius else "outside" if away > radius else "touch"
    way = rng.choice(["parts", "wedge", "rest", "opposite"])
    truth = {
        "parts": {"inside": (2, 5, 8, 4), "touch": (1, 2, 5, 3), "outside": (0, 2, 5, 3)},
        "wedge": {"inside": (2, 3, 3, 1), "touch": (1, 0, 0, 0), "outside": NOTHING},  # what is beyond both planes
        "rest": {"inside": (2, 3, 3, 1), "touch": NOTHING, "outside": NOTHING},  # the same, by differences
        "opposite": {"inside": (2, 3, 3, 1), "touch": (1, 2, 3, 1), "outside": (0, 2, 3, 1)},
    }[way][where]
    back = [[-x for x in n] for n in normals]
    make = {"parts": plane, "wedge": half, "rest": half, "opposite": half}[way]
    sides = back if way == "wedge" else normals
    leaves = {"ball": ball([0, 0, 0], radius), "a": make(point, sides[0]), "b": make(point, sides[1])}
    expression = {
        "parts": ("parts", ("intersection", "a", "ball"), ("intersection", "b", "ball"), "ball"),
        "wedge": ("intersection", "ball", "a", "b"),
        "rest": ("difference", "ball", "a", "b"),
        "opposite": ("intersection", "ball", "a", "b"),
    }[way]
    return Case(kind, leaves, expression, truth, f"{way}, {where}")


def ball_corner(rng, gap):
    """A ball about the origin and three planes at right angles, whose corner is near its surface."""
    kind = "ball and three planes"
    radius = F(1)
    away = near(rng, gap, radius, F(1, 4), F(5, 4))
    way = [abs(x) for x in unit(rng)]
    if not all(way) or any(away ** 2 * (1 - x * x) >= radius ** 2 for x in way):  # the three lines must cut the ball
        return None
    corner = [away * x for x in way]
    where = "inside" if away < radius else "outside" if away > radius else "touch"
    axes = [[F(1), F(0), F(0)], [F(0), F(1), F(0)], [F(0), F(0), F(1)]]
    how = rng.choice(["octant", "room", "box", "parts"])
    if how == "parts":
        truth = {"inside": (7, 18, 20, 8), "touch": (4, 12, 16, 7), "outside": (6, 15, 17, 7)}[where]
        leaves = {"ball": ball([0, 0, 0], radius)} | {n: plane(corner, a) for n, a in zip("abc", axes)}
        walls = [("intersection", n, "ball") for n in "abc"]
        return Case(kind, leaves, ("parts", *walls, "ball"), truth, f"parts, {where}")
    if how == "octant":  # beyond all three planes: nearest to the centre is the corner
        truth = {"inside": (4, 6, 4, 1), "touch": (1, 0, 0, 0), "outside": NOTHING}[where]
        sides = [[-x for x in a] for a in axes]
    else:  # before all three; from outside the corner a triangle of the sphere is seen
        truth = {"inside": (4, 6, 4, 1), "touch": (4, 6, 4, 1), "outside": (6, 9, 5, 1)}[where]
        sides = axes
    leaves = {"ball": ball([0, 0, 0], radius)}
    if how == "box":
        leaves["a"] = block([F(-3)] * 3, corner)
        return Case(kind, leaves, ("intersection", "ball", "a"), truth, f"{how}, {where}")
    leaves |= {n: half(corner, a) for n, a in zip("abc", sides)}
    return Case(kind, leaves, ("intersection", "ball", "a", "b", "c"), truth, f"{how}, {where}")


def bore_wall(rng, gap):
    """A bore through a block, beside its wall y = `wall`; the axis is z."""
    radius = fraction(rng, F(1, 2), F(3, 2), 8)
    wall = near(rng, gap, rng.choice([radius, radius, -radius]), -2 * radius, 2 * radius)
    side = (wall > radius) - (wall < radius), (wall > -radius) - (wall < -radius)
    where, less, common = {
        (1, 1): ("inside", (8, 14, 7, 1), (0, 2, 3, 1)),
        (0, 1): ("touch", (10, 17, 8, 1), (0, 2, 3, 1)),
        (-1, 1): ("open", (12, 18, 8, 1), (4, 6, 4, 1)),
        (-1, 0): ("touch from outside", (8, 12, 6, 1), (2, 1, 0, 0)),
        (-1, -1): ("outside", (8, 12, 6, 1), NOTHING),
    }[side]
    leaves = {"a": block([-4, -5, 0], [4, wall, 4]), "b": rod([0, 0, -1], [0, 0, 5], radius)}
    operator = rng.choice(["difference", "intersection"])
    truth = less if operator == "difference" else common
    return Case("bore and wall", leaves, (operator, "a", "b"), truth, where)


def rod_oblique(rng, gap):
    """A cylinder about z below an oblique plane: levels of the plane's normal at the ends of both rims."""
    radius = fraction(rng, F(1, 2), F(1), 8)
    c, s = rng.choice(TURNS)
    height = 2 * radius * s / c + fraction(rng, F(1), F(2), 4)
    levels = [-radius * s, radius * s, height * c - radius * s, height * c + radius * s]
    level = near(rng, gap, rng.choice(levels), levels[0] - F(1, 4), levels[3] + F(1, 4))
    below = sum(level > x for x in levels)
    if level in levels:  # touches the rim there; with the rest of it on one side
        truth = [(1, 0, 0, 0), (1, 2, 3, 1), (0, 2, 3, 1), (0, 2, 3, 1)][below]
    else:
        truth = [NOTHING, (2, 3, 3, 1), (0, 2, 3, 1), (2, 4, 4, 1), (0, 2, 3, 1)][below]
    normal = [s, F(0), c]
    leaves = {"a": rod([0, 0, 0], [0, 0, height], radius), "b": half([level * x for x in normal], normal)}
    where = f"{'touch' if level in levels else 'beyond'} {below} of 4"
    return Case("cylinder and plane", leaves, ("intersection", "a", "b"), truth, where)


# Parallel cylinders; b is longer at both ends.
PARALLEL = table("""
apart         0 4 6 2   0 0 0 0   0 2 3 1   0 2 3 1
touch         2 5 6 2   2 1 0 0   0 2 3 1   0 2 3 1
cross         4 8 6 1   4 6 4 1   4 6 4 1   4 8 6 1
a-in-b-touch  0 2 3 1   0 2 3 1   0 0 0 0   2 5 6 1
a-in-b        0 2 3 1   0 2 3 1   0 0 0 0   0 4 6 1
b-in-a-touch  2 6 7 1   0 2 3 1   2 5 4 1   0 4 6 2
b-in-a        0 6 7 1   0 2 3 1   0 4 4 1   0 4 6 2
""")


def rods_parallel(rng, gap):
    a = fraction(rng, F(1, 2), F(3, 2), 8)
    b = a + F(3, 8) if a < 1 or rng.random() < 0.5 else a - F(3, 8)
    away = abs(near(rng, gap, rng.choice([a + b, abs(a - b)]), 0, a + b + 1))
    height = fraction(rng, F(1), F(3), 4)
    p, q = rng.choice(TURNS)
    x, y = away * p, away * q
    first, second = rod([0, 0, 0], [0, 0, height], a), rod([x, y, -1], [x, y, height + 1], b)
    return pair("parallel cylinders", rng, first, second, PARALLEL, discs(away ** 2, a, b))


# Long cylinders in different directions, by how they lie along the common normal of their axes.
SKEW = table("""
apart         0 4 6 2   0 0 0 0   0 2 3 1   0 2 3 1
touch         1 4 6 2   1 0 0 0   0 2 3 1   0 2 3 1
cross         0 5 6 1   0 1 2 1   0 3 4 1   0 3 4 1
a-in-b-touch  1 6 7 1   1 2 3 1   1 4 6 2   1 4 4 1
a-in-b        0 6 7 1   0 2 3 1   0 4 6 2   0 4 4 1
b-in-a-touch  1 6 7 1   1 2 3 1   1 4 4 1   1 4 6 2
b-in-a        0 6 7 1   0 2 3 1   0 4 4 1   0 4 6 2
same          2 8 8 1   2 4 4 1   2 6 6 2   2 6 6 2
""")


def rods_skew(rng, gap):
    """Axes x and (c, 0, s), `away` in y: in each plane of y both are strips, which cross where both are there."""
    a = fraction(rng, F(1, 2), F(3, 2), 8)
    b = a + F(1, 4) * rng.choice([1, -1]) if a > F(1, 2) else F(1)
    away = abs(near(rng, gap, rng.choice([a + b, abs(a - b)]), 0, a + b + F(1, 2)))
    if rng.random() < 0.3:  # axes that meet, radii nearly the same
        away, b = F(0), near(rng, gap, a, F(1, 4), 2)
    c, s = rng.choice([(F(0), F(1)), *[turn for turn in TURNS if turn[1] >= F(1, 2)]])
    first, second = rod([-8, 0, 0], [8, 0, 0], a), rod([-8 * c, away, -8 * s], [8 * c, away, 8 * s], b)
    return pair("crossing cylinders", rng, first, second, SKEW, discs(away ** 2, a, b))


# A ball and a rod that is longer at both ends, by the discs that are seen along the rod.
ROD_BALL = table("""
apart         0 2 4 2   0 0 0 0   0 0 1 1   0 2 3 1
touch         1 2 4 2   1 0 0 0   0 0 1 1   0 2 3 1
cross         0 3 4 1   0 1 2 1   0 1 2 1   0 3 4 1
b-in-a-touch  1 4 5 1   1 2 3 1   1 2 2 1   1 4 6 2
b-in-a        0 4 5 1   0 2 3 1   0 2 2 1   0 4 6 2
a-in-b-touch  0 2 3 1   0 0 1 1   0 0 0 0   1 2 4 1
a-in-b        0 2 3 1   0 0 1 1   0 0 0 0   0 2 4 1
same          0 2 3 1   0 0 1 1   0 0 0 0   0 3 6 2
""")


def ball_rod(rng, gap):
    radius = fraction(rng, F(1), F(2), 8)
    thin = rng.choice([radius * F(1, 2), radius * F(2, 3), radius * F(5, 4)])
    away = abs(near(rng, gap, rng.choice([radius + thin, abs(radius - thin)]), 0, radius + thin + F(1, 2)))
    if rng.random() < 0.2:  # about one axis
        away, thin = F(0), near(rng, gap, radius, F(1, 2), 2)
    p, q = rng.choice(TURNS)
    x, y = away * p, away * q
    second = rod([x, y, -3], [x, y, 4], thin)
    return pair("ball and cylinder", rng, ball([0, 0, 0], radius), second, ROD_BALL, discs(away ** 2, radius, thin))


def pin_bore(rng, gap):
    """A pin with edges in a bore about z: one of its four edges is near the bore's wall."""
    radius = F(1)
    p, q = rng.choice(TURNS)
    away = near(rng, gap, radius, F(3, 4), F(5, 4))
    x, y = away * p, away * q
    pin = block([x - F(1, 8), y - F(1, 8), F(-1, 2)], [x, y, F(-1, 4)])
    where = "inside" if away < radius else "outside" if away > radius else "touch"
    if (x - F(1, 8)) ** 2 + y ** 2 >= radius ** 2 or x ** 2 + (y - F(1, 8)) ** 2 >= radius ** 2:
        return None  # other edges are outside, too
    bore = rod([0, 0, -2], [0, 0, 2], radius)
    if rng.random() < 0.5:
        truth = {"inside": NOTHING, "touch": (2, 1, 0, 0), "outside": (6, 9, 5, 1)}[where]
        leaves = {"plate": block([-3, -3, -1], [3, 3, 0]), "bore": bore, "pin": pin}
        return Case("pin in a bore", leaves, ("intersection", ("difference", "plate", "bore"), "pin"), truth,
                    f"plate, {where}")
    truth = (10, 15, 7, 1) if where == "outside" else (8, 12, 6, 1)
    return Case("pin in a bore", {"bore": bore, "pin": pin}, ("intersection", "bore", "pin"), truth, f"rod, {where}")


def cone_plane(rng, gap):
    """A cone about z, its base in z = 0; a plane near its tip, near a line of its side, or near its axis."""
    c, s = rng.choice(TURNS)
    size = fraction(rng, F(1), F(2), 4)
    radius, height = c * size * 2, s * size * 2  # the length of the side, 2 size, is rational
    a = cone([0, 0, 0], [0, 0, height], radius)
    way = rng.choice(["level", "side", "upright"])
    if way == "level":
        normal, limit = [F(0), F(0), F(1)], height
        level = near(rng, gap, limit, height / 4, height * F(5, 4))
        less = [(0, 2, 3, 1), (0, 1, 2, 1), (0, 1, 2, 1)]
        more = [(0, 1, 2, 1), (1, 0, 0, 0), NOTHING]
    elif way == "side":  # the plane is parallel to a line of the side
        normal, limit = [s, F(0), c], radius * s
        level = near(rng, gap, limit, 0, limit * F(5, 4))
        less = [(2, 3, 3, 1), (0, 1, 2, 1), (0, 1, 2, 1)]
        more = [(2, 3, 3, 1), (2, 1, 0, 0), NOTHING]
    else:
        normal, limit = [F(1), F(0), F(0)], F(0)
        level = near(rng, gap, 0, -radius / 2, radius / 2)
        less = more = [(2, 3, 3, 1)] * 3  # in the plane of the axis a curve with a corner in the tip, as the cone has
    at = 1 + (level > limit) - (level < limit)
    below = rng.random() < 0.5
    b = half([level * x for x in normal], normal if below else [-x for x in normal])
    truth = (less if below else more)[at]
    where = f"{way} {'below' if below else 'above'}, {('cut', 'touch', 'beyond')[at]}"
    return Case("cone and plane", {"a": a, "b": b}, ("intersection", "a", "b"), truth, where)


# a: the cone, b: the ball; the ball beside the cone, in it, or around it.
CONE_BESIDE = table("""
apart         0 1 3 2   0 0 0 0   0 1 2 1   0 0 1 1
touch         1 1 3 2   1 0 0 0   0 1 2 1   0 0 1 1
cross         0 2 3 1   0 1 2 1   0 2 3 1   0 1 2 1
""")
CONE_RING = table("""
b-in-a        0 1 2 1   0 0 1 1   0 1 3 1   0 0 0 0
b-in-a-touch  0 1 2 1   0 0 1 1   0 2 5 2   0 0 0 0
cross         0 3 4 1   0 2 3 1   0 3 5 2   0 2 2 1
""")
CONE_TIP = table("""
a-in-b        0 0 1 1   0 1 2 1   0 0 0 0   0 1 3 1
a-in-b-touch  0 0 1 1   0 1 2 1   0 0 0 0   1 1 3 1
cross         0 1 2 1   0 2 3 1   0 1 2 1   0 2 3 1
""")
CONE_RIM = table("""
a-in-b        0 0 1 1   0 1 2 1   0 0 0 0   0 1 3 1
a-in-b-touch  0 0 1 1   0 1 2 1   0 0 0 0   1 1 3 1
cross         2 3 3 1   2 3 3 1   2 3 3 1   2 3 3 1
""")


def cone_ball(rng, gap):
    """A ball beside the side of a cone, or in it about one axis; or a cone in a ball, its tip or a point of its rim
    near the sphere."""
    c, s = rng.choice(TURNS)
    size = fraction(rng, F(1), F(2), 4)
    way = rng.choice(["beside", "ring", "tip", "rim"])
    if way == "beside":  # off a point of the side, along its normal (s, 0, c)
        radius, height, around = c * size * 2, s * size * 2, fraction(rng, F(1, 8), F(1, 2), 16)
        away = near(rng, gap, around, 0, 2 * around)
        x, z = radius / 2 + s * away, height / 2 + c * away
        # The ball crosses the side, and meets neither the axis, and so the opposite side and the tip, nor the base.
        if around >= z or around >= x or away <= -around:
            return None
        where = "apart" if away > around else "touch" if away == around else "cross"
        a, b = cone([0, 0, 0], [0, 0, height], radius), ball([x, 0, z], around)
        found = pair("cone and ball", rng, a, b, CONE_BESIDE, where)
        found.situation = f"beside, {where}"
        return found
    if way == "ring":
        radius, height = c * size * 2, s * size * 2
        # From (0, t) to the line from (radius, 0) to (0, height) it is c (height - t).
        t = radius * height / (radius + 2 * size) * F(5, 4)
        limit = c * (height - t)
        around = near(rng, gap, limit, limit * F(3, 4), limit * F(17, 16))
        # The base stays below the ball, and the sphere meets the line between the ends of the side, if it does.
        if not 0 < around < t or around ** 2 >= radius ** 2 + t ** 2 or around >= height - t:
            return None
        where = "b-in-a" if around < limit else "b-in-a-touch" if around == limit else "cross"
        a, b = cone([0, 0, 0], [0, 0, height], radius), ball([0, 0, t], around)
        found = pair("cone and ball", rng, a, b, CONE_RING, where)
        found.situation = f"one axis, {where}"
        return found
    around = F(2)
    p, q = c, s  # the direction of the point that is near the sphere, in the half-plane of the axis
    away = near(rng, gap, around, F(3, 2), F(9, 4))
    if way == "tip":  # the tip at away (p, q), the axis down along z
        tip, height, radius = [away * p, F(0), away * q], F(3, 2), fraction(rng, F(1, 4), F(3, 4), 8)
        low = tip[2] - height
        if (tip[0] + radius) ** 2 + low ** 2 >= around ** 2:  # the base must be inside
            return None
        a, tables = cone([tip[0], F(0), low], tip, radius), CONE_TIP
    else:  # the farthest point of the base at away (p, q)
        radius, height = fraction(rng, F(1, 4), F(1), 8), fraction(rng, F(1), F(2), 8) * rng.choice([1, -1])
        x, z = away * p - radius, away * q
        if x < 0 or (x - radius) ** 2 + z ** 2 >= around ** 2 or x ** 2 + (z + height) ** 2 >= around ** 2:
            return None
        a, tables = cone([x, F(0), z], [x, F(0), z + height], radius), CONE_RIM
    where = "a-in-b" if away < around else "a-in-b-touch" if away == around else "cross"
    found = pair("cone and ball", rng, a, ball([0, 0, 0], around), tables, where)
    found.situation = f"{way}, {found.situation}"
    return found


def three_balls(rng, gap):
    """Three equal balls about points of a circle, an acute triangle: the last point that they have in common is the
    centre of the circle."""
    (p, q), (c, s) = rng.choice(TURNS), rng.choice(TURNS)
    ways = [(F(1), F(0)), (-p, q), (-c, -s)]
    radius = F(1)
    away = near(rng, gap, radius, F(1, 2), F(9, 8))
    # The centre lies between the second and the third, and any two balls cross.
    if p * s + q * c <= 0 or any(away ** 2 * ((a - c) ** 2 + (b - d) ** 2) >= 4 * radius ** 2
                                 for a, b in ways for c, d in ways):
        return None
    where = "inside" if away < radius else "touch" if away == radius else "outside"
    operator, truth = rng.choice([
        ("intersection", {"inside": (2, 3, 3, 1), "touch": (1, 0, 0, 0), "outside": NOTHING}),
        # Outside of the contact they are a ring, with three whole circles.
        ("union", {"inside": (2, 3, 3, 1), "touch": (1, 3, 3, 1), "outside": (0, 3, 3, 1)}),
    ])
    leaves = {name: ball([away * x, away * y, F(0)], radius) for name, (x, y) in zip("abc", ways)}
    return Case("three balls", leaves, (operator, "a", "b", "c"), truth[where], where)


def lens_plane(rng, gap):
    """What two balls have in common, with the sharp circle where they cross, and a plane near its highest point."""
    (c, s), size = rng.choice(TURNS), fraction(rng, F(1), F(2), 4)
    rim = size * s
    level = near(rng, gap, rim, -rim / 2, rim * F(5, 4))
    where = "cut" if level < rim else "touch" if level == rim else "beyond"
    below = rng.random() < 0.5
    truth = {"cut": (2, 3, 3, 1), "touch": (0, 1, 2, 1) if below else (1, 0, 0, 0),
             "beyond": (0, 1, 2, 1) if below else NOTHING}[where]
    leaves = {"a": ball([-size * c, F(0), F(0)], size), "b": ball([size * c, F(0), F(0)], size),
              "c": half([F(0), level, F(0)], [0, 1 if below else -1, 0])}
    return Case("two balls and plane", leaves, ("intersection", "a", "b", "c"), truth,
                f"{'below' if below else 'above'}, {where}")


def rod_on_floor(rng, gap):
    """A cylinder lies on a floor along a line; a ball crosses both, and its surface is near that line."""
    (c, s), radius = rng.choice(TURNS), F(1, 2)
    away = near(rng, gap, radius, F(1, 4), F(3, 4))
    y, z = away * c, away * s
    # It crosses the floor, and is not inside of the cylinder.
    if z > radius - F(1, 32) or y ** 2 + (1 - z) ** 2 < F(9, 16) ** 2:
        return None
    where = "cut" if away < radius else "touch" if away == radius else "beside"
    truth = {"cut": (12, 20, 11, 1), "touch": (11, 18, 10, 1), "beside": (10, 17, 10, 1)}[where]
    leaves = {"a": block([-3, -3, -1], [3, 3, 0]), "b": rod([-2, 0, 1], [2, 0, 1], F(1)),
              "c": ball([fraction(rng, F(-1), F(1)), y, z], radius)}
    return Case("rod on floor and ball", leaves, ("union", "a", "b", "c"), truth, where)


def pole_planes(rng, gap):
    """Two walls cut a quarter out of a ball or a cone; their edge is parallel to the axis, and near its pole or tip."""
    x, y = (rng.choice([1, -1]) * near(rng, gap, F(0), F(-1, 4), F(1, 4)) for _ in "xy")
    if (x == 0) != (y == 0):  # a tip in one wall alone
        return None
    round_one = rng.random() < 0.5
    body = ball([F(0)] * 3, F(1)) if round_one else cone([0, 0, 0], [0, 0, fraction(rng, F(1, 2), F(2), 8)], F(1))
    leaves = {"a": body, "b": block([x, y, F(-2)], [F(2), F(2), F(3)])}
    truth = (2, 3, 3, 1) if round_one else (4, 6, 4, 1)
    return Case("walls at a pole", leaves, ("difference", "a", "b"), truth, "ball" if round_one else "cone")


def clearance(rng, gap):
    """A cylinder less a longer one about its axis, or a cone less the same one moved along it, nearly in one place."""
    radius, height = fraction(rng, F(1, 2), F(3, 2), 8), fraction(rng, F(1), F(2), 8)
    wall = near(rng, gap, F(0), -radius / 2, radius / 2)
    where = "same" if wall == 0 else "inside" if wall > 0 else "outside"
    if rng.random() < 0.5:
        leaves = {"a": rod([0, 0, 0], [0, 0, height], radius), "b": rod([0, 0, -1], [0, 0, 3], radius - wall)}
        truth = (0, 4, 4, 1) if wall > 0 else NOTHING
    else:
        leaves = {"a": cone([0, 0, 0], [0, 0, height], radius), "b": cone([0, 0, -wall], [0, 0, height - wall], radius)}
        truth = NOTHING if wall == 0 else (0, 2, 3, 1)
    return Case("clearance", leaves, ("difference", "a", "b"), truth, where)


KINDS = [two_balls, three_balls, lens_plane, ball_plane, ball_two_planes, ball_corner, bore_wall, rod_oblique,
         rods_parallel, rods_skew, ball_rod, rod_on_floor, pin_bore, cone_plane, cone_ball,
         pole_planes, clearance]
