#!/bin/sh
# mpmath's interval context rounds bounds outward, so that its results are enclosures (its manual calls
# the support of intervals experimental). Its loggamma takes the two directions of rounding the wrong
# way round where log(gamma) falls: for every point x of [1/64, 1/2) that is tried here, the result has
# its lower bound above its upper bound, so that it contains no number at all, and for wide intervals
# in there the bounds lie inside of the range. iv.gamma of the same x is an enclosure, and so is
# iv.loggamma from 1/2 on.
#
# Judged by mpmath's own loggamma at 300 bits, and by MPFR (gmpy2).
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
python3 -m venv "$d/venv"
"$d/venv/bin/pip" -q install mpmath==1.4.1 gmpy2==2.3.2
cat > "$d/try.py" <<'EOF'
import gmpy2, mpmath
from mpmath import iv, mp

print("mpmath", mpmath.__version__, "MPFR", gmpy2.mpfr_version())
mp.prec = 300
gmpy2.get_context().precision = 300
iv.prec = 53

def exact(x):
    t = mp.loggamma(mp.mpf(x))
    u = mp.mpf(str(gmpy2.lngamma(gmpy2.mpfr(x))))
    assert abs(t - u) < mp.mpf(10) ** -70
    return t

below, above = [k / 1024 for k in range(16, 512, 8)], [k / 64 for k in range(33, 640)]
reversed_, lost, gamma_lost = 0, 0, 0
for x in below:
    r, g = iv.loggamma(iv.mpf(x)), iv.gamma(iv.mpf(x))
    reversed_ += mp.mpf(r.a) > mp.mpf(r.b)
    lost += not mp.mpf(r.a) <= exact(x) <= mp.mpf(r.b)
    gamma_lost += not mp.mpf(g.a) <= mp.gamma(mp.mpf(x)) <= mp.mpf(g.b)
lost_above = sum(not mp.mpf(r.a) <= exact(x) <= mp.mpf(r.b)
                 for x in above for r in [iv.loggamma(iv.mpf(x))])
r = iv.loggamma(iv.mpf([0.125, 0.25]))
print("iv.loggamma(1/4) =", [float(iv.loggamma(iv.mpf(0.25)).a).hex(),
                             float(iv.loggamma(iv.mpf(0.25)).b).hex()],
      "where log(gamma(1/4)) =", mp.nstr(exact(0.25), 25))
print(f"{len(below)} points x < 1/2: {reversed_} results have lower > upper, {lost} do not contain"
      f" log(gamma(x)); {gamma_lost} of iv.gamma do not contain gamma(x)")
print(f"{len(above)} points x > 1/2: {lost_above} do not contain log(gamma(x))")
print("iv.loggamma([1/8, 1/4]) contains log(gamma(1/8)), log(gamma(1/4)):",
      mp.mpf(r.a) <= exact(0.125) <= mp.mpf(r.b), mp.mpf(r.a) <= exact(0.25) <= mp.mpf(r.b))
assert reversed_ == lost == len(below) and lost_above == 0 and gamma_lost == 0
assert not mp.mpf(r.a) <= exact(0.25) or not exact(0.125) <= mp.mpf(r.b)
EOF
"$d/venv/bin/python" "$d/try.py"
