//! A convex cell that planes are cut off from.

use crate::vector::{Vec3, across, add, along, cross, dot, length, scale, sub};

/// What lies beyond a facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wall {
    /// Nothing that was cut: the box in which the cell began.
    Box,
    /// The cell of another node.
    Node(u32),
    /// The outside, at this sample of the surface.
    Skin(u32),
}

/// A facet: its corners counter-clockwise seen from outside, and its distance from the node.
#[derive(Clone, Debug)]
pub struct Facet {
    /// What lies beyond.
    pub wall: Wall,
    /// Distance of its plane from the node [m].
    pub offset: f64,
    /// Outward unit normal.
    pub normal: Vec3,
    corners: Vec<Vec3>,
}

impl Facet {
    /// Area [m²].
    pub fn area(&self) -> f64 {
        let first = self.corners[0];
        let doubled = self.corners.windows(2).map(|w| cross(sub(w[0], first), sub(w[1], first))).fold([0.0; 3], add);
        0.5 * length(doubled)
    }
}

/// A convex polyhedron around its node, which is the origin.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Its facets.
    pub facets: Vec<Facet>,
    cap: Vec<Vec3>,
}

impl Cell {
    /// A cube of a half edge [m].
    pub fn cube(half: f64) -> Self {
        let mut facets = Vec::with_capacity(24);
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let corner = |u: f64, v: f64| {
                    let mut p = [0.0; 3];
                    (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (sign * half, u * half, v * half);
                    p
                };
                // Counter-clockwise seen from outside, as all facets.
                let corners = vec![corner(-sign, -1.0), corner(sign, -1.0), corner(sign, 1.0), corner(-sign, 1.0)];
                let mut normal = [0.0; 3];
                normal[axis] = sign;
                facets.push(Facet { wall: Wall::Box, offset: half, normal, corners });
            }
        }
        Self { facets, cap: Vec::new() }
    }

    /// Distance of the farthest corner from the node [m].
    pub fn reach(&self) -> f64 {
        let squares = self.facets.iter().flat_map(|f| &f.corners).map(|p| dot(*p, *p));
        libm::sqrt(squares.fold(0.0, f64::max))
    }

    /// Keeps the part with x · normal ≤ offset.
    pub fn clip(&mut self, normal: Vec3, offset: f64, wall: Wall) {
        let beyond = |p: &Vec3| dot(*p, normal) - offset;
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

    /// Volume [m³].
    pub fn volume(&self) -> f64 {
        self.facets.iter().map(|f| f.area() * f.offset).sum::<f64>() / 3.0
    }
}

/// The part of a polygon that is not beyond a plane, or none where all of it is kept; adds to `cap` where its boundary
/// leaves.
fn cut(corners: &[Vec3], beyond: &impl Fn(&Vec3) -> f64, cap: &mut Vec<Vec3>) -> Option<Vec<Vec3>> {
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
            let at = along(*p, sub(*q, *p), dp / (dp - dq));
            kept.push(at);
            if dp <= 0.0 {
                cap.push(at);
            }
        }
    }
    Some(kept)
}

/// Points of a plane in order around their mean.
fn around(normal: Vec3, points: &[Vec3]) -> Vec<Vec3> {
    let mean = scale(points.iter().copied().fold([0.0; 3], add), 1.0 / points.len() as f64);
    let u = across(normal);
    let v = cross(normal, u);
    let turn = |p: &Vec3| {
        let d = sub(*p, mean);
        let (x, y) = (dot(d, u), dot(d, v));
        let slope = y / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
        if x < 0.0 { 2.0 - slope } else { slope }
    };
    let mut sorted: Vec<(f64, Vec3)> = points.iter().map(|p| (turn(p), *p)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    sorted.into_iter().map(|(_, p)| p).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::unit;

    #[test]
    fn a_cut_cube_has_the_volume_and_area_that_are_left() {
        let mut cell = Cell::cube(1.0);
        assert!((cell.volume() - 8.0).abs() < 1e-12);
        cell.clip([1.0, 0.0, 0.0], 0.25, Wall::Node(7));
        assert!((cell.volume() - 5.0).abs() < 1e-12);
        cell.clip(unit([0.0, 1.0, 1.0]), libm::sqrt(0.5), Wall::Skin(1));
        // The prism cut off has legs of 1 and a length of 1.25.
        assert!((cell.volume() - (5.0 - 0.625)).abs() < 1e-12);
        let skin = cell.facets.iter().find(|f| f.wall == Wall::Skin(1)).map(Facet::area);
        assert!((skin.unwrap_or_default() - 1.25 * libm::sqrt(2.0)).abs() < 1e-12);
        assert!((cell.reach() - libm::sqrt(3.0)).abs() < 1e-12);
    }

    /// The closed surface of any cell: its area vectors add up to nothing.
    #[test]
    fn facets_close_the_cell() {
        let mut cell = Cell::cube(1.0);
        for k in 0..40 {
            let a = 2.4 * f64::from(k);
            let n = unit([libm::cos(a), libm::sin(a), 0.05 * f64::from(k) - 1.0]);
            cell.clip(n, 0.7, Wall::Node(k as u32));
        }
        let sum = cell.facets.iter().map(|f| scale(f.normal, f.area())).fold([0.0; 3], add);
        assert!(length(sum) < 1e-12, "{sum:?}");
        assert!(cell.facets.len() > 15);
    }
}
