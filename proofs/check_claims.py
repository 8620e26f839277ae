#!/usr/bin/env python3
"""Holds proofs/CLAIMS.md against the repository: check_claims.py ROOT [--ctest CTEST --build DIR]

- every guarantee in README.md and docs/*.md bears an anchor, an HTML comment "claim: id ...", in its
  paragraph, or right under its section's heading; a paragraph that promises in so many words and has
  none is reported ("no claim" in a comment exempts);
- every anchor has a row, and every row an anchor;
- every row's targets are there: its files, the names in backticks after a file in that file, the
  theorems File.name in proofs/coq (those of docs/proofs.md too), the other files of its proof, the tests in `ctest -N`.
--self-test: each kind of broken row, made on purpose, is found. Exit codes: 0, 1.
"""
import argparse
import fnmatch
import re
import subprocess
import sys
from pathlib import Path

PROMISE = re.compile(r"\b(never|always|guarantee\w*|no octant|0 ulp|tightest|bit for bit|exactly)\b", re.I)
ANCHOR = re.compile(r"<!-- claim: ([\w\s-]+?) -->")
COLUMNS = ("id", "guarantee", "code", "bound", "proof", "tests")


def documents(root):
    return [root / "README.md"] + sorted((root / "docs").glob("*.md"))


def blocks(text):
    """(line number, text) of each paragraph; a table or a list belongs to the paragraph before it."""
    found, line = [], 1
    for part in re.split(r"(\n\s*\n)", text):
        if part.strip():
            if found and re.match(r"\s*(\||- |\d+\. |<!--)", part):
                found[-1] = (found[-1][0], found[-1][1] + "\n\n" + part)
            else:
                found.append((line, part))
        line += part.count("\n")
    return found


def rows(claims):
    """The rows of the table of guarantees, as dictionaries."""
    result = []
    for number, line in enumerate(claims.splitlines(), 1):
        cells = [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]
        if len(cells) == len(COLUMNS) and cells[0] != "id" and not set(cells[0]) <= set("-: "):
            result.append(dict(zip(COLUMNS, cells), line=number))
    return result


def expanded(path):
    """a/{b,c}.hpp -> a/b.hpp, a/c.hpp"""
    braces = re.search(r"\{([^}]*)\}", path)
    if not braces:
        return [path]
    return [expanded_path for choice in braces.group(1).split(",")
            for expanded_path in expanded(path[:braces.start()] + choice + path[braces.end():])]


def code_problems(root, cell):
    files = []
    for token in re.findall(r"`[^`]+`|[\w./{},*-]+/[\w./{},*-]*", cell):
        if token.startswith("`"):
            name = token.strip("`")
            if not any(name in file.read_text(errors="replace") for file in files):
                yield f"`{name}` is in none of {', '.join(str(f.relative_to(root)) for f in files) or 'no file'}"
            continue
        files = []
        for path in expanded(token.rstrip(",;.")):
            found = sorted(root.glob(path)) if "*" in path else [root / path]
            found = [p for p in found if p.exists()]
            if not found:
                yield f"no file {path}"
            files += [p for h in found for p in ([h] if h.is_file() else sorted(h.rglob("*.[ch]pp")))]
    if not re.search(r"/", cell):
        yield "names no code"


def proof_problems(root, cell):
    for file, name in re.findall(r"\b([A-Z]\w*)\.([\w']+)", cell):
        if name == "v":
            continue
        path = root / "proofs" / "coq" / f"{file}.v"
        if not path.exists():
            yield f"no proofs/coq/{file}.v"
        elif not re.search(rf"^\s*(Theorem|Lemma|Corollary)\s+{re.escape(name)}(?![\w'])",
                           path.read_text(), re.M):
            yield f"no theorem {name} in {file}.v"
    for path in re.findall(r"proofs/[\w./-]+", cell):
        if not (root / path.rstrip(".")).exists():
            yield f"no file {path}"
    if not cell:
        yield "names no proof and no argument"


def test_problems(names, cell):
    """A test is gone, unless its program is not built here: then nothing can be said."""
    missing_programs = any("NOT_BUILT" in name for name in names)
    patterns = [p.strip() for p in re.split(r";", cell) if p.strip()]
    if not patterns:
        yield "names no test"
    for pattern in patterns:
        simple = re.sub(r"([\[\]])", r"[\1]", pattern)
        for name in expanded(simple):
            if not missing_programs and not fnmatch.filter(names, name + "*"):
                yield f"no test {name}"


