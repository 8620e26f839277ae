#!/bin/sh
# The npm package ray-aabb-intersection determines, by its manual, whether a ray (origin, direction)
# intersects a box, and gives null where it does not. Boxes behind the origin are reported too, as of a line
# in both directions: of the example in the manual itself, a ray that starts above the box [-1, 1]^3 and
# points away from it, the answer is a point of the box, 5 lengths behind the origin, and the distance -5.
#
# Judged in integers: of all rays from integers outside of the box, along integers, half of those that are said
# to meet it have it behind them.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
cd "$d"
npm init -y > npm.log
npm install --silent --no-audit --no-fund ray-aabb-intersection@1.0.1 >> npm.log
cat > try.js <<'JS'
const intersection = require('ray-aabb-intersection');
console.log('ray-aabb-intersection', require('ray-aabb-intersection/package.json').version);
const box = [[-1, -1, -1], [1, 1, 1]];
const point = intersection(new Float32Array(3), [0, 4, 0], [0, 1, 0], box);
const distance = intersection.distance([0, 4, 0], [0, 1, 0], box);
console.log('from (0, 4, 0) along (0, 1, 0), away from [-1, 1]^3:', point, 'distance', distance);
// All rays from the integers of [-3, 3]^3 outside of the box, along integers that are not 0.
let said = 0, behind = 0, lost = 0;
for (let n = 0; n < 7 ** 6; ++n) {
  const v = [...Array(6).keys()].map(a => Math.floor(n / 7 ** a) % 7 - 3), o = v.slice(0, 3), d = v.slice(3);
  if (d.includes(0) || o.every(x => Math.abs(x) <= 1)) continue;
  let enter = -Infinity, leave = Infinity; // of the line, in sixths: exact
  for (let a = 0; a < 3; ++a) {
    const near = (-1 - o[a]) * 6 / d[a], far = (1 - o[a]) * 6 / d[a];
    enter = Math.max(enter, Math.min(near, far));
    leave = Math.min(leave, Math.max(near, far));
  }
  const meets = enter <= leave && leave >= 0, answer = intersection(null, o, d, box) !== null;
  said += answer;
  behind += answer && !meets;
  lost += !answer && meets;
}
console.log(`${said} rays are said to meet the box, ${behind} of them have it behind them; ${lost} that meet it are not`);
process.exit(point !== null && point[1] === -1 && distance === -5 && behind === 5712 && said === 11424 && lost === 0 ? 0 : 1);
JS
node try.js
