//! Steam, smoke and flames: puffs that rise, widen and vanish, as functions of time alone.

use std::f32::consts::{PI, TAU};

use glam::Vec3;

use crate::input::{SteamSource, Vapour};

/// Puffs in the whole picture, at most.
pub(crate) const PUFFS_MAX: usize = 48;

/// How what rises looks (chosen by eye: steam thin and quick, smoke slow and blue, flames short).
struct Manner {
    /// Puffs of one source, at most.
    puffs: usize,
    /// Time from the surface to nothing [s].
    life: f32,
    /// Height reached [m].
    rise: f32,
    /// Flow at which a source with all its puffs is at its densest [g/s]; below it what is seen is in proportion.
    dense: f32,
    /// Half size when it begins and when it ends [m].
    half_size: [f32; 2],
    opacity: f32,
    /// Marks it for the shader: added to the random value.
    mark: f32,
}

impl Manner {
    fn of(kind: Vapour) -> Self {
        match kind {
            Vapour::Steam => Self {
                puffs: 2,
                life: 1.3,
                rise: 0.24,
                dense: 0.022,
                half_size: [0.013, 0.050],
                opacity: 0.40,
                mark: 0.0,
            },
            Vapour::Smoke => Self {
                puffs: 4,
                life: 2.2,
                rise: 0.30,
                dense: 0.0015,
                half_size: [0.014, 0.048],
                opacity: 0.30,
                mark: 2.0,
            },
            Vapour::Flame => Self {
                puffs: 2,
                life: 0.55,
                rise: 0.16,
                dense: 1e-6,
                half_size: [0.030, 0.012],
                opacity: 0.85,
                mark: 4.0,
            },
        }
    }

    /// Opacity of each of `count` puffs at the middle of their lives.
    fn opacity(&self, flow: f32, count: usize) -> f32 {
        let share = flow / self.dense * self.puffs as f32 / count as f32;
        (self.opacity * share).min(0.9)
    }
}

/// Puffs fainter than this are not drawn [-] (chosen: invisible; two steps of 8-bit colour).
const FAINTEST: f32 = 0.008;

/// Corners of a sprite, two triangles.
pub(crate) const CORNERS: [[f32; 2]; 6] =
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Corner of a puff's sprite.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct PuffVertex {
    pub position: [f32; 3],
    pub corner: [f32; 2],
    pub half_size: f32,
    pub opacity: f32,
    pub random: f32,
}

/// Sprites of all sources, six vertices each. Flames come first: a fire is always seen.
pub(crate) fn puffs(sources: &[SteamSource], time: f32) -> Vec<PuffVertex> {
    let mut vertices = Vec::new();
    // With many sources each one has fewer puffs; their opacity stays in proportion to the flow.
    let most = PUFFS_MAX / sources.len().max(1);
    let mut ordered: Vec<(usize, &SteamSource)> = sources.iter().enumerate().collect();
    ordered.sort_by_key(|(_, source)| source.kind != Vapour::Flame);
    for (seed, source) in ordered.into_iter().take(PUFFS_MAX) {
        let manner = Manner::of(source.kind);
        let count = most.clamp(1, manner.puffs);
        let opacity = manner.opacity(source.flow_g_s, count);
        if opacity < FAINTEST {
            continue;
        }
        for k in 0..count {
            push_puff(&mut vertices, source, &manner, (k as f32 / count as f32, opacity), (seed * 37 + k) as f32, time);
        }
    }
    vertices
}

fn push_puff(
    vertices: &mut Vec<PuffVertex>,
    source: &SteamSource,
    manner: &Manner,
    (offset, densest): (f32, f32),
    seed: f32,
    time: f32,
) {
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
    let opacity = densest * (PI * age.powf(0.6)).sin();
    let [young, old] = manner.half_size;
    let half_size = young + (old - young) * age + 0.15 * source.radius;
    for corner in CORNERS {
        vertices.push(PuffVertex {
            position: position.to_array(),
            corner,
            half_size,
            opacity,
            random: random(5.0).min(0.999) + manner.mark,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(sources: &[SteamSource]) -> f32 {
        // The mean over a puff's life.
        let times = (0..30).map(|k| k as f32 * 0.03);
        times.map(|time| puffs(sources, time).iter().map(|v| v.opacity).sum::<f32>()).sum()
    }

    #[test]
    fn flames_are_seen_however_much_steam_there_is() {
        let source = |kind| SteamSource { kind, position: Vec3::ZERO, radius: 0.02, flow_g_s: 1.0 };
        let mut sources = vec![source(Vapour::Steam); 3 * PUFFS_MAX];
        sources.extend([source(Vapour::Flame); 3]);
        let drawn = puffs(&sources, 0.2);
        let flames = drawn.iter().filter(|v| v.random >= Manner::of(Vapour::Flame).mark).count();
        assert_eq!((flames, drawn.len()), (3 * 6, PUFFS_MAX * 6));
    }

    #[test]
    fn what_is_seen_of_steam_is_in_proportion_to_its_flow() {
        for count in [1, 7, 40] {
            let cook = |total: f32| {
                let flow = |k: usize| total * (1.0 + (k % 3) as f32) / (2.0 * count as f32);
                let at = |k: usize| SteamSource {
                    kind: Vapour::Steam,
                    position: Vec3::ZERO,
                    radius: 0.02,
                    flow_g_s: flow(k),
                };
                drawn(&(0..count).map(at).collect::<Vec<_>>())
            };
            let flows = [0.02, 0.04, 0.08, 0.16, 0.30].map(|total| total * (count as f32).min(7.0) / 7.0);
            let seen = flows.map(cook);
            let mean = |v: &[f32; 5]| v.iter().sum::<f32>() / 5.0;
            let (f, s) = (mean(&flows), mean(&seen));
            let along = |a: &[f32; 5], b: &[f32; 5], m: f32, n: f32| {
                a.iter().zip(b).map(|(x, y)| (x - m) * (y - n)).sum::<f32>()
            };
            let r = along(&flows, &seen, f, s) / (along(&flows, &flows, f, f) * along(&seen, &seen, s, s)).sqrt();
            assert!(r > 0.99, "{count} sources: r = {r}, {seen:?}");
        }
    }
}
