"""Traversals: rays a second against misses on adversarial rays and against spurious visits.

Speed is measured by graze-voxel-peers: all contenders in one program, the same voxels, the same rays.
Errors are counted by graze-fuzz, whose judge is exact: in this process, or in a library's own one.
"""
import collections
import json
import pathlib
import re

from report import figures, page, statistics
from report.context import MeasurementFailed

NAME = "traversals"
TITLE = "Traversals: rays a second against misses and spurious visits"
PEERS = pathlib.Path(__file__).parents[3] / "fuzz/peers/CMakeLists.txt"
# each library on that list, and Debian's package
ADAPTERS = dict(re.findall(r"^graze_peer_library\((\S+) (\S+)", PEERS.read_text(), re.M))
TARGETS = ["graze-voxel-peers", "graze-first-hits", "graze-fuzz", *(f"graze-adapter-{name}" for name in ADAPTERS)]

LEVELS = (10, 30, 50)
# rays a campaign asks in a (full, quick) run, by the beginning of the name: libraries behind pipes are slow, and
# each of OpenVDB's hangs costs two seconds
RAYS = {"openvdb-volume": (6000, 300), "openvdb": (600, 60), "nanovdb": (20000, 300), "octomap": (6000, 150),
        "embree": (20000, 1500), "pcl": (30000, 300), "cgal-octree-epeck": (20000, 1000), "cgal": (80000, 2000)}
IN_PROCESS = (2_000_000, 20_000)


def rays_of(traversal, quick):
    """The budget of a campaign: of rays, not of seconds, so that its counts can be repeated."""
    fits = [key for key in RAYS if traversal.startswith(key)]
    return RAYS.get(max(fits, key=len, default=None), IN_PROCESS)[1 if quick else 0]


def measure(context):
    timing = time_all(context)
    fuzz = str(context.needed("graze-fuzz"))
    listed = names(context.run([fuzz, "list"]))
    generators = [name for name in listed["generators"] if name != "random"]
    offered = {name for group in listed.values() for name in group}
    wanted = dict.fromkeys((c["traversal"], c["path"]) for c in timing["contestants"])
    wanted.update(dict.fromkeys((name, "") for name in timing["untimed"]))
    campaigns, unfinished = [], []
    for traversal, path in wanted:
        if traversal not in offered:
            continue
        for level in LEVELS:
            context.progress(f"{traversal} {path}".rstrip() + f" at level {level}")
            try:
                campaigns.append(campaign(context, fuzz, traversal, path, level, generators))
            except MeasurementFailed as error:  # one library's fault is not the section's
                unfinished.append({"traversal": traversal, "level": level, "why": str(error)})
    return {"quick": context.quick, "timing": timing, "campaigns": campaigns, "unfinished": unfinished,
            "first_hits": first_hits(context)}


def time_all(context):
    """Every contender's rates, one a block of rays, and what they report on the same voxels."""
    context.progress("rays a second")
    command = [context.needed("graze-voxel-peers"), "--json", "--level=9", f"--rays={context.share(1000000, 200000)}",
               f"--blocks={context.share(21, 5)}", f"--slice={context.share(0.1, 0.015)}",
               f"--judged={context.share(4000, 150)}"]
    head, *contestants = context.json_lines(command, timeout=context.share(600, 150))
    for peer in head["missing"].split():
        if peer != "none":
            context.missing(peer, ADAPTERS.get(peer, ""), "not timed, and not judged")
    return {"command": " ".join(["graze-voxel-peers", *map(str, command[1:])]), **head, "contestants": contestants}


def first_hits(context):
    """The first voxel on each ray, as users of each library ask for it."""
    context.progress("first hits a second")
    command = [context.needed("graze-first-hits"), "--json", "--level=9", f"--rays={context.share(1000000, 100000)}",
               f"--blocks={context.share(21, 5)}", f"--judged={context.share(4000, 150)}"]
    return {"command": " ".join(["graze-first-hits", *map(str, command[1:])]),
            "contestants": context.json_lines(command, timeout=context.share(600, 150))}


def names(listing):
    """The names that `graze-fuzz list` prints, by heading."""
    found, heading = {}, ""
    for line in listing.splitlines():
        if line.startswith("  "):
            found[heading].append(line.split()[0])
        else:
            heading = line
            found[heading] = []
    return found


