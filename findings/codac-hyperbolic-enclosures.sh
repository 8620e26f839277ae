#!/bin/sh
# codac computes with guaranteed enclosures; its tanh, asinh, acosh and atanh of a point are intervals
# two units in the last place wide that leave the exact value out for some arguments: of 4,000 ordinary
# doubles more than 100 for tanh. cosh of the same arguments is an enclosure, and so are exp and log, of
# which the four could be made.
#
# Judged by MPFR (gmpy2) at 300 bits.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
python3 -m venv "$d/venv"
"$d/venv/bin/pip" -q install --no-deps codac==2.1.2 gmpy2==2.3.2
cat > "$d/try.py" <<'EOF'
import importlib.metadata, random
import codac, gmpy2
from gmpy2 import mpfr

print("codac", importlib.metadata.version("codac"), "MPFR", gmpy2.mpfr_version())
gmpy2.get_context().precision = 300
random.seed(1)
lost = {}
for name, low, high in (("exp", -3, 3), ("log", 0.1, 9), ("cosh", -3, 3),
                        ("tanh", -3, 3), ("asinh", -3, 3), ("acosh", 1.001, 3),
                        ("atanh", -0.9, 0.9)):
    lost[name] = 0
    for _ in range(4000):
        x = random.uniform(low, high)
        r, t = getattr(codac, name)(codac.Interval(x)), getattr(gmpy2, name)(mpfr(x))
        if not mpfr(r.lb()) <= t <= mpfr(r.ub()):
            if lost[name] == 0 and name == "tanh":
                print(f"tanh({x.hex()}) = {t:.25f}, codac: [{r.lb():.20f}, {r.ub():.20f}]")
            lost[name] += 1
print("of 4000 points each, results that do not contain the value:", lost)
assert lost["tanh"] > 50 and min(lost[f] for f in ("asinh", "acosh", "atanh")) > 0
assert max(lost[f] for f in ("exp", "log", "cosh")) == 0
EOF
"$d/venv/bin/python" "$d/try.py"
