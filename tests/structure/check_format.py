#!/usr/bin/env python3
"""Every C and C++ file is as clang-format-19 writes it: check_format.py ROOT CLANG_FORMAT [--self-test]

.clang-format-ignore beside a file takes it out (clang-format's own rule). --self-test: a file that is not
formatted is found. Exit codes: 0 all is well, 1 a file is not (they are named), 2 bad input.
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from check_arrows import SOURCES, tracked


def unformatted(root, program, names):
    found = set()
    for first in range(0, len(names), 100):  # a command's line has room for them
        done = subprocess.run([program, "--dry-run", *names[first:first + 100]], cwd=root, capture_output=True,
                              text=True)
        if done.returncode:
            sys.exit(f"{program} failed: {done.stderr.strip()}")
        found |= set(re.findall(r"^(.*?):\d+:\d+: warning: code should be clang-formatted", done.stderr, re.M))
    return sorted(found)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.splitlines()[0].split(": ", 1)[1])
    parser.add_argument("root", type=Path)
    parser.add_argument("program")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(options.root / ".clang-format", folder)
            (Path(folder) / "right.cpp").write_text("int f(int* x) { return *x; }\n")
            (Path(folder) / "wrong.cpp").write_text("int f(int *x) { return *x; }\n")
            found = unformatted(folder, options.program, ["right.cpp", "wrong.cpp"])
        print(f"found: {', '.join(found)}")
        return 0 if found == ["wrong.cpp"] else 1
    names = sorted(name for name in tracked(options.root)
                   if Path(name).suffix in SOURCES and not name.startswith("build/"))
    found = unformatted(options.root, options.program, names)
    for name in found:
        print(f"{name} is not formatted: clang-format-19 -i {name}")
    print(f"{len(names)} files, {len(found)} not as clang-format-19 writes them")
    return 1 if found or not names else 0


if __name__ == "__main__":
    sys.exit(main())
