"""The aggregates of a report: everything that its tables, figures and main facts say, computed from rows.

A run is right when it was judged and its verdict is no failure; seconds and memory are looked at for right runs
only. Rates are parts of the judged runs. Rows come sorted by family, problem and system, so that the rows of a
problem are side by side. Systems and families are names here; their order is that of the experiment.
"""
import math
from collections import Counter
from dataclasses import dataclass, field
from itertools import groupby

from rows import CLASS_OF, CONFIRMED, CONFIRMED_ROWS, FAILURES, LAST_DISTANCE, OURS

ONSET = 0.01  # the failure rate from which on failures begin


def is_right(row):
    return CLASS_OF[row["verdict"]] in ("exact", "right")


def times_of(row):
    """Of the runs after the first one, in the same process, or of that one if there are none."""
    return row["warm"] or [row["seconds"]]


def wilson(count, of):
    """Wilson's interval for a rate, with a confidence of 95 % (Wilson 1927): (low, high)."""
    if of == 0:
        return 0.0, 1.0
    z, rate = 1.959963984540054, count / of
    middle, spread = rate + z * z / (2 * of), z * math.sqrt(rate * (1 - rate) / of + z * z / (4 * of * of))
    whole = 1 + z * z / of
    return (middle - spread) / whole if count else 0.0, (middle + spread) / whole if count < of else 1.0


class Tally(Counter):
    """Runs by verdict."""

    def of(self, group):
        return sum(count for verdict, count in self.items() if CLASS_OF[verdict] == group)

    runs = property(lambda self: sum(self.values()))
    judged = property(lambda self: self.runs - self.of("unjudged"))
    right = property(lambda self: self.of("exact") + self.of("right"))
    failures = property(lambda self: sum(self.of(group) for group in FAILURES))
    failure_rate = property(lambda self: self.failures / self.judged if self.judged else 0.0)
    failure_interval = property(lambda self: wilson(self.failures, self.judged))


@dataclass
class Spread:
    """Quartiles by linear interpolation between the sorted values at (n - 1) / 4 and 3 (n - 1) / 4, from 0 on."""
    count: int
    least: float = 0.0
    lower: float = 0.0
    median: float = 0.0
    upper: float = 0.0
    most: float = 0.0


def spread_of(values):
    ordered = sorted(values)
    if not ordered:
        return Spread(0)

    def quantile(part):
        place = part * (len(ordered) - 1)
        below = int(place)
        above = min(below + 1, len(ordered) - 1)
        return ordered[below] + (place - below) * (ordered[above] - ordered[below])

    return Spread(len(ordered), ordered[0], quantile(0.25), quantile(0.5), quantile(0.75), ordered[-1])


@dataclass
class PowerLaw:
    """y = factor * x^exponent."""
    points: int
    exponent: float
    factor: float
    error: float             # standard error of the exponent
    r_squared: float = 1.0   # the part of the variance of log y that the law explains; 1 when log y has none


def power_law(points):
    """Least squares on logarithms, each point with the same weight. None with fewer than three different x. All
    numbers are positive."""
    if len({x for x, _ in points}) < 3:
        return None
    n = len(points)
    mean_x = mean_y = 0.0
    for x, y in points:
        mean_x += math.log(x) / n
        mean_y += math.log(y) / n
    xx = xy = yy = 0.0
    for x, y in points:
        dx, dy = math.log(x) - mean_x, math.log(y) - mean_y
        xx += dx * dx
        xy += dx * dy
        yy += dy * dy
    exponent = xy / xx
    residual = max(0.0, yy - exponent * xy)
    law = PowerLaw(n, exponent, math.exp(mean_y - exponent * mean_x), math.sqrt(residual / (n - 2) / xx))
    if yy > 0:
        law.r_squared = 1 - residual / yy
    return law


@dataclass
class FamilyTally:
    family: str
    problems: int
    has_distance: bool
    systems: dict  # Tally by system; those with runs


