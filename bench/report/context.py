"""What a section is given to measure with: programs, pinned runs, what is missing, progress."""
import datetime
import json
import os
import pathlib
import platform
import re
import shutil
import signal
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build" / "release"


class MeasurementFailed(Exception):
    """Ends a section; its one line is shown on the page."""


class Usage:
    """What a command took: stdout, seconds by the clock, seconds of the processor, peak resident bytes."""

    def __init__(self, stdout, usage):
        self.stdout = stdout
        self.seconds, self.processor, self.peak_bytes = usage["seconds"], usage["processor"], usage["peak_bytes"]


class Context:
    """Of one section in one run."""

    def __init__(self, out, quick=False, core=0, say=None, build=BUILD):
        self.quick, self.core, self.root, self.build = quick, core, ROOT, pathlib.Path(build)
        self.out = pathlib.Path(out)
        self.scratch = self.out / "work"
        self.scratch.mkdir(parents=True, exist_ok=True)
        self.missing_peers = []
        self.say = say or (lambda text: None)

    def share(self, full_seconds, quick_seconds):
        """The number for this run."""
        return quick_seconds if self.quick else full_seconds

    def program(self, name):
        """build/release/bin/NAME, or None where it was not built."""
        path = self.build / "bin" / name
        return path if os.access(path, os.X_OK) else None

    def needed(self, name):
        """build/release/bin/NAME; without it the section fails."""
        path = self.program(name)
        if path is None:
            raise MeasurementFailed(f"{name} has not been built")
        return path

    def missing(self, name, package, why=""):
        """Records a peer that is not here: the page says so."""
        entry = {"name": name, "package": package, "why": why}
        if entry not in self.missing_peers:
            self.missing_peers.append(entry)

    def progress(self, text):
        self.say(text)

    def run(self, command, core=None, timeout=None, codes=(0,)):
        """What the command prints; it is pinned to `core` (a number or a list such as "0,1"; --core by
        default). Raises MeasurementFailed for another exit code than `codes`, or after `timeout` seconds."""
        words = self.pinned(command, core)
        try:
            process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, text=True, errors="replace", start_new_session=True)
        except OSError as error:
            raise MeasurementFailed(f"{words[3]}: {error.strerror}") from error
        name = pathlib.Path(str(command[0])).name
        try:
            stdout, stderr = process.communicate(timeout=timeout)
        except BaseException as error:  # an interrupt also ends what was started
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            if isinstance(error, subprocess.TimeoutExpired):
                raise MeasurementFailed(f"{name} took longer than {timeout:g} s") from error
            raise
        if process.returncode not in codes:
            last = stderr.strip().splitlines()[-1:] or [""]
            raise MeasurementFailed(f"{name} ended with {process.returncode}: {last[0]}".rstrip(": "))
        return stdout

    def pinned(self, command, core=None):
        """The command's words behind taskset."""
        return ["taskset", "-c", str(self.core if core is None else core), *map(str, command)]

    def json_lines(self, command, **options):
        """The JSON objects that the command prints, one a line; other lines are left out."""
        return [json.loads(line) for line in self.run(command, **options).splitlines() if line.startswith("{")]

    def measured(self, command, core=None, timeout=None, codes=(0,)):
        """As `run`, with what the command took (Usage); peak memory is of its largest process."""
        usage_file = self.scratch / "usage.json"
        usage_file.unlink(missing_ok=True)
        usage = [sys.executable, "-I", "-S", str(pathlib.Path(__file__).with_name("usage.py")), str(usage_file)]
        stdout = self.run([*usage, *command], core=core, timeout=timeout, codes=codes)
        return Usage(stdout, json.loads(usage_file.read_text()))


def first_line(command):
    """Of what the command prints; empty where it cannot be run."""
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, errors="replace", cwd=ROOT, timeout=30)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.strip().splitlines()[0] if done.returncode == 0 and done.stdout.strip() else ""


def text_of(path):
    try:
        return pathlib.Path(path).read_text(errors="replace")
    except OSError:
        return ""


def machine():
    """The processor, cores, frequency governor, load, memory and kernel."""
    model = re.search(r"^model name\s*:\s*(.*)$", text_of("/proc/cpuinfo"), re.M)
    memory = re.search(r"^MemTotal:\s*(\d+) kB", text_of("/proc/meminfo"), re.M)
    governor = text_of("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor").strip()
    return {"processor": model.group(1) if model else platform.machine(), "cores": os.cpu_count(),
            "cores_allowed": len(os.sched_getaffinity(0)), "governor": governor or "not told by the system",
            "load": round(os.getloadavg()[0], 2), "memory_bytes": 1024 * int(memory.group(1)) if memory else None,
            "kernel": platform.release(), "system": first_line(["lsb_release", "-ds"]) or system_name()}


def system_name():
    name = re.search(r'^PRETTY_NAME="?([^"\n]*)', text_of("/etc/os-release"), re.M)
    return name.group(1) if name else platform.system()


def compiler(build=BUILD):
    """The compiler of the build and its flags."""
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", text_of(build / "CMakeCache.txt"), re.M))
    kind = cache.get("CMAKE_BUILD_TYPE", "")
    program = cache.get("CMAKE_CXX_COMPILER", "")
    flags = f"{cache.get('CMAKE_CXX_FLAGS', '')} {cache.get(f'CMAKE_CXX_FLAGS_{kind.upper()}', '')}".strip()
    return {"compiler": first_line([program, "--version"]) if program else "not built", "build_type": kind,
            "flags": f"{flags} (graze's own code besides: -frounding-math -ffp-contract=off)" if program else ""}


def source():
    """The commit, and whether the tree differs from it."""
    dirty = subprocess.run(["git", "status", "--porcelain"], cwd=ROOT, stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True) if shutil.which("git") else None
    return {"commit": first_line(["git", "rev-parse", "HEAD"]) or "not known",
            "dirty": bool(dirty.stdout.strip()) if dirty and dirty.returncode == 0 else None}


def packages():
    """Versions of the report's packages as dpkg tells them, None for what is not installed."""
    command = "source cmake/setup.sh && echo ${graze_report_packages[@]} python3-matplotlib libboost-dev libmpfr-dev " \
              "libbenchmark-dev"
    names = subprocess.run(["bash", "-c", command], cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout.split()
    if not shutil.which("dpkg-query"):
        return {}
    versions = subprocess.run(["dpkg-query", "-W", "-f=${Package} ${db:Status-Status} ${Version}\n", *names],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    found = {row[0]: row[2] for row in map(str.split, versions.splitlines()) if len(row) == 3 and row[1] == "installed"}
    return {name: found.get(name) for name in names}


def head(arguments, quick, core, build=BUILD):
    """The report's head: where, with what, of what, and when it was measured."""
    return {"machine": machine(), **compiler(build), **source(), "packages": packages(),
            "cargo": first_line(["cargo", "--version"]) or None,
            "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
            "command": " ".join(["bench/graze-report", *arguments]), "quick": quick, "core": core}
