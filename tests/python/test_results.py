"""The cells of a result as arrays: against the exact file of the same result, cell by cell."""
import gc
import json
import os
import subprocess
import sys
import tempfile
import unittest
import warnings
from fractions import Fraction
from math import inf
from pathlib import Path

import numpy

import cnrg

SOURCES = Path(os.environ["CNRG_SOURCES"])
PROGRAM = os.environ["CNRG_PROGRAM"]

SLOPE = """cnrg: 1
materials: {rock: {color: "#998877"}}
nodes:
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}, material: rock}
  fault:  {polygon: [[20, -5, -5], [70, -5, 65], [70, 105, 65], [20, 105, -5]]}
  bolt:   {polyline: [[60, 50, 30], [60, 50, "145/3"]]}
  tunnel: {cylinder: {from: [60, -5, 30], to: [60, 105, 30], radius: 6, segments: 48}}
  inside: {intersection: [fault, ground]}
  split:  {union: [bolt, inside, ground], dominance: left}
  model:  {difference: [split, tunnel]}
result: model
"""
# Curved faces without edges, closed edges without vertices, facets.
ROUND = """cnrg: 1
nodes:
  ball:  {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}
  ring:  {torus: {center: [5, 0, 0], axis: [0, 0, 1], radius: 2, tube: 1/2, segments: 8, rings: 6}}
  bore:  {cylinder: {from: [5, 5, 0], to: [5, 5, 3], radius: 1, segments: 6}}
  block: {box: {min: [3, 3, 1], max: [7, 7, 2]}}
  model: {union: [ball, ring, {difference: [block, bore]}]}
result: model
"""
# Slits, isolated points in faces and in space, wires in regions, faces with holes.
MIXED = """cnrg: 1
nodes:
  slab:  {prism: {base: [[0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 0]], holes: [[[1, 1, 0], [2, 1, 0], [1, 2, 0]]], vector: [0, 0, 1]}}
  lines: {polyline: [[3, 3, 1], [4, 4, 1]]}
  hang:  {polyline: [[3, 4, 1], [3, 4, 3], [2, 5, 4]]}
  dots:  {points: [[5, 5, 1], [5, 5, 1/2], [9, 9, 9]]}
  sheet: {polygon: [[4, 1, 1], [5, 1, 1], [5, 1, 3]]}
  model: {union: [slab, lines, hang, dots, sheet], dominance: right}
result: model
"""
# Components of CNRG, open sets: cells that bound the result without being part of it.
OPEN = """cnrg: 1
nodes:
  a:     {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b:     {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  both:  {sum: [{interior: a}, b]}
  model: {subtract: [both, {points: [[1/2, 1/2, 1/2]]}]}
result: model
"""
# What reaches infinity.
HALF = """cnrg: 1
nodes:
  low:   {halfspace: {point: [0, 0, 0], normal: [1/3, 0, 1]}}
  wall:  {plane: {point: [0, 0, 0], normal: [1, 1, 0]}}
  box:   {box: {min: [-1, -1, -1], max: [1, 1, 1]}}
  model: {union: [wall, box, low], dominance: left}
result: model
"""
TREES = {"slope": SLOPE, "round": ROUND, "mixed": MIXED, "open": OPEN, "half": HALF}


def result_of(text, **options):
    return cnrg.parse(text).evaluate(**options).result


def exact_file(result):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.json"
        result.write(path)
        return json.loads(path.read_text())


def region_in(file, number):
    """A region as arrays have it: -1 for none, and for what has no bounds and is no part of the result."""
    outside = number is not None and file["regions"][number]["component"] == 0 and not file["regions"][number]["bounded"]
    return -1 if number is None or outside else number


