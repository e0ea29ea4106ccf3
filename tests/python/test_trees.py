"""Expressions and tree files: both ways, with the same bytes as the program."""
import copy
import multiprocessing
import os
import pickle
import subprocess
import sys
import tempfile
import unittest
import warnings
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy

import cnrg

SOURCES = Path(os.environ["CNRG_SOURCES"])
PROGRAM = os.environ["CNRG_PROGRAM"]
sys.path.append(str(SOURCES / "bench" / "same"))


def line():
    """The line of the caller."""
    return sys._getframe(1).f_lineno


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def program(self, *arguments, **options):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=100, **options)

    def exact(self, text_or_path, *more):
        """The bytes of the program's exact file for a tree, or None and its first error."""
        path = text_or_path
        if isinstance(path, str):
            path = self.folder / "text.yaml"
            path.write_text(text_or_path)
        out = self.folder / "program.json"
        done = self.program("eval", path, "--quiet", "-o", out, *more)
        return out.read_bytes() if done.returncode == 0 else None

    def exact_here(self, result):
        out = self.folder / "module.json"
        result.write(out)
        return out.read_bytes()


def slope():
    rock = cnrg.material("rock", color="#998877")
    ground = cnrg.box([0, 0, 0], [100, 100, 60], material=rock).named("ground")
    fault = cnrg.polygon([[20, -5, -5], [70, -5, 65], [70, 105, 65], [20, 105, -5]]).named("fault")
    bolt = cnrg.polyline([[60, 50, 30], [60, 50, "145/3"]]).named("bolt")
    tunnel = cnrg.cylinder([60, -5, 30], [60, 105, 30], 6, segments=48).named("tunnel")
    split = cnrg.union(bolt, (fault & ground).named("inside"), ground, dominance="left").named("split")
    return (split - tunnel).named("model")


