"""The benchmark for scripts: systems on own models, verdicts on own meshes, Mäntylä's Boolean; volumes are counted by
hand."""
import os
import unittest
from fractions import Fraction
from unittest import mock

import numpy

import cnrg
import cnrg.bench

try:
    cnrg.bench.program()
    MISSING = ""
except cnrg.FileError as error:
    MISSING = str(error)

A = cnrg.box([0, 0, 0], [2, 2, 2])
B = cnrg.box([1, 1, 1], [3, 3, 3])
VOLUMES = {"union": 15, "difference": 7, "intersection": 1}


def box(low, high):
    """Points and faces, outward."""
    points = numpy.array([[(high if i >> k & 1 else low)[k] for k in range(3)] for i in range(8)], dtype=float)
    return points, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


class Program(unittest.TestCase):
    def test_it_is_named_where_it_is_missing(self):
        with mock.patch.dict(os.environ, {"CNRG_BENCH_PROGRAM": "/no/such"}):
            with self.assertRaisesRegex(cnrg.FileError, "CNRG_BENCH_PROGRAM is /no/such, which is no program; give the path of bench_sweep"):
                cnrg.bench.systems()
        with mock.patch.dict(os.environ, {"PATH": ""}), mock.patch.object(cnrg.bench, "__file__", "/no/lib/cnrg/bench.py"):
            os.environ.pop("CNRG_BENCH_PROGRAM", None)
            with self.assertRaisesRegex(cnrg.FileError, "bench_sweep was not found; build it"):
                cnrg.bench.run("turned")


