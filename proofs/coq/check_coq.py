#!/usr/bin/env python3
"""Checks the Coq files of a folder: check_coq.py WHAT --sources DIR --build DIR [--claims FILE]

compile  coqc on every .v, in dependency order and in parallel, into the build folder
check    coqchk, the independent checker of Coq's kernel, on every compiled file
axioms   Print Assumptions of every theorem: only the axioms below may appear
words    the sources have no Admitted, no axiom of their own, no check of the kernel turned off

Each step is repeated only if what it depends on has changed. Exit codes: 0 passed, 1 failed, 77 Coq
is not installed.
"""
import argparse
import hashlib
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

SKIPPED = 77

# The reals of Coq's standard library, classical logic, functional extensionality.
ALLOWED = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "Classical_Prop.classic",
    "FunctionalExtensionality.functional_extensionality_dep",
}

FORBIDDEN = re.compile(
    r"\b(Admitted|admit|give_up|Axioms?|Parameters?|Conjectures?|bypass_check|type-in-type)\b"
    r"|\b(Unset|Set)\s+(Guard|Positivity|Universe)\s+Checking\b|Declare\s+ML\s+Module")


def without_comments(text):
    """Replaces Coq's nested comments by blanks; strings are left alone."""
    out, depth, i, in_string = [], 0, 0, False
    while i < len(text):
        two = text[i:i + 2]
        if depth == 0 and text[i] == '"':
            in_string = not in_string
        if not in_string and two == "(*":
            depth, i = depth + 1, i + 2
            out.append("  ")
        elif not in_string and two == "*)" and depth:
            depth, i = depth - 1, i + 2
            out.append("  ")
        else:
            out.append(text[i] if depth == 0 or text[i] == "\n" else " ")
            i += 1
    return "".join(out)


def theorems(sources):
    """{file without ending: names of its theorems, lemmas and corollaries, in order}"""
    pattern = re.compile(r"^\s*(?:Local\s+)?(Theorem|Lemma|Corollary|Fact|Proposition)\s+([\w']+)", re.M)
    return {path.stem: pattern.findall(without_comments(path.read_text()))
            for path in sorted(sources.glob("*.v"))}


def named_in(claims, known):
    """The theorems that the claims name as File.theorem."""
    names = re.findall(r"\b([A-Z]\w*)\.([\w']+)", claims.read_text()) if claims else []
    return [(f, t) for f, t in names if f in known and t in {name for _, name in known[f]}]


def words(arguments):
    found = 0
    for path in sorted(arguments.sources.glob("*.v")):
        for number, line in enumerate(without_comments(path.read_text()).splitlines(), 1):
            if FORBIDDEN.search(line):
                print(f"{path.name}:{number}: {line.strip()}")
                found += 1
    files = len(list(arguments.sources.glob("*.v")))
    print(f"{files} files, {found} forbidden words")
    return 1 if found or not files else 0


def run(command, **options):
    return subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)


def copy_sources(arguments):
    """Copies what differs, so that unchanged files keep their time; drops what is gone."""
    arguments.build.mkdir(parents=True, exist_ok=True)
    kept = {path.name for path in arguments.sources.glob("*.v")} | {"Axioms.v"}
    for old in arguments.build.glob("*.v"):
        if old.name not in kept:
            for compiled in arguments.build.glob(old.stem + ".*"):
                compiled.unlink()
    for path in arguments.sources.glob("*.v"):
        copy = arguments.build / path.name
        if not copy.exists() or copy.read_bytes() != path.read_bytes():
            shutil.copyfile(path, copy)


