#!/usr/bin/env python3
"""Measures first hits and writes docs/first_hits.md's tables and docs/first_hits.svg.

usage: bench/traversal_figures.py PROGRAM [--from FILE] [options of the program]
PROGRAM is graze-traversal-bench; --from takes its --json output instead of running it.
"""
import json
import pathlib
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs"
PATHS = ["avx512", "avx2", "baseline", "scalar"]
COLOURS = {"avx512": "#b3261e", "avx2": "#d98e04", "baseline": "#2a6fbb", "scalar": "#555555"}


def measure(arguments):
    if "--from" in arguments:
        text = pathlib.Path(arguments[arguments.index("--from") + 1]).read_text()
    else:
        command = [arguments[0], "surface", "--json", *arguments[1:]]
        text = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    return [json.loads(line) for line in text.splitlines()]


def table(rows, key, title):
    paths = [p for p in PATHS if any(r["path"] == p for r in rows)]
    lines = [f"| {title} | octants opened a ray | " + " | ".join(f"{p}, M rays/s" for p in paths)
             + f" | {paths[0]}, ns an octant |", "|" + "---|" * (len(paths) + 3)]
    for value in sorted({r[key] for r in rows}):
        of_path = {r["path"]: r for r in rows if r[key] == value}
        steps = next(iter(of_path.values()))["steps_per_ray"]
        first = of_path[paths[0]]["rays_per_second"]
        lines.append(f"| {value} | {steps:.1f} | "
                     + " | ".join(f"{of_path[p]['rays_per_second'] / 1e6:.2f}" for p in paths)
                     + f" | {1e9 / (first * steps):.1f} |")
    return "\n".join(lines)


def panel(rows, key, label, left, parts):
    """Nanoseconds a ray for each path, and octants a ray (dashed), against `key`."""
    width, height, top = 330, 260, 40
    xs = sorted({r[key] for r in rows})
    most = max(1e9 / r["rays_per_second"] for r in rows) * 1.05

    def x(v):
        return left + 50 + (v - xs[0]) / (xs[-1] - xs[0]) * width

    def y(v, limit):
        return top + height - v / limit * height

    def text(px, py, words, anchor="middle", colour="#222"):
        parts.append(f'<text x="{px:.0f}" y="{py:.0f}" text-anchor="{anchor}" fill="{colour}">{words}</text>')

    parts.append(f'<rect x="{left + 50}" y="{top}" width="{width}" height="{height}" fill="none" stroke="#999"/>')
    for v in xs:
        text(x(v), top + height + 16, v)
    for k in range(5):
        text(left + 45, y(most * k / 4, most) + 4, f"{most * k / 4:.0f}", "end")
    text(left + 50 + width / 2, top + height + 34, label)
    for p in PATHS:
        line = sorted((r[key], 1e9 / r["rays_per_second"]) for r in rows if r["path"] == p)
        if line:
            points = " ".join(f"{x(a):.1f},{y(b, most):.1f}" for a, b in line)
            parts.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[p]}" stroke-width="2"/>')
    steps = {r[key]: r["steps_per_ray"] for r in rows}
    limit = max(steps.values()) * 1.05
    points = " ".join(f"{x(a):.1f},{y(b, limit):.1f}" for a, b in sorted(steps.items()))
    parts.append(f'<polyline points="{points}" fill="none" stroke="#000" stroke-dasharray="4 3"/>')
    text(left + 56 + width, y(max(steps.values()), limit) + 4, f"{max(steps.values()):.0f}", "start")


def figure(rows):
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 880 370" font-family="sans-serif" font-size="11">',
             '<rect width="880" height="370" fill="#fff"/>']
    panel([r for r in rows if r["octree_level"] == 9], "levels", "NL, octree to level 9", 10, parts)
    panel([r for r in rows if r["levels"] == 30], "octree_level", "octree's level, NL = 30", 450, parts)
    at = 60
    for p in PATHS:
        parts.append(f'<text x="{at}" y="22" fill="{COLOURS[p]}">{p}, ns a ray</text>')
        at += 130
    parts.append(f'<text x="{at}" y="22">dashed: octants opened a ray</text></svg>')
    return "\n".join(parts) + "\n"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    rows = measure(sys.argv[1:])
    hits = [r for r in rows if r["what"] == "first_hit"]
    sections = []
    for scene in dict.fromkeys(r["scene"] for r in rows):
        of_scene = [r for r in hits if r["scene"] == scene]
        voxels = {r["path"]: r["milliseconds"] for r in rows
                  if r["scene"] == scene and r["what"] == "voxelize"}
        sections += [f"### {scene}", "Voxelized to level 9 in "
                     + ", ".join(f"{voxels[p]:.1f} ms ({p})" for p in PATHS if p in voxels) + ".",
                     table([r for r in of_scene if r["octree_level"] == 9], "levels", "NL"),
                     table([r for r in of_scene if r["levels"] == 30], "octree_level", "octree's level")]
    page = DOCS / "first_hits.md"
    before, rest = page.read_text().split("<!-- measured -->\n", 1)
    after = rest.split("<!-- end of measured -->", 1)[1]
    page.write_text(before + "<!-- measured -->\n" + "\n\n".join(sections)
                    + "\n\n<!-- end of measured -->" + after)
    (DOCS / "first_hits.svg").write_text(figure([r for r in hits if r["scene"] == "tanglecube"]))


if __name__ == "__main__":
    main()
