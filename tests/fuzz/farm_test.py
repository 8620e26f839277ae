"""fuzz/farm: two workers of which one is killed count and find what one undisturbed run does.

    farm_test.py FARM_FOLDER GRAZE_FUZZ        exit code 77: Dask is not installed"""
import os
import signal
import subprocess
import sys
import tempfile

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


if __name__ == "__main__":
    main()