@dataclass
class StageTally:
    """Failures of a system at a stage; problem and message are of the first of them."""
    system: str
    stage: str
    problem: str
    message: str
    tally: Tally = field(default_factory=Tally)


@dataclass
class DistancePoint:
    k: int  # of 10^-k; None: exactly degenerate
    tally: Tally = field(default_factory=Tally)


@dataclass
class DistanceCurve:
    system: str
    points: list  # far to near, `exact` last; those that have judged runs

    @property
    def onset(self):
        """The first point with a failure rate of `ONSET` or more, or None."""
        return next((point for point in self.points if point.tally.failure_rate >= ONSET), None)

    @property
    def worst(self):
        """The first point with the highest failure rate."""
        return max(self.points, key=lambda point: point.tally.failure_rate)


@dataclass
class DistanceStudy:
    """Failures against distance, in one family or (None) in all that have distances."""
    family: str
    curves: list


@dataclass
class GrowthPoint:
    """Over the right runs of one size: medians, and quartiles of time and memory."""
    size: int
    runs: int
    right: int
    triangles: float
    place: float             # on the axis: the size, or the triangles
    seconds: float
    own_bytes: float
    cold_seconds: float      # of first runs alone
    seconds_quartiles: tuple
    own_bytes_quartiles: tuple
    times: int = 1           # that the quartiles are of


@dataclass
class GrowthCurve:
    system: str
    points: list  # ascending; those with right runs
    time: PowerLaw    # against triangles, or None
    memory: PowerLaw


@dataclass
class GrowthStudy:
    """A family that was run in three sizes or more. Laws begin with the last point that costs less than twice the least:
    what comes before is overhead."""
    family: str
    curves: list


@dataclass
class Ratio:
    """What a system takes as a multiple of what ours takes, over problems that both did right."""
    system: str
    time: Spread
    memory: Spread


@dataclass
class RuleEffect:
    """What a rule changes, over the problems that were judged with it and without it. `system` and `of` differ by it."""
    rule: str
    on: bool              # in `system`; else in `of`
    system: str
    of: str
    problems: int = 0
    repaired: int = 0     # right with it, failed without it
    broken: int = 0       # the other way round
    refused: int = 0      # refused with it, wrong without it
    answered: int = 0     # wrong with it, refused without it


@dataclass
class ExactShare:
    """Parts of the predicate calls of ours that went to exact arithmetic."""
    family: str
    runs: int
    median: float
    most: float


@dataclass
class TruthCount:
    confirmed: str
    problems: int = 0
    example: str = ""
    reason: str = ""


@dataclass
class RowCount:
    """Rows by who confirms their verdicts."""
    confirmed: str
    systems: Counter = field(default_factory=Counter)
    example: dict = None  # the first row
    rows = property(lambda self: sum(self.systems.values()))


def grouped_by(rows, key):
    return [(name, list(group)) for name, group in groupby(rows, key=lambda row: row[key])]


def problems_of(rows):
    return [group for _, group in grouped_by(rows, "problem")]


