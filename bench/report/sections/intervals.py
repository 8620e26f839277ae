"""Operations on intervals: time against excess width, and unsound results."""
import json
import math
import shlex

from report import page, statistics
from report.sections import interval_figures
from report.sections.interval_libraries import group, is_held, name, short, tell_missing, ulps

NAME = "intervals"
TITLE = "Intervals: time against excess width"
TARGETS = ["interval_bench", "graze-interval-report", "graze-inari"]

ARITHMETIC = ["add", "sub", "mul", "div", "sqr", "sqrt"]
FUNCTIONS = ["exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "pown(x,4)",
             "pow"]
SETS = {"add": "mixed", "sub": "mixed", "mul": "mixed", "div": "mixed", "sqr": "mixed", "sqrt": "positive"}


def timed_set(operation):
    """The set of operands that the figures show."""
    return SETS.get(operation, "narrow")


# measuring

def measure(context):
    """Times by Google Benchmark, all contenders interleaved; verdicts by MPFR."""
    count, repetitions = context.share(4096, 512), context.share(15, 3)
    judge = [context.needed("graze-interval-report"), "--count", count]
    context.progress("answers are judged by MPFR")
    judged = context.json_lines(judge, timeout=context.share(600, 120))
    missing, verdicts = judged[0]["missing"], judged[1:]
    tell_missing(context, missing)
    out = context.scratch / "interval_bench.json"
    bench = [context.needed("interval_bench"), f"--benchmark_repetitions={repetitions}",
             f"--benchmark_min_time={context.share(0.05, 0.004)}", "--benchmark_enable_random_interleaving=true",
             f"--benchmark_out={out}", "--benchmark_out_format=json"]
    if context.quick:
        functions = "|".join(o.replace("(", r"\(").replace(")", r"\)") for o in FUNCTIONS)
        bench.append(f"--benchmark_filter=-polynomial|log/positive|^({functions})/mixed/")
    context.progress(f"operations are timed, {repetitions} repetitions in random order")
    context.run(bench, timeout=context.share(1200, 200))
    times = times_of(json.loads(out.read_text()))
    many = [*bench[:6], "--operands=65536", f"--benchmark_filter=^({'|'.join(ARITHMETIC)})/"]
    context.progress("arithmetic is timed on operands that branch predictors cannot learn")
    context.run(many, timeout=context.share(600, 100))
    return {"times": times, "many": times_of(json.loads(out.read_text())), "verdicts": verdicts, "missing": missing,
            "count": count, "repetitions": repetitions,
            "commands": [words_of(bench), words_of(many), words_of(judge)]}


def words_of(command):
    """A command as it can be repeated, without the folders of this run."""
    kept = [str(word) for word in command[1:] if not str(word).startswith("--benchmark_out")]
    return shlex.join([f"build/release/bin/{command[0].name}", *kept])


def times_of(benchmark):
    """[{operation, operands, library, ns, low, high}] of Google Benchmark's JSON: medians, quartiles."""
    runs, size = {}, int(benchmark["context"]["operands"])
    for run in benchmark["benchmarks"]:
        if run["run_type"] == "iteration":
            runs.setdefault(run["run_name"].split("/repeats:")[0], []).append(run["cpu_time"] / size)
    rows = []
    for title, ns in runs.items():
        operation, operands, library = title.split("/", 2)
        spread = statistics.spread(ns)
        rows.append({"operation": operation, "operands": operands, "library": library, "ns": spread["median"],
                     "low": spread["low"], "high": spread["high"]})
    return rows


# what the data says

