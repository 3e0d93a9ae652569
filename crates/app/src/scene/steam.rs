//! Steam: puffs that rise, widen and vanish, as functions of time alone.

use std::f32::consts::{PI, TAU};

use glam::Vec3;

use super::input::SteamSource;

/// Puffs in the whole picture, at most.
pub(super) const PUFFS_MAX: usize = 40;
/// Time from the surface to nothing [s] (chosen: thin and quick).
const LIFE: f32 = 0.9;
/// Height reached [m] (chosen).
const RISE: f32 = 0.20;
/// Flow at which a source's steam is at its densest [g/s] (chosen).
const DENSE_FLOW: f32 = 0.25;

/// Corner of a puff's sprite.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct PuffVertex {
    pub position: [f32; 3],
    pub corner: [f32; 2],
    pub half_size: f32,
    pub opacity: f32,
    pub random: f32,
}

/// Sprites of all sources, six vertices each.
pub(super) fn puffs(sources: &[SteamSource], time: f32) -> Vec<PuffVertex> {
    let mut vertices = Vec::new();
    for (seed, source) in sources.iter().enumerate().filter(|(_, source)| source.flow_g_s > 0.002) {
        let count = (2.0 + 22.0 * source.flow_g_s).min(9.0) as usize;
        for k in 0..count {
            if vertices.len() >= PUFFS_MAX * 6 {
                return vertices;
            }
            push_puff(&mut vertices, source, k as f32 / count as f32, (seed * 37 + k) as f32, time);
        }
    }
    vertices
}

fn push_puff(vertices: &mut Vec<PuffVertex>, source: &SteamSource, offset: f32, seed: f32, time: f32) {
    let turn = time / LIFE + offset;
    let age = turn.rem_euclid(1.0);
    let random = |k: f32| ((turn.floor() * 12.9898 + seed * 78.233 + k * 37.719).sin() * 43_758.547).rem_euclid(1.0);
    let around = random(1.0) * TAU;
    let reach = source.radius * random(2.0).sqrt() * 0.8;
    let sway = 0.018 * age * ((age * 4.0 + random(3.0) * TAU).sin() + 0.6);
    let position = source.position
        + Vec3::new(
            around.cos() * reach + sway,
            around.sin() * reach + sway * 0.6,
            0.004 + RISE * age * (0.8 + 0.4 * random(4.0)),
        );
    let strength = (source.flow_g_s / DENSE_FLOW).sqrt().min(1.0);
    let opacity = 0.24 * strength * (PI * age.powf(0.6)).sin();
    let half_size = 0.012 + 0.030 * age + 0.15 * source.radius;
    for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        vertices.push(PuffVertex {
            position: position.to_array(),
            corner: [x, y],
            half_size,
            opacity,
            random: random(5.0),
        });
    }
}
