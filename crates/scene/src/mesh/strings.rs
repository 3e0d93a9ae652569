//! Strings that pull on the pan: straight round rods.

use glam::{Vec2, Vec3};

use crate::mesh::solid::{Finish, Material, Mesh, Station};

/// One string.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StringLook {
    /// Where it begins and ends [m].
    pub ends: [Vec3; 2],
    /// Its radius [m].
    pub radius: f32,
    /// Its colour, linear sRGB.
    pub colour: Vec3,
}

/// All strings where they run.
pub(crate) fn string_mesh(strings: &[StringLook]) -> Mesh {
    let mut mesh = Mesh::default();
    for string in strings {
        let [from, to] = string.ends;
        let (side, up) = (to - from).normalize_or(Vec3::Z).any_orthonormal_pair();
        let half = Vec2::splat(string.radius);
        // A sweep looks outwards where its sections turn about the way they go.
        let station = |centre| Station { centre, side, up, half };
        let finish = Finish { colour: string.colour, roughness: 0.7, metalness: 0.0, material: Material::Plain };
        mesh.sweep(&[station(from), station(to)], &finish);
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_string_is_a_rod_of_its_radius_whose_faces_look_outwards() {
        let ends = [Vec3::new(0.1, 0.0, 0.1), Vec3::new(0.3, -0.2, -0.2)];
        let mesh = string_mesh(&[StringLook { ends, radius: 0.002, colour: Vec3::ONE }]);
        let along = (ends[1] - ends[0]).normalize();
        let axis = |p: Vec3| ends[0] + along * (p - ends[0]).dot(along);
        for v in &mesh.vertices {
            let (p, n) = (Vec3::from(v.position), Vec3::from(v.normal));
            let off = (p - axis(p)).length();
            assert!((0.0015..0.0030).contains(&off) && n.dot(p - axis(p)) > 0.0, "{off}");
        }
        for face in mesh.indices.chunks(3) {
            let [a, b, c] = [0, 1, 2].map(|k| Vec3::from(mesh.vertices[face[k] as usize].position));
            let middle = (a + b + c) / 3.0;
            assert!((b - a).cross(c - a).dot(middle - axis(middle)) > 0.0);
        }
    }
}
