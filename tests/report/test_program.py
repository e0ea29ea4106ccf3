"""The command bench/report/report on folders of rows."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from plausible import Sweep

PROGRAM = Path(__file__).resolve().parents[2] / "bench" / "report" / "report"
ROW = "rows/rows/face-union-s1-k0-r1/ours.json"


class Program(unittest.TestCase):
    def setUp(self):
        """A folder with a small sweep in `rows`."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.sweep = Sweep(2, 3)
        self.sweep.write(self.folder / "rows")

    def run_report(self, *arguments, **environment):
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, text=True, capture_output=True,
                              env=os.environ | environment)

    def fails(self, *arguments, **environment):
        """What it says; one line, and nothing is written."""
        ended = self.run_report(*arguments, **environment)
        self.assertEqual(ended.returncode, 2)
        self.assertEqual(ended.stdout, "")
        self.assertEqual(self.written(), [])
        return ended.stderr

    def fault(self, *arguments, **environment):
        said = self.fails(*arguments, **environment)
        self.assertRegex(said, r"\Abench/report: error: [^\n]*\n\Z")
        return said.removeprefix("bench/report: error: ").rstrip("\n")

    def written(self):
        return sorted(path.name for path in self.folder.iterdir() if path.name not in ("rows", "other.json"))

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(text)

    def read(self, name):
        return (self.folder / name).read_text()

    def test_what_is_published_of_a_report_is_in_its_rows(self):
        sys.path.append(str(PROGRAM.parents[1] / "publish"))
        from measurements import read_report
        self.run_report("rows", "-o", "page.html", "--json", "page.json")
        published = read_report(self.read("page.json"))
        report = json.loads(self.read("page.json"))
        self.assertEqual(published["runs"], len(report["rows"]))
        self.assertEqual(published["problems"], len({row["problem"] for row in report["rows"]}))
        names = {system["title"]: system["name"] for system in report["systems"]}
        self.assertEqual(len(published["rows"]), len({row["system"] for row in report["rows"]}))
        for line in published["rows"]:
            title, same, right, wrong, refused, late = line.split(" | ")[:6]
            verdicts = [row["verdict"] for row in report["rows"] if row["system"] == names[title]]
            others = ("same-regularized", "contact-duplicated", "contact-lost", "dangling-lost", "within-rounding")
            self.assertEqual([int(n) for n in (same, right, wrong, refused, late)],
                             [verdicts.count("same"), sum(map(verdicts.count, others)),
                              *map(verdicts.count, ("wrong", "refused", "timed-out"))])

    def test_a_sweep_becomes_a_page_a_json_and_figures(self):
        self.write("rows/.hidden/x.json", "no row")
        self.write("rows/.x.json", "no row")
        self.write("rows/notes.txt", "no row")
        ended = self.run_report("rows", "-o", "page.html", "--json", "page.json", "--figures", "figures",
                                "--tables", "tables", "--title", "A title")
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (0, "", ""))
        page = self.read("page.html")
        ET.fromstring(page)
        table = self.read("tables/verdicts.tex")
        self.assertEqual(table.count("\\\\\n"), 1 + 3)
        self.assertIn("M\u00e4ntyl\u00e4, double & ", table)
        self.assertRegex(table, r"\d \\% \(\d")
        for text in "<h1>A title</h1>", "Mäntylä, exact", "two boxes that share a whole face":
            self.assertIn(text, page)
        report = json.loads(self.read("page.json"))
        self.assertEqual(len(report["rows"]), 2 * 3 * 18 * 3)
        self.assertEqual(report["machine"]["date"], "2026-11-21")
        self.assertEqual(self.written(), ["figures", "page.html", "page.json", "tables"])
        figures = sorted(path.name for path in (self.folder / "figures").iterdir())
        self.assertEqual(figures, sorted(f"{name}.{ending}" for ending in ("csv", "pdf", "svg") for name in (
            "failures", "failures-by-family", "time-ratios", "memory-ratios")))
        for name in figures:
            self.assertIn(f"figures/{name.split('.')[0]}.svg, .pdf, .csv", page)
        before = {path.name: path.read_bytes() for path in self.folder.glob("**/*") if path.is_file()}
        self.assertEqual(self.run_report("rows", "-o", "page.html", "--json", "page.json", "--figures", "figures",
                                         "--title", "A title").returncode, 0)
        after = {path.name: path.read_bytes() for path in self.folder.glob("**/*") if path.is_file()}
        self.assertEqual(before, after)

    def test_the_machine_of_another_file(self):
        self.write("other.json", json.dumps(self.sweep.machine | {"cpu": "Another processor"}))
        self.assertEqual(self.fault("rows", "-o", "page.html", "--machine", "missing.json"),
                         "missing.json: cannot be read")
        self.assertEqual(self.run_report("rows", "-o", "page.html", "--machine", "other.json").returncode, 0)
        self.assertIn("Another processor", self.read("page.html"))
        self.assertNotIn(".pdf", self.read("page.html"))
        self.assertEqual(self.written(), ["page.html"])

    def test_a_broken_file_is_named_and_nothing_is_written(self):
        arguments = ("rows", "-o", "page.html", "--json", "page.json", "--figures", "figures")
        good = self.read(ROW)
        remedy = "; remove the file and let the sweep make it again"
        self.write(ROW, good[:len(good) // 2])
        said = self.fault(*arguments)
        self.assertTrue(said.startswith(f"{ROW}: no JSON: parse error") and said.endswith(remedy), said)
        self.write(ROW, "{}")
        self.assertEqual(self.fault(*arguments), f"{ROW}: the row has no member `problem`{remedy}")
        self.write(ROW, good)
        self.write("rows/copy.json", good)
        self.assertIn("two rows of ours on face-union-s1-k0-r1; remove one", self.fault(*arguments))
        (self.folder / "rows/copy.json").unlink()
        self.write("rows/systems.json", '[{"name": 1}]')
        self.assertEqual(self.fault(*arguments),
                         "rows/systems.json: member `name` of a system is not a text; correct or remove it")
        self.write("rows/systems.json", "{}")
        self.assertEqual(self.fault(*arguments), "rows/systems.json: no JSON list; correct or remove it")
        (self.folder / "rows/systems.json").unlink()
        self.write("rows/machine.json", '{"cpu": 1}')
        self.assertEqual(self.fault(*arguments),
                         "rows/machine.json: member `cpu` of the machine is not a text; correct it or leave it out")

    def test_a_folder_without_rows_and_none(self):
        (self.folder / "rows/empty").mkdir()
        self.assertTrue(self.fault("rows/empty", "-o", "page.html").startswith(
            "rows/empty: there are no rows (*.json); give the folder"))
        self.assertTrue(self.fault("missing", "-o", "page.html").startswith("missing: is no folder; give the one"))
        self.assertIn("write the report's JSON outside of it",
                      self.fault("rows", "-o", "page.html", "--json", "rows/page.json"))
        self.assertIn("required", self.fails("rows"))
        self.assertTrue(self.fault("rows", "-o", "missing/page.html").startswith(
            "missing/page.html: cannot be written: No such file"))

    def test_a_package_that_is_missing_is_named(self):
        for module, package in ("jinja2", "python3-jinja2"), ("matplotlib", "python3-matplotlib"):
            with tempfile.TemporaryDirectory() as hidden:
                (Path(hidden) / f"{module}.py").write_text(f"raise ModuleNotFoundError(name={module!r})\n")
                self.assertEqual(self.fault("rows", "-o", "page.html", PYTHONPATH=hidden),
                                 f"{module} was not found; install the package {package}")
