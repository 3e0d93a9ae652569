//! Placement of several pieces next to each other on the pan's floor.

use core::f64::consts::TAU;

/// Directions in which a footprint stores its reach [-] (chosen: between two of them a circle is off by 0.1 %).
const DIRECTIONS: usize = 72;
/// Clearance between two pieces and to the floor's edge [m] (chosen: raw outlines ripple).
const GAP: f64 = 1.0e-3;
/// Spacing of candidate places [m] (chosen: well below the smallest piece).
const SPACING: f64 = 1.5e-3;
/// Width of the rings that are filled one after the other [m] (chosen: two places wide).
const RING: f64 = 3.0e-3;

/// Convex outline of a piece seen from above, as the support function about its origin [m].
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    reach: [f64; DIRECTIONS],
    inner: f64,
    outer: f64,
}

impl Footprint {
    /// The footprint of an outline about its body's origin [m].
    pub fn of(outline: &[[f64; 2]]) -> Self {
        let reach = core::array::from_fn(|k| {
            let [x, y] = direction(k);
            outline.iter().map(|p| p[0] * x + p[1] * y).fold(f64::NEG_INFINITY, f64::max)
        });
        let inner = reach.iter().copied().fold(f64::INFINITY, f64::min);
        let outer = reach.iter().copied().fold(0.0, f64::max);
        Self { reach, inner, outer }
    }

    /// The footprint of a disc of a radius [m].
    pub(crate) fn disc(radius: f64) -> Self {
        Self { reach: [radius; DIRECTIONS], inner: radius, outer: radius }
    }

    /// Largest distance from the floor's centre that it covers at a place [m].
    pub fn reach_from(&self, at: [f64; 2]) -> f64 {
        let reach = |k: usize| {
            let [x, y] = direction(k);
            self.reach[k] + at[0] * x + at[1] * y
        };
        (0..DIRECTIONS).map(reach).fold(0.0, f64::max)
    }

    /// Returns true if it overlaps another piece.
    pub fn overlaps(&self, here: [f64; 2], other: &Self, there: [f64; 2]) -> bool {
        let [dx, dy] = [there[0] - here[0], there[1] - here[1]];
        (0..DIRECTIONS).all(|k| {
            let [x, y] = direction(k);
            dx * x + dy * y < self.reach[k] + other.reach[(k + DIRECTIONS / 2) % DIRECTIONS]
        })
    }

    /// Returns true if a line separates this piece at `here` from another at `there` with the clearance [`GAP`].
    fn clear_of(&self, here: [f64; 2], other: &Self, there: [f64; 2]) -> bool {
        let [dx, dy] = [there[0] - here[0], there[1] - here[1]];
        let distance = libm::hypot(dx, dy);
        if distance > self.outer + other.outer + GAP {
            return true;
        }
        let parts = |k: usize| {
            let [x, y] = direction(k);
            dx * x + dy * y > self.reach[k] + other.reach[(k + DIRECTIONS / 2) % DIRECTIONS] + GAP
        };
        distance > self.inner + other.inner + GAP && (0..DIRECTIONS).any(parts)
    }

    /// Returns true if it is inside a circle about the origin.
    fn within(&self, radius: f64, at: [f64; 2]) -> bool {
        (0..DIRECTIONS).all(|k| {
            let [x, y] = direction(k);
            self.reach[k] + at[0] * x + at[1] * y + GAP <= radius
        })
    }
}

fn direction(k: usize) -> [f64; 2] {
    let angle = TAU * k as f64 / DIRECTIONS as f64;
    [libm::cos(angle), libm::sin(angle)]
}

/// A round floor with the pieces on it.
#[derive(Clone, Debug)]
pub struct Floor {
    radius: f64,
    lying: Vec<(Footprint, [f64; 2])>,
}

impl Floor {
    /// A floor of a radius [m] with pieces at their places [m].
    pub fn new(radius: f64, lying: Vec<(Footprint, [f64; 2])>) -> Self {
        Self { radius, lying }
    }

    /// Places for pieces in their order, in rings about `around` [m]. If not all fit, the floor is filled from its edge
    /// inwards, and the order that places more pieces is returned.
    pub fn places(self, wanted: &[Footprint], around: [f64; 2]) -> Vec<[f64; 2]> {
        let about = self.clone().filled(wanted, self.rings(around));
        if about.len() == wanted.len() {
            return about;
        }
        let mut inwards = self.rings([0.0, 0.0]);
        inwards.sort_by_key(|place| core::cmp::Reverse(place.0));
        let from_edge = self.filled(wanted, inwards);
        if from_edge.len() > about.len() { from_edge } else { about }
    }

