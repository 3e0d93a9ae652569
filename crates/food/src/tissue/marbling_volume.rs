//! The seams of fat as one volume of cells: what conducts is averaged from it, and what is seen is drawn from it.

use saute_heat::BodyMesh;

use crate::description::Marbling;
use crate::tissue::marbling::{self, MarblingField, share_at};
use crate::tissue::node_means::Grown;

/// Largest number of cells (chosen: 0.9 mm cells in a default steak; seams are smooth between them).
const CELLS: f64 = 3.2e5;
/// Most cells along an axis (chosen: what every graphics adapter takes).
const MOST_ALONG: f64 = 256.0;
/// How far it reaches beyond the nodes [m] (chosen: as far as a picture of a hand-cut surface strays from them).
const MARGIN: f64 = 0.7e-3;
/// Depth within a seam that is told apart, below and above its edge, in widths of the edge [-] (chosen: the share of fat
/// is all or nothing half a width from it).
pub const DEEPEST_WITHIN: f32 = 3.0;

/// Depth within the seams on a regular grid of cells, smooth between their middles; the outermost values go on beyond.
#[derive(Clone, Debug)]
pub struct MarblingVolume {
    /// Cells along x, y, z.
    pub size: [u32; 3],
    /// Lowest corner in the rest mesh's frame [m].
    pub low: [f64; 3],
    /// Extent [m].
    pub extent: [f64; 3],
    /// Cells per metre, and from a cell to the next along each axis; 0 where there is no next.
    per_cell: [f64; 3],
    step: [usize; 3],
    within: Vec<f32>,
    share: f64,
}

impl MarblingVolume {
    /// The seams in the box of a mesh's nodes, with the asked share of fat in it; one empty cell where there is no marbling.
    pub fn new(marbling: Option<&Marbling>, seed: u64, mesh: &BodyMesh) -> Self {
        let marbling = marbling.filter(|m| m.adipose_share > 0.0);
        let mut volume = Self::empty(mesh, marbling.is_some());
        let Some(marbling) = marbling else { return volume };
        volume.share = marbling.adipose_share;
        let field = MarblingField::new(marbling, seed);
        let ridges: Vec<f64> = volume.cells().map(|cell| field.ridge(volume.middle(cell))).collect();
        // Between the middles of cells ridges are lower than the field's: the threshold is that of the cells.
        volume.within = ridges.into_iter().map(|ridge| ridge as f32).collect();
        let at = |node: usize| (volume.within(mesh.position(node)), mesh.volumes()[node]);
        let threshold = marbling::threshold_for(volume.share, &(0..mesh.node_count()).map(at).collect::<Vec<_>>());
        let depth =
            |ridge: f32| (marbling::within(f64::from(ridge), threshold) as f32).clamp(-DEEPEST_WITHIN, DEEPEST_WITHIN);
        volume.within.iter_mut().for_each(|ridge| *ridge = depth(*ridge));
        volume
    }

    /// Lean cells over the box of a mesh's nodes; one cell for all of it where no seams will come.
    fn empty(mesh: &BodyMesh, marbled: bool) -> Self {
        let mut corners = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for p in (0..mesh.node_count()).map(|node| mesh.position(node)) {
            corners[0] = std::array::from_fn(|k| corners[0][k].min(p[k] - MARGIN));
            corners[1] = std::array::from_fn(|k| corners[1][k].max(p[k] + MARGIN));
        }
        let low = corners[0];
        let extent: [f64; 3] = std::array::from_fn(|k| corners[1][k] - low[k]);
        let cell = libm::cbrt(extent.iter().product::<f64>() / CELLS);
        let size = extent.map(|v| if marbled { libm::ceil(v / cell).clamp(1.0, MOST_ALONG) as u32 } else { 1 });
        let per_cell = std::array::from_fn(|k| f64::from(size[k]) / extent[k]);
        let strides = [1, size[0] as usize, (size[0] * size[1]) as usize];
        let step = std::array::from_fn(|k| if size[k] > 1 { strides[k] } else { 0 });
        let count = size.iter().product::<u32>() as usize;
        Self { size, low, extent, per_cell, step, within: vec![-DEEPEST_WITHIN; count], share: 0.0 }
    }

    /// Its cells, x fastest.
    pub fn cells(&self) -> impl Iterator<Item = [u32; 3]> + use<> {
        let [nx, ny, nz] = self.size;
        (0..nx * ny * nz).map(move |index| [index % nx, index / nx % ny, index / nx / ny])
    }

    /// Middle of a cell in the rest mesh's frame [m].
    pub fn middle(&self, cell: [u32; 3]) -> [f64; 3] {
        std::array::from_fn(|k| self.low[k] + (f64::from(cell[k]) + 0.5) / f64::from(self.size[k]) * self.extent[k])
    }

    /// Mean share asked for [-].
    pub fn mean_share(&self) -> f64 {
        self.share
    }

    /// Share of adipose tissue at a point of the rest mesh's frame [-].
    pub fn at(&self, p: [f64; 3]) -> f64 {
        share_at(self.within(p))
    }

    /// How far a point lies within a seam, in widths of the seam's soft edge: linear between the middles of cells [-].
    pub fn within(&self, p: [f64; 3]) -> f64 {
        let (mut first, mut share) = (0, [0.0f32; 3]);
        for k in (0..3).rev() {
            let cells = self.size[k];
            let place = (p[k] - self.low[k]) * self.per_cell[k] - 0.5;
            let place = place.clamp(0.0, f64::from(cells - 1)) as f32;
            let near = (place as u32).min(cells.saturating_sub(2));
            share[k] = place - near as f32;
            first = first * cells as usize + near as usize;
        }
        let mix = |a: f32, b: f32, t: f32| a + t * (b - a);
        let row = |at: usize| mix(self.within[at], self.within[at + self.step[0]], share[0]);
        let plane = |at: usize| mix(row(at), row(at + self.step[1]), share[1]);
        f64::from(mix(plane(first), plane(first + self.step[2]), share[2]))
    }
}

impl Grown for MarblingVolume {
    fn at(&self, p: [f64; 3]) -> f64 {
        Self::at(self, p)
    }

    /// What lies between the middles of cells is no deeper and no shallower than they are.
    fn even(&self, low: [f64; 3], high: [f64; 3]) -> Option<f64> {
        let cell =
            |p: f64, k: usize| ((p - self.low[k]) * self.per_cell[k] - 0.5).clamp(0.0, f64::from(self.size[k] - 1));
        let [from, to] =
            [[0, 1, 2].map(|k| cell(low[k], k) as usize), [0, 1, 2].map(|k| libm::ceil(cell(high[k], k)) as usize)];
        let row = &|y: usize, z: usize| {
            let start = self.size[0] as usize * (y + self.size[1] as usize * z);
            &self.within[start + from[0]..=start + to[0]]
        };
        let depths = (from[2]..=to[2]).flat_map(|z| (from[1]..=to[1]).flat_map(move |y| row(y, z)));
        if depths.clone().all(|depth| *depth <= -0.5) {
            Some(0.0)
        } else {
            depths.clone().all(|depth| *depth >= 0.5).then_some(1.0)
        }
    }
}
