"""The folder of rows: what is read, in which order, and how a fault is named."""
import json
import tempfile
import unittest
from pathlib import Path

from plausible import FACTS, Sweep, right_row, system_info
from rows import FAILURES, CLASS_OF, VERDICTS, Unread, make_experiment, read_experiment, row_of

# Every member has a value of its own.
FULL = {"problem": "edge-union-s4-k7-r3", "family": "edge", "values": {"k": "7"}, "operation": "union", "size": 4, "distance": 7,
        "has_distance": True, "seed": 3, "operands": 5, "triangles": 60, "system": "mantyla-double",
        "verdict": "contact-duplicated", "stage": "connecting", "message": "\"loose\" ends: <2> & ä",
        "stages": [{"name": "read", "seconds": 0.1}, {"name": "Boolean", "seconds": 1 / 3}], "warm": [0.25, 0.5], "asserted_seconds": 0.75, "seconds": 0.1 + 1 / 3,
        "peak_bytes": 5000000001, "own_bytes": 77, "exact_share": 1e-5, "note": "a note",
        "facts": FACTS | {"volume": "-7/3", "genus": -1}, "excess": 0.25, "missing": 1e-17, "duplicates": 13,
        "truth": {"facts": FACTS, "confirmed": "volume", "reason": "Nef ran out of memory"},
        "confirmation": {"by": "points", "reason": "256 points"}, "limit_seconds": 60.0,
        "limit_bytes": 4000000000, "load": 1.5, "command": "bench/run --one edge-union-s4-k7-r3 mantyla-double"}


class Rows(unittest.TestCase):
    def fault(self, text):
        """What is said of a folder with this text as its only row; no fault: `none`."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "row.json"
            path.write_bytes(text if isinstance(text, bytes) else text.encode())
            try:
                read_experiment(folder)
            except Unread as fault:
                said, remedy = str(fault).rsplit("; ", 1)
                self.assertEqual(remedy, "remove the file and let the sweep make it again")
                self.assertTrue(said.startswith(f"{path}: "))
                return said[len(f"{path}: "):]
            return "none"

    def fault_with(self, **members):
        return self.fault(json.dumps(FULL | members))

    def test_a_row_is_read_as_it_was_written(self):
        self.assertEqual(row_of(FULL), FULL)
        self.assertEqual(list(row_of(FULL)), list(FULL))
        self.assertEqual(row_of(FULL | {"what nobody knows": 1}), FULL)
        less = FULL | {"distance": None, "facts": None, "excess": None, "missing": None}
        self.assertEqual(row_of(less), less)
        self.assertIsInstance(row_of(FULL | {"seconds": 1})["seconds"], float)

    def test_what_is_no_row_is_named(self):
        self.assertTrue(self.fault('{"problem": ').startswith("no JSON: parse error at line 1, column 13"))
        self.assertTrue(self.fault(b"\xff").startswith("no JSON: "))
        self.assertEqual(self.fault("[]"), "the row is no JSON object")
        self.assertEqual(self.fault('{"problem": "\\ud800"}'), "member `problem` of the row is not a text")
        for constant in "NaN", "Infinity", "-Infinity":
            self.assertEqual(self.fault(f'{{"seconds": {constant}}}'), f"no JSON: {constant} is no number")
        self.assertEqual(self.fault(json.dumps(FULL).replace('"exact_share": 1e-05', '"exact_share": 1e999')),
                         "member `exact_share` of the row is not a number")
        self.assertEqual(self.fault("[" * 100000)[:9], "no JSON: ")

    def test_each_member_must_be_there_and_of_its_type(self):
        self.assertEqual(self.fault(json.dumps(FULL)), "none")
        for member in FULL:
            less = {key: value for key, value in FULL.items() if key != member}
            self.assertEqual(self.fault(json.dumps(less)), f"the row has no member `{member}`")
            if member not in ("facts", "excess", "missing", "distance", "asserted_seconds"):
                self.assertIn(member if member in ("truth", "confirmation") else f"`{member}`", self.fault_with(**{member: None}))
        self.assertEqual(self.fault_with(truth=None), "the truth is no JSON object")
        self.assertEqual(self.fault_with(truth=FULL["truth"] | {"confirmed": "me"}),
                         "member `confirmed` of the truth is not one of Nef, Nef-by-us, node, formula, volume, none, DISAGREES")
        self.assertEqual(self.fault_with(confirmation={"by": "me", "reason": ""}), "member `by` of the confirmation is "
                         "not one of Nef, integrals, points, none, DISPUTED, no-verdict")
        self.assertEqual(self.fault_with(facts={}), "the facts has no member `volume`")
        self.assertEqual(self.fault_with(verdict="Same"), "member `verdict` of the row is not a known verdict")
        self.assertEqual(self.fault_with(seconds=-1), "member `seconds` of the row is not a number from 0")
        self.assertEqual(self.fault_with(seconds=True), "member `seconds` of the row is not a number")
        self.assertEqual(self.fault_with(seed=-1), "member `seed` of the row is not a number in its range")
        self.assertEqual(self.fault_with(seed=5000000000), "member `seed` of the row is not a number in its range")
        self.assertEqual(self.fault_with(size=1.5), "member `size` of the row is not a whole number")
        self.assertIn("member `distance` of the row is not null or", self.fault_with(distance=301))
        self.assertIn("member `distance` of the row is not null or", self.fault_with(has_distance=False))
        self.assertEqual(self.fault_with(stages=[{"name": "x"}]), "a stage has no member `seconds`")

    def test_verdicts_and_failures(self):
        self.assertEqual(set(VERDICTS), {"same", "same-regularized", "contact-duplicated", "contact-lost",
                                         "dangling-lost", "within-rounding", "wrong", "refused", "crashed", "timed-out",
                                         "out-of-memory", "unjudged"})
        self.assertEqual({verdict for verdict in VERDICTS if CLASS_OF[verdict] in FAILURES},
                         {"wrong", "refused", "crashed", "timed-out", "out-of-memory"})

    def test_ours_comes_first_then_the_order_of_the_description_then_names(self):
        experiment = make_experiment(
            [right_row("b10", "f10"), right_row("b9", "f9"), right_row("ours", "f9"), right_row("z", "g")],
            [system_info("z", "Z"), system_info("ours", "O")], [{"name": "g", "title": "G", "size_means": "", "distance_means": "", "growth": ""}], None)
        self.assertEqual(list(experiment.system), ["ours", "z", "b9", "b10"])
        self.assertEqual(list(experiment.family), ["g", "f9", "f10"])
        self.assertEqual(experiment.rows[0]["system"], "z")
        self.assertEqual(experiment.system["b9"]["title"], "b9")

    def test_what_is_there_twice_or_not_at_all_is_named(self):
        sweep = Sweep(1, 2)
        with self.assertRaisesRegex(Unread, "^`ours` is described twice; remove one of the two$"):
            make_experiment(sweep.rows, [sweep.systems[0], sweep.systems[0]], [], None)
        with self.assertRaisesRegex(Unread, "^there are no rows; run a sweep first$"):
            make_experiment([], sweep.systems, [], None)
        with self.assertRaisesRegex(Unread, "^two rows of ours on face-union-s1-kexact-r1; remove one of the two"):
            make_experiment(sweep.rows + [sweep.rows[0]], sweep.systems, [], None)
