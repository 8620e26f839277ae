"""Hard rays: what becomes of rays that are made to break a traversal, and of hard surfaces' first hits.

hard_rays.jsonl and the fuzzer's recorded counterexamples are replayed through every traversal, and judged
by exact rationals (graze-fuzz replay); first hits by graze-hard-hits, against exact first roots.
"""
import json

from report import page
from report.sections import traversals

NAME = "hard_rays"
TITLE = "Hard cases: rays"
TARGETS = ["graze-fuzz", "graze-hard-hits", *(f"graze-adapter-{name}" for name in traversals.ADAPTERS)]

MADE, KEPT = "bench/report/hard_rays.jsonl", "fuzz/corpus/numerics.jsonl"
RECORDED = "recorded counterexamples"
# graze-fuzz's names and the table's
ASKED = {
    "exact": "graze exact", "exact-closed": "graze exact, closed", "lanes-exact": "graze exact, lanes",
    "sound": "graze sound", "sound-closed": "graze sound, closed", "lanes-sound": "graze sound, lanes",
    "published": "the paper as published", "plain": "plain", "gargantini": "Gargantini", "revelles": "Revelles",
    "amanatides-woo": "Amanatides-Woo", "williams": "Williams", "ize": "Ize", "tavian": "Tavian", "pbrt": "pbrt",
    "pcl": "PCL", "octomap-ray-keys": "OctoMap", "openvdb-level-set-hdda": "OpenVDB", "nanovdb-hdda": "NanoVDB",
    "embree-boxes": "Embree, boxes", "embree-triangles-robust": "Embree, triangles, robust",
    "cgal-inexact": "CGAL, double", "cgal-epick": "CGAL, EPICK", "cgal-epeck": "CGAL, EPECK"}
SLOW = ("openvdb-level-set-hdda",)  # each hang costs seconds: the full run alone
FAULTS = ("crash", "hang", "exception", "nan", "malformed")


def measure(context):
    fuzz = context.needed("graze-fuzz")
    offered = {name for group in traversals.names(context.run([fuzz, "list"])).values() for name in group}
    answers, left_out = {}, []
    for traversal in ASKED:
        if traversal not in offered:
            library = traversal.split("-")[0]
            context.missing(ASKED[traversal].split(",")[0], traversals.ADAPTERS.get(library, ""), "hard rays")
        elif context.quick and traversal in SLOW:
            left_out.append(ASKED[traversal])
        else:
            context.progress(traversal)
            answers[traversal] = replayed(context, fuzz, traversal)
    context.progress("first hits")
    hits = context.json_lines([context.needed("graze-hard-hits"), context.share(40, 20)], timeout=120)
    return {"expected": expected(context, fuzz), "answers": answers, "left_out": left_out, "hits": hits,
            "hits_level": context.share(40, 20), "command": f"graze-fuzz replay {MADE} --traversal NAME --json"}


def replay(context, fuzz, traversal):
    """(case, judged line) of every ray; the recorded ones are not asked of what has no level 50."""
    files = [MADE] if traversals.beyond(traversal, 50) else [MADE, KEPT]
    lines = [line for name in files for line in (context.root / name).read_text().splitlines() if line.strip()]
    rays = context.scratch / "hard_rays.jsonl"
    rays.write_text("\n".join(lines) + "\n")
    judged = context.json_lines([fuzz, "replay", rays, "--traversal", traversal, "--timeout", 0.5, "--json"],
                                codes=(0, 1), timeout=120)
    return [(json.loads(line).get("comment", RECORDED), judgement) for line, judgement in zip(lines, judged, strict=True)]


def octants(line):
    """What is told of each octant of a ray's block."""
    return line.get("octants", [line])


