#!/usr/bin/env python3
"""Small faults made in the code on purpose: each must fail the test that is named beside it.

usage: run_faults.py --build DIR [options]

  --build DIR      a built tree (build/release) with the test programs that are asked for
  --list FILE      the faults (default: faults.toml beside this file)
  --only PATTERN   faults whose program, file, text or test holds this regular expression
  --quick          the ones that are marked quick: what ./check runs
  --jobs N         processes at a time (default: the number of cores)
  --out DIR        overlays, objects and results.jsonl (default: DIR/faults); a fault that was decided
                   there before is not run again, unless its file, its test or it itself has changed
  --fresh          decides all of them again
  --json           one object on one line for each fault, and one at the end
  --check          reads the list, finds every text, and ends
  --help           this text

Nothing of the built tree is changed. Of each program only the sources that the list names are compiled
again, from an overlay in which every fault is there, `GRAZE_FAULT(k) ? faulty : right`, and one is chosen
when the program starts; a fault that is no expression is compiled alone. The control, none of them chosen,
must pass. Exit codes: 0 every fault was caught, or is listed as equivalent and was not; 1 one survived, or
an equivalent one was caught; 2 bad input: a text that is not there once, a program that is not built, a
control that fails; 130 interrupted (what was decided is kept).
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
INCLUDES = ("interval/include", "octree/geometry/include", "octree/tree/include",
            "octree/surface/include", "octree/formula/include", "octree/file/include",
            "fuzz", "proofs/oracle/include")
CHOICE = """#pragma once
/* One fault of many, chosen when the program starts. */
#ifdef __cplusplus
extern "C"
#else
extern
#endif
int graze_fault;
#define GRAZE_FAULT(k) (graze_fault == (k))
"""
CHOOSE = """#include <stdlib.h>
int graze_fault;
__attribute__((constructor(101))) static void choose(void) {
  const char* chosen = getenv("GRAZE_FAULT");
  if (chosen)
    graze_fault = atoi(chosen);
}
"""
LEAST_SECONDS = 20  # for a run, and eight times what the control took


class BadInput(Exception):
    """One line for who called."""


def sources_of(program):
    return [*program["sources"], *program.get("library", [])]


def plain(source):
    """The file of SOURCE@PATH."""
    return source.partition("@")[0]


class Fault:
    """`right` in `file` becomes `faulty`; `test` of `program` must notice."""

    def __init__(self, number, program, row):
        self.number, self.program = number, program
        unknown = set(row) - {"file", "right", "faulty", "test", "quick", "alone", "equivalent"}
        if unknown or not {"file", "right", "faulty", "test"} <= set(row):
            raise BadInput(f"fault {number} of {program['name']}: members are file, right, faulty, test, and "
                           f"quick, alone, equivalent: {sorted(unknown) or sorted(row)}")
        self.file, self.right, self.faulty, self.test = (row[key] for key in ("file", "right", "faulty", "test"))
        self.quick, self.alone = row.get("quick", False), row.get("alone", False)
        self.equivalent = row.get("equivalent", "")
        text = (ROOT / self.file).read_text()
        if text.count(self.right) != 1:
            raise BadInput(f"{self.file} has {text.count(self.right)} times, not once: {self.right!r}")
        if self.right == self.faulty:
            raise BadInput(f"{self.file}: not another text: {self.right!r}")
        self.begin = text.index(self.right)
        self.end = self.begin + len(self.right)

    def key(self):
        """What decides whether it was decided before."""
        files = sorted({self.file, *(plain(f) for f in sources_of(self.program))})
        parts = [self.file, self.right, self.faulty, self.test, self.program["name"]]
        parts += [(ROOT / f).read_text() for f in files]
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:24]

    def words(self):
        texts = " ".join(self.right.split()), " ".join(self.faulty.split())
        return f"{self.file}: {texts[0]} -> {texts[1]}"


def row_of(group, fault):
    """A fault's members, with its group's file and test."""
    if not 2 <= len(fault) <= 3:
        raise BadInput(f"{group['file']}: a fault is [right, faulty] or [right, faulty, {{...}}]: {fault}")
    return {"file": group["file"], "test": group["test"], "right": fault[0], "faulty": fault[1],
            **(fault[2] if len(fault) == 3 else {})}


def read_list(path):
    try:
        tables = tomllib.loads(pathlib.Path(path).read_text())
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise BadInput(f"{path}: {error}") from None
    faults = []
    for program in tables.get("program", []):
        for f in sources_of(program):
            if not (ROOT / plain(f)).exists():
                raise BadInput(f"program {program['name']}: no file {f}")
        rows = [row_of(group, fault) for group in program["group"] for fault in group["faults"]]
        faults += [Fault(i, program, row) for i, row in enumerate(rows, 1)]
    for row in tables.get("unseen", []):
        text = (ROOT / row["file"]).read_text() if (ROOT / row["file"]).exists() else ""
        if text.count(row["right"]) != 1 or not row.get("reason"):
            raise BadInput(f"unseen: {row['file']} has {text.count(row['right'])} times, not once: {row['right']!r}")
    return faults, len(tables.get("unseen", []))


def rounds(faults):
    """Faults of one program, in lists whose texts do not overlap, so that one compilation has them all."""
    lists = []
    for fault in faults:
        if fault.alone:
            lists.append([fault])
            continue
        for batch in lists:
            if not batch[0].alone and all(f.file != fault.file or fault.end <= f.begin or f.end <= fault.begin
                                          for f in batch):
                batch.append(fault)
                break
        else:
            lists.append([fault])
    return lists


def overlay(directory, faults):
    """Writes the files with their faults; the file's own names and lines stand in what it reports."""
    for file in sorted({f.file for f in faults}):
        text, at, out = (ROOT / file).read_text(), 0, []
        for f in sorted((f for f in faults if f.file == file), key=lambda f: f.begin):
            chosen = f.faulty if f.alone else f"(GRAZE_FAULT({f.number}) ? ({f.faulty}) : ({f.right}))"
            out += [text[at:f.begin], chosen]
            at = f.end
        to = directory / file
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text("".join(out) + text[at:])


