#!/usr/bin/env python3
"""Holds the arrows that docs/architecture.md draws against the code: check_arrows.py ROOT [--self-test]

The drawing is the page's mermaid block: a node is a folder, an arrow says that the first may include
headers of, and link to, the second and whatever that one may. Read from the code are each #include of a
file of ours and each target_link_libraries. An error is an arrow of the code that is not drawn, an arrow
drawn that no code needs, a folder drawn that is not there, and a circle.
--self-test: each kind of error, made on purpose, is found. Exit codes: 0 all is well, 1 an error, 2 bad input.
"""
import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

NODE = re.compile(r'(\w+)\["([^"]+)"\]')
ARROW = re.compile(r"^\s*(\w+)(?:\[\"[^\"]*\"\])?\s*-->\s*(\w+)")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
SOURCES = {".hpp", ".cpp", ".h", ".c"}
MADE = re.compile(r"^\s*(?:add_library|add_executable|graze_library|graze_program|graze_test)\(\s*([\w${}-]+)"
                  r"(?:\s+ALIAS\s+([\w:-]+))?", re.M)
LINKED = re.compile(r"target_link_libraries\(([^)]*)\)")


def drawing(page):
    """The folders and arrows of the mermaid block."""
    block = re.search(r"```mermaid\n(.*?)```", page, re.S)
    if not block:
        sys.exit("docs/architecture.md has no mermaid block")
    folders = {name: label.rstrip("/") for name, label in NODE.findall(block[1])}
    arrows = set()
    for line in block[1].splitlines():
        if found := ARROW.match(line):
            if missing := [end for end in found.groups() if end not in folders]:
                sys.exit(f"docs/architecture.md draws an arrow of {missing[0]}, which is no folder there")
            arrows.add(tuple(folders[end] for end in found.groups()))
    return set(folders.values()), arrows


def reach(arrows):
    """Whatever each folder may use."""
    closed = {}
    def follow(folder, seen):
        for a, b in arrows:
            if a == folder and b not in seen:
                seen.add(b)
                follow(b, seen)
        return seen
    for a, _ in arrows:
        closed[a] = follow(a, set())
    return closed


def folder_of(path, folders):
    holding = [f for f in folders if path == f or path.startswith(f + "/")]
    return max(holding, key=len, default=None)


def tracked(root):
    out = subprocess.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                         capture_output=True, text=True)
    if out.returncode == 0 and out.stdout:
        return [name for name in out.stdout.split("\0") if name and (root / name).is_file()]
    return [str(p.relative_to(root)) for p in root.rglob("*") if p.is_file()]


def used(root, folders):
    """{(from, to): the first place that needs it}"""
    files = tracked(root)
    installed = {f.split("/include/", 1)[1]: f for f in files if "/include/" in f}
    installed |= {f.removeprefix("fuzz/"): f for f in files if f.startswith("fuzz/")}
    present, arrows = set(files), {}

    def need(source, target, place):
        a, b = folder_of(source, folders), folder_of(target, folders)
        if a and b and a != b:
            arrows.setdefault((a, b), place)

    made = {}
    for name in files:
        if Path(name).name == "CMakeLists.txt":
            for target, alias in MADE.findall((root / name).read_text()):
                for known in (target, "graze_" + target, "graze::" + target):
                    made.setdefault(known, name)
    for name in files:
        if Path(name).suffix in SOURCES:
            text = (root / name).read_text(errors="replace")
            for match in INCLUDE.finditer(text):
                beside = str((root / name).parent.joinpath(match[1]).resolve())
                beside = beside[len(str(root)) + 1:] if beside.startswith(str(root) + "/") else ""
                target = beside if beside in present else installed.get(match[1])
                if target:
                    need(name, target, f"{name}:{text.count(chr(10), 0, match.start()) + 1}")
        elif Path(name).name == "CMakeLists.txt":
            text = (root / name).read_text()
            for match in LINKED.finditer(text):
                for word in match[1].split()[1:]:
                    if word in made:
                        need(name, made[word], f"{name}:{text.count(chr(10), 0, match.start()) + 1}")
    return arrows


def errors(root):
    folders, drawn = drawing((root / "docs/architecture.md").read_text())
    found = [f"{folder} is drawn and is no folder" for folder in sorted(folders) if not (root / folder).is_dir()]
    allowed = reach(drawn)
    found += [f"{folder} is in a circle of arrows" for folder in sorted(allowed) if folder in allowed[folder]]
    code = used(root, folders)
    found += [f"{place}: {a} uses {b}, and no arrow is drawn"
              for (a, b), place in sorted(code.items()) if b not in allowed.get(a, ())]
    found += [f"{a} --> {b} is drawn and nothing needs it" for a, b in sorted(drawn)
              if (a, b) not in code and not any(b in allowed.get(c, ()) and c != b and (a, c) in code
                                                for c in allowed.get(a, ()))]
    return found, len(code), len(drawn)


def self_test():
    def made(page, files):
        with tempfile.TemporaryDirectory() as name:
            root = Path(name).resolve()
            for path, text in {"docs/architecture.md": page, **files}.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
            return errors(root)[0]
    page = '```mermaid\nflowchart LR\n  top["top/"] --> low["low/"]\n  side["side/"] --> low\n```\n'
    files = {"low/include/low.hpp": "", "top/a.cpp": "#include <low.hpp>\n", "side/b.hpp": '#include <low.hpp>\n'}
    cases = {
        "nothing": (page, files, None),
        "an include against the arrows": (page, {**files, "low/c.cpp": '#include "../side/b.hpp"\n'}, "low uses side"),
        "an include between unjoined folders": (page, {**files, "top/d.cpp": '#include "../side/b.hpp"\n'}, "top uses side"),
        "a link against the arrows": (page, {**files, "top/CMakeLists.txt": "add_library(t a.cpp)\n",
                                            "low/CMakeLists.txt": "target_link_libraries(x PRIVATE t)\n"}, "low uses top"),
        "an arrow that nothing needs": (page, {**files, "top/a.cpp": ""}, "top --> low is drawn"),
        "a folder that is not there": (page.replace("side/", "other/"), files, "other is drawn"),
        "a circle": (page.replace("```\n", "  low --> top\n```\n", 2).replace("```mermaid\n  low --> top\n", "```mermaid\n"),
                     {**files, "low/c.cpp": '#include "../top/a.hpp"\n', "top/a.hpp": ""}, "in a circle"),
    }
    wrong = []
    for name, (drawn, tree, expected) in cases.items():
        found = made(drawn, tree)
        if (expected is None and found) or (expected and not any(expected in e for e in found)):
            wrong.append(f"{name}: {found}")
    return wrong, len(cases)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=Path)
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        wrong, count = self_test()
        print("\n".join(wrong) or f"{count} trees, each judged right")
        return 1 if wrong else 0
    if not (options.root / "docs/architecture.md").is_file():
        print(f"{options.root} has no docs/architecture.md", file=sys.stderr)
        return 2
    found, code, drawn = errors(options.root.resolve())
    print("\n".join(found) or f"{code} arrows in the code, {drawn} drawn: all is well")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
