"""What `bench/run meshes` measures, of meshes whose measures are known, good and bad ones."""
import math
import unittest
from fractions import Fraction
from types import SimpleNamespace

import numpy

from exact import area_of, outside_of, planes_of, size
from measure import Tetrahedra

CORNERS = [(i & 1, i >> 1 & 1, i >> 2 & 1) for i in range(8)]
# Six tetrahedra about the diagonal 0 7 of the unit cube.
SIX = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]


def mesh(points, *blocks):
    """blocks: region, tetrahedra."""
    return Tetrahedra(SimpleNamespace(
        points=numpy.array(points, dtype=float),
        cells=[SimpleNamespace(type="tetra", data=numpy.array(cells)) for _, cells in blocks],
        cell_data={"gmsh:geometrical": [numpy.full(len(cells), region) for region, cells in blocks]}))


def square(axis, at, low=0.0, high=1.0):
    u, v = [k for k in range(3) if k != axis]
    loop = numpy.full((4, 3), float(at))
    loop[:, u], loop[:, v] = [low, high, high, low], [low, low, high, high]
    return loop


class Measures(unittest.TestCase):
    def test_volumes_of_regions(self):
        cube = mesh(CORNERS, (1, SIX[:2]), (5, SIX[2:]))
        volumes = cube.volumes()
        self.assertEqual(set(volumes), {1, 5})
        self.assertAlmostEqual(volumes[1], 1 / 3, places=15)
        self.assertAlmostEqual(volumes[5], 2 / 3, places=15)

    def test_overlapping_tetrahedra_are_more_volume(self):
        self.assertAlmostEqual(mesh(CORNERS, (1, SIX + SIX[:1])).volumes()[1], 7 / 6, places=15)

    def test_without_tetrahedra_there_is_nothing_to_measure(self):
        with self.assertRaisesRegex(ValueError, "no tetrahedra"):
            mesh(CORNERS)

    def test_shape_and_angle_of_the_regular_one(self):
        regular = mesh([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], (1, [(0, 1, 2, 3)]))
        self.assertAlmostEqual(regular.shape()[0], 1, places=14)
        self.assertAlmostEqual(regular.least_dihedral(), math.degrees(math.acos(1 / 3)), places=10)
        flat = mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], (1, [(0, 1, 2, 3)]))
        self.assertEqual(flat.shape()[0], 0)
        self.assertLess(flat.least_dihedral(), 1e-6)

    def test_sides_of_a_cube_are_covered(self):
        sides = [[square(axis, at)] for axis in range(3) for at in (0, 1)]
        self.assertAlmostEqual(mesh(CORNERS, (1, SIX)).covered_area(sides), 6, places=14)

    def test_a_polygon_through_tetrahedra_is_missed(self):
        cube = mesh(CORNERS, (1, SIX))
        self.assertEqual(cube.covered_area([[square(2, 0.5)]]), 0)
        self.assertEqual(cube.covered_area([[square(2, 1 + 1e-3)]]), 0)

    def test_a_missing_tetrahedron_leaves_its_faces_uncovered(self):
        # 0 1 3 7 alone has the half of z = 0 with x > y, and of x = 1 the half with y > z.
        covered = [mesh(CORNERS, (1, SIX[1:])).covered_area([[square(axis, at)]]) for axis, at in ((2, 0), (0, 1), (2, 1))]
        for found, area in zip(covered, (0.5, 0.5, 1)):
            self.assertAlmostEqual(found, area, places=14)

    def test_holes_do_not_count(self):
        # A triangle is counted by its middle: with a hole about (1/3, 2/3) only the other half is left.
        holed = [square(2, 0), square(2, 0, 0.6, 0.7)]
        holed[1][:, 0] -= 0.3
        self.assertAlmostEqual(mesh(CORNERS, (1, SIX)).covered_area([holed]), 0.5, places=14)

    def test_what_does_not_conform_is_missed(self):
        # Half of the square: the diagonal of the mesh is the other one, so its triangles lie across.
        triangle = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0)], dtype=float)
        found = mesh(CORNERS, (1, SIX)).covered_area([[triangle]])
        self.assertGreater(abs(found - 0.5), 0.4)

    def test_edges_are_covered_and_lines_across_are_not(self):
        cube = mesh(CORNERS, (1, SIX))
        ends = [numpy.array([CORNERS[a], CORNERS[b]], dtype=float) for a, b in ((0, 7), (0, 1), (1, 2))]
        self.assertAlmostEqual(cube.covered_length(ends[:1]), math.sqrt(3), places=14)
        self.assertAlmostEqual(cube.covered_length(ends[:2]), math.sqrt(3) + 1, places=14)
        self.assertEqual(cube.covered_length(ends[2:]), 0)


class Dominance(unittest.TestCase):
    def setUp(self):
        corners = [tuple(map(Fraction, p)) for p in CORNERS]
        faces = [[[0, 2, 3, 1]], [[4, 5, 7, 6]], [[0, 1, 5, 4]], [[2, 6, 7, 3]], [[0, 4, 6, 2]], [[1, 3, 7, 5]]]
        self.corners, self.faces, self.planes = corners, faces, planes_of(corners, faces)

    def area(self, polygon):
        return sum(size(area_of([piece])) for piece in outside_of(polygon, self.planes))

    def of_square(self, axis, at, low, high):
        at, low, high = map(Fraction, (at, low, high))
        u, v = [k for k in range(3) if k != axis]
        loop = []
        for a, b in ((low, low), (high, low), (high, high), (low, high)):
            p = [at] * 3
            p[u], p[v] = a, b
            loop.append(tuple(p))
        return loop

    def test_what_is_inside_of_a_convex_body_is_taken_away(self):
        self.assertEqual(self.area(self.of_square(2, "1/2", 0, 1)), 0)
        self.assertEqual(self.area(self.of_square(2, "1/2", -1, 2)), 8)
        self.assertEqual(self.area(self.of_square(2, "1/2", "1/2", 2)), 2)

    def test_what_touches_it_or_is_apart_stays(self):
        self.assertEqual(self.area(self.of_square(2, 1, 0, 1)), 1)
        self.assertEqual(self.area(self.of_square(2, 0, -1, 2)), 9)
        self.assertEqual(self.area(self.of_square(0, 2, 0, 1)), 1)

    def test_faces_may_be_turned_either_way_and_a_dent_is_seen(self):
        turned = [[loops[0][::-1]] for loops in self.faces]
        self.assertEqual([list(way) for _, way in planes_of(self.corners, turned)], [list(way) for _, way in self.planes])
        dented = self.corners + [(Fraction(1, 2),) * 3]
        self.assertIsNone(planes_of(dented, self.faces[:1] + [[[4, 5, 8]], [[5, 7, 8]], [[7, 6, 8]], [[6, 4, 8]]]))


if __name__ == "__main__":
    unittest.main()
