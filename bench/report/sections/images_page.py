"""The page of the section images: figures, tables, and captions that are computed from the data."""
import povray
from report import figures, page, statistics

SOUND = ["avx512", "avx2", "baseline", "upward"]
OLD = ["published", "gargantini", "plain"]
CERTIFIED = ["certified avx512", "certified avx2", "certified baseline"]
TABLE = ["gargantini", "plain", "published", "split", "upward", "avx512", "exact"]
KNOWN_HITS = {("tanglecube", 512): 97549, ("quartdef", 512): 109209}
FIDGET = ["tanglecube", "quartdef"]


def wrong(row):
    return row["wrong_hits"] + row["wrong_misses"]


def row_of(scene, method, levels=30):
    return next((r for r in scene["rows"] if r["method"] == method and r["levels"] == levels), None)


def best(scene, methods, levels):
    """The fastest of the methods at that level."""
    rows = [r for r in map(lambda m: row_of(scene, m, levels), methods) if r]
    return min(rows, key=lambda r: r["seconds"]) if rows else None


def pixels(count):
    return "no wrong pixel" if count == 0 else "1 wrong pixel" if count == 1 else f"{count:,} wrong pixels"


def marked(count):
    """A cell: red where it is not 0."""
    return page.bad(count) if count else 0


def seconds_text(s):
    return f"{s:.4f}" if s < 0.1 else f"{s:.3f}" if s < 1 else f"{s:.2f}" if s < 10 else f"{s:.1f}"


def scientific(x):
    return "-" if x is None else f"{x:.1e}".replace("e-0", "e-")


def power(x):
    """1e-9"""
    return f"{x:.0e}".replace("e-0", "e-")


def show(data):
    scenes = data["scenes"]
    blocks = [page.text(about(data))]
    for name, scene in scenes.items():
        blocks.append(page.figure(scene_figure(name, scene, fidget_of(data, name)), scene_caption(name, scene, data)))
    panels = [name for name in FIDGET if name in scenes]
    if panels:
        blocks.append(page.figure(wrong_figure(scenes, panels), wrong_caption(scenes, panels)))
    if any(scene["povray"] for scene in scenes.values()):
        blocks.append(povray_table(scenes))
    if data["fidget"]:
        blocks.append(fidget_table(data))
    blocks += [mistakes_table(scenes), paper_table(scenes), level_table(scenes)]
    return blocks


def summary(data):
    """Sentences for the page's top."""
    notes, scenes = [], data["scenes"]
    ratios = {name: povray_ratio(scene) for name, scene in scenes.items() if povray_ratio(scene)}
    if ratios:
        low, high = min(ratios, key=ratios.get), max(ratios, key=ratios.get)
        mistaken = sum(wrong(best(scene, CERTIFIED, 0)) for scene in scenes.values())
        span = f"{ratios[low]:.0f} ({low})" + (f" to {ratios[high]:.0f} ({high})" if high != low else "")
        notes.append(f"Images: certified casting to some ulps is {span} times as fast as POV-Ray's isosurface at its "
                     f"finest accuracy, with {pixels(mistaken)}." if ratios[low] > 1 else
                     f"Images: POV-Ray's isosurface is faster than certified casting on {low}.")
    for entry in data["fidget"][:1]:
        notes.append(fidget_words(entry))
    return notes


def about(data):
    scenes = data["scenes"]
    masks = "; ".join(f"{name} {s['hits']:,} hits of {s['size'] ** 2:,}" for name, s in scenes.items())
    known = [f"{name}: {scenes[name]['hits']} hits, not {hits}" for (name, size), hits in KNOWN_HITS.items()
             if name in scenes and scenes[name]["size"] == size and scenes[name]["hits"] != hits]
    words = (f"<p>First hits of the camera's rays, without shading. The masks that judge: {page.escape(masks)}. They "
             "and the depths are exact for the polynomials (Sturm's theorem and bisection over rationals, all "
             "pixels); for the asterisks they are the certified ones of graze itself, whose half width is counted as "
             "error. Depth errors are distances along the ray in the scene's units. Seconds are of one thread on one "
             f"core; the octree of level 9, made once a scene ({page.escape(octree_words(scenes))}), is not in those "
             "of the descents. A pixel is wrong where it is hit or missed against the mask; undecided ones are told "
             "apart.</p>")
    if known:
        words += f'<p class="bad">The masks are not those that are known: {page.escape("; ".join(known))}.</p>'
    return words