class Results:
    """Times and verdicts of a run by (library, operation)."""

    def __init__(self, data):
        self.times = {(t["library"], t["operation"], t["operands"]): t for t in data["times"]}
        self.verdicts = {(v["library"], v["operation"], v["operands"]): v for v in data["verdicts"]}
        self.many = {(t["library"], t["operation"], t["operands"]): t for t in data.get("many", [])}
        self.libraries = list(dict.fromkeys(v["library"] for v in data["verdicts"]))

    def time(self, library, operation):
        return self.times.get((library, operation, timed_set(operation)))

    def time_of_many(self, library, operation):
        """On 65,536 operands, which no branch predictor learns."""
        return self.many.get((library, operation, timed_set(operation)))

    def verdict(self, library, operation):
        return self.verdicts.get((library, operation, timed_set(operation)))

    def all_sets(self, library, operation=None):
        """The verdicts on every set."""
        return [v for (peer, timed, _), v in self.verdicts.items() if peer == library and operation in (None, timed)]

    def has(self, library, operation):
        return self.time(library, operation) is not None and self.verdict(library, operation) is not None

    def unsound(self, library, operation=None):
        return sum(v["unsound"] for v in self.all_sets(library, operation))

    def with_all(self, operations):
        """The libraries that have some of the operations."""
        return [x for x in self.libraries if any(self.has(x, o) for o in operations)]


def is_graze(library):
    return group(library).startswith("Graze")


def is_plain(library):
    return group(library) == "double"


def rivals(results):
    """[(operation, peer, graze's library, ratio of times, mean excess)] where a peer that is sound on every set is
    faster than the fastest scalar graze that is called in the same way: quartiles apart, and 3 % at least."""
    found = []
    for operation in ARITHMETIC + FUNCTIONS:
        for held in (False, True):
            ours = fastest(results, operation, held)
            for peer in results.libraries:
                if ours is None or is_graze(peer) or is_plain(peer) or is_held(peer) != held:
                    continue
                if not results.has(peer, operation) or results.unsound(peer, operation):
                    continue
                theirs = results.time(peer, operation)
                wider = results.verdict(peer, operation)["mean_excess_ulps"]
                if theirs["high"] < ours["low"] and theirs["ns"] < 0.97 * ours["ns"]:
                    found.append((operation, peer, ours["library"], theirs["ns"] / ours["ns"], wider))
    return found


def fastest(results, operation, held):
    """The time of the fastest scalar graze whose caller holds a mode, or does not."""
    ours = [results.time(x, operation) for x in results.libraries
            if group(x) == "Graze scalar" and is_held(x) == held and results.has(x, operation)]
    return min(ours, key=lambda t: t["ns"], default=None)


def named_rivals(results, rows):
    return "; ".join(f"{name(peer)} on {operation} takes {ratio:.2f} of the time of {name(ours)}" +
                     of_many(results, operation, peer, ours) for operation, peer, ours, ratio, _ in rows)


def of_many(results, operation, peer, ours):
    """The same where operands do not repeat: a peer that branches on signs is fast while they are learned."""
    theirs, own = results.time_of_many(peer, operation), results.time_of_many(ours, operation)
    return f" ({theirs['ns'] / own['ns']:.2f} on 65,536 operands, too many to be learned)" if theirs and own else ""


def rivals_text(results, with_unsound=True):
    """Where a peer is faster, plainly."""
    all_rows = rivals(results)
    equal, wider = [r for r in all_rows if r[4] == 0], [r for r in all_rows if r[4] > 0]
    words = ["A peer is faster at equal error: " + named_rivals(results, equal) + "." if equal else
             "No sound peer that is called in the same way (a rounding mode held by the caller, or not) is faster "
             "than the fastest scalar Graze at equal error."]
    if wider:
        words.append("Faster, sound, but wider: " + named_rivals(results, wider) + ".")
    unsound = sorted({(name(x), o) for x in results.libraries for o in ARITHMETIC + FUNCTIONS
                      if not is_graze(x) and not is_plain(x) and results.has(x, o) and results.unsound(x, o)
                      and fastest(results, o, is_held(x))
                      and results.time(x, o)["ns"] < fastest(results, o, is_held(x))["ns"]})
    if unsound and with_unsound:
        libraries = dict.fromkeys(library for library, _ in unsound)
        words.append("Faster, but unsound: " + "; ".join(
            f"{library} on {', '.join(o for peer, o in unsound if peer == library)}" for library in libraries) + ".")
    return " ".join(words)


