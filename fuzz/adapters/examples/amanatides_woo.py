#!/usr/bin/env python3
"""Amanatides and Woo (1987) as it is usually written, for graze-fuzz to look at:

graze-fuzz run --level 10 --command "python3 amanatides_woo.py"
"""
import json
import math
import sys


def visited(origin, direction, lo, size, count):
    """The voxels of a grid of count[a] cubes from lo on that the ray visits, in order."""
    enter, leave = 0.0, math.inf
    for a in range(3):
        hi = lo[a] + count[a] * size
        if direction[a] == 0:
            if not lo[a] <= origin[a] < hi:
                return
            continue
        near, far = sorted(((lo[a] - origin[a]) / direction[a], (hi - origin[a]) / direction[a]))
        enter, leave = max(enter, near), min(leave, far)
    if enter > leave:
        return
    at, step, t_next, t_step = [], [], [], []
    for a in range(3):
        start = origin[a] + enter * direction[a]
        at.append(min(max(math.floor((start - lo[a]) / size), 0), count[a] - 1))
        if direction[a] == 0:
            step.append(0), t_next.append(math.inf), t_step.append(math.inf)
            continue
        step.append(1 if direction[a] > 0 else -1)
        plane = lo[a] + (at[a] + (direction[a] > 0)) * size
        t_next.append((plane - origin[a]) / direction[a])
        t_step.append(size / abs(direction[a]))
    while True:
        yield tuple(at)
        a = t_next.index(min(t_next))
        at[a] += step[a]
        if not 0 <= at[a] < count[a]:
            return
        t_next[a] += t_step[a]


print('{"promise": "crossed"}', flush=True)
for line in sys.stdin:
    ray = json.loads(line)
    base, root, size = ray["base"], ray["root"], ray["voxel_size"]
    corner = [root["lo"][a] + base[a] * size for a in range(3)]
    answer = [[base[a] + v[a] for a in range(3)]
              for v in visited(ray["origin"], ray["direction"], corner, size, ray["extent"])]
    print(json.dumps({"visited": answer, "echo": ray.get("echo")}), flush=True)
