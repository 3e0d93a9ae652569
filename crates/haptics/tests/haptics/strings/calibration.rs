//! Promise: the jig calibrates half a millimetre of manufacturing error and unknown offsets away.

use saute_haptics::strings::jig_calibration::{Accuracy, CalibrationError, JigReading};
use saute_haptics::{Calibration, Geometry, PoseEstimator, StringRig};

use crate::random::{Random, apart, device, somewhere};

/// A device half a millimetre off its drawing.
fn built(geometry: &Geometry, random: &mut Random) -> (StringRig, [f64; 8]) {
    let mut rig = geometry.rig();
    rig.motor.iter_mut().chain(&mut rig.attachment).for_each(|p| *p += random.vector() * 0.5e-3);
    (rig, std::array::from_fn(|_| random.signed()))
}

fn readings(geometry: &Geometry, rig: &StringRig, offset: &[f64; 8]) -> Vec<JigReading> {
    let count = |l: f64, o: f64| ((l - o) / geometry.pitch()).floor() * geometry.pitch();
    let read = |pose| {
        let lengths = rig.lengths(&pose);
        JigReading { pose, length: std::array::from_fn(|i| count(lengths[i], offset[i])) }
    };
    geometry.jig().into_iter().map(read).collect()
}

#[test]
fn half_a_millimetre_of_geometry_error_is_calibrated_away() {
    for name in ["spidar-pan-crossed", "spidar-pan", "spidar-frame"] {
        let geometry = device(name);
        let mut random = Random(3);
        let (rig, offset) = built(&geometry, &mut random);
        let readings = readings(&geometry, &rig, &offset);
        let found = Calibration::fit(&geometry.rig(), &readings, Accuracy::default()).unwrap();
        let uncalibrated = Calibration::as_drawn(geometry.rig(), &readings[0].pose, &readings[0].length);
        let worst = |calibration: &Calibration| {
            let mut random = Random(9);
            (0..500).fold((0.0f64, 0.0f64), |(mm, deg), _| {
                let pose = somewhere(&geometry, &mut random);
                let lengths = rig.lengths(&pose);
                let by_count = std::array::from_fn(|i| lengths[i] - offset[i]);
                let mut estimator = PoseEstimator::new(calibration.rig, geometry.home());
                let (m, d) = apart(&estimator.update(&calibration.lengths(&by_count), 1e-3), &pose);
                (mm.max(m), deg.max(d))
            })
        };
        let (mm, deg) = worst(&found);
        let (mm_before, _) = worst(&uncalibrated);
        assert!(mm < 0.2 && deg < 0.1, "{name}: {mm:.3} mm, {deg:.3}°; as drawn {mm_before:.3} mm");
        assert!(mm_before > 3.0 * mm, "{name}: {mm_before:.3} mm as drawn, {mm:.3} mm calibrated");
    }
}

#[test]
fn too_few_places_and_a_wrong_drawing_are_refused_with_a_remedy() {
    let geometry = device("spidar-pan-crossed");
    let mut random = Random(4);
    let (mut rig, offset) = built(&geometry, &mut random);
    let few = &readings(&geometry, &rig, &offset)[..5];
    let error = Calibration::fit(&geometry.rig(), few, Accuracy::default()).unwrap_err();
    assert_eq!(error, CalibrationError::TooFew(5));
    assert!(error.to_string().contains("8 are needed"));
    // String 3 runs from another motor.
    rig.motor[2] = rig.motor[6];
    let wrong = readings(&geometry, &rig, &offset);
    let error = Calibration::fit(&geometry.rig(), &wrong, Accuracy::default()).unwrap_err();
    assert!(matches!(error, CalibrationError::DoesNotFit { string: 3, .. }), "{error}");
    // The geometry of another device.
    let (other, offset) = built(&device("spidar-pan"), &mut random);
    let wrong = readings(&geometry, &other, &offset);
    let error = Calibration::fit(&geometry.rig(), &wrong, Accuracy::default()).unwrap_err();
    assert!(matches!(error, CalibrationError::NotAsDrawn { .. } | CalibrationError::DoesNotFit { .. }), "{error}");
}