def campaign(context, fuzz, traversal, path, level, generators):
    """One traversal's counts on adversarial rays at one level."""
    rays = rays_of(traversal, context.quick)
    if level != LEVELS[0] and beyond(traversal, level):
        rays = min(rays, 200)  # to see that it declines
    command = [fuzz, "run", "--traversal", traversal, "--level", level, "--rays", rays, "--seed", 2026, "--generator",
               ",".join(generators), "--threads", 1, "--timeout", 0.5, "--no-shrink", "--json"]
    chosen = ["env", f"GRAZE_BATCH_PATH={path}"] if path else []
    result = json.loads(context.run([*chosen, *command], codes=(0, 1), timeout=context.share(200, 40)))
    kept = ("traversal", "promise", "level", "rays", "declined", "faults", "rays_with_miss", "crossed_missed",
            "gross_missed", "visited", "spurious", "far_spurious", "finding", "seconds")
    return {**{key: result[key] for key in kept}, "path": path,
            "by_generator": {g["generator"]: [g["rays_with_miss"], g["rays"] - g["declined"] - g["faults"]]
                             for g in result["generators"]},
            "command": " ".join([*chosen, "graze-fuzz", *map(str, command[1:])])}


def beyond(traversal, level):
    """Cells in float or counted in 32 bits, and voxel_set's 20 levels, end before this level."""
    short = ("lanes", "octomap", "pcl", "openvdb", "nanovdb", "embree", "cgal-octree")
    return level > 20 and traversal.startswith(short)


# What is shown.

Row = collections.namedtuple("Row", "name kind rates contestant at")


def rows_of(data):
    """One a traversal: its rates where it was timed, and its campaign at each level where it was judged."""
    at = {(c["traversal"], c["path"], c["level"]): c for c in data["campaigns"]}

    def campaigns(traversal, path):
        return {level: at[traversal, path, level] for level in LEVELS if (traversal, path, level) in at}

    rows = [Row(c["name"], c["kind"], statistics.spread(c["rays_a_second"]), c, campaigns(c["traversal"], c["path"]))
            for c in data["timing"]["contestants"]]
    untimed = data["timing"]["untimed"]
    return rows + [Row(name, "library", None, None, campaigns(traversal, "")) for traversal, name in untimed.items()
                   if campaigns(traversal, "")]


def judged(campaign):
    """Rays that were answered."""
    return campaign["rays"] - campaign["declined"] - campaign["faults"]


def taken(campaign):
    """Whether the traversal takes such rays at all: one in twenty were answered."""
    return judged(campaign) * 20 >= campaign["rays"] and judged(campaign) > 0


def share(campaign):
    """Of the rays that were answered, those with a miss; None where nearly all were declined."""
    return campaign["rays_with_miss"] / judged(campaign) if taken(campaign) else None


def spurious(campaign):
    """Visits a ray of octants that the ray does not touch."""
    return campaign["spurious"] / judged(campaign) if taken(campaign) else None


def first(row, measure):
    """`of` the campaign at the first level, None where there is none."""
    return measure(row.at[LEVELS[0]]) if LEVELS[0] in row.at else None


def percent(value):
    return f"{100 * value:.2g} %" if value < 0.995 else "100 %"  # .2g would write 1e+02


def million(rate):
    return f"{rate / 1e6:.3g} M"


def label(row):
    """The name in figures' legends: its colour tells who it is."""
    if row.kind == "graze":
        return f"{row.contestant['path'] or 'scalar'} (graze)"
    if row.kind == "paper":
        return row.name.removeprefix("as ") if row.name == "as published" else row.name.lower()
    if row.name in ("Williams", "Ize", "Tavian", "pbrt"):
        return "slab tests"
    return row.name.split(",")[0]


def note(row):
    """What is written beside a point, where its colour alone does not tell."""
    parts = row.name.split(", ")
    if row.kind == "graze":
        return parts[0]
    return label(row) if row.kind == "paper" else parts[-1]


def points(rows, measure):
    found = []
    for row in rows:
        y = first(row, measure)
        if row.rates is None or y is None:
            continue
        found.append({"library": label(row), "x": row.rates["median"], "x_low": row.rates["low"],
                      "x_high": row.rates["high"], "y": y, "text": note(row),
                      "marked": row.at[LEVELS[0]]["faults"] > 0})
    return found