class Arrays(unittest.TestCase):
    """Each test compares one part of the arrays with the file, for all trees."""

    @classmethod
    def setUpClass(cls):
        cls.results = {name: result_of(text) for name, text in TREES.items()}
        cls.files = {name: exact_file(result) for name, result in cls.results.items()}

    def each(self):
        for self.tree, result in self.results.items():
            yield result, self.files[self.tree]

    def _formatMessage(self, message, standard):
        return f"tree {getattr(self, 'tree', '')}: {super()._formatMessage(message, standard)}"

    def test_points_are_the_exact_ones_and_the_nearest_doubles(self):
        for result, file in self.each():
            exact = [tuple(Fraction(x) for x in p) for p in file["points"]]
            self.assertEqual(list(result.exact_points), exact)
            if exact:
                self.assertEqual(result.exact_points[-1], exact[-1])
            self.assertEqual(result.points.tolist(), [[float(x) for x in p] for p in exact])
            self.assertEqual(result.frame_points.tolist(), file["frame"])
            self.assertEqual(result.points.dtype, numpy.float64)
            with self.assertRaises(IndexError):
                result.exact_points[len(exact)]

    def test_vertices_are_those_of_the_file(self):
        for result, file in self.each():
            cells = result.vertices
            self.assertEqual(cells.point.tolist(), [v["point"] for v in file["vertices"]])
            self.assertEqual(cells.component.tolist(), [v["component"] for v in file["vertices"]])
            self.assertEqual(cells.entity.tolist(), [v["entity"] for v in file["vertices"]])
            self.assertEqual(cells.feature.tolist(), [v["feature"] for v in file["vertices"]])
            self.assertEqual(cells.region.tolist(), [region_in(file, v.get("region")) for v in file["vertices"]])
            for i, p in enumerate(cells.point):
                self.assertEqual(result.point_vertices[p], i)
            for i, edges in enumerate(cells.edges):
                ends = numpy.flatnonzero((result.edges.vertices == i).any(axis=1))
                self.assertEqual(sorted(set(edges.tolist())), ends.tolist())
                self.assertEqual(bool(cells.free[i]), len(edges) == 0)

    def test_edges_are_those_of_the_file(self):
        for result, file in self.each():
            cells = result.edges
            self.assertEqual(cells.points.tolist(), [e["points"] for e in file["edges"]])
            for key in ("component", "closed", "entity", "feature", "wire"):
                self.assertEqual(getattr(cells, key).tolist(), [e[key] for e in file["edges"]], key)
            self.assertEqual(cells.region.tolist(), [region_in(file, e.get("region")) for e in file["edges"]])
            for (a, b), e in zip(cells.vertices, file["edges"]):
                if e["closed"]:
                    self.assertEqual((a, b), (-1, -1))
                    continue
                self.assertEqual((a, b), (result.point_vertices[e["points"][0]], result.point_vertices[e["points"][-1]]))

    def test_faces_are_those_of_the_file(self):
        for result, file in self.each():
            cells = result.faces
            self.assertEqual([loops.tolist() for loops in cells.loops], [f["loops"] for f in file["faces"]])
            for key in ("component", "entity"):
                self.assertEqual(getattr(cells, key).tolist(), [f[key] for f in file["faces"]], key)
            regions = [[region_in(file, r) for r in f["regions"]] for f in file["faces"]]
            self.assertEqual(cells.regions.tolist(), regions)
            self.assertEqual(cells.patch.tolist(), [f["patch"] for f in file["faces"]])
            self.assertEqual(cells.isolated.tolist(), [f.get("isolated", []) for f in file["faces"]])
            self.assertEqual(cells.triangles.tolist(), [f["triangles"] for f in file["faces"]])
            self.assertEqual(cells.flat.tolist(), ["facets" not in f for f in file["faces"]])
            for i, f in enumerate(file["faces"]):
                facets = f.get("facets", [])
                self.assertEqual(cells.facets[i].tolist(), [facet["loops"] for facet in facets])
                self.assertEqual(cells.facet_isolated[i].tolist(), [facet.get("isolated", []) for facet in facets])
                if facets:
                    self.assertEqual(cells.facet_triangles[i].sum(), len(f["triangles"]))

    def test_regions_and_volumes_are_those_of_the_file(self):
        for result, file in self.each():
            cells = result.regions
            for key in ("component", "bounded"):
                self.assertEqual(getattr(cells, key).tolist(), [r[key] for r in file["regions"]], key)
            side = {"front": 0, "back": 1}
            shells = [[[2 * s["face"] + side[s["side"]] for s in shell] for shell in r["shells"]] for r in file["regions"]]
            self.assertEqual([of.tolist() for of in cells.shells], shells)
            volumes = [None if r["volume"] is None else Fraction(r["volume"]) for r in file["regions"]]
            self.assertEqual(cells.exact_volumes, volumes)
            self.assertEqual([cells.volume(i) for i in range(len(cells))], volumes)
            self.assertEqual(cells.volumes.tolist(), [inf if v is None else float(v) for v in volumes])
            for c in result.components:
                own = [v for v, r in zip(volumes, file["regions"]) if r["component"] == c.number]
                self.assertEqual(c.volume, None if None in own else sum(own, Fraction(0)))
            active = [v for v, r in zip(volumes, file["regions"]) if r["component"]]
            self.assertEqual(result.volume, None if None in active else sum(active, Fraction(0)))

    def test_components_materials_and_leaves_are_those_of_the_file(self):
        for result, file in self.each():
            self.assertEqual(result.leaves, tuple(leaf["name"] for leaf in file["leaves"]))
            self.assertEqual(result.is_group, file["group"])
            self.assertEqual(result.materials, [(m["name"], m["color"]) for m in file["materials"]])
            listed = [(c["name"], c["material"], tuple(result.leaves[k] for k in c["leaves"])) for c in file["components"]]
            own = [(c.name, c.material, c.leaves) for c in result.components]
            self.assertEqual(own[: len(listed)], listed)
            if result.is_group:  # the entities are one more
                self.assertEqual([c[0] for c in own[len(listed) :]], ["entities"] * (len(own) - len(listed)))

    def test_origins_are_those_of_the_file(self):
        keys = {"point": 0, "edges": 1, "faces": 2, "regions": 3}
        for result, file in self.each():
            for kind in ("vertices", "edges", "faces", "regions"):
                cells = getattr(result, kind)
                for i, cell in enumerate(file[kind]):
                    leaves = [entry["leaf"] for entry in cell.get("origin", [])]
                    of = [
                        [entry["leaf"], keys[key], number]
                        for entry in cell.get("origin", [])
                        for key in ("point", "edges", "faces", "regions")
                        for number in ([0] if entry.get(key) is True else entry.get(key, []))
                    ]
                    self.assertEqual(cells.origin_leaves[i].tolist(), leaves)
                    self.assertEqual(cells.origin_cells[i].tolist(), sorted(of))
                    words = ("point", "wire", "face", "region")
                    self.assertEqual(cells.origin(i), [(result.leaves[a], words[d], n) for a, d, n in sorted(of)])

    def test_walks_by_edges_are_the_walks_by_points(self):
        for result, _ in self.each():
            frame = set(result.frame_points.tolist())
            for loops, walks in zip(result.faces.loops, result.faces.loop_edges):
                for loop, walk in zip(loops, walks):
                    if frame.intersection(loop.tolist()):
                        continue
                    pieces = []
                    for half in walk.tolist():
                        points = result.edges.points[half >> 1].tolist()
                        if result.edges.closed[half >> 1]:
                            points = points + points[:1]
                        pieces += list(zip(points, points[1:])) if half & 1 == 0 else list(zip(points[::-1], points[-2::-1]))
                    loop = loop.tolist()
                    self.assertEqual(sorted(pieces), sorted(zip(loop, loop[1:] + loop[:1])))

    def test_radial_orders_name_each_face_that_has_the_edge_on_its_boundary(self):
        for result, _ in self.each():
            uses = [0] * len(result.edges)
            for i, walks in enumerate(result.faces.loop_edges):
                for walk in walks:
                    for half in walk.tolist():
                        uses[half >> 1] += 1
                        self.assertIn(i, result.edges.around[half >> 1] >> 1)
            self.assertEqual(result.edges.around.lengths.tolist(), uses)
            self.assertEqual((result.edges.around.lengths == 0).tolist(), result.edges.wire.tolist())

    def test_radial_order_turns_counter_clockwise(self):
        # Four quarters about the z-axis: met at 0, 90, 180 and 270 degrees.
        sheets = [cnrg.polygon([[0, 0, 0], [0, 0, 1], [x, y, 1], [x, y, 0]]) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))]
        result = cnrg.union(*sheets).evaluate()
        axis = next(i for i, of in enumerate(result.edges.around) if len(of) == 4)
        upward = result.points[result.edges.points[axis][-1]][2] > result.points[result.edges.points[axis][0]][2]
        middles = [result.points[result.faces.triangles[side >> 1]].mean(axis=(0, 1)) for side in result.edges.around[axis]]
        angles = numpy.degrees([numpy.arctan2(y, x) for x, y, _ in middles])
        steps = numpy.mod(numpy.diff(angles), 360)
        self.assertTrue(numpy.allclose(steps, 90 if upward else 270), angles)

    def test_lengths_and_areas(self):
        for result, _ in self.each():
            for i in result.edges.active:
                points = [result.exact_points[int(p)] for p in result.edges.points[i]]
                if result.edges.closed[i]:
                    points.append(points[0])
                squares = [sum((x - y) ** 2 for x, y in zip(a, b)) for a, b in zip(points, points[1:])]
                length = result.edges.lengths[i]
                if set(result.edges.points[i].tolist()) & set(result.frame_points.tolist()):
                    self.assertEqual(length, inf)
                    self.assertIsNone(result.edges.squared_length(i))
                    continue
                self.assertAlmostEqual(length, sum(float(s) ** 0.5 for s in squares), places=12)
                if len(squares) == 1:
                    self.assertEqual(result.edges.squared_length(i), squares[0])
            for i in result.faces.active:
                on_frame = any(set(loop.tolist()) & set(result.frame_points.tolist()) for loop in result.faces.loops[i])
                if on_frame:
                    self.assertEqual(result.faces.areas[i], inf)
                    self.assertIsNone(result.faces.area_vector(i))
                    self.assertTrue(numpy.isnan(result.faces.area_vectors[i]).all())
                    continue
                p = result.points[result.faces.triangles[i]]
                vectors = numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) / 2
                self.assertTrue(numpy.allclose(result.faces.area_vectors[i], vectors.sum(axis=0)))
                self.assertAlmostEqual(result.faces.areas[i], numpy.linalg.norm(vectors, axis=1).sum(), places=9)
                exact = result.faces.area_vector(i)
                self.assertEqual([float(x) for x in exact], result.faces.area_vectors[i].tolist())
                square = result.faces.squared_area(i)
                self.assertEqual(square is None, not result.faces.flat[i])
                if square is not None:
                    self.assertEqual(square, sum(x * x for x in exact))

    def test_volumes_follow_from_shells(self):
        # The divergence theorem over triangles of the sides, in fractions.
        for result, _ in self.each():
            for i in range(len(result.regions)):
                if not result.regions.bounded[i]:
                    continue
                six = Fraction(0)
                for shell in result.regions.shells[i]:
                    for side in shell:
                        for triangle in result.faces.triangles[side >> 1]:
                            a, b, c = (result.exact_points[int(p)] for p in triangle)
                            volume = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                                      + a[2] * (b[0] * c[1] - b[1] * c[0]))
                            six += volume if side & 1 else -volume
                self.assertEqual(six / 6, result.regions.volume(i))