def octree_words(scenes):
    return ", ".join(f"{name} {s['octree_seconds']:.2g} s" for name, s in scenes.items())


def fidget_of(data, name):
    return next((f for f in data["fidget"] if f["scene"] == name), None)


NAMES = {**{m: f"descent {m}" for m in SOUND}, **{m: m for m in OLD}}


def scene_points(scene, fidget):
    """Series of points in seconds and median depth error, [(name, points)], along NL or accuracy."""
    series = []
    for method, name in NAMES.items():
        rows = sorted((r for r in scene["rows"] if r["method"] == method and r["compared"]), key=lambda r: r["levels"])
        series.append((name, [point(name, r, f"NL {r['levels']}" if method == SOUND[0] else "") for r in rows]))
    series.append(("certified hits", [point("certified hits", r, r["method"].split()[1]) for r in scene["rows"]
                                      if r["levels"] == 0 and r["compared"]]))
    series.append(("POV-Ray", [{**point("POV-Ray", {**r, "seconds": statistics.median(r["seconds"]), "quartiles": None},
                                        power(r['accuracy']))} for r in scene["povray"]
                               if r["correct"] and r["depth"]]))
    if fidget:
        series.append(("fidget", [point("fidget", {**fidget, "seconds": statistics.median(fidget["seconds"])}, "")]))
    return [(name, points) for name, points in series if points]


def point(library, row, text):
    x, error = row["seconds"], row["depth"][0]
    count = wrong(row)
    if count:
        text = (text + ": " if text else "") + f"{count} wrong"
    low, high = row.get("quartiles") or (None, None)
    return {"library": library, "x": x, "y": error, "x_low": low, "x_high": high, "marked": count > 0, "text": text}


def scene_figure(name, scene, fidget):
    if figures.matplotlib is None:
        return ""
    with figures.matplotlib.rc_context(figures.STYLE):
        fig, ax = figures.new(900, 520)
        series = scene_points(scene, fidget)
        figures.draw_scatter(ax, [p for _, points in series for p in points],
                             f"seconds for {scene['size']} x {scene['size']} rays",
                             "median depth error (scene's units)", name, marked_label="wrong pixels")
        for library, points in series:
            ax.plot([p["x"] for p in points], [p["y"] for p in points], color=figures.colour(library), linewidth=1,
                    alpha=0.6 if library != "certified hits" else 0)
        figures.legend_of(fig)
        figures.place_texts(fig)
        return figures.finish(fig)


def scene_caption(name, scene, data):
    """What to read from a scene's figure, by its data."""
    certified = best(scene, CERTIFIED, 0)
    words = (f"{name}: lower is more exact, further left is faster; a line follows NL (POV-Ray's: its accuracy). A "
             f"certified hit takes {seconds_text(certified['seconds'])} s ({certified['method'].split()[1]}) for the "
             f"whole picture to a median error of {scientific(certified['depth'][0])}, with "
             f"{pixels(wrong(certified))}. ")
    descent = best(scene, SOUND, 30)
    words += (f"The descent to NL 30 takes {seconds_text(descent['seconds'])} s ({descent['method']}) to "
              f"{scientific(descent['depth'][0])}. ")
    words += old_words(scene) + povray_words(scene)
    mistaken = [r for r in scene["rows"] if wrong(r)]
    if mistaken:
        first = {}
        for r in sorted(mistaken, key=lambda r: r["levels"]):
            first.setdefault(r["method"], r)
        words += "Red crosses: " + "; ".join(f"{m} from NL {r['levels']} on ({pixels(wrong(r))} there)"
                                             for m, r in first.items()) + ". "
    if fidget_of(data, name):
        voxels = fidget_of(data, name)["depth"][2] * scene["size"] / (2 * povray.SCENES[name][2])
        words += f"fidget's picture is orthographic; its heights are off by {voxels:.2f} of a voxel at most. "
    return words.strip()


