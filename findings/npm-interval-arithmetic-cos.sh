#!/bin/sh
# The npm package interval-arithmetic, a port of Boost.Interval that rounds every result outward, lists
# as one of its improvements that its cosine works with negative values out of the box. A negative
# argument is moved by a multiple of the double below 2 pi, and that sum is not rounded outward:
# cos([-100, -100]) is an interval three ulps wide that does not contain cos(100), while
# cos([100, 100]) is one some eighty times as wide that does.
#
# Judged by the Taylor series in integers (scaled by 10^120; the error is below 10^-110).
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
cd "$d"
npm init -y > npm.log
npm install --silent --no-audit --no-fund interval-arithmetic@1.1.3 >> npm.log
cat > try.js <<'EOF'
const library = require("interval-arithmetic");
const { Interval } = library;
const functions = library.default || library;
console.log("interval-arithmetic", require("interval-arithmetic/package.json").version,
            "node", process.version);

const SCALE = 10n ** 120n, SLACK = 10n ** 10n;
// SCALE * cos(n) for an integer n
function cosine(n) {
  const square = BigInt(n) * BigInt(n);
  let term = SCALE, sum = 0n;
  for (let k = 1n; term !== 0n; k += 2n) {
    sum += term;
    term = -term * square / (k * (k + 1n));
  }
  return sum;
}
// SCALE * x for a double x, towards 0 by less than 1
function scaled(x) {
  let e = 0;
  while (!Number.isInteger(x)) { x *= 2; e += 1; }
  return BigInt(x) * SCALE / (1n << BigInt(e));
}
const contains = (r, t) => scaled(r.lo) <= t + SLACK && scaled(r.hi) >= t - SLACK;

let lost = 0, lostPositive = 0, count = 0;
for (let n = 1; n <= 300; ++n) {
  const t = cosine(n);
  ++count;
  lost += !contains(functions.cos(new Interval(-n, -n)), t);
  lostPositive += !contains(functions.cos(new Interval(n, n)), t);
}
const a = functions.cos(new Interval(-100, -100)), b = functions.cos(new Interval(100, 100));
console.log(`cos([-100, -100]) = [${a.lo}, ${a.hi}], cos([100, 100]) = [${b.lo}, ${b.hi}],` +
            ` cos(100) = ${Number(cosine(100) / 10n ** 95n) / 1e25}`);
console.log(`cos([-n, -n]), n = 1..${count}: ${lost} results do not contain cos(n);` +
            ` cos([n, n]): ${lostPositive}`);
if (!(lost > 200 && lostPositive === 0 && !contains(a, cosine(100)))) process.exit(1);
EOF
node try.js
