"""Each script of csg/python/examples opens with words that teach, and prints what the comment at its end says."""
import ast
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(os.environ["CNRG_SOURCES"]) / "csg/python/examples"
OTHERS = ("dask", "h5py", "meshio")  # packages that some of them show how to work with


def expected(text):
    """The lines behind the line `# Output:`, without their `# `."""
    lines = text.splitlines()
    at = lines.index("# Output:")
    return "".join(line[2:] + "\n" for line in lines[at + 1:])


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


def add(path):
    setattr(Examples, f"test_{path.stem}_prints_what_it_says", lambda self: self.check(path))


for script in sorted(FOLDER.glob("*.py")):
    add(script)
