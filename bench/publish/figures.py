"""What is measured, and the blocks of pages that it makes.

A measurement reads values of what its command prints, or of a file that it writes; values are kept in
bench/measured.json and are small: numbers, and rows of tables as text with ` | ` between cells. A block makes Markdown
of what is kept, times included: nobody writes figures by hand.
"""
import json
import re
from collections import Counter
from dataclasses import dataclass, field
from statistics import median, quantiles
from typing import Callable


@dataclass
class Measurement:
    name: str
    command: str
    read: Callable          # of the text to values
    output: str = ""        # the file that is read in place of what the command prints
    long: bool = False      # more than a minute, or programs that Debian does not have
    environment: dict = field(default_factory=dict)


def table(head, rows):
    rows = [row if isinstance(row, str) else " | ".join(map(str, row)) for row in rows]
    return "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|", *(f"| {row} |" for row in rows)])


def by(entry):
    return f"`{entry['command']}` at `{entry['commit']}`."


def span(values, digits=2):
    """From the least to the most, as `0.5 to 0.8`."""
    low, high = (f"{v:.{digits}g}" for v in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def cells(row):
    return [cell.strip() for cell in row.split(" | ")]


# --- tables that commands print

def printed_rows(place, columns=None):
    """Reads the rows of a table in Markdown, the first one being 0: all columns or some."""
    def read(text):
        tables = re.findall(r"^\|.*\n\|[-| ]+\|\n((?:\|.*\n)*)", text, re.M)
        rows = [line[1:-1].split("|") for line in tables[place].splitlines()]
        return {"rows": [" | ".join(c.strip() for i, c in enumerate(row) if columns is None or i in columns) for row in rows]}
    return read


def plain(name, *head, after="\n\n{by}"):
    return lambda kept: table(head, kept[name]["values"]["rows"]) + after.format(by=by(kept[name]))


# --- whole jobs

def seconds_of(case, system):
    return next((row["seconds"] for row in case["rows"] if row["system"] == system and row.get("seconds")), None)


def whole_jobs(kept):
    def time_of(case, system):
        times = [seconds_of(case, system + end) for end in (", 2 threads", ", 1 thread", "")]
        return " / ".join(f"{median(t):.{0 if median(t) >= 99.5 else 2}{'f' if median(t) >= 99.5 else 'g'}}" for t in times if t)
    systems = {"ours": "cnrg", "Manifold": "manifold", "trueform": "trueform", "corefinement": "CGAL corefinement"}
    cases = [case for case in kept.cases if "rows" in case]
    runs = [sorted(row["seconds"]) for case in cases for row in case["rows"] if row["system"].startswith("cnrg") and row["seconds"][1:]]
    apart = max(abs(quartile / median(r) - 1) for r in runs for quartile in quantiles(r, method="inclusive"))
    return table(["case", *systems, "commit"], [[f"`{c['name']}`", *(time_of(c, s) for s in systems.values()), f"`{c['commit']}`"]
                                                for c in cases]) + f"\n\nQuartiles of ours are within {100 * apart:.0f} % of the median."


def beside_corefinement(kept):
    entry = kept["speed-nef"]
    return (f"Two meshes of 100,000 triangles each are united in {span(entry['values']['corefinement'])} of the time of CGAL's "
            f"corefinement, with one thread each, at `{entry['commit']}`: [all figures](bench/README.md#what-was-measured).")


def read_nef(text):
    cases = {case["name"]: case for case in json.loads(text)}
    mine = {name: next(r for r in case["rows"] if r["system"] == "cnrg, 1 thread") for name, case in cases.items()}

    def slower(system, names):
        found = [seconds_of(cases[n], system) for n in names]
        return [median(t) / median(mine[n]["seconds"]) for n, t in zip(names, found) if t]
    pairs = [name for name, case in cases.items() if case["group"] == "pairs" and case["triangles"] > 199000]
    cost = [median(mine[n]["seconds"]) / (c["input_cells"] + mine[n]["cells"]) for n, c in cases.items() if c["group"] == "growth"]
    return {"pairs": len(pairs), "corefinement": [1 / r for r in slower("CGAL corefinement", pairs)],
            "nef": slower("CGAL Nef", pairs), "bytes": [mine[n]["own_bytes"] / cases[n]["triangles"] for n in pairs],
            "spheres": slower("CGAL Nef", ["spheres64"]), "boxes": slower("CGAL Nef", ["boxes200"]),
            "boxes one by one": slower("Nef, one by one", ["boxes200"]), "growth": max(cost) / min(cost)}


def nef(kept):
    v = kept["speed-nef"]["values"]

    def part(values):
        return " to ".join(dict.fromkeys(f"1/{x:.0f}" for x in (min(values), max(values))))
    rows = [(f"{v['pairs']} pairs of meshes of 100,000 triangles each", f"{span(v['corefinement'])} of corefinement, {part(v['nef'])} "
             f"of Nef polyhedra; {span(v['bytes'], 3)} bytes per triangle"),
            ("64 overlapping spheres", part(v["spheres"]) + " of Nef"),
            ("200 integer boxes", f"{part(v['boxes'])} of Nef with all operands at once, {part(v['boxes one by one'])} one after the other"),
            ("10,000 to 1,000,000 triangles per operand", f"time per cell within {v['growth']:.3g} times")]
    return table(["one thread each", "time"], rows) + "\n\n" + by(kept["speed-nef"])


# --- real models

KINDS = {"mixed_dim": "networks of mixed dimension", "geology": "geology", "robust": "robustness"}


def read_counts(text):
    rows = json.loads(text).values()
    outcome = Counter("left out" if "left_out" in r else r["outcome"].split(" ")[0] for r in rows)
    filled = [r for r in rows if "bad" in r]
    return {"files": len(rows), "left out": outcome["left out"], "refused": outcome["refused"] + outcome["refused:"],
            "as is": outcome["as"], "snapped": outcome["snapped"], "joined": outcome["joined"], "out of time": outcome["out"],
            "failed": outcome["FAILED"], "tetrahedra": sum(r["tetrahedra"] for r in filled), "bad": sum(r["bad"] for r in filled)}


def counts_of(kept, way, columns, shapes):
    entries = [(title, kept[f"conserve-{folder}{way}"]) for folder, title in KINDS.items()]

    def shape(v):
        return f"{100 * v['bad'] / v['tetrahedra']:.2f} % of {v['tetrahedra']:,}" if v.get("tetrahedra") else ""
    rows = [[title, *(e["values"][c] for c in columns), *([shape(e["values"])] if shapes else []), f"`{e['commit']}`"]
            for title, e in entries]
    command = entries[0][1]["command"].split(" --json")[0].replace("mixed_dim", "...")
    return table(["folders", *columns, *(["shapes below 0.1"] if shapes else []), "commit"], rows) + f"\n\n`{command}`"


COUNTS = ("files", "left out", "refused", "as is", "snapped", "joined", "out of time")


def read_crust(text):
    row, = json.loads(text).values()
    return {key: row[key] for key in ("tetrahedra", "bad", "mesh")}


def crust(kept):
    v = kept["conserve-crust"]["values"]
    return (f"The 97 faults of `scec_cfm53_PNRA` in one crust box: {v['tetrahedra']:,} tetrahedra, {100 * v['bad'] / v['tetrahedra']:.2g} % "
            f"with a shape below 0.1, in {v['mesh']:.0f} seconds. TetGen stops by a fault of its own; these are constrained tetrahedra, "
            f"improved. {by(kept['conserve-crust'])}")


def beside_gmsh(kept):
    """The six networks come first in the table; rows of ours and of fragments take turns there."""
    rows = [cells(row) for row in kept["meshes"]["values"]["rows"]]
    pairs = [(a, b) for a, b in zip(rows, rows[1:]) if a[1] == "ours" and b[1] == "Gmsh, fragments"][:6]
    number = [[[float(c[i]) for c in pair] for pair in pairs] for i in (2, 4, 5)]
    worst = sum(g > o for o, g in number[1])
    return (f"- On networks of planar fractures both keep everything. We take {span([o / g for o, g in number[0]])} of the time; Gmsh's "
            f"tetrahedra are better: its median is {span([g for _, g in number[2]])}, ours {span([o for o, _ in number[2]])}, and its "
            f"worst ones are better in {worst} of {len(pairs)}. {by(kept['meshes'])}")


# --- Mäntylä

RULES = "sides single arcs pairs order nearest rings curves checks".split()


def tallies(line):
    """`double, right 59, connecting 1  exact, same 60` to {"double": {"right": 59, "connecting": 1}, ...}."""
    found = {}
    for part in line.strip().split("  "):
        words = part.split(", ")
        counts = [w for w in words if re.search(r" \d+$", w)]
        found[", ".join(w for w in words if w not in counts)] = {w.rsplit(" ", 1)[0]: int(w.rsplit(" ", 1)[1]) for w in counts}
    return found


def read_near(text):
    columns, pairs = [], set()
    for k, line in re.findall(r"^k (\d+):(.*)$", text, re.M):
        checked, free = (tallies(line)[name] for name in ("double", "double, no checks"))
        pairs.add(sum(checked.values()))
        failures = sum(n for word, n in checked.items() if word not in ("right", "within 1e-6", "wrong"))
        if failures:
            columns.append((k, failures, free.get("right", 0) - checked.get("right", 0), free.get("wrong", 0)))
    titles = ("k", "failures", "of these, without `checks`: right", "wrong, unsaid")
    return {"rows": [" | ".join(map(str, (title, *row))) for title, row in zip(titles, zip(*columns))], "pairs": min(pairs)}


def near(kept):
    v = kept["mantyla-near"]["values"]
    return (f"**Doubles fail near their epsilon** (10<sup>-10</sup> of the size): operands on a grid that are moved by 10<sup>-k</sup>, {v['pairs']} "
            f"pairs for each k from 2 to 16:\n\n" + table(cells(v["rows"][0]), v["rows"][1:]) + "\n\n" + by(kept["mantyla-near"]))


def read_folds(text):
    counts = re.findall(r"^(\d+)  (\w+)", text, re.M)
    return {"steps": sum(int(n) for n, _ in counts), "failed": sum(int(n) for n, what in counts if what != "same")}


def folds(kept):
    v = kept["mantyla-folds"]["values"]
    return (f"**Exact fractions never failed** on solids that do not touch themselves. In folds of four Booleans on a grid, where results "
            f"are operands again, {v['failed']} of {v['steps']:,} steps fail: always where an operand touches itself at the place that the "
            f"other boundary crosses. There the structure has two vertices, and the neighbourhood of neither is that of the point.\n\n"
            + by(kept["mantyla-folds"]))


def read_rules(text):
    totals = {f"{who} {what}": int(n) for who, what, n in re.findall(r"^(baseline|published) (\w+) (\d+)$", text, re.M)}
    changes = {}
    for who, name, line in re.findall(r"^(baseline -|published \+)(\w+):(.*)$", text, re.M):
        changes.setdefault(name, {})[who[0]] = Counter({change: int(n) for change, n in re.findall(r"(\w+ to \w+) (\d+)", line)})

    def count(rule, who, before, after):
        return sum(changes[rule][who][f"{b} to {a}"] for b in before for a in after)
    failed, right = ("wrong", "refused"), ("same",)
    return {"totals": totals, "rows": [" | ".join(map(str, (f"`{r}`", count(r, "b", failed, right), count(r, "p", failed, right),
                                                            count(r, "p", right, failed)))) for r in RULES],
            "checks": [count("checks", "p", ("wrong",), ("refused",)), count("checks", "p", right, ("refused",))],
            "nearest": count("nearest", "p", ("wrong",), ("refused",))}


def rules(kept):
    v = kept["mantyla-rules"]["values"]
    right, wrong, ended = (v["totals"].get("published " + what, 0) for what in ("same", "wrong", "refused"))
    return (f"On a grid, {right + wrong + ended:,} Booleans whose boundaries cross, in fractions: the baseline does "
            f"{v['totals']['baseline same']:,} right; the published algorithm {right}, {wrong} are wrong and {ended} end in a stage. \"Fail "
            "without it\": the baseline with that rule off. \"By it alone\": the published algorithm with `shells` and that rule.\n\n"
            + table(["rule", "fail without it", "repaired by it alone", "broken by it alone"], v["rows"]) +
            f"\n\n`checks` turn {v['checks'][0]} wrong results into refusals, and {v['checks'][1]} right ones; `nearest`, which needs "
            f"`rings`, {v['nearest']} of the wrong. {by(kept['mantyla-rules'])}")


def rights(tally):
    return tally["judged"] - tally["failures"]


def read_departures(text):
    totals = json.loads(text)["aggregates"]["totals"]
    names = {"baseline": "mantyla-double", "published": "mantyla-published", "shells": "mantyla-published+shells"}
    return {what: rights(totals[name]) for what, name in names.items()} | {"problems": totals["mantyla-double"]["judged"]}


def departures(kept):
    v = kept["mantyla-departures"]["values"]
    return (f"The same rules in doubles by the judge of sweeps, on {v['problems']} Booleans of notched boxes and an octahedron: the baseline "
            f"is right in {v['baseline']}, the published algorithm in {v['published']}, with `shells` in {v['shells']}; the section \"What a "
            f"rule changes\" of the report has the table. {by(kept['mantyla-departures'])}")


def read_report(text):
    report = json.loads(text)
    a = report["aggregates"]
    ratios = {r["system"]: r for r in a["ratios"]}
    curves = {c["system"]: c for c in a["distances"]["all"]["systems"]}

    def row(system):
        name, tally = system["name"], a["totals"][system["name"]]
        verdicts, curve = tally["verdicts"], curves.get(name)
        begin = curve and curve["fails_from"]
        worst = curve and next(p for p in curve["points"] if p["distance"] == curve["worst_at"])["failure_rate"]
        ratio = [f"{ratios[name][what]['median']:.3g}" if name in ratios else "1" if name == "ours" else "" for what in ("time", "memory")]
        right = rights(tally) - verdicts["same"]
        failed = [verdicts[v] for v in ("wrong", "refused", "timed-out")]
        start = "never" if begin is None else "exact" if begin == "exact" else f"10<sup>-{begin}</sup>"
        return " | ".join(map(str, [system["title"], verdicts["same"], right, *failed, start, f"{100 * (worst or 0):.{2 if (worst or 0) < 0.995 else 3}g} %", *ratio]))
    systems = [s for s in report["systems"] if s["name"] in a["totals"]]
    return {"rows": [row(s) for s in systems], "problems": a["problems"], "families": len(a["families"]),
            "systems": len(systems), "runs": sum(t["runs"] for t in a["totals"].values()), "nef": a["truth"].get("Nef", 0)}


def report(kept):
    v = kept["mantyla-report"]["values"]
    return (f"{v['problems']} problems of {v['families']} families, {v['systems']} systems, {v['runs']:,} runs. Nef polyhedra confirm the exact "
            f"result of {v['nef']} problems. ([Files of a report](../../bench/README.md#reports))\n\n"
            + plain("mantyla-report", "", "same", "right by another contract", "wrong, unsaid", "refused", "timed out", "fails from", "in at most",
                    "time beside ours", "memory beside ours")(kept))


# --- growth

GROWING = {"crossings": ("n sheets across n, n² crossings", lambda n: f"{n * n:,}"),
           "regions": ("(n + 1)³ closed regions", lambda n: f"{(n + 1) ** 3:,}"),
           "inside": ("vertices of a ball in a block", lambda n: f"{n * n // 2 - n + 2:,}"),
           "overlap": ("part of the faces that overlap", lambda n: "1" if n == 16 else f"{n}/16"),
           "degree": ("of two surfaces, in both directions", str)}


def read_growth(text):
    a = json.loads(text)["aggregates"]
    studies = {s["family"]: {c["system"]: (c["points"][0], c["points"][-1]) for c in s["systems"]} for s in a["growth"]}
    rows = []
    for name, (title, size) in GROWING.items():
        boolean, tree = (studies[name][system] for system in ("ours", "ours-tree"))
        rows.append(" | ".join([f"`{name}`: {title}", *(size(p["size"]) for p in boolean),
                                *(span([1000 * p["seconds"] for p in ends]) if max(p["seconds"] for p in ends) < 0.1 else
                                  " to ".join(f"{1000 * p['seconds']:,.0f}" for p in ends) for ends in (boolean, tree)),
                                span([p["own_bytes"] / 1e6 for p in tree])]))
    return {"rows": rows, "problems": a["problems"], "nef": a["truth"].get("Nef", 0)}


def growth(kept):
    v = kept["pereira-growth"]["values"]
    return (f"Medians of five warm runs, one thread of two cores; Nef polyhedra confirm {v['nef']} of {v['problems']} results. *Boolean*: the "
            "operands as polygons, refined, classified, simplified. *Tree*: as `cnrg eval`, leaves and the proof of curved surfaces "
            "included.\n\n" + plain("pereira-growth", "what grows", "from", "to", "Boolean, ms", "tree, ms", "memory of the tree, MB")(kept))


BASELINE = "CNRG_SEEDS={} build/release/tests/test_baseline \"{}\""
CONSERVE = "bench/run conserve FOLDER/{} --count{} --seconds 60 --json out/{}.json"
MEASUREMENTS = [
    Measurement("keyser-errors", "python3 papers/keyser2004/measure.py PROGRAM", printed_rows(0)),
    Measurement("keyser-distances", "python3 papers/keyser2004/measure.py PROGRAM", printed_rows(1)),
    Measurement("keyser-curved", "python3 papers/keyser2004/curved.py PROGRAM", printed_rows(0)),
    Measurement("keyser-coincidences", "python3 papers/keyser2004/coincidences.py PROGRAM", printed_rows(0), long=True),
    Measurement("mantyla-folds", BASELINE.format(2000, "hunt with folds on the grid"), read_folds),
    Measurement("mantyla-near", "CNRG_FIRST_SEED=50000 " + BASELINE.format(600, "hunt near the grid"), read_near),
    Measurement("mantyla-rules", BASELINE.format(3000, "hunt for departures"), read_rules),
    Measurement("mantyla-departures", "bench/run departures --out out/departures", read_departures, "out/departures/report.json", True),
    Measurement("mantyla-report", "bench/run all --limit 900 --seconds 20 --systems ours,nef,occt-rescaled,mantyla-exact,openscad-rescaled,corefinement,"
                "mantyla-double --out out/full", read_report, "out/full/report.json", True),
    Measurement("pereira-growth", f"bench/run {' '.join(GROWING)} --out out/growth", read_growth, "out/growth/report.json", True),
    Measurement("pereira-groups", "python3 tests/formats/supported_tunnel.py PROGRAM $(mktemp -d)", printed_rows(0)),
    Measurement("speed-nef", "bench/run speed pairs growth spheres64 boxes200 --meshes FOLDER --json out/nef.json", read_nef,
                "out/nef.json", True),
    Measurement("meshes", "bench/run meshes FOLDER", printed_rows(0, (0, 1, 2, 3, 4, 5, 8, 11)), long=True),
    *(Measurement(f"conserve-{folder}{way}", CONSERVE.format(folder, way.replace("-", " --"), folder + way), read_counts,
                  f"out/{folder}{way}.json", folder != "mixed_dim") for way in ("", "-surface") for folder in KINDS),
    Measurement("conserve-crust", "bench/run conserve FOLDER/geology/scec_cfm53_PNRA --together --count --seconds 900 --json out/crust.json",
                read_crust, "out/crust.json", True),
]
BLOCKS = {
    "readme": beside_corefinement, "whole-jobs": whole_jobs, "speed-nef": nef,
    "conserve": lambda kept: counts_of(kept, "", COUNTS, True),
    "conserve-surface": lambda kept: counts_of(kept, "-surface", COUNTS, False), "conserve-crust": crust,
    "meshes": plain("meshes", "model", "", "time, s", "tetrahedra", "worst shape", "median", "area missed, %", "regions kept", after=""),
    "meshes-gmsh": beside_gmsh,
    "mantyla-folds": folds, "mantyla-near": near, "mantyla-rules": rules, "mantyla-departures": departures, "mantyla-report": report,
    "pereira-growth": growth, "pereira-groups": plain("pereira-groups", "dimension", "group", "number", "measure of the elements"),
    "keyser-errors": plain("keyser-errors", "node", "volume", "error", "of the leaves", "chord × area"),
    "keyser-distances": plain("keyser-distances", "node", "distance", "bound"),
    "keyser-curved": plain("keyser-curved", "node", "finer", "straight mesh", "error", "bent mesh", "stay straight", "error", "ratio"),
    "keyser-coincidences": plain("keyser-coincidences", "case", "is", "cnrg", "OpenCASCADE", "CGAL Nef", "CGAL corefinement", "Manifold",
                                 "OpenSCAD"),
}
