//! Triangle meshes of what never deforms, and the shapes they are built from.

use std::f32::consts::TAU;

use glam::{Mat4, Vec2, Vec3};

/// What a fixed surface is made of; selects the procedural texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Material {
    Plain = 0,
    Metal = 1,
    PanFloor = 2,
    Glass = 3,
    Wood = 4,
    Cloth = 5,
    Counter = 6,
    /// Glass over a radiant element.
    Zone = 7,
}

/// Vertex of a fixed surface.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct SolidVertex {
    pub position: [f32; 3],
    pub normal: [f32; 3],
    /// Linear sRGB reflectance.
    pub colour: [f32; 3],
    /// Roughness, metalness, material, ambient visibility.
    pub surface: [f32; 4],
}

/// Colour and finish of a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Finish {
    pub colour: Vec3,
    pub roughness: f32,
    pub metalness: f32,
    pub material: Material,
}

/// A growing triangle mesh.
#[derive(Clone, Default, Debug)]
pub(crate) struct Mesh {
    pub vertices: Vec<SolidVertex>,
    pub indices: Vec<u32>,
}

impl Mesh {
    pub fn push(&mut self, position: Vec3, normal: Vec3, finish: &Finish, visibility: f32) -> u32 {
        self.vertices.push(SolidVertex {
            position: position.to_array(),
            normal: normal.to_array(),
            colour: finish.colour.to_array(),
            surface: [finish.roughness, finish.metalness, finish.material as u32 as f32, visibility],
        });
        self.vertices.len() as u32 - 1
    }

    /// Adds a regular grid of vertices, `point(i, j)` for `i ≤ columns`, `j ≤ rows`; faces look along ∂i × ∂j.
    pub fn grid(&mut self, columns: u32, rows: u32, finish: &Finish, point: impl Fn(u32, u32) -> (Vec3, Vec3, f32)) {
        let first = self.vertices.len() as u32;
        for j in 0..=rows {
            for i in 0..=columns {
                let (position, normal, visibility) = point(i, j);
                self.push(position, normal, finish, visibility);
            }
        }
        for j in 0..rows {
            for i in 0..columns {
                let a = first + j * (columns + 1) + i;
                let b = a + columns + 1;
                self.indices.extend([a, a + 1, b + 1, a, b + 1, b]);
            }
        }
    }

    /// Turns a profile (radius, height) about the vertical; the outside is to the left of the profile's direction.
    pub fn lathe(&mut self, profile: &[ProfilePoint], segments: u32, finish: &Finish) {
        let rows = profile.len() as u32 - 1;
        self.grid(rows, segments, finish, |i, j| {
            let point = profile[i as usize];
            let (sin, cos) = (TAU * j as f32 / segments as f32).sin_cos();
            let turned = |v: Vec2| Vec3::new(v.x * cos, v.x * sin, v.y);
            (turned(point.at), turned(point.normal), point.visibility)
        });
    }

    /// A box with rounded vertical edges and a small rounded top edge, on `base` (centre of its underside).
    pub fn slab(&mut self, base: Vec3, size: Vec3, corner: f32, edge: f32, finish: &Finish) {
        // Inset, height under the top (both in edge radii) and how far the normal leans upwards.
        let profile = [(0.0, size.z / edge, 0.0), (0.0, 1.0, 0.0), (0.29, 0.29, 0.5), (1.0, 0.0, 1.0)];
        const CORNER_STEPS: u32 = 6;
        let outline = rounded_outline(Vec2::new(size.x, size.y) * 0.5, corner, CORNER_STEPS);
        let columns = outline.len() as u32 - 1;
        let rows = profile.len() as u32 - 1;
        self.grid(columns, rows, finish, |i, j| {
            let (point, outward) = outline[i as usize];
            let (inset, drop, tilt) = profile[j as usize];
            let xy = point - outward * inset * edge;
            let normal = (outward * (1.0 - tilt)).extend(tilt).normalize();
            (base + xy.extend(size.z - drop * edge), normal, if j == 0 { 0.4 } else { 1.0 })
        });
        let centre = self.push(base + Vec3::Z * size.z, Vec3::Z, finish, 1.0);
        let ring: Vec<u32> = outline
            .iter()
            .map(|(point, outward)| {
                let xy = *point - *outward * edge;
                self.push(base + Vec3::new(xy.x, xy.y, size.z), Vec3::Z, finish, 1.0)
            })
            .collect();
        for pair in ring.windows(2) {
            self.indices.extend([centre, pair[0], pair[1]]);
        }
    }