def replayed(context, fuzz, traversal):
    """By case: rays, declined, faults, octants that the judged rays cross, crossed and missed, gaps, spurious,
    and what breaks a promise that goes beyond."""
    cases = {}
    for case, line in replay(context, fuzz, traversal):
        c = cases.setdefault(case, dict.fromkeys(
            ("rays", "declined", "crossed", "touched", "missed", "gaps", "spurious", "broken"), 0) | {"faults": {}})
        c["rays"] += 1
        fault = next((f for f in line["findings"] if f in FAULTS), None)
        if line.get("declined"):
            c["declined"] += 1
        elif fault:
            c["faults"][fault] = c["faults"].get(fault, 0) + 1
        else:
            c["crossed"] += sum(o["crosses"] for o in octants(line))
            c["touched"] += sum(o["touches"] for o in octants(line))
            c["missed"] += sum(o["crosses"] and not o["visited"] for o in octants(line))
            c["spurious"] += sum(o["visited"] and not o["touches"] for o in octants(line))
            c["gaps"] += "gap" in line["findings"] or "seam" in line["findings"]
            c["broken"] += bool({"miss", "order", "spurious", "outside"} & set(line["findings"]))
    return cases


def expected(context, fuzz):
    """By case, from exact rationals: rays, and the octants that they touch, own and cross."""
    cases = {}
    for case, line in replay(context, fuzz, "rational"):
        c = cases.setdefault(case, {"rays": 0, "touches": 0, "owns": 0, "crosses": 0})
        c["rays"] += 1
        for relation in ("touches", "owns", "crosses"):
            c[relation] += sum(o[relation] for o in octants(line))
    return cases


# What is shown.


def word(c):
    """A cell: exact, or what went wrong."""
    if c["declined"] == c["rays"]:
        return "declined"
    wrong = [f"{kind}, {n} of {rays(c['rays'])}" for kind, n in c["faults"].items()]
    if c["missed"]:
        wrong.append(f"missed {c['missed']} of {c['crossed']}")
    elif c["gaps"]:
        wrong.append(f"gap, {rays(c['gaps'])}")
    elif c["broken"]:
        wrong.append(f"breaks its promise, {rays(c['broken'])}")
    rest = [f"spurious {c['spurious']}"] if c["spurious"] else []
    if c["declined"]:
        rest.append(f"declined {c['declined']} of {c['rays']} rays")
    if wrong:
        return page.bad("; ".join(wrong + rest))
    return "; ".join(rest if c["spurious"] else ["exact", *rest])


def rays(n):
    return "1 ray" if n == 1 else f"{n} rays"


def cases_by_level(data):
    """The cases without their level, of level 10 and of level 50."""
    return [[case for case in data["expected"] if case.endswith(f"level {level}")] for level in (10, 50)]


def show(data):
    shallow, deep = cases_by_level(data)
    recorded = [RECORDED] if RECORDED in data["expected"] else []
    return [page.text(introduction(data)),
            page.table(*ray_table(data, shallow, "at level 10, where libraries can follow")),
            page.table(*ray_table(data, deep + recorded, "at level 50, and those of fuzz/corpus/numerics.jsonl; "
                                  "traversals that have no such level are left out")),
            page.table(*hit_table(data))]


def introduction(data):
    failing = {traversal: sum(bad(c) for c in cases.values()) for traversal, cases in data["answers"].items()}
    ours = [t for t in failing if ASKED[t].startswith("graze")]
    right = [ASKED[t] for t in failing if not failing[t] and t not in ours]
    broken = sum(failing[t] for t in ours)
    words = (f"<b>graze's modes fail in {broken} cells of the tables</b>" if broken else
             "graze's modes miss nothing in any of them")
    others = (f"of the others, {'; '.join(right)} miss nothing that they answer" if right else
              "every other traversal fails in at least one")
    left = ""
    if data["left_out"]:
        left = f" Not asked in a quick run: {', '.join(data['left_out'])}, whose hangs take long."
    return (f"<p>{sum(e['rays'] for e in data['expected'].values())} rays that are made to break a traversal, each in "
            "a block of up to 64 octants, judged by exact rationals. Words of a cell: <b>exact</b>: every octant whose "
            "interior the ray crosses is reported, and none that it does not touch; <b>missed</b> k of n crossed "
            "octants; <b>gap</b>: a length of the ray along octants' faces is in none that is reported; "
            "<b>spurious</b> k: nothing is missed, but k are reported and not touched (sound modes and conservative "
            "tests may); <b>declined</b>: the traversal cannot represent the ray or the level. Libraries get "
            "directions scaled by a power of two to a length of about 1, and are judged on the ray as they round it. "
            f"On these rays {words}; {others}.{left}{spurious_words(data)} Repeat: "
            f"<code>{page.escape(data['command'])}</code>.</p>")


