//! The rest shape of a piece: mesh, faces and outline before anything contracts.

use saute_heat::{BodyMesh, Layout, Outline, Probe, Station, SweptMesh};

use crate::body::cells::cell_body::{cell_core, middle_cut};
use crate::body::halving::Halving;
use crate::body::pool::Pool;
use crate::body::{Body, Face, Patch, Surface, Waves};
use crate::paper_2013::Rules;

/// Mesh of a piece, its faces towards the outside and its outline, at rest.
#[derive(Clone, Debug)]
pub(crate) struct RestShape {
    /// Of a slice z goes from 0 to the thickness, with the origin at the outline's centroid.
    pub(crate) mesh: BodyMesh,
    /// Length, width, thickness; of a curved body along its curve, across it in its plane, and its height [m].
    pub(crate) size: [f64; 3],
    pub(crate) outline: Outline,
    /// In the order of both ends of the path, then the side; fresh faces of a cut come last.
    pub(crate) patches: Vec<Patch>,
    pub(crate) surface: Surface,
    /// Outward normal of each patch in the body frame [-].
    pub(crate) rest_normals: Vec<[f64; 3]>,
    /// Square of the distance of each patch from the middle, relative to half the length and width [-].
    pub(crate) outwards: Vec<f64>,
    pub(crate) contracts: bool,
    /// True if the body has the natural form of its food.
    pub(crate) natural: bool,
    /// True if the lower end of the path is no face, as the centre of a ball is not.
    pub(crate) closed_below: bool,
    pub(crate) core: Probe,
    /// Distance of the core along the path [m]; 0 in a body of cells.
    pub(crate) core_z: f64,
    /// Area of the middle cut of a body of cells that belongs to each of its nodes [m²]; empty in a swept body.
    pub(crate) middle_cut: Vec<(u32, f64)>,
    pub(crate) halving: Option<Halving>,
    /// How a poured food lies; none in other forms.
    pub(crate) pool: Option<Pool>,
    /// Where the waves of a thin slice are; none in other foods.
    pub(crate) waves: Option<Waves>,
    /// Height of the waves at each patch, 0 to 1 [-]; empty without waves.
    pub(crate) waved: Vec<f64>,
}

impl RestShape {
    /// The rest shape of a body; a body under the rules of 2013 does not contract.
    pub(crate) fn new(body: Body, rules: Rules) -> Self {
        let Body { size, mesh, outline, patches, contracts, natural, pool, waves } = body;
        let closed_below = !patches.iter().any(|p| p.face == Face::Bottom && p.area > 0.0);
        let (core, core_z) = core_of(&mesh, closed_below, middle(pool.as_ref()));
        let surface = mesh.swept().map(|swept| Surface::of(swept, &patches)).unwrap_or_default();
        let mut shape = Self {
            contracts: contracts && rules == Rules::Full,
            middle_cut: mesh.cells().map(middle_cut).unwrap_or_default(),
            rest_normals: Vec::new(),
            outwards: Vec::new(),
            halving: None,
            waved: Vec::new(),
            waves,
            pool,
            natural,
            mesh,
            size,
            outline,
            patches,
            surface,
            closed_below,
            core,
            core_z,
        };
        shape.place_patches(&shape.rest_poses());
        shape
    }

    /// Place of the core in the section of a slice [m]: its middle, or that of its yolk.
    pub(crate) fn middle(&self) -> [f64; 2] {
        middle(self.pool.as_ref())
    }

    /// Square of the distance of a point from the middle, relative to half the length and width [-].
    pub(crate) fn outwards_at(&self, [x, y, _]: [f64; 3]) -> f64 {
        4.0 * ((x / self.size[0]) * (x / self.size[0]) + (y / self.size[1]) * (y / self.size[1]))
    }

    /// Returns true if the body is a slice: its section carried straight up.
    #[inline]
    pub(crate) fn is_slice(&self) -> bool {
        self.mesh.is_slice()
    }
}

fn middle(pool: Option<&Pool>) -> [f64; 2] {
    pool.map_or([0.0; 2], |pool| pool.dome.at)
}

/// The core and its distance along the path [m].
fn core_of(mesh: &BodyMesh, closed_below: bool, middle: [f64; 2]) -> (Probe, f64) {
    let at = |swept: &SweptMesh, z: f64| (swept.probe_at(&swept.locate_or_nearest(middle), z), z);
    match mesh.layout() {
        Layout::Upright(swept) => at(swept, if closed_below { 0.0 } else { 0.5 * swept.thickness() }),
        Layout::Along(swept, stations) => at(swept, deepest_level(swept, stations)),
        Layout::Cells(cells) => (Probe::Cells(cell_core(cells)), 0.0),
    }
}

/// Distance along the path of the level whose middle is deepest below the skin [m].
fn deepest_level(mesh: &SweptMesh, stations: &[Station]) -> f64 {
    let depth = |level: usize| {
        let z = mesh.levels[level];
        let rim = stations[level].section.points.iter().map(|p| p[1]).fold(0.0, f64::max);
        rim.min(z).min(mesh.thickness() - z)
    };
    let deepest = (0..mesh.levels.len()).max_by(|a, b| depth(*a).total_cmp(&depth(*b))).unwrap_or(0);
    mesh.levels[deepest]
}
