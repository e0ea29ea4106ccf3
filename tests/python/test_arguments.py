"""Arguments that nobody should give: what is known of them, and a short run of the fuzzer."""

import subprocess
import sys
import unittest
from pathlib import Path

import cnrg

FUZZER = Path(__file__).resolve().parent / "fuzz_arguments.py"


class Arguments(unittest.TestCase):
    def test_half_a_character_is_no_number(self):
        for make in (lambda: cnrg.box(["\ud800", 0, 0], [1, 1, 1]), lambda: cnrg.box([0, 0, 0], [1, 1, 1], dominance="\ud800")):
            with self.assertRaisesRegex(cnrg.InputError, "not Unicode"):
                make()

    def test_a_node_of_another_tree_is_not_found(self):
        tree = cnrg.Tree.of(cnrg.box([0, 0, 0], [1, 1, 1]))
        with self.assertRaisesRegex(KeyError, "not in the tree"):
            tree.evaluate(cnrg.box([0, 0, 0], [2, 2, 2]))
        for node in (None, 3, [tree.result]):
            with self.assertRaisesRegex(TypeError, "a node or its name is wanted, not "):
                tree.evaluate(node)

    def test_whatever_is_given_only_documented_errors_come_out(self):
        done = subprocess.run([sys.executable, "-B", FUZZER, "--calls", "6000", "--seed", "1"], capture_output=True,
                              text=True, timeout=600)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_fuzzer_tells_the_call_that_raised_what_it_must_not(self):
        script = ("import sys; sys.argv = ['x']; sys.path.insert(0, sys.argv[0]); import runpy, cnrg\n"
                  "def wrong(text): raise RuntimeError('out of order')\n"
                  "cnrg.__all__ = ['wrong']; cnrg.wrong = wrong\n"
                  f"m = runpy.run_path({str(FUZZER)!r})\n"
                  "m['World'].targets = [('cnrg.wrong', wrong)]\n"
                  "said = []\n"
                  "fault = m['call'](1, 0, said.append, False)\n"
                  "assert 'out of order' in fault and said[-1].startswith('0 cnrg.wrong('), (fault, said)\n")
        done = subprocess.run([sys.executable, "-B", "-c", script], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
