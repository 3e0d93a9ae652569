//! Colours measured on flat pictures of a piece.

use std::f64::consts::PI;

use glam::{DQuat, DVec3, Vec3};
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::food::Lab;
use saute_kitchen::{Kitchen, Piece};
use saute_lab::cook_case::SeenAt;
use saute_scene::camera::{Camera, FIELD_OF_VIEW};
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;

use saute_picture::cut::section::Picture;
use saute_picture::stage::{Places, Stage, StageOptions};
use saute_picture::still::headless::Gpu;
use saute_picture::still::shot::ShotOptions;
use saute_picture::view::View;

/// Size of the pictures [px] and distance of the camera [m] (chosen: three pixels per millimetre).
const SIZE: [u32; 2] = [800, 600];
const DISTANCE: f32 = 0.25;
/// Half the measured field over half the length and width of the piece [-], and half its height in a cut [m] (chosen: the
/// middle, where the colour is uniform, as with the aperture of a colorimeter of some 20 mm).
const FIELD: f64 = 0.25;
const CUT_HALF_HEIGHT: f64 = 0.002;
/// Number of readings across the field (chosen).
const READINGS: i32 = 15;

/// Height by which a piece is lifted so that its underside is visible [m] (chosen: clear of the pan).
const LIFT: f64 = 0.15;

/// Measures colours on flat pictures.
pub struct Colorimeter {
    gpu: Gpu,
    renderer: SceneRenderer,
    stage: Stage,
}

impl Colorimeter {
    /// Returns a colorimeter on a graphics adapter.
    pub fn new(gpu: Gpu) -> Self {
        let renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
        Self { gpu, renderer, stage: Stage::default() }
    }

    /// Returns the mean colour of a piece on a flat picture, in the middle of a face or of its cut (CIE L*a*b*).
    pub fn read(&mut self, kitchen: &Kitchen, piece: &Piece, at: SeenAt) -> Lab {
        let options = ShotOptions {
            view: View::Look,
            slice: at == SeenAt::Cut,
            white_balance: Default::default(),
            light: Default::default(),
            photo: Default::default(),
            quality: Quality::Smooth,
            flat: true,
            scales: ScaleChoice::default(),
            split: false,
            eye: None,
            field_of_view: FIELD_OF_VIEW,
            samples: 1,
            plated: false,
        };
        let pose = held(piece, at);
        let camera = eye(&pose, at);
        let stage = StageOptions { camera: camera.clone(), ..options.stage(kitchen) };
        let drawn = saute_picture::stage::Pose::of_body(&pose);
        let pieces = if at == SeenAt::Under { [(piece.id.clone(), drawn)].into() } else { Default::default() };
        let input = self.stage.scene(kitchen, &stage, &Places { pieces, ..Places::default() });
        let eye = input.camera.clone();
        let rgba = self.renderer.render_to_image(&self.gpu.device, &self.gpu.queue, &input, SIZE, options.quality);
        let picture = Picture { width: SIZE[0] as usize, height: SIZE[1] as usize, rgba };
        let aspect = SIZE[0] as f32 / SIZE[1] as f32;
        let read = |point: Vec3| eye.project(point, aspect).and_then(|ndc| pixel(&picture, ndc));
        mean(field(piece, &pose, at).into_iter().filter_map(read))
    }
}

/// Returns the pose of a piece while it is measured: for its underside it is lifted and turned towards the camera.
fn held(piece: &Piece, at: SeenAt) -> Pose {
    let Pose { position, rotation } = piece.pose;
    match at {
        SeenAt::Under => Pose { position: position + LIFT * DVec3::Z, rotation: DQuat::from_rotation_x(PI) * rotation },
        SeenAt::Top | SeenAt::Cut => piece.pose,
    }
}

/// Returns the camera: in front of the cut, or straight above a face.
fn eye(pose: &Pose, at: SeenAt) -> Camera {
    let normal = pose.rotation * DVec3::X;
    let (yaw, pitch) = match at {
        SeenAt::Cut => (normal.x.atan2(-normal.y) as f32, 0.35),
        SeenAt::Top | SeenAt::Under => (0.0, 1.55),
    };
    Camera { yaw, pitch, distance: DISTANCE, target: pose.position.as_vec3(), ..Camera::three_quarter() }
}

/// Returns the points of the field in the world [m].
fn field(piece: &Piece, pose: &Pose, at: SeenAt) -> Vec<Vec3> {
    let half = piece.model.size().map(|v| 0.5 * v);
    let shown_below = piece.upside_down() != (at == SeenAt::Under);
    let face = 0.5 * piece.model.thickness(&piece.state) * if shown_below { -1.0 } else { 1.0 };
    let step = |k: i32| f64::from(k) / f64::from(READINGS);
    let range = || -READINGS..=READINGS;
    let place = |i: i32, j: i32| {
        let seen = match at {
            SeenAt::Cut => DVec3::new(0.0, FIELD * half[1] * step(i), CUT_HALF_HEIGHT * step(j)),
            SeenAt::Top | SeenAt::Under => DVec3::new(FIELD * half[0] * step(i), FIELD * half[1] * step(j), face),
        };
        pose.to_world(seen).as_vec3()
    };
    range().flat_map(|i| range().map(move |j| (i, j))).map(|(i, j)| place(i, j)).collect()
}

fn pixel(picture: &Picture, [x, y]: [f32; 2]) -> Option<Lab> {
    let column = (0.5 + 0.5 * x) * picture.width as f32;
    let row = (0.5 - 0.5 * y) * picture.height as f32;
    let inside = column >= 0.0 && row >= 0.0 && (column as usize) < picture.width && (row as usize) < picture.height;
    let at = 4 * (row as usize * picture.width + column as usize);
    inside.then(|| Lab::from_srgb8([picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]]))
}

fn mean(colours: impl Iterator<Item = Lab>) -> Lab {
    let (mut sum, mut count) = ([0.0; 3], 0.0f64);
    for Lab(lab) in colours {
        (0..3).for_each(|k| sum[k] += lab[k]);
        count += 1.0;
    }
    Lab(sum.map(|v| v / count.max(1.0)))
}
