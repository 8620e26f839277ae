// Libraries of npm, asked by graze-fuzz: npm_adapter.mjs LIBRARY (run.py builds and runs).
import { createInterface } from 'node:readline';

const name = process.argv[2];
const boxes = test => r => ({ visited: r.boxes.flatMap((b, i) => (test(r, b) ? [i] : [])) });
const isInside = (p, b) => p.every((x, a) => b.lo[a] <= x && x <= b.hi[a]);
const isFlat = b => b.lo.some((x, a) => x === b.hi[a]);
const corners = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                 [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]];
// Doubles that give the box back without a rounding.
function centreAndHalf(b) {
  const centre = b.lo.map((l, a) => (l + b.hi[a]) / 2), half = centre.map((c, a) => c - b.lo[a]);
  const exact = centre.every((c, a) => c - half[a] === b.lo[a] && c + half[a] === b.hi[a]);
  return exact ? { centre, half } : null;
}

const libraries = {
  three: async () => {
    const { Ray, Box3, Vector3 } = await import('three');
    return [{ promise: 'crossed', cells: 'boxes' }, r => {
      const direction = new Vector3(...r.direction).normalize(); // as its manual asks
      const ray = new Ray(new Vector3(...r.origin), direction);
      const received = { origin: r.origin, direction: direction.toArray() };
      const test = (_, b) => ray.intersectsBox(new Box3(new Vector3(...b.lo), new Vector3(...b.hi)));
      return { ...boxes(test)(r), received };
    }];
  },
  'three-mesh-bvh': async () => {
    const { Ray, Vector3, BufferGeometry, BufferAttribute, DoubleSide } = await import('three');
    const { MeshBVH } = await import('three-mesh-bvh');
    return [{ promise: 'first', cells: 'boxes', float: true }, r => { // its vertices are floats
      // a mesh is met at its surface: what a ray from inside meets first need not be the box that it is in
      if (r.boxes.some(b => isFlat(b) || isInside(r.origin, b))) return { skip: true };
      const at = r.boxes.flatMap(b => [...Array(8).keys()].flatMap(
        k => [0, 1, 2].map(a => (k >> a & 1 ? b.hi : b.lo)[a])));
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(new Float32Array(at), 3));
      geometry.setIndex(r.boxes.flatMap((_, i) => corners.flat().map(k => 8 * i + k)));
      const bvh = new MeshBVH(geometry, { indirect: true });
      const direction = new Vector3(...r.direction).normalize();
      const hit = bvh.raycastFirst(new Ray(new Vector3(...r.origin), direction), DoubleSide);
      return { first: hit ? Math.floor(hit.faceIndex / 12) : null,
               received: { origin: r.origin, direction: direction.toArray() } };
    }];
  },
  'fast-voxel-raycast': async () => {
    const { default: raycast } = await import('fast-voxel-raycast');
    return [{ promise: 'first', cells: 'cube' }, r => {
      const size = r.voxel_size, lo = r.root.lo.map(x => x / size);
      if (Math.log2(size) % 1 !== 0 || !lo.every(Number.isInteger)) return { skip: true };
      const unit = v => v.map(x => x / size); // voxels of edge 1: exact
      let first = null;
      const index = (x, y, z) => [x - lo[0], y - lo[1], z - lo[2]];
      const occupied = (x, y, z) => {
        const v = index(x, y, z);
        if (!v.every((i, a) => r.base[a] <= i && i < r.base[a] + r.extent[a])) return 0;
        first = v;
        return 1;
      };
      const origin = unit(r.origin), d = r.direction, length = Math.hypot(...origin.map((x, a) => x - lo[a] - r.base[a]));
      if (!(length < 2 ** 14)) return { skip: true }; // it walks voxel by voxel
      const norm = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); // as it does
      raycast(occupied, origin, d, length + 16);
      return { first, received: { origin: r.origin, direction: d.map(x => x / norm) } };
    }];
  },
  'ray-aabb-intersection': async () => {
    const { default: intersect } = await import('ray-aabb-intersection');
    return [{ promise: 'crossed', cells: 'boxes' },
            boxes((r, b) => intersect([], r.origin, r.direction, [b.lo, b.hi]) !== null)];
  },
  playcanvas: async () => {
    const { BoundingBox, Ray, Vec3 } = await import('playcanvas');
    return [{ promise: 'crossed', cells: 'boxes' }, r => {
      const all = r.boxes.map(centreAndHalf);
      if (all.includes(null)) return { skip: true };
      const direction = new Vec3(...r.direction).normalize(); // as its manual asks
      const ray = new Ray(new Vec3(...r.origin), direction);
      return { visited: all.flatMap((b, i) =>
        new BoundingBox(new Vec3(...b.centre), new Vec3(...b.half)).intersectsRay(ray) ? [i] : []),
               received: { origin: r.origin, direction: [direction.x, direction.y, direction.z] } };
    }];
  },
};

const [hello, answer] = await libraries[name]();
console.log(JSON.stringify(hello));
for await (const line of createInterface({ input: process.stdin })) {
  const r = JSON.parse(line), echo = r.echo?.map(x => (Object.is(x, -0) ? '-0' : x));
  console.log(JSON.stringify({ ...answer(r), id: r.id, echo }));
}
