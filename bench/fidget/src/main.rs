//! fidget's height map of a surface, orthographic: seconds on one thread and the depth of each pixel.
//!
//! usage: graze-fidget tanglecube|quartdef SIZE REPETITIONS DEPTHS
//! Prints JSON: the seconds of each repetition after a warm-up, in which the shape is rendered by JIT
//! into SIZE x SIZE pixels of SIZE voxels each; compiling the formula is not in them. DEPTHS: a file,
//! written with a u32 a pixel, row by row, in voxels from the back, 0 where nothing was hit.
use fidget::context::Tree;
use fidget::jit::JitShape;
use fidget::raster::voxel::{EvalConfig, RenderConfig, RenderSize, render};
use std::{env, fs, process, time::Instant};

/// The formula over [-1,1]^3, which is scaled to the scene's domain, and half of the domain's side.
fn surface(name: &str) -> Option<(Tree, f32)> {
    let axes = [Tree::x(), Tree::y(), Tree::z()];
    match name {
        "tanglecube" => {
            let [x, y, z] = axes.map(|a| a.square().square() - 5.0 * a.square());
            Some((x + y + z + 11.8, 2.5))
        }
        "quartdef" => {
            let [x, y, z] = axes.map(|a| (a.square() - 1.0).square());
            Some((x + y + z - 1.0, 1.5))
        }
        _ => None,
    }
}

fn main() {
    let arguments: Vec<String> = env::args().collect();
    let parsed = (|| {
        let size: u32 = arguments.get(2)?.parse().ok()?;
        let repetitions: usize = arguments.get(3)?.parse().ok()?;
        Some((surface(arguments.get(1)?)?, size, repetitions, arguments.get(4)?))
    })();
    let Some(((tree, half), size, repetitions, depths)) = parsed else {
        eprintln!("usage: graze-fidget tanglecube|quartdef SIZE REPETITIONS DEPTHS");
        process::exit(2);
    };
    let shape = JitShape::from(tree);
    let mut config = RenderConfig::from_size(RenderSize::new(size, size, size));
    config.world_to_model.append_scaling_mut(half);
    let one_thread = EvalConfig { threads: None, ..Default::default() };
    let mut seconds = Vec::new();
    let mut image = None;
    for repetition in 0..=repetitions {
        let bound = shape.clone().try_into().expect("no variables but x, y, z");
        let start = Instant::now();
        image = render(bound, &config, &one_thread);
        if repetition > 0 {
            seconds.push(start.elapsed().as_secs_f64());
        }
    }
    let image = image.expect("not cancelled");
    let bytes: Vec<u8> = image.iter().flat_map(|p| p.depth.to_le_bytes()).collect();
    if let Err(why) = fs::write(depths, bytes) {
        eprintln!("graze-fidget: {depths}: {why}");
        process::exit(1);
    }
    println!("{{\"scene\": \"{}\", \"size\": {size}, \"seconds\": {seconds:?}}}", arguments[1]);
}