    /// Sweeps an ellipse-like section along stations.
    pub fn sweep(&mut self, stations: &[Station], finish: &Finish) {
        const SIDES: u32 = 16;
        let rows = stations.len() as u32 - 1;
        self.grid(SIDES, rows, finish, |i, j| {
            let station = stations[j as usize];
            let (sin, cos) = (TAU * i as f32 / SIDES as f32).sin_cos();
            let square = |v: f32| v.signum() * v.abs().powf(0.55);
            let offset = station.side * square(cos) * station.half.x + station.up * square(sin) * station.half.y;
            let normal = station.side * cos / station.half.x.max(1e-4) + station.up * sin / station.half.y.max(1e-4);
            (station.centre + offset, normal.normalize(), 1.0)
        });
    }

    /// A flattened dome (a rivet head) sitting on a surface.
    pub fn dome(&mut self, centre: Vec3, normal: Vec3, radius: f32, height: f32, finish: &Finish) {
        let (side, up) = normal.any_orthonormal_pair();
        self.grid(16, 4, finish, |i, j| {
            let (sin, cos) = (TAU * i as f32 / 16.0).sin_cos();
            let (rise, run) = (j as f32 / 4.0 * TAU / 4.0).sin_cos();
            let around = side * cos + up * sin;
            let position = centre + around * run * radius + normal * rise * height;
            (position, (around * run * height + normal * rise * radius).normalize(), 0.9)
        });
    }

    /// The same elsewhere.
    pub fn posed(&self, pose: Mat4) -> Self {
        let mut mesh = self.clone();
        mesh.transform_from(0, pose);
        mesh
    }

    /// Moves the vertices added since `first`.
    pub fn transform_from(&mut self, first: usize, pose: Mat4) {
        for vertex in &mut self.vertices[first..] {
            vertex.position = pose.transform_point3(Vec3::from(vertex.position)).to_array();
            vertex.normal = pose.transform_vector3(Vec3::from(vertex.normal)).normalize().to_array();
        }
    }
}

/// A point of a lathe profile.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProfilePoint {
    pub at: Vec2,
    pub normal: Vec2,
    pub visibility: f32,
}

/// A section of a sweep.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Station {
    pub centre: Vec3,
    pub side: Vec3,
    pub up: Vec3,
    pub half: Vec2,
}

/// Gives every point of a profile the normal to the left of its direction.
pub(crate) fn with_normals(points: &[Vec2]) -> Vec<ProfilePoint> {
    (0..points.len())
        .map(|i| {
            let along = points[(i + 1).min(points.len() - 1)] - points[i.saturating_sub(1)];
            ProfilePoint { at: points[i], normal: along.perp().normalize_or_zero(), visibility: 1.0 }
        })
        .collect()
}

/// Points along a cubic Bézier curve.
pub(crate) fn bezier(control: [Vec2; 4], steps: u32) -> impl Iterator<Item = Vec2> {
    (0..=steps).map(move |i| bezier_at(control, i as f32 / steps as f32))
}

/// Point of a cubic Bézier curve at a parameter of 0–1.
pub(crate) fn bezier_at(control: [Vec2; 4], t: f32) -> Vec2 {
    let s = 1.0 - t;
    control[0] * s * s * s + control[1] * 3.0 * s * s * t + control[2] * 3.0 * s * t * t + control[3] * t * t * t
}

/// Closed outline (first point repeated) of a rounded rectangle, counter-clockwise, with outward normals.
fn rounded_outline(half: Vec2, corner: f32, steps: u32) -> Vec<(Vec2, Vec2)> {
    let mut outline = Vec::new();
    for quarter in 0..4 {
        let sign = [Vec2::new(1.0, 1.0), Vec2::new(-1.0, 1.0), Vec2::new(-1.0, -1.0), Vec2::new(1.0, -1.0)][quarter];
        let centre = (half - Vec2::splat(corner)) * sign;
        for step in 0..=steps {
            let angle = TAU * 0.25 * (quarter as f32 + step as f32 / steps as f32);
            let outward = Vec2::from_angle(angle);
            outline.push((centre + outward * corner, outward));
        }
    }
    outline.push(outline[0]);
    outline
}