class Tree:
    """What the built tree tells of how its programs are made."""

    def __init__(self, build):
        self.build = pathlib.Path(build).resolve()
        if not (self.build / "build.ninja").exists():
            raise BadInput(f"{build} is no tree that was built by Ninja")
        self.links = {}

    def lines(self, target):
        if target not in self.links:
            commands = subprocess.run(["ninja", "-C", str(self.build), "-t", "commands", target],
                                      capture_output=True, text=True)
            if commands.returncode != 0:
                raise BadInput(f"no target {target} in {self.build}")
            self.links[target] = commands.stdout.splitlines()
        return self.links[target]

    def at(self, source):
        """Where it is compiled: a source for a path is included by a file that the build has made."""
        file, _, path = source.partition("@")
        if not path:
            return ROOT / file
        return self.build / "paths" / pathlib.Path(file).parent / f"{path}_{pathlib.Path(file).name}"

    def compile_line(self, target, source):
        """The arguments that compile the source, without the compiler's cache and -o."""
        at = str(self.at(source))
        lines = [shlex.split(line) for line in self.lines(target) if f" {at}" in line and " -c " in line]
        lines = [line for line in lines if at in line]
        # a test's own source is compiled for its own program
        lines.sort(key=lambda line: f"{target}.dir" not in line[line.index("-o") + 1])
        if not lines:
            raise BadInput(f"{target} does not compile {source}")
        line = lines[0]
        if pathlib.Path(line[0]).name == "ccache":
            line = line[1:]
        cut, skip = [], False
        for word in line:
            if skip:
                skip = False
            elif word in ("-o", "-MF", "-MT", "-MQ"):
                skip = True
            elif word not in ("-MD", "-c", at) and word != "-Werror":
                cut.append(word)
        return cut

    def link_line(self, target, objects, out):
        """The line that links the program, of `objects` in place of its own."""
        line = next((x for x in reversed(self.lines(target)) if f" -o bin/{target} " in x), None)
        if line is None:
            raise BadInput(f"{target} is no program")
        words = shlex.split(line.split("&&")[1])
        own = [w for w in words if w.endswith(".o")]
        kept = [w for w in words if w not in own]
        kept[kept.index("-o") + 1] = str(out)
        archives = [w for w in words if w.endswith(".a")]
        for archive in archives:
            if not (self.build / archive).exists() and not pathlib.Path(archive).exists():
                raise BadInput(f"{target}: {archive} has not been built")
        # before the archives, whose members are then not taken
        first = next((i for i, w in enumerate(kept) if w.endswith((".a", ".so")) or w.startswith("-l")), len(kept))
        return kept[:first] + [str(o) for o in objects] + kept[first:]


