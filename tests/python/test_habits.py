"""What users of other packages type: sizes, operators, meshes and results as operands, words with a remedy."""
import builtins
import copy
import itertools
import os
import pickle
import shutil
import subprocess
import sys
import types
import unittest
import warnings
from fractions import Fraction
from pathlib import Path

import numpy

import cnrg
from test_conversions import WithFolder
from test_results import HALF, MIXED, OPEN, ROUND, SLOPE, result_of

UNIT = cnrg.box([0, 0, 0], [1, 1, 1])
FAR = cnrg.box([2, 0, 0], [3, 1, 1])
L_SHAPE = cnrg.box([0, 0, 0], [2, 2, 1]) - cnrg.box([1, 1, -1], [3, 3, 2])


def corners(numbers):
    """The corners of a box as other packages list them, and its 12 triangles, outward."""
    points = numpy.array(list(itertools.product(*numbers)), dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points, numpy.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


class Sizes(unittest.TestCase):
    def test_an_l_by_hand(self):
        # Three unit cubes: their middles are (1/2, 1/2), (3/2, 1/2), (1/2, 3/2) at the height 1/2.
        r = L_SHAPE.evaluate()
        self.assertEqual(r.volume, 3)
        self.assertEqual(r.exact_centroid, (Fraction(5, 6), Fraction(5, 6), Fraction(1, 2)))
        self.assertEqual(r.exact_area, 14)  # 2 * 3 and a wall of height 1 around 8
        self.assertEqual(r.exact_bounds, ((0, 0, 0), (2, 2, 1)))
        self.assertEqual(r.bounds.tolist(), [[0, 0, 0], [2, 2, 1]])
        self.assertEqual((r.bounds.dtype, r.centroid.dtype, r.centroid.shape), (float, float, (3,)))
        self.assertAlmostEqual(r.area, 14)
        self.assertTrue((abs(r.centroid - [5 / 6, 5 / 6, 0.5]) < 1e-15).all())

    def test_a_centroid_moves_with_the_solid_and_weighs_regions(self):
        turn = [[0, -1, 0, 5], [1, 0, 0, "1/3"], [0, 0, 1, -7], [0, 0, 0, 1]]
        x, y, z = (UNIT | FAR.scale(2)).evaluate().exact_centroid  # 1 at 1/2 and 8 at (5, 1, 1)
        self.assertEqual((x, y, z), (Fraction(81, 18), Fraction(17, 18), Fraction(17, 18)))
        moved = (UNIT | FAR.scale(2)).transform(turn).evaluate()
        self.assertEqual(moved.exact_centroid, (5 - y, x + Fraction(1, 3), z - 7))
        for region in moved.regions:
            self.assertEqual(region.centroid, moved.regions.exact_centroids[region.number])

    def test_a_tetrahedron_has_its_centroid_at_the_mean_of_its_corners(self):
        points = [["1/3", 0, 0], [5, "1/7", 1], [0, 4, 2], [1, 1, 9]]
        r = cnrg.tetrahedron(*points).evaluate()
        self.assertEqual(r.exact_centroid, tuple(sum(map(Fraction, c)) / 4 for c in zip(*points)))

    def test_a_cavity_counts(self):
        r = (cnrg.box(size=4) - cnrg.box([1, 1, 1], [2, 2, 2])).evaluate()
        self.assertEqual(r.exact_centroid[0], (64 * 2 - Fraction(3, 2)) / 63)
        self.assertEqual(r.exact_area, 6 * 16 + 6)

    def test_a_wall_counts_once(self):
        r = cnrg.union(UNIT, cnrg.box([1, 0, 0], [2, 1, 1]), dominance="left").evaluate()
        self.assertEqual(len(list(r.regions)), 2)
        self.assertEqual(r.exact_area, 11)

    def test_what_is_no_fraction_or_has_no_end(self):
        slope = cnrg.polygon([[0, 0, 0], [1, 0, 1], [1, 1, 1], [0, 1, 0]]).evaluate()
        self.assertIsNone(slope.exact_area)
        self.assertAlmostEqual(slope.area, 2**0.5)
        self.assertIsNone(slope.centroid)
        half = cnrg.halfspace([0, 0, 0], [0, 0, 1]).evaluate()
        self.assertEqual((half.bounds, half.centroid, half.area), (None, None, float("inf")))
        self.assertIsNone((~UNIT).evaluate().bounds)
        self.assertIsNone((UNIT - UNIT).evaluate().bounds)

    def test_a_ball_is_in_the_middle(self):
        r = cnrg.sphere([1, 2, 3], 2).evaluate()
        self.assertTrue((abs(r.centroid - [1, 2, 3]) < 1e-12).all())
        self.assertTrue(0.95 < r.area / (16 * numpy.pi) < 1)

    def test_regions_are_those_of_the_result(self):
        both = (UNIT.named("a").with_(material="rock") | FAR.named("b")).evaluate()
        self.assertEqual([(r.name, r.material, r.volume) for r in both.regions], [("a", "rock", 1), ("b", "", 1)])
        self.assertEqual(len(both.regions), 3)  # with the outside, as in files
        self.assertEqual(sorted(set(both.faces.regions.ravel().tolist())), [-1, *(r.number for r in both.regions)])
        for text in (SLOPE, ROUND, MIXED, OPEN, HALF):
            result = result_of(text)
            self.assertEqual([r.number for r in result.regions], result.regions.active.tolist())

    def test_contains(self):
        r = L_SHAPE.evaluate()
        asked = [[0.5, 0.5, 0.5], [1.5, 1.5, 0.5], [1, 1.5, 0.5], [9, 9, 9]]
        self.assertEqual(r.contains(asked).tolist(), [True, False, True, False])
        self.assertEqual(r.contains(numpy.array(asked)).dtype, bool)

    def test_a_table_for_pandas(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        r = L_SHAPE.evaluate()
        table = r.faces.to_pandas()
        self.assertEqual(len(table), len(r.faces))
        self.assertEqual(table["regions_1"].tolist(), r.faces.regions[:, 1].tolist())


class Operators(unittest.TestCase):
    def test_plus_is_the_union_and_hat_the_symmetric_difference(self):
        a, b = cnrg.box([0, 0, 0], [2, 1, 1]), cnrg.box([1, 0, 0], [5, 1, 1])
        self.assertTrue((a + b).evaluate().compare((a | b).evaluate()).same)
        self.assertTrue(sum([a, b]).evaluate().compare((a | b).evaluate()).same)
        self.assertEqual((a ^ b).evaluate().volume, 1 + 3)
        self.assertEqual((a ^ a).evaluate().volume, 0)
        for wrong in (lambda: a + 1, lambda: 1 + a, lambda: a ^ "b", lambda: a - [b]):
            self.assertRaises(TypeError, wrong)

    def test_a_box_by_its_size(self):
        def box(**keys):
            return cnrg.box(**keys).evaluate().exact_bounds

        self.assertEqual(box(size=[1, 2, 3]), ((0, 0, 0), (1, 2, 3)))
        self.assertEqual(box(size="1/3", center=True)[1], (Fraction(1, 6),) * 3)
        self.assertEqual(box(size=2, center=[1, 2, 3]), ((0, 1, 2), (2, 3, 4)))
        self.assertEqual(box(size=(1, 1, 1), min=[5, 5, 5]), ((5, 5, 5), (6, 6, 6)))
        self.assertEqual(box(size=0.1), ((0, 0, 0), (Fraction(0.1),) * 3))
        for wrong in ({}, {"min": [0, 0, 0]}, {"size": 1, "max": [1, 1, 1]}, {"center": True},
                      {"size": 1, "min": [0, 0, 0], "center": True}):
            self.assertRaises(TypeError, cnrg.box, **wrong)
        self.assertRaises(cnrg.InputError, cnrg.box, size=[1, 2])
        self.assertRaises(cnrg.InputError, cnrg.box(size=-1).evaluate)

    def test_a_matrix_of_four_rows(self):
        r = UNIT.transform(numpy.array([[2, 0, 0, 1], [0, 3, 0, 2], [0, 0, 4, 3], [0, 0, 0, 1]])).evaluate()
        self.assertEqual(r.exact_bounds, ((1, 2, 3), (3, 5, 7)))
        for wrong in ([[1, 0, 0, 0]] * 3, [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]):
            self.assertRaisesRegex(cnrg.InputError, "0, 0, 0, 1", UNIT.transform, wrong)

    def test_star_hides_nothing_of_python(self):
        names = {}
        exec("from cnrg import *", names)
        self.assertEqual(set(names) & set(dir(builtins)), set() | {"__builtins__"} & set(dir(builtins)))
        self.assertTrue({"box", "union", "evaluate", "product"} <= set(names))
        self.assertEqual(cnrg.sum(UNIT, FAR).operator, "sum")


class Meshes(WithFolder):
    def check(self, mesh):
        self.assertEqual(cnrg.mesh(mesh).evaluate().volume, 24)
        self.assertEqual((cnrg.box(size=4) - mesh).evaluate().volume, 64 - 24)
        self.assertEqual((mesh & cnrg.box(size=1)).evaluate().volume, 1)
        self.assertEqual(cnrg.union([UNIT, mesh]).evaluate().volume, 24)

    def test_of_trimesh(self):
        points, faces = corners(([0, 2], [0, 3], [0, 4]))
        self.check(types.SimpleNamespace(vertices=points, faces=faces))

    def test_of_pyvista(self):
        points, faces = corners(([0, 2], [0, 3], [0, 4]))
        flat = numpy.column_stack([numpy.full(12, 3), faces]).ravel()
        self.check(types.SimpleNamespace(points=points, faces=flat))
        quads = [[4, 0, 1, 3, 2], [4, 4, 6, 7, 5], [4, 0, 4, 5, 1], [4, 2, 3, 7, 6], [4, 0, 2, 6, 4],
                 [3, 1, 5, 7], [3, 1, 7, 3]]
        self.check(types.SimpleNamespace(points=points, faces=numpy.concatenate(quads)))
        with_lines = types.SimpleNamespace(points=points, faces=flat, n_lines=2, n_strips=0, n_verts=0)
        self.assertRaisesRegex(cnrg.InputError, "lines beside faces.*extract_surface", cnrg.mesh, with_lines)

    def test_of_meshio(self):
        points, faces = corners(([0, 2], [0, 3], [0, 4]))

        def mesh(**cells):
            blocks = [types.SimpleNamespace(type=kind, data=numpy.array(data)) for kind, data in cells.items()]
            return types.SimpleNamespace(points=points, cells=blocks, cells_dict=None)

        self.check(mesh(triangle=faces))
        self.check(mesh(triangle=faces[:10], quad=[[1, 5, 7, 3]]))
        with self.assertWarnsRegex(cnrg.Notice, "line, vertex are left out"):
            self.assertEqual(cnrg.mesh(mesh(vertex=[[0]], triangle=faces, line=[[0, 1]])).evaluate().volume, 24)
        self.assertRaisesRegex(cnrg.InputError, "not tetra; give the surface", cnrg.mesh, mesh(tetra=[[0, 1, 2, 4]]))

    def test_of_the_package_itself(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("meshio is not installed")
        path = str(self.folder / "box.stl")
        cnrg.box(size=[2, 3, 4]).evaluate().write(path)
        self.check(meshio.read(path))

    def test_what_is_no_mesh(self):
        self.assertRaisesRegex(TypeError, "points and faces", cnrg.mesh, [[0, 0, 0]])
        self.assertRaisesRegex(TypeError, "result.node", cnrg.mesh, UNIT.evaluate())
        self.assertRaisesRegex(TypeError, "meshes, not int", cnrg.union, UNIT, 3)


class ResultsAsOperands(WithFolder):
    def test_they_are_what_their_files_are(self):
        for number, text in enumerate((SLOPE, ROUND, MIXED, OPEN)):
            result = result_of(text)
            path = self.folder / f"{number}.json"
            result.write(path)
            cut = cnrg.box([-1, -1, -1], [2, 3, "7/3"], material="cut").named("cut")
            memory = (result.node.closure() & cut).evaluate()
            file = (cnrg.load(path).named("cnrg").closure() & cut).evaluate()
            for name, r in (("memory", memory), ("file", file)):
                r.write(self.folder / f"{name}.json")
            self.assertTrue(memory.compare(file).same, number)
            self.assertTrue(memory.volume_bound <= file.volume_bound <= 1.01 * memory.volume_bound)  # three digits
            self.assertEqual(memory.points.tolist(), file.points.tolist())
            again = result.node.evaluate()
            self.assertTrue(again.compare(result).same, number)

    def test_a_tree_grows_step_by_step(self):
        # Each step evaluates two leaves, whatever was before.
        made = UNIT.evaluate()
        for i in range(1, 20):
            evaluation = cnrg.evaluate((made | cnrg.box([i, 0, 0], [i + 1, 1, 1])).regularize().unify())
            self.assertEqual(len(evaluation), 5)
            made = evaluation.result
        self.assertEqual((made.volume, made.exact_bounds[1]), (20, (20, 1, 1)))
        self.assertEqual(len(made.faces.active), 6)

    def test_names_materials_and_numbers_stay(self):
        rock = cnrg.box([0, 0, 0], [2, 2, 2], material=cnrg.material("rock", color="#123456")).named("ground")
        hole = (rock - cnrg.sphere([1, 1, 1], 1)).evaluate()
        cut = (hole & cnrg.box([0, 0, 0], [2, 2, 1])).evaluate()
        self.assertEqual([(r.name, r.material) for r in cut.regions], [("ground", "rock")])
        self.assertIn(("rock", "#123456"), cut.materials)
        picked = hole.node.select(dimension=3, material="rock").evaluate()
        self.assertEqual(picked.volume, hole.volume)
        self.assertGreater(hole.volume_bound, 0)
        self.assertEqual(hole.node.evaluate().volume_bound, hole.volume_bound)

    def test_a_tree_of_it_is_no_file(self):
        node = UNIT.evaluate().node
        self.assertIs(UNIT.evaluate().node.operator, "cnrg")
        with self.assertRaisesRegex(cnrg.InputError, r"'box' stands in no file.*result.write\(\"part.json\"\)"):
            (node - FAR).to_yaml()

    def test_what_has_no_bounds_is_refused(self):
        result = cnrg.halfspace([0, 0, 0], [0, 0, 1]).evaluate()
        self.assertRaisesRegex(cnrg.InputError, "no bounds.*cut the node with a box", lambda: result - UNIT)
        self.assertRaisesRegex(cnrg.InputError, "no bounds", pickle.dumps, result)

    def test_the_outside_as_an_operand(self):
        outside = (~UNIT).evaluate()
        self.assertEqual((outside.node.closure() & cnrg.box([0, 0, 0], [1, 1, 2])).evaluate().volume, 1)

    def test_nodes_of_results_can_be_pickled(self):
        node = L_SHAPE.evaluate() - UNIT
        self.assertEqual(pickle.loads(pickle.dumps(node)).evaluate().volume, 2)
        self.assertEqual(copy.deepcopy(node).evaluate().volume, 2)


class FilesOfResults(WithFolder):
    def test_a_vtu_is_read_back(self):
        two = cnrg.union(UNIT, cnrg.box([1, 0, 0], [3, 1, 1]), dominance="left").evaluate()
        two.write(self.folder / "two.vtu")
        again = cnrg.load(self.folder / "two.vtu").evaluate()
        self.assertEqual(sorted(r.volume for r in again.regions), [1, 2])
        self.assertEqual(len(again.faces.active), 11)
        for extension in ("vtu", "msh", "glb", "3mf"):
            L_SHAPE.evaluate().write(self.folder / f"l.{extension}")
            self.assertEqual((cnrg.load(self.folder / f"l.{extension}") & UNIT).evaluate().volume, 1)

    def test_other_files_are_told_with_a_remedy(self):
        for name, remedy in (("a.med", "write a result as .json"), ("a.inp", "as .stl"), ("a.ifc", "IfcConvert"),
                             ("a.dxf", "export it as .step"), ("a.GLTF", "as .stl")):
            (self.folder / name).write_text("x")
            for command in (("eval",), ("check",), ("mesh", "-o", "m.msh"), ("view",)):
                run = subprocess.run([sys.executable, "-m", "cnrg", command[0], str(self.folder / name), *command[1:]],
                                     capture_output=True, text=True)
                self.assertEqual(run.returncode, 2)
                self.assertRegex(run.stderr, f"{name}.*: error: a .* file is not read; .*{remedy}")
                self.assertEqual(run.stderr.count("\n"), 1)


class Pickled(unittest.TestCase):
    def test_a_result_comes_back(self):
        for text in (SLOPE, ROUND, MIXED, OPEN):
            result = result_of(text)
            again = pickle.loads(pickle.dumps(result))
            self.assertEqual(again.name, result.name)
            self.assertEqual(again.materials, result.materials)
            self.assertEqual(list(again.exact_points), list(result.exact_points))
            self.assertEqual([(c.name, c.material, c.volume) for c in again.components],
                             [(c.name, c.material, c.volume) for c in result.components])
            self.assertTrue(result.volume_bound <= again.volume_bound <= 1.01 * result.volume_bound)  # three digits
            self.assertTrue(again.compare(result).same)
            self.assertEqual(pickle.loads(pickle.dumps(again)).volume, result.volume)

    def test_it_has_no_tree(self):
        again = pickle.loads(pickle.dumps(UNIT.evaluate()))
        self.assertRaisesRegex(cnrg.InputError, "tree", again.explain, "f0")


class Notices(WithFolder):
    def program(self, *words):
        run = subprocess.run([sys.executable, "-m", "cnrg", "eval", *map(str, words)], capture_output=True, text=True, check=True)
        return run.stderr.replace(": notice: rounding", ": rounding").splitlines()

    def test_what_the_program_tells_is_warned_of(self):
        path, out = self.folder / "t.yaml", self.folder / "t.vtu"
        path.write_text("""cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1/3]}}
  b: {points: [[1, 2, 3]]}
  c: {mesh: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1/7]], faces: [[0, 1, 2]]}}
  d: {union: [a, {select: {of: c, dimension: 3}}]}
result: d
""")
        told = self.program(path, "-o", out)
        self.assertEqual(len(told), 4, told)
        with warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter("always")
            cnrg.read(path).evaluate().result.write(out)
        self.assertEqual([str(w.message) for w in warned], told)
        self.assertEqual({w.category for w in warned}, {cnrg.Notice})


@unittest.skipIf(shutil.which("snakemake") is None, "snakemake is not installed (Debian: snakemake)")
class ManyModels(WithFolder):
    def test_the_example_of_snakemake(self):
        folder = self.folder / "many"
        shutil.copytree(Path(os.environ["CNRG_SOURCES"]) / "csg/examples/many", folder)
        path = f"{Path(os.environ['CNRG_PROGRAM']).parent}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run(["snakemake", "--cores", "2", "--config", "count=9"], cwd=folder, capture_output=True,
                              text=True, env={**os.environ, "PATH": path, "HOME": str(self.folder)})
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split(",") for line in (folder / "volumes.csv").read_text().splitlines()]
        self.assertEqual(len(rows), 9)
        for side, depth, volume in rows:
            self.assertEqual(Fraction(volume), 1000 - Fraction(side) ** 2 * Fraction(depth))
        self.assertEqual(len({volume for *_, volume in rows}), 9)


class Words(unittest.TestCase):
    RESULT = UNIT.evaluate()

    def test_words_of_others_are_told_with_a_remedy(self):
        r = self.RESULT
        for wrong, remedy in (
            (lambda: UNIT.fillet(0.1), "cnrg.load a CAD model"), (lambda: UNIT.minkowski_sum(UNIT), "cnrg.minkowski"),
            (lambda: UNIT.bounds, r"node.evaluate\(\).bounds"), (lambda: UNIT.tranlate, "'translate'"),
            (lambda: r.show(), "result.view"), (lambda: r.save("x"), r"result.write\(path\)"), (lambda: r.genus, "betti"),
            (lambda: r.translate([1, 0, 0]), "result.node.translate"), (lambda: r.volum, "'volume'"),
            (lambda: r.zzz, "help"), (lambda: cnrg.from_trimesh, "cnrg.mesh"), (lambda: cnrg.cube, "cnrg.box"),
            (lambda: cnrg.spere, "'sphere'"), (lambda: r.tetrahedralize().to_gmsh(), "model.msh"),
        ):
            self.assertRaisesRegex(AttributeError, remedy, wrong)
        for wrong, remedy in ((lambda: UNIT.rotate([0, 0, 45]), "an axis and degrees"), (lambda: len(r), "result.points"),
                              (lambda: cnrg.hull(UNIT, FAR), "exact_points")):
            self.assertRaisesRegex(TypeError, remedy, wrong)
        self.assertTrue(r)
        self.assertTrue(hasattr(r, "volume") and not hasattr(r, "__array__"))

    def test_the_remedies_hold(self):
        self.assertEqual(cnrg.hull([*UNIT.evaluate().exact_points, *FAR.evaluate().exact_points]).evaluate().volume, 3)
        ring = cnrg.box(size=3) - cnrg.box([1, 1, -1], [2, 2, 4])
        self.assertEqual(ring.evaluate().topology().betti[1], 1)
        self.assertTrue(ring.evaluate().topology().manifold)

    def test_pyvista(self):
        shown = []
        fake = types.SimpleNamespace(wrap=lambda grid: types.SimpleNamespace(plot=lambda **o: shown.append((grid, o))))
        try:
            import vtkmodules  # noqa: F401
        except ImportError:
            self.skipTest("vtk is not installed")
        before = sys.modules.get("pyvista")
        sys.modules["pyvista"] = fake
        try:
            self.RESULT.plot(opacity=0.5)
            self.RESULT.tetrahedralize().plot()
        finally:
            del sys.modules["pyvista"]
            if before is not None:
                sys.modules["pyvista"] = before
        self.assertEqual([(g.GetNumberOfPoints(), o) for g, o in shown], [(8, {"opacity": 0.5}), (8, {})])

    def test_pyvista_is_asked_for(self):
        before = sys.modules.get("pyvista")
        sys.modules["pyvista"] = None
        try:
            self.assertRaisesRegex(ImportError, "pip install pyvista", self.RESULT.plot)
        finally:
            del sys.modules["pyvista"]
            if before is not None:
                sys.modules["pyvista"] = before

    def test_a_map_is_a_tree(self):
        tree = cnrg.read({"cnrg": 1, "nodes": {"a": {"box": {"min": [0, 0, 0], "max": [1, 1, "1/3"]}}}, "result": "a"})
        self.assertEqual(tree.evaluate().result.volume, Fraction(1, 3))

    def test_names_that_nobody_has_are_faults_where_they_are_written(self):
        ground = cnrg.box([0, 0, 0], [1, 1, 1], material="rock").named("ground")
        for make, words in ((lambda: ground.select(region="grond"), "'grond'; did you mean 'ground'"),
                            (lambda: ground.select(region=["ground", "zz"]), "'zz'"),
                            (lambda: ground.select(region="1"), "'1'; a number is no text"),
                            (lambda: ground.select(material="rokc"), "'rokc'; did you mean 'rock'")):
            node = make()
            with self.assertRaisesRegex(cnrg.InputError, words) as raised:
                node.boundary().evaluate()
            self.assertEqual((raised.exception.file, raised.exception.line), (__file__, make.__code__.co_firstlineno))
        for name in ("ground", 1):
            self.assertEqual(ground.select(region=name).evaluate().volume, 1)
        self.assertEqual(UNIT.select(region="box").evaluate().volume, 1)
        self.assertEqual((UNIT.with_(name="x") | FAR).select(region=["x", "box2"]).evaluate().volume, 2)
        self.assertEqual(ground.evaluate().node.select(region="ground").evaluate().volume, 1)
        mixed = cnrg.union(ground, cnrg.box(size=[2, 1, 1], material="clay").named("b"), blend="linear")
        self.assertEqual(mixed.select(region="b & ground").evaluate().volume + mixed.select(region="ground & b").evaluate().volume, 1)

    def test_the_program_as_a_module(self):
        run = subprocess.run([sys.executable, "-m", "cnrg", "--version"], capture_output=True, text=True)
        self.assertIn(cnrg.__version__, run.stdout)
        self.assertEqual(subprocess.run([sys.executable, "-m", "cnrg", "eval"], capture_output=True).returncode, 2)


if __name__ == "__main__":
    unittest.main()
