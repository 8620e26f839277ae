// A recursive octree walk with a slab test at each octant (Smits 1998, as it is often copied), for
// graze-fuzz to look at:
//
//   graze-fuzz run --level 10 --command "node octree_slabs.mjs"
import { createInterface } from 'node:readline';

function meets(origin, direction, lo, size) {
  let enter = 0, leave = Infinity;
  for (let a = 0; a < 3; ++a) {
    const t0 = (lo[a] - origin[a]) / direction[a], t1 = (lo[a] + size - origin[a]) / direction[a];
    enter = Math.max(enter, Math.min(t0, t1));
    leave = Math.min(leave, Math.max(t0, t1));
  }
  return enter <= leave; // false for the NaN of 0/0: Math.max and Math.min keep it
}

// The octants of level `left` below this one that hold occupied voxels and are met.
function walk(ray, index, lo, size, left, out) {
  for (let a = 0; a < 3; ++a) { // the voxels of this octant, and those that are occupied
    const first = index[a] * 2 ** left;
    if (ray.base[a] >= first + 2 ** left || ray.base[a] + ray.extent[a] <= first) return;
  }
  if (!meets(ray.origin, ray.direction, lo, size)) return;
  if (left === 0) return void out.push(index);
  for (let child = 0; child < 8; ++child) {
    const side = [child & 1, child >> 1 & 1, child >> 2];
    walk(ray, index.map((i, a) => 2 * i + side[a]), lo.map((x, a) => x + side[a] * size / 2),
         size / 2, left - 1, out);
  }
}

function answer(ray) {
  const visited = [];
  walk(ray, [0, 0, 0], ray.root.lo, ray.root.size, ray.level, visited);
  const echo = ray.echo?.map(x => Object.is(x, -0) ? '-0' : x); // JSON.stringify drops the sign
  return { visited, echo };
}

console.log('{"promise":"crossed","batch":64}'); // many requests a message: fewer turns to and fro
for await (const line of createInterface({ input: process.stdin }))
  console.log(JSON.stringify({ answers: JSON.parse(line).batch.map(answer) }));
