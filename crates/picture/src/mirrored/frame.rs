//! One frame of the mirror: the scenes of the eyes and the warp that brings them to the device.

use std::sync::Arc;

use glam::{DMat3, DVec2};
use saute_scene::input::{MirrorLook, SceneInput};
use saute_scene::quality::Quality;

use saute_mirror::options::MirrorOptions;
use saute_mirror::rig::Rig;
use saute_mirror::stereo::{Stereo, anaglyph};
use saute_mirror::warp::Warp;

/// Input of the mirror's renderers.
#[derive(Clone, Debug)]
pub struct MirrorFrame {
    /// The scene as each eye sees it: one, or the left and the right one.
    pub eyes: Vec<Arc<SceneInput>>,
    /// Size of each eye's picture [pixels].
    pub size: [u32; 2],
    /// Rendering quality.
    pub quality: Quality,
    /// From the device to the pictures.
    pub warp: WarpUniform,
}

/// The longest side of an eye's picture [pixels] (chosen: WebGL2 guarantees 2048).
pub const LONGEST: f64 = 2048.0;

/// Mirrors `Warp` in `mirror.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct WarpUniform {
    columns: [[f32; 4]; 3],
    lens: [f32; 4],
    scale: [f32; 4],
    anaglyph: [[f32; 4]; 3],
}

impl WarpUniform {
    /// The warp for a device of a size [pixels].
    pub fn new(warp: &Warp, device: DVec2, stereo: Stereo) -> Self {
        let from_shares = warp.keystone.inverse() * DMat3::from_diagonal(device.extend(1.0));
        let columns = [from_shares.x_axis, from_shares.y_axis, from_shares.z_axis];
        let (centre, scale) = (warp.lens.centre / device, device / warp.lens.unit);
        let [left, right] = anaglyph();
        let rows = [left.row(0), right.row(1), right.row(2)];
        let four = |v: [f64; 3]| [v[0] as f32, v[1] as f32, v[2] as f32, 0.0];
        Self {
            columns: columns.map(|c| four(c.to_array())),
            lens: [centre.x, centre.y, warp.lens.k[0], warp.lens.k[1]].map(|v| v as f32),
            scale: four([scale.x, scale.y, f64::from(stereo as u8)]),
            anaglyph: rows.map(|row| four(row.to_array())),
        }
    }
}

impl MirrorFrame {
    /// A scene as the eyes of a rig see it, for a device of a size [pixels].
    pub fn new(
        scene: &SceneInput,
        rig: &Rig,
        warp: &Warp,
        options: &MirrorOptions,
        device: DVec2,
        quality: Quality,
    ) -> Self {
        let eyes = options.stereo.eyes(rig, options.eye_distance).into_iter().map(|eye| {
            let look = MirrorLook {
                eye: rig.eye_in_kitchen(eye).as_vec3(),
                clip_from_world: rig.view_projection(eye).as_mat4(),
                pan_shown: options.pan_shown,
            };
            Arc::new(SceneInput { mirror: Some(look), flat: false, ..scene.clone() })
        });
        Self {
            eyes: eyes.collect(),
            size: rig.picture_size(device, LONGEST),
            quality,
            warp: WarpUniform::new(warp, device, options.stereo),
        }
    }
}
