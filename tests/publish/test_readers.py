"""What is read of measurements: of reports and counts as their programs write them here, and of kept rows of speed."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES = Path(os.environ["CNRG_SOURCES"])
sys.path += [str(SOURCES / "bench/report"), str(SOURCES / "tests/report")]

from measurements import GROWING, nef, read_counts, read_growth, read_nef, read_report  # noqa: E402
from plausible import right_row  # noqa: E402
from report_json import report_json  # noqa: E402
from rows import make_experiment  # noqa: E402
from summary import Summary  # noqa: E402

CUBE = """OFF
8 6 0
0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1
4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7
"""


def report_of(rows):
    experiment = make_experiment(rows, [], [], None)
    return report_json(experiment, Summary(experiment), "t")


class Reports(unittest.TestCase):
    def test_growth_is_from_the_least_size_to_the_largest(self):
        rows = [right_row(system, family, size, seconds=size * unit, own_bytes=size * 1_000_000)
                for family in GROWING for size in (4, 8, 16) for system, unit in (("ours", 0.001), ("ours-tree", 0.1))]
        read = read_growth(report_of(rows))
        self.assertEqual((read["problems"], read["nef"]), (15, 15))
        told = {row.split("`")[1]: row.split(" | ")[1:] for row in read["rows"]}
        self.assertEqual(told["crossings"], ["16", "256", "4 to 16", "400 to 1,600", "4 to 16"])
        self.assertEqual(told["regions"], ["125", "4,913", "4 to 16", "400 to 1,600", "4 to 16"])
        self.assertEqual(told["overlap"][:2], ["4/16", "1"])

    def test_a_report_without_a_family_is_no_growth(self):
        with self.assertRaises(KeyError):
            read_growth(report_of([right_row("ours", "crossings", size) for size in (1, 2, 3)]))

    def test_a_report_is_a_row_per_system(self):
        rows = [right_row("ours", "f", seed=1), right_row("a", "f", seed=1, verdict="wrong", seconds=3.0),
                right_row("ours", "f", seed=2), right_row("a", "f", seed=2, seconds=3.0)]
        read = read_report(report_of(rows))
        self.assertEqual(read["rows"], ["ours | 2 | 0 | 0 | 0 | 0 |  |  | 1 | 1", "a | 1 | 0 | 1 | 0 | 0 |  |  | 3 | 1"])
        self.assertEqual([read[what] for what in ("problems", "systems", "families", "runs", "nef")], [2, 2, 1, 4, 2])


class Counts(unittest.TestCase):
    def test_models_by_what_became_of_them(self):
        with tempfile.TemporaryDirectory() as folder:
            models = Path(folder, "models")
            models.mkdir()
            Path(models, "cube.off").write_text(CUBE)
            Path(models, "broken.off").write_text("OFF\n3 1 0\n0 0 x\n")
            out = Path(folder, "out.json")
            done = subprocess.run([SOURCES / "bench/conserve/conserve", "--cnrg", os.environ["CNRG_PROGRAM"], models, "--count",
                                   "--json", out], capture_output=True, text=True, check=False)
            self.assertTrue(out.exists(), done.stderr)
            read = read_counts(out.read_text())
        outcomes = ("left out", "refused", "as is", "snapped", "joined", "out of time", "FAILED")
        self.assertEqual(read["files"], 2)
        self.assertEqual({what: read[what] for what in outcomes if read[what]}, {"left out": 1, "as is": 1})
        self.assertGreater(read["tetrahedra"], 5)
        self.assertLessEqual(read["bad"], read["tetrahedra"])


def case(name, group, triangles, cells, **seconds):
    """As bench/run speed keeps it; seconds by system."""
    names = {"ours": "cnrg, 1 thread", "fine": "CGAL corefinement", "nef": "CGAL Nef", "each": "Nef, one by one"}
    rows = [{"system": names[system], "seconds": times, "own_bytes": 500 * triangles, "cells": cells} for system, times in seconds.items()]
    return {"name": name, "group": group, "triangles": triangles, "input_cells": cells, "rows": rows}


class Nef(unittest.TestCase):
    CASES = [case("a+b", "pairs", 200_000, 600_000, ours=[0.2, 0.1, 0.4], fine=[0.25], nef=[12.0]),
             case("small", "pairs", 1000, 3000, ours=[1.0], fine=[9.0], nef=[9.0]),
             case("c", "growth", 10_000, 1000, ours=[1.0]), case("d", "growth", 20_000, 2000, ours=[2.5]),
             case("spheres64", "nary", 5000, 9, ours=[0.5], nef=[40.0]),
             case("boxes200", "nary", 2400, 9, ours=[0.25], nef=[6.0], each=[34.25])]

    def test_ratios_are_of_medians(self):
        read = read_nef(json.dumps(self.CASES))
        self.assertEqual(read, {"pairs": 1, "corefinement": [0.8], "nef": [60.0], "bytes": [500.0], "spheres": [80.0],
                                "boxes": [24.0], "one_by_one": [137.0], "growth": 1.25})
        fields = nef({"speed-nef": {"values": read, "commit": "abc", "command": "c"}})
        self.assertEqual([fields[name] for name in ("nef", "spheres", "one_by_one", "corefinement", "bytes")],
                         ["1/60", "1/80", "1/137", "0.8", "500"])

    def test_what_is_read_is_what_speed_writes(self):
        kept = [one for one in json.loads((SOURCES / "bench/measured.json").read_text()) if one.get("group") == "pairs"]
        self.assertTrue(kept)
        for members, there in (self.CASES[0], kept[0]), (self.CASES[0]["rows"][0], kept[0]["rows"][0]):
            self.assertLessEqual(set(members), set(there))
        self.assertLessEqual({"cnrg, 1 thread", "CGAL corefinement"}, {row["system"] for row in kept[0]["rows"]})


if __name__ == "__main__":
    unittest.main()
