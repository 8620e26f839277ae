"""exact_peer.py ADAPTER PROMISE [lose]: answers rays through a map in fractions, from the voxels that ADAPTER reads.

It takes the file and the grid from the first request alone. With `lose` it leaves out the voxels of one layer."""
import json
import subprocess
import sys
from fractions import Fraction

adapter, promise = sys.argv[1:3]
lose = "lose" in sys.argv[3:]
print(json.dumps({"promise": promise, "cells": "grid"}), flush=True)
boxes = None


def planes_of(grid, axis):
    if isinstance(grid["planes"], list):
        return lambda k: Fraction(grid["planes"][axis][k])
    origin, spacing = Fraction(grid["origin"][axis]), Fraction(grid["spacing"][axis])
    if grid["planes"] == "rounded":
        return lambda k: Fraction(float(origin + k * spacing))
    return lambda k: Fraction(float(origin + Fraction(float(k * spacing))))


def read_map(request):
    ran = subprocess.run([adapter, "--voxels", request["scene"]], capture_output=True, check=True)
    line, _, rest = ran.stdout.partition(b"\n")
    assert json.loads(line)["first"] == request["first"]
    numbers = [int.from_bytes(rest[i : i + 4], "little") for i in range(0, len(rest), 4)]
    planes = [planes_of(request["grid"], a) for a in range(3)]
    result = {}
    for i in range(0, len(numbers), 3):
        voxel = numbers[i : i + 3]
        if not (lose and voxel[0] == 2):
            result[tuple(voxel)] = [(planes[a](voxel[a]), planes[a](voxel[a] + 1)) for a in range(3)]
    return result


def passage(origin, direction, box):
    """Entry, and whether the interior is crossed; None where the closed box is not touched."""
    enter, leave, inside = Fraction(0), None, True
    for o, d, (lo, hi) in zip(origin, direction, box):
        if d == 0:
            if not lo <= o <= hi:
                return None
            inside = inside and lo < o < hi
            continue
        near, far = sorted(((lo - o) / d, (hi - o) / d))
        enter = max(enter, near)
        leave = far if leave is None else min(leave, far)
    if enter > leave:
        return None
    return enter, inside and enter < leave


for line in sys.stdin:
    request = json.loads(line)
    if boxes is None:
        boxes = read_map(request)
    assert "scene" in request and request["id"] >= 0
    ray = [[Fraction(x) for x in request[m]] for m in ("origin", "direction")]
    met = [(v, p) for v, b in boxes.items() if (p := passage(*ray, b)) is not None]
    met.sort(key=lambda x: x[1][0])
    answer = {"visited": [v for v, _ in met]}
    if promise == "first":
        crossed = [(v, p) for v, p in met if p[1]]
        answer = {"first": crossed[0][0] if crossed else None}
        if crossed and crossed[0][1][0] < 1e300:
            answer["t"] = float(crossed[0][1][0])
    elif promise == "first-touched":
        answer = {"first": met[0][0] if met else None}
    elif promise == "any":
        answer = {"hit": any(p[1] for _, p in met)}
    if "echo" in request:
        answer["echo"] = request["bits"]["echo"]
    print(json.dumps(answer), flush=True)
