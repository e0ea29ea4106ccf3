"""Each example prints what the comment at its end says; scripts of csg/python/examples open with words that teach."""
import ast
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CSG = Path(os.environ["CNRG_SOURCES"]) / "csg"
OTHERS = ("dask", "h5py", "meshio")  # packages that some of them show how to work with


def expected(text, mark="# "):
    """The lines behind the line `# Output:`, without their `# `."""
    lines = text.splitlines()
    at = lines.index(mark + "Output:")
    return "".join(line[len(mark):] + "\n" for line in lines[at + 1:])


class Examples(unittest.TestCase):
    maxDiff = None

    def check(self, path):
        text = path.read_text()
        self.assertGreater(len(ast.get_docstring(ast.parse(text)) or ""), 200)
        for package in OTHERS:
            if re.search(rf"^import {package}$", text, re.M) and importlib.util.find_spec(package) is None:
                self.skipTest(f"{package} is not installed (Debian: python3-{package})")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-W", "error", str(path)], cwd=folder, capture_output=True,
                                  text=True)
        if "OpenCASCADE" in done.stderr and "built without" in done.stderr:
            self.skipTest("cnrg is built without OpenCASCADE")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout)
        self.assertEqual(done.stdout, expected(text))


    def check_program(self, path):
        program = Path(os.environ["CNRG_PROGRAM"]).with_name("example_" + path.stem)
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([str(program)], cwd=folder, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout)
        self.assertEqual(done.stdout, expected(path.read_text(), "// "))


def add(path, check):
    setattr(Examples, f"test_{path.stem}_prints_what_it_says", lambda self: check(self, path))


for script in sorted(CSG.glob("python/examples/*.py")):
    add(script, Examples.check)
for source in sorted(CSG.glob("examples/*.cpp")):
    add(source, Examples.check_program)