def compile_all(arguments):
    copy_sources(arguments)
    files = sorted(path.name for path in arguments.sources.glob("*.v"))
    # A forgotten entry would leave a file unchecked: every file of the folder is compiled.
    version = run(["coqc", "--version"]).stdout
    stamp = arguments.build / "coq_version"
    if not stamp.exists() or stamp.read_text() != version:
        for compiled in arguments.build.glob("*.vo*"):
            compiled.unlink()
        stamp.write_text(version)
    (arguments.build / "_CoqProject").write_text("-Q . Graze\n" + "\n".join(files) + "\n")
    made = run(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile.coq"], cwd=arguments.build)
    if made.returncode:
        print(made.stdout)
        return 1
    made = run(["make", "-f", "Makefile.coq", "-k", f"-j{os.cpu_count() or 1}",
                f"COQC=timeout {arguments.seconds} coqc"], cwd=arguments.build)
    print(made.stdout, end="")
    print(f"{len(files)} files compiled by {version.splitlines()[0]}")
    return 1 if made.returncode else 0


def digest(paths, *more):
    sha = hashlib.sha256("\0".join(more).encode())
    for path in sorted(paths):
        sha.update(path.name.encode() + b"\0" + path.read_bytes())
    return sha.hexdigest()


def cached(arguments, name, key, step):
    """Runs step() -> (passed, text) unless it has passed on the same key; prints its text."""
    stamp = arguments.build / f"{name}.passed"
    if stamp.exists() and stamp.read_text().split("\n", 1)[0] == key:
        print(stamp.read_text().split("\n", 1)[1], end="")
        print("(as of the last run: nothing has changed since)")
        return 0
    passed, text = step()
    print(text, end="")
    if passed:
        stamp.write_text(key + "\n" + text)
    return 0 if passed else 1


def compiled_files(arguments):
    """The compiled files, or None if one is missing or older than its source."""
    compiled = []
    for path in sorted(arguments.sources.glob("*.v")):
        copy, vo = arguments.build / path.name, arguments.build / (path.stem + ".vo")
        if not vo.exists() or copy.read_bytes() != path.read_bytes() \
                or vo.stat().st_mtime < copy.stat().st_mtime:
            print(f"{path.name} is not compiled: run `compile` first")
            return None
        compiled.append(vo)
    return compiled


def check(arguments):
    compiled = compiled_files(arguments)
    if compiled is None:
        return 1

    def step():
        done = run(["coqchk", "-silent", "-o", "-Q", ".", "Graze"] +
                   [f"Graze.{vo.stem}" for vo in compiled], cwd=arguments.build)
        text = done.stdout
        section = re.search(r"\* Axioms:(.*?)(?=\n\*|\Z)", text, re.S)
        axioms = set(re.findall(r"^\s+(\S+)$", section.group(1), re.M)) if section else {"?"}
        ours = [a for a in axioms if not any(a.endswith("." + allowed) for allowed in ALLOWED)]
        off = [line for line in re.findall(r"^\* (.*)$", text, re.M)
               if line.startswith(("Constants/Inductives", "Inductives whose")) and
               not line.rstrip().endswith("<none>")]
        for entry in ours + off:
            text += f"not allowed: {entry}\n"
        return done.returncode == 0 and not ours and not off, text

    return cached(arguments, "coqchk", digest(compiled, run(["coqchk", "--version"]).stdout), step)


def axioms(arguments):
    compiled = compiled_files(arguments)
    if compiled is None:
        return 1
    known = theorems(arguments.sources)
    claimed = named_in(arguments.claims, known)
    # All theorems at once (a tuple shares the walk through the libraries: seconds, not minutes),
    # then those that the claims name one by one.
    every = [(f, name) for f, names in known.items() for kind, name in names
             if kind in ("Theorem", "Corollary")]
    every += [named for named in dict.fromkeys(claimed) if named not in every]
    wanted = [("every theorem",)] + list(dict.fromkeys(claimed))
    source = "(** The axioms that each theorem rests on. Written by check_coq.py. *)\n"
    source += "From Graze Require " + " ".join(sorted({f for f, _ in every})) + ".\n"
    source += "Definition every := (" + ",\n  ".join(f"@Graze.{f}.{t}" for f, t in every) + ").\n"
    source += "Print Assumptions every.\n"
    source += "".join(f"Print Assumptions Graze.{f}.{t}.\n" for f, t in wanted[1:])
    path = arguments.build / "Axioms.v"
    if not path.exists() or path.read_text() != source:
        path.write_text(source)

    def step():
        done = run(["coqc", "-q", "-Q", ".", "Graze", "Axioms.v"], cwd=arguments.build)
        answers = re.split(r"^(?=Closed under the global context|Axioms:$)", done.stdout, flags=re.M)[1:]
        if done.returncode or len(answers) != len(wanted):
            return False, done.stdout + f"{len(answers)} answers for {len(wanted)} questions\n"
        passed, text = True, ""
        for theorem, answer in zip(wanted, answers):
            names = set(re.findall(r"^([\w.']+)\s*(?::|$)", answer, re.M)) - {"Axioms"}
            if answer.startswith("Closed"):
                names = set()
            text += ".".join(theorem) + ": " + (", ".join(sorted(names)) or "no axiom") + "\n"
            if names - ALLOWED:
                passed = False
                text += f"  NOT ALLOWED: {', '.join(sorted(names - ALLOWED))}\n"
        return passed, text + f"{len(every)} theorems, {len(wanted) - 1} of them named in the claims\n"

    key = digest(compiled + [arguments.build / "Axioms.v"], repr(sorted(ALLOWED)))
    return cached(arguments, "axioms", key, step)


def main():
    parser = argparse.ArgumentParser()
    steps = {"compile": compile_all, "check": check, "axioms": axioms, "words": words}
    parser.add_argument("what", choices=list(steps))
    parser.add_argument("--sources", type=Path, required=True)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--claims", type=Path)
    parser.add_argument("--seconds", type=int, default=300, help="limit for one file")
    arguments = parser.parse_args()
    if arguments.what != "words" and not all(map(shutil.which, ("coqc", "coqchk", "coq_makefile"))):
        print("skipped: Coq is not installed (Debian: coq, libcoq-flocq)")
        return SKIPPED
    started = time.monotonic()
    code = steps[arguments.what](arguments)
    print(f"{arguments.what}: {time.monotonic() - started:.1f} s")
    return code


if __name__ == "__main__":
    sys.exit(main())