def show(data):
    rows = rows_of(data)
    closed = [row for row in rows if row.kind != "graze" or "closed" in row.name]
    exactly = [row for row in closed if row.kind != "graze" or row.name.startswith("exact")]
    blocks = [page.text(introduction(data)),
              page.figure(figures.scatter([{**p, "y": 100 * p["y"]} for p in points(exactly, share)],
                                          "rays a second, one core", "adversarial rays with a miss, % (level 10)",
                                          marked_label="crashes or hangs"), misses_caption(rows)),
              page.figure(figures.scatter(points(closed, spurious), "rays a second, one core",
                                          "spurious visits a ray (adversarial rays, level 10)",
                                          marked_label="crashes or hangs"), spurious_caption(rows)),
              page.table(*main_table(rows)), page.table(*depth_table(rows)), page.table(*shell_table(data))]
    if "first_hits" in data:
        blocks.append(page.table(*first_hits_table(data["first_hits"])))
    return blocks


def summary(data):
    """Sentences for the page's top."""
    return speed_sentences(rows_of(data))[:2]


def introduction(data):
    timing = data["timing"]
    return (f"<p>All occupied voxels on a ray. <b>Speed</b>: a sphere shell at level {timing['level']} "
            f"({timing['voxels']:,} voxels), the same random rays for all, one core; {timing['blocks']} blocks of "
            "rays, each by all contenders in turn in one program; medians of the blocks with their quartiles; the "
            "thread's own processor time. Grids, octrees and boxes are built on these voxels before. <b>Errors</b>: "
            "rays through and a few units in the last place beside vertices, edges and planes of the octants, from far "
            "away, subnormal, huge, nearly parallel (18 generators), in a block of up to 64 octants; the exact answer "
            "is rational arithmetic's, and a library is judged on the ray that it really got, rounded to float where "
            "it works in float. A <i>miss</i> is a voxel that is left out although the ray crosses its open interior, "
            "which is wrong under every convention; graze is held to what it promises beyond that (a voxel touched, or "
            "owned, counts). <i>Spurious</i>: reported, not touched; graze's exact, owned mode must not report a "
            "touched one either that owns no point of the ray.</p>"
            f"<p>Repeat: <code>{page.escape(timing['command'])}</code>; errors: "
            f"<code>{page.escape(again(data))}</code>, with the other names of <code>graze-fuzz list</code>.</p>"
            + unfinished(data))


def unfinished(data):
    """What ended without an answer."""
    return "".join(f"<p>{page.bad(u['traversal'])} at level {u['level']} was not judged: {page.escape(u['why'])}.</p>"
                   for u in data.get("unfinished", []))


def again(data):
    """The command of one campaign."""
    return next((c["command"] for c in data["campaigns"] if c["traversal"] == "published"), "graze-fuzz run")


def best(rows):
    """The fastest, None where there is none."""
    return max((row for row in rows if row.rates), key=lambda row: row.rates["median"], default=None)


def listed_with_misses(rows):
    """Names with their share of misses, the least first; of many the first and the last."""
    rows = sorted(rows, key=lambda row: first(row, share))
    words = [f"“{row.name}” ({percent(first(row, share))})" for row in rows]
    if len(words) > 4:
        words[3:] = [f"and {len(words) - 3} more, up to {words[-1]}"]
    return ", ".join(words)


