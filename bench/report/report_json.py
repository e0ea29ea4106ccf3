"""The report as JSON: schema version, title, machine, systems, families, main facts, all aggregates, the exact
results by problem, all rows."""
import json
import re

from facts import main_facts
from rows import VERDICTS
from words import HOSTILE

SCHEMA = 1


def json_text(value):
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return re.sub(f"[{HOSTILE}]", lambda c: json.dumps(c[0])[1:-1], text)


def _tally(tally):
    return {"runs": tally.runs, "judged": tally.judged, "failures": tally.failures,
            "failure_rate": tally.failure_rate, "failure_interval": tally.failure_interval,
            "verdicts": {verdict: tally[verdict] for verdict in VERDICTS}}


def _tallies(tallies):
    return {system: _tally(tally) for system, tally in tallies.items() if tally.runs}


def _spread(s):
    if s.count == 0:
        return None
    return {"count": s.count, "min": s.least, "lower_quartile": s.lower, "median": s.median,
            "upper_quartile": s.upper, "max": s.most}


def _law(law):
    return law and {"points": law.points, "exponent": law.exponent, "standard_error": law.error,
                    "factor": law.factor, "r_squared": law.r_squared}


def _distance(point):
    return "exact" if point.k is None else point.k


def _distances(study):
    return {"family": study.family,
            "systems": [{"system": curve.system, "fails_from": curve.onset and _distance(curve.onset),
                         "worst_at": _distance(curve.worst),
                         "points": [{"distance": _distance(p)} | _tally(p.tally) for p in curve.points]}
                        for curve in study.curves]}


def _growth(study):
    return {"family": study.family,
            "systems": [{"system": curve.system, "time": _law(curve.time), "memory": _law(curve.memory),
                         "points": [vars(point) for point in curve.points]} for curve in study.curves]}


def _share(share):
    return {"runs": share.runs, "median": share.median, "max": share.most}


def _fact(fact):
    return {"question": fact.question, "headline": fact.headline, "sentence": fact.sentence, "note": fact.note,
            "systems": [{"system": system} | dict(zip(fact.columns, cells)) for system, cells in fact.lines]}


def _aggregates(s):
    return {
        "problems": s.problems,
        "totals": _tallies(s.totals),
        "families": [{"family": f.family, "problems": f.problems, "has_distance": f.has_distance,
                      "systems": _tallies(f.systems)} for f in s.families],
        "stages": [{"system": stage.system, "stage": stage.stage} | _tally(stage.tally)
                   | {"example": stage.problem, "message": stage.message} for stage in s.stages],
        "distances": {"all": _distances(s.all_distances), "families": [_distances(study) for study in s.distances]},
        "growth": [_growth(study) for study in s.growth],
        "ratios": [{"system": r.system, "time": _spread(r.time), "memory": _spread(r.memory)} for r in s.ratios],
        "rules": [vars(effect) for effect in s.rules],
        "exact_share": s.exact_share and _share(s.exact_share),
        "exact_shares": [{"family": share.family} | _share(share) for share in s.exact_shares],
        "truth": {truth.confirmed: truth.problems for truth in s.truths},
        "confirmed_rows": {name: dict(count.systems) for name, count in s.confirmations.items()},
        "assertions": {system: _spread(ratios) for system, ratios in s.assertions.items()},
        "disagreements": [{"problem": problem, "reason": reason} for problem, reason in s.disagreements]}


def report_json(experiment, summary, title):
    """The exact results once, by problem; a row per line, as in its file but for them. Facts of a result that are
    those of the exact result are the word `exact`."""
    head = {"schema": SCHEMA, "title": title, "machine": experiment.machine, "systems": experiment.systems,
            "families": experiment.families,
            "facts": [_fact(fact) for fact in main_facts(experiment, summary)], "aggregates": _aggregates(summary)}
    truths = {}
    for row in experiment.rows:
        truths.setdefault(row["problem"], row["truth"])
    rows = []
    for row in experiment.rows:
        same = row["facts"] == row["truth"]["facts"]
        rows.append({key: "exact" if key == "facts" and same else value for key, value in row.items()
                     if key != "truth"})
    lines = [f"{json_text(problem)}:{json_text(truth)}" for problem, truth in sorted(truths.items())]
    return (json_text(head)[:-1] + ',"truths":{\n' + ",\n".join(lines) + '\n},"rows":[\n'
            + ",\n".join(map(json_text, rows)) + "\n]}\n")