class Expressions(Folder):
    def test_the_text_of_an_expression_means_the_same_to_the_program(self):
        model = slope()
        self.assertEqual(self.exact_here(model.evaluate()), self.exact(model.to_yaml()))
        ev = cnrg.evaluate(model)
        self.assertEqual([row.name for row in ev], ["bolt", "fault", "ground", "inside", "split", "tunnel", "model"])
        self.assertEqual(ev.rows[-1].cells, (14, 23, 12, 2))
        self.assertEqual(ev.rows[-1].volume, Fraction(182200800143074347420665943296475, 309485009821345068724781056))

    def test_other_nodes_are_kept_by_name_or_as_nodes(self):
        model = slope()
        split = model.operands[0]
        ev = cnrg.evaluate(model, split, "tunnel")
        self.assertEqual(ev["split"].name, "split")
        self.assertIs(ev[split], ev["split"])
        self.assertEqual(ev["tunnel"].name, "tunnel")
        self.assertEqual(ev.result.name, "model")
        with self.assertRaisesRegex(KeyError, "not kept"):
            ev["bolt"]
        with self.assertRaisesRegex(KeyError, "no node called 'tunel'"):
            cnrg.evaluate(model, "tunel")

    def test_numbers_of_all_kinds_are_exact(self):
        for number, volume in [
            (2, 2), (0.1, Fraction(0.1)), ("0.1", Fraction(1, 10)), ("1/3", Fraction(1, 3)),
            (Fraction(2, 7), Fraction(2, 7)), (Decimal("0.1"), Fraction(1, 10)), (10**40, 10**40),
            (numpy.float32(0.1), Fraction(float(numpy.float32(0.1)))), (numpy.int8(3), 3), (numpy.uint64(2**63), 2**63),
            (numpy.longdouble(1) / 3, Fraction(*(numpy.longdouble(1) / 3).as_integer_ratio())),
            (5e-324, Fraction(5e-324)), (1.5e300, Fraction(1.5e300)), (numpy.array(0.25), Fraction(1, 4)),
        ]:
            with self.subTest(number=number, kind=type(number)):
                box = cnrg.box([0, 0, 0], [1, 1, number])
                self.assertEqual(cnrg.evaluate(box).rows[0].volume, volume)
        corner = numpy.array([1, 2, 3])
        for dtype in "int8", "uint16", "int64", "float16", "float32", "float64", ">f8", "longdouble":
            self.assertEqual(cnrg.evaluate(cnrg.box((0, 0, 0), corner.astype(dtype))).rows[0].volume, 6)

    def test_what_is_no_number_is_refused_at_once(self):
        for bad in float("nan"), float("inf"), numpy.float32("inf"), Decimal("NaN"), "one", "1/0", "", "1e999999999":
            with self.subTest(bad=bad), self.assertRaises(cnrg.InputError):
                cnrg.box([0, 0, 0], [1, 1, bad])
        for bad in None, True, object(), [1], {}, 1j, b"1":
            with self.subTest(bad=bad), self.assertRaises((TypeError, cnrg.InputError)):
                cnrg.sphere([0, 0, 0], bad)

    def test_transforms_act_in_their_order_and_repeat(self):
        box = cnrg.box([0, 0, 0], [1, 1, 1])
        moved = box.translate([1, 0, 0]).rotate([0, 0, 1], 90).translate([0, 0, 5]).scale(2)
        same = cnrg.box([-2, 2, 10], [0, 4, 12])
        self.assertEqual(cnrg.evaluate(cnrg.subtract(moved, same)).rows[-1].cells, (0, 0, 0, 0))
        self.assertEqual(cnrg.evaluate(cnrg.subtract(same, moved)).rows[-1].cells, (0, 0, 0, 0))
        mirrored = box.mirror([1, 0, 0], point=[2, 0, 0])
        self.assertEqual(cnrg.evaluate(cnrg.subtract(mirrored, cnrg.box([3, 0, 0], [4, 1, 1]))).rows[-1].volume, 0)

    def test_a_named_node_stays_one_node_when_it_is_moved(self):
        bolt = cnrg.polyline([[0, 0, 0], [0, 0, 1]]).named("bolt")
        bolts = cnrg.union(*(bolt.translate([i, 0, 0]) for i in range(5)))
        names = [row.name for row in cnrg.evaluate(bolts)]
        self.assertEqual(names[:2], ["bolt#1", "simplify"])
        self.assertIn("bolt#5", names)

    def test_chains_become_one_node_with_the_same_result(self):
        boxes = [cnrg.box([i, i % 3, 0], [i + 2, i % 3 + 2, 2], dominance=i % 2) for i in range(12)]
        one = boxes[0]
        for box in boxes[1:]:
            one = one | box
        self.assertEqual(len(one.operands), 12)
        nested = boxes[0]
        for i, box in enumerate(boxes[1:]):
            nested = cnrg.union(nested, box).named(f"u{i}")
        a, b = self.exact_here(one.named("u10").evaluate()), self.exact_here(nested.evaluate())
        self.assertEqual(a, b)

    def test_ten_thousand_nodes_in_a_chain(self):
        node = cnrg.box([0, 0, 0], [1, 1, 1])
        for i in range(10_000):
            node = cnrg.Node("simplify", (node,), site=("test", i))
        self.assertEqual(cnrg.evaluate(node, rows=False).result.name, "simplify10000")

    def test_operators_of_both_families(self):
        a, b = cnrg.box([0, 0, 0], [2, 2, 2]), cnrg.box([1, 1, 1], [3, 3, 3])

        def volume(node):
            return cnrg.evaluate(node).rows[-1].volume

        self.assertEqual([volume(n) for n in (a | b, a & b, a - b)], [15, 1, 7])
        self.assertEqual([volume(n) for n in (cnrg.sum(a, b), cnrg.product(a, b), cnrg.subtract(a, b))], [15, 1, 7])
        self.assertIsNone(volume(~a))
        self.assertEqual(volume(~~a), 8)
        self.assertEqual(cnrg.evaluate(a.boundary()).rows[-1].cells, (8, 12, 6, 0))
        self.assertEqual(cnrg.evaluate(a.interior()).rows[-1].cells, (0, 0, 0, 1))
        self.assertEqual(cnrg.evaluate(a.interior().closure()).rows[-1].cells, (8, 12, 6, 1))
        self.assertEqual(volume(cnrg.aggregate(a, cnrg.box([5, 5, 5], [6, 6, 6])).unify()), 9)
        self.assertEqual(volume((a | b).regularize()), 15)
        self.assertEqual(cnrg.evaluate((a | b).simplify("points")).rows[-1].cells, (20, 30, 12, 1))
        with self.assertRaises(TypeError):
            a | 3

    def test_near_features_are_joined_inside_of_a_tree(self):
        low, high = cnrg.box([0, 0, 0], [2, 2, 1]), cnrg.box([0, 0, "1.0001"], [2, 2, 2])
        joined = (low | high).simplify(within="1/1000")
        drilled = joined - cnrg.box([0, 0, 0], [1, 1, 2])
        evaluation = cnrg.evaluate(drilled)
        self.assertEqual([row.volume for row in evaluation.rows][-1], 6)
        self.assertTrue(any("joined 4 pairs nearer than 0.001" in n.message for n in evaluation.notices))
        text = joined.to_yaml()
        self.assertIn("within: 1/1000", text)
        both = (low | high).simplify("points", within=0.001)
        self.assertEqual(cnrg.evaluate(both).rows[-1].volume, 8)
        with self.assertRaises(cnrg.InputError):
            cnrg.evaluate((low | high).simplify(within=0))

    def test_graded_materials(self):
        skin = cnrg.box([0, 0, 0], [4, 4, 4]).named("skin")
        coating = cnrg.material("coating", distance={"to": skin, "stops": [[0, "ceramic"], ["1/2", "steel"]]})
        graded = cnrg.material(
            "graded", linear={"from": [0, 0, 0], "to": [0, 0, 4], "stops": [[0, "steel"], [1, {"steel": "1/4", "ceramic": "3/4"}]]}
        )
        model = cnrg.box([1, 1, 1], [2, 2, 2], material=coating) | cnrg.box([2, 1, 1], [3, 2, 2], material=graded)
        self.assertEqual(self.exact_here(model.evaluate()), self.exact(model.to_yaml()))
        with self.assertRaisesRegex(cnrg.InputError, "add up to 1/2"):
            cnrg.material("x", linear={"from": [0, 0, 0], "to": [0, 0, 1], "stops": [[0, "a"], [1, {"a": "1/2"}]]})
        with self.assertRaisesRegex(cnrg.InputError, "two materials of this tree are called 'rock'"):
            a = cnrg.box([0, 0, 0], [1, 1, 1], material=cnrg.material("rock", "#112233"))
            (a | cnrg.box([2, 2, 2], [3, 3, 3], material=cnrg.material("rock", "#445566"))).evaluate()

    def test_materials_of_materials(self):
        skin = cnrg.box([0, 0, 0], [4, 4, 4])
        inner = cnrg.material("inner", distance={"to": skin, "stops": [[0, "ceramic"], [1, cnrg.material("steel", "#112233")]]})
        outer = cnrg.material(
            "outer", linear={"from": [0, 0, 0], "to": [0, 0, 4], "stops": [[0, inner], [1, {inner: "1/4", "tin": "3/4"}]]}
        )
        a = cnrg.box([0, 0, 0], [4, 4, 4], material=outer)
        b = cnrg.box([2, 1, 1], [8, 7, 6], material=cnrg.material("hard", dominance="5/2"))
        for model in a | b, a & b, cnrg.union(a, b, blend="linear"):
            text = model.to_yaml()
            self.assertEqual(self.exact_here(model.evaluate()), self.exact(text))
            self.assertEqual(cnrg.parse(text).to_yaml(), text)
            self.assertEqual(pickle.loads(pickle.dumps(model)).to_yaml(), text)
            # A node of a tree that was read brings the materials of its materials along into another tree.
            taken = (cnrg.parse(text).result - cnrg.box([9, 9, 9], [10, 10, 10])).to_yaml()
            for part in "inner: {distance: {to:", 'steel: {color: "#112233"}':
                self.assertIn(part, taken)
        self.assertIn("dominance: 5/2", text)
        self.assertIn("#112233", text)
        self.assertEqual(cnrg.union(a, b, blend="linear").evaluate().components[1].material, "hard & outer")
        with self.assertRaisesRegex(cnrg.InputError, "`blend` is for union"):
            cnrg.intersection(a, b, blend="linear")
        with self.assertRaisesRegex(cnrg.InputError, "none of them dominates"):
            cnrg.union(a, b, blend="linear", dominance="left")

    def test_a_node_does_not_change(self):
        box = cnrg.box([0, 0, 0], [1, 1, 1])
        with self.assertRaises(AttributeError):
            box.key = "a"
        with self.assertRaises(AttributeError):
            del box.operator


    def test_nodes_go_to_other_processes(self):
        points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.5]])
        mesh = cnrg.mesh(points, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).translate([1, 2, 3])
        skin = cnrg.box([0, 0, 0], [4, 4, 4]).named("skin")
        crust = cnrg.material("crust", "#112233", distance={"to": skin, "stops": [[0, "a"], [1, "b"]]})
        for model in slope(), mesh, mesh | cnrg.box([0, 0, 0], [1, 1, 1], material=crust):
            again = pickle.loads(pickle.dumps(model))
            self.assertEqual(again.to_yaml(), model.to_yaml())
            self.assertEqual(copy.deepcopy(model).to_yaml(), model.to_yaml())
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual(pool.apply(_volume, (mesh,)), Fraction(1, 4))