def spurious_words(data):
    """Where sound mode gives way, and who does better there."""
    sound = data["answers"].get("sound", {})
    worst = [case for case, c in sound.items() if c["spurious"] > 2 * c["touched"] > 0]
    if not worst:
        return ""
    better = [ASKED[t] for t, cases in data["answers"].items() if not ASKED[t].startswith("graze") and
              any(c in cases and not bad(cases[c]) and cases[c]["declined"] == 0 and
                  cases[c]["spurious"] * 10 < sound[c]["spurious"] for c in worst)]
    return (f" graze's sound mode reports most of the block in {len(worst)} cases (“{'”, “'.join(worst)}”): its bounds "
            "are of distances that are rounded at the origin's magnitude, or of components so far apart that their "
            "products underflow; exact mode decides them." +
            (f" In some of these far fewer octants are reported, and none is missed, by {'; '.join(better)}."
             if better else ""))


def bad(c):
    return bool(c["missed"] or c["gaps"] or c["faults"] or c["broken"])


def ray_table(data, cases, where):
    heads = ["traversal", *(case.rsplit(", level", 1)[0] for case in cases)]
    rows = [["exact rationals: crossed / owned / touched",
             *(f"{e['crosses']} / {e['owns']} / {e['touches']}" for e in (data["expected"][c] for c in cases))]]
    for traversal, by_case in data["answers"].items():
        cells = [word(by_case[case]) if case in by_case else "not asked" for case in cases]
        if any(cell != "declined" for cell, case in zip(cells, cases) if case != RECORDED):
            rows.append([ASKED[traversal], *cells])
    return heads, rows, f"Hard rays {where}."


OUTCOMES = ("certified", "sound", "exact", "published", "plain", "gargantini", "revelles")


def hit_word(hit):
    """A cell: right, undecided (what is told encloses the root), or wrong."""
    width = f" {hit['width']:.0e}" if "width" in hit else ""
    if hit["verdict"] == "right":
        return f"{hit['outcome']}{width}"
    return f"undecided{width}" if hit["verdict"] == "undecided" else page.bad(hit["verdict"])


def root_word(hit):
    if "root" not in hit:
        return "none"
    kind = {0: "", 1: "", 2: ", double"}.get(hit["multiplicity"], f", {hit['multiplicity']}-fold")
    return f"t = {hit['root']:.6g}{kind}"


def hit_table(data):
    rays = {}
    for hit in data["hits"]:
        rays.setdefault((hit["surface"], hit["ray"]), {})[hit["traversal"]] = hit
    rows = [[surface, ray, root_word(next(iter(hits.values()))),
             *(hit_word(hits[t]) if t in hits else "-" for t in OUTCOMES)] for (surface, ray), hits in rays.items()]
    verdicts = {t: [hits[t]["verdict"] for hits in rays.values() if t in hits] for t in OUTCOMES}
    right = ", ".join(f"{t} {verdicts[t].count('right')}" for t in OUTCOMES)
    wrong = {t: sum(v not in ("right", "undecided") for v in verdicts[t]) for t in OUTCOMES}
    lost = ", ".join(f"{t} {n}" for t, n in wrong.items() if n) or "none"
    return (["surface", "ray", "exact first root", *OUTCOMES], rows,
            "First hits on hard surfaces, with the width in t of what is told of the first root. Exact roots are by "
            "Sturm's theorem, those of the asterisks by definition (the origin is on them; on the axis and in y = 0 "
            "nothing else is). Undecided: neither a root nor its absence is proven, and a first root, if there is one, "
            f"is in the interval told, which is checked here. Right of {len(rays)} rays: {right}. Wrong: {lost}. "
            f"certified goes along the ray; the others descend to level {data['hits_level']}; what published, plain, "
            "gargantini and revelles say is proven by nothing, even where it is right.")