def speed_sentences(rows):
    """Who is faster than graze, and at what error: computed, whoever wins."""
    timed = [row for row in rows if row.rates and first(row, share) is not None]
    ours = [row for row in timed if row.kind == "graze" and first(row, share) == 0]
    others = [row for row in timed if row.kind != "graze"]
    right = [row for row in others if first(row, share) == 0]
    lead = best(ours)
    exact_scalar = best([row for row in ours if row.name.startswith("exact") and row.name.endswith("scalar")])
    if lead is None or not others:
        return ["No traversal of graze without a miss was timed beside others."]
    sentences = [beside(lead, others)]
    if right:
        peer = best(right)
        ahead = [row for row in ours if row.rates["median"] < peer.rates["median"]]
        sentences.append(f"Of the others {joined(right)} miss nothing that they answer{declining(right)}: the fastest, "
                         f"{peer.name}, has {million(peer.rates['median'])} rays/s, {times(lead, peer)}"
                         + (f", and is faster than graze's {joined(ahead)}." if ahead else "."))
    else:
        sentences.append("None of the others that were timed is without a miss on these rays.")
    if exact_scalar is not None:
        quicker = [row for row in others if row.rates["median"] > exact_scalar.rates["median"]]
        sentences.append(f"Faster than graze's scalar exact code ({million(exact_scalar.rates['median'])} rays/s), "
                         "which opens one node at a time with bounds rounded outwards where lanes take eight, are "
                         f"{listed_with_misses(quicker)}; in brackets, what they miss."
                         if quicker else
                         "None is faster than graze's scalar exact code either.")
    return sentences


def joined(rows):
    return " and ".join(f"“{row.name}”" for row in rows) if len(rows) < 4 else f"{len(rows)} variants"


def declining(rows):
    """Which of them declined many rays."""
    notes = [f"“{row.name}” declined "
             f"{percent(row.at[LEVELS[0]]['declined'] / row.at[LEVELS[0]]['rays'])} of the rays"
            for row in rows if row.at[LEVELS[0]]["declined"] * 10 > row.at[LEVELS[0]]["rays"]]
    return f" ({'; '.join(notes)})" if notes else ""


def beside(lead, others):
    quicker = [row for row in others if row.rates["median"] > lead.rates["median"]]
    if quicker:
        return (f"Faster than graze's fastest without a miss ({lead.name}, {million(lead.rates['median'])} rays/s): "
                f"{listed_with_misses(quicker)}; in brackets, what they miss.")
    peer = best(others)
    return (f"graze's {lead.name} is the fastest of all with {million(lead.rates['median'])} rays/s and no miss; next "
            f"of the others is {peer.name} with {million(peer.rates['median'])} and misses on "
            f"{percent(first(peer, share))} of adversarial rays.")


def times(lead, peer):
    ratio = lead.rates["median"] / peer.rates["median"]
    words = f"{ratio:.1f} times slower" if ratio >= 1 else f"{1 / ratio:.1f} times faster"
    return f"{words} than {lead.name}"


def misses_caption(rows):
    broken = dict.fromkeys(row.name.split(",")[0] for row in rows if row.rates and
                           row.at.get(LEVELS[0], {"faults": 0})["faults"])
    return " ".join(["Right is faster, down is better; 0: none in the rays of the table; bars are quartiles. Of graze, "
                     "exact and closed.", *speed_sentences(rows),
                     f"A red cross: rays without an answer too ({', '.join(broken)})." if broken else ""]).rstrip()


def spurious_caption(rows):
    timed = [row for row in rows if row.rates and first(row, spurious) is not None]
    others = [row for row in timed if row.kind != "graze"]
    sound, exact = (best([row for row in timed if row.kind == "graze" and row.name.startswith(mode)])
                    for mode in ("sound", "exact"))
    words = ["Right is faster, down is better."]
    if sound and exact:
        cost = 1 - exact.rates["median"] / sound.rates["median"]
        words.append(f"graze's sound mode may report octants within its rounding: {first(sound, spurious):.2g} a ray "
                     f"here, where rays lie within ulps of them; exact mode reports {first(exact, spurious):.2g}, for "
                     f"{percent(max(cost, 0))} of the speed.")
        less = [row for row in others if first(row, spurious) < first(sound, spurious)]
        if less:
            words.append(f"Fewer than sound mode report {listed_with_misses(less)}; in brackets, what they miss.")
    none = [row for row in others if first(row, spurious) == 0]
    words.append(f"Without any of the others: {joined(none)}." if none else "All others report some.")
    return " ".join(words)


def share_cell(campaign):
    """The share with a miss; without one, the bound of 95 % confidence."""
    if campaign is None:
        return "not asked"
    n = judged(campaign)
    if not taken(campaign):
        return "declined"
    if campaign["rays_with_miss"]:
        return page.bad(percent(share(campaign)))
    return f"none in {n:,} (< {percent(min(1, 3 / n))})"


