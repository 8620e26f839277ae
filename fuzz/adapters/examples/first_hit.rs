// First hits through a bounding volume tree over boxes, as it is usually written, for graze-fuzz to look
// at. It reads the plain form in bits: no crate, and every double is exact.
//
//   rustc -O first_hit.rs && graze-fuzz run --command ./first_hit
use std::io::{self, BufRead, Write};

type Vec3 = [f64; 3];
type Box3 = (Vec3, Vec3);

/// Where the ray o + t d, t >= 0, enters the box.
fn hit(o: Vec3, d: Vec3, (lo, hi): Box3) -> Option<f64> {
    let (mut enter, mut leave) = (0.0f64, f64::INFINITY);
    for a in 0..3 {
        let (t0, t1) = ((lo[a] - o[a]) / d[a], (hi[a] - o[a]) / d[a]);
        enter = enter.max(t0.min(t1)); // min and max pass over the NaN of 0/0
        leave = leave.min(t0.max(t1));
    }
    (enter <= leave).then_some(enter)
}

/// The first of these boxes that the ray hits, and where.
fn first(o: Vec3, d: Vec3, boxes: &[(usize, Box3)], best: &mut Option<(usize, f64)>) {
    let mut all = boxes[0].1;
    for (_, b) in boxes {
        for a in 0..3 {
            all.0[a] = all.0[a].min(b.0[a]);
            all.1[a] = all.1[a].max(b.1[a]);
        }
    }
    match hit(o, d, all) {
        Some(t) if best.is_none_or(|(_, sooner)| t < sooner) && boxes.len() == 1 => *best = Some((boxes[0].0, t)),
        Some(t) if best.is_none_or(|(_, sooner)| t < sooner) => {
            first(o, d, &boxes[..boxes.len() / 2], best);
            first(o, d, &boxes[boxes.len() / 2..], best);
        }
        _ => (),
    }
}

fn main() {
    println!("promise first cells boxes numbers bits echo true");
    for line in io::stdin().lock().lines().map_while(Result::ok) {
        let (line, echo) = line.split_once(" echo ").unwrap_or((&line, ""));
        let words: Vec<&str> = line.split(' ').collect(); // id "boxes" origin direction count lo hi lo hi ...
        let double = |i: usize| f64::from_bits(u64::from_str_radix(words[i], 16).unwrap());
        let vec3 = |i: usize| [double(i), double(i + 1), double(i + 2)];
        let boxes: Vec<_> = (9..words.len()).step_by(6).map(|i| (i / 6 - 1, (vec3(i), vec3(i + 3)))).collect();
        let mut best = None;
        first(vec3(2), vec3(5), &boxes, &mut best);
        let mut answer = best.map_or("none".to_string(), |(i, t)| format!("{i} t {:016x}", t.to_bits()));
        if !echo.is_empty() {
            let read = echo.split(' ').map(|w| f64::from_bits(u64::from_str_radix(w, 16).unwrap()));
            answer += &read.fold(" echo".to_string(), |text, x| format!("{text} {:016x}", x.to_bits()));
        }
        println!("{answer}");
        io::stdout().flush().unwrap();
    }
}
