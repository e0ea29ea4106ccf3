"""Cases that users of this and other programs reported in public, written anew and small: volumes by formulas, cells
counted by hand. `cells` are vertices, edges, faces and regions of the result."""
import unittest
from fractions import Fraction
from math import pi, sin

import cnrg


class Case(unittest.TestCase):
    def result(self, nodes):
        return cnrg.parse(f"cnrg: 1\nnodes:\n{nodes}\nresult: m\n").evaluate().result

    def check(self, nodes, volume=None, cells=None):
        r = self.result(nodes)
        if volume is not None:
            self.assertEqual(r.volume, volume)
        if cells is not None:
            counted = [len(c.active) for c in (r.vertices, r.edges, r.faces, r.regions)]
            self.assertEqual(counted, list(cells))
        return r

    def about(self, r, true):
        """Within the bound that the result itself states."""
        self.assertLessEqual(abs(float(r.volume) - true), r.volume_bound)
        self.assertLess(r.volume_bound, 0.05 * true)


class Solids(Case):
    def test_two_tetrahedra_on_one_face(self):
        def volume(a, b, c, d):
            (x, y, z), (u, v, w), (p, q, r) = ([Fraction(s) - Fraction(t) for s, t in zip(e, a)] for e in (b, c, d))
            return abs(x * (v * r - w * q) - y * (u * r - w * p) + z * (u * q - v * p)) / 6

        base = [("-0.85", "34.2", "-32.2"), ("-38.7", "-48.6", "35.2"), ("-2.3", "-39.6", "-41.2")]
        # On the two sides of the base: one is the other one's mirror image in its middle.
        middle = [sum(map(Fraction, xs)) / 3 for xs in zip(*base)]
        tip = ("-2.22", "-18.9", "-7.25")
        other = [str(2 * m - Fraction(t)) for m, t in zip(middle, tip)]
        text = "\n".join(f"  {n}: {{tetrahedron: {[list(map(str, p)) for p in (*base, t)]}}}" for n, t in (("a", tip), ("b", other)))
        self.check(text + "\n  m: {union: [a, b]}", 2 * volume(*base, tip), (5, 9, 6, 1))
        self.check(text + "\n  m: {union: [a, b], dominance: left}", 2 * volume(*base, tip), (5, 9, 7, 2))

    def test_boxes_that_share_an_edge(self):
        r = self.check("""  a: {box: {min: [0, 0, 0], max: [10, 10, 10]}}
  b: {box: {min: [10, 10, 0], max: [20, 20, 10]}}
  m: {union: [a, b]}""", 2000, (14, 23, 12, 2))
        self.assertFalse(r.topology().manifold)

    def test_a_closed_void(self):
        r = self.check("""  out: {box: {min: [-10, -10, -10], max: [10, 10, 10]}}
  in: {box: {min: [-9, -9, -9], max: [9, 9, 9]}}
  m: {difference: [out, in]}""", 20**3 - 18**3, (16, 24, 12, 1))
        self.assertEqual(r.topology().betti, (1, 0, 1))

    def test_a_symmetric_difference_of_three(self):
        # 64 - 8, and 64, less twice the 8 - 1 that both have.
        self.check("""  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  c: {box: {min: [2, 2, 2], max: [6, 6, 6]}}
  ab: {union: [{difference: [a, b]}, {difference: [b, a]}]}
  m: {union: [{difference: [ab, c]}, {difference: [c, ab]}]}""", 56 + 64 - 2 * 7)

    def test_flush_holes_in_a_plate(self):
        holes = "\n".join(f"  s{i}: {{box: {{min: [{x}.5, 0.5, -1], max: [{x + 1}.5, 1.5, 1]}}}}" for i, x in enumerate((6, 7, 11, 12, 13)))
        plate = "  plate: {box: {min: [0, 0, 0], max: [21, 21, 21]}}\n" + holes + "\n"
        cut = "{difference: [plate, s0, s1, s2, s3, s4]}"
        # Two pockets of k = 2 and 3 cubes: 4 (k + 1) vertices, 7 k + 5 edges, 3 k + 2 faces.
        self.check(f"{plate}  m: {cut}", 21**3 - 5, (8 + 12 + 16, 12 + 19 + 26, 6 + 8 + 11, 1))
        # Without the features of the cubes each has four sides and a floor.
        self.check(f"{plate}  m: {{simplify: {{of: {cut}, mode: points}}}}", 21**3 - 5, (8 + 16, 12 + 24, 6 + 10, 1))

    def test_a_cube_with_three_square_holes(self):
        r = self.check("""  c: {box: {min: [0, 0, 0], max: [3, 3, 3]}}
  x: {box: {min: [-1, 1, 1], max: [4, 2, 2]}}
  y: {box: {min: [1, -1, 1], max: [2, 4, 2]}}
  z: {box: {min: [1, 1, -1], max: [2, 2, 4]}}
  m: {difference: [c, x, y, z]}""", 27 - 7)
        self.assertEqual(r.topology().betti, (1, 5, 0))  # six arms that meet: five loops

    def test_a_thin_wall_far_away(self):
        self.check("""  a: {box: {min: [1000000000, 0, 0], max: ["1000000000.001", 1, 1]}}
  b: {box: {min: ["1000000000.001", 0, 0], max: ["1000000000.0010000001", 1, 1]}}
  m: {union: [a, b], dominance: left}""", Fraction(1, 1000) + Fraction(1, 10**10), (12, 20, 11, 2))

    def test_components_of_a_sum(self):
        r = self.result("""  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  b: {box: {min: [2, 0, 0], max: [6, 4, 4]}}
  c: {box: {min: [1, 2, 0], max: [5, 6, 4]}}
  m: {sum: [a, b, c]}""")
        alone, pairs, all_three = [24, 24, 32], [16, 8, 8], [16]  # by inclusion and exclusion, in squares times 4
        self.assertEqual(sum(region.volume for region in r.regions), sum(alone + pairs + all_three))
        self.assertEqual(sorted(c.volume for c in r.components if c.volume), sorted(alone + pairs + all_three))

    def test_terrain_over_a_plane(self):
        self.check("  m: {heightfield: {heights: [[1, 2, 3], [3, 4, 5]], spacing: [1, 1], base: 0}}", 6)  # 1 + x + 2 y

    def test_the_hull_of_an_octahedron(self):
        self.check("  m: {hull: [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0, 0, 0]]}",
                   Fraction(4, 3), (6, 12, 8, 1))


