//! Steam, smoke and flames: puffs that rise, widen and vanish, as functions of time alone.

use std::f32::consts::{PI, TAU};

use glam::Vec3;

use super::input::{SteamSource, Vapour};

/// Puffs in the whole picture, at most.
pub(super) const PUFFS_MAX: usize = 56;

/// How what rises looks (chosen by eye: steam thin and quick, smoke slow and blue, flames short).
struct Manner {
    /// Time from the surface to nothing [s].
    life: f32,
    /// Height reached [m].
    rise: f32,
    /// Flow at which a source is at its densest [g/s].
    dense: f32,
    /// Half size when it begins and when it ends [m].
    half_size: [f32; 2],
    opacity: f32,
    /// What the shader knows it by: added to the random value.
    mark: f32,
}

impl Manner {
    fn of(kind: Vapour) -> Self {
        match kind {
            Vapour::Steam => {
                Self { life: 0.9, rise: 0.20, dense: 0.25, half_size: [0.012, 0.042], opacity: 0.24, mark: 0.0 }
            }
            Vapour::Smoke => {
                Self { life: 2.2, rise: 0.30, dense: 0.004, half_size: [0.014, 0.070], opacity: 0.30, mark: 2.0 }
            }
            Vapour::Flame => {
                Self { life: 0.55, rise: 0.16, dense: 1e-6, half_size: [0.030, 0.012], opacity: 0.85, mark: 4.0 }
            }
        }
    }

    /// Flow from which a source is to be seen [g/s].
    fn least(&self) -> f32 {
        0.008 * self.dense
    }
}

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
    for (seed, source) in sources.iter().enumerate() {
        let manner = Manner::of(source.kind);
        if source.flow_g_s < manner.least() && source.kind != Vapour::Flame {
            continue;
        }
        let count = (2.0 + 5.5 * source.flow_g_s / manner.dense).min(9.0) as usize;
        for k in 0..count {
            if vertices.len() >= PUFFS_MAX * 6 {
                return vertices;
            }
            push_puff(&mut vertices, source, &manner, k as f32 / count as f32, (seed * 37 + k) as f32, time);
        }
    }
    vertices
}

fn push_puff(vertices: &mut Vec<PuffVertex>, source: &SteamSource, manner: &Manner, offset: f32, seed: f32, time: f32) {
    let turn = time / manner.life + offset;
    let age = turn.rem_euclid(1.0);
    let random = |k: f32| ((turn.floor() * 12.9898 + seed * 78.233 + k * 37.719).sin() * 43_758.547).rem_euclid(1.0);
    let around = random(1.0) * TAU;
    let reach = source.radius * random(2.0).sqrt() * 0.8;
    let sway = 0.018 * age * ((age * 4.0 + random(3.0) * TAU).sin() + 0.6);
    let position = source.position
        + Vec3::new(
            around.cos() * reach + sway,
            around.sin() * reach + sway * 0.6,
            0.004 + manner.rise * age * (0.8 + 0.4 * random(4.0)),
        );
    let strength = (source.flow_g_s / manner.dense).sqrt().min(1.0);
    let opacity = manner.opacity * strength * (PI * age.powf(0.6)).sin();
    let [young, old] = manner.half_size;
    let half_size = young + (old - young) * age + 0.15 * source.radius;
    for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        vertices.push(PuffVertex {
            position: position.to_array(),
            corner: [x, y],
            half_size,
            opacity,
            random: random(5.0).min(0.999) + manner.mark,
        });
    }
}
