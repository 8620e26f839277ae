#!/usr/bin/python3
"""A campaign of graze-fuzz on many machines, through Dask (Debian: python3-distributed).

    graze_farm.py --rays 100000000000 --scheduler tcp://head:8786 --out plain.jsonl \
        -- --traversal plain --level 1-50 --seed 2026

What follows -- is for `graze-fuzz run`. Each task checks a range of rays and returns what the program
printed; it has no state, so a worker that is killed loses nothing but time: its tasks are run again
elsewhere. Finished ranges are kept in --out, and the same command goes on where it was.
Exit code: 0 nothing found, 1 a finding, 2 bad input, a range that could not be checked, or another
failure (files, memory, output, the scheduler), 130 interrupted."""
import argparse
import fcntl
import json
import logging
import os
import queue
import signal
import stat
import subprocess
import sys

AHEAD = 1000  # tasks that wait at the scheduler
LONGEST_LINE = 1 << 24  # of --out
PATIENCE = 5  # seconds for a scheduler that does not answer


class Refusal(Exception):
    """One line for standard error; exit code 2."""


class Lost(Refusal):
    """The scheduler is gone, and the client's threads may wait for it for long."""


def check(program, options, first, rays):
    """One task: the rays first .. first + rays - 1."""
    ran = subprocess.run(
        [program, "run", "--json", "--threads", "1", "--first-ray", str(first), "--rays", str(rays)]
        + options, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL)
    if ran.returncode not in (0, 1):
        raise RuntimeError(ran.stderr.decode(errors="replace").strip()
                           or f"{program} ended with {ran.returncode}")
    return json.loads(ran.stdout)


def ranges(rays, piece):
    for first in range(0, rays, piece):
        yield first, min(piece, rays - first)


def farm(client, program, options, todo):
    """Yields (first, result) of each range once, as they are finished; todo may be long."""
    finished, waiting, todo = queue.Queue(), {}, iter(todo)

    def submit():
        for first, rays in todo:
            task = client.submit(check, program, options, first, rays, pure=False)
            waiting[task] = first
            task.add_done_callback(finished.put)
            return True
        return False

    while len(waiting) < AHEAD and submit():
        pass
    while waiting:
        try:
            task = finished.get(timeout=PATIENCE)
        except queue.Empty:
            if client.status != "running":
                raise Lost("the scheduler does not answer any more") from None
            continue
        if task.status == "cancelled" or task.status == "lost":
            raise Lost("the scheduler has ended")
        yield waiting.pop(task), task.result()
        task.release()
        submit()


class Totals:
    """Counts added up, and the counterexamples, each once, with the first ray that showed it."""

    def __init__(self):
        self.total, self.of_generator, self.findings = {}, {}, {}

    def add(self, result):
        for row in result["generators"]:
            for into in (self.total, self.of_generator.setdefault(row["generator"], {})):
                for key, value in row.items():
                    if isinstance(value, int):
                        into[key] = into.get(key, 0) + value
        if result["counterexample"]:
            found = {"kind": result["finding"], "ray": int(result["ray"]),
                     "counterexample": result["counterexample"]}
            key = json.dumps(result["counterexample"])
            known = self.findings.get(key)
            if known is None or found["ray"] < known["ray"]:
                self.findings[key] = found

    def summary(self):
        return {**self.total, "generators": self.of_generator,
                "findings": sorted(self.findings.values(), key=lambda f: f["ray"])}


def summary(results):
    totals = Totals()
    for result in results.values():
        totals.add(result)
    return totals.summary()


