//! The eye of a picture on the command line: `front`, `above`, `close-up` or `40,20,350`.

use saute_picture::still::shot::Eye;
use saute_scene::camera::{DISTANCE_MAX, DISTANCE_MIN, PITCH_MIN};

/// Allowed fields of view [°] (chosen: from a long lens to a wide one).
const FIELDS: std::ops::RangeInclusive<f32> = 5.0..=100.0;

/// Reads where the eye is.
pub fn eye(text: &str) -> Result<Eye, String> {
    match text {
        "front" => Ok(Eye::Front),
        "above" => Ok(Eye::Above),
        "close-up" => Ok(Eye::CloseUp),
        _ => from_numbers(text),
    }
}

/// Reads angles in degrees, a distance and a point in millimetres.
fn from_numbers(text: &str) -> Result<Eye, String> {
    let numbers: Option<Vec<f32>> =
        text.split(',').map(|n| n.trim().parse().ok().filter(|n: &f32| n.is_finite())).collect();
    let (view, target) = match numbers.as_deref() {
        Some([pitch, yaw, distance]) => ([*pitch, *yaw, *distance], None),
        Some([pitch, yaw, distance, x, y, z]) => ([*pitch, *yaw, *distance], Some([x, y, z].map(|mm| 1e-3 * mm))),
        _ => {
            return Err(
                "write front, above, close-up or PITCH,YAW,DISTANCE[,X,Y,Z] (degrees, mm), as in 40,20,350".into()
            );
        }
    };
    let [pitch, yaw, distance] = view;
    let lowest = PITCH_MIN.to_degrees().ceil();
    if !(lowest..=90.0).contains(&pitch) {
        return Err(format!("the pitch is {pitch}°: write {lowest} to 90"));
    }
    let nearest = [DISTANCE_MIN, DISTANCE_MAX].map(|m| 1e3 * m);
    if !(nearest[0]..=nearest[1]).contains(&distance) {
        return Err(format!("the distance is {distance} mm: write {:.0} to {:.0}", nearest[0], nearest[1]));
    }
    Ok(Eye::From { direction: [yaw, pitch].map(f32::to_radians), distance: 1e-3 * distance, target })
}

/// Reads a field of view [°].
pub fn field_of_view(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(degrees) if FIELDS.contains(&degrees) => Ok(degrees),
        _ => Err(format!("write degrees from {} to {}, as in 35", FIELDS.start(), FIELDS.end())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_eye_is_read_from_angles_and_millimetres() {
        let Ok(Eye::From { direction, distance, target }) = eye("30,-90,400,10,20,30") else { panic!("is read") };
        assert!((direction[0] + std::f32::consts::FRAC_PI_2).abs() < 1e-6 && (distance - 0.4).abs() < 1e-6);
        assert!((target.expect("a point")[2] - 0.03).abs() < 1e-6);
        assert_eq!(eye("above"), Ok(Eye::Above));
    }

    #[test]
    fn an_eye_out_of_reach_is_refused_with_its_limits() {
        for (text, says) in
            [("40,0,0.4", "140 to 1500"), ("95,0,400", "to 90"), ("40,0", "write front"), ("nan,0,300", "write front")]
        {
            assert!(eye(text).is_err_and(|message| message.contains(says)), "{text}");
        }
        assert!(field_of_view("200").is_err());
    }
}
