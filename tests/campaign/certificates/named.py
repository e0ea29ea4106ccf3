"""Constellations that were certified and wrong once, or lost: each with its truth and why it is so."""
from fractions import Fraction as F

from bodies import Case, Frame, Leaf, ball, block, cone, half, operation, placed, plane, ring, rod


def fine(leaf, segments, rings=None, spin=()):
    leaf.fineness = {"segments": segments} | ({"rings": rings} if rings else {})
    leaf.spin = spin
    return leaf


def case(name, truth, leaves, *expression, gap="general"):
    return Case(name, leaves, expression, truth, "named", gap)


def pins():
    """Fuel, cladding and water around it from a STEP file, whose leaves are drawn apart: a ring of water (10 14 7), a
    tube (4 4 4, with a vertex on each circle) and a rod (2 2 3); water and tube have one side and its two circles in
    common."""
    o, top = [0, 0, 0], [0, 0, 20]
    leaves = {"fuel": rod(o, top, F("0.4096")), "outer": rod(o, top, F("0.475")), "inner": rod(o, top, F("0.418")),
              "box": block([F("-0.63"), F("-0.63"), 0], [F("0.63"), F("0.63"), 20])}
    nodes = {name: placed(leaf, Frame()) for name, leaf in leaves.items()}
    nodes["result"] = operation(("parts", "fuel", ("difference", "outer", "inner"), ("difference", "box", "outer")))
    solids = {name: Leaf("step", {}, {}, {"file": "pins.step", "solids": [i], "chord": F(1, 10)})
              for i, name in enumerate("abc", 1)}
    found = case("pins.step", (14, 18, 13, 3), solids, "parts", "a", "b", "c", gap="-2")
    found.files = {"pins.step": {"cnrg": 1, "nodes": nodes, "result": "result"}}
    return found


def named():
    o = [0, 0, 0]
    apart = [F(1999, 1000), 0, 0]
    balls = {"a": fine(ball(o, 1), 32, 16, ([1, 2, 3], 41)), "b": fine(ball(apart, 1), 32, 16, ([3, -2, 1], 17))}
    walls = {"a": plane([F("0.634"), 0, 0], [1, 0, 0]), "b": plane([0, F("0.773"), 0], [0, 1, 0])}
    boxes = {"a": block([-2, -2, -2], [F("0.634"), 2, 2]), "b": block([-2, -2, -2], [2, F("0.773"), 2])}
    unit_ball = {"ball": fine(ball(o, 1), 32, 16)}
    slim = {"a": fine(ball(["11/4", "3/2", "3/4"], 2), 9, 4),
            "b": fine(cone(["5/2", "9/4", 0], ["67/18", "37/36", "77/36"], F(5, 4)), 7)}
    for leaf in slim.values():
        leaf.points = {key: [F(x) for x in p] for key, p in leaf.points.items()}
    fuel = {"fuel": fine(rod(o, [0, 0, 20], F("0.4096")), 6), "outer": fine(rod(o, [0, 0, 20], F("0.475")), 6, None,
            (None, 30)), "inner": fine(rod(o, [0, 0, 20], F("0.418")), 6, None, (None, 30))}
    return [
        # Viviani's body: the rod touches the ball from inside, in (2, 0, 0).
        case("viviani", (1, 2, 2, 1), {"a": fine(ball(o, 2), 50, 25), "b": fine(rod([1, 0, -3], [1, 0, 3], 1), 46)},
             "difference", "a", "b", gap="contact"),
        # 0.634^2 + 0.773^2 < 1: the line of the planes passes inside of the ball.
        case("four parts", (2, 5, 8, 4), unit_ball | walls, "parts", ("intersection", "a", "ball"),
             ("intersection", "b", "ball"), "ball", gap="-4"),
        case("sliver", (2, 3, 3, 1), unit_ball | boxes, "difference", "ball", "a", "b", gap="-4"),
        # A bore of radius 1, 0.998 from a wall.
        case("bore", (12, 18, 8, 1), {"a": block([-4, -4, 0], [4, F("0.998"), 4]),
             "b": fine(rod([0, 0, -1], [0, 0, 5], 1), 32, None, (None, 5))}, "difference", "a", "b", gap="-3"),
        case("lens", (0, 1, 2, 1), balls, "intersection", "a", "b", gap="-3"),
        case("two balls", (0, 1, 2, 1), balls, "union", "a", "b", gap="-3"),
        # 0.4^2 + 0.9^2 < 1: the pin is inside of the bore.
        case("pin", (0, 0, 0, 0), {"plate": block([-3, -3, -1], [3, 3, 0]),
             "bore": fine(rod([0, 0, -2], [0, 0, 2], 1), 6),
             "pin": block([F("0.2"), F("0.6"), F("-0.5")], [F("0.4"), F("0.9"), F("-0.25")])},
             "intersection", ("difference", "plate", "bore"), "pin", gap="-1"),
        # The farthest point of the cone is 1.912 from the centre of the ball, of radius 2.
        case("cone in ball, union", (0, 0, 1, 1), slim, "union", "a", "b", gap="-1"),
        case("cone in ball, common", (0, 1, 2, 1), slim, "intersection", "a", "b", gap="-1"),
        case("cone in ball, rest", (0, 1, 3, 1), slim, "difference", "a", "b", gap="-1"),
        # The outermost circle of the torus touches the plane in the origin.
        case("tyre", (1, 0, 0, 0), {"slab": block([-4, -4, -1], [4, 4, 0]),
             "tyre": fine(ring([0, 0, 3], [F(3, 5), F(4, 5), 0], 2, 1), 9, 16)},
             "intersection", "slab", "tyre", gap="contact"),
        # Half a torus, and a pipe that goes on at one end: three circles, two sides, two flat ends.
        case("bend", (0, 3, 4, 1), {"ring": fine(ring(o, [-3, 0, 4], 2, 1), 32, 16), "cut": half(o, [4, 0, 3]),
             "pipe": fine(rod([0, -2, 0], [-4, -2, -3], 1), 32)}, "union", ("difference", "ring", "cut"), "pipe",
             gap="contact"),
        # The centre of the ball is 1 = 1/3 + 2/3 from the circle in the middle of the tube.
        case("ball on torus", (1, 0, 0, 0), {
            "a": fine(ring([F(2), F(4, 3), F(3)], [F(-12, 13), 0, F(5, 13)], 1, F(1, 3)), 6, 6),
            "b": fine(ball([F(14, 13), F(7, 3), F(44, 13)], F(2, 3)), 15, 5)}, "intersection", "a", "b", gap="contact"),
        # The cylinder touches the outermost circle of the torus from inside, and passes the innermost one.
        case("torus and cylinder", (1, 2, 3, 1), {"a": fine(ring(o, [0, 0, 1], 5, F(3, 2)), 96, 48),
             "b": fine(rod([4, 0, -4], [4, 0, 4], F(5, 2)), 96)}, "difference", "a", "b", gap="contact"),
        # Fuel in its cladding: 0.4096 < 0.418.
        case("fuel", (0, 6, 7, 2), fuel, "parts", "fuel", ("difference", "outer", "inner"), gap="-2"),
        # Equal balls whose centres are 1e-5 apart.
        case("equal balls", (0, 1, 2, 1), {"a": fine(ball(o, 1), 32, 16), "b": fine(ball([F("0.00001"), 0, 0], 1), 33,
             16)}, "union", "a", "b", gap="-5"),
        pins(),
    ]
