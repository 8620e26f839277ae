#!/usr/bin/env python3
"""The table of findings in docs/fuzz.md: what each adapter is caught at.

fuzz/peers/table.py [--program build/release/bin/graze-fuzz] [--level 10] [--rays N] [NAME...]

For each traversal of others: the share of adversarial rays (all generators but the control) on which
a crossed octant is missed, over five seeds, and its range over the generators; whether a gross miss is
among them (a chord of over 1e-3 of the octant's edge); the share of random rays with a miss; and the
median over the seeds of the time to the first definite miss, the start of the process included. Rays
that were declined are not counted. A name alone measures that adapter."""

import argparse
import json
import statistics
import subprocess
import sys

# rays a second are very different: a budget of rays, not of time, so that counts can be repeated
SLOW = {"nanovdb": 600, "openvdb": 600, "octomap": 4000, "embree": 8000, "rational": 20000}
SEEDS = range(1, 6)


def run(program, name, level, rays, seed, generators):
    command = [program, "run", "--traversal", name, "--level", str(level), "--rays", str(rays),
               "--seed", str(seed), "--generator", ",".join(generators), "--threads", "1", "--json",
               "--timeout", "0.2"]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}")
    return json.loads(done.stdout)


def listed(program):
    """Names by heading of `graze-fuzz list`."""
    names, heading = {}, None
    for line in subprocess.run([program, "list"], stdout=subprocess.PIPE, text=True,
                               check=True).stdout.splitlines():
        if line.startswith("  "):
            names[heading].append(line.split()[0])
        else:
            heading = line
            names[heading] = []
    return names


def share(counts):
    judged = counts["rays"] - counts["declined"] - counts["faults"]
    return counts["rays_with_miss"] / judged if judged else 0.0


def percent(x):
    return "0" if x == 0 else f"{100 * x:.2g} %"


def row(program, name, level, rays, adversarial):
    runs = [run(program, name, level, rays, seed, adversarial) for seed in SEEDS]
    random = run(program, name, level, max(rays // 4, 100), 1, ["random"])
    total = {key: sum(r[key] for r in runs) for key in
             ("rays", "rays_with_miss", "declined", "faults", "gross_missed", "rays_with_finding")}
    total["exact"] = random["promise"].startswith("exactly")
    by_generator = [
        share({key: sum(r["generators"][g][key] for r in runs) for key in
               ("rays", "rays_with_miss", "declined", "faults")})
        for g in range(len(adversarial))]
    first = [r["first_miss_seconds"] for r in runs]
    time = "none" if None in first else f"{1000 * statistics.median(first):.2g} ms"
    faults = [r["finding"] for r in runs if r["finding"] in ("crash", "hang", "exception", "nan", "malformed")]
    return (f"| {name} | {total['rays']} | {percent(share(total))} | "
            f"{percent(min(by_generator))} to {percent(max(by_generator))} | "
            f"{'yes' if total['gross_missed'] else 'no'} | {percent(share(random))} | {time} | "
            f"{faults[0] if faults else ''} |"), total


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("names", nargs="*", metavar="NAME")
    options.add_argument("--program", default="build/release/bin/graze-fuzz")
    options.add_argument("--level", type=int, default=10)
    options.add_argument("--rays", type=int, help="for each seed (default: by the adapter's speed)")
    given = options.parse_args()
    names = listed(given.program)
    adversarial = [g for g in names["generators"] if g != "random"]
    accused = False
    print("| adapter | rays | any miss | by generator | gross | random rays | first miss | besides |")
    print("|---|---|---|---|---|---|---|---|")
    for name in given.names or names["traversals of others"] + ["gargantini", "published"]:
        rays = given.rays or next((n for key, n in SLOW.items() if name.startswith(key)), 20000)
        text, total = row(given.program, name, given.level, rays, adversarial)
        print(text, flush=True)
        if total["exact"] and total["rays_with_finding"]:
            accused = True
            print(f"{name} is exact, and was accused", file=sys.stderr)
    return 1 if accused else 0


if __name__ == "__main__":
    sys.exit(main())
