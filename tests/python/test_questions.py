"""Questions to results: the answers of the program, as text and as data, all of which is as its schema says."""
import json
import os
import subprocess
import sys
import tempfile
import threading
import unittest
import unittest.mock
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import jsonschema
import numpy

import cnrg
from test_results import HALF, MIXED, OPEN, PROGRAM, ROUND, SLOPE, TREES, result_of

ANSWERS = jsonschema.Draft7Validator(
    json.loads((Path(os.environ["CNRG_SOURCES"]) / "csg" / "explain" / "answers.schema.json").read_text()))
SEEN = {"lives": 0, "betti": 0, "only_a": 0}


def checked(text):
    """What `cnrg.stories` reads, checked."""
    data = json.loads(text)
    ANSWERS.validate(data)
    for key in SEEN.keys() & data.keys():
        SEEN[key] += 1
    return data


def setUpModule():
    replaced = unittest.mock.patch.object(cnrg.stories, "json", SimpleNamespace(loads=checked))
    unittest.addModuleCleanup(replaced.stop)
    unittest.addModuleCleanup(lambda: unittest.TestCase().assertTrue(all(SEEN.values()), SEEN))
    replaced.start()


class WithProgram(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def tree(self, text, name="tree.yaml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def program(self, *arguments, status=0, **options):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=100, **options)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout


def some_points(result, count=200):
    """Points in, on and off cells: corners, middles of edges and triangles, and others in a box around."""
    exact = result.exact_points
    points = [exact[i] for i in range(min(len(exact), count)) if i not in set(result.frame_points.tolist())]
    for list_ in (result.edges.points, result.faces.triangles.values):
        for cell in list(list_)[:count]:
            corners = [exact[int(p)] for p in cell]
            points.append(tuple(sum(c[k] for c in corners) / len(corners) for k in range(3)))
    numbers = numpy.random.default_rng(7)
    low, high = result.points.min(axis=0), result.points.max(axis=0)
    points += [tuple(Fraction(float(x)) for x in p) for p in numbers.uniform(low - 1, high + 1, (count, 3))]
    return points


class Locate(WithProgram):
    def answers(self, text, points):
        """Dimension, cell and component as the program has them."""
        lines = "".join(f"{x} {y} {z}\n" for x, y, z in points)
        out = self.program("locate", self.tree(text), input=lines).splitlines()
        return [(int(d), cell, int(component)) for d, cell, component in (line.split()[:3] for line in out)]

    def assert_as_program(self, text, points, given):
        found = result_of(text).locate(given)
        self.assertEqual(list(zip(found.dimension.tolist(), found.names, found.component.tolist())), self.answers(text, points))

    def test_exact_points_as_the_program(self):
        for name, text in TREES.items():
            with self.subTest(name):
                points = some_points(result_of(text))
                self.assert_as_program(text, points, points)

    def test_arrays_of_doubles_are_those_doubles_exactly(self):
        points = numpy.random.default_rng(3).uniform(-10, 110, (3000, 3))
        points[::7] = numpy.round(points[::7])
        self.assert_as_program(SLOPE, [[Fraction(float(x)) for x in p] for p in points], points)
        self.assert_as_program(SLOPE, [[Fraction(float(x)) for x in p] for p in points[:50, ::-1]], points[:50, ::-1])
        small = points.astype(numpy.float32)
        self.assert_as_program(SLOPE, [[Fraction(float(x)) for x in p] for p in small], small)

    def test_beyond_the_frame(self):
        near = some_points(result_of(HALF), 20)
        far = [tuple(x * scale for x in p) for scale in (10**3, 10**9, 10**200, Fraction(2) ** 990) for p in near[-8:]]
        far += [(0, 0, 10**9), (10**9, -(10**9), 10**9), (3 * 10**9, 7, -(10**9)), (-(3 * 10**9), 3 * 10**9, 10**9)]
        result = result_of(HALF)
        alone = result.locate(near)
        self.assert_as_program(HALF, near + far, near + far)
        # Cells are those of the result itself, whatever else is asked with them.
        together = result.locate(near + far)
        self.assertEqual(together.cell[: len(near)].tolist(), alone.cell.tolist())
        for dimension, cell, component in zip(*together):
            kind = (result.vertices, result.edges, result.faces, result.regions)[dimension]
            self.assertEqual(component, 0 if cell < 0 else kind.component[cell])
        with self.assertRaisesRegex(cnrg.InputError, "2\\^1000"):
            result.locate([[0, 0, Fraction(2) ** 1001]])

    def test_forms_of_points(self):
        result = result_of(SLOPE)
        expected = ["f9", "e15"]
        forms = [
            [[66, 50, 30], [60, 50, 40]],
            [(66.0, 50.0, 30.0), (60.0, 50.0, 40.0)],
            [["66", "100/2", "3e1"], [Fraction(60), Decimal("50.0"), 40]],
            [numpy.array([66, 50, 30]), numpy.float32([60, 50, 40])],
            numpy.array([[66, 50, 30], [60, 50, 40]]),
            numpy.array([[66, 50, 30], [60, 50, 40]], dtype=numpy.uint8),
            numpy.array([[66, 50, 30], [60, 50, 40]], dtype=numpy.longdouble),
            numpy.array([[Fraction(66), 50, 30], [60, "50", 40.0]], dtype=object),
            numpy.asfortranarray(numpy.array([[66.0, 50, 30], [60, 50, 40]])),
            ((x, 50, z) for x, z in ((66, 30), (60, 40))),
        ]
        for form in forms:
            self.assertEqual(result.locate(form).names, expected, form)
        self.assertEqual(result.locate([66, 50, 30]).names, ["f9"])
        self.assertEqual(result.locate(["66", 50, 30.0]).names, ["f9"])
        self.assertEqual(result.locate(numpy.zeros((0, 3))).names, [])
        self.assertEqual(result.locate([]).names, [])
        # 1/3 is no double: the nearest one is beside the plane x = 1/3.
        box = cnrg.box([0, 0, 0], ["1/3", 1, 1]).evaluate()
        self.assertEqual(box.locate([["1/3", "1/2", "1/2"], [1 / 3, 0.5, 0.5]]).dimension.tolist(), [2, 3])
        big = 2**60 + 1
        box = cnrg.box([0, 0, 0], [big, 1, 1]).evaluate()
        self.assertEqual(box.locate([[big, "1/2", "1/2"]]).dimension.tolist(), [2])
        self.assertEqual(box.locate(numpy.array([[big, 1, 1]])).dimension.tolist(), [0])

    def test_what_is_no_point(self):
        result = result_of(SLOPE)
        for wrong in ([[1, 2, float("nan")]], numpy.array([[1, numpy.inf, 2]])):
            with self.assertRaises(cnrg.InputError):
                result.locate(wrong)
        for wrong in (numpy.zeros((2, 2)), numpy.zeros((1, 2, 3))):
            with self.assertRaises(ValueError):
                result.locate(wrong)
        for wrong in (3, "1 2 3", None, [[1, 2]], [1, 2], [[1, 2, "x"]], [[True, 1, 2]], [[1, 2, 3j]]):
            with self.assertRaises((TypeError, cnrg.InputError)):
                result.locate(wrong)

    def test_others_run_meanwhile(self):
        result = cnrg.sphere([0, 0, 0], 1, segments=64).evaluate()
        points = numpy.random.default_rng(1).uniform(-1, 1, (100_000, 3))
        turns, ended = 0, threading.Event()

        def locate():
            result.locate(points)
            ended.set()

        worker = threading.Thread(target=locate)
        worker.start()
        while not ended.wait(0.001):
            turns += 1
        worker.join()
        self.assertGreater(turns, 3)


class Explain(WithProgram):
    def test_texts_of_cells_are_those_of_the_program(self):
        for name, text in TREES.items():
            with self.subTest(name):
                path = self.tree(text)
                result = cnrg.read(path).evaluate().result
                names = [f"{letter}{i}" for letter, cells in zip("vefr", (result.vertices, result.edges, result.faces, result.regions))
                         for i in range(0, len(cells), 5)]
                for cell in names:
                    self.assertEqual(str(result.explain(cell)), self.program("explain", path, "--cell", cell))

    def test_texts_of_points_are_those_of_the_program(self):
        for text in (SLOPE, HALF):
            path = self.tree(text)
            result = cnrg.read(path).evaluate().result
            for point in ((60, 50, 33), (Fraction(1, 3), 1, 1), (0, 0, 10**6)):
                told = self.program("explain", path, "--point", ",".join(str(x) for x in point))
                self.assertEqual(str(result.explain(point)), told)

    def test_facts_of_an_explanation(self):
        result = result_of(SLOPE)
        why = result.explain([60, 50, 33])
        self.assertEqual(why.cell, "r1")
        self.assertEqual(why.data["point"], (60, 50, 33))
        last = why.steps[-1]
        self.assertEqual((last.node, last.operator, last.component, last.removed), ("model", "difference", 0, True))
        self.assertEqual(last.rows, ("difference.edge.AinB",))
        self.assertEqual([step.node for step in why.steps][-3:], ["split", "tunnel", "model"])
        face = result.explain("f9")
        self.assertEqual(face.data["lives"][0]["patches"][0]["leaf"], "tunnel")
        self.assertEqual(face.data["lives"][0]["normal"].__class__, tuple)
        stars = result_of(OPEN).explain("f0").lives
        self.assertTrue(any("stars" in step.data for life in stars for step in life))

    def test_names_that_are_no_cells(self):
        result = result_of(SLOPE)
        for wrong, said in (("f99", "f0 to f11"), ("x1", "names no cell"), ("", "names no cell")):
            with self.assertRaisesRegex(cnrg.InputError, said):
                result.explain(wrong)

    def test_nodes_of_a_script_have_the_lines_of_their_calls(self):
        at = sys._getframe().f_lineno + 1
        a = cnrg.box([0, 0, 0], [2, 2, 2])
        b = cnrg.box([1, 1, 1], [3, 3, 3])
        told = (a - b).evaluate().explain([1.5, 1.5, 1.5])
        self.assertEqual([step.data["line"] for step in told.steps], [at, at + 1, at + 2])
        self.assertRegex(str(told), rf"(?m)^box .* line {at}  .*\nbox2 .* line {at + 1}  .*\ndifference .* line {at + 2}  ")

    def test_cells_of_other_nodes_are_explained(self):
        path = self.tree(SLOPE)
        result = cnrg.read(path).evaluate("split")["split"]
        told = self.program("explain", path, "--node", "split", "--cell", "f5")
        self.assertEqual(str(result.explain("f5")), told)


class Topology(WithProgram):
    def test_topology_is_told_as_by_the_program(self):
        for name, text in TREES.items():
            with self.subTest(name):
                path = self.tree(text)
                out = self.program("eval", path, "--quiet", "--topology")
                told = out.split("\n", 1)[1] if out.startswith("topology") else out.lstrip("\n").split("\n", 1)[1]
                self.assertEqual(str(cnrg.read(path).evaluate().result.topology()), told)

    def test_facts_of_topology(self):
        t = result_of(SLOPE).topology()
        self.assertEqual(t.betti, (1, 1, 0))
        self.assertEqual(t.betti_of(3, "q"), (1, 2, 2))
        e = t.euler
        self.assertEqual((e["v"], e["e"], e["eh"], e["f"], e["r"]), (14, 23, 2, 12, 4))
        self.assertEqual(e["v"] - (e["e"] - e["eh"]) + (e["f"] - e["r"] + e["fc"]) - (e["V"] - e["Vh"] + e["Vc"]),
                         e["C"] - e["Ch"] + e["Cc"])
        self.assertTrue(t.manifold)
        self.assertEqual(t.adjacent, [(0, 1, 5), (0, 2, 6), (1, 2, 1)])
        mixed = result_of(MIXED).topology()
        self.assertFalse(mixed.manifold)
        self.assertTrue(any(cells for cells in (entry["cells"] for entry in mixed.data["reasons"])))
        self.assertIsNone(result_of(HALF).topology().euler)
        self.assertFalse(result_of(OPEN).topology().data["closed"])
        nothing = (cnrg.box([0, 0, 0], [1, 1, 1]) - cnrg.box([-1, -1, -1], [2, 2, 2])).evaluate().topology()
        self.assertTrue(nothing.data["empty"])
        self.assertEqual(nothing.betti, (0, 0, 0))


class Compare(WithProgram):
    def test_comparisons_are_told_as_by_the_program(self):
        bolt = SLOPE.replace("[60, 50, 30], [60, 50,", "[61, 50, 30], [61, 50,")
        named = SLOPE.replace("ground", "soil")
        for text in (bolt, named, ROUND, SLOPE.replace("#998877", "#000000")):
            a, b = self.tree(SLOPE, "a.yaml"), self.tree(text, "b.yaml")
            found = result_of(SLOPE).compare(result_of(text))
            told = self.program("compare", a, b, status=0 if found.same else 4)
            self.assertEqual(told.split("\n", 3)[3], str(found) if not found.same else "")
            self.assertEqual(told.split("\n")[2], "the same" if found.same else "different")

    def test_facts_of_a_comparison(self):
        small = cnrg.box([0, 0, 0], [1, 1, 1], name="a")
        large = cnrg.box([0, 0, 0], [1, 1, 2], name="b")
        found = small.evaluate().compare(large.evaluate())
        self.assertFalse(found)
        self.assertEqual([piece["volume"] for piece in found.data["only_b"]], [Fraction(1)])
        self.assertEqual(found.data["only_a"], [])
        self.assertEqual(found.data["only_b"][0]["dimension"], 3)
        self.assertEqual([a["what"] for a in found.data["attributes"]], ["name"])
        same = small.evaluate().compare(cnrg.box([0, 0, 0], [1, 1, "1/2"], name="b").scale([1, 1, 2]).evaluate(), ignore="names")
        self.assertTrue(same)
        self.assertEqual(str(same), "the same\n")
        with self.assertRaises(cnrg.InputError):
            small.evaluate().compare(large.evaluate(), ignore="colours")
        with self.assertRaises(TypeError):
            small.evaluate().compare(large)


if __name__ == "__main__":
    unittest.main()
