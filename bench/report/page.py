"""The page: the templates page.html.j2, style.css and script.js, filled with the summary. It is one file that loads
nothing and is well-formed XML; texts of rows are escaped by the templates, always."""
import json
import math
import re
from pathlib import Path

import words
from facts import main_facts
from figures import SERIES, VARIABLES, clean, for_page, label
from rows import CLASS_OF, VERDICTS
from summary import Tally

MEANINGS = {
    "same": "The exact point set, of a system that rounds up to the rounding that it states, each contact once.",
    "same-regularized": "The closure of the interior: what the operation makes of lower dimension is missing.",
    "contact-duplicated": "The point set, but edges or vertices at a non-manifold contact are there twice or more. "
                          "A contact in the interior of a face is not told apart.",
    "contact-lost": "Parts that touch in the exact result do not, or the other way round, for coordinates were "
                    "rounded.",
    "dangling-lost": "A surface, wire or point of an operand that the exact result has is missing.",
    "within-rounding": "As much volume, up to the rounding that the system states, but with other shells or handles.",
    "wrong": "Anything else: volume or surface too much or too little, or no solid at all, and no word of it.",
    "refused": "The system says that it cannot.",
    "crashed": "The process ended by itself without a result, by a signal or otherwise.",
    "timed-out": "No result within the limit of time.",
    "out-of-memory": "No result within the limit of memory.",
    "unjudged": "There is a result, but the exact one could not be had within the limits. No rate counts it."}
COUNTS_AS = {"exact": "same", "right": "right by another contract", "wrong": "failed: wrong, unsaid",
             "refused": "failed: says so", "no result": "failed: no result", "unjudged": "nothing"}
CONFIRMS = {"Nef": "Nef polyhedra have our result as a point set, exactly; CGAL alone compared.",
            "Nef-by-us": "Nef polyhedra have the same point set, exactly; our kernel compared.",
            "node": "Another node, which the experiment claims to be the same, gives the same point set.",
            "formula": "The volume is that of the experiment's formula, exactly.",
            "volume": "The volume agrees with corefinement to 10⁻⁹.",
            "none": "None was possible.", "DISAGREES": "One of them has another result."}

CONFIRMS_ROW = {
    "Nef": "CGAL compared the result with that of Nef polyhedra, exactly.",
    "integrals": "The volume of the difference of result and Boolean, by exact integrals over the triangles of operands and "
                 "result, is zero, or within the rounding, or it is not, as the verdict says; or the faces are not closed.",
    "points": "256 random exact points, a half of them near faces, are in result and Boolean, or in none; or one is not, as "
              "the verdict says.",
    "none": "None could.",
    "DISPUTED": "One contradicts the verdict.",
    "no-verdict": "There is no verdict on a result."}


def assertions_text(spread):
    return (f"on for verdicts, off for times; on takes {words.three_digits(spread.median)} × the time (quartiles "
            f"{words.three_digits(spread.lower)}–{words.three_digits(spread.upper)}, n {words.grouped(spread.count)})"
            if spread else words.NONE)


def spoken(tally):
    return ", ".join(f"{words.grouped(tally[v])} {v.replace('-', ' ')}" for v in VERDICTS if tally[v])


def rounding_text(rounding):
    if rounding == 0:
        return "exact"
    exponent = math.floor(math.log10(rounding) + 1e-9)
    factor = rounding / 10.0 ** exponent
    times = "" if abs(factor - 1) < 5e-3 else words.three_digits(factor) + " × "
    return f"{times}{words.power_of_ten(exponent)} of the largest coordinate"


def limit_text(limits, text, unit):
    """Of (least, most); 0 is none."""
    least, most = limits
    if most == 0:
        return "none"
    if least == most:
        return f"{text(most)} {unit}"
    return f"{text(least) if least else 'none'} to {text(most)} {unit}"


def runs_json(experiment):
    """Rows as lists, names by their places: a page of 20,000 rows stays small. The script shows them on demand. No
    character of it ends the element that it is in, or is none of XML."""
    verdicts = {verdict: place for place, verdict in enumerate(VERDICTS)}
    rows = [[row["problem"], experiment.place[row["system"]], verdicts[row["verdict"]], row["stage"],
             words.three_digits(row["seconds"]), words.megabytes(row["own_bytes"]),
             words.megabytes(row["peak_bytes"]), row["message"], row["command"]] for row in experiment.rows]
    text = json.dumps({"rows": rows, "systems": [label(experiment, system) for system in experiment.system],
                       "verdicts": VERDICTS}, ensure_ascii=False, separators=(",", ":"))
    units = lambda c: "".join(f"\\u{u}" for u in c[0].encode("utf-16-be", "surrogatepass").hex(" ", 2).split())
    return re.sub(f"[<>&{words.HOSTILE}]", units, text)


def page_html(experiment, summary, title, figures, svgs, folder=""):
    """`svgs`: the drawn figures by their names; `folder`: where their files are, if they are written."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    from markupsafe import Markup

    def text_of(value):
        return clean(value) if isinstance(value, str) and not hasattr(value, "__html__") else value

    def power(law):
        return (f"{words.exponent_text(law.exponent)} ± {words.exponent_text(law.error)}" if law else words.NONE)

    environment = Environment(loader=FileSystemLoader(Path(__file__).resolve().parent), autoescape=True,
                              finalize=text_of, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters |= {name: getattr(words, name) for name in
                            ("grouped", "percent", "three_digits", "megabytes", "plural")}
    environment.globals |= {
        "e": experiment, "s": summary, "figures": figures, "folder": folder, "facts": main_facts(experiment, summary),
        "runs": Markup(runs_json(experiment)), "variables": VARIABLES, "colours": len(SERIES),
        "verdicts": VERDICTS, "class_of": CLASS_OF, "counts_as": COUNTS_AS, "meanings": MEANINGS,
        "confirms": CONFIRMS, "confirms_row": CONFIRMS_ROW, "assertions_text": assertions_text, "none": words.NONE, "spoken": spoken, "power": power, "rounding_text": rounding_text,
        "label": lambda system: label(experiment, system), "sum_of": lambda tallies: sum(tallies, Tally()),
        "svg": lambda figure: Markup(for_page(svgs[figure.name], figure)),
        "time_limit": limit_text(summary.limit_seconds, lambda x: f"{x:g} s", "of wall time per run"),
        "memory_limit": limit_text(summary.limit_bytes, lambda x: words.megabytes(x) + " MB",
                                   "of address space per run")}
    return environment.get_template("page.html.j2").render(title=title)
