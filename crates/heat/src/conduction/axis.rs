//! One axis of a product mesh: straight, or the radius of a cylinder or a sphere.

use core::ops::RangeInclusive;

/// How an axis measures length and area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// A straight axis.
    Straight,
    /// The radius of a cylinder, all the way round.
    Cylindrical,
    /// The radius of a sphere, all directions.
    Spherical,
}

/// One axis: node positions, ascending [m]; a radius starts at 0. Equal neighbours are the two sides of a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// How it measures.
    pub metric: Metric,
    /// Nodes [m].
    pub nodes: Vec<f64>,
}

/// Which end of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The first node.
    Low,
    /// The last node.
    High,
}

impl Axis {
    /// A straight axis.
    pub fn straight(nodes: Vec<f64>) -> Self {
        Self { metric: Metric::Straight, nodes }
    }

    /// Measure enclosed up to `x`: length, area of the disc, volume of the ball.
    fn enclosed(&self, x: f64) -> f64 {
        use core::f64::consts::PI;
        match self.metric {
            Metric::Straight => x,
            Metric::Cylindrical => PI * x * x,
            Metric::Spherical => 4.0 / 3.0 * PI * x * x * x,
        }
    }

    /// Measure of the surface at `x`.
    fn surface(&self, x: f64) -> f64 {
        use core::f64::consts::PI;
        match self.metric {
            Metric::Straight => 1.0,
            Metric::Cylindrical => 2.0 * PI * x,
            Metric::Spherical => 4.0 * PI * x * x,
        }
    }

    /// Measure of the surface at an end.
    pub fn end_surface(&self, end: End) -> f64 {
        self.surface(self.nodes[self.end_node(end)])
    }

    /// Node at an end.
    pub fn end_node(&self, end: End) -> usize {
        if end == End::Low { 0 } else { self.nodes.len() - 1 }
    }

    /// Measures of the two halves of each node's cell, bounded half-way to its neighbours.
    pub fn halves(&self) -> Vec<[f64; 2]> {
        let (nodes, last) = (&self.nodes, self.nodes.len() - 1);
        let half_way = |i: usize, j: usize| 0.5 * (nodes[i] + nodes[j]);
        (0..=last)
            .map(|i| {
                let low = if i > 0 { half_way(i - 1, i) } else { nodes[0] };
                let high = if i < last { half_way(i, i + 1) } else { nodes[last] };
                let here = self.enclosed(nodes[i]);
                [here - self.enclosed(low), self.enclosed(high) - here]
            })
            .collect()
    }

    /// Measure of the cell that belongs to each node.
    pub fn cells(&self) -> Vec<f64> {
        self.halves().iter().map(|[low, high]| low + high).collect()
    }

    /// Area over length between node `i` and the next.
    pub fn link(&self, i: usize) -> f64 {
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        self.surface(0.5 * (a + b)) / (b - a)
    }

    /// Nodes around `x` within `range`, at most `most`, centred on it as far as the range lets them.
    fn around(&self, x: f64, range: RangeInclusive<usize>, most: usize) -> RangeInclusive<usize> {
        let (first, last) = (*range.start(), *range.end());
        let count = most.min(last - first + 1);
        let above = first + self.nodes[first..=last].partition_point(|&n| n <= x);
        let from = above.saturating_sub(count / 2).clamp(first, last + 1 - count);
        from..=from + count - 1
    }

    /// Weights that interpolate at `x` by a polynomial through `points` nodes of `range`: 2 is linear, 4 cubic [-].
    pub fn weights(&self, x: f64, range: RangeInclusive<usize>, points: usize) -> Vec<(usize, f64)> {
        let used = self.around(x, range, points);
        let weight = |i: usize| -> f64 {
            let others = used.clone().filter(|&j| j != i);
            others.map(|j| (x - self.nodes[j]) / (self.nodes[i] - self.nodes[j])).product()
        };
        used.clone().map(|i| (i, weight(i))).filter(|(_, w)| *w != 0.0).collect()
    }

    /// Weights that give the slope at `x` of the polynomial through `points` nodes of `range` [1/m].
    pub fn slope_weights(&self, x: f64, range: RangeInclusive<usize>, points: usize) -> Vec<(usize, f64)> {
        let used = self.around(x, range, points);
        let weight = |i: usize| -> f64 {
            let others = || used.clone().filter(move |&j| j != i);
            let scale: f64 = others().map(|j| self.nodes[i] - self.nodes[j]).product();
            let product = |m: usize| others().filter(|&j| j != m).map(|j| x - self.nodes[j]).product::<f64>();
            others().map(product).sum::<f64>() / scale
        };
        used.clone().map(|i| (i, weight(i))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_and_their_slopes_are_reproduced_everywhere() {
        let axis = Axis::straight(vec![0.0, 0.1, 0.25, 0.5, 0.8, 1.0]);
        let (cubic, slope) = (|x: f64| 1.0 + x * (2.0 - x * (3.0 + x)), |x: f64| 2.0 - 6.0 * x - 3.0 * x * x);
        for x in [0.0, 0.04, 0.25, 0.6, 0.97, 1.0] {
            let value: f64 = axis.weights(x, 0..=5, 4).iter().map(|(i, w)| w * cubic(axis.nodes[*i])).sum();
            let rise: f64 = axis.slope_weights(x, 0..=5, 4).iter().map(|(i, w)| w * cubic(axis.nodes[*i])).sum();
            assert!((value - cubic(x)).abs() < 1e-12 && (rise - slope(x)).abs() < 1e-12, "at {x}");
        }
        assert_eq!(axis.weights(0.25, 0..=5, 4), vec![(2, 1.0)]);
    }

    #[test]
    fn a_range_of_one_node_is_a_constant() {
        let axis = Axis::straight(vec![0.0, 0.0, 0.5]);
        assert_eq!(axis.weights(-0.3, 0..=0, 4), vec![(0, 1.0)]);
        assert_eq!(axis.slope_weights(0.2, 1..=2, 4), vec![(1, -2.0), (2, 2.0)]);
    }
}