class Round(Case):
    SHAFTS = """  up: {cylinder: {from: [0, 0, 0], to: [0, 0, 40], radius: 10, segments: 64}}
  across: {cylinder: {from: [-20, 0, 20], to: [20, 0, 20], radius: 10, segments: 64}}
"""

    def test_viviani(self):
        r = self.result("""  ball: {sphere: {center: [0, 0, 0], radius: 2, segments: 64}}
  rod: {cylinder: {from: [1, 0, -3], to: [1, 0, 3], radius: 1, segments: 64}}
  m: {intersection: [ball, rod]}""")
        self.about(r, 2 / 3 * 8 * (pi - 4 / 3))

    def test_equal_shafts_at_right_angles(self):
        self.about(self.result(self.SHAFTS + "  m: {intersection: [up, across]}"), 16 / 3 * 1000)
        self.about(self.result(self.SHAFTS + "  m: {union: [up, across]}"), 2 * pi * 100 * 40 - 16 / 3 * 1000)

    def test_a_ball_cut_by_a_ball(self):
        lens = pi * (4 * 10 + 15) * (2 * 10 - 15) ** 2 / 12
        r = self.result("""  a: {sphere: {center: [0, 0, 0], radius: 10, segments: 64}}
  b: {sphere: {center: [15, 0, 0], radius: 10, segments: 64}}
  m: {difference: [b, a]}""")
        self.about(r, 4 / 3 * pi * 1000 - lens)

    def test_nested_shells(self):
        radii = (5, 7, 10, 14)
        balls = "\n".join(f"  s{r}: {{sphere: {{center: [0, 0, 0], radius: {r}, segments: 48}}}}" for r in radii)
        r = self.check(balls + "\n  m: {union: [s5, s7, s10, s14], dominance: left}", cells=(0, 0, 4, 4))
        found = {region.name: float(region.volume) for region in r.regions}
        for inner, outer in zip((0, *radii), radii):
            self.assertAlmostEqual(found[f"s{outer}"] / (4 / 3 * pi * (outer**3 - inner**3)), 1, delta=0.02)
        self.about(r, 4 / 3 * pi * 14**3)

    def test_a_bar_with_a_bend(self):
        r = self.result("""  leg1: {box: {min: [-30, -2, -2], max: [0, 2, 2]}}
  bend: {revolve: {profile: [[8, -2], [12, -2], [12, 2], [8, 2]], center: [0, 10, 0], axis: [0, 0, 1], degrees: 90}, rotate: {axis: [0, 0, 1], degrees: -90, center: [0, 10, 0]}}
  leg2: {box: {min: [8, 10, -2], max: [12, 40, 2]}}
  m: {union: [leg1, bend, leg2]}""")
        self.about(r, 2 * 30 * 16 + 16 * 10 * pi / 2)  # Pappus

    def test_a_pin_that_overlaps_by_a_millionth(self):
        parts = """  box: {unify: {box: {min: [-5, -5, 0], max: [5, 5, 10]}}}
  pin: {unify: {cylinder: {from: [0, 0, "9.999999"], to: [0, 0, 20], radius: 2, segments: 48}}}
"""
        r = self.result(parts + "  m: {product: [box, pin]}")
        polygon = 48 / 2 * 4 * sin(2 * pi / 48)
        self.assertAlmostEqual(float(r.volume) / (polygon * 1e-6), 1, places=9)
        with self.assertRaisesRegex(cnrg.InputError, "overlap"):
            self.result(parts + "  m: {aggregate: [box, pin]}")


