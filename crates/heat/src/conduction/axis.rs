//! One axis of a product mesh: a straight coordinate, or the radius of a cylinder or a sphere.

use core::ops::RangeInclusive;

/// The coordinate system of an axis: it fixes the measure of a control volume and of its faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// A Cartesian coordinate: measure = length [m], face = 1 [-].
    Straight,
    /// The radius of a full cylinder: measure = πr² [m²], face = 2πr [m].
    Cylindrical,
    /// The radius of a full sphere: measure = 4/3 πr³ [m³], face = 4πr² [m²].
    Spherical,
}

/// One axis of a product mesh, as ascending node positions [m].
///
/// A radius starts at 0. Two equal neighbours are the two sides of a thermal contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The coordinate system.
    pub metric: Metric,
    /// Node positions, ascending [m].
    pub nodes: Vec<f64>,
}

/// One of the two ends of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The first node.
    Low,
    /// The last node.
    High,
}

impl Axis {
    /// Returns a straight axis with the given node positions [m].
    pub fn straight(nodes: Vec<f64>) -> Self {
        Self { metric: Metric::Straight, nodes }
    }

    /// Returns the measure enclosed up to `x`: length [m], disc area [m²] or sphere volume [m³].
    fn enclosed(&self, x: f64) -> f64 {
        use core::f64::consts::PI;
        match self.metric {
            Metric::Straight => x,
            Metric::Cylindrical => PI * x * x,
            Metric::Spherical => 4.0 / 3.0 * PI * x * x * x,
        }
    }

    /// Returns the measure of the face at `x`: 1 [-], circumference [m] or sphere area [m²].
    fn surface(&self, x: f64) -> f64 {
        use core::f64::consts::PI;
        match self.metric {
            Metric::Straight => 1.0,
            Metric::Cylindrical => 2.0 * PI * x,
            Metric::Spherical => 4.0 * PI * x * x,
        }
    }

    /// Returns the measure of the face at an end: 1 [-], 2πr [m] or 4πr² [m²].
    pub fn end_surface(&self, end: End) -> f64 {
        self.surface(self.nodes[self.end_node(end)])
    }

    /// Returns the index of the node at an end.
    pub fn end_node(&self, end: End) -> usize {
        if end == End::Low { 0 } else { self.nodes.len() - 1 }
    }

    /// Returns the measures of both halves of each node's control volume [m], [m²] or [m³].
    ///
    /// Control volumes end half-way between neighbouring nodes.
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

    /// Returns the measure of each node's control volume [m], [m²] or [m³].
    pub fn cells(&self) -> Vec<f64> {
        self.halves().iter().map(|[low, high]| low + high).collect()
    }

    /// Returns face measure ÷ distance between node `i` and the next [1/m], [-] or [m].
    ///
    /// The face is half-way between the nodes. The value times the measure across the axis is the shape of the edge [m].
    pub fn link(&self, i: usize) -> f64 {
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        self.surface(0.5 * (a + b)) / (b - a)
    }

    /// Returns at most `most` nodes of `range` around `x`, centred on it as far as the range permits.
    fn around(&self, x: f64, range: RangeInclusive<usize>, most: usize) -> RangeInclusive<usize> {
        let (first, last) = (*range.start(), *range.end());
        let count = most.min(last - first + 1);
        let above = first + self.nodes[first..=last].partition_point(|&n| n <= x);
        let from = above.saturating_sub(count / 2).clamp(first, last + 1 - count);
        from..=from + count - 1
    }

    /// Returns the Lagrange weights that interpolate at `x` through `points` nodes of `range` [-].
    ///
    /// Two points are linear interpolation, four are cubic. Weights that are zero are left out.
    pub fn weights(&self, x: f64, range: RangeInclusive<usize>, points: usize) -> Vec<(usize, f64)> {
        let used = self.around(x, range, points);
        let weight = |i: usize| -> f64 {
            let others = used.clone().filter(|&j| j != i);
            others.map(|j| (x - self.nodes[j]) / (self.nodes[i] - self.nodes[j])).product()
        };
        used.clone().map(|i| (i, weight(i))).filter(|(_, w)| *w != 0.0).collect()
    }

    /// Returns the weights of the slope at `x` of the Lagrange polynomial through `points` nodes of `range` [1/m].
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
