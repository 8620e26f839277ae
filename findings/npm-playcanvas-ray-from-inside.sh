#!/bin/sh
# PlayCanvas' BoundingBox.intersectsRay(ray, point) says whether a ray meets a box; where `point` is given,
# the point of intersection is copied into it. That parameter changes the answer: for every ray that starts
# within the box it is true without a point, and false with one.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
cd "$d"
npm init -y > npm.log
npm install --silent --no-audit --no-fund playcanvas@2.23.3 >> npm.log
cat > try.mjs <<'JS'
import { BoundingBox, Ray, Vec3, version } from 'playcanvas';
console.log('PlayCanvas', version);
const box = new BoundingBox(new Vec3(0, 0, 0), new Vec3(1, 1, 1));
const ray = new Ray(new Vec3(0, 0, 0), new Vec3(0, 0, 1));
const [without, within] = [box.intersectsRay(ray), box.intersectsRay(ray, new Vec3())];
console.log(`from the middle of [-1, 1]^3: intersectsRay(ray) ${without}, intersectsRay(ray, point) ${within}`);
// Origins in quarters, inside and outside (not on the surface); directions along one axis, which pass faces only.
const counts = { inside: [0, 0], outside: [0, 0] };
for (let n = 0; n < 15 ** 3; ++n)
  for (let k = 0; k < 6; ++k) {
    const o = [0, 1, 2].map(a => (Math.floor(n / 15 ** a) % 15 - 7) / 4);
    if (o.some(x => Math.abs(x) === 1)) continue;
    const d = [0, 0, 0];
    d[k >> 1] = k & 1 ? 1 : -1;
    const r = new Ray(new Vec3(...o), new Vec3(...d));
    const row = counts[o.every(x => Math.abs(x) < 1) ? 'inside' : 'outside'];
    ++row[0];
    row[1] += box.intersectsRay(r) !== box.intersectsRay(r, new Vec3());
  }
for (const [where, [rays, differ]] of Object.entries(counts))
  console.log(`${rays} rays from ${where}: the two answers differ on ${differ}`);
process.exit(without && !within && counts.inside[0] === counts.inside[1] && counts.outside[1] === 0 ? 0 : 1);
JS
node try.mjs