def soundness_text(results):
    """Graze's own verdict."""
    ours = [v for x in results.libraries if is_graze(x) for v in results.all_sets(x)]
    unsound, wide = sum(v["unsound"] for v in ours), sum(v["count"] - v["tight"] for v in ours)
    judged = sum(v["count"] for v in ours)
    if unsound == wide == 0:
        return f"Every one of Graze's {judged:,} judged results is the tightest enclosure."
    return f"Of Graze's {judged:,} judged results {unsound} are unsound and {wide} are not the tightest."


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def summary_points(results, operations):
    """[{library, x, y, unsound}]: time as a multiple of plain double's, geometric mean over the operations; worst
    excess over the timed operands and the points. Libraries that have all of the operations."""
    points = []
    for library in results.libraries:
        if not all(results.has(library, o) and results.has("double", o) for o in operations):
            continue
        ratios = [results.time(library, o)["ns"] / results.time("double", o)["ns"] for o in operations]
        worst = [v["worst_excess_ulps"] for o in operations for v in results.all_sets(library, o)
                 if v["operands"] == timed_set(o)]
        points.append({"library": library, "x": geometric_mean(ratios), "y": max(worst),
                       "marked": any(results.unsound(library, o) for o in operations)})
    return points


def common(results, operations):
    """The operations that most libraries which have any of them have."""
    libraries = results.with_all(operations)
    return [o for o in operations if 2 * sum(results.has(x, o) for x in libraries) > len(libraries)
            and all(results.has(x, o) for x in libraries if x in ("Boost", "MPFI"))]


# the page

def show(data):
    results = Results(data)
    blocks = [page.text(introduction(data))]
    blocks.append(page.figure(interval_figures.grid(results, ARITHMETIC + FUNCTIONS), grid_caption(results)))
    arithmetic = [o for o in ARITHMETIC if results.has("double", o)]
    functions = common(results, FUNCTIONS)
    blocks.append(page.figure(
        interval_figures.overview([("Arithmetic: " + ", ".join(arithmetic), summary_points(results, arithmetic)),
                                   ("Functions: " + ", ".join(functions), summary_points(results, functions))]),
        overview_caption(results)))
    for operations, word in ((ARITHMETIC, "arithmetic"), (FUNCTIONS, "functions")):
        blocks.append(time_table(results, operations, word))
        if operations is ARITHMETIC and results.many:
            blocks.append(many_table(results))
    blocks.append(excess_table(results, FUNCTIONS))
    blocks.append(set_table(results))
    blocks.append(unsound_table(results))
    return blocks


def summary(data):
    """Sentences for the head of the page."""
    results = Results(data)
    return [f"{soundness_text(results)} {fastest_text(results)}", rivals_text(results, with_unsound=False)]


def introduction(data):
    commands = "; ".join(f"<code>{page.escape(c)}</code>" for c in data["commands"])
    return (f"<p>Each library does the same operation on the same {data['count']:,} intervals of each set; 4,096 (or "
            f"65,536) are timed, one after the other, {data['repetitions']} repetitions of all contenders in random "
            "order. A result is <i>unsound</i> if a part of the true range is outside of it. Its <i>excess</i> is how far its "
            "two bounds are outside of the tightest enclosure, which MPFR finds, in ulps of the tightest bound (of "
            "the other bound where that is 0). Besides the timed operands, <i>points</i> (intervals of no width) "
            "and <i>hard</i> operands are judged: ties, subnormal and overflowing results, one-ulp neighbours, exact "
            "cases, arguments near multiples of pi/2 up to 2<sup>1023</sup>, values next to a double. MPFI has 53 "
            "bits; its bounds, whose exponents have no end, are rounded outwards to doubles. Arb's balls of 53 bits "
            "have a radius of 30 bits: to make an interval a ball, and back, costs width, so that Arb is best judged "
            "at points. Plain double answers with one number: it is the floor of time and never encloses what is "
            "inexact. Boost's arithmetic is judged here where the compiler knows neither operands nor rounding "
            "mode; where it does, it may fold an operation before the mode is set. Its functions are the C library's, "
            "by its rounded_transc_opp (<i>Boost</i>), by rounded_transc_std, which asks the C library in the mode of "
            "the bound (<i>Boost, std</i>), and with nothing rounded at all, arithmetic neither (<i>Boost, raw</i>). "
            "Graze is built for every x86-64 machine (no FMA or AVX in scalar arithmetic).</p>"
            f"<p>Repeated by {commands}.</p>")


