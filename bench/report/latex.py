"""Tables for a paper: LaTeX with booktabs, a file each, of the numbers that the page has; and all rows as .csv."""
import csv
import io
import re

import words

_ESCAPES = {"\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_",
            "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "×": r"$\times$", "–": "--"}


def escaped(text):
    return "".join(_ESCAPES.get(c, c) for c in words.shown(text))


def _table(heads, rows, note):
    lines = ["% " + words.shown(note), r"\begin{tabular}{l" + "r" * (len(heads) - 1) + "}", r"\toprule",
             " & ".join(map(escaped, heads)) + r" \\", r"\midrule",
             *(" & ".join(map(escaped, row)) + r" \\" for row in rows), r"\bottomrule", r"\end{tabular}"]
    return "\n".join(lines) + "\n"


def _verdicts(summary, name):
    """Systems against what became of their runs, with the interval of the rate of failures."""
    rows = []
    for system in summary.systems:
        tally = summary.totals[system]
        low, high = tally.failure_interval
        rows.append([name(system), words.grouped(tally.runs), words.grouped(tally.of("exact")),
                     words.grouped(tally.of("right")), words.grouped(tally["within-rounding"]),
                     words.grouped(tally.of("wrong")), words.grouped(tally.of("refused")),
                     words.grouped(tally.of("no result")),
                     f"{words.percent(tally.failure_rate)} ({words.percent(low)} to {words.percent(high)})"])
    return ["system", "runs", "same", "right otherwise", "of these within rounding", "wrong", "refused", "no result",
            "failures (95 %)"], rows


def _times(name, study):
    """A row per system and size."""
    rows = []
    for curve in study.curves:
        for p in curve.points:
            low, high = p.seconds_quartiles
            spread = f"{words.three_digits(low)} to {words.three_digits(high)}" if p.times > 1 else words.NONE
            rows.append([name(curve.system), words.grouped(p.size), words.grouped(round(p.triangles)),
                         f"{p.right} of {p.runs}", words.three_digits(p.seconds), spread,
                         words.three_digits(p.cold_seconds), words.megabytes(p.own_bytes)])
    return ["system", "size", "triangles", "right", "median (s)", "quartiles (s)", "first run (s)", "memory (MB)"], rows


def _rules(name, effects):
    """A row per pair of systems that differ by a rule."""
    return ["rule", "off", "on", "problems", "repaired", "broken", "wrong to refused", "refused to wrong"], [
        [e.rule, *map(name, (e.of, e.system) if e.on else (e.system, e.of)),
         *map(words.grouped, (e.problems, e.repaired, e.broken, e.refused, e.answered))] for e in effects]


def rows_csv(experiment):
    """A line per run: what it was, its parameters, and what became of it."""
    names = list(dict.fromkeys(name for row in experiment.rows for name in row["values"]))
    heads = ["problem", "family", "operation", "operands", "triangles", "system", "verdict", "stage", "seconds",
             "own_bytes", "excess", "missing", "load"]
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([*heads, "warm_seconds", "confirmed", "confirmed_by", *(f"value:{name}" for name in names)])
    for row in experiment.rows:
        cells = [*(row[head] for head in heads), " ".join(map(str, row["warm"])), row["truth"]["confirmed"],
                 row["confirmation"]["by"],
                 *(row["values"].get(name, "") for name in names)]
        writer.writerow([words.shown(cell) if isinstance(cell, str) else cell for cell in cells])
    return out.getvalue()


def tables(experiment, summary, label):
    """Texts by the names of their files, without what is no letter of those."""
    commit = experiment.machine["commit"] if experiment.machine else ""
    note = f"{len(experiment.rows)} runs, commit {commit or 'not recorded'}"
    found = {"verdicts": _table(*_verdicts(summary, label), note)}
    if summary.rules:
        found["rules"] = _table(*_rules(label, summary.rules), note)
    for study in summary.costs:
        found[f"times-{study.family}"] = _table(*_times(label, study), note)
    return {f"{re.sub('[^A-Za-z0-9_-]+', '-', name)}.tex": text for name, text in found.items()} | {
        "rows.csv": rows_csv(experiment)}