@unittest.skipIf(MISSING, MISSING)
class Bench(unittest.TestCase):
    def test_systems_say_what_they_are(self):
        systems = {system.name: system for system in cnrg.bench.systems()}
        self.assertEqual(next(iter(systems)), "ours")
        self.assertEqual((systems["nef"].rounding, systems["nef"].regularized), (0, False))
        self.assertEqual(systems["corefinement"].rounding, 2.0 ** -50)
        self.assertTrue(systems["nef"].version.startswith("CGAL"))

    def test_own_nodes_are_given_to_systems(self):
        for model, volume in ((A | B, 15), (A - B, 7), (A & B, 1)):
            rows = cnrg.bench.run(model, systems=["ours", "nef", "mantyla-exact"])
            self.assertEqual(list(rows["system"]), ["ours", "nef", "mantyla-exact"])
            self.assertEqual(set(rows["verdict"]), {"same"})
            self.assertEqual({row["facts"]["volume"] for row in rows}, {str(volume)})
            self.assertEqual(list(rows["confirmed_by"]), ["Nef", "Nef", "integrals"])
            self.assertEqual(rows[0]["asserted_seconds"], None)
            self.assertGreater(rows[1]["asserted_seconds"], 0)
            self.assertTrue((rows["seconds"] > 0).all())

    def test_boxes_that_touch_along_an_edge_as_the_page_has_them(self):
        a, b = A, cnrg.box([2, 2, 0], [4, 4, 2])
        rows = cnrg.bench.run(a | b, systems=["ours", "nef", "mantyla-exact"])
        self.assertEqual(list(rows["verdict"]), ["same", "same", "contact-duplicated"])
        self.assertEqual(list(rows["confirmed_by"]), ["Nef", "Nef", "integrals"])
        kept = cnrg.bench.mantyla(a, b, "union", epsilon=1e-8)
        self.assertEqual((kept.row["verdict"], kept.result.evaluate().volume), ("contact-duplicated", 16))

    def test_experiments_of_the_source_by_operations_and_values(self):
        rows = cnrg.bench.run("edge", systems="ours", operations=["union", "difference"], values={"k": "exact,3", "seed": 1, "size": [4]})
        self.assertEqual(sorted(zip(rows["operation"], rows["value:k"])),
                         [("difference", "3"), ("difference", "exact"), ("union", "3"), ("union", "exact")])
        self.assertEqual(set(rows["verdict"]), {"same"})
        self.assertEqual(rows.array.dtype["seconds"], numpy.dtype("f8"))
        with self.assertRaises(ValueError):
            rows["seconds"][0] = 1

    def test_a_folder_keeps_rows_and_a_program_is_a_system(self):
        import tempfile
        from pathlib import Path
        with tempfile.TemporaryDirectory() as folder:
            mine = Path(folder, "mine")
            mine.write_text('#!/bin/sh\ncp "$2" "$4"\n')
            mine.chmod(0o755)
            for _ in range(2):
                rows = cnrg.bench.run(A | B, systems=["mine"], programs={"mine": mine}, folder=Path(folder, "rows"))
                self.assertEqual((rows["system"][0], rows["verdict"][0]), ("mine", "wrong"))
                self.assertAlmostEqual(rows["missing"][0], 7 / 15)
                self.assertEqual(rows["confirmed_by"][0], "integrals")
            self.assertEqual(len(list(Path(folder, "rows", "rows").glob("*/mine.json"))), 1)
            with self.assertRaisesRegex(cnrg.InputError, "has another experiment model"):
                cnrg.bench.run(B | A, systems=["ours"], folder=Path(folder, "rows"))

    def test_rows_are_a_table_of_pandas(self):
        rows = cnrg.bench.run("edge", systems=["ours", "mantyla-exact"], operations="union", values={"k": "exact,3", "seed": 1, "size": 4})
        frame = rows.to_pandas()
        self.assertEqual(list(frame.columns), list(rows.array.dtype.names))
        self.assertEqual(len(frame), 4)
        for name in frame.columns:
            self.assertEqual(frame[name].dtype, rows.array.dtype[name])
            self.assertEqual(frame[name].tolist(), rows[name].tolist())
        counts = frame.groupby(["system", "verdict"]).size().to_dict()
        self.assertEqual(counts, {("ours", "same"): 2, ("mantyla-exact", "same"): 1, ("mantyla-exact", "contact-duplicated"): 1})
        self.assertEqual(frame[frame["value:k"] == "3"]["verdict"].tolist(), ["same", "same"])
        empty = cnrg.bench.Rows([]).to_pandas()
        self.assertEqual((len(empty), empty["seconds"].dtype), (0, numpy.dtype("f8")))
        frame.loc[0, "seconds"] = -1.0  # a copy: rows stay as they are
        self.assertGreater(rows["seconds"][0], 0)

    def test_what_a_row_lacks_is_not_a_number(self):
        row = dict(cnrg.bench.run(A | B, systems="ours")[0]) | {"excess": None}
        frame = cnrg.bench.Rows([row]).to_pandas()
        self.assertTrue(frame["excess"].isna()[0])
        self.assertFalse(frame["missing"].isna()[0])

    def test_a_mesh_is_judged(self):
        right = box([1, 1, 1], [2, 2, 2])
        row = cnrg.bench.judge(right, [A, box([1, 1, 1], [3, 3, 3])], "intersection")
        self.assertEqual((row["verdict"], row["facts"]["volume"], row["confirmation"]["by"]), ("same", "1", "integrals"))
        row = cnrg.bench.judge(box([1, 1, 1], [2, 2, 2.5]), [A, B], "intersection")
        self.assertEqual((row["verdict"], row["stage"], row["excess"]), ("wrong", "volume", 0.5))
        hair = box([1, 1, 1], [2, 2, 2 + 1e-15])
        self.assertEqual(cnrg.bench.judge(hair, [A, B], "intersection")["verdict"], "wrong")
        self.assertEqual(cnrg.bench.judge(hair, [A, B], "intersection", rounding=1e-12)["verdict"], "same")
        plate = cnrg.box([0, 0, 0], [3, 1, 1])
        holes = [cnrg.box([x, 0, 0], [x + 1, 1, 1]) for x in (0, 1)]
        self.assertEqual(cnrg.bench.judge(box([2, 0, 0], [3, 1, 1]), [plate, *holes], "difference")["verdict"], "same")

    def test_mantyla_has_the_result_and_its_verdict(self):
        for operation, volume in VOLUMES.items():
            for epsilon in None, 1e-8:
                kept = cnrg.bench.mantyla(A, box([1, 1, 1], [3, 3, 3]), operation, epsilon=epsilon)
                self.assertEqual(kept.row["verdict"], "same")
                self.assertEqual(kept.result.evaluate().volume, volume)
        third = cnrg.bench.mantyla(A, cnrg.box([Fraction(1, 3), 0, 0], [3, 2, 2]), "intersection")
        self.assertEqual(third.result.evaluate().volume, Fraction(20, 3))  # exactly
        gone = cnrg.bench.mantyla(A, cnrg.box([5, 5, 5], [6, 6, 6]), "intersection")
        self.assertEqual((gone.row["verdict"], gone.result), ("same", None))

    def test_what_is_wrong_is_told(self):
        with self.assertRaisesRegex(cnrg.InputError, "there is no system 'nex'; did you mean `nef`"):
            cnrg.bench.run(A | B, systems="nex")
        with self.assertRaisesRegex(cnrg.InputError, "-D k: no experiment here has values for this parameter"):
            cnrg.bench.run(A | B, values={"k": 1})
        with self.assertRaisesRegex(cnrg.InputError, "-D operation: no experiment here"):
            cnrg.bench.run(A | B, operations="union")
        sheet = cnrg.polygon([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        with self.assertRaisesRegex(cnrg.InputError, "judge: input: "):
            cnrg.bench.judge(box([0, 0, 0], [2, 2, 2]), [A, sheet], "union")
        refused = cnrg.bench.mantyla(A, sheet, "union")
        self.assertEqual((refused.row["verdict"], refused.row["stage"], refused.result), ("refused", "input", None))
        with self.assertRaisesRegex(ValueError, "there is no operation 'minus'"):
            cnrg.bench.judge(box([0, 0, 0], [1, 1, 1]), [A, B], "minus")
        with self.assertRaisesRegex(ValueError, "two operands or more"):
            cnrg.bench.judge(box([0, 0, 0], [1, 1, 1]), [A], "union")


if __name__ == "__main__":
    unittest.main()
