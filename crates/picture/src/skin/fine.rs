//! A finer surface over a body that is carried along stations: smooth between the nodes, which feed it by weights.
//!
//! The rim nodes of the stations form a grid, around the body and along it. The fine grid is on cubic curves through
//! them (Catmull and Rom 1974). The head end closes to a blunt tip; the tail fan is split into blades.

use glam::Vec3;
use saute_kitchen::food::{FoodModel, Form};
use saute_kitchen::heat::{Station, SweptMesh};

/// Fine vertices for each rim node around the body [-] (chosen: no corner of a silhouette shows at 1280×720).
const AROUND: usize = 3;
/// Distance of the fine rings along the body [m], and the most of them between two stations [-] (chosen in the same way).
const APART: f32 = 1.6e-3;
const MOST_BETWEEN: usize = 4;
/// Rings that close an end [-] (chosen: a round tip).
const TIP_RINGS: usize = 4;
/// Height of the head's tip over the half height of its end [-] (chosen: a cut that the flesh bulges out of a little).
const TIP: f32 = 0.14;
/// Blades of the tail fan (anatomy: a telson between two pairs of uropods), from where along the body they part [-], the
/// depth of the gaps over the body's length [-], and how far they thin the fan [-] (chosen).
const BLADES: f32 = 5.0;
const FAN_FROM: f32 = 0.84;
const GAP: f32 = 0.10;
const THINS: f32 = 0.72;
/// How much shorter than its middle a blade is at its sides, the telson at its, and the outermost blades as wholes, over the gaps'
/// depth [-] (chosen: blades that lie half over each other, with a spike between them).
const LEAF: f32 = 0.42;
const SPIKE: f32 = 0.55;
const OUTER: f32 = 0.80;

/// Weights of up to four nodes.
pub(crate) type Reads = [(u32, f32); 4];

/// A fine surface at rest.
#[derive(Default)]
pub(crate) struct Fine {
    pub(crate) reads: Vec<Reads>,
    pub(crate) positions: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Fine {
    /// The fine surface of a natural shrimp; none of other pieces.
    pub(crate) fn of(model: &FoodModel) -> Option<Self> {
        model.natural()?;
        let mesh = model.mesh().swept()?;
        let stations = mesh.stations().filter(|_| model.description().form == Form::Shrimp)?;
        Some(Grid::new(model, mesh, stations).surface())
    }
}

/// The rim nodes of all stations.
struct Grid<'a> {
    mesh: &'a SweptMesh,
    rim: Vec<u32>,
    /// Rest positions, and places across the body from belly (−1) to back (1), ring by ring.
    places: Vec<Vec<Vec3>>,
    across: Vec<Vec<f32>>,
    centres: Vec<Vec3>,
    fine: Fine,
}

impl<'a> Grid<'a> {
    fn new(model: &FoodModel, mesh: &'a SweptMesh, stations: &[Station]) -> Self {
        let rim = mesh.section.rim();
        let levels = 0..mesh.levels.len();
        let place = |level: usize, i: &u32| {
            Vec3::from_array(model.rest_position(mesh.node(level, *i as usize)).map(|v| v as f32))
        };
        let across = |level: usize| {
            let points = &stations[level].section.points;
            let reach = rim.iter().map(|i| points[*i as usize][0].abs()).fold(1e-9, f64::max);
            rim.iter().map(|i| (points[*i as usize][0] / reach) as f32).collect()
        };
        let places: Vec<Vec<Vec3>> =
            levels.clone().map(|level| rim.iter().map(|i| place(level, i)).collect()).collect();
        let centres = places.iter().map(|ring| ring.iter().sum::<Vec3>() / ring.len() as f32).collect();
        let across = levels.map(across).collect();
        Self { mesh, rim, places, across, centres, fine: Fine::default() }
    }

    fn surface(mut self) -> Fine {
        let rings = self.rings();
        let count = (AROUND * self.rim.len()) as u32;
        for ring in 1..rings as u32 {
            self.strip((ring - 1) * count, ring * count, false);
        }
        self.tip(0, 0, true);
        self.tip(self.places.len() - 1, (rings as u32 - 1) * count, false);
        self.fine.normals = normals(&self.fine.positions, &self.fine.triangles);
        self.fine
    }

    /// Adds the rings along the body; returns their number.
    fn rings(&mut self) -> usize {
        let mut rings = 0;
        let last = self.places.len() - 1;
        for level in 0..last {
            let run = (self.mesh.levels[level + 1] - self.mesh.levels[level]) as f32;
            let between = ((run / APART).round() as usize).clamp(1, MOST_BETWEEN);
            for k in 0..between {
                self.ring(level, k as f32 / between as f32);
                rings += 1;
            }
        }
        self.ring(last - 1, 1.0);
        rings + 1
    }

