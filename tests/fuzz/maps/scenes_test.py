"""scenes_test.py GRAZE_FUZZ ADAPTER WRITER FOLDER: campaigns over a map, judged right and told in a line where there is
none. ADAPTER and WRITER are those of .npy."""
import os
import shutil
import subprocess
import sys

fuzz, adapter, writer, folder = sys.argv[1:5]
here = os.path.dirname(os.path.abspath(__file__))
if not os.path.exists(adapter) or not os.path.exists(writer):
    print("skipped: xtensor is not there")
    sys.exit(77)
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
subprocess.run([writer, folder], check=True)
scene, saved = os.path.join(folder, "npy-fortran.npy"), os.path.join(folder, "saved.jsonl")
wrong = []


def run(*words, **environment):
    ran = subprocess.run([fuzz, *words], capture_output=True, text=True, timeout=280, env={**os.environ, **environment})
    return ran.returncode, ran.stdout, ran.stderr


def command(*words):
    return ["--command", " ".join([sys.executable, os.path.join(here, "exact_peer.py"), adapter, *words])]


def expect(what, seen, code, text=""):
    ok = seen[0] == code and text in seen[1] + seen[2] and (code != 2 or seen[2].count("\n") == 1)
    print(f"{what}: {'as it should be' if ok else 'WRONG'}")
    if not ok:
        wrong.append(what)
        print(f"exit code {seen[0]}\n{seen[1][-3000:]}{seen[2][-1000:]}")


rays = ["--rays", "950", "--threads", "1"]
for promise in ["exactly-touched", "first", "first-touched", "any"]:
    expect(f"exact, {promise}", run("run", "--scene", scene, *command(promise), *rays), 0, "nothing found")
for promise in ["crossed", "first", "any"]:
    expect(f"a layer lost, {promise}", run("run", "--scene", scene, *command(promise, "lose"), *rays), 1, "gross-miss")
expect("saved", run("run", "--scene", scene, *command("crossed", "lose"), *rays, "--save", saved), 1)
expect("replayed, a layer lost", run("replay", saved, *command("crossed", "lose")), 1, "gross-miss")
expect("replayed, exact", run("replay", saved, *command("crossed")), 0)
campaign = ["campaign", os.path.join(folder, "campaign")]
expect("campaign", run(*campaign, "--scene", scene, *command("crossed", "lose"), *rays), 1)
expect("campaign, gone on with", run(*campaign), 1)
with open(os.path.join(folder, "text.npy"), "w") as to:
    to.write("no array\n")
expect("no array", run("run", "--scene", os.path.join(folder, "text.npy"), *command("first")), 2, "not a file of NumPy")
expect("no map by its name", run("run", "--scene", fuzz, *command("first")), 2, ".bt")
expect("no traversal of this map", run("run", "--scene", scene, "--traversal", "exact"), 2)
empty = os.path.join(folder, "adapters")
os.makedirs(empty)
expect("no adapter", run("run", "--scene", scene, *command("first"), GRAZE_ADAPTERS=empty), 2, "libxtensor-dev")
stand_in = os.path.join(empty, os.path.basename(adapter))
with open(stand_in, "w") as to:
    to.write("#!/bin/sh\nkill -SEGV $$\n")
os.chmod(stand_in, 0o755)
expect("an adapter that ends", run("run", "--scene", scene, *command("first"), GRAZE_ADAPTERS=empty), 2, "signal 11")
sys.exit(1 if wrong else 0)
