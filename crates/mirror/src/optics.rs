//! Optics of a half mirror: the virtual image of a screen, and how an eye looks through it.
//!
//! The eye sees the screen's picture where the mirror puts its image. What is to appear at a point must be shown where
//! the line from the eye to that point meets the image; so the eye looks through the image as through a window, off its
//! axis (R. Kooima, Generalized Perspective Projection, 2008 `[@kooima-2008]`).

use glam::{DMat4, DVec2, DVec3, DVec4};

/// An infinite plane: a point of it [m] and its unit normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point of the plane [m].
    pub point: DVec3,
    /// Unit normal, to either side.
    pub normal: DVec3,
}

impl Plane {
    /// A point's image in the plane as a mirror [m].
    pub fn mirrored(&self, point: DVec3) -> DVec3 {
        point - 2.0 * (point - self.point).dot(self.normal) * self.normal
    }

    /// Where a line through two points meets the plane [m]; none where it runs along it.
    pub fn met_by(&self, from: DVec3, through: DVec3) -> Option<DVec3> {
        let along = through - from;
        let t = (self.point - from).dot(self.normal) / along.dot(self.normal);
        t.is_finite().then(|| from + t * along)
    }
}

/// The rectangle of a screen's virtual image that pictures are drawn for [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VirtualImage {
    /// The corner at the lower left as the eye sees it [m].
    pub corner: DVec3,
    /// Unit vector to the eye's right.
    pub right: DVec3,
    /// Unit vector upwards as the eye sees it, perpendicular to `right`.
    pub up: DVec3,
    /// Width and height [m].
    pub size: DVec2,
}

/// Nearest and farthest that the mirror's pictures show [m] (chosen: a hand before the eye, the table behind the pan).
const NEAR: f64 = 0.04;
const FAR: f64 = 6.0;

impl VirtualImage {
    /// The smallest upright rectangle round points of a plane, as seen from an eye to whose right `x` points.
    pub fn round(points: &[DVec3], plane: &Plane, eye: DVec3, x: DVec3) -> Option<Self> {
        let towards = plane.normal * (eye - plane.point).dot(plane.normal).signum();
        let right = (x - x.dot(towards) * towards).try_normalize()?;
        let up = towards.cross(right);
        let places = || points.iter().map(|p| DVec2::new((*p - plane.point).dot(right), (*p - plane.point).dot(up)));
        let low = places().fold(DVec2::INFINITY, DVec2::min);
        let high = places().fold(DVec2::NEG_INFINITY, DVec2::max);
        let size = high - low;
        let corner = plane.point + low.x * right + low.y * up;
        (size.min_element() > 1e-6 && size.is_finite()).then_some(Self { corner, right, up, size })
    }

    /// Unit normal towards the eye.
    pub fn normal(&self) -> DVec3 {
        self.right.cross(self.up)
    }

    /// The plane that it is in.
    pub fn plane(&self) -> Plane {
        Plane { point: self.corner, normal: self.normal() }
    }

    /// Place of a point of its plane in the picture: shares of width and height from the upper left [-].
    pub fn place(&self, point: DVec3) -> DVec2 {
        let from = point - self.corner;
        DVec2::new(from.dot(self.right) / self.size.x, 1.0 - from.dot(self.up) / self.size.y)
    }

    /// The point of its plane at a place in the picture [m].
    pub fn point(&self, place: DVec2) -> DVec3 {
        self.corner + place.x * self.size.x * self.right + (1.0 - place.y) * self.size.y * self.up
    }

    /// Where in the picture an eye sees a point [-]; none for a point that is not before the eye.
    pub fn seen(&self, eye: DVec3, point: DVec3) -> Option<DVec2> {
        ((eye - point).dot(self.normal()) > 0.0)
            .then(|| self.plane().met_by(eye, point))
            .flatten()
            .map(|p| self.place(p))
    }

    /// Maps the world to the clip space of the picture (depth 0–1) for an eye: an asymmetric frustum through its edges.
    pub fn view_projection(&self, eye: DVec3) -> DMat4 {
        let (normal, from_eye) = (self.normal(), self.corner - eye);
        let distance = -from_eye.dot(normal);
        let [left, bottom] = [from_eye.dot(self.right), from_eye.dot(self.up)];
        let (middle_x, middle_y) = (2.0 * left / self.size.x + 1.0, 2.0 * bottom / self.size.y + 1.0);
        let rows = [self.right, self.up, normal].map(|axis| axis.extend(-axis.dot(eye)));
        let depth = FAR / (NEAR - FAR);
        let clip = [
            2.0 * distance / self.size.x * rows[0] + middle_x * rows[2],
            2.0 * distance / self.size.y * rows[1] + middle_y * rows[2],
            depth * rows[2] + NEAR * depth * DVec4::W,
            -rows[2],
        ];
        DMat4::from_cols(clip[0], clip[1], clip[2], clip[3]).transpose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image() -> VirtualImage {
        let plane = Plane { point: DVec3::new(0.0, 0.05, 0.01), normal: DVec3::new(0.0, 0.1, 1.0).normalize() };
        let corners = [[-0.3, -0.2], [0.2, -0.15], [0.3, 0.2], [-0.25, 0.2]].map(|[x, y]| {
            let above = DVec3::new(x, y, 1.0);
            plane.met_by(above, above - plane.normal).expect("meets")
        });
        VirtualImage::round(&corners, &plane, DVec3::new(0.0, -0.3, 0.5), DVec3::X).expect("has an extent")
    }

    #[test]
    fn a_mirror_image_lies_as_far_behind_the_mirror_and_twice_mirrored_is_as_before() {
        let mirror = Plane { point: DVec3::new(0.1, 0.2, 0.3), normal: DVec3::new(0.0, 0.6, 0.8) };
        let point = DVec3::new(-0.4, 0.5, 0.9);
        let image = mirror.mirrored(point);
        let height = |p: DVec3| (p - mirror.point).dot(mirror.normal);
        assert!((height(point) + height(image)).abs() < 1e-15);
        assert!(mirror.mirrored(image).distance(point) < 1e-15);
    }

    #[test]
    fn the_frustum_draws_a_point_where_the_line_from_the_eye_meets_the_image() {
        let (image, eye) = (image(), DVec3::new(0.04, -0.35, 0.55));
        for point in [DVec3::new(0.1, 0.0, 0.03), DVec3::new(-0.12, 0.15, 0.08), DVec3::new(0.0, -0.1, -0.02)] {
            let clip = image.view_projection(eye).project_point3(point);
            let place = image.seen(eye, point).expect("before the eye");
            let drawn = DVec2::new(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y);
            assert!(drawn.distance(place) < 1e-12, "{drawn} {place}");
            assert!(clip.z > 0.0 && clip.z < 1.0);
        }
    }

    #[test]
    fn the_image_stands_upright_before_the_eye_and_has_no_handle_behind_it() {
        let (image, eye) = (image(), DVec3::new(0.04, -0.35, 0.55));
        assert!((eye - image.corner).dot(image.normal()) > 0.0 && image.right.x > 0.9 && image.up.y > 0.9);
        assert_eq!(image.seen(eye, eye + image.normal()), None);
    }
}
