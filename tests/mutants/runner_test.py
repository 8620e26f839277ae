#!/usr/bin/env python3
"""The runner of faults on a small tree of its own: what is caught, what survives, what is refused, and that
a run goes on where another ended. Exit codes: 0 passed, 1 failed."""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

# A tree with one program, made by hand; the runner asks Ninja how.
NINJA = """rule cxx
  command = c++ -std=c++17 -I{root}/interval/include -MD -MF $out.d -o $out -c $in
rule link
  command = : && c++ $in -o $out && :
build check.dir/check.cpp.o: cxx {root}/check.cpp
build bin/check: link check.dir/check.cpp.o
build check: phony bin/check
"""
# Takes a test's name as Catch does; fails, passes or does not end by what it says.
CHECK = """#include <graze/sum.hpp>
#include <cstdio>
#include <cstring>
int main(int, char** argv) {
  if (std::strcmp(argv[1], "sum") == 0)
    return sum(2, 3) == 5 ? 0 : 1;
  if (std::strcmp(argv[1], "nothing") == 0)
    return 0;
  std::puts("No test cases matched");
  return 0;
}
"""
SUM = """#pragma once
/* {0} */
inline int sum(int a, int b) {
  int total = a;
  for (int i = 0; i < b; ++i)
    total = total + 1;
  return total;
}
"""
FAULTS = """[[program]]
name = "check"
target = "check"
sources = ["check.cpp"]
[[program.group]]
file = "interval/include/graze/sum.hpp"
test = "sum"
faults = [
  ['total + 1', 'total + 2'],
  ['total + 1', 'total', {quick = true}],
  ['i < b', 'i <= b'],
  ['int total = a;', 'int total = b;', {alone = true}],
  ['i < b', 'i < b + 0', {equivalent = "the same"}],
  SURVIVOR
]
"""


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "interval/include/graze").mkdir(parents=True)
        (root / "interval/include/graze/sum.hpp").write_text(SUM)
        (root / "check.cpp").write_text(CHECK)
        (root / "tests/mutants").mkdir(parents=True)
        runner = root / "tests/mutants/run_faults.py"
        runner.write_text((HERE / "run_faults.py").read_text())
        build = root / "build"
        build.mkdir()
        (build / "build.ninja").write_text(NINJA.replace("{root}", str(root)))
        if subprocess.run(["ninja", "-C", str(build)], capture_output=True).returncode != 0:
            return "no tree"
        faults = root / "tests/mutants/faults.toml"

        def run(survivor, *arguments, build_in=build):
            faults.write_text(FAULTS.replace("SURVIVOR", survivor))
            return subprocess.run([sys.executable, str(runner), "--build", str(build_in), *arguments],
                                  capture_output=True, text=True)

        def want(done, code, *words):
            for word in words:
                if word not in done.stdout + done.stderr:
                    return f"no {word!r} in {done.stdout}{done.stderr}"
            if done.returncode != code:
                return f"exit code {done.returncode}, not {code}: {done.stdout}{done.stderr}"
            if code == 2 and done.stderr.count("\n") != 1:
                return f"not one line: {done.stderr}"
            return None

        survivor = "['i = 0', 'i = 0', {test = \"nothing\"}],"
        lost = "['return total;', 'return total + 1;', {alone = true, test = \"nothing\"}],"
        problems = [
            want(run(""), 0, "4 caught, 1 equivalent, 0 wrong"),
            want(run("", "--quick", "--fresh"), 0, "1 of 1 faults"),
            want(run(lost), 1, "1 wrong", "SURVIVES"),
            want(run(survivor), 2, "not another text"),
            want(run("['absent', 'x'],"), 2, "0 times, not once"),
            want(run("['total', 'x'],"), 2, "times, not once"),
            want(run("['i < b', 'i > b', {sooner = true}],"), 2, "members are"),
            want(run("['i < b', 'i +'],"), 2, "cannot make"),
            want(run("['i < b', 'true', {test = \"other\"}],"), 2, "no such test"),
            want(run("['i < b', 'i > b', {equivalent = \"no\"}],"), 1, "though listed as equivalent"),
            want(run("", build_in=root), 2, "is no tree"),
            want(run("", "--only", "nowhere"), 2, "no fault is asked for"),
            want(run("", "--jobs", "0"), 2, "--jobs"),
        ]
        # what was decided is not decided again; what has changed is
        done = run("", "--json", "--fresh")
        first_of = run("", "--json")
        if not first_of.stdout:
            return f"nothing: {first_of.stderr}"
        again = [json.loads(line) for line in run("", "--json").stdout.splitlines()]
        if not all(record["before"] for record in again[:-1]) or again[-1]["caught"] != 4:
            problems.append(f"decided again: {again}{done.stdout}")
        (root / "check.cpp").write_text(CHECK + "// changed\n")
        if any(json.loads(line)["before"] for line in run("", "--json").stdout.splitlines()[:-1]):
            problems.append("a changed test is not asked again")
        return "\n".join(p for p in problems if p)


if __name__ == "__main__":
    wrong = main()
    if wrong:
        print(wrong)
    sys.exit(1 if wrong else 0)
