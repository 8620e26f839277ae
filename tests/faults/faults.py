#!/usr/bin/env python3
"""What each program does on a bad day: a matrix of programs and faults.

    faults.py BIN [--farm FILE] [--slice N] [--only REGEX] [--seed S] [--json] [--list]

A cell runs one program with one fault and looks at its exit code and its lines on standard error: one line
where it fails, exit code 2 (1 where a picture or an octree could not be written, 130 where it was
interrupted), never a finding's code, never an abort, and in time. --slice N runs every N-th cell. All is
within one temporary folder; the full disk is a tmpfs there, in a mount namespace of this test's own. A cell
that cannot be tried here is said to be skipped, with the reason. Exit codes: 0 all is well, 1 a cell is
wrong, 2 bad input."""
import argparse
import json
import os
import random
import re
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

NOBODY = 65534
SECONDS = 60  # a cell that takes longer hangs; a busy machine is slow
NO_ECHO = "whether it reads doubles exactly was not checked"
ADAPTER = """while read l; do echo '{"skip":true}'; done"""
PROGRESS = re.compile(r"\d (\w )?\w+/s( |$)|\d s left|\d ranges$|^shrinking")
SIGNS_OF_AN_ABORT = re.compile(r"terminate called|Traceback|Sanitizer|core dumped|assert", re.I)


class Skip(Exception):
    pass


class Outcome:
    def __init__(self, code, out, err, seconds):
        self.code, self.out, self.err, self.seconds = code, out, err, seconds

    @property
    def lines(self):
        """Complaints; lines of progress and what is erased with them are none, nor is the word that ADAPTER
        gave no echo back."""
        text = self.err.decode(errors="replace")
        return [line for line in text.splitlines()
                if line.strip() and not PROGRESS.search(line) and NO_ECHO not in line]


class Cell:
    def __init__(self, name, run, codes=(2,), lines=(1,), check=None):
        self.name, self.run, self.codes, self.lines, self.check = name, run, codes, lines, check

    def wrong(self):
        """What is wrong, or nothing."""
        o = self.run()
        said = o.err.decode(errors="replace")[:300]
        if o.code not in self.codes:
            return f"exit code {o.code}, not {' or '.join(map(str, self.codes))}: {said!r}"
        if len(o.lines) not in self.lines:
            return f"{len(o.lines)} lines on standard error: {said!r}"
        if any(len(line) > 1100 or any(ord(c) < 32 for c in line) for line in o.lines):
            return f"a line that is long or holds control characters: {said!r}"
        if SIGNS_OF_AN_ABORT.search(said):
            return f"not a refusal: {said!r}"
        return self.check(o) if self.check else None