class Figures(unittest.TestCase):
    def test_figures_of_papers_are_as_their_files(self):
        for name in ("pereira2012/fig10.yaml", "rossignac1991/operators.yaml", "weiler1986/edge.yaml"):
            with self.subTest(name):
                result = cnrg.read(SOURCES / "papers" / name).evaluate().result
                file = exact_file(result)
                self.assertEqual([loops.tolist() for loops in result.faces.loops], [f["loops"] for f in file["faces"]])
                self.assertEqual(result.edges.points.tolist(), [e["points"] for e in file["edges"]])
                self.assertEqual(result.regions.exact_volumes,
                                 [None if r["volume"] is None else Fraction(r["volume"]) for r in file["regions"]])


class ListsOfLists(unittest.TestCase):
    def test_lists_are_sequences(self):
        lists = result_of(SLOPE).edges.points
        self.assertIsInstance(lists, cnrg.Lists)
        self.assertEqual(lists[-1].tolist(), lists[len(lists) - 1].tolist())
        self.assertEqual([part.tolist() for part in lists], lists.tolist())
        self.assertEqual(lists[2:5].tolist(), lists.tolist()[2:5])
        self.assertEqual(lists[5:2].tolist(), [])
        self.assertEqual(lists[2:5].owners.tolist(), [i for i, part in enumerate(lists[2:5]) for _ in part])
        self.assertEqual(lists.lengths.sum(), len(lists.values))
        for wrong in (len(lists), -len(lists) - 1):
            with self.assertRaises(IndexError):
                lists[wrong]
        with self.assertRaises(ValueError):
            lists[::2]


