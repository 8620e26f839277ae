#!/usr/bin/env python3
"""read_npz.py GRAZE_RENDER RENDER_MD: a .npz file of graze-render by its bytes, and by the lines of Python
that docs/render.md shows, where NumPy is installed (77, skipped, where it is not)."""
import ast
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import zipfile

SIZES = {"|i1": "b", "<i4": "i", "<f8": "d"}


def read(archive, name):
    data = archive.read(name + ".npy")
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    (length,) = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0 and data[9 + length : 10 + length] == b"\n"
    header = ast.literal_eval(data[10 : 10 + length].decode())
    assert header["fortran_order"] is False
    if header["descr"].startswith("|S"):
        assert header["shape"] == ()
        return (), data[10 + length :]
    values = struct.unpack(f"<{math.prod(header['shape'])}{SIZES[header['descr']]}", data[10 + length :])
    return header["shape"], values


def main():
    program, page = sys.argv[1:]
    lines = re.search(r"```python\n(.*?)```", open(page).read(), re.S)[1]
    assert lines.count("\n") == 6, "six lines"
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "tanglecube.npz")
        make = [program, "--scene", "tanglecube", "--size", "48x40", "--json", "-o"]
        said = subprocess.run(make + [file], capture_output=True, text=True, check=True).stdout
        hits = int(re.search(r'"hits":(\d+)', said)[1])
        subprocess.run(make + [file + "2.npz", "--threads", "1"], capture_output=True, check=True)
        assert open(file, "rb").read() == open(file + "2.npz", "rb").read(), "other bytes"
        archive = zipfile.ZipFile(file)
        assert archive.testzip() is None
        shape, verdict = read(archive, "verdict")
        assert shape == (40, 48) and verdict.count(0) == hits > 500
        (_, lower), (_, upper) = read(archive, "depth_lower"), read(archive, "depth_upper")
        normals, point = read(archive, "normal_lower"), read(archive, "point_upper")
        assert normals[0] == point[0] == (40, 48, 3)
        for i, outcome in enumerate(verdict):
            if outcome == 0:
                assert 5 < lower[i] < upper[i] < lower[i] + 1e-11, (i, lower[i], upper[i])
                assert all(abs(c) <= 1 for c in normals[1][3 * i : 3 * i + 3])
            else:
                assert lower[i] == upper[i] == math.inf and math.isnan(normals[1][3 * i])
        assert read(archive, "scene")[1].startswith(b'{"name":"tanglecube"')
        for python in (sys.executable, "/usr/bin/python3"):
            if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode == 0:
                said = subprocess.run([python, "-c", lines], cwd=folder, capture_output=True, text=True)
                print(said.stdout, said.stderr)
                sys.exit(0 if said.returncode == 0 and said.stdout.startswith(f"{hits} hits") else 1)
    print("skipped: the file's bytes are right; NumPy is not installed, so the page's lines were not run")
    sys.exit(77)


main()