KINDS = {"graze": "graze", "paper": "the paper and its time", "published": "published", "library": "library"}


def main_table(rows):
    heads = ["traversal", "of", "M rays/s", "quartiles", f"rays with a miss, level {LEVELS[0]}", "gross",
             "spurious a ray", "rays without an answer"]
    cells = []
    for row in rows:
        c = row.at.get(LEVELS[0])
        rate = row.rates
        cells.append([row.name, KINDS[row.kind], f"{rate['median'] / 1e6:.3f}" if rate else "not timed",
                      f"{rate['low'] / 1e6:.3f} to {rate['high'] / 1e6:.3f}" if rate else "-", share_cell(c),
                      "-" if c is None else "yes" if c["gross_missed"] else "no",
                      "-" if c is None or not taken(c) else f"{spurious(c):.3g}",
                      "-" if c is None else f"{c['finding']}, {c['faults']} of {c['rays'] - c['declined']:,}"
                      if c["faults"] else "0"])
    return heads, cells, ("Speed and error of every traversal. In brackets, where none was missed: 95 % confidence "
                          "that the share is below 3/N. Gross: a ray is in a missed voxel on more than 1e-3 of its "
                          "edge. Not timed: it does not go through all voxels of an octree, or answers voxel by voxel. "
                          "Of CGAL's rays by two points (EPICK) those are judged whose origin + direction is exact.")


def depth_table(rows):
    deep = [row for row in rows if any(level in row.at and taken(row.at[level]) for level in LEVELS[1:])]
    cells = [[row.name, *(share_cell(row.at.get(level)) for level in LEVELS[1:]),
              *(f"{spurious(row.at[level]):.3g}" if level in row.at and taken(row.at[level]) else "-"
                for level in LEVELS[1:])] for row in deep]
    names = sorted({"graze's lanes" if row.kind == "graze" else row.name.split(",")[0] for row in rows
                    if row not in deep})
    return (["traversal", *(f"rays with a miss, level {level}" for level in LEVELS[1:]),
             *(f"spurious a ray, level {level}" for level in LEVELS[1:])], cells,
            "The same at levels 30 and 50, where octants are 2^-30 and 2^-50 of the root, for those that have such "
            f"levels. Declined by, or not asked of: {', '.join(names)}.")


def shell_table(data):
    kinds = list(data["timing"]["contestants"][0]["judged"]) if data["timing"]["contestants"] else []
    if not kinds:
        return [], [], "no ray was judged"
    rows = [[c["name"], *(f"{c['judged'][k]['rays_with_gap']:,} / {c['judged'][k]['spurious']:,} / "
                          f"{c['judged'][k]['doubles']:,}" for k in kinds)] for c in data["timing"]["contestants"]]
    n = data["timing"]["contestants"][0]["judged"][kinds[0]]["rays"]
    return (["traversal", *kinds], rows,
            f"On the voxels of the timing, {n:,} rays of each kind: rays with a crossed voxel left out / voxels "
            "reported and not touched / voxels reported again. Adversarial rays pass within a few units in the last "
            "place of the shell's vertices and edges; those in float are doubles that float holds, so that none "
            "rounds them. Those in double are rounded by PCL, OctoMap, NanoVDB and Embree, which then answer for "
            "another ray.")


def first_hits_table(data):
    contestants = data["contestants"]
    kinds = list(contestants[0]["judged"])
    rows = []
    for c in contestants:
        rate = statistics.spread(c["rays_a_second"])
        rows.append([c["name"], KINDS[c["kind"]], f"{rate['median'] / 1e6:.3f}",
                     f"{rate['low'] / 1e6:.3f} to {rate['high'] / 1e6:.3f}",
                     *(f"{c['judged'][k]['missed']:,} / {c['judged'][k]['untouched']:,}" for k in kinds)])
    n = contestants[0]["judged"][kinds[0]]["rays"]
    return (["first hits", "of", "M rays/s", "quartiles", *kinds], rows,
            f"The first voxel of the same shell on each ray ({page.escape(data['command'])}). Of {n:,} rays of each "
            "kind: the first voxel missed (none reported, or one that is entered after the first crossed one) / one "
            "reported that the ray does not touch. graze's are exact; grids have the same planes as the octants, as "
            "doubles or as real numbers.")
