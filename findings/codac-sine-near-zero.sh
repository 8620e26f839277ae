#!/bin/sh
# codac's sine of a small positive number is an interval of both signs: sin of the point 1e-20 is
# [-1.6e-16, 2.8e-16], the same as that of 1e-300, and sin(0) is no point. The sine is enclosed, but only
# to an absolute error of about 1e-16, so that sin(x) / x of small x has no bound, and no sign of sin(x)
# is ever proven there; tan and atan of the same points are two units in the last place wide.
#
# Judged by MPFR (gmpy2) at 300 bits.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
python3 -m venv "$d/venv"
"$d/venv/bin/pip" -q install --no-deps codac==2.1.2 gmpy2==2.3.2
cat > "$d/try.py" <<'EOF'
import importlib.metadata, math
import codac, gmpy2
from gmpy2 import mpfr

print("codac", importlib.metadata.version("codac"))
gmpy2.get_context().precision = 300
for x in (0.0, 1e-300, 1e-20, 1e-10, 0.1):
    row = []
    for name in ("sin", "tan", "atan"):
        r, t = getattr(codac, name)(codac.Interval(x)), getattr(gmpy2, name)(mpfr(x))
        assert mpfr(r.lb()) <= t <= mpfr(r.ub())
        row.append(f"{name} [{r.lb():.4g}, {r.ub():.4g}] {(r.ub() - r.lb()) / math.ulp(float(t)):.3g} ulp")
    print(f"{x:g}:", "; ".join(row))
sine = lambda x: codac.sin(codac.Interval(x))
assert sine(1e-20).lb() < -1e-16 and sine(1e-20).ub() > 1e-16
assert sine(1e-20).lb() == sine(1e-300).lb() and sine(0.0).lb() < 0 < sine(0.0).ub()
assert codac.tan(codac.Interval(1e-20)).lb() > 0
EOF
"$d/venv/bin/python" "$d/try.py"