def problems(root, claims, texts, names):
    found, seen, anchored = [], set(), set()
    table = rows(claims)
    for path, text in texts.items():
        if path.name == "proofs.md":
            # Its code spans name theorems in full, or a family by `name_...`.
            spans = re.findall(r"`([A-Z]\w*\.[a-z][\w']*)`", text)
            found += [f"{path}: {p}" for p in proof_problems(root, " ".join(spans))]
        section = False  # whether the heading above bears an anchor
        for line, block in blocks(text):
            if block.startswith("#"):
                section = re.match(r"#+ .*\s+<!-- claim: [^>]*-->", block) is not None
            ids = [i for anchor in ANCHOR.findall(block) for i in anchor.split()]
            anchored |= set(ids)
            known = {row["id"] for row in table}
            found += [f"{path}:{line}: claim {i} has no row in CLAIMS.md" for i in ids if i not in known]
            promise = PROMISE.search(block)
            if promise and not ids and not section and "<!-- no claim -->" not in block and not block.startswith("    "):
                found.append(f"{path}:{line}: '{promise.group(0)}' promises, and has no claim beside it")
    for row in table:
        prefix = f"CLAIMS.md:{row['line']}: {row['id']}: "
        if row["id"] in seen:
            found.append(prefix + "twice")
        seen.add(row["id"])
        if row["id"] not in anchored:
            found.append(prefix + "no guarantee in README or docs bears this id")
        found += [prefix + p for p in code_problems(root, row["code"])]
        found += [prefix + p for p in proof_problems(root, row["proof"])]
        found += [prefix + p for p in test_problems(names, row["tests"])]
    if not table:
        found.append("CLAIMS.md: no rows")
    return found


def self_test(root, claims, texts, names):
    """Each break must be reported, and the first must be the one that was made."""
    row = rows(claims)[0]
    line = claims.splitlines()[row["line"] - 1]
    some = next(iter(texts))
    names = [name for name in names if "NOT_BUILT" not in name]
    breaks = {
        "file": (claims.replace(line, line.replace(".hpp", ".gone")), texts, "no file"),
        "name": (claims.replace(line, line.replace("| " + row["code"], "| " + row["code"] + " `no_such_name`")),
                 texts, "no_such_name"),
        "theorem": (claims.replace(line, line.replace(row["proof"], "Never_miss.no_such_theorem")), texts,
                    "no theorem no_such_theorem"),
        "test": (claims.replace(line, line.replace(row["tests"], "no.such: test")), texts, "no test"),
        "row": (claims.replace(line, ""), texts, "has no row"),
        "anchor": (claims, {p: ANCHOR.sub("", t) for p, t in texts.items()}, "promises"),
        "promise": (claims, {**texts, some: texts[some] + "\n\nIt never rains.\n"}, "'never' promises"),
    }
    code = 0
    for title, (broken, documents_, expected) in breaks.items():
        found = [p for p in problems(root, broken, documents_, names) if expected in p]
        print(f"broken {title}: {found[0] if found else 'NOT FOUND'}")
        code |= not found
    return code


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("--ctest", default="ctest")
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    root = arguments.root
    claims = (root / "proofs" / "CLAIMS.md").read_text()
    texts = {path.relative_to(root): path.read_text() for path in documents(root)}
    listed = subprocess.run([arguments.ctest, "-N"], cwd=arguments.build, text=True, capture_output=True)
    names = re.findall(r"^\s*Test\s+#\d+:\s+(.*)$", listed.stdout, re.M)
    if arguments.self_test:
        return self_test(root, claims, texts, names)
    found = problems(root, claims, texts, names)
    print("\n".join(found))
    unbuilt = [name for name in names if "NOT_BUILT" in name]
    if unbuilt:
        print(f"programs not built, so that no test's name was checked: {', '.join(unbuilt)}")
    print(f"{len(rows(claims))} claims, {len(found)} problems, {len(names)} tests known")
    return 1 if found or unbuilt else 0


if __name__ == "__main__":
    sys.exit(main())