def old_words(scene):
    """Who is faster than the sound descent at NL 30, among the paper's methods."""
    lanes, scalar = best(scene, SOUND[:3], 30), row_of(scene, "upward")
    rows = [r for r in map(lambda m: row_of(scene, m), OLD) if r and r["compared"]]
    if not (lanes and scalar and rows):
        return ""
    faster = [r for r in rows if 1.02 * r["seconds"] < scalar["seconds"]]
    if not faster:
        return "At NL 30 no unsound scalar descent is faster than the sound one by more than 2 %. "
    names = " and ".join(f"{r['method']} ({100 * (scalar['seconds'] / r['seconds'] - 1):.0f} %)" for r in faster)
    words = f"At NL 30 the unsound {names} {'is' if len(faster) == 1 else 'are'} faster than the sound scalar descent, "
    words += "since nothing is rounded outward; the sound eight-lane one is "
    ahead = [r["method"] for r in rows if r["seconds"] < lanes["seconds"]]
    return words + (f"slower than {' and '.join(ahead)}. " if ahead else "faster than all of them. ")


def povray_ratio(scene):
    """POV-Ray's seconds at its finest accuracy over those of certified hits."""
    rows = [r for r in scene["povray"] if r["correct"]]
    certified = best(scene, CERTIFIED, 0)
    if not rows or not certified:
        return None
    return statistics.median(min(rows, key=lambda r: r["accuracy"])["seconds"]) / certified["seconds"]


def povray_words(scene):
    """Where POV-Ray stands; plainly where it is faster at its error."""
    rows = [r for r in scene["povray"] if r["correct"] and r["depth"]]
    if not rows:
        return ""
    certified, fine = best(scene, CERTIFIED, 0), min(rows, key=lambda r: r["accuracy"])
    ahead = []
    for r in rows:
        rivals = [g for g in scene["rows"] if g["method"] in SOUND + CERTIFIED and g["compared"] and not wrong(g)
                  and g["depth"][0] <= r["depth"][0]]
        quickest = min((g["seconds"] + (scene["octree_seconds"] if g["levels"] else 0) for g in rivals), default=None)
        if quickest is None or statistics.median(r["seconds"]) < quickest:
            ahead.append(r)
    seconds = statistics.median(fine["seconds"])
    words = (f"POV-Ray at accuracy {power(fine['accuracy'])} takes {seconds_text(seconds)} s, "
             f"{seconds / certified['seconds']:.0f} times certified hits, to {scientific(fine['depth'][0])}. ")
    if ahead:
        words += (f"POV-Ray is faster than any sound method of graze at its error at accuracy {powers(ahead)}: it "
                  "stops as soon as its steps are short enough, and proves nothing. ")
    descent = descent_of(scene)
    behind = [r for r in rows if descent and statistics.median(r["seconds"]) < descent]
    if behind:
        words += (f"POV-Ray at {powers(behind)} is faster than the descent to NL 30 with its octree "
                  f"({seconds_text(descent)} s, {seconds_text(scene['octree_seconds'])} s of them the octree's, made "
                  "once for any number of rays): POV-Ray is told the greatest slope, which the octree has to do "
                  "without. ")
    return words


def powers(rows):
    return ", ".join(power(r["accuracy"]) for r in rows)


def descent_of(scene):
    """Seconds of the fastest sound descent to NL 30, its octree's included."""
    row = best(scene, SOUND, 30)
    return row["seconds"] + scene["octree_seconds"] if row else None


def wrong_figure(scenes, names):
    panels = []
    for name in names:
        points = [{"library": library, "x": p["x"], "y": p["count"], "marked": p["count"] > 0, "text": p["text"]}
                  for library, p in wrong_points(scenes[name])]
        size = scenes[name]["size"]
        panels.append({"points": points, "x_label": f"seconds for {size} x {size} rays", "title": name,
                       "marked_label": "wrong pixels", "y_label": f"wrong pixels of {size ** 2:,}"})
    return figures.scatter_panels(panels, columns=len(panels), row_height=440)


def wrong_points(scene):
    for r in scene["rows"]:
        name = "certified hits" if r["levels"] == 0 else NAMES.get(r["method"])
        if name:
            yield name, {"x": r["seconds"], "count": wrong(r), "text": f"NL {r['levels']}" if wrong(r) else ""}
    for r in scene["povray"]:
        text = f"gradient {r['max_gradient']:g}" if not r["correct"] else power(r['accuracy'])
        yield "POV-Ray", {"x": statistics.median(r["seconds"]), "count": wrong(r), "text": text if wrong(r) else ""}


def loss(row):
    """What too small a max_gradient costs POV-Ray: pixels, or else depth."""
    if wrong(row) or not row["depth"] or row["depth"][2] < 10 * row["accuracy"]:
        return pixels(wrong(row))
    return f"no wrong pixel, but depths off by up to {scientific(row['depth'][2])}"


