"""Aggregates against numbers worked out by hand."""
import math
import unittest

import words
from facts import main_facts
from plausible import at_distance, right_row, system_info
from rows import make_experiment
from summary import Summary, power_law, spread_of, wilson


def experiment_of(rows):
    return make_experiment(rows, [], [], None)


def summary_of(rows):
    return Summary(experiment_of(rows))


def facts_of(rows):
    experiment = experiment_of(rows)
    return main_facts(experiment, Summary(experiment))


def curve_of(study, system):
    return next(curve for curve in study.curves if curve.system == system)


def rows_at_distances(family):
    """Ten problems at each of the distances 0, 4, 8 and exact: `ours` never fails, `a` fails in 0, 0, 3 and 10."""
    rows = []
    for k, failed in (0, 0), (4, 0), (8, 3), (None, 10):
        for seed in range(1, 11):
            verdict = "same" if seed > failed else "wrong" if seed % 2 else "refused"
            rows.append(at_distance(right_row("ours", family, 1, seed), k))
            rows.append(at_distance(right_row("a", family, 1, seed), k, verdict))
    return rows


class Rules(unittest.TestCase):
    def test_what_a_rule_changes_is_counted_over_common_problems(self):
        # By problem: verdicts with the rule, without it.
        pairs = [("same", "wrong"), ("same", "refused"), ("within-rounding", "same"), ("wrong", "same"),
                 ("refused", "wrong"), ("refused", "wrong"), ("wrong", "refused"), ("same", "same"),
                 ("unjudged", "wrong"), ("wrong", "wrong")]
        for on in True, False:
            varied = system_info("b+r" if on else "b-r", "", varies={"of": "b", "rule": "r", "on": on})
            rows = []
            for seed, (with_it, without) in enumerate(pairs):
                of, by = (without, with_it) if on else (with_it, without)
                rows += [right_row("b", "f", 1, seed, verdict=of), right_row(varied["name"], "f", 1, seed, verdict=by)]
            rows.append(right_row("b", "f", 1, 99, verdict="wrong"))
            [effect] = Summary(make_experiment(rows, [system_info("b", ""), varied], [], None)).rules
            self.assertEqual((effect.rule, effect.on, effect.system, effect.of), ("r", on, varied["name"], "b"))
            self.assertEqual((effect.problems, effect.repaired, effect.broken, effect.refused, effect.answered),
                             (9, 2, 1, 2, 1))

    def test_a_rule_without_the_other_system_says_nothing(self):
        varied = system_info("b-r", "", varies={"of": "b", "rule": "r", "on": False})
        self.assertEqual(Summary(make_experiment([right_row("b-r", "f")], [varied], [], None)).rules, [])


class Fits(unittest.TestCase):
    def test_quartiles_lie_between_the_sorted_values(self):
        s = spread_of([4, 1, 3, 2])
        self.assertEqual((s.count, s.least, s.lower, s.median, s.upper, s.most), (4, 1, 1.75, 2.5, 3.25, 4))
        self.assertEqual(spread_of([7]).lower, 7)
        self.assertEqual(spread_of([]).count, 0)

    def test_an_exact_power_law_is_found(self):
        law = power_law([(10, 3e-3), (100, 3e-3 * 10 ** 1.5), (1000, 3.0)])
        self.assertAlmostEqual(law.exponent, 1.5)
        self.assertAlmostEqual(law.factor, 3e-3 / 10 ** 1.5)
        self.assertAlmostEqual(law.error, 0, 6)
        self.assertAlmostEqual(law.r_squared, 1)
        self.assertIsNone(power_law([(10, 1), (100, 2), (100, 3)]))

    def test_a_power_law_that_does_not_fit_says_so(self):
        # With t = ln 10: x is 0, t, 2t and y is 0, 2t, 2t, so that the slope is 1, the line t/3 + x, and the
        # residuals are -t/3, 2t/3, -t/3: their squares make 2t^2/3, the variance of y 8t^2/3, that of x 2t^2.
        law = power_law([(1, 1), (10, 100), (100, 100)])
        self.assertAlmostEqual(law.exponent, 1)
        self.assertAlmostEqual(law.factor, 10 ** (1 / 3))
        self.assertAlmostEqual(law.error, math.sqrt(1 / 3))
        self.assertAlmostEqual(law.r_squared, 0.75)


