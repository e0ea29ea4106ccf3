"""The page and the JSON as a whole."""
import copy
import functools
import json
import re
import unittest
import xml.etree.ElementTree as ET
from html.parser import HTMLParser

from facts import main_facts
from figures import drawn, figures_of
from page import page_html
from plausible import Sweep, at_distance, right_row
from report_json import report_json
from rows import make_experiment
from summary import Summary

HOSTILE = "</script><script>alert(\"1\")</script> & 'x' <img src=\"http://a.b/c\"> ]]> {{ 7 * 7 }} $x_1$ \x01 \ufffe"
VOID = {"meta"}


def page_of(experiment, title="A <title> & more"):
    summary = Summary(experiment)
    figures = figures_of(experiment, summary)
    svgs = {figure.name: drawn(figure, "svg") for figure in figures.all()}
    return page_html(experiment, summary, title, figures, svgs)


def experiment_of(sweep):
    return make_experiment(sweep.rows, sweep.systems, sweep.families, sweep.machine)


@functools.cache
def full_page():
    return page_of(experiment_of(Sweep(15, 7)))


class Markup(HTMLParser):
    """What a browser sees: it reads HTML, where `<i/>` outside of a drawing is a beginning without an end."""

    def __init__(self, page):
        super().__init__()
        self.attributes, self.tags, self.faults, self.open = [], [], [], []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs
        self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs
        if "svg" not in self.open and tag not in VOID:
            self.faults.append(tag)

    def handle_endtag(self, tag):
        while self.open and self.open.pop() != tag:
            self.faults.append(tag)

    def values(self, name):
        return [value for key, value in self.attributes if key == name]


def runs_data(page):
    """What the page holds for its script."""
    return json.loads(re.search('id="runs-data">(.*?)</script>', page, re.DOTALL)[1])


