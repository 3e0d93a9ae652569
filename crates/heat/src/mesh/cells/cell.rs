//! A convex polyhedron that is clipped by half-spaces.

use glam::DVec3;

/// The neighbour beyond a facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wall {
    /// None: a side of the initial cube.
    Box,
    /// The cell of another node.
    Node(u32),
    /// The surroundings, at this sample of the surface.
    Skin(u32),
}

/// A facet, with its corners counter-clockwise seen from outside [m].
#[derive(Clone, Debug)]
pub struct Facet {
    /// The neighbour beyond it.
    pub wall: Wall,
    /// Distance of its plane from the node [m].
    pub offset: f64,
    /// Outward unit normal [-].
    pub normal: DVec3,
    corners: Vec<DVec3>,
}

impl Facet {
    /// Returns the corners, counter-clockwise seen from outside [m].
    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// Returns the area [m²].
    pub fn area(&self) -> f64 {
        let first = self.corners[0];
        let doubled: DVec3 = self.corners.windows(2).map(|w| (w[0] - first).cross(w[1] - first)).sum();
        0.5 * doubled.length()
    }
}

/// A convex polyhedron with its node at the origin [m].
#[derive(Clone, Debug)]
pub struct Cell {
    /// Its facets.
    pub facets: Vec<Facet>,
    cap: Vec<DVec3>,
}

impl Cell {
    /// Returns a cube with the given half edge [m].
    pub fn cube(half: f64) -> Self {
        let mut facets = Vec::with_capacity(24);
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let corner = |u: f64, v: f64| {
                    let mut p = DVec3::ZERO;
                    (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (sign * half, u * half, v * half);
                    p
                };
                // Counter-clockwise seen from outside, like all facets.
                let corners = vec![corner(-sign, -1.0), corner(sign, -1.0), corner(sign, 1.0), corner(-sign, 1.0)];
                let mut normal = DVec3::ZERO;
                normal[axis] = sign;
                facets.push(Facet { wall: Wall::Box, offset: half, normal, corners });
            }
        }
        Self { facets, cap: Vec::new() }
    }

    /// Returns the distance of the farthest corner from the node [m].
    pub fn reach(&self) -> f64 {
        let squares = self.facets.iter().flat_map(|f| &f.corners).map(|p| p.length_squared());
        libm::sqrt(squares.fold(0.0, f64::max))
    }

    /// Keeps the part with x · `normal` ≤ `offset` [m].
    pub fn clip(&mut self, normal: DVec3, offset: f64, wall: Wall) {
        let beyond = |p: &DVec3| p.dot(normal) - offset;
        if self.facets.iter().all(|f| f.corners.iter().all(|p| beyond(p) <= 0.0)) {
            return;
        }
        self.cap.clear();
        let cap = &mut self.cap;
        self.facets.retain_mut(|facet| {
            if let Some(kept) = cut(&facet.corners, &beyond, cap) {
                facet.corners = kept;
            }
            facet.corners.len() >= 3
        });
        if self.cap.len() >= 3 {
            let corners = around(normal, &self.cap);
            self.facets.push(Facet { wall, offset, normal, corners });
        }
    }

    /// Returns the volume, Σ facet area × offset / 3 [m³].
    pub fn volume(&self) -> f64 {
        self.facets.iter().map(|f| f.area() * f.offset).sum::<f64>() / 3.0
    }
}

/// Returns the part of a polygon with `beyond` ≤ 0, or `None` if that is all of it (Sutherland–Hodgman clipping) [m].
///
/// Adds the point at which the boundary leaves that part to `cap`.
fn cut(corners: &[DVec3], beyond: &impl Fn(&DVec3) -> f64, cap: &mut Vec<DVec3>) -> Option<Vec<DVec3>> {
    if corners.iter().all(|p| beyond(p) <= 0.0) {
        return None;
    }
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (i, p) in corners.iter().enumerate() {
        let q = &corners[(i + 1) % corners.len()];
        let (dp, dq) = (beyond(p), beyond(q));
        if dp <= 0.0 {
            kept.push(*p);
        }
        if (dp <= 0.0) != (dq <= 0.0) {
            let at = p + dp / (dp - dq) * (q - p);
            kept.push(at);
            if dp <= 0.0 {
                cap.push(at);
            }
        }
    }
    Some(kept)
}

/// Returns a unit vector perpendicular to a unit vector [-].
///
/// `DVec3::any_orthonormal_vector` selects another one, and with it another first corner of facets: areas would change in
/// the last bit.
fn perpendicular(n: DVec3) -> DVec3 {
    let pick = if n.x.abs() < 0.6 { DVec3::X } else { DVec3::Y };
    n.cross(pick).normalize_or_zero()
}

/// Returns points of a plane in order of angle around their mean [m].
fn around(normal: DVec3, points: &[DVec3]) -> Vec<DVec3> {
    let mean = points.iter().sum::<DVec3>() * (1.0 / points.len() as f64);
    let u = perpendicular(normal);
    let v = normal.cross(u);
    // A monotonic function of the angle that needs no arctangent.
    let turn = |p: &DVec3| {
        let d = *p - mean;
        let (x, y) = (d.dot(u), d.dot(v));
        let slope = y / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
        if x < 0.0 { 2.0 - slope } else { slope }
    };
    let mut sorted: Vec<(f64, DVec3)> = points.iter().map(|p| (turn(p), *p)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    sorted.into_iter().map(|(_, p)| p).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clipped_cube_has_the_exact_volume_and_area() {
        let mut cell = Cell::cube(1.0);
        assert!((cell.volume() - 8.0).abs() < 1e-12);
        cell.clip(DVec3::X, 0.25, Wall::Node(7));
        assert!((cell.volume() - 5.0).abs() < 1e-12);
        cell.clip(DVec3::new(0.0, 1.0, 1.0).normalize(), libm::sqrt(0.5), Wall::Skin(1));
        // The removed prism has legs of 1 and a length of 1.25.
        assert!((cell.volume() - (5.0 - 0.625)).abs() < 1e-12);
        let skin = cell.facets.iter().find(|f| f.wall == Wall::Skin(1)).map(Facet::area);
        assert!((skin.unwrap_or_default() - 1.25 * libm::sqrt(2.0)).abs() < 1e-12);
        assert!((cell.reach() - libm::sqrt(3.0)).abs() < 1e-12);
    }

    #[test]
    fn the_area_vectors_of_the_facets_sum_to_zero() {
        let mut cell = Cell::cube(1.0);
        for k in 0..40 {
            let a = 2.4 * f64::from(k);
            let n = DVec3::new(libm::cos(a), libm::sin(a), 0.05 * f64::from(k) - 1.0).normalize();
            cell.clip(n, 0.7, Wall::Node(k as u32));
        }
        let sum: DVec3 = cell.facets.iter().map(|f| f.normal * f.area()).sum();
        assert!(sum.length() < 1e-12, "{sum:?}");
        assert!(cell.facets.len() > 15);
    }
}
