#!/usr/bin/env python3
"""graze-report's section images: its page from recorded data, its judges, and its measurement in small.

usage: images.py [graze-traversal-bench]
Without the program its measurement counts as skipped (exit code 77 when all else holds).
"""
import array
import copy
import json
import math
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "bench"))

from report import context as contexts, figures, page  # noqa: E402
from report.sections import images, images_page  # noqa: E402

PROGRAM = None
DATA = json.loads((HERE / "images.json").read_text())


def words(blocks):
    """All text of the page, without the figures."""
    return " ".join(str(b.get("html", "")) + str(b.get("caption", "")) + str(b.get("rows", "")) for b in blocks)


def changed(**methods):
    """The recorded data, rows of the methods changed."""
    data = copy.deepcopy(DATA)
    for row in data["scenes"]["tanglecube"]["rows"]:
        row.update(methods.get(row["method"].replace(" ", "_"), {}))
    return data


class Page(unittest.TestCase):
    def test_blocks(self):
        blocks = images.show(DATA)
        self.assertEqual([b["kind"] for b in blocks], ["text"] + 2 * ["figure"] + 5 * ["table"])
        for block in blocks:
            page.block_html(block, page.Numbering())
        if figures.matplotlib:
            self.assertTrue(all(b["svg"].startswith("<svg") for b in blocks if b["kind"] == "figure"))

    def test_claims_follow_the_data(self):
        text = words(images.show(DATA))
        self.assertIn("have no wrong pixel at any NL", text)
        self.assertIn("told a max_gradient of 10 (1,735 wrong pixels), 20 (22 wrong pixels) instead of 65", text)
        self.assertIn("gargantini from NL 50 on (242 wrong pixels there)", text)
        self.assertIn("Only gargantini, plain make mistakes", text)
        self.assertNotIn("POV-Ray is faster", text)

    def test_wrong_depths_without_a_wrong_pixel_are_told(self):
        data = copy.deepcopy(DATA)
        data["scenes"]["tanglecube"]["povray"][-1]["wrong_misses"] = 0
        self.assertIn("20 (no wrong pixel, but depths off by up to 1.8e-1)", words(images.show(data)))

    def test_a_wrong_pixel_of_a_sound_method_is_told(self):
        text = words(images.show(changed(avx512={"wrong_misses": 3})))
        self.assertIn("3 wrong pixels (avx512)", text)
        self.assertIn("some of which must make none", text)

    def test_a_faster_peer_is_told(self):
        data = copy.deepcopy(DATA)
        for row in data["scenes"]["tanglecube"]["povray"]:
            row["seconds"] = [1e-5]
        data["fidget"][0]["seconds"] = [1e-6]
        text = words(images.show(data)) + " ".join(images.summary(data))
        self.assertIn("POV-Ray is faster than any sound method of graze at its error at accuracy 1e-3, 1e-6, 1e-9",
                      text)
        self.assertIn("POV-Ray's isosurface is faster than certified casting on tanglecube", text)
        self.assertIn("fidget is", text)
        text = words(images.show(changed(gargantini={"seconds": 1e-4})))
        self.assertIn("faster than the sound scalar descent", text)
        self.assertIn("the sound eight-lane one is slower than gargantini", text)

    def test_another_count_of_hits_than_is_known_is_told(self):
        data = copy.deepcopy(DATA)
        data["scenes"]["tanglecube"].update(size=512, hits=97548)
        self.assertIn("97548 hits, not 97549", words(images.show(data)))

    def test_without_peers(self):
        data = copy.deepcopy(DATA)
        data["fidget"], data["scenes"]["tanglecube"]["povray"] = [], []
        self.assertNotIn("POV-Ray at accuracy", words(images.show(data)))
        self.assertEqual(images.summary(data), [])


class Judges(unittest.TestCase):
    def test_masks(self):
        self.assertEqual(images.judged_mask(bytes([1, 1, 0, 0, 1]), [0.5, math.nan, 0.5, math.nan, math.inf]),
                         {"hits": 3, "wrong_hits": 1, "wrong_misses": 1})

    def test_heights(self):
        for name in images_page.FIDGET:
            half, size = images.povray.SCENES[name][2], 32
            step = 2 * half / size
            roots = [images.top_root(name, (i - size / 2) * step, (size / 2 - 1 - j) * step)
                     for j in range(size) for i in range(size)]
            depths = array.array("I", (0 if z is None else math.ceil(z / step) + size // 2 for z in roots))
            found = images.fidget_errors(name, size, depths)
            self.assertEqual((found["wrong_hits"], found["wrong_misses"]), (0, 0))
            self.assertLessEqual(found["depth"][2], 0.5 * step * (1 + 1e-9))
            self.assertGreater(found["hits"], 100)
            lost = next(k for k, d in enumerate(depths) if d)
            depths[lost] = 0
            self.assertEqual(images.fidget_errors(name, size, depths)["wrong_misses"], 1)

    def test_top_root_is_on_the_surface(self):
        z = images.top_root("tanglecube", 1.5, 1.25)
        self.assertAlmostEqual(sum(a ** 4 - 5 * a * a for a in (1.5, 1.25, z)) + 11.8, 0, 12)
        z = images.top_root("quartdef", 0.75, 1)
        self.assertAlmostEqual(sum((a * a - 1) ** 2 for a in (0.75, 1, z)) - 1, 0, 12)


class Measurement(unittest.TestCase):
    def test_tanglecube_in_small(self):
        if PROGRAM is None:
            self.skipTest("graze-traversal-bench is not built")
        with tempfile.TemporaryDirectory() as folder:
            context = contexts.Context(folder, quick=True, core=min(contexts.os.sched_getaffinity(0)))
            scene = images.graze_scene(context, PROGRAM, "tanglecube", 32)
            truth = images.roots(context, "tanglecube", 32)
            self.assertEqual(scene["truth"], "exact")
            self.assertEqual(scene["hits"], sum(map(math.isfinite, truth)))
            certified = [r for r in scene["rows"] if r["levels"] == 0]
            self.assertTrue(certified)
            for row in certified + [r for r in scene["rows"] if r["method"] in images_page.SOUND]:
                self.assertEqual((images_page.wrong(row), row["not_enclosed"]), (0, 0), row)
            for row in certified:
                self.assertEqual(row["hits"], scene["hits"])
                self.assertLess(row["depth"][2], 1e-12)
            descent = images_page.row_of(scene, "upward")
            self.assertLess(descent["depth"][2], descent["half_diagonal"])
            # without outward rounding rays are lost where a level is an ulp
            self.assertGreater(images_page.wrong(images_page.row_of(scene, "gargantini", 53)), 0)
            if images.shutil.which("povray"):
                right, small = images.povray_scene(context, "tanglecube", 32, [1e-6], [5])
                self.assertEqual(images_page.wrong(right), 0)
                self.assertLess(right["depth"][2], 2e-6)
                self.assertGreater(images_page.wrong(small), 0)
            images.show({"scenes": {"tanglecube": scene}, "fidget": []})


if __name__ == "__main__":
    if len(sys.argv) > 1 and pathlib.Path(sys.argv[1]).exists():
        PROGRAM = pathlib.Path(sys.argv[1])
    done = unittest.main(argv=sys.argv[:1], exit=False).result
    sys.exit(1 if not done.wasSuccessful() else 77 if done.skipped else 0)
