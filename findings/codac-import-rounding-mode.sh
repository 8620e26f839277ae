#!/bin/sh
# Importing codac, an interval library, into Python leaves the processor rounding upward for the whole
# process, not only within the library's calls. From then on sums and quotients of Python's own floats
# are rounded up, and Python prints some doubles wrongly: "%.4g" of 9.999999999999998e-21 is "nan".
#
# A sum is compared with exact rationals, in one process before and after the import.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
python3 -m venv "$d/venv"
"$d/venv/bin/pip" -q install --no-deps codac==2.1.2
cat > "$d/try.py" <<'EOF'
import ctypes, ctypes.util, importlib.metadata
from fractions import Fraction

mode = ctypes.CDLL(ctypes.util.find_library("m")).fegetround
x, y, small = float("0.1"), float("0.7"), float.fromhex("0x1.79ca10c924222p-67")

def state():
    exact = Fraction(x) + Fraction(y)
    error = (Fraction(x + y) - exact) * 2**54
    return mode(), (x + y).hex(), float(error), "%.4g" % small, "%.17g" % small

before = state()
import codac
after = state()
print("codac", importlib.metadata.version("codac"))
print("(mode, 0.1 + 0.7, its error in 2^-54, a small number with 4 and 17 digits)")
print("before the import:", before)
print("after the import: ", after)
assert before[0] == 0 and after[0] != 0
assert before[3] == "1e-20" and after[3] != before[3]
EOF
"$d/venv/bin/python" "$d/try.py"