    /// Greedy placement: each piece takes the first free place; stops at the first piece without one.
    fn filled(mut self, wanted: &[Footprint], order: Vec<(i64, [f64; 2])>) -> Vec<[f64; 2]> {
        let mut free: Vec<[f64; 2]> = order.into_iter().map(|(_, at)| at).collect();
        let smallest = wanted.iter().map(|w| w.inner).fold(f64::INFINITY, f64::min);
        let mut places = Vec::new();
        for (footprint, at) in core::mem::take(&mut self.lying) {
            self.occupy(&mut free, smallest, footprint, at);
        }
        for piece in wanted {
            let Some(at) = free.iter().copied().find(|at| self.takes(piece, *at)) else { break };
            places.push(at);
            self.occupy(&mut free, smallest, piece.clone(), at);
        }
        places
    }

    fn takes(&self, piece: &Footprint, at: [f64; 2]) -> bool {
        piece.within(self.radius, at) && self.lying.iter().all(|(other, there)| piece.clear_of(at, other, *there))
    }

    /// Places a piece and drops the candidates that even the smallest piece cannot take any more.
    fn occupy(&mut self, free: &mut Vec<[f64; 2]>, smallest: f64, piece: Footprint, at: [f64; 2]) {
        let nearest = smallest + piece.inner + GAP;
        free.retain(|p| libm::hypot(p[0] - at[0], p[1] - at[1]) > nearest);
        self.lying.push((piece, at));
    }

    /// Candidate places with the index of their ring about a point: the point itself, then ring by ring, sorted by angle
    /// within each ring, which packs pieces densely.
    fn rings(&self, around: [f64; 2]) -> Vec<(i64, [f64; 2])> {
        let farthest = self.radius + libm::hypot(around[0], around[1]);
        let steps = libm::ceil(farthest / SPACING) as i64;
        let mut places: Vec<(i64, f64, [f64; 2])> = Vec::new();
        for (i, j) in (-steps..=steps).flat_map(|i| (-steps..=steps).map(move |j| (i, j))) {
            let [x, y] = [i as f64 * SPACING, j as f64 * SPACING];
            let at = [around[0] + x, around[1] + y];
            if libm::hypot(at[0], at[1]) < self.radius {
                let ring = libm::floor(libm::hypot(x, y) / RING) as i64;
                let angle = if (i, j) == (0, 0) { -TAU } else { libm::atan2(y, x) };
                places.push((ring, angle, at));
            }
        }
        places.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        places.into_iter().map(|(ring, _, at)| (ring, at)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use saute_heat::mesh::outline::Outline;

    fn coin(radius: f64) -> Footprint {
        Footprint::of(&Outline::circle(radius).points)
    }

    fn places(floor: f64, pieces: &[Footprint], around: [f64; 2]) -> Vec<[f64; 2]> {
        Floor::new(floor, Vec::new()).places(pieces, around)
    }

    #[test]
    fn coins_lie_apart_and_on_the_floor() {
        let places = places(0.1, &vec![coin(0.015); 22], [0.0, 0.0]);
        assert_eq!(places.len(), 22);
        for (i, p) in places.iter().enumerate() {
            assert!(libm::hypot(p[0], p[1]) + 0.015 <= 0.1);
            assert!(places[..i].iter().all(|q| libm::hypot(p[0] - q[0], p[1] - q[1]) >= 0.03), "{places:?}");
        }
    }

    #[test]
    fn the_first_piece_lies_where_it_was_asked_for_and_seven_coins_lie_closely() {
        let places = places(0.1, &vec![coin(0.015); 7], [0.02, -0.01]);
        assert_eq!(places[0], [0.02, -0.01]);
        // Six around one is as close as coins lie: 31 mm between centres, a few more for the grid.
        assert!(places[1..].iter().all(|p| libm::hypot(p[0] - 0.02, p[1] + 0.01) < 0.036), "{places:?}");
    }

    #[test]
    fn no_more_coins_find_a_place_than_the_floor_has_room_for_but_most_of_those() {
        // Nineteen coins of a fifth of the radius are the densest known packing that leaves 0.2056 of the radius each.
        let many = places(0.1, &vec![coin(0.02); 40], [0.0, 0.0]).len();
        assert!((16..=19).contains(&many), "{many}");
    }

    #[test]
    fn a_steak_takes_only_the_room_of_its_outline_and_a_flipped_one_its_mirror_image() {
        let long = Outline::superellipse(0.12, 0.06, 2.5, &[]);
        let steak = Footprint::of(&long.points);
        // A circle about the steak would leave 40 mm next to it.
        let floor = Floor::new(0.1, vec![(steak, [0.0, 0.0])]);
        let beside = floor.places(&vec![coin(0.0125); 12], [0.0, 0.05]);
        assert_eq!(beside.len(), 12, "{beside:?}");
        let lopsided = [[-0.01, -0.03], [0.01, -0.03], [0.0, 0.01]];
        let turned: Vec<[f64; 2]> = lopsided.iter().map(|p| [p[0], -p[1]]).collect();
        let (up, down) = (Footprint::of(&lopsided), Footprint::of(&turned));
        assert_eq!(up.reach[DIRECTIONS / 4], down.reach[3 * DIRECTIONS / 4]);
        assert_ne!(up, down);
    }
}
