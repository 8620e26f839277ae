"""maps_test.py PROGRAM WRITER FOLDER: PROGRAM --voxels reads the maps that WRITER writes, and refuses others."""
import json
import os
import random
import shutil
import subprocess
import sys
from fractions import Fraction

program, writer, folder = sys.argv[1:4]
wrong = []


def planes_of(grid, axis):
    """The function from a plane's number to its double."""
    if isinstance(grid["planes"], list):
        return lambda k: float.fromhex(grid["planes"][axis][k])
    origin, spacing = (float.fromhex(grid[m][axis]) for m in ("origin", "spacing"))
    if grid["planes"] == "rounded":
        return lambda k: float(Fraction(origin) + k * Fraction(spacing))
    assert grid["planes"] == "multiplied"
    return lambda k: origin + k * spacing


def read(path, options):
    ran = subprocess.run([program, "--voxels", path, *options], capture_output=True, timeout=300)
    if ran.returncode != 0:
        return ran.returncode, ran.stderr.decode(), None
    line, _, rest = ran.stdout.partition(b"\n")
    header = json.loads(line)
    assert len(rest) == 12 * header["voxels"], path
    numbers = [int.from_bytes(rest[i : i + 4], "little") for i in range(0, len(rest), 4)]
    return 0, header, [tuple(numbers[i : i + 3]) for i in range(0, len(numbers), 3)]


def check(condition, what):
    if not condition:
        wrong.append(what)


def compare(path):
    voxels, planes, ambiguous, options = set(), [], [None, None], []
    for line in open(path + ".expected"):
        kind, *words = line.split()
        if kind == "voxel":
            voxels.add(tuple(map(int, words)))
        elif kind == "plane":
            planes.append((int(words[0]), int(words[1]), float.fromhex(words[2])))
        elif kind == "ambiguous":
            ambiguous = [int(w) for w in words]
        else:
            options = words
    code, header, found = read(path, options)
    name = os.path.basename(path)
    if name.startswith("refused"):
        check(code == 2 and header.count("\n") == 1, f"{name}: not refused in one line: {header}")
        return
    if code != 0:
        wrong.append(f"{name}: refused: {header}")
        return
    first = header["first"]
    own = {tuple(i + f for i, f in zip(v, first)) for v in found}
    check(own == voxels, f"{name}: other voxels: {len(own - voxels)} too many, {len(voxels - own)} missing")
    check(len(found) == len(own) and found == sorted(found, key=lambda v: v[::-1]), f"{name}: not sorted")
    of = [planes_of(header["grid"], a) for a in range(3)]
    moved = [(a, i, x, of[a](i - first[a])) for a, i, x in planes if of[a](i - first[a]) != x]
    check(not moved, f"{name}: other planes: {len(moved)}, {moved[:3]}")
    counted = [header["ambiguous"], header["ambiguous_below"]]
    check(counted == ambiguous, f"{name}: ambiguous {counted}, expected {ambiguous}")
    shape = header["grid"]["planes"]
    print(f"{name}: {len(own)} voxels, {ambiguous} ambiguous, planes {shape if isinstance(shape, str) else 'given'}")


def damaged(path, options):
    """What is no map is refused in a line. (Libraries do worse with other bytes; none such is kept here.)"""
    start = open(path, "rb").read(100)
    other = os.path.join(folder, "damaged" + os.path.splitext(path)[1])
    for content in [b"", start[:4], start[:20], b"no map\n", random.Random(2026).randbytes(500)]:
        with open(other, "wb") as to:
            to.write(content)
        code, text, _ = read(other, options)
        check(code == 2 and text.count("\n") == 1, f"{os.path.basename(other)}: {content[:20]!r}: {code}, {text}")
    os.remove(other)
    for path in [other, folder]:
        code, text, _ = read(path, options)
        check(code == 2 and text.count("\n") == 1, f"{path}: {code}, {text}")


if not os.path.exists(program) or not os.path.exists(writer):
    print("skipped: the library is not there")
    sys.exit(77)
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
subprocess.run([writer, folder], check=True)
maps = sorted(f[: -len(".expected")] for f in os.listdir(folder) if f.endswith(".expected"))
check(maps, "no maps")
for each in maps:
    compare(os.path.join(folder, each))
for extension in sorted({os.path.splitext(each)[1] for each in maps}):
    one = next(each for each in maps if each.endswith(extension) and not each.startswith("refused"))
    words = [line.split()[1:] for line in open(os.path.join(folder, one + ".expected")) if line.startswith("option")]
    damaged(os.path.join(folder, one), words[0] if words else [])
for text in wrong:
    print("WRONG", text)
sys.exit(1 if wrong else 0)
