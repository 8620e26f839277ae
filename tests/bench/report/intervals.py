#!/usr/bin/env python3
"""graze-report's sections on intervals: their pages from recorded data, and their measurements in small.

usage: intervals.py [FOLDER-OF-PROGRAMS]
Programs that have not been built count as skipped (exit code 77 when all else holds).
"""
import copy
import json
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "bench"))

from report import context as contexts, figures, page  # noqa: E402
from report.sections import hard_intervals, intervals  # noqa: E402

PROGRAMS = None
DATA = json.loads((HERE / "intervals.json").read_text())
HARD = json.loads((HERE / "hard_intervals.json").read_text())


def words(blocks):
    """All text of the page, without the figures."""
    return " ".join(str(b.get("html", "")) + str(b.get("caption", "")) + str(b.get("rows", "")) for b in blocks)


def changed(rows, wanted, **values):
    """The recorded data, some rows of one list changed."""
    data = copy.deepcopy(DATA)
    for row in data[rows]:
        if all(row[key] == value for key, value in wanted.items()):
            row.update(values)
    return data


class Intervals(unittest.TestCase):
    def test_blocks(self):
        blocks = intervals.show(DATA)
        self.assertEqual([b["kind"] for b in blocks], ["text"] + 2 * ["figure"] + 5 * ["table"])
        for block in blocks:
            page.block_html(block, page.Numbering())
        if figures.matplotlib:
            self.assertTrue(all(b["svg"].startswith("<svg") for b in blocks if b["kind"] == "figure"))

    def test_graze_is_sound_and_tight_as_recorded(self):
        self.assertIn("judged results is the tightest enclosure", intervals.summary(DATA)[0])

    def test_an_unsound_result_of_graze_is_told(self):
        selected = {"library": "interval<>", "operation": "exp", "operands": "hard"}
        data = changed("verdicts", selected, unsound=2, tight=510, example=DATA["verdicts"][0]["example"])
        self.assertIn("2 are unsound", intervals.summary(data)[0])
        self.assertIn(["Graze\u00a0scalar", "exp", "2 of 2,048"], [row[:3] for row in intervals.show(data)[-1]["rows"]])

    def test_a_faster_peer_is_told(self):
        slow = changed("times", {"library": "CGAL unprotected"}, ns=9.0, low=8.9, high=9.1)
        self.assertNotIn("CGAL unprotected on mul", intervals.rivals_text(intervals.Results(slow)))
        fast = changed("times", {"library": "CGAL unprotected"}, ns=0.02, low=0.019, high=0.021)
        self.assertIn("CGAL unprotected on mul takes 0.0", intervals.rivals_text(intervals.Results(fast)))

    def test_what_a_faster_peer_takes_where_operands_do_not_repeat(self):
        fast = changed("times", {"library": "CGAL unprotected"}, ns=0.02, low=0.019, high=0.021)
        fast["many"] = [{**t, "ns": 3.0 if t["library"] == "CGAL unprotected" else 1.5} for t in fast["times"]
                        if t["operation"] == "mul"]
        results = intervals.Results(fast)
        self.assertIn("(2.00 on 65,536 operands", intervals.rivals_text(results))
        tables = [b for b in intervals.show(fast) if "65,536 operands" in str(b.get("caption", ""))]
        self.assertTrue(any(str(cell).startswith("3") for b in tables for row in b.get("rows", []) for cell in row))

    def test_unsound_peers_are_no_rivals_at_equal_error(self):
        fast = changed("times", {"library": "Boost", "operation": "sin"}, ns=0.02, low=0.019, high=0.021)
        text = intervals.rivals_text(intervals.Results(fast))
        self.assertIn("Faster, but unsound: Boost on sin", text)
        self.assertNotIn("Boost on sin takes", text)

    def test_wider_peers_are_told_apart(self):
        fast = changed("times", {"library": "Arb", "operation": "exp"}, ns=0.02, low=0.019, high=0.021)
        text = intervals.rivals_text(intervals.Results(fast))
        self.assertRegex(text, "Faster, sound, but wider: .*Arb on exp")

    def test_quartiles_of_google_benchmark(self):
        runs = [{"run_type": "iteration", "run_name": "add/mixed/Boost/repeats:3", "cpu_time": 100.0 * ns}
                for ns in (1, 2, 9)]
        aggregate = {"run_type": "aggregate", "run_name": "add/mixed/Boost/repeats:3", "cpu_time": 1e9}
        self.assertEqual(intervals.times_of(
            {"context": {"operands": "100"}, "benchmarks": [*runs, aggregate]}), [
            {"operation": "add", "operands": "mixed", "library": "Boost", "ns": 2, "low": 1.5, "high": 5.5}])