class Page(unittest.TestCase):
    def check_markup(self, page):
        """As XML, and as browsers read it. Returns the latter."""
        ET.fromstring(page)
        markup = Markup(page)
        self.assertEqual(markup.faults, [])
        self.assertEqual(markup.open, [])
        ids = markup.values("id")
        self.assertEqual(len(ids), len(set(ids)))
        for href in markup.values("href"):
            self.assertTrue(href[0] == "#" and href[1:] in ids, href)
        return markup

    def test_the_check_of_markup_finds_faults(self):
        for broken in "<a>", "<a></b>", "<a b=c></a>", "<a>&</a>", "<a>&nbsp;</a>", "<a></a><b></b>", "x<a></a>":
            self.assertRaises(ET.ParseError, ET.fromstring, broken)
        self.assertEqual(Markup("<p><i/></p>").faults, ["i"])
        self.assertEqual(Markup("<p><svg><path/></svg><meta/></p>").faults, [])
        self.assertNotEqual(Markup("<p><i></p>").faults, [])

    def test_the_page_is_well_formed_and_needs_nothing_else(self):
        page = full_page()
        markup = self.check_markup(page)
        self.assertIn("<h1>A &lt;title&gt; &amp; more</h1>", page)
        # Names of namespaces are no addresses to load.
        rest = page.replace("http://www.w3.org/1999/xhtml", "").replace("http://www.w3.org/2000/svg", "")
        for load in "http:", "https:", "//www", "url(", "@import", " src=", "<link", "<iframe", "fetch(", "<image":
            self.assertNotIn(load, rest)
        # One for all distances, one of families with distances, seven families in three sizes twice, two of ratios.
        self.assertEqual(markup.tags.count("svg"), 1 + 1 + 2 * 7 + 2)

    def test_drawings_follow_light_and_dark(self):
        drawings = "".join(re.findall("<svg.*?</svg>", full_page(), re.DOTALL))
        self.assertNotRegex(drawings, "#[0-9a-f]{6}|rgb\\(|font-family|font:|'DejaVu")
        used = set(re.findall(r"var\(--([a-z0-9]+)\)", drawings))
        self.assertEqual(used, {"page", "ink", "muted", "rule"} | {f"s{place}" for place in range(7)})
        light, dark = full_page().split("@media (prefers-color-scheme: dark)", 1)
        for name in used:
            self.assertIn(f"--{name}: #", light)
            self.assertIn(f"--{name}: #", dark.split("}", 1)[0])

    def test_the_page_of_a_small_sweep_has_its_facts_and_says_what_is_missing(self):
        sweep = Sweep(1, 2)
        experiment = make_experiment(sweep.rows, sweep.systems, [], None)
        page = page_of(experiment)
        self.check_markup(page)
        text = "".join(ET.fromstring(page).itertext())
        for fact in main_facts(experiment, Summary(experiment)):
            self.assertIn(fact.headline, text)
            self.assertIn(fact.sentence, text)
        self.assertIn("2 systems were given 54 Boolean problems of 1 family, each", text)
        self.assertIn("not recorded: there was no machine.json", text)
        self.assertIn("no family was run in more than one size", text)
        self.assertNotIn('class="alarm"', page)

    def test_pages_of_one_row_and_without_ours(self):
        for system in "ours", "a":
            for verdict in "same", "refused", "unjudged":
                page = page_of(make_experiment([right_row(system, "f", verdict=verdict)], [], [], None))
                self.check_markup(page)
                self.assertIn("1 system was given 1 Boolean problem of 1 family", page)
                self.assertIn("No run failed." if verdict != "refused" else "1 refused", page)

    def test_verdicts_are_counted_by_family_and_in_all(self):
        root = ET.fromstring(full_page())
        experiment = experiment_of(Sweep(15, 7))
        cells = [cell.get("title") for cell in root.iter() if cell.get("class") == "tally"]
        self.assertEqual(len(cells), 7 * 16)
        for place, system in enumerate(experiment.system):
            rows = [row for row in experiment.rows if row["system"] == system]
            for cell, among in ((cells[place], [row for row in rows if row["family"] == "face"]),
                                (cells[-7 + place], rows)):
                counts = {part.split(" ", 1)[1]: int(part.split(" ")[0].replace(",", ""))
                          for part in cell.replace(", ", ";").split(";")}
                self.assertEqual(counts, {verdict.replace("-", " "): [row["verdict"] for row in among].count(verdict)
                                          for verdict in {row["verdict"] for row in among}})

    def test_hostile_texts_stay_texts(self):
        sweep = Sweep(8, 3)
        for row in sweep.rows:
            if row["system"] != "ours":
                row.update(stage=HOSTILE, message=HOSTILE, command=HOSTILE)
                # Right somewhere, so that the system's name is in figures of all kinds.
                row["verdict"] = "same" if row["family"] == "menger" or row["distance"] == 3 else "refused"
        sweep.rows[-1]["truth"] = sweep.rows[-1]["truth"] | {"confirmed": "DISAGREES", "reason": HOSTILE}
        sweep.rows[-1]["confirmation"] = {"by": "DISPUTED", "reason": HOSTILE}
        sweep.systems[1]["title"] = "_<b>&'x'\"{}$^_@%"
        sweep.systems[2].update(guarantee=HOSTILE, version=HOSTILE, absent=HOSTILE)
        sweep.families[0]["title"] = sweep.machine["cpu"] = sweep.machine["commit"] = HOSTILE
        sweep.machine["left_out"] = [[HOSTILE, HOSTILE]]
        for row in sweep.rows:
            row["family"] = "../<b>\"" if row["family"] == "menger" else row["family"]
        experiment = experiment_of(sweep)
        page = page_of(experiment)
        markup = self.check_markup(page)
        self.assertEqual(markup.tags.count("script"), 2)
        self.assertEqual(page.count('alert("1")'), 0)
        self.assertNotIn("img", markup.tags)
        self.assertNotIn("b>&'x'", page)
        self.assertIn("{{ 7 * 7 }}", page)
        root = ET.fromstring(page)
        self.assertIn("_<b>&'x'\"{}$^_@%", [element.text for element in root.iter("{http://www.w3.org/2000/svg}text")])
        self.assertIn("The truth is disputed for 1 problem", page)
        self.assertIn(HOSTILE.replace("\x01", "\ufffd").replace("\ufffe", "\ufffd"), "".join(root.itertext()))
        data = runs_data(page)
        self.assertEqual(len(data["rows"]), len(experiment.rows))
        self.assertIn(HOSTILE, {row[8] for row in data["rows"]})

    def test_twenty_disputed_problems_are_named_and_the_others_counted(self):
        rows = [right_row("ours", "f", 1, seed) for seed in range(1, 24)]
        for row in rows:
            row["truth"] = row["truth"] | {"confirmed": "DISAGREES", "reason": "Nef has volume 7"}
        page = page_of(make_experiment(rows, [], [], None))
        self.assertIn("The truth is disputed for 23 problems", page)
        alarm = page.split('class="alarm"')[1].split("</div>")[0]
        self.assertEqual(alarm.count("<li><code>"), 20)
        self.assertIn("<li>and 3 others</li>", alarm)

    def test_disputed_verdicts_are_named_and_confirmed_ones_counted(self):
        rows = [right_row("ours", "f", 1, 1), right_row("ours", "f", 1, 2),
                right_row("nef", "f", 1, 1, asserted_seconds=2.5, seconds=2.0,
                          confirmation={"by": "DISPUTED", "reason": "integrals: <7>"})]
        page = page_of(make_experiment(rows, [], [], None))
        self.check_markup(page)
        self.assertIn("The verdict is disputed for 1 row", page)
        self.assertIn("<li><code>f-union-s1-r1 nef</code> same; integrals: &lt;7&gt;</li>", page)
        section = page.split('<section id="confirmed-rows">')[1].split("</section>")[0]
        counts = {name: re.findall(r'<td[^>]*>([0-9]+)<', section.split(f'scope="row">{name}<')[1].split("</tr>")[0])
                  for name in ("integrals", "DISPUTED", "none")}
        self.assertEqual(counts, {"integrals": ["2", "0"], "DISPUTED": ["0", "1"], "none": ["0", "0"]})
        self.assertIn("on for verdicts, off for times; on takes 1.25 × the time", page)

    def test_all_runs_are_in_the_page_each_with_its_command(self):
        experiment = experiment_of(Sweep(2, 3))
        data = runs_data(page_of(experiment))
        self.assertEqual(len(data["rows"]), len(experiment.rows))
        for shown, row in zip(data["rows"], experiment.rows):
            self.assertEqual((shown[0], shown[3], shown[7], shown[8]),
                             (row["problem"], row["stage"], row["message"], row["command"]))
            self.assertEqual(experiment.systems[shown[1]]["name"], row["system"])
            self.assertEqual(data["verdicts"][shown[2]], row["verdict"])


