"""Figures: their data are those of the rows, and what is drawn are their data."""
import csv
import io
import math
import re
import unittest
import xml.etree.ElementTree as ET
from statistics import median

import words
from figures import GROUND, MARKERS, SERIES, SVG, decades, drawn, figures_of, for_page, growth_figure, label, styled
from plausible import FAMILIES, Sweep, right_row, system_info
from rows import CLASS_OF, FAILURES, make_experiment
from summary import GrowthCurve, GrowthPoint, GrowthStudy, Summary

SWEEP = Sweep(15, 7)
EXPERIMENT = make_experiment(SWEEP.rows, SWEEP.systems, SWEEP.families, SWEEP.machine)
FIGURES = {figure.name: figure for figure in figures_of(EXPERIMENT, Summary(EXPERIMENT)).all()}
RIGHT = [row for row in EXPERIMENT.rows if CLASS_OF[row["verdict"]] in ("exact", "right")]


def table(figure):
    return list(csv.DictReader(io.StringIO(figure.csv())))


def canvas_of(figure):
    with styled():
        from matplotlib.figure import Figure
        canvas = Figure()
        figure.draw(canvas)
    return canvas


def texts(svg):
    return [element.text for element in ET.fromstring(svg).iter(f"{{{SVG}}}text")]


class Figures(unittest.TestCase):
    def test_each_study_has_its_figure(self):
        grown = [name for name, _, _, _, sizes, _ in FAMILIES if len(sizes) >= 3]
        self.assertEqual(set(FIGURES), {"failures", "failures-by-family", "time-ratios", "memory-ratios"}
                         | {f"{what}-{family}" for family in grown for what in ("time", "memory")})

    def test_failures_are_those_of_the_rows(self):
        everywhere = {}
        for row in EXPERIMENT.rows:
            if row["has_distance"] and row["verdict"] != "unjudged":
                failed = CLASS_OF[row["verdict"]] in FAILURES
                for family in "all", row["family"]:
                    counts = everywhere.setdefault((family, row["system"], row["distance"]), [0, 0])
                    counts[0] += 1
                    counts[1] += failed
        said = {}
        for name in "failures", "failures-by-family":
            for line in table(FIGURES[name]):
                k = None if line["k"] == "exact" else int(line["k"])
                self.assertEqual(float(line["distance"]), 0 if k is None else float(f"1e-{k}"))
                self.assertEqual(float(line["failure_rate"]), int(line["failures"]) / int(line["judged"]))
                said[line["family"], line["system"], k] = [int(line["judged"]), int(line["failures"])]
        self.assertEqual(said, everywhere)

    def test_growth_is_that_of_the_rows(self):
        for what, cost, column, unit in ("time", "seconds", "seconds", 1), ("memory", "own_bytes", "megabytes", 1e6):
            for line in table(FIGURES[f"{what}-boxes"]):
                rows = [row for row in RIGHT if row["family"] == "boxes" and row["system"] == line["system"]
                        and row["size"] == int(line["size"])]
                self.assertEqual(int(line["right"]), len(rows))
                self.assertAlmostEqual(float(line["triangles"]), median(row["triangles"] for row in rows))
                self.assertAlmostEqual(float(line[column]), median(row[cost] for row in rows) / unit)
            self.assertEqual(len(table(FIGURES[f"{what}-boxes"])), 7 * 4)

    def test_ratios_are_those_of_the_rows(self):
        ours = {row["problem"]: row for row in RIGHT if row["system"] == "ours"}
        for what, cost in ("time", "seconds"), ("memory", "own_bytes"):
            lines = table(FIGURES[f"{what}-ratios"])
            self.assertEqual([line["system"] for line in lines], list(EXPERIMENT.system)[1:])
            for line in lines:
                ratios = [row[cost] / ours[row["problem"]][cost] for row in RIGHT
                          if row["system"] == line["system"] and row["problem"] in ours]
                self.assertEqual(int(line["count"]), len(ratios))
                for column, value in ("min", min(ratios)), ("median", median(ratios)), ("max", max(ratios)):
                    self.assertAlmostEqual(float(line[column]), value)

    def test_what_is_drawn_are_the_data(self):
        axes, = canvas_of(FIGURES["failures"]).axes
        drawn_rates = sorted(y for line in axes.lines for y in line.get_ydata())
        self.assertEqual(drawn_rates, sorted(r[7] for r in FIGURES["failures"].records))
        self.assertEqual(axes.get_ylim()[0], 0)  # nothing is below 0 %
        starts = [line.get_xdata()[0] for line in axes.lines if len(line.get_xdata()) > 1]
        self.assertEqual(len(set(starts)), 7)  # systems stand beside each other
        bars = sorted(tuple(bar[:, 1]) for bars in axes.collections for bar in bars.get_segments())
        self.assertEqual(bars, sorted(r[8:] for r in FIGURES["failures"].records))
        families = FIGURES["failures-by-family"]
        panels = canvas_of(families).axes
        self.assertEqual([panel.get_title("left") for panel in panels],
                         list(dict.fromkeys(record[0] for record in families.records)))
        for panel in panels:
            own = sorted(r[7] for r in families.records if r[0] == panel.get_title("left"))
            self.assertEqual(sorted(y for line in panel.lines for y in line.get_ydata()), own)
        figure = FIGURES["time-boxes"]
        axes, = canvas_of(figure).axes
        self.assertEqual([(x, y) for line in axes.lines for x, y in zip(*line.get_data())],
                         [record[3:5] for record in figure.records])
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        ratios = FIGURES["time-ratios"]
        axes, = canvas_of(ratios).axes
        whiskers = [tuple(line.get_xdata()) for line in axes.lines][0:-1:3]
        self.assertEqual(whiskers, [(record[2], record[6]) for record in ratios.records])

    def test_each_figure_says_its_systems_and_units(self):
        for name, figure in FIGURES.items():
            svg, pdf = (drawn(figure, form, "0123abcd") for form in ("svg", "pdf"))
            said = "\n".join(texts(svg))
            systems = {record[0 if name.endswith("-ratios") else 1] for record in figure.records}
            for system in systems:
                self.assertIn(label(EXPERIMENT, system), said)
            unit = {"failures": "distance to the degenerate position, as a part", "time-ratios": "time as a multiple",
                    "memory-ratios": "memory as a multiple"}.get(
                        name.removesuffix("-by-family"), "time, seconds" if name.startswith("time") else "memory, MB")
            self.assertIn(unit, said)
            self.assertIn(b"Rows of commit 0123abcd", svg)
            self.assertTrue(pdf.startswith(b"%PDF-"))
            self.assertNotIn(b"/Type3", pdf)  # fonts that publishers refuse
            self.assertNotRegex(svg.decode(), r"\d{4}-\d{2}-\d{2}T")
        self.assertEqual((drawn(figure, "svg", "0123abcd"), drawn(figure, "pdf", "0123abcd")), (svg, pdf))

    def test_axes_have_whole_decades_with_all_their_ticks(self):
        low, high, ticks = decades([0.02, 30])
        self.assertEqual((low, high), (-2, 2))
        self.assertEqual([words.decade_text(e) for e in ticks], ["0.01", "0.1", "1", "10", "100"])
        self.assertEqual(decades([1])[:2], (0, 1))
        self.assertEqual(decades([2e4, 3e5])[1], 6)
        experiment = make_experiment([right_row("a & b", "f")], [], [], None)
        for e in range(-9, 10):
            ends = [GrowthPoint(size, 1, 1, y, y, y, 1.0, y, (y, y), (1.0, 1.0))
                    for size, y in ((1, 1.5 * 10.0 ** e), (2, 500 * 10.0 ** e))]
            study = GrowthStudy("f", [GrowthCurve("a & b", ends, None, None)])
            svg = drawn(growth_figure(experiment, "ours", study, "time", "seconds", 1, "seconds"), "svg")
            ticks = [words.decade_text(tick) for tick in range(e, e + 4)]
            self.assertEqual(sorted(texts(svg)),
                             sorted(2 * ticks + ["f", "a & b", "triangles of all operands", "time, seconds"]))

    def test_systems_look_different_and_the_same_in_all_figures(self):
        systems = [system_info(f"s{i}", f"S{i}") for i in range(30)]
        rows = [right_row(info["name"], "f", size) for info in systems for size in (1, 2, 3)]
        experiment = make_experiment(rows, systems, [], None)
        figures = figures_of(experiment, Summary(experiment))
        axes, = canvas_of(figures.growth["f"][0]).axes
        looks = {(line.get_color(), line.get_marker(), line.get_markerfacecolor(), line.get_linestyle())
                 for line in axes.lines}
        self.assertEqual(len(looks), 30)
        page = for_page(drawn(figures.growth["f"][0], "svg"), figures.growth["f"][0])
        self.assertEqual(set(re.findall(r"var\(--(s[0-9]+)\)", page)), {f"s{i}" for i in range(10)})

    def test_colours_stay_apart_for_the_colour_blind_in_brightness_or_marker(self):
        self.assertEqual(2 * len(set(MARKERS)), len(SERIES))  # filled and empty

        def luminance(colour):
            parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
            red, green, blue = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
            return 0.2126 * red + 0.7152 * green + 0.0722 * blue

        for light, dark in SERIES:  # against the page, as WCAG asks of graphics
            self.assertGreater((1 + 0.05) / (luminance(light) + 0.05), 3)
            self.assertGreater((luminance(dark) + 0.05) / (luminance(GROUND[1]) + 0.05), 3)

    def test_a_name_that_is_too_long_for_a_legend_is_cut(self):
        long, spaced = "n" * 60, "a name\nin lines"
        experiment = make_experiment([right_row(name, "f", size) for name in (long, spaced) for size in (1, 2, 3)],
                                     [], [], None)
        said = texts(drawn(figures_of(experiment, Summary(experiment)).growth["f"][0], "svg"))
        self.assertIn("n" * 29 + "…", " ".join(said))
        self.assertIn("a name in lines", " ".join(said))

    def test_families_may_be_called_anything(self):
        rows = [right_row("ours", family, size, seconds=float(size)) for family in ("../a", ".. a", "a b")
                for size in (1, 2, 3)]
        experiment = make_experiment(rows, [], [], None)
        names = [figure.name for figure in figures_of(experiment, Summary(experiment)).all()]
        self.assertEqual(len(set(names)), 6)
        for name in names:
            self.assertRegex(name, "^[A-Za-z0-9_-]+$")

    def test_nothing_is_drawn_of_nothing(self):
        rows = [right_row("ours", "f", size, verdict="refused") for size in (1, 2, 3)]
        experiment = make_experiment(rows, [], [], None)
        self.assertEqual(figures_of(experiment, Summary(experiment)).all(), [])
        rows = [right_row("ours", "f", size, seconds=0.0) for size in (1, 2, 3)]
        experiment = make_experiment(rows, [], [], None)
        self.assertEqual([figure.name for figure in figures_of(experiment, Summary(experiment)).all()], ["memory-f"])
        self.assertTrue(all(math.isfinite(record[4]) for figure in FIGURES.values() for record in figure.records
                            if figure.name.startswith(("time-b", "memory-b"))))