class HardIntervals(unittest.TestCase):
    def test_blocks(self):
        blocks = hard_intervals.show(HARD)
        self.assertEqual([b["kind"] for b in blocks], ["text", "table", "table"])
        for block in blocks:
            page.block_html(block, page.Numbering())

    def test_claims_follow_the_data(self):
        text = words(hard_intervals.show(HARD))
        self.assertIn("Graze holds the true value in 8 of 8 expressions", text)
        self.assertIn("Boost is wrong on (1 - cos x)/x^2", text)
        self.assertIn("Narrower than Graze and sound: Arb on exp(y log x)", text)
        data = copy.deepcopy(HARD)
        for answer in data["answers"]:
            if answer["library"] == "interval<>" and answer["expression"] == "Thirds":
                answer["verdict"] = "wrong"
        text = words(hard_intervals.show(data))
        self.assertIn("Graze holds the true value in 7 of 8", text)
        self.assertIn("Graze scalar is wrong on 3 (4/3 - 1) - 1", text)

    def test_digits_of_the_true_value(self):
        for value, words in (("-9007199254740992", "-9007199254740992"), ("408811723375.659584999", "408811723375…"),
                             ("0.49999999999999999583", "0.499999999999…"), ("0", "0"),
                             ("2.2844130418931805224e+222", "2.28441304189…e+222")):
            self.assertEqual(hard_intervals.true_text({"true": value}), words)

    def test_decimals_are_rounded_outwards(self):
        self.assertEqual(hard_intervals.outward(1 / 3, False, 4), "0.3333")
        self.assertEqual(hard_intervals.outward(1 / 3, True, 4), "0.3334")
        self.assertEqual(hard_intervals.outward(-1 / 3, False, 4), "-0.3334")
        self.assertEqual(hard_intervals.outward(0.99999, True, 4), "1")
        self.assertEqual(hard_intervals.outward(1.5, True, 4), "1.5")
        self.assertEqual(hard_intervals.outward(-1.23456e300, False, 4), "-1.235e300")


class Measurement(unittest.TestCase):
    def context(self, folder, *names):
        context = contexts.Context(folder, quick=True, core=min(contexts.os.sched_getaffinity(0)),
                                   build=PROGRAMS.parent if PROGRAMS else "nowhere")
        if any(context.program(n) is None for n in names):
            self.skipTest(f"{', '.join(names)}: not built")
        return context

    def test_hard_expressions(self):
        with tempfile.TemporaryDirectory() as folder:
            data = hard_intervals.measure(self.context(folder, "graze-hard-intervals"))
        ours = hard_intervals.counts(data, "interval<>")
        self.assertEqual(set(ours), {"holds", "useless"})
        self.assertGreater(hard_intervals.counts(data, "double")["wrong"], 10)
        hard_intervals.show(data)

    def test_answers_are_judged(self):
        with tempfile.TemporaryDirectory() as folder:
            context = self.context(folder, "graze-interval-report")
            rows = context.json_lines([context.needed("graze-interval-report"), "--count", 64])[1:]
        for row in rows:
            if intervals.is_graze(row["library"]):
                self.assertEqual((row["unsound"], row["unbounded"], row["tight"]), (0, 0, row["count"]), row)
        self.assertTrue(any(r["unsound"] for r in rows if r["library"] == "double"))
        self.assertTrue(any(r["unsound"] for r in rows if r["library"] == "Boost"))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        PROGRAMS = pathlib.Path(sys.argv.pop())
    result = unittest.main(exit=False).result
    sys.exit(1 if not result.wasSuccessful() else 77 if result.skipped else 0)