class Memory(unittest.TestCase):
    def test_arrays_live_on_when_all_else_is_gone(self):
        result = result_of(SLOPE)
        points, triangles, component = result.points, result.faces.triangles.values, result.faces.component
        copies = [array.copy() for array in (points, triangles, component)]
        part = points[3:5]
        del result
        gc.collect()
        result_of(ROUND).points  # takes what is free now
        for array, copy in zip((points, triangles, component), copies):
            self.assertTrue((array == copy).all())
        del points
        gc.collect()
        self.assertTrue((part == copies[0][3:5]).all())

    def test_arrays_are_views_of_one_memory_and_cannot_be_written(self):
        result = result_of(SLOPE)
        self.assertEqual(result.points.ctypes.data, result.points.ctypes.data)
        again = cnrg._cnrg.ResultArrays.data(result._arrays)
        self.assertEqual(again["points"].ctypes.data, result.points.ctypes.data)
        self.assertFalse(result.points.flags.owndata)
        for array in (result.points, result.edges.vertices, result.faces.flat, result.edges.around.offsets):
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_memory_does_not_grow(self):
        script = (
            "import cnrg, resource\n"
            "node = cnrg.sphere([0, 0, 0], 1, segments=96) - cnrg.box([0, 0, 0], [2, 2, 2])\n"
            "def once():\n"
            "    r = node.evaluate()\n"
            "    r.points, r.faces.triangles, r.edges.around, r.regions.volumes, r.locate(r.points)\n"
            "    kept = r.vertices.point\n"
            "    del r\n"
            "    return kept\n"
            "for i in range(15): once()\n"
            "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
            "for i in range(40): once()\n"
            "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)\n"
        )
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=200)
        self.assertEqual(done.returncode, 0, done.stderr)
        # One round takes several megabytes: forty that leaked would take hundreds.
        self.assertLess(int(done.stdout), 40_000)