class Store:
    """JSON lines: the plan, then one for every finished range; a last line cut off is dropped. Held by
    this process alone."""

    def __init__(self, path, plan):
        self.finished, self.totals, self.file = set(), Totals(), None
        if not path:
            return
        if os.path.exists(path) and not stat.S_ISREG(os.stat(path).st_mode):
            raise Refusal(f"{path} is not a regular file")
        self.file = open(path, "a+b")
        try:
            fcntl.lockf(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Refusal(f"{path} is in use by another graze_farm.py") from None
        self.file.seek(0)
        whole, number = 0, 0
        while (line := self.file.readline(LONGEST_LINE)).endswith(b"\n"):
            number += 1
            whole += len(line)
            try:
                entry = json.loads(line)
                if number > 1:
                    self.keep(entry["first_ray"], entry["result"])
            except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
                raise Refusal(f"{path}:{number}: not a line of graze_farm.py") from None
            if number == 1 and entry != plan:
                raise Refusal(f"{path} holds another plan: {json.dumps(entry)}")
        if len(line) == LONGEST_LINE or (number == 0 and line and not self.is_beginning(line, plan)):
            raise Refusal(f"{path}:{number + 1}: not a line of graze_farm.py")
        self.file.truncate(whole)
        if whole == 0:
            self.append(plan)

    @staticmethod
    def is_beginning(line, plan):
        return json.dumps(plan).encode().startswith(line)

    def keep(self, first, result):
        if first not in self.finished:
            self.totals.add(result)
            self.finished.add(int(first))

    def append(self, entry):
        if self.file:
            self.file.write(json.dumps(entry).encode() + b"\n")
            self.file.flush()
            os.fsync(self.file.fileno())

    def add(self, first, result):
        self.append({"first_ray": first, "result": result})
        self.keep(first, result)


def run(given):
    logging.disable(logging.CRITICAL)  # Dask's; what it says comes back as an error, told in one line
    import dask
    from distributed import Client, LocalCluster
    store = Store(given.out, {"graze_farm": 1, "rays": given.rays, "piece": given.piece,
                              "options": given.options})
    todo = (r for r in ranges(given.rays, given.piece) if r[0] not in store.finished)
    # a range is not to blame for the worker that it was on
    dask.config.set({"distributed.scheduler.allowed-failures": 1000})
    cluster = given.scheduler or LocalCluster(n_workers=given.workers, threads_per_worker=1,
                                              dashboard_address=None)
    with Client(cluster, timeout=PATIENCE) as client:
        for first, result in farm(client, given.program, given.options, todo):
            store.add(first, result)
            say(f"{len(store.finished)} of {-(-given.rays // given.piece)} ranges")
    return store.totals.summary()


def say(text):
    """One line on standard error: what was given or thrown may have more, and no reader is needed."""
    line = "".join(c if c.isprintable() else " " for c in str(text))[:1000]
    try:
        print(line.encode(errors="replace").decode(), file=sys.stderr, flush=True)
    except (OSError, ValueError, AttributeError):
        pass


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rays", type=int, required=True, help="rays in all")
    parser.add_argument("--piece", type=int, default=10_000_000, help="rays of a task")
    parser.add_argument("--scheduler", help="address of a Dask scheduler (default: this machine)")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="on this machine")
    parser.add_argument("--program", default="graze-fuzz", help="its path on the workers")
    parser.add_argument("--out", help="file of finished ranges, to go on from")
    parser.add_argument("options", nargs="*", help="for graze-fuzz run, after --")
    parser.error = lambda why: (_ for _ in ()).throw(Refusal(why))
    given = parser.parse_args()
    if not 1 <= given.rays < 2**64 or given.piece < 1 or given.workers < 1:
        raise Refusal("--rays, --piece and --workers are 1 or more, and rays have 64 bits")
    try:
        found = run(given)
    except ImportError:
        raise Refusal("needs Dask (Debian: python3-distributed)") from None
    print(json.dumps(found))
    return 1 if found["findings"] else 0


def orderly():
    """main(), whose failures are one line and exit code 2."""
    def interrupted(*_):
        raise KeyboardInterrupt
    for s in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(s, interrupted)
    try:
        if sys.stdout is None:
            raise OSError("standard output is closed")
        code = main()
        sys.stdout.flush()
        return code
    except SystemExit as end:  # help
        try:
            sys.stdout.flush()
            return end.code
        except OSError as error:
            say(f"graze_farm.py: {error}")
            return 2
    except KeyboardInterrupt:
        say("graze_farm.py: interrupted")
        return 130
    except MemoryError:
        say("graze_farm.py: not enough memory")
        return 2
    except Exception as error:  # pylint: disable=broad-except
        say(f"graze_farm.py: {str(error) or type(error).__name__}")
        if isinstance(error, Lost):
            os._exit(2)
        return 2


if __name__ == "__main__":
    ended = orderly()
    try:
        sys.stdout.close()
    except (OSError, AttributeError):
        pass
    sys.exit(ended)