class Matrix:
    def __init__(self, programs, farm, folder, disk, seed):
        self.programs, self.farm, self.folder, self.disk = programs, farm, Path(folder), disk
        self.random = random.Random(seed)
        self.cells, self.made = [], 0
        self.prepare()

    # ---- running
    def scratch(self):
        self.made += 1
        path = self.folder / f"cell-{self.made}"
        path.mkdir()
        path.chmod(0o777)
        return path

    def run(self, argv, stdout=None, close=(), limits=(), nobody=False, env=None, stdin=b""):
        def prepare():
            for fd in close:
                os.close(fd)
            if nobody:
                os.setgroups([])
                os.setgid(NOBODY)
                os.setuid(NOBODY)
            for what, value in limits:
                resource.setrlimit(what, (value, value))
        if nobody and os.getuid() != 0:
            raise Skip("needs root to run as another user")
        start = time.monotonic()
        try:
            p = subprocess.Popen(argv, stdin=subprocess.PIPE, stdout=stdout or subprocess.PIPE, cwd=self.folder,
                                 stderr=subprocess.PIPE, preexec_fn=prepare, env=env, start_new_session=True)
        except OSError as error:
            raise Skip(f"cannot be started here: {error}") from None
        except subprocess.SubprocessError as error:
            raise Skip(f"cannot be prepared here: {error}") from None
        try:
            out, err = p.communicate(stdin, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(p.pid, signal.SIGKILL)
            out, err = p.communicate()
            return Outcome("hangs", out or b"", err, SECONDS)
        return Outcome(p.returncode, out or b"", err, time.monotonic() - start)

    def add(self, name, run, **more):
        self.cells.append(Cell(name, run, **more))

    # ---- what the cells use
    def prepare(self):
        p, f = self.programs, self.folder
        f.chmod(0o777)
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": f}
        subprocess.run([p["graze-fuzz"], "run", "--rays", "2000", "--traversal", "published", "--no-shrink",
                        "--save", "miss.jsonl"], **quiet)
        subprocess.run([p["graze-fuzz"], "run", "--rays", "500", "--traversal", "published", "--no-shrink",
                        "--write-baseline", "known.json"], **quiet)
        subprocess.run([p["graze-fuzz"], "campaign", "campaign", "--rays", "4000", "--piece", "1000", "--traversal",
                        "published", "--seed", "3"], **quiet)
        for picture in ("a.png", "a.exr"):
            subprocess.run([p["graze-render"], "--scene", "spheres", "--size", "8", "-o", picture], **quiet)
        subprocess.run([p["graze-voxelize"], "--scene", "spheres", "--level", "3", "-o", "a.octree"], **quiet)
        (f / "a.itl").write_text("testcase a { add [1,2] [3,4] = [4,6]; }\n")
        (f / "scene.json").write_text('{"formula":"x^2+y^2+z^2-1","domain":[-2,2]}')

    def commands(self):
        """name: arguments, exit code where all is well."""
        p = self.programs
        fuzz, render, voxelize = p["graze-fuzz"], p["graze-render"], p["graze-voxelize"]
        itl, exhaustive = p["graze-itf1788"], p["graze-exhaustive"]
        out = lambda ending: str(self.scratch() / ("out" + ending))
        all_of = {
            "fuzz run": lambda: [fuzz, "run", "--rays", "500"],
            "fuzz run --json": lambda: [fuzz, "run", "--rays", "500", "--json"],
            "fuzz run, a climb": lambda: [fuzz, "run", "--rays", "500", "--search", "climb"],
            "fuzz run, a finding": lambda: [fuzz, "run", "--rays", "500", "--traversal", "published", "--no-shrink"],
            "fuzz run, a finding, --json": lambda: [fuzz, "run", "--rays", "500", "--traversal", "published", "--json",
                                                    "--no-shrink"],
            "fuzz run --baseline": lambda: [fuzz, "run", "--rays", "500", "--traversal", "published", "--no-shrink",
                                            "--baseline", "known.json"],
            "fuzz run --github": lambda: [fuzz, "run", "--rays", "500", "--traversal", "published", "--no-shrink",
                                          "--github"],
            "fuzz run --command": lambda: [fuzz, "run", "--rays", "50", "--command", ADAPTER],
            "fuzz replay": lambda: [fuzz, "replay", "miss.jsonl"],
            "fuzz replay --json": lambda: [fuzz, "replay", "miss.jsonl", "--json"],
            "fuzz list": lambda: [fuzz, "list"],
            "fuzz self": lambda: [fuzz, "self", "functions", "--trials", "50", "--threads", "1"],
            "fuzz self --json": lambda: [fuzz, "self", "functions", "--trials", "50", "--threads", "1", "--json"],
            "fuzz self --list": lambda: [fuzz, "self", "--list"],
            "fuzz campaign": lambda: [fuzz, "campaign", out(""), "--rays", "2000", "--piece", "1000"],
            "fuzz campaign --json": lambda: [fuzz, "campaign", out(""), "--rays", "2000", "--piece", "1000", "--json"],
            "fuzz summary": lambda: [fuzz, "summary", "campaign"],
            "fuzz summary --json": lambda: [fuzz, "summary", "campaign", "--json"],
            "fuzz --help": lambda: [fuzz, "--help"],
            "fuzz --version": lambda: [fuzz, "--version"],
            "render png": lambda: [render, "--scene", "spheres", "--size", "16", "-o", out(".png")],
            "render exr --json": lambda: [render, "--scene", "spheres", "--size", "16", "--json", "-o", out(".exr")],
            "render descent": lambda: [render, "--scene", "spheres", "--size", "16", "--levels", "9",
                                       "--octree-level", "4", "-o", out(".png")],
            "render a formula": lambda: [render, "--formula", "x^2+y^2-1", "--size", "16", "-o", out(".png")],
            "render a scene file": lambda: [render, "--scene", "scene.json", "--size", "16", "-o", out(".png")],
            "render --again": lambda: [render, "--again", "a.exr", "-o", out(".exr")],
            "render --help": lambda: [render, "--help"],
            "render --version": lambda: [render, "--version"],
            "voxelize": lambda: [voxelize, "--scene", "spheres", "--level", "3", "-o", out("")],
            "voxelize --json": lambda: [voxelize, "--scene", "spheres", "--level", "3", "--json", "-o", out("")],
            "voxelize --info": lambda: [voxelize, "--info", "a.octree"],
            "voxelize --info --json": lambda: [voxelize, "--info", "a.octree", "--json"],
            "voxelize --version": lambda: [voxelize, "--version"],
            "itf1788": lambda: [itl, "a.itl"],
            "itf1788 --json": lambda: [itl, "--json", "a.itl"],
            "itf1788 --verbose": lambda: [itl, "--verbose", "a.itl"],
            "itf1788 --version": lambda: [itl, "--version"],
            "exhaustive": lambda: [exhaustive, "--directions", "1"],
            "exhaustive --version": lambda: [exhaustive, "--version"],
        }
        if self.farm:
            all_of["farm --help"] = lambda: ["/usr/bin/python3", self.farm, "--help"]
        # one direction shows no miss of the baselines: that is its finding
        found = {"fuzz run, a finding", "fuzz run --github", "fuzz run, a finding, --json", "fuzz summary", "fuzz summary --json",
                 "exhaustive"}
        return {name: (argv, 1 if name in found else 0) for name, argv in all_of.items()}

    # ---- the faults
    def build(self):
        self.standard_output()
        self.bad_input_files()
        self.bad_output_files()
        self.limits()
        self.signals()
        self.arguments()
        self.folders()
        return self.cells

    def standard_output(self):
        def full(argv):
            if not self.disk:
                raise Skip("no mount namespaces here")
            with open(self.disk / "stdout", "wb", buffering=0) as out:
                try:
                    while out.write(bytes(4096)):
                        pass
                except OSError:
                    pass
                result = self.run(argv, stdout=out)
            os.remove(self.disk / "stdout")
            return result

        def nobody_reads(argv):
            read, write = os.pipe()
            os.close(read)
            try:
                return self.run(argv, stdout=write)
            finally:
                os.close(write)

        def limited(argv):
            # the limit is on all files: of a command that writes one too, its own complaint comes first
            with tempfile.TemporaryFile(dir=self.folder) as out:
                return self.run(argv, stdout=out, limits=[(resource.RLIMIT_FSIZE, 0)])

        writes_file = re.compile(r"render (png|exr|descent|a |--again)|voxelize( --json)?$|campaign|summary")
        for name, (argv, well) in self.commands().items():
            self.add(f"{name}: standard output on a full disk", lambda a=argv: full(a()))
            self.add(f"{name}: standard output closed", lambda a=argv: self.run(a(), close=[1]))
            self.add(f"{name}: standard output without a reader", lambda a=argv: nobody_reads(a()))
            self.add(f"{name}: file size limited to 0", lambda a=argv: limited(a()),
                     codes=(1, 2) if re.match("render|voxelize", name) and writes_file.match(name) else (2,))
            self.add(f"{name}: standard error closed", lambda a=argv: self.run(a(), close=[2]), codes=(well,),
                     lines=(0,))
            self.add(f"{name}: standard input closed", lambda a=argv: self.run(a(), close=[0]), codes=(well,),
                     lines=(0,))
        for program in self.programs:
            self.add(f"{program} --nonsense: standard error closed",
                     lambda p=program: self.run([self.programs[p], "--nonsense"], close=[2]), lines=(0,))

    def bad_file(self, kind, ending):
        """A path that is no good to be read, and whether it must be asked for as another user."""
        folder = self.scratch()
        path = folder / ("bad" + ending)
        if kind == "folder":
            path.mkdir()
        elif kind == "FIFO":
            os.mkfifo(path)
        elif kind == "socket":
            with socket.socket(socket.AF_UNIX) as s:
                here = os.getcwd()
                os.chdir(folder)  # a socket's path is short
                s.bind(path.name)
                os.chdir(here)
        elif kind == "loop of links":
            path.symlink_to(path.name)
        elif kind == "link to nothing":
            path.symlink_to("nothing")
        elif kind == "no permission":
            path.write_text("x")
            path.chmod(0)
        elif kind == "empty":
            path.write_text("")
        elif kind == "random bytes":
            path.write_bytes(random.Random(kind).randbytes(5000))
        elif kind == "text":
            path.write_text("this is not it\n" * 100)
        elif kind == "long line":
            path.write_text("[" * 3_000_000)
        elif kind == "sparse and huge":
            with open(path, "wb") as file:
                file.truncate(1 << 40)
        elif kind == "long name":
            path = folder / ("n" * 300 + ending)
        return path

    READ_KINDS = ["missing", "folder", "FIFO", "socket", "loop of links", "link to nothing", "no permission", "empty",
                  "random bytes", "text", "long line", "sparse and huge", "long name"]
    WRITE_KINDS = ["folder", "FIFO", "socket", "loop of links", "link to nothing", "no permission", "long name",
                   "missing folder", "folder without permission", "full disk"]

    def bad_input_files(self):
        p = self.programs
        picture = lambda: str(self.scratch() / "out.png")
        readers = {
            "fuzz replay FILE": (".jsonl", lambda f: [p["graze-fuzz"], "replay", f]),
            "fuzz run --baseline FILE": (".json", lambda f: [p["graze-fuzz"], "run", "--rays", "500", "--baseline", f]),
            "fuzz replay --baseline FILE": (".json", lambda f: [p["graze-fuzz"], "replay", "miss.jsonl", "--baseline", f]),
            "fuzz replay FOLDER/FILE": (".jsonl", lambda f: [p["graze-fuzz"], "replay", os.path.dirname(f)]),
            "render --scene FILE": (".json", lambda f: [p["graze-render"], "--scene", f, "-o", picture()]),
            "render --again FILE": (".exr", lambda f: [p["graze-render"], "--again", f, "-o", picture()]),
            "voxelize --info FILE": ("", lambda f: [p["graze-voxelize"], "--info", f]),
            "voxelize --scene FILE": (".json", lambda f: [p["graze-voxelize"], "--scene", f, "-o",
                                                         str(self.scratch() / "out.octree")]),
            "itf1788 FILE": (".itl", lambda f: [p["graze-itf1788"], f]),
        }
        for name, (ending, argv) in readers.items():
            for kind in self.READ_KINDS:
                def run(argv=argv, ending=ending, kind=kind):
                    return self.run(argv(str(self.bad_file(kind, ending))), nobody=kind == "no permission",
                                    limits=[(resource.RLIMIT_AS, 4 << 30)])
                self.add(f"{name}: {kind}", run)
        # what a campaign's folder holds
        for file in ("plan.json", "progress.jsonl", "lock", "findings"):
            for kind in self.READ_KINDS:
                if (file, kind) in {("lock", k) for k in ("missing", "empty", "random bytes", "text", "long line",
                                                         "sparse and huge", "link to nothing")} or \
                   (file, kind) in {("progress.jsonl", "missing"), ("progress.jsonl", "empty"), ("findings", "folder"),
                                    ("findings", "missing"), ("progress.jsonl", "link to nothing")} or \
                   kind == "long name" or (file == "plan.json" and kind == "missing"):
                    continue

                def run(file=file, kind=kind):
                    folder = self.scratch() / "c"
                    shutil.copytree(self.folder / "campaign", folder)
                    target = folder / file
                    bad = self.bad_file(kind, "")
                    if target.is_dir():
                        shutil.rmtree(target)
                    elif target.exists():
                        target.unlink()
                    if kind == "loop of links":
                        target.symlink_to(target.name)
                    else:
                        os.rename(bad, target)
                    if kind == "no permission":
                        for path in (folder, *folder.iterdir()):
                            os.chown(path, NOBODY, NOBODY)
                    return self.run([p["graze-fuzz"], "campaign", str(folder)], nobody=kind == "no permission")
                # a last line without an end was cut off: it is left out, and its piece is done again
                cut_off = file == "progress.jsonl" and kind in ("random bytes",)
                self.add(f"fuzz campaign, {file}: {kind}", run, codes=(1, 2) if cut_off else (2,),
                         lines=(0, 1) if cut_off else (1,))

    def bad_output_files(self):
        p = self.programs
        writers = {
            "fuzz run --save FILE": (".jsonl", 2, lambda f: [p["graze-fuzz"], "run", "--rays", "500", "--traversal",
                                                            "published", "--no-shrink", "--save", f]),
            "fuzz run --reproducer FOLDER": ("", 2, lambda f: [p["graze-fuzz"], "run", "--rays", "500", "--no-shrink",
                                                              "--traversal", "published", "--reproducer", f]),
            "fuzz run --save-all FOLDER": ("", 2, lambda f: [p["graze-fuzz"], "run", "--rays", "500", "--no-shrink",
                                                            "--traversal", "published", "--save-all", f]),
            **{f"fuzz {command[0]} {option} FILE": (".json", 2, lambda f, c=command, o=option: [p["graze-fuzz"], *c, o, f])
               for option in ("--write-baseline", "--junit", "--sarif")
               for command in (["run", "--rays", "500", "--no-shrink", "--traversal", "published"],
                               ["replay", "miss.jsonl", "--traversal", "published"], ["summary", "campaign"])},
            "fuzz summary --html FILE": (".html", 2, lambda f: [p["graze-fuzz"], "summary", "campaign", "--html", f]),
            "fuzz campaign FOLDER": ("", 2, lambda f: [p["graze-fuzz"], "campaign", f, "--rays", "1000"]),
            "render -o FILE.png": (".png", 1, lambda f: [p["graze-render"], "--scene", "spheres", "--size", "200",
                                                        "-o", f]),
            "render -o FILE.exr": (".exr", 1, lambda f: [p["graze-render"], "--scene", "spheres", "--size", "100",
                                                        "-o", f]),
            "render -o FILE.npz": (".npz", 1, lambda f: [p["graze-render"], "--scene", "spheres", "--size", "100",
                                                        "-o", f]),
            "voxelize -o FILE": ("", 1, lambda f: [p["graze-voxelize"], "--scene", "spheres", "--level", "6", "-o", f]),
        }
        for name, (ending, late, argv) in writers.items():
            folder_wanted = "FOLDER" in name
            for kind in self.WRITE_KINDS:
                if folder_wanted and kind == "folder":
                    continue
                state = {}

                def run(argv=argv, ending=ending, kind=kind, state=state):
                    if kind == "missing folder":
                        path = self.scratch() / "none" / "none" / ("out" + ending)
                        if argv("x")[1] == "run" and {"--reproducer", "--save-all"} & set(argv("x")):
                            (path.parent.parent).write_text("no folder")
                    elif kind == "folder without permission":
                        folder = self.scratch()
                        path = folder / ("out" + ending)
                        folder.chmod(0o555)
                    elif kind == "full disk":
                        if not self.disk:
                            raise Skip("no mount namespaces here")
                        path = self.disk / ("out" + ending)
                        with open(self.disk / "filler", "wb", buffering=0) as out:
                            try:
                                while out.write(bytes(4096)):
                                    pass
                            except OSError:
                                pass
                    else:
                        path = self.bad_file(kind, ending)
                    state["path"] = path
                    state["was"] = os.lstat(path).st_mode if os.path.lexists(path) else None
                    try:
                        return self.run(argv(str(path)), nobody="permission" in kind)
                    finally:
                        if kind == "full disk":
                            shutil.rmtree(self.disk / ("out" + ending), ignore_errors=True)
                            for left in self.disk.iterdir():
                                left.unlink()

                def unchanged(o, state=state, kind=kind):
                    path, was = state["path"], state["was"]
                    is_now = os.lstat(path).st_mode if os.path.lexists(path) else None
                    if kind != "full disk" and is_now != was:
                        return f"{path} was {was and oct(was)} and is {is_now and oct(is_now)}"
                    return None
                self.add(f"{name}: {kind}", run, codes=(late,) if kind == "full disk" else (2,), check=unchanged)
        # an older file keeps its permissions, and a link its target
        def through_link():
            folder = self.scratch()
            (folder / "target.png").write_bytes(b"older")
            (folder / "target.png").chmod(0o640)
            (folder / "link.png").symlink_to("target.png")
            return self.run([p["graze-render"], "--scene", "spheres", "--size", "8", "-o", str(folder / "link.png")])

        def link_kept(_):
            folder = self.folder / f"cell-{self.made}"
            good = (folder / "link.png").is_symlink() and (folder / "target.png").read_bytes() != b"older" and \
                (folder / "target.png").stat().st_mode & 0o777 == 0o640 and len(list(folder.iterdir())) == 2
            return None if good else "the link or its target's permissions are not kept"
        self.add("render -o LINK: written through", through_link, codes=(0,), lines=(0,), check=link_kept)

    def limits(self):
        commands = self.commands()
        for name in ("fuzz run", "fuzz run --command", "fuzz replay", "fuzz self", "fuzz campaign", "fuzz summary",
                     "render png", "render exr --json", "render descent", "render --again", "voxelize",
                     "voxelize --info", "itf1788", "exhaustive"):
            argv, well = commands[name]
            for files in (4, 5, 6, 7, 9):
                def run(a=argv, n=files):
                    return self.run(a(), limits=[(resource.RLIMIT_NOFILE, n)])
                self.add(f"{name}: {files} descriptors", run,
                         codes=(well, 1 if name.startswith(("render", "voxelize")) else 2, 2), lines=(0, 1, 2),
                         check=self.word_of_the_program)
            libraries = "exr" in name  # OpenImageIO's, which start threads and take memory when they are loaded
            for megabytes in (40, 80, 120, 200, 400, *((550, 640, 700, 800) if libraries else ())):
                def run(a=argv, m=megabytes):
                    argv = a()
                    threads = ["--threads", "64"] if argv[1] in ("run", "campaign", "--scene") else []
                    return self.run(argv + threads, limits=[(resource.RLIMIT_AS, m << 20)])
                self.add(f"{name}: {megabytes} MB of memory", run, codes=(well, 2), lines=(0, 1, 2),
                         check=self.word_of_the_program)
            for processes in (1, 3, *((2, 4, 5, 6, 7, 8) if libraries else ())):
                def run(a=argv, n=processes):
                    argv = a()
                    threads = ["--threads", "8"] if argv[1] in ("run", "campaign", "--scene") else []
                    return self.run(argv + threads, nobody=True, limits=[(resource.RLIMIT_NPROC, n)])
                self.add(f"{name}: {processes} processes", run, codes=(well, 2), lines=(0, 1, 2),
                         check=self.word_of_the_program)

    @staticmethod
    def word_of_the_program(o):
        if o.code == 2 and not any(line.startswith("graze-") for line in o.lines):
            return f"exit code 2 without a word of the program: {o.err[:200]!r}"
        return None

    def signals(self):
        p = self.programs
        powers = " + ".join(f"x^{i % 23 + 2}*y^{i % 19 + 1}*z^{i % 29 + 3}" for i in range(3000))
        works = {
            "fuzz run": ([p["graze-fuzz"], "run", "--seconds", "50", "--progress"], (0,)),
            "fuzz run --command": ([p["graze-fuzz"], "run", "--seconds", "50", "--progress", "--command", ADAPTER],
                                   (0,)),
            "fuzz campaign": ([p["graze-fuzz"], "campaign", None, "--piece", "100", "--progress"], (0,)),
            "fuzz self": ([p["graze-fuzz"], "self", "voxelizer", "--seconds", "50", "--progress"], (0,)),
            "render": ([p["graze-render"], "--scene", "asterisk(9,18)", "--size", "4000", "--spp", "16", "--progress",
                        "-o", None], ()),
            "render, an octree": ([p["graze-render"], "--scene", "asterisk(9,18)", "--octree-level", "12", "--size",
                                   "16", "-o", None], ()),
            "render, thousands of powers": ([p["graze-render"], "--formula", powers, "--size", "64", "--progress", "-o",
                                             None], ()),
            "voxelize": ([p["graze-voxelize"], "--scene", "tanglecube", "--level", "13", "--progress", "-o", None], ()),
            "exhaustive": ([p["graze-exhaustive"], "--bits", "4"], ()),
        }
        for name, (argv, orderly) in works.items():
            for s in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                for twice in (False, True):
                    def run(argv=argv, s=s, twice=twice, wait=self.random.random()):
                        return self.interrupted(argv, s, twice, wait)
                    self.add(f"{name}: {s.name}{' twice' if twice else ''} at a random time", run,
                             codes=(130, *orderly), lines=(0, 1), check=self.in_time)

    def interrupted(self, argv, s, twice, wait):
        folder = self.scratch()
        argv = [a if a is not None else str(folder / "out.png") for a in argv]
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            p = subprocess.Popen(argv, stdout=out, stderr=err, stdin=subprocess.DEVNULL, cwd=self.folder,
                                 start_new_session=True)
            # until it listens: that SIGINT is caught
            until = time.monotonic() + SECONDS
            while p.poll() is None and time.monotonic() < until:
                status = Path(f"/proc/{p.pid}/status").read_text()
                caught = int(re.search(r"SigCgt:\s*(\w+)", status)[1], 16)
                if caught >> (signal.SIGTERM - 1) & 1:
                    break
                time.sleep(0.005)
            time.sleep(wait)
            start = time.monotonic()
            p.send_signal(s)
            if twice:
                time.sleep(0.05)
                p.send_signal(s)
            try:
                p.wait(timeout=SECONDS)
            except subprocess.TimeoutExpired:
                p.kill()
                p.wait()
                return Outcome("hangs", b"", b"", SECONDS)
            seconds = time.monotonic() - start
            out.seek(0), err.seek(0)
            o = Outcome(p.returncode, out.read(), err.read(), seconds)
        left = [f.name for f in folder.iterdir() if f.name.startswith(".graze-part")]
        if left:
            o.err += b"\nleft behind: " + str(left).encode() + b"\nleft behind\n"
        return o

    @staticmethod
    def in_time(o):
        busy = os.getloadavg()[0] > 1.5 * (os.cpu_count() or 1)
        return f"took {o.seconds:.1f} s to end" if o.seconds > (10 if busy else 1.2) else None

    def arguments(self):
        p = self.programs
        refused = {
            "fuzz run: control characters are not echoed": ["graze-fuzz", "run", "--traversal", "a\x1b[31m\nb\x07"],
            "fuzz run: a long word is cut": ["graze-fuzz", "run", "--traversal", "x" * 100_000],
            "fuzz run: bytes that are no UTF-8": ["graze-fuzz", "run", "--generator", b"\xff\xfe"],
            "fuzz run --rays -1": ["graze-fuzz", "run", "--rays", "-1"],
            "fuzz run --rays 2^64": ["graze-fuzz", "run", "--rays", str(2**64)],
            "fuzz run --threads 2^32 + 1": ["graze-fuzz", "run", "--threads", str(2**32 + 1)],
            "fuzz run --seed 1e3": ["graze-fuzz", "run", "--seed", "1e3"],
            "fuzz campaign, a command that is no UTF-8": ["graze-fuzz", "campaign", "x-none", "--command",
                                                         b"echo \xff"],
            "exhaustive --directions -1": ["graze-exhaustive", "--directions", "-1"],
            "exhaustive --directions 2^64": ["graze-exhaustive", "--directions", str(2**64)],
            "exhaustive --bits 5": ["graze-exhaustive", "--bits", "5"],
            "render --levels 2^32 + 1": ["graze-render", "--scene", "spheres", "--levels", str(2**32 + 1), "-o",
                                         "x.png"],
            "render --domain without --formula": ["graze-render", "--scene", "spheres", "--domain=-1,1", "-o", "x.png"],
            "render --again with --size": ["graze-render", "--again", "a.exr", "--size", "8", "-o", "x.png"],
            "voxelize --info with --scene": ["graze-voxelize", "--info", "a.octree", "--scene", "spheres"],
            "voxelize --domain without --formula": ["graze-voxelize", "--scene", "spheres", "--domain=-1,1", "-o", "x"],
            "voxelize --info with --formula": ["graze-voxelize", "--info", "a.octree", "--formula", "x"],
            "voxelize --info with --out": ["graze-voxelize", "--info", "a.octree", "--out", "x"],
            "itf1788: nested lists": None,
            "itf1788 without arguments": ["graze-itf1788"],
        }
        for name, argv in refused.items():
            if argv is None:
                deep = self.folder / "deep.itl"
                deep.write_text("testcase a { sum_nearest " + "{" * 1_000_000)
                argv = ["graze-itf1788", str(deep)]
            self.add(name, lambda a=argv: self.run([p[a[0]], *a[1:]]))

        def is_json(o):
            try:
                for line in (o.out.decode() if o.out.count(b"\n") < 5 else o.out.decode()).split("\n}\n"):
                    if line.strip():
                        json.loads(line if line.rstrip().endswith("}") else line + "}")
            except ValueError as error:
                return f"not JSON in UTF-8: {error}"
            return None
        odd = b"odd \xff\xfe"
        self.add("fuzz run --json, a command that is no UTF-8",
                 lambda: self.run([p["graze-fuzz"], "run", "--rays", "10", "--json", "--command",
                                   ADAPTER.encode() + b" # \xff"]), codes=(0,), lines=(0,), check=is_json)
        self.add("render --json, a file name that is no UTF-8",
                 lambda: self.run([p["graze-render"], "--scene", "spheres", "--size", "8", "--json", "-o",
                                   os.fsencode(self.scratch()) + b"/" + odd + b".png"]), codes=(0,), lines=(0,),
                 check=is_json)
        self.add("voxelize --json, a file name that is no UTF-8",
                 lambda: self.run([p["graze-voxelize"], "--scene", "spheres", "--level", "3", "--json", "-o",
                                   os.fsencode(self.scratch()) + b"/" + odd]), codes=(0,), lines=(0,), check=is_json)
        self.add("fuzz campaign --json, a folder that is no UTF-8",
                 lambda: self.run([p["graze-fuzz"], "campaign", os.fsencode(self.scratch()) + b"/" + odd, "--rays",
                                   "1000"]), codes=(0,), lines=(0,))

    def folders(self):
        p = self.programs

        def changed(change):
            folder = self.scratch() / "c"
            shutil.copytree(self.folder / "campaign", folder)
            change(folder)
            return folder

        def with_hash(text):
            def change(folder):
                lines = [json.loads(line) for line in (folder / "progress.jsonl").read_text().splitlines()]
                next(line for line in lines if line["findings"])["findings"][0]["hash"] = text
                (folder / "progress.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
            return change
        for text in ("../../../x", "<script>alert(1)</script>", "", "A" * 32, "0" * 31, "0" * 33):
            for command in ("summary", "campaign"):
                self.add(f"fuzz {command}: a finding's hash is {text!r}",
                         lambda c=command, t=text: self.run([p["graze-fuzz"], c, str(changed(with_hash(t)))]))
        self.add("fuzz summary: findings were deleted",
                 lambda: self.run([p["graze-fuzz"], "summary",
                                   str(changed(lambda f: [x.unlink() for x in (f / "findings").iterdir()]))]),
                 codes=(1,), check=lambda o: None if "lost" in o.lines[0] else "nothing is said of the loss")
        self.add("fuzz campaign: findings were deleted",
                 lambda: self.run([p["graze-fuzz"], "campaign",
                                   str(changed(lambda f: [x.unlink() for x in (f / "findings").iterdir()]))]),
                 codes=(1,), check=lambda o: None if "lost" in o.lines[0] else "nothing is said of the loss")

        keys = ",".join(f'"k{i}":{i}' for i in range(100_000))

        def quick(o):
            return f"took {o.seconds:.1f} s" if o.seconds > 10 else None

        def scene_of_keys():
            path = self.scratch() / "keys.json"
            path.write_text("{" + keys + "}")
            return self.run([p["graze-render"], "--scene", str(path), "-o", str(path) + ".png"])
        self.add("render --scene: 100,000 keys", scene_of_keys, check=quick)

        def plan_of_keys():
            def change(folder):
                (folder / "plan.json").write_text("{" + keys[:1_000_000].rsplit(",", 1)[0] + "}")
            return self.run([p["graze-fuzz"], "campaign", str(changed(change))])
        self.add("fuzz campaign, plan.json: 100,000 keys", plan_of_keys, check=quick)

        def progress_of_keys():
            def change(folder):
                with open(folder / "progress.jsonl", "a", encoding="ascii") as file:
                    file.write("{" + keys[:1_000_000].rsplit(",", 1)[0] + "}\n")
            return self.run([p["graze-fuzz"], "campaign", str(changed(change))])
        self.add("fuzz campaign, progress.jsonl: 100,000 keys", progress_of_keys, check=quick)
        self.add("fuzz replay -: 100,000 keys",
                 lambda: self.run([p["graze-fuzz"], "replay", "-"], stdin=("{" + keys + "}\n").encode()), check=quick)

        def answers(line, twice):
            return f"while read l; do echo '{line}'; {'echo ' + repr(line) + ';' if twice else ''} done"
        for name, line in (("skip", '{"skip":true}'), ("a list", "[]")):
            self.add(f"fuzz run: an adapter that answers twice by {name}",
                     # several exchanges: a line too many behind the last one may come too late to be seen
                     lambda li=line: self.run([p["graze-fuzz"], "run", "--rays", "2000", "--threads", "1", "--no-shrink",
                                               "--command", answers(li, True)]),
                     codes=(1, 2), lines=(0, 1),
                     check=lambda o: None if b"malformed" in o.out or b"no answer" in o.err else "is not malformed")

        def nothing_is_left():
            folder = self.scratch()
            child = f"sleep 1000 & echo $! >> {folder}/pids; {ADAPTER}"
            process = subprocess.Popen([p["graze-fuzz"], "run", "--seconds", "50", "--threads", "2", "--command", child],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=self.folder)
            until = time.monotonic() + SECONDS
            while time.monotonic() < until and not (folder / "pids").exists():
                time.sleep(0.05)
            time.sleep(0.5)
            process.kill()
            process.wait()
            pids = [int(n) for n in (folder / "pids").read_text().split()]
            until = time.monotonic() + 10

            def alive(pid):
                try:
                    return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
                except OSError:
                    return False
            while time.monotonic() < until and any(map(alive, pids)):
                time.sleep(0.05)
            left = [pid for pid in pids if alive(pid)]
            for pid in left:
                os.kill(pid, signal.SIGKILL)
            return Outcome(len(left), b"", b"", 0)
        self.add("fuzz run: killed, and no child of an adapter is left", nothing_is_left, codes=(0,), lines=(0,))


def mounted(folder):
    """A small file system of this test's own, or nothing."""
    disk = Path(folder) / "disk"
    disk.mkdir()
    if os.environ.get("GRAZE_FAULTS_NAMESPACE") and \
            subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", disk],
                           stderr=subprocess.DEVNULL).returncode == 0:
        disk.chmod(0o777)
        return disk
    return None


def in_namespace():
    """Runs this script again in a mount namespace, if there is one to be had."""
    if os.environ.get("GRAZE_FAULTS_NAMESPACE"):
        return
    for own in (["unshare", "--mount"], ["unshare", "--mount", "--map-root-user"],
                ["unshare", "--mount", "--propagation", "unchanged"]):
        if shutil.which("unshare") and subprocess.run([*own, "true"], stderr=subprocess.DEVNULL).returncode == 0:
            os.environ["GRAZE_FAULTS_NAMESPACE"] = "1"
            os.execvp(own[0], [*own, sys.executable, *sys.argv])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=Path, help="the folder of the programs")
    parser.add_argument("--farm", help="graze_farm.py")
    parser.add_argument("--slice", type=int, default=1, help="every N-th cell")
    parser.add_argument("--only", default="", help="cells whose name holds this regular expression")
    parser.add_argument("--seed", type=int, default=1, help="of the times of signals")
    parser.add_argument("--json", action="store_true", help="one JSON object a cell, and one for all")
    parser.add_argument("--list", action="store_true", help="the names of the cells")
    given = parser.parse_args()
    names = ["graze-fuzz", "graze-render", "graze-voxelize", "graze-itf1788", "graze-exhaustive"]
    programs = {name: str((given.bin / name).resolve()) for name in names}
    if missing := [name for name, path in programs.items() if not os.access(path, os.X_OK)]:
        print(f"faults.py: {given.bin} has no {missing[0]}", file=sys.stderr)
        return 2
    in_namespace()
    with tempfile.TemporaryDirectory(prefix="graze-faults-") as folder:
        disk = mounted(folder)
        try:
            return run(given, Matrix(programs, given.farm and os.path.abspath(given.farm), folder, disk, given.seed))
        finally:
            if disk:
                subprocess.run(["umount", disk], check=False)