def grid_caption(results):
    return ("An operation a panel: time to the right, mean excess upwards (the bar ends at the worst), both "
            "logarithmic; the shaded band at the bottom is an excess of exactly 0 ulp, a line for each library within "
            "it. A red cross: some result, on the timed, point or hard operands, is unsound. Hollow: the caller must "
            "hold a rounding mode. Functions are on intervals of width up to 2^-6. Best is the lower left without a "
            f"cross. {soundness_text(results)} {rivals_text(results)}")


def overview_caption(results):
    return ("Over all operations that the libraries have in common: the geometric mean of time as a multiple of plain, "
            "not vectorised double, against the worst excess on the timed operands. " + fastest_text(results))


def fastest_text(results):
    """Which is the fastest that is sound and tight."""
    words = []
    for operations, word in ((ARITHMETIC, "arithmetic"), (common(results, FUNCTIONS), "functions")):
        if not operations:
            continue
        points = [p for p in summary_points(results, operations) if not is_plain(p["library"])]
        sound = [p for p in points if not p["marked"] and p["y"] == 0]
        if sound:
            best = min(sound, key=lambda p: p["x"])
            peers = [p for p in sound if not is_graze(p["library"])]
            words.append(f"In {word} the fastest that is sound and tight is {name(best['library'])}, at "
                         f"{best['x']:.3g} times plain double" +
                         (f"; of the peers {name(peer['library'])}, at {peer['x']:.3g} times." if
                          (peer := min(peers, key=lambda p: p["x"], default=None)) else "; no peer is both."))
    return " ".join(words)


def time_table(results, operations, word):
    """A row for each of those that are more, libraries or operations."""
    libraries = results.with_all(operations)
    cells = {(x, o): time_cell(results.time(x, o)) for x in libraries for o in operations}
    if len(libraries) > len(operations):
        heads = ["library", *operations]
        rows = [[whole(name(x)), *(cells[x, o] for o in operations)] for x in libraries]
    else:
        heads = ["operation", *map(name, libraries)]
        rows = [[o, *(cells[x, o] for x in libraries)] for o in operations]
    return page.table(heads, rows,
                      f"Nanoseconds of an operation, {word}: medians, and half the distance of the quartiles where "
                      f"that is over 5 %. Operands: {operands_text(operations)}.")


def many_table(results):
    libraries = [x for x in results.with_all(ARITHMETIC) if any(results.time_of_many(x, o) for o in ARITHMETIC)]
    rows = [[whole(name(x)), *(time_cell(results.time_of_many(x, o)) for o in ARITHMETIC)] for x in libraries]
    return page.table(["library", *ARITHMETIC], rows,
                      "The same on 65,536 operands. The 4,096 of the table above repeat, and branch predictors learn "
                      "them: a library that branches on signs takes longer here; what has no branches differs by the "
                      "caches alone.")


def operands_text(operations):
    return "; ".join(f"{s} for {', '.join(o for o in operations if timed_set(o) == s)}"
                     for s in dict.fromkeys(map(timed_set, operations)))


def time_cell(time):
    if time is None:
        return "-"
    half = (time["high"] - time["low"]) / 2
    words = f"{time['ns']:.3g}" if time["ns"] < 1000 else f"{time['ns']:.0f}"
    return f"{words} ±{short(half, 1)}" if half > 0.05 * time["ns"] else words


def excess_cell(results, library, operation):
    if not results.has(library, operation):
        return "-"
    v = results.verdict(library, operation)
    words = f"{ulps(v['mean_excess_ulps'])} / {ulps(v['worst_excess_ulps'])}"
    share = f"{100 * v['unsound'] / v['count']:.2g}\u00a0%"
    return small(page.bad(f"{words}; {share}") if v["unsound"] else words)