class Aggregates(unittest.TestCase):
    def test_failure_rates_and_where_failures_begin(self):
        summary = summary_of(rows_at_distances("edge"))
        self.assertEqual(summary.problems, 40)
        a = curve_of(summary.all_distances, "a")
        self.assertEqual([p.tally.runs for p in a.points], [10] * 4)
        self.assertEqual([p.tally.failure_rate for p in a.points], [0, 0, 0.3, 1])
        self.assertEqual([p.k for p in a.points], [0, 4, 8, None])
        self.assertIs(a.onset, a.points[2])
        self.assertIs(a.worst, a.points[3])
        self.assertIsNone(curve_of(summary.all_distances, "ours").onset)
        self.assertEqual(summary.totals["a"]["wrong"], 7)    # 1, 3 and 1, 3, 5, 7, 9
        self.assertEqual(summary.totals["a"]["refused"], 6)  # 2 and 2, 4, 6, 8, 10
        self.assertEqual(summary.totals["a"].failure_rate, 13 / 40)

    def test_a_system_has_no_rate_in_a_family_whose_operands_it_does_not_take(self):
        sheets = [row | {"verdict": "refused", "stage": "input"} if row["system"] == "a" else row
                  for row in rows_at_distances("sheet")]
        rows = rows_at_distances("edge") + sheets
        summary = summary_of(rows)
        self.assertEqual(curve_of(summary.all_distances, "a").points[0].tally.failure_rate, 0)
        self.assertEqual(curve_of(summary.all_distances, "ours").points[0].tally.runs, 20)
        self.assertEqual(summary.totals["a"].failures, 13 + 40)
        # One that is taken is enough: then a refusal counts.
        next(row for row in sheets if row["system"] == "a").update(verdict="same", stage="")
        self.assertGreater(curve_of(summary_of(rows).all_distances, "a").points[0].tally.failure_rate, 0.4)

    def test_families_are_counted_apart_those_with_distances_first(self):
        summary = summary_of(rows_at_distances("edge") + [right_row("a", "boxes", 5, verdict="same-regularized")])
        self.assertEqual([family.family for family in summary.families], ["edge", "boxes"])
        self.assertEqual([family.problems for family in summary.families], [40, 1])
        self.assertEqual(summary.families[1].systems["a"].of("right"), 1)
        self.assertNotIn("ours", summary.families[1].systems)
        self.assertEqual(len(summary.distances), 1)
        self.assertEqual(summary.problems, 41)

    def test_failures_by_stage_the_most_frequent_first_with_an_example(self):
        def failed(system, seed, verdict, stage="", message=""):
            return right_row(system, "f", 1, seed, verdict=verdict, stage=stage, message=message)
        summary = summary_of([
            right_row("ours", "f"), failed("a", 2, "refused", "input", "open"),
            failed("a", 10, "refused", "connecting", "second"), failed("a", 9, "wrong", "connecting", "first"),
            failed("a", 4, "contact-lost", "connecting", "no failure"), failed("b", 4, "crashed")])
        self.assertEqual([(s.system, s.stage) for s in summary.stages],
                         [("a", "connecting"), ("a", "input"), ("b", "unknown")])
        first = summary.stages[0]
        self.assertEqual((first.tally.runs, first.tally["wrong"]), (2, 1))
        self.assertEqual((first.problem, first.message), ("f-union-s1-r9", "first"))  # before r10

    def test_growth_is_fitted_to_the_medians_of_right_runs(self):
        rows = []
        for size in 1, 10, 100:  # triangles: 24 size
            time = 1e-3 * size ** 2
            for seed, factor in (1, 0.5), (2, 1), (3, 9):
                rows.append(right_row("ours", "f", size, seed, seconds=factor * time, own_bytes=1000 * size))
            rows.append(right_row("ours", "f", size, 4, verdict="timed-out", seconds=60.0, own_bytes=1))
            if size < 100:
                rows.append(right_row("a", "f", size, seconds=time, own_bytes=1))
        summary = summary_of(rows + [right_row("ours", "g")])
        self.assertEqual(len(summary.growth), 1)
        ours, a = summary.growth[0].curves
        self.assertEqual((ours.system, a.system), ("ours", "a"))
        self.assertEqual(len(ours.points), 3)
        self.assertEqual(vars(ours.points[1]),
                         {"size": 10, "runs": 4, "right": 3, "triangles": 240, "place": 240, "seconds": 0.1,
                          "own_bytes": 10000, "cold_seconds": 0.1, "seconds_quartiles": (0.05 * 1.5, 0.5),
                          "own_bytes_quartiles": (10000, 10000), "times": 3})
        self.assertAlmostEqual(ours.time.exponent, 2)
        self.assertAlmostEqual(ours.memory.exponent, 1)
        self.assertEqual(len(a.points), 2)
        self.assertIsNone(a.time)

    def test_overhead_is_not_fitted_and_warm_runs_count(self):
        rows = [right_row("ours", "f", size, seconds=9.0, warm=[max(0.1, 1e-3 * size ** 2)] * 3)
                for size in (1, 2, 4, 8, 10, 20, 40)]
        curve, = summary_of(rows).growth[0].curves
        self.assertEqual(curve.time.points, 3)
        self.assertAlmostEqual(curve.time.exponent, 2)
        self.assertEqual([curve.points[0].seconds, curve.points[0].cold_seconds], [0.1, 9])

    def test_ratios_on_problems_that_both_did_right(self):
        rows = []
        for seed, factor in (1, 2), (2, 4), (3, 6), (4, 8):
            rows += [right_row("ours", "f", 1, seed, seconds=0.5 * seed, own_bytes=1000 * seed),
                     right_row("nef", "f", 1, seed, seconds=0.5 * seed * factor, own_bytes=3000 * seed),
                     right_row("a", "f", 1, seed, seconds=0.001, own_bytes=1, verdict="wrong")]
        rows += [right_row("ours", "f", 1, 5, verdict="refused"), right_row("nef", "f", 1, 5, seconds=100.0),
                 right_row("nef", "f", 1, 6, seconds=100.0)]
        ratio, = summary_of(rows).ratios
        self.assertEqual(ratio.system, "nef")
        self.assertEqual(vars(ratio.time),
                         {"count": 4, "least": 2, "lower": 3.5, "median": 5, "upper": 6.5, "most": 8})
        self.assertEqual(ratio.memory.median, 3)

    def test_exact_share_truth_and_limits(self):
        rows = []
        for seed, share, truth in (1, 0.1, "Nef"), (2, 0.3, "volume"), (3, 0.2, "none"), (4, -1.0, "Nef"):
            row = right_row("ours", "f" if seed < 3 else "g", 1, seed, exact_share=share, limit_seconds=10.0 * seed)
            row["truth"] = row["truth"] | {"confirmed": truth}
            other = row | {"system": "a", "exact_share": 0.9}
            if seed == 4:
                other["truth"] = row["truth"] | {"confirmed": "DISAGREES", "reason": "Nef has volume 7"}
            rows += [row, other]
        summary = summary_of(rows)
        f, g = summary.exact_shares
        self.assertAlmostEqual(f.median, 0.2)
        self.assertEqual((f.most, g.runs, summary.exact_share.runs), (0.3, 1, 3))
        self.assertAlmostEqual(summary.exact_share.median, 0.2)
        self.assertEqual([truth.problems for truth in summary.truths], [1, 0, 0, 0, 1, 1, 1])
        self.assertEqual(summary.disagreements, [("g-union-s1-r4", "Nef has volume 7")])
        self.assertEqual(summary.limit_seconds, (10, 40))

    def test_rows_are_counted_by_who_confirms_them_and_runs_with_assertions_beside_those_without(self):
        rows = []
        for seed, by, asserted in (1, "Nef", 3.0), (2, "DISPUTED", 5.0), (3, "Nef", None), (4, "no-verdict", None):
            rows += [right_row("ours", "f", 1, seed, confirmation={"by": "points", "reason": ""}),
                     right_row("nef", "f", 1, seed, seconds=2.0, confirmation={"by": by, "reason": "why"},
                               asserted_seconds=asserted)]
        summary = summary_of(rows)
        self.assertEqual({name: dict(count.systems) for name, count in summary.confirmations.items()},
                         {"Nef": {"nef": 2}, "integrals": {}, "points": {"ours": 4}, "none": {},
                          "DISPUTED": {"nef": 1}, "no-verdict": {"nef": 1}})
        self.assertEqual([row["problem"] for row in summary.disputed], ["f-union-s1-r2"])
        self.assertEqual(list(summary.assertions), ["nef"])
        self.assertEqual((summary.assertions["nef"].count, summary.assertions["nef"].median), (2, 2.0))

    def test_what_could_not_be_judged_counts_nowhere(self):
        rows = [at_distance(right_row("ours", "f", 20, 1), 4, "unjudged")]
        for seed in range(1, 5):
            verdict = "unjudged" if seed <= 2 else "wrong" if seed == 3 else "same"
            rows += [at_distance(right_row("ours", "f", 1, seed), 3),
                     at_distance(right_row("a", "f", 1, seed), 3, verdict),
                     at_distance(right_row("a", "f", 9, seed), 4, "unjudged"),
                     at_distance(right_row("ours", "f", 9, seed), 4, "unjudged")]
        summary = summary_of(rows)
        a = summary.totals["a"]
        self.assertEqual((a.runs, a.judged, a.right, a.failures, a.failure_rate), (8, 2, 1, 1, 0.5))
        point, = curve_of(summary.all_distances, "a").points
        self.assertEqual(point.tally.failure_rate, 0.5)
        self.assertEqual([ratio.time.count for ratio in summary.ratios], [1])
        self.assertEqual([len(study.curves[0].points) for study in summary.growth], [1])
        fact = facts_of(rows)[0]
        self.assertEqual(fact.headline, "4 of 4")
        self.assertIn("5 more could not be judged. Best of the others is a with 1 of 2.", fact.sentence)