    /// Adds a ring at a share of the way from a level to the next.
    fn ring(&mut self, level: usize, up: f32) {
        let n = self.rim.len();
        let levels = [level.saturating_sub(1), level, level + 1, (level + 2).min(self.places.len() - 1)];
        let share = (f64::from(up) * (self.mesh.levels[level + 1] - self.mesh.levels[level]) + self.mesh.levels[level])
            as f32
            / self.mesh.thickness() as f32;
        for k in 0..AROUND * n {
            let (i, on) = (k / AROUND, (k % AROUND) as f32 / AROUND as f32);
            let columns = [(i + n - 1) % n, i, (i + 1) % n, (i + 2) % n];
            let on_ring = |level: usize| curve(columns.map(|c| self.places[level][c]), on);
            let place = curve(levels.map(on_ring), up);
            let across = |l: usize| self.across[l][i] * (1.0 - on) + self.across[l][columns[2]] * on;
            let across = across(level) * (1.0 - up) + across(level + 1) * up;
            let node = |l: usize, c: usize| self.mesh.node(l, self.rim[c] as usize) as u32;
            self.fine.reads.push([
                (node(level, i), (1.0 - up) * (1.0 - on)),
                (node(level, columns[2]), (1.0 - up) * on),
                (node(level + 1, i), up * (1.0 - on)),
                (node(level + 1, columns[2]), up * on),
            ]);
            let middle = self.centres[level].lerp(self.centres[level + 1], up);
            let along = (self.centres[level + 1] - self.centres[level]).normalize_or_zero();
            let length = self.mesh.thickness() as f32;
            self.fine.positions.push(bladed(place, middle, along * length, share, across));
        }
    }

    /// Closes an end with rings towards its middle; `first` is its outer ring.
    fn tip(&mut self, level: usize, first: u32, head: bool) {
        let count = AROUND * self.rim.len();
        let centre = self.centres[level];
        let next = if head { self.centres[1] } else { self.centres[level - 1] };
        let out = (centre - next).normalize_or_zero();
        let outer: Vec<Vec3> = self.fine.positions[first as usize..first as usize + count].to_vec();
        let reads: Vec<Reads> = self.fine.reads[first as usize..first as usize + count].to_vec();
        // Of a blade the half height, of the head its half thickness.
        let height = outer.iter().map(|p| p.z.abs()).fold(0.0, f32::max);
        let core = self.mesh.node(level, self.mesh.nodes_per_level() - 1) as u32;
        let mut before = first;
        for ring in 1..=TIP_RINGS {
            let inwards = ring as f32 / TIP_RINGS as f32;
            let rise = if head { TIP * height * (1.0 - (1.0 - inwards) * (1.0 - inwards)).sqrt() } else { 0.0 };
            let here = self.fine.positions.len() as u32;
            for (p, reads) in outer.iter().zip(&reads) {
                let to = if head { centre } else { Vec3::new(p.x, p.y, centre.z) };
                self.fine.positions.push(p.lerp(to, inwards) + out * rise);
                let [a, b, c, d] = *reads;
                // The two nodes of the end, and the one in its middle.
                let pair = if head { [a, b] } else { [c, d] };
                let [a, b] = pair.map(|(node, weight)| (node, weight * (1.0 - inwards)));
                self.fine.reads.push([a, b, (core, inwards), (core, 0.0)]);
            }
            self.strip(before, here, head);
            before = here;
        }
    }

    /// Joins two rings, the second farther along the body, or on the tip of the head.
    fn strip(&mut self, a: u32, b: u32, head: bool) {
        let count = (AROUND * self.rim.len()) as u32;
        for k in 0..count {
            let next = (k + 1) % count;
            let corners = [[a + k, a + next, b + next], [a + k, b + next, b + k]];
            self.fine.triangles.extend(corners.map(|[p, q, r]| if head { [p, r, q] } else { [p, q, r] }));
        }
    }
}

/// Moves a point of the tail fan so that blades part: gaps draw back towards the body, and the fan thins along them.
fn bladed(p: Vec3, middle: Vec3, length: Vec3, share: f32, across: f32) -> Vec3 {
    let fan = ((share - FAN_FROM) / (1.0 - FAN_FROM)).clamp(0.0, 1.0);
    if fan == 0.0 {
        return p;
    }
    // How far across its own blade the point is, −1 to 1, and which blade that is: 0 is the telson.
    let (blade, off) = {
        let place = 0.5 * BLADES * across;
        (place.round(), 2.0 * (place - place.round()))
    };
    // A leaf's tip is an ellipse, the telson's pointed.
    let leaf = LEAF * (1.0 - (1.0 - off * off).max(0.0).sqrt());
    let drawn_back = if blade == 0.0 { SPIKE * off.abs() } else { leaf };
    let gap = drawn_back + OUTER * across * across;
    let thin = 1.0 - THINS * fan.sqrt() * (0.75 + 0.25 * off * off);
    let p = Vec3::new(p.x, p.y, middle.z + (p.z - middle.z) * thin);
    p - length * (GAP * gap * fan * fan)
}

/// A point on the cubic curve through four successive points, between the middle two.
fn curve([a, b, c, d]: [Vec3; 4], t: f32) -> Vec3 {
    let (t2, t3) = (t * t, t * t * t);
    0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t2 + (3.0 * b - a - 3.0 * c + d) * t3)
}

/// Mean normals of the triangles around each vertex.
pub(crate) fn normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for t in triangles {
        let [a, b, c] = t.map(|i| positions[i as usize]);
        let normal = (b - a).cross(c - a);
        t.iter().for_each(|i| sums[*i as usize] += normal);
    }
    sums.into_iter().map(|s| s.normalize_or(Vec3::Z)).collect()
}
