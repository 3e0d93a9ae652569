//! The rounded rim between the faces of a slice and its side; only the picture is rounded.

use glam::Vec3;
use saute_kitchen::food::FoodModel;
use saute_kitchen::heat::{Section, SweptMesh};

use crate::skin::side::bulge;
use crate::skin::surface::{fineness, uneven};

/// Radius of the rounded rim of a steak [m] (chosen: it strays from the body by a millimetre at most).
const RIM_RADIUS: f32 = 2.6e-3;
/// The same above, where the body itself has a shoulder: the edge is blunt there, so that a wider arc strays no more [m] (chosen).
const SHOULDERED_RIM: f32 = 3.2e-3;
/// Distance from the outline up to which the face gives way to its rim, over the rim's radius [-] (chosen: twice as far as would fold
/// it).
const GIVES_WAY: f32 = 4.0;
/// How far the normals of the side lean outwards at the edge of a face [-] (chosen: the edge is seen as round).
const LEAN: f32 = 0.4;

/// Radius of the rounded rim of a piece [m].
pub(crate) fn rim_radius(model: &FoodModel) -> f32 {
    RIM_RADIUS * fineness(model) as f32
}

/// The nodes of a slice's surface as they are drawn.
pub(crate) struct Rim<'a> {
    model: &'a FoodModel,
    pub(crate) mesh: &'a SweptMesh,
    /// Mean direction outwards at each node of the outline.
    pub(crate) outward: Vec<Option<Vec3>>,
    /// Of each node the nearest of the outline, and how far that is [m].
    nearest: Vec<(usize, f32)>,
}

impl<'a> Rim<'a> {
    pub(crate) fn new(model: &'a FoodModel, mesh: &'a SweptMesh) -> Self {
        let points = &mesh.section.points;
        let outward = outward_normals(&mesh.section);
        let outline: Vec<usize> = (0..points.len()).filter(|i| outward[*i].is_some()).collect();
        let squared = |p: [f64; 2], i: usize| {
            let [x, y] = [points[i][0] - p[0], points[i][1] - p[1]];
            x * x + y * y
        };
        let nearest = points.iter().map(|p| {
            let ways = outline.iter().map(|i| (*i, squared(*p, *i)));
            let (node, way) = ways.fold((0, f64::INFINITY), |best, way| if way.1 < best.1 { way } else { best });
            (node, way.sqrt() as f32)
        });
        let nearest = nearest.collect();
        Self { model, mesh, outward, nearest }
    }

    /// Where a node of a face or of the side is drawn in the rest frame [m].
    pub(crate) fn place(&self, level: usize, i: usize) -> Vec3 {
        let p = Vec3::from_array(self.model.rest_position(self.mesh.node(level, i)).map(|v| v as f32));
        p + self.shift(level, i) + uneven(p, self.model, self.mesh)
    }

    /// Normal of the side at a level, which at the levels of the faces is that of their edge too.
    pub(crate) fn normal(&self, level: usize, i: usize) -> Vec3 {
        let out = self.outward[i].unwrap_or(Vec3::ZERO);
        let [sine, cosine] = angle(self.model, self.mesh, level);
        let up = if is_upper(self.mesh, level) { 1.0 } else { -1.0 };
        let slope = bulge(self.model, self.mesh, level, out)[1];
        (out * (cosine + LEAN) + Vec3::Z * (up * sine - slope)).normalize()
    }

    /// How far the rounded rim and the bulge shift a node of the surface [m].
    fn shift(&self, level: usize, i: usize) -> Vec3 {
        if let Some(out) = self.outward[i] {
            return rim_inset(self.model, self.mesh, level, out);
        }
        let (nearest, away) = self.nearest[i];
        let share = (1.0 - away / (GIVES_WAY * radius_at(self.model, self.mesh, level))).max(0.0);
        self.outward[nearest].map_or(Vec3::ZERO, |out| rim_inset(self.model, self.mesh, level, out) * (share * share))
    }
}

/// How far the rounded rim and the bulge shift the side at a level, given the direction outwards [m].
pub(crate) fn rim_inset(model: &FoodModel, mesh: &SweptMesh, level: usize, out: Vec3) -> Vec3 {
    out * (bulge(model, mesh, level, out)[0] - radius_at(model, mesh, level) * (1.0 - angle(model, mesh, level)[1]))
}

