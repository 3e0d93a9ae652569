//! A simulated projector, mirror and eye, with separate code, against which the program's pictures are checked.

use glam::{DMat3, DVec2, DVec3, Mat4, Vec3};

use crate::calibration::Calibration;
use crate::rig::{MARKS, Rig};
use crate::rig_file::shipped;
use crate::screen::Screen;
use crate::warp::Warp;

const SIZE: DVec2 = DVec2::new(1920.0, 1080.0);

/// Food, pan and steam: the middle of the pan, both sides of a steak, the rim at the right, steam over the middle [m].
const KNOWN: [DVec3; 5] = [
    DVec3::new(0.0, 0.0, 0.004),
    DVec3::new(-0.09, 0.05, 0.03),
    DVec3::new(0.08, 0.06, 0.025),
    DVec3::new(0.125, -0.05, 0.05),
    DVec3::new(-0.02, -0.03, 0.10),
];

/// The pixel at which the program shows a point, by the very matrix that the renderer is given.
fn shown(rig: &Rig, warp: &Warp, point: DVec3) -> DVec2 {
    let clip: Mat4 = rig.view_projection(rig.eye).as_mat4();
    let ndc = clip.project_point3(Vec3::new(point.x as f32, point.y as f32, point.z as f32)).as_dvec3();
    warp.pixel(DVec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y))
}

/// A projector, a board, a mirror and an eye as they really are.
struct Bench {
    eye: DVec3,
    mirror: [DVec3; 2],
    board: [DVec3; 2],
    /// Columns: along a row of pixels, down a column, along the axis.
    projector: DMat3,
    at: DVec3,
    focal: f64,
    principal: DVec2,
    /// Three radial coefficients, two of decentring.
    lens: [f64; 5],
}

/// Where a ray meets a plane of a point and a normal.
fn meet(from: DVec3, along: DVec3, [point, normal]: [DVec3; 2]) -> DVec3 {
    let t = normal.dot(point - from) / normal.dot(along);
    assert!(t > 0.0, "the ray leaves");
    from + along * t
}

impl Bench {
    /// One that differs from the shipped rig by what hands and a tape measure leave, with its own lens.
    fn as_built(rig: &Rig) -> Self {
        let turned = |n: DVec3, by: DVec3| (n + by).normalize();
        let axis = DVec3::new(0.012, -0.250, -0.968).normalize();
        let row = (DVec3::new(1.0, 0.02, 0.0) - axis * axis.dot(DVec3::new(1.0, 0.02, 0.0))).normalize();
        Self {
            eye: rig.eye,
            mirror: [DVec3::new(0.0, 0.0, 0.283), turned(rig.mirror.normal, DVec3::new(0.004, 0.006, 0.0))],
            board: [DVec3::new(0.0, 0.1195, 0.5295), DVec3::new(0.008, 0.349, 0.937).normalize()],
            projector: DMat3::from_cols(row, axis.cross(row), axis),
            at: DVec3::new(0.018, 0.294, 1.335),
            focal: 2702.0,
            principal: DVec2::new(968.0, 655.0),
            lens: [-0.12, 0.25, 0.05, 0.0004, -0.0003],
        }
    }

    /// The pixel whose light the eye sees at a point: from the eye to the mirror, thrown back to the board, into the
    /// lens.
    fn seen_at(&self, point: DVec3) -> DVec2 {
        let along = (point - self.eye).normalize();
        let [_, normal] = self.mirror;
        let on_mirror = meet(self.eye, along, self.mirror);
        let thrown = along - normal * (2.0 * normal.dot(along));
        let on_board = meet(on_mirror, thrown, self.board);
        let local = self.projector.transpose() * (on_board - self.at);
        let DVec2 { x, y } = local.truncate() / local.z;
        let r2 = x * x + y * y;
        let [k1, k2, k3, p1, p2] = self.lens;
        let radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
        let bent = DVec2::new(
            x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
            y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y,
        );
        self.principal + bent * self.focal
    }
}

/// A simulated person who sees how far a cross is from its mark, to the limit of the eye [pixels], and presses keys.
struct User {
    seed: u64,
}

