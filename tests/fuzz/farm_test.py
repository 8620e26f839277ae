"""fuzz/farm: two workers of which one is killed count and find what one undisturbed run does; a scheduler
that is killed is said, and costs no range.

    farm_test.py FARM_FOLDER GRAZE_FUZZ        exit code 77: Dask is not installed"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

folder, program = sys.argv[1:]
sys.path.insert(0, folder)
os.environ["PYTHONPATH"] = os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")])

try:
    import dask
    from distributed import Client, LocalCluster
except ImportError:
    print("graze: skipped, Dask is not installed (Debian: python3-distributed)")
    sys.exit(77)
sys.dont_write_bytecode = True
os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
import graze_farm

OPTIONS = ["--traversal", "published", "--level", "10", "--seed", "7"]
RANGES = list(graze_farm.ranges(2_000_500, 100_000))


def main():
    undisturbed = {first: graze_farm.check(program, OPTIONS, first, rays) for first, rays in RANGES}
    expected = graze_farm.summary(undisturbed)
    assert expected["rays"] == 2_000_500 and expected["findings"], expected

    dask.config.set({"distributed.scheduler.allowed-failures": 1000})
    results = {}
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, \
            Client(cluster) as client:
        workers = list(client.run(os.getpid).values())
        assert len(workers) == 2, workers
        for first, result in graze_farm.farm(client, program, OPTIONS, RANGES):
            assert first not in results, first
            results[first] = result
            if len(results) == 3:
                os.kill(workers[0], signal.SIGKILL)
        assert workers[0] not in client.run(os.getpid).values()
    assert graze_farm.summary(results) == expected

    # the driver: another plan is refused, and a range that is there is not checked again
    with tempfile.TemporaryDirectory() as scratch:
        out = os.path.join(scratch, "farm.jsonl")

        def drive(*more):
            return subprocess.run([sys.executable, os.path.join(folder, "graze_farm.py"), "--piece",
                                   "1000", "--workers", "1", "--out", out, "--program", program,
                                   *more], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        first = drive("--rays", "2000", "--", *OPTIONS)
        assert first.returncode == 1, first
        with open(out, "r+b") as file:
            file.truncate(os.path.getsize(out) - 5)
        again = drive("--rays", "2000", "--", *OPTIONS)
        assert again.returncode == 1 and again.stdout == first.stdout, again
        other = drive("--rays", "3000", "--", *OPTIONS)
        assert other.returncode == 2 and b"holds another plan" in other.stderr, other
        os.remove(out)
        wrong = drive("--rays", "1000", "--", "--traversal", "nobody")
        assert wrong.returncode == 2 and b"nobody" in wrong.stderr, wrong

    dead_scheduler()


def dead_scheduler():
    """Killed between two ranges: one line and exit code 2 within seconds; --out goes on elsewhere."""
    python = [sys.executable, "-m"]
    with tempfile.TemporaryDirectory() as scratch:
        address, out = os.path.join(scratch, "scheduler.json"), os.path.join(scratch, "farm.jsonl")
        begin = {"cwd": scratch, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        scheduler = subprocess.Popen([*python, "distributed.cli.dask_scheduler", "--port", "0", "--no-dashboard",
                                      "--scheduler-file", address], **begin)
        worker = subprocess.Popen([*python, "distributed.cli.dask_worker", "--nthreads", "1", "--no-dashboard",
                                   "--no-nanny", "--scheduler-file", address], **begin)
        command = [sys.executable, os.path.join(folder, "graze_farm.py"), "--piece", "20000", "--rays", "2000500",
                   "--out", out, "--program", program]
        try:
            while not os.path.exists(address) or not open(address, encoding="utf-8").read().strip():
                time.sleep(0.1)
            with open(address, encoding="utf-8") as file:
                where = json.load(file)["address"]
            farm = subprocess.Popen([*command, "--scheduler", where, "--", *OPTIONS], stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, text=True)
            assert " of 101 ranges" in farm.stderr.readline()  # the first, or two that came together
            scheduler.kill()
            since = time.monotonic()
            printed, said = farm.communicate(timeout=60)
            took = time.monotonic() - since
        finally:
            scheduler.kill(), worker.kill()
            scheduler.wait(), worker.wait()
        complaints = [line for line in said.splitlines() if not line.endswith(" ranges")]
        assert farm.returncode == 2 and printed == "" and len(complaints) == 1, (farm.returncode, said)
        assert "scheduler" in complaints[0] and took < 30, (complaints, took)
        again = subprocess.run([*command, "--workers", "1", "--", *OPTIONS], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, check=False)
        assert again.returncode == 1 and json.loads(again.stdout)["rays"] == 2_000_500, again


if __name__ == "__main__":
    main()
