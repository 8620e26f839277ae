#!/bin/sh
# The crate parry3d-f64 casts rays at boxes (Cuboid) and at sets of voxels (Voxels). A ray that starts on the
# upper face of a box and points into it hits it at 0: the Cuboid says so. Of one voxel of the same size the
# answer depends on the size: 2 x 2 x 3 is hit, 2 x 2 x 3.2 is not hit at all, although the ray runs through
# all of it. The faces are the same doubles.
#
# With voxels of side 0.1, at the top of voxel k - 1, k * 0.1 as doubles: 176 of 1,000 such rays downward give
# nothing, of the rays upward from the lower faces none. With sides of 1 and 0.5 all are hit.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
cd "$d"
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "from-face"
version = "0.1.0"
edition = "2021"
[dependencies]
parry3d-f64 = "=0.31.1"
TOML
cat > src/main.rs <<'RS'
use parry3d_f64::math::{IVector, Vector};
use parry3d_f64::query::{Ray, RayCast};
use parry3d_f64::shape::{Cuboid, Voxels};

fn ray(x: f64, z: f64, dz: f64) -> Ray {
    Ray::new(Vector::new(x, x, z), Vector::new(0.0, 0.0, dz))
}

fn main() {
    let mut right = true;
    for (height, hit) in [(3.0, true), (3.2, false)] {
        let voxels = Voxels::new(Vector::new(2.0, 2.0, height), &[IVector::new(0, 0, 0)]);
        let cuboid = Cuboid::new(Vector::new(1.0, 1.0, height / 2.0)); // about 0
        let v = voxels.cast_local_ray(&ray(1.0, height, -1.0), f64::MAX, true);
        let c = cuboid.cast_local_ray(&ray(0.0, height / 2.0, -1.0), f64::MAX, true);
        println!("2 x 2 x {height}, from its upper face downward: voxel {v:?}, cuboid {c:?}");
        right = right && v.is_some() == hit && c == Some(0.0);
    }
    for (side, none) in [(1.0, 0), (0.5, 0), (0.1, 176)] {
        let (mut down, mut up) = (0, 0);
        for k in 1..=1000i64 {
            let voxel = Voxels::new(Vector::new(side, side, side), &[IVector::new(0, 0, k - 1)]);
            let (lower, upper) = ((k - 1) as f64 * side, k as f64 * side);
            let lost = |r: Ray| voxel.cast_local_ray(&r, f64::MAX, true).is_none() as i32;
            down += lost(ray(side / 2.0, upper, -1.0));
            up += lost(ray(side / 2.0, lower, 1.0));
        }
        println!("side {side}: {down} of 1000 rays from upper faces downward give nothing, {up} from lower faces upward");
        right = right && down == none && up == 0;
    }
    std::process::exit(if right { 0 } else { 1 });
}
RS
echo "parry3d-f64 0.31.1"
cargo run --release --quiet