class Facts(unittest.TestCase):
    def test_the_main_facts_follow_from_the_rows(self):
        exact, begin, cost = facts_of([row | {"seconds": 4.0 if row["system"] == "a" else 1.0}
                                       for row in rows_at_distances("edge")])
        self.assertEqual(exact.headline, "40 of 40")
        self.assertEqual(exact.sentence, "results of ours are the exact ones. Best of the others is a with 27 of 40. "
                                         "7 results of 1 other system are wrong without saying so.")
        self.assertEqual(exact.lines[1], ("a", ["27", "27", "7"]))
        self.assertEqual(begin.headline, "0 failures")
        self.assertEqual(begin.sentence, "of ours in 40 runs at all distances. First of the others, a begins to fail "
                                         "at 10⁻⁸ and fails in up to 100 % of the runs at a distance.")
        self.assertEqual(begin.lines[1], ("a", ["10⁻⁸", "100 %", "exact"]))
        self.assertEqual(cost.headline, "4.00 ×")
        self.assertEqual(cost.lines[0], ("a", ["4.00 ×", "4.00–4.00", "27"]))

    def test_the_main_facts_do_not_flatter(self):
        exact, begin, _ = facts_of([row | {"system": "a" if row["system"] == "ours" else "ours"}
                                    for row in rows_at_distances("edge")])
        self.assertEqual(exact.headline, "27 of 40")
        self.assertIn("7 are wrong, unsaid.", exact.sentence)
        self.assertIn("None of the others is wrong", exact.sentence)
        self.assertEqual(begin.headline, "from 10⁻⁸")
        self.assertEqual(begin.sentence,
                         "13 failures of ours in 40 runs at all distances. None of the others begins to fail.")

    def test_results_right_within_their_rounding_are_told_apart(self):
        rows = rows_at_distances("edge")
        for row in rows:
            if row["verdict"] == "wrong" and row["distance"] is None:
                row["verdict"] = "within-rounding"
        exact, begin, _ = facts_of(rows)
        self.assertIn("2 results of 1 other system are wrong without saying so.", exact.sentence)
        self.assertEqual(exact.lines[1][1], ["27", "32", "2"])

    def test_the_interval_of_a_rate_is_that_of_wilson(self):
        for count, of in (0, 1), (0, 10), (1, 10), (5, 10), (10, 10), (3, 1000):
            low, high = wilson(count, of)
            rate = count / of
            self.assertTrue(0 <= low <= rate <= high <= 1)
            for bound in low, high:  # the rates at which the count is 1.96 standard deviations away
                if 0 < bound < 1:
                    self.assertAlmostEqual(abs(rate - bound), 1.959963984540054 * (bound * (1 - bound) / of) ** 0.5)
            self.assertEqual((low == 0, high == 1), (count == 0, count == of))
        self.assertEqual(wilson(0, 0), (0, 1))

    def test_too_few_data_for_a_fact_are_said(self):
        self.assertEqual([fact.headline for fact in facts_of([right_row("a", "f")])], ["–"] * 3)
        exact, begin, cost = facts_of([right_row("ours", "f")])
        self.assertEqual(exact.sentence, "results of ours are the exact ones.")
        self.assertTrue(begin.sentence.startswith("Not enough data"))
        self.assertTrue(cost.sentence.startswith("Not enough data"))


class Words(unittest.TestCase):
    def test_numbers_for_people(self):
        for value, text in ((0.0012345, "0.00123"), (9.996, "10.0"), (0.09996, "0.100"), (123456, "123,000"),
                            (999.6, "1,000"), (0, "0"), (math.nan, "–"), (1e-9, "1e-09")):
            self.assertEqual(words.three_digits(value), text)
        self.assertEqual((words.grouped(1234567), words.grouped(123)), ("1,234,567", "123"))
        for part, text in ((0, "0 %"), (1, "100 %"), (0.9999999, "99.99 %"), (0.00001, "0.001 %"),
                           (0.034, "3.4 %"), (0.5, "50 %")):
            self.assertEqual(words.percent(part), text)
        self.assertEqual(words.megabytes(1234567), "1.23")
        self.assertEqual([words.distance_text(k) for k in (16, 0, None)], ["10⁻¹⁶", "10⁰", "exact"])
        self.assertEqual([words.decade_text(e) for e in (-4, -3, -1, 0, 2, 3, 4)],
                         ["10⁻⁴", "0.001", "0.1", "1", "100", "1,000", "10⁴"])
        self.assertEqual((words.plural(1, "run"), words.plural(2000, "run")), ("1 run", "2,000 runs"))
