"""What is measured, and the fields of the blocks of pages (blocks.txt) that it makes.

A measurement reads values of what its command prints, or of a file that it writes; they are kept in
bench/measured.json and are small: numbers, and rows of tables as text with ` | ` between cells. Fields are these
values, and for some blocks what is derived of them.
"""
import json
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from statistics import median, quantiles
from typing import Callable


@dataclass
class Measurement:
    name: str
    command: str
    read: Callable          # of the text to values
    output: str = ""        # the file that is read in place of what the command prints
    long: bool = False      # minutes, or data and programs that a clone does not have


def piped(rows):
    return "\n".join(f"| {row if isinstance(row, str) else ' | '.join(map(str, row))} |" for row in rows)


def fields_of(entry):
    return entry["values"] | {"rows": piped(entry["values"].get("rows", [])), "commit": entry["commit"],
                              "by": f"`{entry['command']}` at `{entry['commit']}`."}


def span(values, digits=2):
    """From the least to the most, as `0.5 to 0.8`."""
    low, high = (f"{v:.{digits}g}" for v in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def percent(part):
    return f"{100 * part:.{2 if part < 0.995 else 3}g} %"


def cells(row):
    return [cell.strip() for cell in row.split("|")]


def printed_rows(place, columns=None):
    """Reads the rows of a table in Markdown, the first one being 0: all columns or some."""
    def read(text):
        tables = re.findall(r"^\|.*\n\|[-| ]+\|\n((?:\|.*\n)*)", text, re.M)
        rows = [cells(line[1:-1]) for line in tables[place].splitlines()]
        return {"rows": [" | ".join(c for i, c in enumerate(row) if columns is None or i in columns) for row in rows]}
    return read


# --- whole jobs

SYSTEMS = ("cnrg", "manifold", "trueform", "CGAL corefinement")  # the columns


def seconds_of(case, system):
    return next((row["seconds"] for row in case["rows"] if row["system"] == system and row.get("seconds")), None)


def whole_jobs(kept):
    def time_of(case, system):
        times = [seconds_of(case, system + end) for end in (", 2 threads", ", 1 thread", "")]
        return " / ".join(f"{m:.2g}" if m < 99.5 else f"{m:.0f}" for m in map(median, filter(None, times)))
    cases = [case for case in kept.cases if "rows" in case]
    runs = [row["seconds"] for case in cases for row in case["rows"] if row["system"].startswith("cnrg")]
    return {"rows": piped([f"`{c['name']}`", *(time_of(c, s) for s in SYSTEMS), f"`{c['commit']}`"] for c in cases),
            "apart": percent(max(abs(q / median(r) - 1) for r in runs if r[1:] for q in quantiles(r, method="inclusive")))}


def read_nef(text):
    cases = {case["name"]: case for case in json.loads(text)}
    mine = {n: next(r for r in c["rows"] if r["system"] == "cnrg, 1 thread") for n, c in cases.items()}

    def slower(system, *names):
        found = [(median(mine[n]["seconds"]), seconds_of(cases[n], system)) for n in names]
        return [median(theirs) / ours for ours, theirs in found if theirs]
    pairs = [name for name, case in cases.items() if case["group"] == "pairs" and case["triangles"] > 199000]
    cost = [median(mine[n]["seconds"]) / (c["input_cells"] + mine[n]["cells"])
            for n, c in cases.items() if c["group"] == "growth"]
    return {"pairs": len(pairs), "corefinement": [1 / r for r in slower("CGAL corefinement", *pairs)],
            "nef": slower("CGAL Nef", *pairs), "bytes": [mine[n]["own_bytes"] / cases[n]["triangles"] for n in pairs],
            "spheres": slower("CGAL Nef", "spheres64"), "boxes": slower("CGAL Nef", "boxes200"),
            "one_by_one": slower("Nef, one by one", "boxes200"), "growth": max(cost) / min(cost)}


def nef(kept):
    fields = fields_of(kept["speed-nef"])

    def part(name):
        return " to ".join(dict.fromkeys(f"1/{x:.0f}" for x in (min(fields[name]), max(fields[name]))))
    return fields | {name: part(name) for name in ("nef", "spheres", "boxes", "one_by_one")} | {
        "corefinement": span(fields["corefinement"]), "bytes": span(fields["bytes"], 3)}


# --- real models

FOLDERS = {"mixed_dim": "networks of mixed dimension", "geology": "geology", "robust": "robustness"}
COUNTS = ("files", "left out", "refused", "as is", "snapped", "joined", "out of time")


def read_counts(text):
    rows = json.loads(text).values()
    outcome = Counter("left out" if "left_out" in r else re.sub(" at .*|: .*", "", r["outcome"]) for r in rows)
    filled = [r for r in rows if "bad" in r]
    return {"files": len(rows), **{what: outcome[what] for what in (*COUNTS[1:], "FAILED")},
            "tetrahedra": sum(r["tetrahedra"] for r in filled), "bad": sum(r["bad"] for r in filled)}


def conserved(way):
    def shape(v):
        return f"{100 * v['bad'] / v['tetrahedra']:.2f} % of {v['tetrahedra']:,}" if v.get("tetrahedra") else ""

    def fields(kept):
        entries = [(title, kept[f"conserve-{folder}{way}"]) for folder, title in FOLDERS.items()]
        return {"command": entries[0][1]["command"].split(" --json")[0].replace("mixed_dim", "..."),
                "rows": piped([title, *(e["values"][c] for c in COUNTS), *([] if way else [shape(e["values"])]),
                               f"`{e['commit']}`"] for title, e in entries)}
    return fields


def read_crust(text):
    row, = json.loads(text).values()
    return {key: row[key] for key in ("tetrahedra", "bad", "mesh")}


def crust(kept):
    fields = fields_of(kept["conserve-crust"])
    return fields | {"share": percent(fields["bad"] / fields["tetrahedra"])}


def beside_gmsh(kept):
    """Of the six networks, which come first in the table: a row of ours and one of fragments each."""
    rows = [cells(row) for row in kept["meshes"]["values"]["rows"]]
    pairs = [(a, b) for a, b in zip(rows, rows[1:]) if a[1] == "ours" and b[1] == "Gmsh, fragments"][:6]
    time, worst, middle = ([(float(a[i]), float(b[i])) for a, b in pairs] for i in (2, 4, 5))
    return fields_of(kept["meshes"]) | {
        "time": span([a / b for a, b in time]), "theirs": span([b for _, b in middle]), "models": len(pairs),
        "ours": span([a for a, _ in middle]), "worst": sum(b > a for a, b in worst)}


# --- Mäntylä

RULES = "sides single arcs pairs order nearest rings curves checks".split()


def tallies(line):
    """`double, right 59, connecting 1  exact, same 60` to {"double": {"right": 59, "connecting": 1}, ...}."""
    found = {}
    for part in line.strip().split("  "):
        words = [re.fullmatch(r"(.*?)(?: (\d+))?", word).groups() for word in part.split(", ")]
        name = ", ".join(word for word, count in words if count is None)
        found[name] = Counter({word: int(count) for word, count in words if count is not None})
    return found


def read_near(text):
    columns, pairs = [], set()
    for k, line in re.findall(r"^k (\d+):(.*)$", text, re.M):
        checked, free = (tallies(line)[name] for name in ("double", "double, no checks"))
        pairs.add(sum(checked.values()))
        failures = sum(n for word, n in checked.items() if word not in ("right", "within 1e-6", "wrong"))
        if failures:
            columns.append((k, failures, free["right"] - checked["right"], free["wrong"]))
    titles = ("k", "failures", "of these, without `checks`: right", "wrong, unsaid")
    return {"rows": [" | ".join(map(str, (title, *row))) for title, row in zip(titles, zip(*columns))],
            "pairs": min(pairs)}


def near(kept):
    head, *rows = kept["mantyla-near"]["values"]["rows"]
    return fields_of(kept["mantyla-near"]) | {"rows": piped([head]) + "\n" + "|---" * len(cells(head)) + "|\n" + piped(rows)}


def read_folds(text):
    counts = re.findall(r"^(\d+)  (\w+)", text, re.M)
    return {"steps": sum(int(n) for n, _ in counts), "failed": sum(int(n) for n, what in counts if what != "same")}


def read_rules(text):
    totals = re.findall(r"^(baseline|published) (\w+) (\d+)$", text, re.M)
    published = Counter({what: int(n) for who, what, n in totals if who == "published"})
    changes = {}
    for who, name, line in re.findall(r"^(baseline -|published \+)(\w+):(.*)$", text, re.M):
        found = re.findall(r"(\w+ to \w+) (\d+)", line)
        changes[name, who[0]] = Counter({change: int(n) for change, n in found})

    def count(rule, who, before, after):
        return sum(changes[rule, who][f"{b} to {a}"] for b in before for a in after)
    failed, right, wrong, refused = ("wrong", "refused"), ("same",), ("wrong",), ("refused",)
    rows = [(f"`{rule}`", count(rule, "b", failed, right), count(rule, "p", failed, right),
             count(rule, "p", right, failed)) for rule in RULES]
    return {"problems": sum(published.values()), "right": published["same"], "wrong": published["wrong"],
            "ended": published["refused"], "nearest": count("nearest", "p", wrong, refused),
            "baseline": sum(int(n) for who, what, n in totals if (who, what) == ("baseline", "same")),
            "checks": [count("checks", "p", before, refused) for before in (wrong, right)],
            "rows": [" | ".join(map(str, row)) for row in rows]}


def rights(tally):
    return tally["judged"] - tally["failures"]


def read_departures(text):
    totals = json.loads(text)["aggregates"]["totals"]
    names = {"baseline": "mantyla-double", "published": "mantyla-published", "shells": "mantyla-published+shells"}
    return {what: rights(totals[name]) for what, name in names.items()} | {"problems": totals["mantyla-double"]["judged"]}


def read_report(text):
    report = json.loads(text)
    a = report["aggregates"]
    ratios = {r["system"]: r for r in a["ratios"]}
    curves = {c["system"]: c for c in a["distances"]["all"]["systems"]}

    def failing(curve):
        rates = {p["distance"]: p["failure_rate"] for p in curve["points"]}
        begin = curve["fails_from"]
        start = "never" if begin is None else "exact" if begin == "exact" else f"10<sup>-{begin}</sup>"
        return start, percent(rates[curve["worst_at"]])

    def row(system):
        name, tally = system["name"], a["totals"][system["name"]]
        verdicts = tally["verdicts"]
        ratio = [f"{ratios[name][what]['median']:.3g}" for what in ("time", "memory")] if name in ratios else ("1", "1")
        return [system["title"], verdicts["same"], rights(tally) - verdicts["same"], verdicts["wrong"], verdicts["refused"],
                verdicts["timed-out"], *(failing(curves[name]) if name in curves else ("", "")), *ratio]
    systems = [s for s in report["systems"] if s["name"] in a["totals"]]
    return {"rows": [" | ".join(map(str, row(s))) for s in systems], "problems": a["problems"], "systems": len(systems),
            "families": len(a["families"]), "runs": sum(t["runs"] for t in a["totals"].values()),
            "nef": a["truth"].get("Nef", 0)}


# --- growth

GROWING = {"crossings": ("n sheets across n, n² crossings", lambda n: f"{n * n:,}"),
           "regions": ("(n + 1)³ closed regions", lambda n: f"{(n + 1) ** 3:,}"),
           "inside": ("vertices of a ball in a block", lambda n: f"{n * n // 2 - n + 2:,}"),
           "overlap": ("part of the faces that overlap", lambda n: "1" if n == 16 else f"{n}/16"),
           "degree": ("of two surfaces, in both directions", str)}


def milliseconds(points):
    times = [1000 * p["seconds"] for p in points]
    return span(times) if max(times) < 99.5 else " to ".join(f"{t:,.0f}" if t >= 99.5 else f"{t:.2g}" for t in times)


def read_growth(text):
    a = json.loads(text)["aggregates"]
    ends = {(study["family"], curve["system"]): (curve["points"][0], curve["points"][-1])
            for study in a["growth"] for curve in study["systems"]}
    rows = [[f"`{name}`: {title}", *(size(p["size"]) for p in ends[name, "ours"]), milliseconds(ends[name, "ours"]),
             milliseconds(ends[name, "ours-tree"]), span([p["own_bytes"] / 1e6 for p in ends[name, "ours-tree"]])]
            for name, (title, size) in GROWING.items()]
    return {"rows": [" | ".join(row) for row in rows], "problems": a["problems"], "nef": a["truth"].get("Nef", 0)}


BASELINE = "CNRG_SEEDS={} build/release/tests/test_baseline \"{}\""
CONSERVE = "bench/run conserve FOLDER/{} --count{} --seconds {} --json out/{}.json"
SOME = "ours,nef,occt-rescaled,mantyla-exact,openscad-rescaled,corefinement,mantyla-double"
MEASUREMENTS = [
    Measurement("keyser-errors", "python3 papers/keyser2004/measure.py PROGRAM", printed_rows(0)),
    Measurement("keyser-distances", "python3 papers/keyser2004/measure.py PROGRAM", printed_rows(1)),
    Measurement("keyser-curved", "python3 papers/keyser2004/curved.py PROGRAM", printed_rows(0)),
    Measurement("keyser-coincidences", "python3 papers/keyser2004/coincidences.py PROGRAM", printed_rows(0), long=True),
    Measurement("mantyla-folds", BASELINE.format(2000, "hunt with folds on the grid"), read_folds),
    Measurement("mantyla-near", "CNRG_FIRST_SEED=50000 " + BASELINE.format(600, "hunt near the grid"), read_near),
    Measurement("mantyla-rules", BASELINE.format(3000, "hunt for departures"), read_rules),
    Measurement("mantyla-departures", "bench/run departures --out out/departures", read_departures,
                "out/departures/report.json", True),
    Measurement("mantyla-report", f"bench/run all --limit 900 --seconds 20 --systems {SOME} --out out/full", read_report,
                "out/full/report.json", True),
    Measurement("pereira-growth", f"bench/run {' '.join(GROWING)} --out out/growth", read_growth,
                "out/growth/report.json", True),
    Measurement("pereira-groups", "/usr/bin/python3 tests/formats/supported_tunnel.py PROGRAM $(mktemp -d)",
                printed_rows(0)),
    Measurement("speed-nef", "bench/run speed pairs growth spheres64 boxes200 --meshes FOLDER --json out/nef.json",
                read_nef, "out/nef.json", True),
    Measurement("meshes", "bench/run meshes FOLDER", printed_rows(0, (0, 1, 2, 3, 4, 5, 8, 11)), long=True),
    *(Measurement(f"conserve-{folder}{way}", CONSERVE.format(folder, way.replace("-", " --"), 60, folder + way),
                  read_counts, f"out/{folder}{way}.json", True) for way in ("", "-surface") for folder in FOLDERS),
    Measurement("conserve-crust", CONSERVE.format("geology/scec_cfm53_PNRA --together", "", 900, "crust"), read_crust,
                "out/crust.json", True),
]
DERIVED = {"readme": nef, "whole-jobs": whole_jobs, "speed-nef": nef, "conserve": conserved(""), "mantyla-near": near,
           "conserve-surface": conserved("-surface"), "conserve-crust": crust, "meshes-gmsh": beside_gmsh}
TEMPLATES = dict(re.findall(r"^== (\S+)\n((?:(?!== ).*\n)*)", (Path(__file__).parent / "blocks.txt").read_text(), re.M))


def block(name, kept):
    fields = DERIVED[name](kept) if name in DERIVED else fields_of(kept[name])
    return TEMPLATES[name].rstrip("\n").format_map(fields)