def excess_table(results, operations):
    libraries = [x for x in results.with_all(operations) if not is_plain(x)]
    rows = [[o, *(excess_cell(results, x, o) for x in libraries)] for o in operations]
    return page.table(["function", *map(name, libraries)], rows,
                      "Mean / worst excess in ulps, of the sound results on the timed operands of the functions; "
                      "behind it, in red, the share of unsound results. Arithmetic is tight in every library but Arb.")


KINDS = {"timed": lambda v: v["operands"] not in ("points", "hard"), "points": lambda v: v["operands"] == "points",
         "hard": lambda v: v["operands"] == "hard"}


def set_row(results, library):
    """A library's verdicts on all operations: judged, unsound, tightest, unbounded, worst excess at points."""
    kinds = [[v for v in results.all_sets(library) if wanted(v)] for wanted in KINDS.values()]

    def each(cell_of):
        return [cell_of(rows) if rows and not (k == 0 and is_plain(library)) else "-" for k, rows in enumerate(kinds)]

    def unsound(rows):
        count = sum(v["unsound"] for v in rows)
        return page.bad(f"{100 * count / sum(v['count'] for v in rows):.2g} %") if count else "0"

    def tight(rows):
        return f"{100 * sum(v['tight'] for v in rows) / sum(v['count'] for v in rows):.3g} %"

    everything = results.all_sets(library)
    return [whole(name(library)), f"{sum(v['count'] for v in everything):,}", *each(unsound), *each(tight),
            f"{sum(v['unbounded'] for v in everything):,}",
            each(lambda rows: ulps(max(v["worst_excess_ulps"] for v in rows)))[1]]


def set_table(results):
    heads = ["library", "judged", *(f"{word} {kind}" for word in ("unsound", "tightest") for kind in KINDS),
             "un\u00adbounded", "worst points"]
    heads = [page.Raw(f'<span style="white-space:normal;font-size:.84em">{head}</span>') for head in heads]
    rows = [[first, *map(small, rest)] for first, *rest in (set_row(results, x) for x in results.libraries)]
    return page.table(heads, rows,
                      "All operations of a library together, by kind of operands: results judged, share that is "
                      "unsound, share that is the tightest enclosure, results that are needlessly unbounded or no interval (as "
                      "some answer where an operand is partly outside of the domain), worst excess at points in ulps. "
                      "Plain double takes points, of the hard operands too.")


def whole(words):
    """Not broken over lines."""
    return words.replace(" ", "\u00a0").replace("-", "\u2011")


def interval_text(pair):
    return pair[0] if pair[0] == pair[1] else f"[{pair[0]}, {pair[1]}]"


def small(words):
    """In smaller letters."""
    return page.Raw(f'<span style="font-size:.84em">{page.escape(words)}</span>')


def unsound_table(results):
    rows = []
    for library in results.libraries:
        for operation in ARITHMETIC + FUNCTIONS:
            bad = [v for v in results.all_sets(library, operation) if v["unsound"]]
            if not bad or is_plain(library) or library == "Boost not rounded":
                continue
            example = bad[0]["example"]
            two = operation in ("add", "sub", "mul", "div", "atan2", "pow")
            judged = sum(v["count"] for v in results.all_sets(library, operation))
            rows.append([whole(name(library)), operation, f"{sum(v['unsound'] for v in bad):,} of {judged:,}",
                         small(interval_text(example["x"]) + (", " + interval_text(example["y"]) if two else "")),
                         small(interval_text(example["answer"])), small(interval_text(example["tightest"]))])
    caption = ("Unsound results on all operands, with an example of each: operands, answer, and the tightest "
               "enclosure, which the answer does not hold. Plain double and Boost, raw, unsound wherever the result "
               "is inexact, are left out.")
    if not rows:
        return page.text("<p>No library's results are unsound, but those of plain double and of Boost, raw.</p>")
    return page.table(["library", "operation", "unsound", "operands", "answer", "tightest"], rows, caption)
