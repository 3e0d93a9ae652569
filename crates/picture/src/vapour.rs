//! Sources of steam, smoke and flames as the renderer's input.

use glam::{Vec2, Vec3};
use saute_kitchen::{Kitchen, Piece, Place};
use saute_scene::input::{SteamSource, Vapour};

use crate::pose::Pose;
use crate::stage::ALWAYS_FRESH;

/// Vapour leaves round the lower rim of a frying piece and from its upper face; of many pieces each has fewer sources.
pub(crate) fn steam(kitchen: &Kitchen, pan: &Pose, poses: &[Pose]) -> Vec<SteamSource> {
    let mut sources = Vec::new();
    let fries = |p: &Piece| p.place != Place::Waiting && p.vapour_flow > 0.0;
    let frying = kitchen.pieces().iter().zip(poses).filter(|(p, _)| fries(p));
    // Pieces with negligible vapour need no sources.
    let most = kitchen.pieces().iter().map(|p| p.vapour_flow).fold(0.0, f64::max);
    let around = match kitchen.pieces().iter().filter(|p| fries(p) && p.vapour_flow > 0.1 * most).count() {
        0..=ALWAYS_FRESH => 6u8,
        7..=20 => 1,
        _ => 0,
    };
    for (piece, pose) in frying {
        let around = if piece.vapour_flow > 0.1 * most { around } else { 0 };
        let [a, b] = [0.45 * piece.model.size()[0] as f32, 0.45 * piece.model.size()[1] as f32];
        let share = 1e3 * piece.vapour_flow as f32 / f32::from(around + 1);
        for k in 0..around {
            let angle = f32::from(k) * std::f32::consts::TAU / 6.0 + 0.4;
            let position = pose.position + Vec3::new(a * angle.cos(), b * angle.sin(), 0.0);
            sources.push(SteamSource { kind: Vapour::Steam, position, radius: 0.015f32.min(0.5 * b), flow_g_s: share });
        }
        let top = pose.position + Vec3::Z * 0.5 * piece.model.thickness(&piece.state) as f32;
        sources.push(SteamSource { kind: Vapour::Steam, position: top, radius: 0.5 * b, flow_g_s: share });
    }
    let (puddle, cloth) = kitchen.other_vapour();
    if puddle + cloth > 1e-6 {
        let flow_g_s = 1e3 * (puddle + 0.3 * cloth) as f32;
        sources.push(SteamSource {
            kind: Vapour::Steam,
            position: pan.position + Vec3::Z * 0.01,
            radius: 0.09,
            flow_g_s,
        });
    }
    sources.extend(smoke(kitchen, pan));
    sources
}

/// Smoke from which on it rises from six places [g/s] (chosen: thin smoke looks the same from three, and each costs every frame).
const BROAD_SMOKE: f32 = 0.015;

/// Smoke and flames rise from the whole film of oil.
fn smoke(kitchen: &Kitchen, pan: &Pose) -> Vec<SteamSource> {
    let state = kitchen.pan_state();
    let rate = 1e-3 * state.smoke_mg_s() as f32;
    let radius = 0.4e-3 * kitchen.pan_model().description.floor.radius_mm as f32;
    let place = |kind: Vapour, k: u8, flow_g_s: f32| {
        let around = Vec2::from_angle(f32::from(k) * std::f32::consts::TAU / 6.0 + 0.7) * radius * 1.3;
        let position = pan.position + pan.rotation * around.extend(0.012);
        SteamSource { kind, position, radius, flow_g_s }
    };
    // The height of flames does not follow from the smoke.
    let flames = (0..6u8).step_by(2).filter(|_| state.liquids.smoke.burning).map(|k| place(Vapour::Flame, k, 1.0));
    let apart = if rate < BROAD_SMOKE { 2 } else { 1 };
    let share = rate * apart as f32 / 6.0;
    let wisps = (0..6u8).step_by(apart).filter(|_| rate > 1e-5).map(|k| place(Vapour::Smoke, k, share));
    flames.chain(wisps).collect()
}