def _volume(node):
    return node.evaluate().volume


class Places(Folder):
    def test_a_form_is_refused_where_it_is_written(self):
        with self.assertRaises(cnrg.InputError) as caught:
            at = line() + 1
            cnrg.box([0, 0], [1, 1, 1])
        self.assertEqual((caught.exception.file, caught.exception.line), (__file__, at))
        self.assertIn("`min` of box must be a list of three numbers", str(caught.exception))

    def test_numbers_and_arrays_are_refused_where_they_are_written(self):
        nan = float("nan")
        for bad in (
            lambda: cnrg.sphere([0, 0, 0], nan), lambda: cnrg.box([0, 0, 0], [1, 1, Decimal("NaN")]),
            lambda: cnrg.box([0, 0, 0], [1, 1, "one"]), lambda: cnrg.mesh([[0, 0, 0]], [[0, 1, 9]]),
            lambda: cnrg.material("a\ud800"), lambda: cnrg.box([0, 0, 0], [1, 1, 1]).simplify("all"),
            lambda: cnrg.box([0, 0, 0], [1, 1, 1], dominance="lft"),
        ):
            with self.assertRaises(cnrg.InputError) as caught:
                bad()
            self.assertEqual((caught.exception.file, caught.exception.line), (__file__, bad.__code__.co_firstlineno))

    def test_messages_have_no_control_characters(self):
        with self.assertRaises(cnrg.InputError) as caught:
            cnrg.parse('cnrg: 1\nnodes: {a: "\\\x04"}\nresult: a\n')
        self.assertTrue(str(caught.exception).isprintable(), str(caught.exception))

    def test_a_shape_is_refused_where_it_was_made(self):
        at = line() + 1
        flat = cnrg.box([0, 0, 0], [1, 1, 0])
        other = cnrg.box([0, 0, 0], [1, 1, 1])
        with self.assertRaises(cnrg.InputError) as caught:
            (other | flat).evaluate()
        self.assertEqual((caught.exception.file, caught.exception.line), (__file__, at))
        self.assertIn("min is not less than max in z", caught.exception.message)

    def test_an_operator_is_refused_where_it_was_made(self):
        a = cnrg.box([0, 0, 0], [2, 2, 2]).interior()
        at = line() + 1
        bad = a | cnrg.box([0, 0, 0], [1, 1, 1])
        with self.assertRaises(cnrg.InputError) as caught:
            bad.evaluate()
        self.assertEqual((caught.exception.file, caught.exception.line), (__file__, at))
        self.assertIn("closure", caught.exception.message)

    def test_certificates_of_curved_surfaces(self):
        balls = cnrg.sphere([0, 0, 0], 1) & cnrg.sphere([1.1994, 1.5992, 0], 1)
        for certify in (None, True):
            proven = cnrg.evaluate(balls, certify=certify)
            self.assertTrue(proven.certificate.certified)
            self.assertGreater(proven.certificate.crossing, 0)
            self.assertEqual(proven.rows[-1].cells, (0, 1, 2, 1))
        drawn = cnrg.evaluate(balls, certify=False)
        self.assertIsNone(drawn.certificate)
        self.assertEqual(drawn.rows[-1].cells, (0, 0, 0, 0))
        window = cnrg.cylinder([1, 0, -3], [1, 0, 3], 1) | cnrg.sphere([0, 0, 0], 2)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            touching = cnrg.evaluate(window)
        self.assertFalse(touching.certificate.certified)
        place = touching.certificate.places[0]
        self.assertEqual(place.why, "near")
        self.assertAlmostEqual(place.at[0], 2, delta=0.1)
        self.assertRegex(str(told[0].message), "near .*they touch, or are nearer to it than")

    def test_what_runs_along_a_cut_elsewhere_in_the_tree_does_not_count(self):
        nodes = """cnrg: 1
nodes:
  plane: {polygon: [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]}
  knife: {bezier: {patch: [[[1, 1, -1], [2, 3, -1], [3, 1, -1]], [[1, 1, 1], [2, 3, 1], [3, 1, 1]]], segments: 8}}
  filled: {sum: [{subtract: [plane, knife]}, plane]}
  half: {bezier: {curve: [[1, 1, 0], [3/2, 2, 0], [2, 2, 0]], segments: 4}}
  both: {sum: [filled, half]}
result: """
        for result in ("filled", "both"):
            rows = cnrg.parse(nodes + result).evaluate("filled", certify=False).rows
            self.assertEqual([row.cells for row in rows if row.name == "filled"], [(6, 5, 1, 0)])

    def test_arcs_of_one_circle_turn_to_one_surface_about_any_axis(self):
        weights = "weights: [1, 1, 2]"
        ball = f"[[0, -1], {{bezier: [[1, -1]], {weights}}}, [1, 0], {{bezier: [[1, 1]], {weights}}}, [0, 1]]"
        ring = (f"[[3, 0], {{bezier: [[3, 1]], {weights}}}, [2, 1], {{bezier: [[1, 1]], {weights}}}, [1, 0], "
                f"{{bezier: [[1, -1]], {weights}}}, [2, -1], {{bezier: [[3, -1]], {weights}}}]")
        for axis in ("[0, 0, 1]", "[1, 2, 2]", "[1, 1, 0]", "[1, 1, 1]", "[1, 2, 3]"):
            for profile in (ball, ring):
                with self.subTest(axis=axis, profile=profile):
                    tree = (f"cnrg: 1\nnodes:\n  a: {{revolve: {{profile: {profile}, axis: {axis}}}}}\n"
                            "  b: {simplify: {of: a, mode: points}}\nresult: b\n")
                    result = cnrg.parse(tree).evaluate(certify=True)
                    self.assertTrue(result.certificate.certified)
                    self.assertEqual(result.rows[-1].cells, (0, 0, 1, 1))

    def test_what_is_joined_in_a_cut_is_joined_beside_it(self):
        balls = """cnrg: 1
nodes:
  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}
  b: {sphere: {center: [199/150, 199/150, 199/300], radius: 1, segments: 8}}
  k: {box: {min: [1/4, 1/4, -1/4], max: [5/4, 5/4, 3/4]}}
  u: {union: [a, b]}
  s: {select: {of: u, region: 1}}
  r: {difference: [s, k]}
result: r
"""
        wall = """cnrg: 1
nodes:
  a: {sphere: {center: [0, 0, 0], radius: 1001/1000, segments: 10}}
  b: {box: {min: [-2, -2, -3/2], max: [2, 2, 3/2]}}
  c: {polygon: {outer: [[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]], holes: [[[-.7, -.7, 0], [.7, -.7, 0], [.7, .7, 0], [-.7, .7, 0]]]}}
  d: {union: [{union: [c, {closure: {boundary: a}}], dominance: left}, b], dominance: left}
  e: {polygon: [[1.5, -1, 0], [1.8, -1, 0], [1.8, 1, 0], [1.5, 1, 0]]}
  k: {box: {min: [-1.2, -1.2, -1.2], max: [1.2, 1.2, 1.2]}}
  r: {difference: [{difference: [d, e]}, k]}
result: r
"""
        for tree, cells in ((balls, (12, 18, 10, 2)), (wall, (24, 40, 21, 2))):
            result = cnrg.parse(tree).evaluate(certify=True)
            self.assertTrue(result.certificate.certified)
            self.assertEqual(result.rows[-1].cells, cells)

    def test_leaves_that_end_in_one_plane_meet_in_their_rims(self):
        ring = "torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1, segments: 16, rings: 8}"
        cut = "  cut: {halfspace: {point: [0, 0, 0], normal: [0, 1, 0]}}\n"
        bend = "{difference: [ring, cut]}"
        pairs = (
            (f"  ring: {{{ring}}}\n{cut}  more: {{cylinder: {{from: [3, 0, 0], to: [3, -4, 0], radius: WIDE, segments: 11}}}}\n",
             f"[{bend}, more]", (0, 3, 4, 1)),
            (f"  ring: {{{ring}}}\n{cut}  more: {{torus: {{center: [6, 0, 0], axis: [0, 0, 1], radius: 3, tube: WIDE, segments: 9, rings: 5}}}}\n",
             f"[{bend}, {{intersection: [more, cut]}}]", (0, 3, 4, 1)),
            ("  rod: {cylinder: {from: [0, 0, -2], to: [0, 0, 0], radius: 1, segments: 12}}\n"
             "  more: {cone: {from: [0, 0, 0], to: [0, 0, 3], radius: WIDE, segments: 17}}\n", "[rod, more]", (0, 2, 3, 1)),
            ("  rod: {cylinder: {from: [0, 0, -2], to: [0, 0, 0], radius: 3, segments: 12}}\n"
             "  cut: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\n"
             "  more: {sphere: {center: [0, 0, -4], radius: 5 * WIDE, segments: 17, rings: 9}}\n",
             "[rod, {difference: [more, cut]}]", (0, 2, 3, 1)),
        )
        for nodes, union, (v, e, f, c) in pairs:
            narrower = () if "sphere" in nodes else ("-1e-5", "-1e-9")  # a smaller ball crosses the rod near its rim
            for step in ("0", "1e-3", "1e-5", "1e-7", "1e-11", *narrower):
                for turn in ("", ", rotate: {axis: [1, 2, 2], degrees: 57}"):
                    with self.subTest(union=union, step=step, turn=turn):
                        wide = nodes.replace("5 * WIDE", f'"${{5 + {step}}}"').replace("WIDE", f'"${{1 + {step}}}"')
                        tree = cnrg.parse(f"cnrg: 1\nnodes:\n{wide}  r: {{union: {union}{turn}}}\nresult: r\n")
                        with warnings.catch_warnings():
                            warnings.simplefilter("ignore")
                            result = tree.evaluate(certify=True)
                        self.assertTrue(result.certificate.certified)
                        self.assertEqual(result.rows[-1].cells, (v, e, f, c) if step == "0" else (v, e + 1, f + 1, c))

    def test_chords_of_two_curves_on_one_line_by_chance_are_two_edges(self):
        tree = """cnrg: 1
nodes:
  wires: {bezier: {curves: [[[-2, 0, 0], [-1, 1, 0], [0, 0, 0]], [[0, 0, 0], [1, -1, 0], [2, 0, 0]]]}}
  wall: {extrude: {profile: [[-2, 0, 0], {bezier: [[-1, 1, 0]]}, [0, 0, 0], {bezier: [[1, -1, 0]]}, [2, 0, 0], [2, 3, 0], [-2, 3, 0]],
                   vector: [0, 0, 1]}}
  across: {plane: {point: [0, 0, 1/2], normal: [0, 0, 1]}}
  section: {intersection: [wall, across]}
  turned: {revolve: {profile: [[1, -2], {bezier: [[2, -1]]}, [1, 0], {bezier: [[0, 1]]}, [1, 2], [3, 2], [3, -2]]}}
  along: {plane: {point: [0, 0, 0], normal: [0, 1, 0]}}
  halves: {intersection: [turned, along]}
  line: {polyline: [[0, 0, 5], [1, 0, 5], [3, 0, 5]]}
result: RESULT
"""
        for name, cells in (("wires", (3, 2, 0, 0)), ("section", (5, 5, 1, 0)), ("halves", (10, 10, 2, 0)), ("line", (2, 1, 0, 0))):
            with self.subTest(name=name):
                result = cnrg.parse(tree.replace("RESULT", name)).evaluate(certify=True)
                self.assertTrue(result.certificate.certified)
                self.assertEqual(result.rows[-1].cells, cells)

    def test_an_edge_of_two_planes_is_one_whatever_touches_it(self):
        tree = cnrg.parse("""cnrg: 1
nodes:
  a: {box: {min: [-2, 0, 0], max: [2, 4, 1]}}
  c: {cylinder: {from: [2, 1, 2], to: [2, 3, 2], radius: 1, segments: 8}}
  d: {difference: [a, c]}
  p: {simplify: {of: d, mode: points}}
  s: {sum: [{product: [a, c]}, {subtract: [a, c]}]}
  q: {unify: s}
  r: {aggregate: [p, {simplify: q, translate: [10, 0, 0]}]}
result: r
""")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            rows = {row.name: row.cells for row in tree.evaluate().rows}
        self.assertEqual([rows[name] for name in "dpqr"], [(8, 12, 6, 1)] * 3 + [(16, 24, 12, 2)])

    def test_a_wire_is_asked_about_flat_patches_of_its_leaf(self):
        tree = cnrg.parse("""cnrg: 1
nodes:
  a: {bezier: {patch: [[[0, 0, 0], [2, 0, 0]], [[0, 2, 0], [2, 2, 0]]], curve: [[0, 1, 1], [1, 1, -1.000001], [2, 1, 1]], segments: 5}}
result: a
""")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertFalse(tree.evaluate(certify=True).certificate.certified)

    def test_what_facets_alone_tell_is_not_certified(self):
        two = "  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 3}}\n  b: {cylinder: {from: [0, 5, 0], to: [0, 5, 1], radius: 0.9, segments: 4}}\n"
        roof = "polygon: [[-10, -3, 3], [2, -3, 3], [2, 3, 3], [-10, 3, 3]]}, {polygon: [[-0.8, -3, 5], [2, -3, 3], [2, 3, 3], [-0.8, 3, 5]]"
        fold = "[[0, -1, -1], [0, -1, 0], [2, -1, 5], [0.1, -1, 10], [0.1, -1, 11]], [[0, 2, -1], [0, 2, 0], [2, 2, 5], [0.1, 2, 10], [0.1, 2, 11]]"
        for nodes, error in (
                (two + "  u: {union: [a, b]}\n  r: {select: {of: u, region: 1}}\n", "numbered by vertices of facets"),
                (two + "  u: {union: [a, b]}\n  r: {select: {of: {interior: u}, region: 1}}\n", "numbered by vertices of facets"),
                (f"  a: {{sphere: {{center: [0, 0, 0], radius: 1, segments: 4}}}}\n  u: {{union: [a, {{box: {{min: [-9, -1, 0], max: [-7, 1, 6]}}}}]}}\n"
                 f"  s: {{union: [{{{roof}}}]}}\n  r: {{below: s, within: u}}\n", "facets alone tell whether"),
                (f"  b: {{box: {{min: [-3, 0, 0], max: [3, 1, 10]}}}}\n  s: {{bezier: {{patch: [{fold}], segments: 2}}}}\n  r: {{below: s, within: b}}\n",
                 "is curved in `b`"),
                ("  r: {revolve: {profile: [[1, 0], {bezier: [[2, 2]]}, [3, 0], [3, 0.999], [1, 0.999]], segments: 3}}\n",
                 "the profile of revolve is not simple")):
            tree = cnrg.parse(f"cnrg: 1\nnodes:\n{nodes}result: r\n")
            tree.evaluate(certify=False)
            with self.assertRaisesRegex(cnrg.Error, error):
                tree.evaluate(certify=True)

    def test_what_lies_below_a_curved_surface_beside_it_is_not_certified(self):
        tree = cnrg.parse("""cnrg: 1
nodes:
  s: {bezier: {patches: [[[[-5, -5, 0], [5, -5, 0]], [[-5, 5, 0], [5, 5, 0]]],
                         [[[0, 0, 3], [1, 0, 7/2], [2, 0, 3]], [[0, 1, 3], [1, 3, 7/2], [2, 1, 3]]]], segments: 3}}
  b: {union: [{box: {min: [-4, -4, -2], max: [-2, -2, 2]}}, {box: {min: [0.98, 1.95, 1], max: [1.02, 1.975, 2]}}]}
  low: {below: s, within: b}
result: low
""")
        tree.evaluate(certify=False)
        with self.assertRaisesRegex(cnrg.Error, "facets alone tell"):
            tree.evaluate(certify=True)

    def test_a_ball_that_touches_a_hyperboloid_from_inside(self):
        tree = """cnrg: 1
nodes:
  a: {revolve: {curve: [[5/3, -4/3], {bezier: [[3/5, 0]], weights: [1, 1, 9/25]}, [5/3, 4/3]], segments: 8}}
  b: {sphere: {center: [1/2, 0, 0], radius: 1/2, segments: 8}}
  r: {sum: [a, b]}
result: r
"""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertFalse(cnrg.parse(tree).evaluate(certify=True).certificate.certified)

    def test_a_result_of_curved_leaves_is_not_certified_again(self):
        for leaf, certified in (("cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 8}", False),
                                ("box: {min: [0, 0, 0], max: [1, 1, 1]}", True)):
            with self.subTest(leaf=leaf), tempfile.TemporaryDirectory() as folder:
                cnrg.parse(f"cnrg: 1\nnodes:\n  a: {{{leaf}}}\nresult: a\n").evaluate().result.write(f"{folder}/a.json")
                tree = (f"cnrg: 1\nnodes:\n  a: {{cnrg: {folder}/a.json}}\n"
                        "  b: {box: {min: [0.9, 0.37, 1/2], max: [0.91, 0.38, 1]}}\n"
                        "  c: {difference: [b, a]}\nresult: c\n")
                self.assertEqual(cnrg.parse(tree).evaluate(certify=True).certificate.certified, certified)

    def test_what_facets_alone_tell_is_not_certified(self):
        row = "[[-8/9, 2, {0}], [28/27, -2/3, {0}], [-28/27, -2/3, {0}], [8/9, 2, {0}]]"  # crosses itself at 1/3 and 2/3
        for leaf in (
            f"bezier: {{patch: [{row.format(0)}, {row.format(1)}], segments: 3}}",
            "extrude: {curve: [[0, 0, 0], {bezier: [[5, 0, 0]]}, [1, 0, 0]], vector: [0, 0, 1], segments: 1}",  # up to 25/9
        ):
            tree = cnrg.parse(f"cnrg: 1\nnodes:\n  a: {{{leaf}}}\nresult: a\n")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                self.assertFalse(tree.evaluate(certify=True).certificate.certified)

    def test_warnings_and_notices_have_their_place(self):
        at = line() + 1
        a = cnrg.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        ev = cnrg.evaluate(a)
        self.assertEqual([(n.level, n.file, n.line) for n in ev.notices], [("notice", __file__, at)])
        near = cnrg.union(cnrg.box([0, 0, 0], [1, 1, 1]), cnrg.box([1 + 2**-24, 0, 0], [2, 1, 1]))
        self.assertEqual(len(cnrg.evaluate(near, near).notices), 1)
        a = cnrg.box([0, 0, 0], [1, 1, 1], material="rock")
        b = cnrg.box([0, 0, 0], [1, 1, 1], material="clay")
        with self.assertWarnsRegex(cnrg.Notice, "rock"):
            cnrg.union(a, b, dominance="equal").evaluate()

    def test_two_nodes_of_one_name(self):
        a, b = cnrg.box([0, 0, 0], [1, 1, 1]).named("a"), cnrg.box([0, 0, 0], [2, 1, 1]).named("a")
        with self.assertRaisesRegex(cnrg.InputError, "two nodes of this tree are called 'a'"):
            (a | b).evaluate()

    def test_files_that_are_not_there(self):
        with self.assertRaisesRegex(cnrg.FileError, "nowhere.off") as caught:
            at = line() + 1
            cnrg.load(self.folder / "nowhere.off").evaluate()
        self.assertEqual((caught.exception.file, caught.exception.line), (__file__, at))
        self.assertTrue(caught.exception.message.startswith("there is no file"))
        with self.assertRaises(cnrg.FileError):
            cnrg.read(self.folder / "nowhere.yaml")
        with self.assertRaises(cnrg.FileError):
            cnrg.box([0, 0, 0], [1, 1, 1]).evaluate().write(self.folder / "no" / "x.json")

    def test_faults_of_a_tree_file_have_line_and_column(self):
        path = self.folder / "t.yaml"
        path.write_text("cnrg: 1\nnodes:\n  a: {bax: {}}\nresult: a\n")
        with self.assertRaises(cnrg.InputError) as caught:
            cnrg.read(path)
        e = caught.exception
        self.assertEqual((e.file, e.line, e.column), (str(path), 3, 7))
        path.write_text("cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 0]}}\nresult: a\n")
        with self.assertRaises(cnrg.InputError) as caught:
            cnrg.read(path).evaluate()
        self.assertEqual((caught.exception.file, caught.exception.line), (str(path), 3))
        with self.assertRaises(cnrg.InputError) as caught:  # as an expression, likewise
            cnrg.read(path)["a"].evaluate()
        self.assertEqual((caught.exception.file, caught.exception.line), (str(path), 3))


