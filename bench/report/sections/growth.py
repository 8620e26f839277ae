"""Time and memory against NL, the octree's level, pixels, surfaces, terms of a formula, and threads."""
import itertools
import json
import math
import os

from report import figures, page, statistics

NAME = "growth"
TITLE = "Cost growth: time and memory against the size of the work"
TARGETS = ["graze-render", "graze-voxelize", "graze-traversal-bench", "graze-fuzz"]
METHODS = {"certified": [], "descent": ["--levels", "30"]}
PATHS = ["avx512", "avx2", "baseline", "scalar"]


def measure(context):
    """Each part's repetitions run over all of its cases in turn, so that what else the machine does meets all."""
    starts = [context.measured([context.needed("graze-render"), "--version"]) for _ in range(5)]
    start, base = min(s.processor for s in starts), statistics.median([s.peak_bytes for s in starts])
    parts = {"nl": levels_of_descent, "octree": octree_levels, "pixels": pixels, "spheres": spheres, "terms": terms,
             "threads": threads, "campaign": campaign_threads}
    data = {"load": os.getloadavg()[0], "start_seconds": start, "start_bytes": base,
            "cores": len(os.sched_getaffinity(0))}
    for name, part in parts.items():
        context.progress(name)
        data[name] = part(context, start)
    return data


def render(context, start, arguments, core=None):
    """What graze-render tells; seconds are the rendering's (the octree's included) by the clock, or the processor
    time of the process less that of its start, where that is less: others' work on the core is left out. By the clock
    alone where start is None."""
    program = context.needed("graze-render")
    command = [program, *arguments, "--json", "-o", context.scratch / "growth.png"]
    usage = context.measured(command, core=core)
    result = json.loads(usage.stdout.splitlines()[-1])
    seconds = result["seconds"] + result["octree_seconds"]
    if start is not None:
        seconds = min(seconds, max(usage.processor - start, 1e-4))
    return {"seconds": seconds, "peak_bytes": usage.peak_bytes, "hits": result["hits"],
            "undecided": result["undecided"], "pixels": result["pixels"],
            "steps_per_ray": result["octants_per_ray"]}


def in_turn(cases, run, repetitions, least=3, patience=1.0):
    """Rows of cases with medians and quartiles of seconds; what takes longer than `patience` seconds has no more
    than `least` repetitions. A first run of the first case is not counted."""
    times, last = [[] for _ in cases], [None] * len(cases)
    run(cases[0])
    for _ in range(repetitions):
        for k, case in enumerate(cases):
            if len(times[k]) >= least and times[k][0] > patience:
                continue
            last[k] = run(case)
            times[k].append(last[k]["seconds"])
    return [{**case, **result, "seconds": statistics.spread(t)} for case, result, t in zip(cases, last, times)]


def levels_of_descent(context, start):
    """First hits of 2^16 camera rays by graze-traversal-bench, and graze-render's memory."""
    command = [context.needed("graze-traversal-bench"), "surface", "--json", "--scene", "tanglecube", "--size",
               context.share(256, 64), "--repetitions", context.share(9, 3)]
    rows = context.json_lines(command)
    cases = [{"levels": n} for n in (10, 20, 30, 40, 50, 53)]
    common = ["--scene", "tanglecube", "--threads", "1", "--size", context.share(256, 96)]
    memory = in_turn(cases, lambda c: render(context, start, [*common, "--levels", c["levels"]]), context.share(3, 1))
    return {"rows": rows, "memory": memory}


def octree_levels(context, _start):
    """Voxelization of three scenes."""
    program = context.needed("graze-voxelize")

    def run(case):
        usage = context.measured([program, "--scene", case["scene"], "--level", case["level"], "--threads", "1",
                                  "--json", "-o", context.scratch / "growth.octree"])
        result = json.loads(usage.stdout.splitlines()[-1])
        return {key: result[key] for key in ("seconds", "leaves", "nodes", "bytes")} | {"peak_bytes": usage.peak_bytes}

    last = context.share(12, 10)
    scenes = context.share(["tanglecube", "spheres", "holesrot"], ["tanglecube"])
    cases = [{"scene": s, "level": n} for s in scenes for n in range(5, last + 1)]
    return in_turn(cases, run, context.share(7, 3), patience=0.5)


