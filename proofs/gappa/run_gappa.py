#!/usr/bin/env python3
"""run_gappa.py FILE: Gappa proves FILE, and does not prove it with its bounds halved (so that
the bound is not far too large, and the check is seen to fail). Exit codes: 0, 1, 77 no Gappa."""
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path


def gappa(text):
    """(proved, what Gappa says); a search that goes on and on has proved nothing"""
    try:
        done = subprocess.run(["gappa"], input=text, text=True, capture_output=True, timeout=10)
    except subprocess.TimeoutExpired:
        return False, "nothing after 10 s"
    return done.returncode == 0, done.stderr.strip()


def smaller(conclusion, only):
    """The conclusion with its bound number `only` halved."""
    count = -1

    def shrink(match):
        nonlocal count
        text = match.group(0)
        if text in ("0", "-0"):
            return text
        count += 1
        if count != only:
            return text
        if "x" in text:  # 0xH.Hp-E
            value = Fraction(float.fromhex(text))
        else:            # NbE
            digits, _, exponent = text.partition("b")
            value = int(digits) * Fraction(2) ** int(exponent or 0)
        value *= Fraction(1, 2)
        return f"{int(value * 2**200)}b-200"

    shrunk = re.sub(r"(?<=[\[ ])-?(0x[0-9a-f.]+p-?\d+|\d+b-?\d+|0)(?=[,\]])", shrink, conclusion)
    return shrunk, count + 1


def main():
    if not shutil.which("gappa"):
        print("skipped: Gappa is not installed (Debian: gappa)")
        return 77
    text = Path(sys.argv[1]).read_text()
    proved, message = gappa(text)
    print(f"{sys.argv[1]}: {'proved' if proved else 'NOT PROVED'} {message}")
    head, arrow, conclusion = text.rpartition("->")
    conclusion_bounds = smaller(conclusion, -1)[1]
    for number in range(conclusion_bounds):
        still, _ = gappa(head + arrow + smaller(conclusion, number)[0])
        print(f"bound {number + 1} of {conclusion_bounds}, halved: "
              f"{'STILL PROVED: the stated bound is far too large' if still else 'not proved, as it should be'}")
        proved = proved and not still
    return 0 if proved and conclusion_bounds else 1


if __name__ == "__main__":
    sys.exit(main())
