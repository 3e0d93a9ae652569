//! The pan's surface as control volumes for thin-film flow: places, normals and faces between neighbours.

use saute_heat::Section;

use crate::pan::pan_description::PanDescription;
use crate::pan::ridges::Ridges;

/// Cross-section of a face.
#[derive(Clone, Copy, Debug)]
pub struct Mouth {
    /// Length of the face [m].
    pub face: f64,
    /// Distance between the nodes [m].
    pub length: f64,
}

/// A face between the control volumes of two nodes.
#[derive(Clone, Copy, Debug)]
pub struct BedEdge {
    /// One end.
    pub a: u32,
    /// The other.
    pub b: u32,
    /// Cross-section.
    pub mouth: Mouth,
    /// Between nodes of a ridged floor: squared cosine between the edge and the direction across the ridges [-].
    pub across: Option<f64>,
}

/// A face over the rim.
#[derive(Clone, Copy, Debug)]
pub struct RimFace {
    /// The node below it.
    pub node: u32,
    /// Cross-section towards the lip.
    pub mouth: Mouth,
    /// The lip in the pan's frame [m].
    pub lip: [f64; 3],
}

/// Geometry of the surface on which liquids rest and flow.
#[derive(Clone, Debug)]
pub struct Bed {
    /// Nodes in the pan's frame; the origin is the centre of the floor [m].
    pub places: Vec<[f64; 3]>,
    /// Unit normals, into the pan.
    pub normals: Vec<[f64; 3]>,
    /// Area of each node [m²].
    pub areas: Vec<f64>,
    /// One over the area of each node [1/m²].
    pub per_area: Vec<f64>,
    /// Faces between nodes.
    pub edges: Vec<BedEdge>,
    /// Faces over the rim.
    pub rim: Vec<RimFace>,
    /// Ridges on the floor.
    pub ridges: Option<Ridges>,
}

impl Bed {
    /// Maps the pan's mesh with its unrolled wall to the pan's frame.
    pub fn new(section: &Section, pan: &PanDescription) -> Self {
        let floor = 1e-3 * pan.floor.radius_mm;
        let (out, up) = (1e-3 * (pan.wall.rim_radius_mm - pan.floor.radius_mm), 1e-3 * pan.wall.height_mm);
        let rise = libm::hypot(out, up);
        let (cos, sin) = (out / rise, up / rise);
        let place = |p: &[f64; 2], beyond: f64| -> ([f64; 3], [f64; 3], f64) {
            let unrolled = libm::hypot(p[0], p[1]);
            let along = unrolled + beyond - floor;
            if along <= 0.0 {
                return ([p[0], p[1], 0.0], [0.0, 0.0, 1.0], 1.0);
            }
            let radius = floor + along * cos;
            let direction = [p[0] / unrolled, p[1] / unrolled];
            let narrower = radius / (unrolled + beyond);
            (
                [radius * direction[0], radius * direction[1], along * sin],
                [-sin * direction[0], -sin * direction[1], cos],
                narrower,
            )
        };
        let ridges = pan.ridges.as_ref().map(Ridges::of);
        let placed: Vec<_> = section.points.iter().map(|p| place(p, 0.0)).collect();
        let distance = |a: u32, b: u32| {
            let (p, q) = (section.points[a as usize], section.points[b as usize]);
            libm::hypot(p[0] - q[0], p[1] - q[1])
        };
        let edges = section.edges.iter().map(|&(a, b, weight)| {
            let length = distance(a, b);
            let narrower = 0.5 * (placed[a as usize].2 + placed[b as usize].2);
            let mouth = Mouth { face: weight * length * narrower, length };
            let flat = |i: u32| placed[i as usize].0[2] <= 0.0;
            let rise = section.points[b as usize][0] - section.points[a as usize][0];
            let across = (ridges.is_some() && flat(a) && flat(b)).then(|| rise * rise / (length * length));
            BedEdge { a, b, mouth, across }
        });
        let lengths = section.boundary_lengths();
        let rim = lengths.iter().enumerate().filter(|(_, length)| **length > 0.0).map(|(node, &length)| {
            // The outermost nodes are on the rim; the lip is half a cell further out.
            let beyond = 0.5 * section.areas[node] / length;
            let (lip, _, narrower) = place(&section.points[node], beyond);
            RimFace { node: node as u32, mouth: Mouth { face: length * narrower, length: beyond }, lip }
        });
        let areas: Vec<f64> = section.areas.iter().zip(&placed).map(|(area, p)| area * p.2).collect();
        Self {
            ridges,
            edges: edges.collect(),
            rim: rim.collect(),
            per_area: areas.iter().map(|area| 1.0 / area).collect(),
            areas,
            places: placed.iter().map(|p| p.0).collect(),
            normals: placed.iter().map(|p| p.1).collect(),
        }
    }
}
