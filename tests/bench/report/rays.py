#!/usr/bin/env python3
"""usage: rays.py traversals|hard_rays|measure|measure_hard: one test of two report sections.

The first two draw recorded data; the others measure in the smallest form with the programs of build/release or
of GRAZE_BUILD. Exit code 0 passed, 1 failed, 77 skipped (a program or python3-matplotlib is missing)."""
import copy
import json
import os
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "bench"))
from report import context, figures  # noqa: E402
from report.sections import hard_rays, traversals  # noqa: E402

SKIPPED = 77


def recorded(name):
    return json.loads((HERE / f"{name}.json").read_text())


def check(right, claim):
    if not right:
        sys.exit(f"failed: {claim}")


def captions(blocks):
    return [block.get("caption", block.get("html", "")) for block in blocks]


def row(block, name):
    return next(row for row in block["rows"] if row[0] == name)


def row_of(data, traversal, path=""):
    return next(c for c in data["timing"]["contestants"] if (c["traversal"], c["path"]) == (traversal, path))


def test_traversals():
    """Captions follow the data, whoever wins; misses, bounds and refusals are told."""
    data = recorded("traversals")
    blocks = traversals.show(data)
    check([b["kind"] for b in blocks] == ["text", "figure", "figure", "table", "table", "table"], "blocks")
    table = blocks[3]
    check("✗" in row(table, "as published")[4], "misses are marked")
    check(row(table, "exact, closed, scalar")[4] == "none in 20,000 (< 0.015 %)", row(table, "exact, closed, scalar")[4])
    check("hang" in row(table, "OpenVDB")[7] and "crash" in row(table, "Embree")[7], "faults")
    check(row(table, "CGAL box test, EPECK")[2] == "not timed", "a speed that was not measured")
    check(not any(r[0] == "Embree" for r in blocks[4]["rows"]), "float has no level 30")
    check("fastest of all" in captions(blocks)[1], captions(blocks)[1])

    faster = copy.deepcopy(data)
    row_of(faster, "cgal-octree-epeck")["rays_a_second"] = [9e6] * 5
    words = captions(traversals.show(faster))[1]
    check("fastest of all" not in words and "Faster than graze's fastest without a miss" in words
          and "“CGAL, exact rays” (0 %)" in words, words)

    missing = copy.deepcopy(data)
    for c in missing["campaigns"]:
        if c["promise"].endswith("touched") and not c["traversal"].startswith("cgal"):
            c["rays_with_miss"] = 7
    check("No traversal of graze without a miss" in captions(traversals.show(missing))[1], "misses of our own")

    none = copy.deepcopy(data)
    none["campaigns"] = []
    check(len(traversals.show(none)) == 6, "timed alone")


def test_hard_rays():
    data = recorded("hard_rays")
    blocks = hard_rays.show(data)
    check("graze's modes miss nothing" in captions(blocks)[0], captions(blocks)[0])
    check(all(cell == "exact" for cell in row(blocks[1], "graze exact")[1:]), "exact is exact")
    check("missed 64 of 64" in row(blocks[1], "the paper as published")[3], row(blocks[1], "the paper as published")[3])
    check(not any(r[0] == "NanoVDB" for r in blocks[2]["rows"]), "NanoVDB has no level 50")
    check("published" in captions(blocks)[3].split("Wrong:")[1].split(".")[0], "what is wrong is told")

    case = data["answers"]["exact"]["exactly through corners, level 10"]
    case["missed"] = 1
    words = captions(hard_rays.show(data))[0]
    check("graze's modes fail in 1 cells" in words, words)
    case.update(missed=0, faults={"hang": 2})
    check("hang, 2 of 8 rays" in row(hard_rays.show(data)[1], "graze exact")[2], "a hang")


def contexts(programs):
    build = os.environ.get("GRAZE_BUILD") or ROOT / "build" / "release"
    made = context.Context(tempfile.mkdtemp(), quick=True, core=min(os.sched_getaffinity(0)), build=build)
    if not all(made.program(name) for name in programs):
        print(f"skipped: {' and '.join(programs)} have not been built")
        sys.exit(SKIPPED)
    return made


def test_measure():
    """Two campaigns that are known to end otherwise, and a timing of two at level 4."""
    made = contexts(["graze-fuzz"])
    fuzz = str(made.needed("graze-fuzz"))
    wrong, right = (traversals.campaign(made, fuzz, name, "", 10, ["vertex", "aimed-edge"])
                    for name in ("gargantini", "exact-closed"))
    check(wrong["rays_with_miss"] > 0 and right["rays_with_miss"] == 0 and right["spurious"] == 0, (wrong, right))
    lanes = traversals.campaign(made, fuzz, "lanes-exact", "baseline", 50, ["vertex"])
    check(not traversals.taken(lanes), "lanes have no level 50")
    if made.program("graze-voxel-peers"):
        head, *timed = made.json_lines([made.needed("graze-voxel-peers"), "--json", "--level=4", "--rays=2000",
                                        "--blocks=2", "--judged=30", "--only=scalar"])
        check(head["level"] == 4 and len(timed) == 4, (head, timed))
        check(all(len(c["rays_a_second"]) == 2 and c["judged"]["adversarial double"]["rays_with_gap"] == 0
                  for c in timed), timed)
    if made.program("graze-first-hits"):
        hits = made.json_lines([made.needed("graze-first-hits"), "--json", "--level=5", "--rays=2000", "--blocks=2",
                                "--judged=30"])
        ours = [c for c in hits if c["kind"] == "graze"]
        check(len(ours) % 3 == 0 and not any(v["missed"] or v["untouched"] for c in ours
                                             for v in c["judged"].values()), ours)
        head, rows, caption = traversals.first_hits_table({"command": "graze-first-hits", "contestants": hits})
        check(len(rows) == len(hits) and all(len(row) == len(head) for row in rows), (head, rows, caption))


def test_measure_hard():
    made = contexts(["graze-fuzz"])
    fuzz = made.needed("graze-fuzz")
    rationals, exact, published = (hard_rays.replayed(made, fuzz, name) for name in ("rational", "exact", "published"))
    check(not any(hard_rays.bad(c) for c in [*rationals.values(), *exact.values()]), "exact is exact")
    check(published["directions of 1e-300, level 10"]["missed"] == 64, published)
    check(sum(c["rays"] for c in exact.values()) == 127, "every ray is judged")


if __name__ == "__main__":
    if sys.argv[1] in ("traversals", "hard_rays") and figures.matplotlib is None:
        print("skipped: python3-matplotlib is missing")
        sys.exit(SKIPPED)
    globals()[f"test_{sys.argv[1]}"]()
