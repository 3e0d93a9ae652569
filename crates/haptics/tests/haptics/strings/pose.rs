//! Promise: from lengths at the stated encoder pitch the pose is found within 0.1 mm and 0.1° over ±100 mm and ±20°.

use saute_haptics::{Geometry, PoseEstimator, STRINGS};

use crate::random::{Random, apart, device, somewhere};

/// Lengths as the device's encoders read them, at the middle of the count.
fn read(geometry: &Geometry, lengths: [f64; STRINGS]) -> [f64; STRINGS] {
    lengths.map(|l| ((l / geometry.pitch()).floor() + 0.5) * geometry.pitch())
}

/// Worst errors over random poses, with string `k` longer by `wrong(k)` [m].
fn worst(name: &str, wrong: impl Fn(&mut Random) -> f64) -> (f64, f64) {
    let geometry = device(name);
    let mut random = Random(7);
    let (mut mm, mut deg) = (0.0f64, 0.0f64);
    for _ in 0..2000 {
        let pose = somewhere(&geometry, &mut random);
        let lengths = geometry.rig().lengths(&pose).map(|l| l + wrong(&mut random));
        let mut estimator = PoseEstimator::new(geometry.rig(), geometry.home());
        let found = estimator.update(&read(&geometry, lengths), 1e-3);
        let (m, d) = apart(&found, &pose);
        (mm, deg) = (mm.max(m), deg.max(d));
    }
    (mm, deg)
}

#[test]
fn crossed_rigid_strings_give_the_pose_within_a_tenth_of_a_millimetre_and_degree() {
    let (mm, deg) = worst("spidar-pan-crossed", |_| 0.0);
    assert!(mm < 0.1 && deg < 0.1, "{mm:.4} mm, {deg:.4}°");
}

#[test]
fn the_classic_frame_and_uncrossed_strings_do_too() {
    for name in ["spidar-frame", "spidar-pan"] {
        let (mm, deg) = worst(name, |_| 0.0);
        assert!(mm < 0.1 && deg < 0.1, "{name}: {mm:.4} mm, {deg:.4}°");
    }
}

#[test]
fn a_string_stiffness_that_is_a_tenth_off_costs_less_than_half_a_millimetre() {
    let geometry = device("spidar-pan-crossed");
    let (tension, length) = (3.0, 0.45);
    let stretch = tension / geometry.drive.axial_stiffness_n * length;
    let (mm, _) = worst("spidar-pan-crossed", move |random| 0.1 * stretch * random.signed());
    assert!(mm <= 0.5, "{mm:.3} mm");
}

#[test]
fn lengths_that_are_not_finite_change_nothing() {
    let geometry = device("spidar-pan-crossed");
    let mut estimator = PoseEstimator::new(geometry.rig(), geometry.home());
    assert_eq!(estimator.update(&[f64::NAN; STRINGS], 1e-3), geometry.home());
}

#[test]
fn drift_of_one_encoder_is_estimated_from_the_two_redundant_lengths() {
    let geometry = device("spidar-pan-crossed");
    let mut estimator = PoseEstimator::new(geometry.rig(), geometry.home());
    let mut drifted = geometry.rig().lengths(&geometry.home());
    drifted[0] += 1e-3;
    estimator.update(&drifted, 1e-3);
    let before = estimator.residual();
    for _ in 0..300_000 {
        estimator.update(&drifted, 1e-3);
    }
    assert!(before > 5e-5 && estimator.residual() < 0.1 * before, "{before} {}", estimator.residual());
}

#[test]
fn velocity_follows_a_steady_motion() {
    let geometry = device("spidar-pan-crossed");
    let mut estimator = PoseEstimator::new(geometry.rig(), geometry.home());
    let mut pose = geometry.home();
    for _ in 0..200 {
        pose.position.x += 0.2e-3;
        estimator.update(&read(&geometry, geometry.rig().lengths(&pose)), 1e-3);
    }
    let twist = estimator.twist();
    assert!((twist.linear.x - 0.2).abs() < 0.01 && twist.linear.y.abs() < 0.01, "{twist:?}");
    assert!(twist.angular.length() < 0.05, "{twist:?}");
}
