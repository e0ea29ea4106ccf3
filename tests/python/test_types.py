"""Type hints: those of the extension are what it has, and a checker knows what users get."""

import builtins
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import cnrg

PACKAGE = Path(cnrg.__file__).resolve().parent
# The package itself is looked into and not reported on: this is about its users.
SETTINGS = "[mypy]\nfollow_imports = silent\nignore_missing_imports = True\n"
GOOD = """from fractions import Fraction
import cnrg
a = cnrg.box([0, 0, 0], ["1/3", 1.5, Fraction(2, 7)], material="rock")
model: cnrg.Node = (a | ~a.closure()).translate((1, 2, 3))
evaluation: cnrg.Evaluation = cnrg.evaluate(model, a, threads=1)
volume: "Fraction | None" = evaluation.rows[0].volume
result: cnrg.Result = model.evaluate()
tree: cnrg.Tree = cnrg.read("t.yaml")
node: cnrg.Node = tree["a"]
"""
BAD = """import cnrg
cnrg.box([0, 0, 0])
cnrg.evaluate("text")
text: str = cnrg.box([0, 0, 0], [1, 1, 1])
cnrg.boxes()
"""


def checked(words, folder):
    # As an installed package is found, whose py.typed says that its types may be used.
    environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent), "PYTHONPATH": str(PACKAGE.parent)}
    done = subprocess.run([sys.executable, "-m", *words], cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout + done.stderr


class Types(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "mypy.ini").write_text(SETTINGS)

    def test_what_is_public_is_listed(self):
        public = {name for name, value in vars(cnrg).items()
                  if not name.startswith("_") and not isinstance(value, type(cnrg))}
        self.assertEqual(set(cnrg.__all__), public - set(dir(builtins)) | {"__version__"})

    def test_the_types_of_the_package_hold(self):
        (self.folder / "all.ini").write_text("[mypy]\nignore_missing_imports = True\n")
        status, said = checked(["mypy", "--config-file", "all.ini", "-p", "cnrg"], self.folder)
        self.assertEqual(status, 0, said)

    def test_a_package_with_types_says_so(self):
        self.assertTrue((PACKAGE / "py.typed").is_file())

    def test_types_of_the_extension_are_what_it_has(self):
        # Of a class of pybind11 the type is its own, and it has a constructor also where there is nothing to call.
        (self.folder / "allowed").write_text("cnrg\\._cnrg\\.[A-Z]\\w*\ncnrg\\._cnrg\\.[A-Z]\\w*\\.__init__\n")
        status, said = checked(["mypy.stubtest", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed", "cnrg._cnrg"],
                               self.folder)
        self.assertEqual(status, 0, said)
        stub = (PACKAGE / "_cnrg.pyi").read_text()
        self.assertIn("def evaluate(tree: Tree, nodes: list[int], threads: int", stub)
        self.assertNotIn("*arguments", stub)  # every signature was understood

    def test_a_checker_knows_what_users_get(self):
        (self.folder / "good.py").write_text(GOOD)
        status, said = checked(["mypy", "--strict", "good.py"], self.folder)
        self.assertEqual(status, 0, said)

    def test_a_checker_finds_what_is_wrong(self):
        (self.folder / "bad.py").write_text(BAD)
        status, said = checked(["mypy", "bad.py"], self.folder)
        self.assertEqual(status, 1, said)
        for line in (2, 3, 4, 5):
            self.assertIn(f"bad.py:{line}: error:", said)