class Summary:
    def __init__(self, experiment):
        rows = experiment.rows
        self._place = experiment.place
        self._growth = {name: info["growth"] for name, info in experiment.family.items()}
        self.families = self._tally_families(rows)
        self.problems = sum(family.problems for family in self.families)
        self.totals = {name: Tally() for name in experiment.system}  # those without runs, too
        for row in rows:
            self.totals[row["system"]][row["verdict"]] += 1
        self.systems = [name for name, tally in self.totals.items() if tally.runs]
        self.ours = OURS if OURS in self.systems else None
        self.stages = self._tally_stages(rows)
        families = grouped_by(rows, "family")
        self.all_distances = self._study_distances(None, rows)
        studies = [self._study_distances(name, group) for name, group in families]
        self.distances = [study for study in studies if study.curves]
        self.costs = [self._study_growth(name, group) for name, group in families]
        self.growth = [study for study, (_, group) in zip(self.costs, families)
                       if len({row["size"] for row in group}) >= 3]
        self.ratios = self._ratios(rows) if self.ours else []
        shares = [(name, [row["exact_share"] for row in group if row["system"] == OURS and row["exact_share"] >= 0])
                  for name, group in families]
        self.rules = self._rule_effects(experiment.systems, rows)
        self.exact_shares = [self._share(name, values) for name, values in shares if values]
        everywhere = [value for _, values in shares for value in values]
        self.exact_share = self._share("", everywhere) if everywhere else None
        self._count_truths(rows)
        self._count_confirmations(rows)
        self.assertions = self._cost_of_assertions(rows)
        seconds, sizes = [row["limit_seconds"] for row in rows], [row["limit_bytes"] for row in rows]
        self.load = spread_of([row["load"] for row in rows])
        self.limit_seconds, self.limit_bytes = (min(seconds), max(seconds)), (min(sizes), max(sizes))

    def _by_place(self, values):
        return sorted(values.items(), key=lambda item: self._place[item[0]])

    def _tally_families(self, rows):
        """First those with distances."""
        families = []
        for name, group in grouped_by(rows, "family"):
            systems = {}
            for row in group:
                systems.setdefault(row["system"], Tally())[row["verdict"]] += 1
            families.append(FamilyTally(name, len(problems_of(group)), any(row["has_distance"] for row in group),
                                        dict(self._by_place(systems))))
        return sorted(families, key=lambda family: not family.has_distance)

    def _tally_stages(self, rows):
        """By system, most failures first."""
        stages = {}
        for row in rows:
            if CLASS_OF[row["verdict"]] in FAILURES:
                name = row["stage"] or "unknown"
                stage = stages.setdefault((row["system"], name),
                                          StageTally(row["system"], name, row["problem"], row["message"]))
                stage.tally[row["verdict"]] += 1
        return sorted(stages.values(), key=lambda s: (self._place[s.system], -s.tally.runs, s.stage))

    def stages_by_system(self):
        return [(name, list(group)) for name, group in groupby(self.stages, key=lambda stage: stage.system)]

    def _study_distances(self, family, rows):
        """A system that refuses all operands of a family at the input does not take such problems at all, and a
        rate of failures would say nothing: these runs are left out."""
        taken = {(row["system"], row["family"]) for row in rows
                 if row["verdict"] != "refused" or row["stage"] != "input"}
        systems = {}
        for row in rows:
            if (not row["has_distance"] or row["verdict"] == "unjudged"
                    or (row["system"], row["family"]) not in taken):
                continue
            points = systems.setdefault(row["system"], {})
            k = row["distance"]
            points.setdefault(k, DistancePoint(k)).tally[row["verdict"]] += 1
        return DistanceStudy(family, [
            DistanceCurve(name, sorted(points.values(), key=lambda p: LAST_DISTANCE + 1 if p.k is None else p.k))
            for name, points in self._by_place(systems)])

    def _study_growth(self, family, rows):
        systems = {}
        for row in rows:
            systems.setdefault(row["system"], {}).setdefault(row["size"], []).append(row)
        curves = []
        for name, sizes in self._by_place(systems):
            points = []
            for size, runs in sorted(sizes.items()):
                right = [row for row in runs if is_right(row)]
                cold = spread_of([row["seconds"] for row in right]).median
                time = spread_of([seconds for row in right for seconds in times_of(row)])
                memory = spread_of([float(row["own_bytes"]) for row in right])
                triangles = spread_of([float(row["triangles"]) for row in right]).median
                if right:
                    place = float(size) if self._growth.get(family) == "size" else triangles
                    points.append(GrowthPoint(size, len(runs), len(right), triangles, place, time.median, memory.median, cold,
                                              (time.lower, time.upper), (memory.lower, memory.upper), time.count))
            if points:
                curves.append(GrowthCurve(name, points, *(self._law(points, cost) for cost in ("seconds", "own_bytes"))))
        return GrowthStudy(family, curves)

    @staticmethod
    def _law(points, cost):
        costs = [(p.place, getattr(p, cost)) for p in points if p.place > 0 and getattr(p, cost) > 0]
        least = min((y for _, y in costs), default=0.0)
        flat = [place for place, (_, y) in enumerate(costs) if y < 2 * least]
        return power_law(costs[flat[-1]:] if flat else [])

    def _ratios(self, rows):
        """Of all systems but ours that have right runs in common with ours."""
        systems = {}
        for problem in problems_of(rows):
            right = {row["system"]: row for row in problem if is_right(row)}
            ours = right.pop(OURS, None)
            for name, row in right.items() if ours else ():
                times, memories = systems.setdefault(name, ([], []))
                theirs, own = (spread_of(times_of(one)).median for one in (row, ours))
                if theirs > 0 and own > 0:
                    times.append(theirs / own)
                if row["own_bytes"] and ours["own_bytes"]:
                    memories.append(row["own_bytes"] / ours["own_bytes"])
        return [Ratio(name, spread_of(times), spread_of(memories))
                for name, (times, memories) in self._by_place(systems)]

    def _rule_effects(self, systems, rows):
        """Of each system that varies another one that was run, too."""
        effects = [RuleEffect(s["varies"]["rule"], s["varies"]["on"], s["name"], s["varies"]["of"])
                   for s in systems if s["varies"] and {s["name"], s["varies"]["of"]} <= set(self.systems)]
        for problem in problems_of(rows) if effects else ():
            by_system = {row["system"]: row for row in problem if row["verdict"] != "unjudged"}
            for effect in effects:
                pair = [by_system.get(effect.system), by_system.get(effect.of)]
                if None in pair:
                    continue
                effect.problems += 1
                with_it, without = pair if effect.on else pair[::-1]
                effect.repaired += is_right(with_it) and not is_right(without)
                effect.broken += is_right(without) and not is_right(with_it)
                verdicts = with_it["verdict"], without["verdict"]
                effect.refused += verdicts == ("refused", "wrong")
                effect.answered += verdicts == ("wrong", "refused")
        return effects

    @staticmethod
    def _share(family, values):
        spread = spread_of(values)
        return ExactShare(family, spread.count, spread.median, spread.most)

    def _count_truths(self, rows):
        """A disagreement that one row of a problem has counts for the problem."""
        self.truths = [TruthCount(name) for name in CONFIRMED]
        self.disagreements = []  # problem and reason
        for problem in problems_of(rows):
            disagrees = [row for row in problem if row["truth"]["confirmed"] == "DISAGREES"]
            row = (disagrees or problem)[0]
            if disagrees:
                self.disagreements.append((row["problem"], row["truth"]["reason"]))
            count = self.truths[CONFIRMED.index(row["truth"]["confirmed"])]
            if count.problems == 0:
                count.example, count.reason = row["problem"], row["truth"]["reason"]
            count.problems += 1

    def _count_confirmations(self, rows):
        self.confirmations = {name: RowCount(name) for name in CONFIRMED_ROWS}
        for row in rows:
            count = self.confirmations[row["confirmation"]["by"]]
            count.systems[row["system"]] += 1
            count.example = count.example or row
        self.disputed = [row for row in rows if row["confirmation"]["by"] == "DISPUTED"]

    def _cost_of_assertions(self, rows):
        """By system, what its run with assertions took as a multiple of the same run without."""
        costs = {}
        for row in rows:
            if row["asserted_seconds"] is not None and row["seconds"] > 0:
                costs.setdefault(row["system"], []).append(row["asserted_seconds"] / row["seconds"])
        return {name: spread_of(ratios) for name, ratios in self._by_place(costs)}
