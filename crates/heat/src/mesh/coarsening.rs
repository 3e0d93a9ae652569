//! How the nodes of a plane mesh are handed out to those of a coarser one.

use crate::mesh::locate::{Located, Locator};
use crate::mesh::section::Section;

/// Rounds of balancing [-] (chosen: the sizes of the nodes are then right to a millionth).
const ROUNDS: usize = 60;

/// The coarse nodes to which each fine one goes, with its shares: their sum is 1.
///
/// The shares are those of linear interpolation, balanced so that each coarse node gets its size (iterative proportional
/// fitting): the adjoint of interpolation, which conserves sums.
///
/// ```
/// use saute_heat::{Coarsening, Outline, Section};
///
/// let fine = Section::mesh(&Outline::circle(0.05), 4e-3, 2e-3)?;
/// let coarse = Section::concentric(&Outline::circle(0.05), &[(12, 1.0), (6, 0.5), (1, 0.0)])?;
/// let to = Coarsening::between((&fine.points, &fine.areas), (&coarse, &coarse.areas), |_, _| true);
/// let heat_j = to.sums(&fine.areas.iter().map(|area| 4e6 * area).collect::<Vec<_>>());
/// let whole_j = 4e6 * fine.area();
/// assert!((heat_j.iter().sum::<f64>() - whole_j).abs() < 1e-9 * whole_j);
/// # Ok::<(), saute_heat::MeshError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Coarsening {
    shares: Vec<Located>,
    count: usize,
}

impl Coarsening {
    /// Hands out points with their sizes to the nodes of a section with theirs, in one unit. A point only goes to nodes that
    /// it `meets`, given both indices; one that meets no node around it goes to the nearest that it meets.
    pub fn between(
        (points, sizes): (&[[f64; 2]], &[f64]),
        (coarse, wanted): (&Section, &[f64]),
        meets: impl Fn(usize, usize) -> bool,
    ) -> Self {
        let locator = Locator::new(coarse);
        let share = |(i, p): (usize, &[f64; 2])| {
            let mut found = locator.locate_or_nearest(coarse, *p);
            for (node, weight) in found.nodes.into_iter().zip(&mut found.weights) {
                // Rounding makes shares at the rim slightly negative.
                *weight = if meets(i, node as usize) { weight.max(0.0) } else { 0.0 };
            }
            if found.weights.iter().sum::<f64>() > 0.0 { found } else { nearest(coarse, *p, |node| meets(i, node)) }
        };
        let shares = points.iter().enumerate().map(share).collect();
        let mut coarsening = Self { shares, count: coarse.points.len() };
        (0..ROUNDS).for_each(|_| coarsening.balance(sizes, wanted));
        coarsening
    }

    fn balance(&mut self, sizes: &[f64], wanted: &[f64]) {
        let got = self.sums(sizes);
        for share in &mut self.shares {
            for (node, weight) in share.nodes.into_iter().zip(&mut share.weights) {
                let node = node as usize;
                *weight *= if got[node] > 0.0 { wanted[node] / got[node] } else { 1.0 };
            }
            let sum: f64 = share.weights.iter().sum();
            share.weights.iter_mut().for_each(|weight| *weight /= sum);
        }
    }

    /// Returns the sums of a field, or of the field of each level of a swept mesh one after the other, in its unit.
    pub fn sums(&self, field: &[f64]) -> Vec<f64> {
        let levels = field.len() / self.shares.len();
        let mut sums = vec![0.0; levels * self.count];
        for (from, to) in field.chunks(self.shares.len()).zip(sums.chunks_mut(self.count)) {
            for (value, share) in from.iter().zip(&self.shares) {
                (0..3).for_each(|k| to[share.nodes[k] as usize] += share.weights[k] * value);
            }
        }
        sums
    }

    /// Returns the means of a field as in [`Self::sums`], given the weight of each of its values, in its unit; 0 where nothing
    /// has weight.
    pub fn means(&self, field: &[f64], weights: &[f64]) -> Vec<f64> {
        let weighted: Vec<f64> = field.iter().zip(weights).map(|(value, weight)| value * weight).collect();
        let whole = self.sums(&weights[..field.len()]);
        self.sums(&weighted).iter().zip(whole).map(|(sum, whole)| if whole > 0.0 { sum / whole } else { 0.0 }).collect()
    }
}

/// The nearest node that counts; the first one if none does.
fn nearest(section: &Section, p: [f64; 2], counts: impl Fn(usize) -> bool) -> Located {
    let distance = |i: &usize| libm::hypot(section.points[*i][0] - p[0], section.points[*i][1] - p[1]);
    let nodes = (0..section.points.len()).filter(|node| counts(*node));
    let node = nodes.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0) as u32;
    Located { nodes: [node; 3], weights: [1.0, 0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Outline;

    fn sections() -> [Section; 2] {
        let outline = Outline::superellipse(0.12, 0.08, 2.5, &[]);
        let fine = Section::mesh(&outline, 5e-3, 2e-3).expect("meshes");
        [fine, Section::concentric(&outline, &[(14, 1.0), (9, 0.6), (1, 0.0)]).expect("meshes")]
    }

    #[test]
    fn sums_are_kept_and_each_node_gets_its_size() {
        let [fine, coarse] = sections();
        let scale = fine.area() / coarse.area();
        let wanted: Vec<f64> = coarse.areas.iter().map(|area| scale * area).collect();
        let to = Coarsening::between((&fine.points, &fine.areas), (&coarse, &wanted), |_, _| true);
        for (got, wanted) in to.sums(&fine.areas).iter().zip(&wanted) {
            assert!((got / wanted - 1.0).abs() < 1e-3, "{got} {wanted}");
        }
        let field: Vec<f64> = (0..fine.points.len()).map(|i| libm::sin(i as f64)).collect();
        let [before, after] = [field.iter().sum::<f64>(), to.sums(&field).iter().sum()];
        assert!((before - after).abs() < 1e-12);
    }

    #[test]
    fn means_of_an_even_field_are_even_and_groups_keep_apart() {
        let [fine, coarse] = sections();
        let left = |p: [f64; 2]| p[0] < 0.0;
        let meets = |i: usize, node: usize| left(fine.points[i]) == left(coarse.points[node]);
        let to = Coarsening::between((&fine.points, &fine.areas), (&coarse, &coarse.areas), meets);
        let sides: Vec<f64> = fine.points.iter().map(|p| if left(*p) { 1.0 } else { 5.0 }).collect();
        for (mean, p) in to.means(&sides, &fine.areas).iter().zip(&coarse.points) {
            let expected = if left(*p) { 1.0 } else { 5.0 };
            assert!((mean - expected).abs() < 1e-12, "{mean} at {p:?}");
        }
    }
}