class Json(unittest.TestCase):
    def test_the_json_holds_the_aggregates_and_all_rows(self):
        rows = []
        for seed in range(1, 5):
            for k in 2, 9:
                rows.append(at_distance(right_row("ours", "edge", 1, seed), k))
                rows.append(at_distance(right_row("nef", "edge", 1, seed), k, seconds=2.0 * seed))
                if (k, seed) == (9, 1):
                    rows[-1].update(verdict="wrong", stage="finishing", message="twice")
        for size in 1, 10, 100:
            rows.append(right_row("ours", "boxes", size, seconds=0.01 * size * size, own_bytes=5000 * size,
                                  exact_share=0.01))
        rows[0]["facts"] = copy.deepcopy(rows[0]["truth"]["facts"])
        rows[1]["facts"] = rows[1]["truth"]["facts"] | {"genus": 1}
        machine = Sweep(1, 1).machine | {"commit": "a1"}
        experiment = make_experiment(rows, [], [], machine)
        text = report_json(experiment, Summary(experiment), "t")
        report = json.loads(text)
        self.assertEqual(list(report), ["schema", "title", "machine", "systems", "families", "facts", "aggregates",
                                        "truths", "rows"])
        self.assertEqual((report["schema"], report["title"], report["machine"]), (1, "t", machine))
        self.assertEqual([system["name"] for system in report["systems"]], ["ours", "nef"])
        self.assertEqual(report["facts"][0]["headline"], "11 of 11")
        every = report["aggregates"]
        self.assertEqual(every["problems"], 11)
        nef = every["totals"]["nef"]
        self.assertEqual((nef["failures"], nef["failure_rate"], nef["verdicts"]["wrong"]), (1, 0.125, 1))
        edge = next(family for family in every["families"] if family["family"] == "edge")
        self.assertEqual(edge["systems"]["ours"]["verdicts"]["same"], 8)
        stage = every["stages"][0]
        self.assertEqual((stage["stage"], stage["example"], stage["message"]),
                         ("finishing", "edge-union-s1-k9-r1", "twice"))
        curve = every["distances"]["all"]["systems"][1]
        self.assertEqual((curve["system"], curve["fails_from"], curve["worst_at"]), ("nef", 9, 9))
        self.assertEqual(curve["points"][1]["failure_rate"], 0.25)
        self.assertIsNone(every["distances"]["all"]["systems"][0]["fails_from"])
        growth = every["growth"][0]
        self.assertEqual(growth["family"], "boxes")
        self.assertAlmostEqual(growth["systems"][0]["time"]["exponent"], 2)
        self.assertAlmostEqual(growth["systems"][0]["memory"]["exponent"], 1)
        # Ratios 2, 4, 6, 8 and, without the wrong one, 4, 6, 8: sorted 2, 4, 4, 6, 6, 8, 8.
        time = every["ratios"][0]["time"]
        self.assertEqual((time["count"], time["lower_quartile"], time["median"], time["upper_quartile"]),
                         (7, 4, 6, 7))
        self.assertAlmostEqual(every["exact_share"]["median"], 0.01)
        self.assertEqual(every["truth"]["Nef"], 11)
        self.assertEqual(every["confirmed_rows"]["integrals"], {"ours": 11, "nef": 8})
        self.assertEqual(every["assertions"], {})
        self.assertEqual(len(report["rows"]), len(rows))
        for row, said in zip(experiment.rows, report["rows"]):
            truth = report["truths"][row["problem"]]
            facts = truth["facts"] if said["facts"] == "exact" else said["facts"]
            self.assertEqual(said | {"facts": facts, "truth": truth}, row)
        self.assertEqual([row["facts"] for row in report["rows"]].count("exact"), 1)
        self.assertEqual(text.count("\n"), 1 + 11 + 1 + len(rows) + 1)  # a line per truth and per row