/// What a user does not see [pixels] (chosen: vernier acuity of 10" at 0.65 m is 0.03 mm, a pixel 0.28 mm).
const UNSEEN: f64 = 0.11;

impl User {
    fn blur(&mut self) -> f64 {
        self.seed = self.seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5) * 2.0 * UNSEEN
    }

    /// Drags a cross near its mark, then presses arrow keys, then arrow keys with Shift, until it does not get nearer.
    fn fits(&mut self, mark: usize, wanted: DVec2, calibration: &mut Calibration, rig: &Rig) {
        let dragged = (wanted + DVec2::new(3.0, -2.0)).round();
        calibration.place(mark, dragged, rig, SIZE);
        for step in [1.0, 0.1] {
            for _ in 0..40 {
                let now = calibration.pixels(rig, SIZE).expect("is shown")[mark];
                let off = wanted - now + DVec2::new(self.blur(), self.blur());
                let by = off.to_array().map(|v| if v.abs() > 0.5 * step { step * v.signum() } else { 0.0 });
                calibration.shift(mark, DVec2::from_array(by), rig, SIZE);
            }
        }
    }
}

fn farthest(bench: &Bench, rig: &Rig, warp: &Warp) -> f64 {
    KNOWN.iter().map(|point| shown(rig, warp, *point).distance(bench.seen_at(*point))).fold(0.0, f64::max)
}

#[test]
fn after_calibration_on_screen_five_known_points_land_within_a_pixel() {
    for name in ["projector", "flat-screen"] {
        let rig = shipped(name).expect("is there").expect("is read");
        let bench = Bench::as_built(&rig);
        let (mut calibration, mut user) = (Calibration::default(), User { seed: 3 });
        let warp = |c: &Calibration| c.fitted(&rig, SIZE).expect("no three on a line");
        let before = farthest(&bench, &rig, &warp(&calibration).warp);
        let wanted: Vec<DVec2> = rig.sheet.marks().iter().map(|mark| bench.seen_at(*mark)).collect();
        for (mark, wanted) in wanted.iter().enumerate().take(4) {
            user.fits(mark, *wanted, &mut calibration, &rig);
        }
        let corners = farthest(&bench, &rig, &warp(&calibration).warp);
        for (mark, wanted) in wanted.iter().enumerate().skip(4) {
            user.fits(mark, *wanted, &mut calibration, &rig);
        }
        let fitted = warp(&calibration);
        let after = farthest(&bench, &rig, &fitted.warp);
        eprintln!(
            "{name}: five points off by {before:.1} px as measured, {corners:.2} px after the corners, {after:.2} px after the lens; residual {:.2} px",
            fitted.residual
        );
        assert!(before > 20.0, "{before}: there was nothing to calibrate");
        assert!(after < 1.0, "{after}");
        assert!(fitted.residual < 1.0, "{}", fitted.residual);
    }
}

#[test]
fn a_lens_that_bends_a_lot_is_found_from_the_middles_of_the_edges() {
    let rig = shipped("projector").expect("is there").expect("is read");
    let bench = Bench { lens: [-1.2, 4.0, 0.0, 0.0, 0.0], ..Bench::as_built(&rig) };
    let mut calibration = Calibration::default();
    let marks = rig.sheet.marks();
    (0..4).for_each(|mark| calibration.place(mark, bench.seen_at(marks[mark]), &rig, SIZE));
    let warp = |c: &Calibration| c.fitted(&rig, SIZE).expect("no three on a line").warp;
    let corners = farthest(&bench, &rig, &warp(&calibration));
    (4..MARKS).for_each(|mark| calibration.place(mark, bench.seen_at(marks[mark]), &rig, SIZE));
    let after = farthest(&bench, &rig, &warp(&calibration));
    eprintln!("off by {corners:.2} px with the corners alone, {after:.3} px with the lens");
    assert!(corners > 2.0 && after < 0.3, "{corners} {after}");
}