def run(given, matrix):
    cells = [c for i, c in enumerate(matrix.build()) if i % given.slice == 0 and re.search(given.only, c.name)]
    if given.list:
        print("\n".join(c.name for c in cells))
        return 0
    shown = sys.stderr.isatty()
    wrong, skipped, start = [], [], time.monotonic()
    for i, cell in enumerate(cells):
        if shown:
            left = (time.monotonic() - start) / i * (len(cells) - i) if i else 0
            print(f"\r{i} of {len(cells)} cells, {left:.0f} s left\x1b[K", end="", file=sys.stderr, flush=True)
        try:
            why, verdict = cell.wrong(), "right"
            if why:
                verdict = "wrong"
                wrong.append((cell.name, why))
        except Skip as reason:
            why, verdict = str(reason), "skipped"
            skipped.append((cell.name, why))
        if given.json:
            print(json.dumps({"cell": cell.name, "is": verdict, "why": why}), flush=True)
        elif verdict != "right":
            print(f"{verdict}: {cell.name}: {why}", flush=True)
    if shown:
        print("\r\x1b[K", end="", file=sys.stderr)
    summary = {"cells": len(cells), "right": len(cells) - len(wrong) - len(skipped), "wrong": len(wrong),
               "skipped": len(skipped), "seconds": round(time.monotonic() - start, 1)}
    print(json.dumps(summary) if given.json else
          "{cells} cells: {right} right, {wrong} wrong, {skipped} skipped, {seconds} s".format(**summary))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
