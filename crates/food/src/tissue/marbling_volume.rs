//! Fat seams as a volume of cells; both the masses of the nodes and the pictures derive from it.

use saute_heat::BodyMesh;

use crate::description::Marbling;
use crate::tissue::fat_cap::FatCap;
use crate::tissue::marbling::{self, MarblingField, share_at};
use crate::tissue::node_means::Grown;

/// Largest number of cells [-] (chosen: 0.9 mm cells in a default steak; seams are smooth between them).
const CELLS: f64 = 3.2e5;
/// Largest number of cells along an axis [-] (chosen: the limit that every graphics adapter supports).
const MOST_ALONG: f64 = 256.0;
/// Largest number of cells for a fat cap without seams [-] (chosen: 1.2 mm cells in a default steak; its border is smooth).
const CAP_CELLS: f64 = 1.4e5;
/// Margin of the volume around the nodes [m] (chosen: the unevenness of the drawn surface).
const MARGIN: f64 = 0.7e-3;
/// Largest depth within or outside a seam, in widths of its edge [-] (chosen: the share of fat is 0 or 1 beyond half a
/// width).
pub const DEEPEST_WITHIN: f32 = 3.0;

/// Depth within the fat seams on a regular grid of cells [-]: trilinear between their centres, constant beyond the outermost.
#[derive(Clone, Debug)]
pub struct MarblingVolume {
    /// Number of cells along x, y and z [-].
    pub size: [u32; 3],
    /// Lowest corner in the rest mesh's frame [m].
    pub low: [f64; 3],
    /// Extent along x, y and z [m].
    pub extent: [f64; 3],
    /// Cells per metre [1/m], and index step to the next cell along each axis; 0 along an axis of one cell.
    per_cell: [f64; 3],
    step: [usize; 3],
    within: Vec<f32>,
    share: f64,
    capped: bool,
}

impl MarblingVolume {
    /// The seams in the bounding box of a mesh with the mean share of adipose tissue that the food states; one lean cell
    /// without marbling.
    pub fn new(marbling: Option<&Marbling>, seed: u64, mesh: &BodyMesh) -> Self {
        Self::with_cap(marbling, None, seed, mesh)
    }

    /// As [`Self::new`], with a fat cap that is no part of the stated share.
    pub(crate) fn with_cap(marbling: Option<&Marbling>, cap: Option<&FatCap>, seed: u64, mesh: &BodyMesh) -> Self {
        let marbling = marbling.filter(|m| m.adipose_share > 0.0);
        let cells = match (marbling, cap) {
            (Some(_), _) => CELLS,
            (None, Some(_)) => CAP_CELLS,
            (None, None) => 0.0,
        };
        let mut volume = Self::empty(mesh, cells);
        if let Some(marbling) = marbling {
            volume.marble(marbling, seed, mesh);
        }
        if let Some(cap) = cap {
            volume.cover(cap);
        }
        volume
    }

    /// Fills the cells with seams.
    fn marble(&mut self, marbling: &Marbling, seed: u64, mesh: &BodyMesh) {
        self.share = marbling.adipose_share;
        let mut field = MarblingField::new(marbling, seed);
        let ridges: Vec<f64> = self.cells().map(|cell| field.ridge(self.middle(cell))).collect();
        // Interpolation lowers the ridges between cell centres, so the threshold is found on the interpolated field.
        self.within = ridges.into_iter().map(|ridge| ridge as f32).collect();
        let at = |node: usize| (self.within(mesh.position(node)), mesh.volumes()[node]);
        let threshold = marbling::threshold_for(self.share, &(0..mesh.node_count()).map(at).collect::<Vec<_>>());
        let depth =
            |ridge: f32| (marbling::within(f64::from(ridge), threshold) as f32).clamp(-DEEPEST_WITHIN, DEEPEST_WITHIN);
        self.within.iter_mut().for_each(|ridge| *ridge = depth(*ridge));
    }

    /// Adds a fat cap.
    fn cover(&mut self, cap: &FatCap) {
        self.capped = true;
        let [nx, ny, nz] = self.size;
        for column in 0..nx * ny {
            let [x, y] = [column % nx, column / nx];
            let [px, py, _] = self.middle([x, y, 0]);
            let Some(near) = cap.near([px, py]) else { continue };
            for z in 0..nz {
                let depth = cap.within(&near, self.middle([x, y, z])) as f32;
                let cell = &mut self.within[(column + nx * ny * z) as usize];
                *cell = cell.max(depth.clamp(-DEEPEST_WITHIN, DEEPEST_WITHIN));
            }
        }
    }