def pixels(context, start):
    sizes = context.share([128, 256, 512, 1024, 2048], [128, 256, 512])
    cases = [{"method": m, "size": n} for m in METHODS for n in sizes]
    common = ["--scene", "tanglecube", "--threads", "1"]
    return in_turn(cases, lambda c: render(context, start, [*common, "--size", c["size"], *METHODS[c["method"]]]),
                   context.share(7, 3))


def ball_formula(n):
    """n balls around the points of a Fibonacci lattice on the unit sphere, their cross-sections together the same."""
    turn, parts = math.pi * (3 - math.sqrt(5)), []
    for k in range(n):
        z = 1 - (2 * k + 1) / n
        r = math.sqrt(1 - z * z)
        parts.append(f"(x-({r * math.cos(turn * k):.3f}))^2+(y-({r * math.sin(turn * k):.3f}))^2+(z-({z:.3f}))^2"
                     f"-{0.36 / n:.6f}")
    return f"min({', '.join(parts)})" if n > 1 else parts[0]


def term_formula(n):
    """A ball's polynomial with n small monomials besides, so that the picture stays nearly the same."""
    powers = sorted((sum(p), p) for p in itertools.product(range(7), repeat=3) if 3 <= sum(p) <= 6)
    chosen = [powers[k * len(powers) // n][1] for k in range(n)]
    small = "".join(f" {'+-'[k % 2]} {0.1 / n:.6f}*x^{a}*y^{b}*z^{c}" for k, (a, b, c) in enumerate(chosen))
    return f"x^2 + y^2 + z^2 - 1{small}"


def formulas(context, start, key, counts, formula):
    side = context.share(256, 96)  # the middle of a picture of twice the size: few pixels beside the balls
    common = ["--domain=-1.75,1.75", "--threads", "1", "--size", 2 * side, "--crop",
              f"{side // 2},{side // 2},{side},{side}"]
    cases = [{"method": m, key: n} for m in METHODS for n in counts]
    return in_turn(cases, lambda c: render(context, start, ["--formula", formula(c[key]), *common,
                                                            *METHODS[c["method"]]]),
                   context.share(5, 3))


def spheres(context, start):
    return formulas(context, start, "surfaces", context.share([1, 2, 4, 8, 16, 32, 64], [1, 4, 16]), ball_formula)


def terms(context, start):
    return formulas(context, start, "terms", context.share([2, 4, 8, 16, 32, 64], [2, 8, 32]), term_formula)


def thread_counts(context):
    """1, 2, 4 ... and all, and the cores that they run on, the pinned one first."""
    cores = sorted(os.sched_getaffinity(0), key=lambda core: (core != context.core, core))
    counts = sorted({2 ** k for k in range(10) if 2 ** k <= len(cores)} | {len(cores)})
    return {n: ",".join(map(str, cores[:n])) for n in counts}


def threads(context, _start):
    on, size = thread_counts(context), context.share(1024, 384)
    cases = [{"method": m, "threads": n} for n in on for m in METHODS]

    def run(case):
        arguments = ["--scene", "tanglecube", "--size", size, "--threads", case["threads"], *METHODS[case["method"]]]
        return render(context, None, arguments, core=on[case["threads"]])

    return in_turn(cases, run, context.share(7, 3))


def campaign_threads(context, _start):
    on, rays, program = thread_counts(context), context.share(1000000, 60000), context.needed("graze-fuzz")

    def run(case):
        usage = context.measured([program, "run", "--traversal", "sound", "--level", 50, "--seed", 22, "--rays", rays,
                                  "--threads", case["threads"], "--json"], core=on[case["threads"]])
        result = json.loads(usage.stdout)
        return {key: result[key] for key in ("seconds", "rays", "misses")} | {"peak_bytes": usage.peak_bytes}

    return in_turn([{"threads": n} for n in on], run, context.share(5, 2))


# --- the page


def spread_lists(rows, scale=1.0):
    """y, y_low, y_high of rows' seconds."""
    return {name: [row["seconds"][key] * scale for row in rows]
            for name, key in (("y", "median"), ("y_low", "low"), ("y_high", "high"))}


def grouped_by(rows, key):
    return {value: [r for r in rows if r[key] == value] for value in dict.fromkeys(r[key] for r in rows)}


def ns_rows(rows):
    """ns a ray of graze-traversal-bench's rows: y, y_low, y_high."""
    return {name: [1e6 * r[key] / r["rays"] for r in rows]
            for name, key in (("y", "milliseconds"), ("y_low", "milliseconds_low"), ("y_high", "milliseconds_high"))}


def nl_series(data):
    hits = [r for r in data["nl"]["rows"] if r["what"] == "first_hit"]
    against_nl = grouped_by([r for r in hits if r["octree_level"] == 9], "path")
    stored = sorted((r for r in hits if r["levels"] == 30), key=lambda r: r["octree_level"])
    return against_nl, grouped_by(stored, "path")


def nl_fits(data):
    """Lines of ns a ray against NL, by path; `beyond`: of NL = 53, where octants are a few ulps wide, ns above."""
    fits = {}
    for path, rows in nl_series(data)[0].items():
        below = [r for r in rows if r["levels"] <= 50]
        fit = statistics.line([r["levels"] for r in below], ns_rows(below)["y"])
        last = [y - fit["intercept"] - fit["slope"] * r["levels"]
                for r, y in zip(rows, ns_rows(rows)["y"]) if r["levels"] == 53]
        fits[path] = {**fit, "beyond": last[0] if last else None}
    return fits


def plus_minus(value, error, digits=2):
    return f"{value:.{digits}f}" + (f" ± {error:.{digits}f}" if error is not None else "")


def exponent_row(title, against, xs, ys, expected):
    """A power fitted to the larger half of the sizes, four at least: the smaller ones are mostly the fixed cost."""
    kept = sorted(zip(xs, ys))[-max(4, (len(xs) + 1) // 2):]
    fit = statistics.exponent(*zip(*kept))
    return {"what": title, "against": against, "exponent": fit["exponent"], "error": fit["error"],
            "r_squared": fit["r_squared"], "range": f"{kept[0][0]} to {kept[-1][0]}", "points": len(kept),
            "said": expected}


def exponents(data):
    """Every fitted power."""
    found = []
    for scene, rows in grouped_by(data["octree"], "scene").items():
        sides = [2 ** r["level"] for r in rows]
        found.append(exponent_row(f"{scene}: octants of the last level", "octants a side, 2^level", sides,
                                  [r["leaves"] for r in rows], "2: a surface"))
        found.append(exponent_row(f"{scene}: time of voxelization", "octants of the last level",
                                  [r["leaves"] for r in rows], [r["seconds"]["median"] for r in rows],
                                  "1: the same for each octant"))
        found.append(exponent_row(f"{scene}: bytes of the octree's file", "octants of the last level",
                                  [r["leaves"] for r in rows], [r["bytes"] for r in rows], "1"))
    for part, key, against, expected in (("pixels", "pixels", "pixels", "1: the same for each ray"),
                                         ("spheres", "surfaces", "balls", "1, were each ball asked at each step"),
                                         ("terms", "terms", "terms", "1, were each term as dear as the first")):
        for method, rows in grouped_by(data[part], "method").items():
            found.append(exponent_row(f"{method}: time of a picture", against, [r[key] for r in rows],
                                      [r["seconds"]["median"] for r in rows], expected))
    return found


def speed_ups(data):
    """[(what, threads, speed-up, share of the ideal)]."""
    found = []
    series = [(f"picture, {method}", rows) for method, rows in grouped_by(data["threads"], "method").items()]
    for title, rows in [*series, ("campaign with its exact judge", data["campaign"])]:
        single = rows[0]["seconds"]["median"]
        found += [(title, r["threads"], single / r["seconds"]["median"],
                   single / r["seconds"]["median"] / r["threads"]) for r in rows if r["threads"] > 1]
    return found


def memory_line(rows, key):
    """Peak bytes as a line of what `key` counts."""
    return statistics.line([r[key] for r in rows], [r["peak_bytes"] for r in rows])


def above(data, rows):
    """MiB of rows' peak memory above that of the program's start."""
    return [(r["peak_bytes"] - data["start_bytes"]) / 2**20 for r in rows]


def size_of(count):
    for unit, size in (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10)):
        if abs(count) >= size:
            return f"{count / size:.1f} {unit}"
    return f"{count:.0f} B"


def show(data):
    return [*show_nl(data), *show_octree(data), *show_pixels(data), *show_formulas(data), *show_threads(data),
            *show_exponents(data)]


def show_nl(data):
    against_nl, stored = nl_series(data)
    fits = nl_fits(data)
    memory = [r["peak_bytes"] for r in data["nl"]["memory"]]

    def series(groups, key):
        return [{"library": path, "x": [r[key] for r in groups[path]], **ns_rows(groups[path])}
                for path in PATHS if path in groups]

    svg = figures.line_panels([
        {"series": series(against_nl, "levels"), "x_label": "NL, levels of the descent", "y_label": "time of a ray, ns",
         "title": "octree stored to level 9"},
        {"series": series(stored, "octree_level"), "x_label": "level of the stored octree, levels",
         "y_label": "time of a ray, ns", "title": "NL = 30"}])
    slopes = "; ".join(f"{path} {plus_minus(fits[path]['slope'], fits[path]['slope_error'], 1)}"
                       for path in PATHS if path in fits)
    rays = next(iter(against_nl.values()))[0]["rays"]
    caption = (f"First hits of tanglecube by the descent, {rays:.0f} camera rays on one core, each path of the lanes "
               f"and the scalar code. Left: a line fits the time up to NL = 50 with R² of at least "
               f"{min(f['r_squared'] for f in fits.values()):.3f}; ns a ray for each further level: {slopes}. Right: "
               f"{stored_words(stored)}")
    rows = [[r["levels"], steps_of(against_nl, r["levels"]), f"{r['seconds']['median']:.3f}", size_of(r["peak_bytes"])]
            for r in data["nl"]["memory"]]
    note = (f"Pictures by the descent, {data['nl']['memory'][0]['pixels']} pixels: peak memory lies between "
            f"{size_of(min(memory))} and {size_of(max(memory))} for every NL, since levels below the stored octree are "
            "evaluated, not stored.")
    return [page.heading("NL and the stored octree"), page.figure(svg, caption),
            page.table(["NL", "octants opened a ray", "picture, s", "peak memory"], rows, note)]


def stored_words(stored):
    """What the stored octree's level changes, for the fastest path."""
    path = next(p for p in PATHS if p in stored)
    ordered = sorted(stored[path], key=lambda r: r["milliseconds"])
    ratio = ordered[-1]["milliseconds"] / ordered[0]["milliseconds"]
    return (f"of the stored octree's levels {ordered[0]['octree_level']} is the fastest for {path}, and "
            f"{ordered[-1]['octree_level']} takes {ratio:.2f} times as long.")


def steps_of(groups, levels):
    found = [r["steps_per_ray"] for rows in groups.values() for r in rows if r["levels"] == levels]
    return f"{found[0]:.1f}" if found else ""


def show_octree(data):
    series, memory = [], []
    for scene, rows in grouped_by(data["octree"], "scene").items():
        look = SCENES_LOOK.get(scene, {})
        series.append({"library": scene, "x": [r["leaves"] for r in rows], **spread_lists(rows, 1e3), **look})
        seen = [(r["leaves"], m) for r, m in zip(rows, above(data, rows)) if m >= 1]
        if seen:
            memory.append({"library": scene, "x": [x for x, _ in seen],
                           "y": [m for _, m in seen], **look})
    rows = sorted(data["octree"], key=lambda r: r["leaves"])
    memory.append({"library": "file", "label": "file, each scene", "x": [r["leaves"] for r in rows], "dashed": True,
                   "y": [r["bytes"] / 2**20 for r in rows], "colour": "#444"})
    svg = figures.line_panels([
        {"series": series, "x_label": "octants of the last level, number", "y_label": "time of voxelization, ms",
         "log_x": True, "log_y": True, "title": "time"},
        {"series": memory, "x_label": "octants of the last level, number", "y_label": "memory, MiB", "log_x": True,
         "log_y": True, "title": "memory"}])
    deepest = {scene: rows[-1] for scene, rows in grouped_by(data["octree"], "scene").items()}
    words = "; ".join(f"{scene} {r['seconds']['median'] / r['leaves'] * 1e9:.0f} ns and "
                      f"{r['bytes'] / r['leaves']:.2f} bytes an octant" for scene, r in deepest.items())
    levels = [r["level"] for r in data["octree"]]
    caption = (f"Voxelization from level {min(levels)} to level {max(levels)}, one thread: above a fixed cost, time "
               "and bytes follow the octants that the surface meets, four times as many with each level. At the "
               f"deepest level: {words}. Memory is above the program's own {size_of(data['start_bytes'])}, from 1 MiB "
               "on; dotted, the file that is written.")
    return [page.heading("The octree's level"), page.figure(svg, caption)]


SCENES_LOOK = {"tanglecube": {"colour": "#0b5fa5", "marker": "o"}, "spheres": {"colour": "#d55e00", "marker": "s"},
               "holesrot": {"colour": "#009e73", "marker": "v"}}


def method_series(rows, key, scale=1.0):
    return [{"library": method, "x": [r[key] for r in group], **spread_lists(group, scale)}
            for method, group in grouped_by(rows, "method").items()]


def show_pixels(data):
    rows = grouped_by(data["pixels"], "method")
    memory = [{"library": m, "x": [r["pixels"] for r in group], "y": [max(0.0, m) for m in above(data, group)]}
              for m, group in rows.items()]
    ticks = {r["pixels"]: f"{r['size']}²" for r in data["pixels"]}
    svg = figures.line_panels([
        {"series": method_series(data["pixels"], "pixels"), "x_label": "pixels of the picture, number",
         "y_label": "time of a picture, s", "log_x": True, "log_y": True, "title": "time", "x_ticks": ticks},
        {"series": memory, "x_label": "pixels of the picture, number", "y_label": "peak memory above the start's, MiB",
         "log_x": True, "title": "memory", "x_ticks": ticks}])
    ratio = rows["descent"][-1]["seconds"]["median"] / rows["certified"][-1]["seconds"]["median"]
    lines = {m: memory_line(group, "pixels") for m, group in rows.items()}
    words = ", ".join(f"{m} {line['slope']:.0f} bytes a pixel above {size_of(line['intercept'])}"
                      for m, line in lines.items())
    largest = rows["certified"][-1]["size"]
    caption = (f"Pictures of tanglecube on one thread; the descent goes to NL = 30, its octree included. At "
               f"{largest}x{largest} the descent takes {ratio:.1f} times as long as certified hits. Memory is a line "
               f"of the pixels: {words}.")
    return [page.heading("Pixels"), page.figure(svg, caption)]


def show_formulas(data):
    panels, words = [], []
    for part, key, label, title in (("spheres", "surfaces", "balls in the union, number", "union of balls"),
                                    ("terms", "terms", "terms added to the ball, number", "one polynomial")):
        panels.append({"series": method_series(data[part], key), "x_label": label, "y_label": "time of a picture, s",
                       "log_x": True, "log_y": True, "title": title})
        for method, rows in grouped_by(data[part], "method").items():
            growth = rows[-1]["seconds"]["median"] / rows[0]["seconds"]["median"]
            words.append(f"{rows[-1][key]} {'terms' if part == 'terms' else 'balls'} take {growth:.1f} times as long "
                         f"as {rows[0][key]} ({method})")
    some = data["spheres"][0]
    caption = (f"Pictures of formulas on one thread, {some['pixels']} pixels. Left: min(...) of balls whose "
               "cross-sections together stay the same; right: a ball's polynomial with small monomials of degree 3 to "
               f"6 added, nearly the same picture. {'; '.join(words)}.")
    peaks = [r["peak_bytes"] for part in ("spheres", "terms") for r in data[part]]
    return [page.heading("Surfaces and terms"), page.figure(figures.line_panels(panels), caption),
            page.text(f"Peak memory of these pictures: {size_of(min(peaks))} to {size_of(max(peaks))}.")]


def show_threads(data):
    rows = [[title, n, f"{up:.2f}", f"{100 * share:.0f} %"] for title, n, up, share in speed_ups(data)]
    cores = data["cores"]
    only = f"This machine has {cores} core{'s' if cores > 1 else ''} for it: more threads were not measured."
    blocks = [page.heading("Threads")]
    if not rows:
        return [*blocks, page.text(f"<p>{only}</p>")]
    most = max(int(r[1]) for r in rows)
    series = []
    for title in dict.fromkeys(r[0] for r in rows):
        points = [(1, 1.0)] + [(n, up) for w, n, up, _ in speed_ups(data) if w == title]
        series.append({"library": title.split()[-1] if "picture" in title else title, "label": title,
                       "x": [n for n, _ in points], "y": [up for _, up in points]})
    series.append({"library": "ideal", "x": [1, most], "y": [1, most], "dashed": True, "colour": "#444"})
    svg = figures.lines(series, "threads, number", "speed-up, times one thread", height=360,
                        x_ticks={n: str(n) for n in sorted({1, *(r[1] for r in rows)})})
    blocks.append(page.figure(svg, f"Times as fast as one thread, by the clock; the dotted line is the ideal. {only} "
                              "Pictures and campaigns share nothing but their result among threads; what else the "
                              f"machine does moves the lines (its load before: {data.get('load', 0):.1f})."))
    memory = "; ".join(f"{r['threads']}: {size_of(r['peak_bytes'])}" for r in data["threads"]
                       if r["method"] == "certified")
    return [*blocks, page.table(["work", "threads", "speed-up", "of the ideal"], rows,
                                f"Speed-up by threads. Peak memory of the certified picture by threads: {memory}.")]


def show_exponents(data):
    rows = [[r["what"], r["against"], plus_minus(r["exponent"], r["error"]), r["said"], f"{r['r_squared']:.4f}",
             r["range"], r["points"]] for r in exponents(data)]
    lines = [[path, plus_minus(fit["slope"], fit["slope_error"], 1), f"{fit['intercept']:.0f}",
              f"{fit['r_squared']:.4f}", fit["points"], "" if fit["beyond"] is None else f"{fit['beyond']:.0f}"]
             for path, fit in sorted(nl_fits(data).items(), key=lambda item: PATHS.index(item[0]))]
    return [page.heading("Fitted growth"),
            page.table(["what", "against", "exponent", "expected", "R²", "range", "points"], rows,
                       "Least squares in logarithms over the larger sizes (range), with the slope's standard error. An "
                       "exponent below the expected one comes from a part that does not grow (the start of threads, "
                       "pixels that meet nothing)."),
            page.table(["path", "ns for a further level", "ns at NL = 0", "R²", "points",
                        "ns above the line at NL = 53"], lines,
                       "Time of a ray as a line of NL up to 50, least squares. At NL = 53 an octant is a few ulps "
                       "wide, and enclosures can no longer tell it from its neighbours: more are opened.")]


def summary(data):
    best, fit = min(nl_fits(data).items(), key=lambda item: item[1]["slope"])
    powers = {(r["what"], r["against"]): r for r in exponents(data)}
    pixel = powers["certified: time of a picture", "pixels"]
    voxel = powers["tanglecube: time of voxelization", "octants of the last level"]
    sentences = [f"The descent's time against NL is a line with R² {fit['r_squared']:.3f}: "
                 f"{plus_minus(fit['slope'], fit['slope_error'], 1)} ns a ray for each further level ({best}, NL up to "
                 "50).",
                 f"Fitted exponents of time: voxelization by octants {plus_minus(voxel['exponent'], voxel['error'])}, "
                 f"a certified picture by pixels {plus_minus(pixel['exponent'], pixel['error'])}."]
    threads_most = max((n for _, n, _, _ in speed_ups(data)), default=None)
    if threads_most:
        ups = [up for _, n, up, _ in speed_ups(data) if n == threads_most]
        sentences.append(f"{threads_most} threads are {min(ups):.2f} to {max(ups):.2f} times as fast as one.")
    return sentences