class Surfaces(Case):
    def test_a_floor_and_an_upright_triangle(self):
        # The triangle meets the floor from its corner to its middle: there the floor has a slit.
        self.check("""  floor: {polygon: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}
  upright: {polygon: [[0, 0, 1], [0, 0, -1], [1, 1, -1]]}
  m: {union: [floor, upright]}""", 0, (8, 10, 3, 0))

    def test_a_t_of_fractures_that_ends_in_a_wall(self):
        # 8 + 4 of the long one + 2 of the short one + 2 where they meet; 12 + 7 + 3; 6 + 2 + 1.
        self.check("""  cube: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  f1: {polygon: [[0.5, 0.4, 0.2], [0.5, 0.5, 0.2], [0.5, 0.5, 0.8], [0.5, 0.4, 0.8]]}
  f2: {polygon: [[0, 0.5, 0.2], [0.8, 0.5, 0.2], [0.8, 0.5, 0.8], [0, 0.5, 0.8]]}
  m: {union: [f1, f2, cube], dominance: left}""", 1, (16, 22, 9, 1))

    def test_a_line_that_ends_on_a_line_in_a_plane(self):
        self.check("""  domain: {polygon: [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]}
  first: {polyline: [[0.2, 0.2, 0], [1.8, 1.8, 0]]}
  second: {polyline: [[1, 1, 0], [1.7, 0.3, 0]]}
  m: {union: [first, second, domain]}""", 0, (8, 7, 1, 0))

    def test_three_fractures_make_eight_blocks(self):
        r = self.check("""  cube: {box: {min: [-1, -1, -1], max: [1, 1, 1]}}
  x: {polygon: [[0, -2, -2], [0, 2, -2], [0, 2, 2], [0, -2, 2]]}
  y: {polygon: [[-2, 0, -2], [2, 0, -2], [2, 0, 2], [-2, 0, 2]]}
  z: {polygon: [[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]]}
  cut: {intersection: [{union: [x, y, z]}, cube]}
  m: {union: [cut, cube], dominance: left}""", 8, (27, 54, 36, 8))
        self.assertEqual({region.volume for region in r.regions}, {1})
        self.assertEqual({abs(x) for region in r.regions for x in region.centroid}, {Fraction(1, 2)})

    def test_layers_west_of_a_fault(self):
        # The fault is at x = 400 on top and at 200 in a depth of 400.
        r = self.result("""  ground: {box: {min: [0, 0, -400], max: [1000, 500, 0]}}
  fault: {polygon: [[99, -9, -602], [501, -9, 202], [501, 509, 202], [99, 509, -602]]}
  west: {above: fault, within: ground}
  sand: {polygon: [[-9, -9, -90], [1009, -9, -90], [1009, 509, -90], [-9, 509, -90]]}
  upper: {above: sand, within: west, name: upper}
  lower: {below: sand, within: west, name: lower}
  m: {union: [upper, lower], dominance: left}""")
        middle = 400 - Fraction(90, 2)
        expected = {"upper": (400 + middle) / 2 * 90 * 500, "lower": (middle + 200) / 2 * 310 * 500}
        self.assertEqual({region.name: region.volume for region in r.regions}, expected)

    def test_a_bolt_through_two_layers(self):
        # Two boxes on one another have 12, 20, 11; the bolt crosses the wall between them.
        self.check("""  low: {box: {min: [0, 0, 0], max: [2, 2, 1]}}
  high: {box: {min: [0, 0, 1], max: [2, 2, 2]}}
  bolt: {polyline: [[1, 1, 0.5], [1, 1, 1.5]]}
  m: {union: [bolt, low, high], dominance: left}""", 8, (12 + 3, 20 + 2, 11, 2))


if __name__ == "__main__":
    unittest.main()