class Round:
    """Faults of one program that are compiled together, and run one by one."""

    def __init__(self, tree, directory, program, faults, everything):
        self.tree, self.directory, self.program = tree, directory, program
        self.faults, self.everything = faults, everything
        self.executable = directory / program["name"]
        self.control = {}

    def make(self, stop):
        shutil.rmtree(self.directory, ignore_errors=True)  # of another list
        self.directory.mkdir(parents=True)
        overlay(self.directory, self.everything)
        (self.directory / "choice.h").write_text(CHOICE)
        (self.directory / "choose.c").write_text(CHOOSE)
        self.call(["cc", "-c", "choose.c", "-o", "choose.o"], self.directory, stop)
        target = self.program["target"]
        objects = [self.directory / "choose.o"]
        for source in sources_of(self.program):
            file = plain(source)
            copied, folder = self.directory / file, pathlib.Path(file).parent
            if not copied.exists() and any(f.file.startswith(f"{folder}/") for f in self.everything):
                # so that its "neighbour.hpp", and what that includes, is the overlay's
                (self.directory / folder).mkdir(parents=True, exist_ok=True)
                copied.write_text((ROOT / file).read_text())
                for header in (ROOT / folder).glob("*.hpp"):
                    if not (self.directory / folder / header.name).exists():
                        (self.directory / folder / header.name).write_text(header.read_text())
            at = copied if copied.exists() else ROOT / file
            if file != source:
                made = self.tree.at(source).read_text().replace(str(ROOT / file), str(at))
                at = self.directory / (source.replace("/", "-").replace("@", "-") + ".cpp")
                at.write_text(made)
            line = self.tree.compile_line(target, source)
            to = self.directory / (source.replace("/", "-").replace("@", "-") + ".o")
            line[1:1] = [f"-I{self.directory / i}" for i in INCLUDES]
            line += [f"-iquote{ROOT / folder}", "-include", str(self.directory / "choice.h"), "-w",
                     *self.program.get("flags", []), "-c", str(at), "-o", str(to)]
            self.call(line, self.tree.build, stop)
            objects.append(to)
        self.call(self.tree.link_line(target, objects, self.executable), self.tree.build, stop)

    @staticmethod
    def call(line, folder, stop):
        if stop.is_set():
            raise KeyboardInterrupt
        done = subprocess.run(line, cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            first = next((x for x in done.stderr.splitlines() if "error" in x or "undefined" in x), done.stderr[:300])
            raise BadInput(f"cannot make {line[-1]}: {first}")

    def run(self, test, number, seconds):
        """(failed, seconds, how)"""
        start = time.monotonic()
        environment = dict(os.environ, GRAZE_FAULT=str(number), GRAZE_TEST_INPUTS=self.program.get("inputs", ""))
        if not environment["GRAZE_TEST_INPUTS"]:
            del environment["GRAZE_TEST_INPUTS"]
        process = subprocess.Popen([str(self.executable), test.replace(",", "\\,"), "--abort"],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=self.directory,
                                   env=environment, start_new_session=True)
        try:
            out, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return True, time.monotonic() - start, "hangs"
        took = time.monotonic() - start
        if b"graze: skipped," in out:
            return False, took, "skipped"
        if b"No test cases matched" in out:
            return False, took, "no such test"
        return process.returncode != 0, took, "fails" if process.returncode > 0 else "crashes"

    def decide(self, fault):
        """The fault's record."""
        if fault.test not in self.control:
            failed, took, outcome = False, 0, ""
            if not fault.alone:
                failed, took, outcome = self.run(fault.test, 0, 600)
            if failed or outcome in ("skipped", "no such test"):
                raise BadInput(f"the control of {self.program['name']}, {fault.test!r}: {outcome}")
            self.control[fault.test] = took
        limit = max(LEAST_SECONDS, 8 * self.control[fault.test])
        if fault.alone:
            limit = 120
        caught, took, outcome = self.run(fault.test, 0 if fault.alone else fault.number, limit)
        if fault.alone and outcome in ("skipped", "no such test"):
            raise BadInput(f"{self.program['name']}, {fault.test!r}: {outcome}")
        return {"caught": caught, "how": outcome if caught else "passes", "seconds": round(took, 2)}


class Report:
    """Lines as faults are decided: how many, how fast, how long still."""

    def __init__(self, total, unseen, as_json):
        self.total, self.unseen, self.as_json = total, unseen, as_json
        self.done = self.caught = self.equivalent = 0
        self.wrong, self.start, self.lock = [], time.monotonic(), threading.Lock()

    def add(self, fault, record, anew):
        with self.lock:
            self.done += 1
            if fault.equivalent:
                good = not record["caught"]
                self.equivalent += good
                word = "equivalent" if good else "CAUGHT, though listed as equivalent"
            else:
                good = record["caught"]
                self.caught += good
                word = f"caught ({record['how']})" if good else "SURVIVES"
            if not good:
                self.wrong.append(fault)
            elapsed = time.monotonic() - self.start
            if self.as_json:
                print(json.dumps({"file": fault.file, "right": fault.right, "faulty": fault.faulty,
                                  "program": fault.program["name"], "test": fault.test, **record,
                                  "equivalent": fault.equivalent, "before": not anew}), flush=True)
            else:
                left = elapsed / self.done * (self.total - self.done)
                print(f"[{self.done}/{self.total}, {60 * self.done / max(elapsed, 1e-3):.0f} a minute, "
                      f"{left:.0f} s left] {word}: {fault.words()}", flush=True)

    def end(self):
        if self.as_json:
            print(json.dumps({"faults": self.total, "decided": self.done, "caught": self.caught,
                              "equivalent": self.equivalent, "survivors": len(self.wrong), "unseen": self.unseen,
                              "seconds": round(time.monotonic() - self.start, 1)}))
        else:
            print(f"{self.done} of {self.total} faults: {self.caught} caught, {self.equivalent} equivalent, "
                  f"{len(self.wrong)} wrong, {time.monotonic() - self.start:.0f} s; {self.unseen} more are listed "
                  "that no test can see")
            for fault in self.wrong:
                print(f"  {fault.words()}\n    by {fault.program['name']}, {fault.test}")


def run_list(options):
    faults, unseen = read_list(options.list)
    if options.only:
        wanted = re.compile(options.only, re.M)
        faults = [f for f in faults if wanted.search("\n".join((f.program["name"], f.file, f.right, f.faulty, f.test)))]
    if options.quick:
        faults = [f for f in faults if f.quick]
    if not faults:
        raise BadInput("no fault is asked for")
    if options.check:
        print(f"{len(faults)} faults, and {unseen} that no test can see: each text once")
        return 0
    tree = Tree(options.build)
    out = pathlib.Path(options.out) if options.out else tree.build / "faults"
    out.mkdir(parents=True, exist_ok=True)
    results, known = out / "results.jsonl", {}
    if results.exists() and not options.fresh:
        for line in results.read_text().splitlines():
            try:
                record = json.loads(line)
                known[record.pop("key")] = record
            except (json.JSONDecodeError, KeyError):
                pass  # cut off
    report = Report(len(faults), unseen, options.json)
    left = []
    for fault in faults:
        if (record := known.get(fault.key())) is not None:
            report.add(fault, record, False)
        else:
            left.append(fault)
    by_program = {}
    for fault in left:
        by_program.setdefault(fault.program["name"], []).append(fault)
    all_rounds = []
    for name, program_faults in by_program.items():
        for i, batch in enumerate(rounds(program_faults)):
            all_rounds.append(Round(tree, out / f"{name}-{i}", program_faults[0].program, batch, batch))
    stop, writing = threading.Event(), threading.Lock()

    def one_round(r):
        r.make(stop)
        for fault in r.faults:
            if stop.is_set():
                return
            record = r.decide(fault)
            with writing, open(results, "a", encoding="utf-8") as file:
                file.write(json.dumps({"key": fault.key(), **record}) + "\n")
            report.add(fault, record, True)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        futures = [pool.submit(one_round, r) for r in all_rounds]
        try:
            for future in concurrent.futures.as_completed(futures):
                future.result()
        except BaseException:
            stop.set()
            for future in futures:
                future.cancel()
            raise
    report.end()
    return 1 if report.wrong else 0


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise BadInput(message)


def main():
    try:
        parser = Parser(add_help=False, allow_abbrev=False)
        for name in ("--build", "--only", "--out"):
            parser.add_argument(name)
        parser.add_argument("--list", default=str(HERE / "faults.toml"))
        parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
        for name in ("--quick", "--fresh", "--json", "--check", "--help"):
            parser.add_argument(name, action="store_true")
        options = parser.parse_args()
        if options.help:
            print(__doc__.strip())
            return 0
        if not options.build and not options.check:
            raise BadInput("--build is needed")
        if options.jobs < 1:
            raise BadInput("--jobs is less than 1")
        return run_list(options)
    except BadInput as error:
        print(f"run_faults.py: {' '.join(str(error).split())}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("run_faults.py: interrupted; the next run goes on", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