class ArraysOfRandomTrees(Arrays):
    """The same for random trees of every leaf and operator."""

    @classmethod
    def setUpClass(cls):
        sys.path.append(os.environ["CNRG_SOURCES"] + "/bench/same")
        import trees

        first, count = int(os.environ.get("CNRG_FIRST_SEED", 0)), int(os.environ.get("CNRG_SEEDS", 0)) or 30
        cls.results = {}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", cnrg.Notice)
            for number in range(first, first + count):
                tree = trees.random_tree(5, number)
                try:
                    result = None if tree.files or tree.before else result_of(tree.text)
                except cnrg.InputError:
                    continue  # some are faulty
                if result is not None and len(result.points) < 400:
                    cls.results[f"random {number}"] = result
        cls.files = {name: exact_file(result) for name, result in cls.results.items()}

    def test_most_trees_are_good(self):
        self.assertGreater(len(self.results), 10)


class Snapped(unittest.TestCase):
    def test_a_snapped_result_is_made_of_doubles_and_stands_alone(self):
        gap = cnrg.box([0, 0, 0], [1, 1, 1]) | cnrg.box([0, 0, "1.00000000000000001"], [1, 1, 2])
        result = gap.evaluate()
        self.assertEqual(len(result.regions.active), 2)
        snapped = result.snap()
        self.assertTrue(all(float(x) == x for p in snapped.exact_points for x in p))
        self.assertEqual(snapped.volume, 2)
        with self.assertRaisesRegex(cnrg.InputError, "tree"):
            snapped.explain("f0")
        self.assertEqual(len(snapped.faces), 11)
        self.assertFalse(result.compare(snapped))
        self.assertTrue(snapped.compare(snapped.snap()))

    def test_near_features_are_joined_and_regions_that_vanish_are_named(self):
        bolt = cnrg.polyline([[1, 1, 0.5], [1, 1, "0.99999"]], name="bolt")
        low = cnrg.box([0, 0, 0], [2, 2, 1], name="low")
        dust = cnrg.box([0, 0, 1], [2, 2, "1.00001"], name="dust")
        high = cnrg.box([0, 0, "1.00001"], [2, 2, 2], name="high")
        result = cnrg.union(bolt, low, dust, high, dominance="left").evaluate()
        with self.assertWarnsRegex(cnrg.Notice, "the region dust, r[0-9]+, at .* has vanished"):
            joined = result.join("0.001")
        self.assertEqual(joined.volume, 8)
        self.assertEqual(len(result.regions.active), 3)
        self.assertEqual(len(joined.regions.active), 2)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertIs(joined.join("0.001"), joined)
        for distance in (0, -1, 2, float("nan"), "x"):
            with self.assertRaises(cnrg.InputError):
                result.join(distance)

    def test_regions_that_vanish_when_a_result_is_snapped_are_named(self):
        low = cnrg.box([0, 0, 0], [1, 1, 1], name="low")
        dust = cnrg.box([3, 0, 1], [4, 1, "1.00000000000000001"], name="dust")
        result = (low | dust).evaluate()
        told = "the region dust, r[0-9]+, at \\(3, 0, 1\\), is thinner than .*e-17 and has vanished"
        with self.assertWarnsRegex(cnrg.Notice, "^" + told):
            snapped = result.snap()
        self.assertEqual([r.name for r in snapped.components], ["low", "entities"])
        with tempfile.TemporaryDirectory() as folder:
            with self.assertWarnsRegex(cnrg.Notice, "a.msh: " + told):
                notices = result.write(f"{folder}/a.msh")
            self.assertRegex(" ".join(notices), "snapped 4 of 16 .*1 region vanished")

    def test_files_are_snapped_unless_they_are_not_to_be(self):
        gap = (cnrg.box([0, 0, 0], [1, 1, 1]) | cnrg.box([0, 0, "1.00000000000000001"], [1, 1, 2])).evaluate()
        with tempfile.TemporaryDirectory() as folder:
            self.assertRegex(" ".join(gap.write(f"{folder}/a.vtu")), "snapped 4 of 16")
            self.assertEqual(gap.write(f"{folder}/a.json"), [])
            with self.assertWarnsRegex(cnrg.Notice, "broke the result"):
                gap.write(f"{folder}/b.vtu", snap=False)
            box = cnrg.box([0, 0, 0], [1, 1, 1]).evaluate()
            self.assertEqual(box.write(f"{folder}/box.stl", binary=True), [])
            self.assertEqual(os.path.getsize(f"{folder}/box.stl"), 84 + 12 * 50)
            with self.assertRaises(cnrg.InputError):
                box.write(f"{folder}/box.obj", binary=True)

    def test_what_is_on_doubles_stays_itself(self):
        result = cnrg.box([0, 0, 0], [1, 1, 1]).evaluate()
        self.assertIs(result.snap(), result)


if __name__ == "__main__":
    unittest.main()