/// Sine and cosine of the angle at which the rounded rim leans at a level.
fn angle(model: &FoodModel, mesh: &SweptMesh, level: usize) -> [f32; 2] {
    let (z, thickness) = (mesh.levels[level] as f32, mesh.thickness() as f32);
    let radius = radius_at(model, mesh, level);
    let sine = 1.0 - z.min(thickness - z).min(radius) / radius;
    [sine, (1.0 - sine * sine).sqrt()]
}

/// Radius of the rim at the face that a level is nearer to [m].
fn radius_at(model: &FoodModel, mesh: &SweptMesh, level: usize) -> f32 {
    let shouldered = model.natural().is_some_and(|form| form.shoulder_mm > 0.0);
    if shouldered && is_upper(mesh, level) { SHOULDERED_RIM * fineness(model) as f32 } else { rim_radius(model) }
}

fn is_upper(mesh: &SweptMesh, level: usize) -> bool {
    2.0 * mesh.levels[level] > mesh.thickness()
}

/// Mean outward direction at each boundary node of the section.
pub(crate) fn outward_normals(section: &Section) -> Vec<Option<Vec3>> {
    let mut sums = vec![Vec3::ZERO; section.points.len()];
    for &[a, b] in &section.boundary {
        let (p, q) = (section.points[a as usize], section.points[b as usize]);
        let out = Vec3::new((q[1] - p[1]) as f32, (p[0] - q[0]) as f32, 0.0);
        sums[a as usize] += out;
        sums[b as usize] += out;
    }
    sums.into_iter().map(|s| s.try_normalize()).collect()
}

#[cfg(test)]
mod tests {
    use saute_kitchen::{Kitchen, Library, MeshSize, OutlineKind, PieceOrder, food::Rules, kelvin};

    use super::*;

    /// Farthest that a rounded rim may lie from the body [m] (chosen: the drawn shape agrees with what heats and collides to about a
    /// millimetre).
    const STRAYS: f32 = 1.4e-3;

    /// How far a place of the upper face is from the nearest surface of the body, of which the nodes are known [m].
    fn astray(rim: &Rim<'_>, level: usize, at: Vec3) -> f32 {
        let node = |i: usize| Vec3::from_array(rim.model.rest_position(rim.mesh.node(level, i)).map(|v| v as f32));
        let (nearest, across) = (0..rim.mesh.section.points.len())
            .map(|i| (i, (node(i) - at).truncate().length()))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .expect("has nodes");
        // What lies between two nodes may differ by the slope between them: half a ring.
        (node(nearest).z - at.z).abs() - 0.35 * across
    }

    #[test]
    fn rounded_faces_do_not_fold_and_stay_near_the_body() {
        let library = Library::embedded().expect("embedded data");
        for kind in ["beef-lean", "beef-patty", "chicken-breast", "pork-chop", "cod-fillet", "salmon-fillet", "tofu"] {
            let food = &library.foods[kind];
            let given: Vec<f64> = food.size.default_mm.iter().map(|mm| 1e-3 * mm).collect();
            for seed in 1..6 {
                let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("pan");
                let order = PieceOrder {
                    id: "it".to_owned(),
                    kind: kind.to_owned(),
                    size: food.form.extent(&given).expect("dimensions"),
                    temperature: kelvin(5.0),
                    seed,
                    coarseness: 1.0,
                    rules: Rules::Full,
                    mesh: MeshSize::Default,
                    outline: OutlineKind::Natural,
                };
                kitchen.add(&library, &order).expect("builds");
                let model = &kitchen.pieces()[0].model;
                let mesh = model.mesh().swept().expect("a slice");
                let rim = Rim::new(model, mesh);
                let top = mesh.levels.len() - 1;
                let bare = |i: usize| rim.place(top, i) - uneven_at(&rim, top, i);
                for t in &mesh.section.triangles {
                    let [a, b, c] = t.map(|i| bare(i as usize).truncate());
                    assert!((b - a).perp_dot(c - a) > 0.0, "{kind} {seed}: a triangle of the face folds at {a}");
                }
                let most = (0..mesh.section.points.len()).map(|i| astray(&rim, top, bare(i))).fold(0.0, f32::max);
                println!("{kind} {seed}: {:.2} mm", 1e3 * most);
                assert!(most <= STRAYS, "{kind} {seed}: {most} m from the body");
            }
        }
    }

    fn uneven_at(rim: &Rim<'_>, level: usize, i: usize) -> Vec3 {
        let p = Vec3::from_array(rim.model.rest_position(rim.mesh.node(level, i)).map(|v| v as f32));
        uneven(p, rim.model, rim.mesh)
    }
}
