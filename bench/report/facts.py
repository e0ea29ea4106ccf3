"""The three main facts: each a number for us, a line for every system, and how to read it. Nothing is claimed that
the rows do not say; the words follow the numbers."""
from dataclasses import dataclass, field

from summary import ONSET
from words import NONE, distance_text, grouped, percent, plural, three_digits


@dataclass
class MainFact:
    question: str
    headline: str = NONE  # the number
    sentence: str = ""    # what the number is
    note: str = ""
    columns: list = field(default_factory=list)
    lines: list = field(default_factory=list)  # (system, cells); none when there is not enough data


def _part(part, whole):
    return f"{grouped(part)} of {grouped(whole)}"


def exact_results(experiment, summary):
    fact = MainFact("Who has the right result?", columns=["same", "right", "wrong"], note=(
        "Same: the exact point set, of systems that round up to the rounding that they state. Right: by some "
        "contract, the same ones included. Wrong: a wrong result and no word of it."))
    judged = {name: tally for name, tally in summary.totals.items() if tally.judged}
    systems = sorted(judged, key=lambda s: (s != summary.ours, -judged[s].of("exact") / judged[s].judged))
    fact.lines = [(s, [grouped(judged[s].of("exact")), grouped(judged[s].right), grouped(judged[s].of("wrong"))])
                  for s in systems]
    if summary.ours not in judged:
        fact.sentence = "There are no judged runs of ours."
        return fact
    ours, others = judged[summary.ours], systems[1:]
    fact.headline = _part(ours.of("exact"), ours.judged)
    fact.sentence = f"results of {experiment.system[summary.ours]['title']} are the exact ones."
    if ours.of("wrong"):
        fact.sentence += f" {grouped(ours.of('wrong'))} are wrong, unsaid."
    if ours.of("unjudged"):
        fact.sentence += f" {grouped(ours.of('unjudged'))} more could not be judged."
    if not others:
        return fact

    def said(s):
        return f"{experiment.system[s]['title']} with {_part(judged[s].of('exact'), judged[s].judged)}"

    fact.sentence += f" Best of the others is {said(others[0])}"
    if len(others) > 1:
        fact.sentence += f", last {said(others[-1])}"
    wrong = [judged[s].of("wrong") for s in others]
    unsaid, systems_unsaid = sum(wrong), sum(count > 0 for count in wrong)
    if unsaid == 0:
        fact.sentence += ". None of the others is wrong without saying so."
    else:
        fact.sentence += (f". {plural(unsaid, 'result')} of {plural(systems_unsaid, 'other system')} "
                          f"{'is' if unsaid == 1 else 'are'} wrong without saying so.")
    return fact


def _onset_rank(curve):
    """From far to near; those that never fail come last."""
    if curve.onset is None:
        return 2000
    return 1000 if curve.onset.k is None else curve.onset.k


def failures_near_degeneracy(experiment, summary):
    fact = MainFact("Where do failures begin?")
    curves = summary.all_distances.curves
    if not curves:
        fact.sentence = "Not enough data: no family with a distance to degeneracy was run."
        return fact
    fact.columns = ["fails from", "at most", "there"]
    fact.note = ("From: the largest 10⁻ᵏ, such as a distance as a part of the operands' size, at which "
                 f"{percent(ONSET)} of the runs or more fail. At most: the highest rate of failure, and at which "
                 "distance.")
    curves = sorted(curves, key=lambda c: (c.system != summary.ours, _onset_rank(c), -c.worst.tally.failure_rate))
    for curve in curves:
        rate = curve.worst.tally.failure_rate
        fact.lines.append((curve.system, [distance_text(curve.onset.k) if curve.onset else "never", percent(rate),
                                          distance_text(curve.worst.k) if rate > 0 else NONE]))
    ours = curves[0] if curves[0].system == summary.ours else None
    if ours is None:
        fact.sentence = "There are no runs of ours at distances."
    else:
        runs = sum(point.tally.runs for point in ours.points)
        failures = plural(sum(point.tally.failures for point in ours.points), "failure")
        fact.headline = "from " + distance_text(ours.onset.k) if ours.onset else failures
        fact.sentence = (f"{failures + ' ' if ours.onset else ''}of {experiment.system[ours.system]['title']} in "
                         f"{plural(runs, 'run')} at all distances.")
    first = next((curve for curve in curves if curve is not ours and curve.onset), None)
    if first:
        begin = ("in the exactly degenerate position" if first.onset.k is None
                 else "at " + distance_text(first.onset.k))
        fact.sentence += (f" First of the others, {experiment.system[first.system]['title']} begins to fail {begin} "
                          f"and fails in up to {percent(first.worst.tally.failure_rate)} of the runs at a distance.")
    elif len(curves) > (ours is not None):
        fact.sentence += " None of the others begins to fail."
    return fact


def _quartiles(spread):
    return f"{three_digits(spread.lower)}–{three_digits(spread.upper)}"


def speed(experiment, summary):
    fact = MainFact("What does it cost?")
    ratios = sorted((ratio for ratio in summary.ratios if ratio.time.count), key=lambda r: -r.time.median)
    if not ratios:
        fact.sentence = "Not enough data: no problem was done right by ours and by another system."
        return fact
    fact.columns = ["median", "quartiles", "n"]
    fact.lines = [(ratio.system, [three_digits(ratio.time.median) + " ×", _quartiles(ratio.time),
                                  grouped(ratio.time.count)]) for ratio in ratios]
    fact.note = ("Time of the system over ours, on the n problems that both did right, of warm runs where there are some; below 1 the "
                 "system is faster. Most problems are small; below are times by size. Guarantees are not equal.")
    # The peers of the project, else the fastest: the least flattering.
    by_name = {ratio.system: ratio for ratio in ratios}
    peers = [by_name[name] for name in ("nef", "corefinement") if name in by_name]
    shown, second = (peers + [None] if peers else [ratios[-1], None])[:2]

    def described(ratio):
        return f"(quartiles {_quartiles(ratio.time)}, {plural(ratio.time.count, 'problem')})"

    fact.headline = three_digits(shown.time.median) + " ×"
    fact.sentence = (f"the time of {experiment.system[summary.ours]['title']} is what "
                     f"{experiment.system[shown.system]['title']} takes, in the median {described(shown)}.")
    if second:
        fact.sentence += (f" {experiment.system[second.system]['title']}: {three_digits(second.time.median)} × "
                          f"{described(second)}.")
    return fact


def main_facts(experiment, summary):
    """Exact results; where failures begin; time beside ours."""
    return [exact_results(experiment, summary), failures_near_degeneracy(experiment, summary),
            speed(experiment, summary)]