    /// Returns true if the piece contains adipose tissue: seams or a fat cap.
    pub fn holds_fat(&self) -> bool {
        self.capped || self.share > 0.0
    }

    /// About `cells` lean cells over the bounding box of a mesh; a single one for 0.
    fn empty(mesh: &BodyMesh, cells: f64) -> Self {
        let mut corners = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for p in (0..mesh.node_count()).map(|node| mesh.position(node)) {
            corners[0] = std::array::from_fn(|k| corners[0][k].min(p[k] - MARGIN));
            corners[1] = std::array::from_fn(|k| corners[1][k].max(p[k] + MARGIN));
        }
        Self::over(corners[0], std::array::from_fn(|k| corners[1][k] - corners[0][k]), cells)
    }

    /// About `cells` lean cells over a box; a single one for 0.
    fn over(low: [f64; 3], extent: [f64; 3], cells: f64) -> Self {
        let cell = libm::cbrt(extent.iter().product::<f64>() / cells.max(1.0));
        let size = extent.map(|v| if cells > 0.0 { libm::ceil(v / cell).clamp(1.0, MOST_ALONG) as u32 } else { 1 });
        let per_cell = std::array::from_fn(|k| f64::from(size[k]) / extent[k]);
        let strides = [1, size[0] as usize, (size[0] * size[1]) as usize];
        let step = std::array::from_fn(|k| if size[k] > 1 { strides[k] } else { 0 });
        let count = size.iter().product::<u32>() as usize;
        Self { size, low, extent, per_cell, step, within: vec![-DEEPEST_WITHIN; count], share: 0.0, capped: false }
    }

    /// Indices of all cells, x fastest.
    pub fn cells(&self) -> impl Iterator<Item = [u32; 3]> + use<> {
        let [nx, ny, nz] = self.size;
        (0..nx * ny * nz).map(move |index| [index % nx, index / nx % ny, index / nx / ny])
    }

    /// Centre of a cell in the rest mesh's frame [m].
    pub fn middle(&self, cell: [u32; 3]) -> [f64; 3] {
        std::array::from_fn(|k| self.low[k] + (f64::from(cell[k]) + 0.5) / f64::from(self.size[k]) * self.extent[k])
    }

    /// Mean share of adipose tissue in the seams, as the food states it [-].
    pub fn mean_share(&self) -> f64 {
        self.share
    }

    /// Share of adipose tissue at a point of the rest mesh's frame [-].
    pub fn at(&self, p: [f64; 3]) -> f64 {
        share_at(self.within(p))
    }

    /// A point in units of cells from the middle of the first [-].
    pub(crate) fn in_cells(&self, p: [f64; 3]) -> [f32; 3] {
        [0, 1, 2].map(|k| ((p[k] - self.low[k]) * self.per_cell[k] - 0.5) as f32)
    }

    /// Depth of every cell, x fastest [-].
    pub(crate) fn depths(&self) -> &[f32] {
        &self.within
    }

    /// Index steps to the next cell along x, y and z; 0 along an axis of one cell.
    pub(crate) fn steps(&self) -> [usize; 3] {
        self.step
    }

    /// Depth of a point within a seam, in widths of the seam's soft edge, trilinear between cell centres [-].
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

    // A trilinear value is between the smallest and the largest of its cells.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tissue::node_means::LANES;
    use crate::tissue::seam_blocks::SeamBlocks;

    #[test]
    fn blocks_give_the_depths_of_their_volume() {
        let extent = [0.04, 0.03, 0.01];
        for (count, expected) in [(5000.0, 1e-5), (0.0, 0.0)] {
            let mut volume = MarblingVolume::over([-0.02, 0.01, 0.0], extent, count);
            for (index, depth) in volume.within.iter_mut().enumerate() {
                *depth = libm::sin(index as f64 * 1.7) as f32;
            }
            let blocks = SeamBlocks::new(&volume);
            for i in 0..1000 {
                let share = [0.618_034, 0.754_878, 0.569_84].map(|step| f64::from(i) * step % 1.0);
                let p = [0, 1, 2].map(|k| volume.low[k] + share[k] * extent[k]);
                let lanes = blocks.depths(volume.in_cells(p).map(|place| [place; LANES]));
                let difference = lanes.map(|depth| (f64::from(depth) - volume.within(p)).abs());
                assert!(difference.iter().all(|d| *d <= expected), "{difference:?} at {p:?}");
            }
        }
    }
}