class Files(Folder):
    def both_ways(self, path, name):
        """The program, the tree as read, its text, and its result as an expression agree; True if it evaluates."""
        wanted = self.exact(path)
        try:
            tree = cnrg.read(path)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                got = self.exact_here(tree.evaluate(rows=False).result)
        except cnrg.Error as e:
            self.assertIsNone(wanted, f"{name}: {e}")
            return False
        self.assertTrue(wanted == got, f"{name}: evaluated")
        text = tree.to_yaml(self.folder)
        self.assertTrue(self.exact(text) == wanted, f"{name}: its text\n{text}")
        again = cnrg.parse(text, str(self.folder / "text.yaml")).to_yaml(self.folder)
        self.assertEqual(again, text, name)
        return True

    def test_trees_of_the_pages_go_both_ways(self):
        good = 0
        for path in sorted((SOURCES / "papers").rglob("*.yaml")):
            if path.parent.name != "lessons":  # exercises have holes
                good += self.both_ways(path, path)
        self.assertGreater(good, 40)

    def test_random_trees_go_both_ways(self):
        import trees

        good = 0
        first, count = int(os.environ.get("CNRG_FIRST_SEED", 0)), int(os.environ.get("CNRG_SEEDS", 0)) or 60
        for number in range(first, first + count):
            tree = trees.random_tree(17, number) if hasattr(trees, "random_tree") else None
            if tree is None or tree.files or tree.before:
                continue
            path = self.folder / "random.yaml"
            path.write_text(tree.text)
            good += self.both_ways(path, f"random tree {number}")
        self.assertGreater(good, count // 4)

    def test_copies_are_nodes(self):
        text = ("cnrg: 1\nparameters: {n: 3}\nnodes:\n  peg: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
                "  pegs: {repeat: {of: {union: [{simplify: peg, translate: [\"${2 * i}\", 0, 0]}, {box: {min: "
                "[\"${2 * i}\", 0, 1], max: [\"${2 * i + 1}\", 1, 2]}}]}, count: \"${n}\", index: i}, x-a: b}\n"
                "result: pegs\n")
        for n in (1, 3):
            tree = cnrg.parse(text, parameters={"n": n})
            again = cnrg.Tree.of(tree.result)
            self.assertEqual([t.evaluate().rows[-1].volume for t in (tree, again)], [2 * n] * 2)

    def test_layers_are_those_of_a_file(self):
        text = ("cnrg: 1\nmaterials: {m: {}, n: {}}\nnodes:\n  ground: {box: {min: [0, 0, 0], max: [4, 4, 4]}}\n"
                "  high: {plane: {point: [0, 0, 9], normal: [0, 0, 1]}}\n"
                "  model: {layers: {within: ground, surfaces: [{polygon: [[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]]}, high, "
                "{polygon: [[-1, -1, 1], [5, -1, 3], [5, 5, 3], [-1, 5, 1]]}], names: [a, b, c, d], materials: [m, n, m, n]}}\n"
                "result: model\n")
        tree = cnrg.parse(text)
        again = cnrg.Tree.of(tree.result)
        floor = cnrg.polygon([[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]])
        top = cnrg.polygon([[-1, -1, 1], [5, -1, 3], [5, 5, 3], [-1, 5, 1]])
        m, n = cnrg.material("m"), cnrg.material("n")
        made = cnrg.layers(cnrg.box([0, 0, 0], [4, 4, 4]), [floor, cnrg.plane([0, 0, 9], [0, 0, 1]), top], names="abcd",
                           materials=[m, n, m, n])
        for result in (tree.evaluate().result, again.evaluate().result, made.evaluate()):
            self.assertEqual([(r.name, r.volume) for r in result.regions], [("a", 32), ("b", 32)])
        with self.assertRaisesRegex(cnrg.InputError, "2 names are needed, one more than surfaces, not 1"):
            cnrg.layers(cnrg.box([0, 0, 0], [4, 4, 4]), [floor], names=["a"])

    def test_all_faults_of_a_tree_are_in_one_error(self):
        with self.assertRaises(cnrg.InputError) as caught:
            cnrg.parse("cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, x], max: [1, 1, y]}}\nresult: b\n")
        error = caught.exception
        self.assertEqual([(e.line, e.column) for e in (error, *error.more)], [(3, 25), (3, 41), (4, 9)])
        self.assertEqual(len(str(error).splitlines()), 3)

    def test_parameters_of_a_file_are_numbers_of_the_nodes(self):
        text = ("cnrg: 1\nparameters: {R: 2, h: \"${R / 4}\"}\nnodes:\n"
                "  \"ball ${R}\": {sphere: {center: [0, 0, \"${h}\"], radius: \"${R}\"}}\nresult: ball ${R}\n")
        self.assertEqual(list(cnrg.parse(text)), ["ball 2"])
        tree = cnrg.parse(text, parameters={"R": Fraction(1, 2)})
        self.assertEqual(list(tree), ["ball 1/2"])
        again = cnrg.Tree.of(tree.result)  # written and read without parameters
        self.assertEqual(again.evaluate().rows[0].volume, tree.evaluate().rows[0].volume)
        with self.assertRaisesRegex(cnrg.InputError, "no such one; did you mean `R`"):
            cnrg.parse(text, parameters={"r": 1})

    def test_texts_of_a_script_are_no_expressions(self):
        named = cnrg.box((0, 0, 0), (1, 1, 1)).named("costs ${R}, $${R}")
        self.assertEqual(cnrg.Tree.of(named).evaluate().rows[0].name, "costs ${R}, $${R}")

    def test_inside_keeps_files_in_a_folder(self):
        (self.folder / "in").mkdir()
        (self.folder / "x.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        path = self.folder / "in" / "t.yaml"
        path.write_text("cnrg: 1\nnodes:\n  a: {mesh: {file: ../x.off}}\nresult: a\n")
        self.assertEqual(len(cnrg.read(path).evaluate().rows), 1)
        with self.assertRaisesRegex(cnrg.InputError, "no file inside of the folder"):
            cnrg.read(path, inside=self.folder / "in").evaluate()

    def test_meshes_stand_in_the_text(self):
        points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0.1]])
        faces = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
        node = cnrg.mesh(points, faces, fill="winding", material="rock")
        self.assertEqual(self.exact_here(node.evaluate()), self.exact(node.to_yaml()))
        self.assertEqual(cnrg.evaluate(node).rows[0].volume, Fraction(0.1) / 6)
        # Arrays of all types, by rows and columns, and polygons of different sizes.
        for dtype in numpy.int8, numpy.uint8, numpy.uint32, numpy.int64, numpy.uint64, ">i4":
            other = cnrg.mesh(numpy.asfortranarray(points), numpy.asfortranarray(faces.astype(dtype)), fill="winding", material="rock")
            self.assertEqual(other.to_yaml(), node.to_yaml())
        pyramid = cnrg.mesh(
            [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 3]], [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
        )
        self.assertEqual(cnrg.evaluate(pyramid).rows[0].volume, 1)
        points[:] = 7  # a node does not change
        self.assertEqual(cnrg.evaluate(node).rows[0].volume, Fraction(0.1) / 6)

    def test_meshes_that_are_none(self):
        p = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        for points, faces in [
            (p, [[0, 1, 3]]), (p, [[0, 1, -1]]), (p, [[0, 1]]), ([[0, 0, float("nan")]] * 3, [[0, 1, 2]]),
            ([[1, 2]], [[0, 0, 0]]), (p, [[0.0, 1.0, 2.0]]), (p, "abc"), ("abc", [[0, 1, 2]]), (p, [[0, 1, 2], [0]]),
            (p, numpy.array([[0, 1, 2**63]], numpy.uint64)), (numpy.array([[2**60 + 1] * 3] * 3), [[0, 1, 2]]),
        ]:
            with self.subTest(points=points, faces=faces), self.assertRaises((cnrg.InputError, TypeError, ValueError)):
                cnrg.mesh(points, faces)
        with self.assertRaisesRegex(cnrg.InputError, "no faces"):
            cnrg.mesh(p, numpy.zeros((0, 3), int)).evaluate()

    def test_sides(self):
        west = cnrg.polygon([[1, -1, -1], [1, 3, -1], [1, 3, 3], [1, -1, 3]]).named("west")
        east = cnrg.polygon([[4, -1, -1], [4, 3, -1], [4, 3, 3], [4, -1, 3]]).named("east")
        block = cnrg.box([0, 0, 0], [6, 2, 2]).named("block")
        ground = cnrg.union(west, east, block, dominance="left").named("ground")
        for volume, given in [(4, dict(behind=west)), (12, dict(front_of=west, behind=[east])), (8, dict(front_of=east))]:
            node = ground.select(dimension=3, **given)
            self.assertEqual(node.evaluate().volume, volume)
            again = cnrg.parse(node.to_yaml()).to_yaml()
            self.assertEqual(cnrg.parse(again).to_yaml(), again)
            self.assertEqual(self.exact(again), self.exact(node.to_yaml()))
            self.assertEqual(pickle.loads(pickle.dumps(node)).to_yaml(), node.to_yaml())
        with self.assertRaises(cnrg.InputError) as error:
            here = line(); ground.select(front_of=block).evaluate()
        self.assertEqual(error.exception.line, here)

    def test_select(self):
        low = cnrg.box([0, 0, 0], [4, 4, 2], material="rock").named("low")
        high = cnrg.box([0, 0, 2], [4, 4, 4], material="clay").named("high")
        bolt = cnrg.polyline([[1, 1, 1], [1, 1, 5]], material="steel", attributes={"diameter": 25}).named("bolt")
        model = cnrg.union(bolt, low, high, dominance="left").named("model")
        corner = cnrg.points([[0, 0, 0]])
        picked = {  # vertices, edges, faces, regions
            (4, 4, 1, 0): [
                dict(dimension=2, between=("rock", "clay")), dict(from_=high, source_face=5),
                dict(from_=[high], source_face=[5]),
            ],
            (12, 20, 10, 0): [dict(dimension=2, between=[("rock", None), ("high", None)])],
            (2, 1, 0, 0): [
                dict(attributes={"diameter": [24, 25]}), dict(attributes={"diameter": 25.0}), dict(from_=bolt),
                dict(material=cnrg.material("steel")), dict(dimension=1, material=["steel"], inside=[high]),
            ],
            (10, 13, 6, 1): [
                dict(region="low"), dict(region=1), dict(dimension=3, touching=corner), dict(name="low"),
                dict(region=["low"], inside=[low, high]),
            ],
            (0, 0, 0, 0): [dict(attributes={"diameter": "25"})],
        }
        for counts, criteria in picked.items():
            for given in criteria:
                with self.subTest(given=given), warnings.catch_warnings(record=True):
                    warnings.simplefilter("always")
                    node = model.select(**given)
                    result = node.evaluate()
                    found = tuple(len(getattr(result, kind)) for kind in ("vertices", "edges", "faces"))
                    self.assertEqual(found, counts[:3])
                    self.assertEqual(result.volume, 32 * counts[3])
                    text = node.to_yaml()
                    again = cnrg.parse(text).to_yaml()  # [5] and 5 are the same
                    self.assertEqual(cnrg.parse(again).to_yaml(), again)
                    self.assertEqual(self.exact(again), self.exact(text))
                    self.assertEqual(pickle.loads(pickle.dumps(node)).to_yaml(), text)
                    self.assertEqual(self.exact(text), self.exact_here(node.evaluate()))
        for given in [dict(dimension=4), dict(dimension=[]), dict(region=-1), dict(between=("rock",)),
                      dict(source_face=0), dict(from_=model, source_face=0), dict(material="gold"), dict(from_=corner)]:
            with self.subTest(given=given), self.assertRaises(cnrg.InputError) as error:
                here = line(); model.select(**given).evaluate()
            self.assertEqual(error.exception.line, here)
        for given in [dict(inside=3), dict(attributes=3)]:
            with self.subTest(given=given), self.assertRaises(TypeError):
                model.select(**given)
        for key in ("each", "regularize"):
            with self.assertRaisesRegex(TypeError, f"{key}: True or False is wanted, not 'no'"):
                model.with_(**{key: "no"})
        for key in ("from_", "inside", "touching", "behind"):
            with self.assertRaisesRegex(TypeError, f"{key}: a node is wanted, not its name 'low'; give the variable"):
                model.select(**{key: "low"})
        listed = {(s.key, s.value): s for s in model.evaluate().selectables()}
        self.assertEqual(listed["dimension", "3"][2:6], (2, 0, 0, 0))
        self.assertEqual(listed["between", "[high, low]"][2:6], (0, 1, 4, 5))
        self.assertEqual(listed["from", "low"].source_faces, [0, 1, 2, 3, 4, 5])

    def test_materials_picked_by(self):
        block = cnrg.box([0, 0, 0], [2, 2, 2], material="rock")
        with self.assertRaisesRegex(cnrg.InputError, "no node has the material 'rokc'; did you mean 'rock'?"):
            block.select(material="rokc").evaluate()
        with self.assertRaisesRegex(cnrg.InputError, r"no node has the material 'gold'; .* give cnrg.material\('gold'\)"):
            block.select(material="gold").evaluate()
        self.assertEqual(len(block.select(material=cnrg.material("gold")).evaluate().regions), 0)
        with tempfile.TemporaryDirectory() as folder:
            block.evaluate().write(f"{folder}/block.json")
            read = cnrg.load(f"{folder}/block.json").select(dimension=3, material=cnrg.material("rock"))
            self.assertEqual(read.evaluate().volume, 8)
            tree = cnrg.parse(read.to_yaml())
            self.assertEqual(tree.result.evaluate().volume, 8)  # a node of a tree that was read knows its materials
            self.assertEqual(pickle.loads(pickle.dumps(read)).evaluate().volume, 8)


if __name__ == "__main__":
    unittest.main()
