#!/usr/bin/python3
"""A campaign of graze-fuzz on many machines, through Dask (Debian: python3-distributed).

    graze_farm.py --rays 100000000000 --scheduler tcp://head:8786 --out plain.jsonl \
        -- --traversal plain --level 1-50 --seed 2026

What follows -- is for `graze-fuzz run`. Each task checks a range of rays and returns what the program
printed; it has no state, so a worker that is killed loses nothing but time: its tasks are run again
elsewhere. Finished ranges are kept in --out, and the same command goes on where it was.
Exit code: 0 nothing found, 1 a finding, 2 bad input, or a range that could not be checked."""
import argparse
import json
import os
import subprocess
import sys


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
    return [(first, min(piece, rays - first)) for first in range(0, rays, piece)]


def farm(client, program, options, todo):
    """Yields (first, result) of each range once, as they are finished."""
    from distributed import as_completed
    tasks = {client.submit(check, program, options, first, rays, pure=False): first
             for first, rays in todo}
    for task in as_completed(tasks):
        yield tasks[task], task.result()


def summary(results):
    """Counts added up, and the counterexamples, each once."""
    total, of_generator, findings = {}, {}, {}
    for first in sorted(results):
        result = results[first]
        for row in result["generators"]:
            for into in (total, of_generator.setdefault(row["generator"], {})):
                for key, value in row.items():
                    if isinstance(value, int):
                        into[key] = into.get(key, 0) + value
        if result["counterexample"]:
            findings.setdefault(json.dumps(result["counterexample"]),
                                {"kind": result["finding"], "ray": result["ray"],
                                 "counterexample": result["counterexample"]})
    return {**total, "generators": of_generator, "findings": list(findings.values())}


class Store:
    """JSON lines: the plan, then one for every finished range; a last line cut off is dropped."""

    def __init__(self, path, plan):
        self.results = {}
        self.file = open(path, "a+b") if path else None
        if not self.file:
            return
        self.file.seek(0)
        whole = 0
        for number, line in enumerate(self.file):
            if not line.endswith(b"\n"):
                break
            whole += len(line)
            entry = json.loads(line)
            if number == 0 and entry != plan:
                raise ValueError(f"{path} holds another plan: {json.dumps(entry)}")
            if number > 0:
                self.results[entry["first_ray"]] = entry["result"]
        self.file.truncate(whole)
        if whole == 0:
            self.append(plan)

    def append(self, entry):
        if self.file:
            self.file.write(json.dumps(entry).encode() + b"\n")
            self.file.flush()
            os.fsync(self.file.fileno())

    def add(self, first, result):
        self.append({"first_ray": first, "result": result})
        self.results[first] = result


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
    given = parser.parse_args()
    if given.rays < 1 or given.piece < 1 or given.workers < 1:
        parser.error("--rays, --piece and --workers are 1 or more")
    try:
        import dask
        from distributed import Client, LocalCluster
    except ImportError:
        sys.exit(print("graze_farm.py: needs Dask (Debian: python3-distributed)", file=sys.stderr)
                 or 2)
    try:
        store = Store(given.out, {"graze_farm": 1, "rays": given.rays, "piece": given.piece,
                                  "options": given.options})
        todo = [r for r in ranges(given.rays, given.piece) if r[0] not in store.results]
        # a range is not to blame for the worker that it was on
        dask.config.set({"distributed.scheduler.allowed-failures": 1000})
        cluster = given.scheduler or LocalCluster(n_workers=given.workers, threads_per_worker=1,
                                                  dashboard_address=None)
        with Client(cluster) as client:
            for first, result in farm(client, given.program, given.options, todo):
                store.add(first, result)
                print(f"{len(store.results)} of {len(ranges(given.rays, given.piece))} ranges",
                      file=sys.stderr)
    except (OSError, RuntimeError, ValueError) as error:
        print(f"graze_farm.py: {error}".replace("\n", " "), file=sys.stderr)
        return 2
    found = summary(store.results)
    print(json.dumps(found))
    return 1 if found["findings"] else 0


if __name__ == "__main__":
    sys.exit(main())
