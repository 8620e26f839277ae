#!/usr/bin/env python3
"""Renders the implicit surfaces of a collection of MathMod (mathmodcollection.js) with graze-render, and
tells of each its pixels' verdicts, or why it is refused.

usage: collection.py --render PROGRAM --collection FILE [--size N] [--seconds S] [--first N] [--json]

The file is not part of this repository: it is in github.com/parisolab/mathmod, mathmodcollection.js.
A surface with functions of its own, or scripts, is counted as left out. Exit codes: 0 done, 2 bad input.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time


def read(path):
    """Names, texts and the six ends of the domains, as they are written."""
    text = open(path, encoding="utf-8", errors="replace").read()
    try:
        models = json.loads(text, strict=False)["MathModels"]
    except (ValueError, KeyError) as error:
        sys.exit(f"collection.py: {path} is no collection: {error}")
    for model in models:
        part = model.get("Iso3D")
        if not part or "Fxyz" not in part:
            continue
        for i, text in enumerate(part["Fxyz"]):
            ends = [part[axis + end][min(i, len(part[axis + end]) - 1)]
                    for axis in "XYZ" for end in ("min", "max")]
            name = part.get("Name", ["?"])[0] + (f"[{i}]" if len(part["Fxyz"]) > 1 else "")
            own = [key for key in ("Funct", "Vect", "Import") if part.get(key)]
            yield name, part.get("Const", []), text, ends, own


def number(text, constants):
    """A domain's end, which may be made of the constants; nothing if it is more than arithmetic."""
    values = {"pi": 3.141592653589793}
    for line in constants:
        name, _, value = line.partition("=")
        values[name.strip()] = number(value, []) if name.strip() not in values else values[name.strip()]
    for name in sorted(values, key=len, reverse=True):
        if values[name] is not None:
            text = re.sub(rf"\b{re.escape(name)}\b", f"({values[name]!r})", text)
    if len(text) > 200 or "**" in text or not re.fullmatch(r"[\d.eE+\-*/() ]+", text):
        return None
    try:
        return float(eval(text, {"__builtins__": {}}))  # digits and + - * / alone
    except (SyntaxError, ArithmeticError, TypeError, ValueError):
        return None


def render(options, text, domain, picture):
    command = [options.render, "--formula", text, "--domain=" + ",".join(map(repr, domain)),
               "--size", str(options.size), "--threads", "1", "--json", "-o", picture]
    if re.search(r"\bt\b", text):
        command += ["--set", "t=0"]  # time, of what moves there
    begin = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace",
                              timeout=options.seconds, check=False)
    except subprocess.TimeoutExpired:
        return {"reason": f"more than {options.seconds:g} s"}
    if done.returncode != 0:
        return {"reason": (done.stderr.splitlines() or ["?"])[0]}
    counts = json.loads(done.stdout)
    return {"hits": counts["hits"], "misses": counts["misses"], "undecided": counts["undecided"],
            "seconds": round(time.monotonic() - begin, 3), "note": done.stderr.strip()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--render", required=True)
    parser.add_argument("--collection", required=True)
    parser.add_argument("--size", type=int, default=96)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--first", type=int, default=None)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    if not os.path.isfile(options.render) or not os.path.isfile(options.collection):
        sys.exit("collection.py: --render or --collection is no file")
    total = {"surfaces": 0, "rendered": 0, "refused": 0, "left out": 0, "all decided": 0, "undecided": 0}
    with tempfile.TemporaryDirectory() as folder:
        for name, constants, text, ends, own in list(read(options.collection))[:options.first]:
            total["surfaces"] += 1
            domain = [number(end, constants) for end in ends]
            if own or None in domain:
                what = {"left out": ", ".join(own) or "its domain"}
                total["left out"] += 1
            else:
                used = "".join(line + "; " for line in constants)
                what = render(options, used + text, domain, os.path.join(folder, "a.png"))
                total["refused" if "reason" in what else "rendered"] += 1
                total["undecided"] += what.get("undecided", 0)
                total["all decided"] += what.get("undecided", 1) == 0
            print(json.dumps({"name": name, **what}) if options.json else f"{name}: {what}", flush=True)
    print(json.dumps(total) if options.json else total)


if __name__ == "__main__":
    try:
        main()
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
            sys.exit(2)
        raise
