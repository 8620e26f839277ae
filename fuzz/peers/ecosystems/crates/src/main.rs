//! Libraries of crates.io, asked by graze-fuzz about boxes: crates_adapter LIBRARY (run.py builds and runs).
use std::io::{self, BufRead, Write};

type Vec3 = [f64; 3];

struct Request {
    origin: Vec3,
    direction: Vec3,
    boxes: Vec<(Vec3, Vec3)>,
}

fn listed(hits: impl Iterator<Item = bool>) -> String {
    let places = hits.enumerate().filter(|(_, hit)| *hit).map(|(i, _)| i.to_string());
    places.collect::<Vec<_>>().join(" ")
}

fn received(origin: Vec3, direction: Vec3) -> String {
    let words = origin.iter().chain(&direction).map(|x| format!(" {:016x}", x.to_bits()));
    " received".to_string() + &words.collect::<String>()
}

fn parry_box((lo, hi): &(Vec3, Vec3)) -> parry3d_f64::bounding_volume::Aabb {
    parry3d_f64::bounding_volume::Aabb::new((*lo).into(), (*hi).into())
}

fn parry(r: &Request) -> String {
    use parry3d_f64::query::{Ray, RayCast};
    let ray = Ray::new(r.origin.into(), r.direction.into());
    listed(r.boxes.iter().map(|b| parry_box(b).cast_local_ray(&ray, f64::INFINITY, true).is_some()))
}

fn parry_bvh(r: &Request) -> String {
    use parry3d_f64::{partitioning::{Bvh, BvhBuildStrategy}, query::{Ray, RayCast}};
    let ray = Ray::new(r.origin.into(), r.direction.into());
    let boxes: Vec<_> = r.boxes.iter().map(parry_box).collect();
    let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
    let hit = tree.cast_ray(&ray, f64::INFINITY, |i, best| boxes[i as usize].cast_local_ray(&ray, best, true));
    hit.map_or("none".to_string(), |(i, t)| format!("{i} t {:016x}", t.to_bits()))
}

struct Shape(bvh::aabb::Aabb<f64, 3>, usize, usize); // its box, its place in the list and in the tree
impl bvh::aabb::Bounded<f64, 3> for Shape {
    fn aabb(&self) -> bvh::aabb::Aabb<f64, 3> {
        self.0
    }
}
impl bvh::bounding_hierarchy::BHShape<f64, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.2 = index;
    }
    fn bh_node_index(&self) -> usize {
        self.2
    }
}

fn bvh_tree(r: &Request) -> String {
    let ray = bvh::ray::Ray::new(r.origin.into(), nalgebra::SVector::from(r.direction));
    let mut shapes: Vec<_> = r.boxes.iter().enumerate()
        .map(|(i, b)| Shape(bvh::aabb::Aabb::with_bounds(b.0.into(), b.1.into()), i, 0)).collect();
    let tree = bvh::bvh::Bvh::build(&mut shapes);
    let mut hits: Vec<_> = tree.traverse(&ray, &shapes).iter().map(|s| s.1.to_string()).collect();
    hits.sort();
    hits.join(" ") + &received(ray.origin.into(), ray.direction.into())
}

fn collision_crate(r: &Request) -> String {
    use collision::{prelude::*, Aabb3, Ray3};
    use cgmath::{Point3, Vector3};
    let ray = Ray3::new(Point3::from(r.origin), Vector3::from(r.direction));
    listed(r.boxes.iter().map(|b| Aabb3::new(Point3::from(b.0), Point3::from(b.1)).intersects(&ray)))
}

fn obvhs_crate(r: &Request) -> String {
    let float = |v: Vec3| glam::Vec3A::new(v[0] as f32, v[1] as f32, v[2] as f32);
    if r.direction.iter().any(|d| *d == 0.0 || d.abs() < f32::MIN_POSITIVE.into()) {
        return "skip".to_string(); // it moves such directions
    }
    let ray = obvhs::ray::Ray::new_inf(float(r.origin), float(r.direction));
    listed(r.boxes.iter().map(|b| obvhs::aabb::Aabb::new(float(b.0), float(b.1)).intersect_ray(&ray) < f32::INFINITY))
}

fn main() {
    let (hello, answer): (_, fn(&Request) -> String) = match std::env::args().nth(1).unwrap_or_default().as_str() {
        "parry3d-f64" => ("promise crossed", parry),
        "parry3d-f64-bvh" => ("promise first", parry_bvh),
        "bvh" => ("promise crossed", bvh_tree),
        "collision" => ("promise crossed", collision_crate),
        "obvhs" => ("promise crossed float true", obvhs_crate),
        _ => panic!("usage: crates_adapter LIBRARY"),
    };
    println!("{hello} cells boxes numbers bits echo true");
    for line in io::stdin().lock().lines().map_while(Result::ok) {
        let (line, echo) = line.split_once(" echo ").unwrap_or((&line, ""));
        let words: Vec<&str> = line.split(' ').collect(); // id "boxes" origin direction count lo hi lo hi ...
        let double = |i: usize| f64::from_bits(u64::from_str_radix(words[i], 16).unwrap());
        let vec3 = |i: usize| [double(i), double(i + 1), double(i + 2)];
        let boxes = (9..words.len()).step_by(6).map(|i| (vec3(i), vec3(i + 3))).collect();
        let mut said = answer(&Request { origin: vec3(2), direction: vec3(5), boxes });
        if !echo.is_empty() {
            let read = echo.split(' ').map(|w| f64::from_bits(u64::from_str_radix(w, 16).unwrap()));
            said += &read.fold(" echo".to_string(), |text, x| format!("{text} {:016x}", x.to_bits()));
        }
        println!("{said}");
        io::stdout().flush().unwrap();
    }
}
