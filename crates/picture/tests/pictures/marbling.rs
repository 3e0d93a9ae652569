//! Promise: the marbling that is seen is the marbling that conducts: a node contains as much fat as the picture shows in
//! its volume, and a piece as much as its description states.

use saute_fixtures::campaign::pairs;
use saute_kitchen::food::FoodModel;
use saute_kitchen::{Kitchen, Library, Piece};
use saute_picture::skin::surface::Skin;
use saute_recipe::Recipe;
use saute_scene::input::{GrainVolume, WITHIN_RANGE};

/// Places along each side of a triangle at which the picture is read, and how many are on each other in every half of
/// a layer (chosen: 0.2 mm apart and less, where seams are some 0.5 to 1 mm wide; with half as many a node is off by 0.030).
const ALONG: usize = 26;
const UPWARDS: usize = 3;
/// Largest difference in share of fat [-].
const MOST: f64 = 0.02;

fn steak(kind: &str, outline: &str, seed: u64) -> Kitchen {
    let library = Library::embedded().expect("embedded data");
    let food = format!("id = \"s\"\nkind = \"{kind}\"\noutline = \"{outline}\"\nseed = {seed}\n");
    let text = format!("[[food]]\n{food}[[step]]\nafter_s = 1\nend = true\n");
    Recipe::parse(&text, "marbling.toml", &library).expect("parses").kitchen(&library).expect("sets out")
}

/// Depth within a seam as the sampler of the shader reads it: linear between the middles of cells.
fn within(grain: &GrainVolume, p: [f64; 3]) -> f64 {
    let (mut near, mut share) = ([[0usize; 2]; 3], [0.0; 3]);
    for k in 0..3 {
        let last = f64::from(grain.size[k] - 1);
        let place = (p[k] - f64::from(grain.origin[k])) / f64::from(grain.extent[k]) * f64::from(grain.size[k]) - 0.5;
        near[k] = [place.floor(), place.floor() + 1.0].map(|v| v.clamp(0.0, last) as usize);
        share[k] = place - place.floor();
    }
    let [nx, ny] = [grain.size[0] as usize, grain.size[1] as usize];
    let mut sum = 0.0;
    for corner in 0..8usize {
        let side = [corner & 1, corner >> 1 & 1, corner >> 2];
        let weight: f64 = (0..3).map(|k| if side[k] == 1 { share[k] } else { 1.0 - share[k] }).product();
        let at = near[0][side[0]] + nx * (near[1][side[1]] + ny * near[2][side[2]]);
        sum += weight * f64::from(grain.cells[at][0]) / 255.0;
    }
    (sum * 2.0 - 1.0) * f64::from(WITHIN_RANGE)
}

/// Share of fat as `grown` in `flesh.wgsl` makes it.
fn fatty(within: f64) -> f64 {
    let s = (within + 0.5).clamp(0.0, 1.0);
    s * s * (3.0 - 2.0 * s)
}

/// Mean share of fat that is seen in the volume of each node: of each triangle the third that is nearest to the node's
/// corner, half way to the levels next to it.
fn seen(model: &FoodModel, grain: &GrainVolume) -> Vec<f64> {
    let mesh = model.mesh().swept().expect("a slice");
    let mut sums = vec![[0.0; 2]; mesh.node_count()];
    for triangle in &mesh.section.triangles {
        let places = places(triangle.map(|i| mesh.section.points[i as usize]));
        let corners: Vec<[[f64; 3]; 3]> =
            (0..mesh.levels.len()).map(|l| triangle.map(|i| model.rest_position(mesh.node(l, i as usize)))).collect();
        for (level, pair) in corners.windows(2).enumerate() {
            // Layers of unlike height weigh as much as they are high.
            let height = mesh.levels[level + 1] - mesh.levels[level];
            for (share, nearest, area) in &places {
                for layer in 0..2 * UPWARDS {
                    let up = (layer as f64 + 0.5) / (2 * UPWARDS) as f64;
                    let on = |l: usize, axis: usize| (0..3).map(|k| share[k] * pair[l][k][axis]).sum::<f64>();
                    let p = [0, 1, 2].map(|axis| (1.0 - up) * on(0, axis) + up * on(1, axis));
                    let sum = &mut sums[mesh.node(level + layer / UPWARDS, triangle[*nearest] as usize)];
                    sum[0] += area * height * fatty(within(grain, p));
                    sum[1] += area * height;
                }
            }
        }
    }
    sums.into_iter().map(|[sum, weight]| sum / weight).collect()
}

/// Places spread evenly over a triangle as shares of its corners, each with a corner nearest to it and the area that it
/// represents there [m²]; what is on the border between corners belongs to each of them in part.
fn places([a, b, c]: [[f64; 2]; 3]) -> Vec<([f64; 3], usize, f64)> {
    let third = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 6.0;
    let mut found = Vec::new();
    for (i, j) in (0..ALONG).flat_map(|i| (0..ALONG - i).map(move |j| (i, j))) {
        // Thirds of a step: the middle of a small triangle.
        let counts = [3 * (ALONG - i - j) - 2, 3 * i + 1, 3 * j + 1];
        let most = counts.into_iter().max().unwrap_or(0);
        let nearest: Vec<usize> = (0..3).filter(|k| counts[*k] == most).collect();
        let share = counts.map(|n| n as f64 / (3 * ALONG) as f64);
        found.extend(nearest.iter().map(|k| (share, *k, 1.0 / nearest.len() as f64)));
    }
    let total = |corner: usize| found.iter().filter(|f| f.1 == corner).map(|f| f.2).sum::<f64>();
    let totals = [0, 1, 2].map(total);
    found.into_iter().map(|(share, k, part)| (share, k, third * part / totals[k])).collect()
}

/// Largest difference between a node's fat and what is seen, and the shares of both in the whole piece.
fn largest_difference(piece: &Piece) -> (f64, [f64; 2]) {
    let (model, skin) = (&piece.model, Skin::new(piece));
    let seen = seen(model, &skin.mesh.grain);
    let volume = model.mesh().volumes();
    let mean = |field: &[f64]| field.iter().zip(volume).map(|(f, v)| f * v).sum::<f64>() / volume.iter().sum::<f64>();
    let largest = seen.iter().zip(model.adipose()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    (largest, [mean(model.adipose()), mean(&seen)])
}

#[test]
fn each_node_holds_the_fat_that_is_seen_in_its_volume() {
    let pieces = [("beef-marbled", 1), ("beef-marbled", 7), ("beef-marbled", 2013), ("beef-lean", 1)];
    for ((kind, seed), outline) in pairs(&pieces, &["plain", "natural"]) {
        let kitchen = steak(kind, outline, seed);
        let piece = &kitchen.pieces()[0];
        let (largest, [held, shown]) = largest_difference(piece);
        println!("{kind} {outline} {seed}: largest difference {largest:.4}, {held:.4} held, {shown:.4} shown");
        assert!(largest < MOST, "{kind} {outline} {seed}: {largest}");
        assert!((held - shown).abs() < 0.002, "{kind} {outline} {seed}: {held} held, {shown} shown");
        let asked = piece.model.marbling().mean_share();
        if outline == "plain" {
            assert!((held - asked).abs() < MOST, "{kind} {seed}: {held} held, {asked} asked for");
        } else {
            // The fat cap comes on top.
            assert!((0.01..0.10).contains(&(held - asked)), "{kind} {seed}: {held} held, {asked} asked for");
        }
    }
}
