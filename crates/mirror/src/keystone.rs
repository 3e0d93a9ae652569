//! Keystone: the homography that takes four points to four others.

use glam::{DMat3, DVec2, DVec3};

/// The homography that takes four points to four others exactly; none where three of four are on a line.
pub fn homography(from: [DVec2; 4], to: [DVec2; 4]) -> Option<DMat3> {
    let (from, to) = (basis(from)?, basis(to)?);
    let map = to * from.inverse();
    map.is_finite().then(|| map * map.z_axis.z.recip()).filter(|m| m.is_finite())
}

/// Takes the unit vectors and their sum to four points.
fn basis([a, b, c, d]: [DVec2; 4]) -> Option<DMat3> {
    let columns = DMat3::from_cols(a.extend(1.0), b.extend(1.0), c.extend(1.0));
    let extent = (b - a).length() * (c - a).length();
    if columns.determinant().abs() <= 1e-9 * extent.max(1e-300) {
        return None;
    }
    let weights = columns.inverse() * d.extend(1.0);
    let least = weights.abs().min_element();
    (least > 1e-9).then(|| columns * DMat3::from_diagonal(weights))
}

/// Where a homography takes a point.
pub fn taken(map: &DMat3, point: DVec2) -> DVec2 {
    let DVec3 { x, y, z } = *map * point.extend(1.0);
    DVec2::new(x, y) / z
}

#[cfg(test)]
mod tests {
    use super::*;

    const QUAD: [DVec2; 4] =
        [DVec2::new(102.0, 53.5), DVec2::new(1801.0, 99.0), DVec2::new(1750.5, 1001.0), DVec2::new(60.0, 950.0)];
    const SQUARE: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

    #[test]
    fn four_points_are_met_exactly_and_straight_lines_stay_straight() {
        let map = homography(SQUARE, QUAD).expect("no three on a line");
        for (from, to) in SQUARE.into_iter().zip(QUAD) {
            assert!(taken(&map, from).distance(to) < 1e-9);
        }
        let [a, b, c] = [0.1, 0.35, 0.8].map(|t| taken(&map, DVec2::new(t, 0.2 + 0.5 * t)));
        assert!((b - a).perp_dot(c - a).abs() / (c - a).length() < 1e-9);
    }

    #[test]
    fn the_way_back_is_the_inverse() {
        let (there, back) = (homography(SQUARE, QUAD).expect("is"), homography(QUAD, SQUARE).expect("is"));
        let point = DVec2::new(0.3, 0.7);
        assert!(taken(&back, taken(&there, point)).distance(point) < 1e-12);
    }

    #[test]
    fn three_points_on_a_line_have_no_homography() {
        let flat = [DVec2::ZERO, DVec2::X, DVec2::new(2.0, 0.0), DVec2::Y];
        assert_eq!(homography(SQUARE, flat), None);
        let doubled = [DVec2::ZERO, DVec2::X, DVec2::X, DVec2::Y];
        assert_eq!(homography(doubled, QUAD), None);
    }
}