def wrong_caption(scenes, names):
    words = ["Wrong pixels against seconds; 0 is the line at the bottom, where a reference picture belongs."]
    for name in names:
        scene = scenes[name]
        sound = [r for r in scene["rows"] if r["method"] in SOUND + CERTIFIED + ["split", "exact"]]
        worst = max(sound, key=wrong)
        count = pixels(wrong(worst)) + (f" ({worst['method']})" if wrong(worst) else " at any NL")
        note = f"{name}: the sound methods of graze have {count}"
        small = [r for r in scene["povray"] if not r["correct"]]
        if small:
            losses = ", ".join(f"{r['max_gradient']:g} ({loss(r)})" for r in small)
            note += (f"; POV-Ray, told a max_gradient of {losses} instead of {scene['povray'][0]['max_gradient']:g}, "
                     "says nothing of it in its picture")
        right = [r for r in scene["povray"] if r["correct"] and wrong(r)]
        if right:
            note += "; with the correct one it has wrong pixels at accuracy " + ", ".join(
                f"{power(r['accuracy'])} ({wrong(r)})" for r in right)
        words.append(note + ".")
    return " ".join(words)


def povray_table(scenes):
    rows = []
    for name, scene in scenes.items():
        certified = best(scene, CERTIFIED, 0)
        for r in scene["povray"]:
            s = statistics.spread(r["seconds"])
            gradient = f"{r['max_gradient']:g}" + ("" if r["correct"] else " (too small)")
            rows.append([name, gradient, power(r["accuracy"]), seconds_text(s["median"]), s["repetitions"],
                         f"{s['median'] / certified['seconds']:.0f}", f"{s['median'] / descent_of(scene):.1f}",
                         r["hits"], marked(wrong(r)), *(map(scientific, r["depth"] or [None] * 3))])
    return page.table(["scene", "max_gradient", "accuracy", "POV-Ray, s", "runs", "times certified",
                       "times descent (NL 30, with octree)", "hits", "wrong pixels", "depth error: median", "99.9 %",
                       "greatest"], rows, povray_caption(scenes))


def povray_caption(scenes):
    ratios = {name: povray_ratio(s) for name, s in scenes.items() if povray_ratio(s)}
    low = min(ratios, key=ratios.get)
    return ("POV-Ray's isosurface with graze's camera, one thread, no anti-aliasing; CPU-seconds of tracing. Where it "
            "hits is asked of its own trace() in a run that is not timed. Certified casting is at least "
            f"{ratios[low]:.0f} times as fast as POV-Ray at its finest accuracy (least on {low}).")


def fidget_words(entry):
    certified = min((statistics.median(times), name) for name, times in entry["certified"].items())
    fidget = statistics.median(entry["seconds"])
    ratio = fidget / certified[0]
    words = (f"fidget's JIT height map of {entry['scene']} at {entry['size']}^3 takes {seconds_text(fidget)} s, "
             f"certified casting of {entry['size']} x {entry['size']} rays {seconds_text(certified[0])} s")
    return words + (f": certified is {ratio:.1f} times as fast." if ratio >= 1 else
                    f": fidget is {1 / ratio:.1f} times as fast, in single precision with {entry['size']} steps of "
                    "depth.")


def fidget_table(data):
    rows = []
    for f in data["fidget"]:
        s = statistics.spread(f["seconds"])
        name, times = min(f["certified"].items(), key=lambda item: statistics.median(item[1]))
        scene = data["scenes"][f["scene"]]
        certified = row_of(scene, name, 0)
        times = statistics.median(times)
        rows.append([f["scene"], f"{f['size']}^3", f"{seconds_text(s['median'])} ({seconds_text(s['low'])} to "
                     f"{seconds_text(s['high'])})", seconds_text(times), f"{s['median'] / times:.1f}", marked(wrong(f)),
                     scientific(f["depth"][0]), scientific(f["depth"][2]), wrong(certified),
                     scientific(certified["depth"][0]), scientific(certified["depth"][2])])
    words = (" Both on one thread in turn; fidget's rays are orthographic, in single precision, its normals are "
             "included; its heights are judged by the surface's root in closed form, and taken to be midway between "
             "two voxels.")
    return page.table(["scene", "voxels", "fidget, s (quartiles)", "certified, s", "ratio", "fidget: wrong pixels",
                       "depth error: median", "greatest", "certified: wrong pixels", "depth error: median",
                       "greatest"], rows, " ".join(map(fidget_words, data["fidget"])) + words)