/// The light of a pixel: from the device to the plane of the screen, by code of this test.
fn lit(screen: &Screen, pixel: DVec2) -> DVec3 {
    match screen {
        Screen::Panel(p) => p.first + p.row * (pixel.x / p.pixels.x) + p.column * (pixel.y / p.pixels.y),
        Screen::Projector(p) => {
            let bent = (pixel - p.lens.centre) / p.focal;
            let (mut low, mut high) = (0.0, 2.0 * bent.length());
            for _ in 0..200 {
                let r: f64 = 0.5 * (low + high);
                let far = r * (1.0 + p.lens.k[0] * r.powi(2) + p.lens.k[1] * r.powi(4));
                if far < bent.length() { low = r } else { high = r }
            }
            let straight = bent.normalize_or_zero() * low;
            let along = p.axis + p.right * straight.x + p.axis.cross(p.right) * straight.y;
            meet(p.position, along, [p.board.point, p.board.normal])
        }
    }
}

#[test]
fn light_of_a_points_pixel_comes_to_the_eye_through_that_point() {
    for name in ["projector", "flat-screen"] {
        let rig = shipped(name).expect("is there").expect("is read");
        for point in KNOWN {
            let on_screen = lit(&rig.screen, shown(&rig, &rig.nominal, point));
            // The mirror sends it on where the way to the eye is shortest.
            let mirror = [rig.mirror.point, rig.mirror.normal];
            let height = |p: DVec3| (p - mirror[0]).dot(mirror[1]);
            let share = height(on_screen) / (height(on_screen) + height(rig.eye));
            let foot = |p: DVec3| p - mirror[1] * height(p);
            let on_mirror = foot(on_screen) + (foot(rig.eye) - foot(on_screen)) * share;
            let (there, on) = ((on_mirror - on_screen).normalize(), (rig.eye - on_mirror).normalize());
            assert!((there + on).dot(mirror[1]).abs() < 1e-12, "as steep as it came");
            assert!((there - on).cross(mirror[1]).length() < 1e-12, "in one plane");
            let back = point - rig.eye;
            let off = back.cross(on).length();
            // A pixel is 0.28 mm: what is left are the 32 bits of the renderer's matrix.
            assert!(off < 5e-6, "{name} {point}: {off} m");
        }
    }
}

#[test]
fn a_real_pan_touched_with_half_a_millimetre_of_error_is_met_within_two_millimetres_as_the_eye_sees_it() {
    use crate::registration::{Rigid, register};
    let rig = shipped("flat-screen").expect("is there").expect("is read");
    // How the kitchen really is in the rig, and points of the pan touched there.
    let turn = glam::DQuat::from_rotation_z(0.15);
    let really = Rigid { rotation: turn, shift: DVec3::new(0.012, -0.008, 0.003) };
    let mut hand = User { seed: 11 };
    // Even noise with a standard deviation of 0.5 mm.
    let mut error = || hand.blur() / UNSEEN * 0.5e-3 * 3.0f64.sqrt();
    let rim = (0..6).map(|k| f64::from(k) * std::f64::consts::TAU / 6.0);
    let rim = rim.map(|a| DVec3::new(0.14 * a.cos(), 0.14 * a.sin(), 0.045));
    let pairs: Vec<_> = rim.map(|p| [p, really.point(p) + DVec3::new(error(), error(), error())]).collect();
    let found = register(&pairs).expect("registers");
    let registered = Rig { rig_from_kitchen: found.transform, residual: Some(found.residual), ..rig.clone() };
    let truth = Rig { rig_from_kitchen: really, ..rig };
    let pixel = truth.image.size.x / 1920.0;
    let off = |p: &DVec3| shown(&registered, &truth.nominal, *p).distance(shown(&truth, &truth.nominal, *p));
    let farthest = KNOWN.iter().map(off).fold(0.0, f64::max);
    eprintln!(
        "residual {:.2} mm; points of the pan seen {farthest:.1} px ({:.2} mm) off at most",
        1e3 * found.residual,
        1e3 * farthest * pixel
    );
    assert!(farthest * pixel < 2e-3, "{farthest}");
}

#[test]
fn another_window_size_shows_the_same() {
    let rig = shipped("projector").expect("is there").expect("is read");
    let calibration = Calibration::default();
    let half = calibration.fitted(&rig, 0.5 * SIZE).expect("is").warp;
    for point in KNOWN {
        assert!((shown(&rig, &half, point) * 2.0).distance(shown(&rig, &rig.nominal, point)) < 1e-6);
    }
}