def mistakes_table(scenes):
    """Rows with wrong or undecided pixels or intervals that do not hold the root; methods that agree are one row."""
    groups = {}
    for name, scene in scenes.items():
        for r in scene["rows"]:
            counts = tuple(r[k] for k in ("wrong_hits", "wrong_misses", "not_enclosed"))
            if any(counts) or r["undecided"]:
                error = scientific(r["depth"][0]) if r["compared"] else "-"
                groups.setdefault((name, r["levels"], r["hits"], counts, r["undecided"], error), []).append(r["method"])
    rows = [[name, ", ".join(methods), levels or "-", hits, *map(marked, counts), undecided, error]
            for (name, levels, hits, counts, undecided, error), methods in groups.items()]
    unsound = sorted({m for key, methods in groups.items() if any(key[3]) for m in methods})
    verdict = f"Only {', '.join(unsound)} make mistakes" if unsound else "No method makes a mistake"
    if set(unsound) & set(SOUND + CERTIFIED + ["split", "exact"]):
        verdict = f"Mistakes are made by {', '.join(unsound)}, some of which must make none"
    return page.table(["scene", "method", "NL", "hits", "wrongly hit", "wrongly missed",
                       "first root outside the interval", "undecided", "median depth error"], rows,
                      "Methods and NL with wrong or undecided pixels, or hits whose interval of t does not hold the "
                      f"first root. {verdict}; an undecided pixel says so, and is none.")


def paper_table(scenes):
    rows, ratios = [], []
    for name, scene in scenes.items():
        count = scene["size"] ** 2
        for method in TABLE:
            r = row_of(scene, method)
            if r is None:
                rows.append([name, method, "-", "-", "not on this processor", *["-"] * 5])
                continue
            then = r.get("paper_seconds", 0)
            paper = [f"{then:.1f}", f"{512 * 512 / then:,.0f}"] if then else ["-" if then == 0 else "lost"] * 2
            rate = count / r["seconds"]
            if then:
                ratios.append((rate * then / 512 ** 2, f"{method}, {name}"))
            rows.append([name, method, *paper, seconds_text(r["seconds"]), f"{rate:,.0f}",
                         f"{rate * then / 512 ** 2:.0f}" if then else "-", r["hits"], r["undecided"],
                         marked(wrong(r)), r.get("other_octants", "-")])
    sizes = ", ".join(dict.fromkeys(f"{s['size']} x {s['size']}" for s in scenes.values()))
    note = (f"By rays a second today's columns are {min(ratios)[0]:.0f} ({min(ratios)[1]}) to {max(ratios)[0]:.0f} "
            f"times ({max(ratios)[1]}) the paper's. " if ratios else "")
    return page.table(["scene", "column", "paper, s", "paper, rays/s", "today, s", "rays/s", "times", "hits",
                       "undecided", "wrong pixels", "first octant not that of exact"], rows,
                      "The paper's Table 1 today: ray casting, octree to level 9, NL 30. The paper's seconds are of "
                      "whole pictures of 512 x 512 on a Pentium 4 of 2.4 GHz, and some of its cells are lost; today's "
                      f"are of first hits of {sizes} rays. {note}upward, avx512 and exact are not the paper's.")


def level_table(scenes):
    rows, follows = [], []
    for name in [n for n in ("tanglecube", "spheres") if n in scenes]:
        for r in scenes[name]["rows"]:
            if r["method"] == "upward" and r["compared"]:
                rows.append([name, r["levels"], scientific(r["half_diagonal"]), scientific(r["depth"][0]),
                             scientific(r["depth"][2]), r["beyond"], scientific(r["octant"][0]), r["compared"]])
                if 20 <= r["levels"] <= 40:
                    follows.append(r["depth"][0] / r["half_diagonal"])
    note = f"From NL 20 to 40 the median is {min(follows):.2f} to {max(follows):.2f} of it. " if follows else ""
    return page.table(["scene", "NL", "sqrt(3) 2^(-NL-1) of the root", "depth error: median", "greatest",
                       "pixels beyond", "first octant's middle: median", "pixels"], rows,
                      f"The descent's error against NL, beside the paper's: half the diagonal of an octant. {note}The "
                      "first octant's middle, the paper's answer, is further off: the surface may meet that octant "
                      "beside the ray.")
