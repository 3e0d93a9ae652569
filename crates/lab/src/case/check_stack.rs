//! Checks what a lab case is made of: bodies, materials, the pan.

use saute_food::components::Properties;
use saute_heat::boundary::Boundary;
use saute_heat::product::Constants;
use toml::Spanned;

use crate::solve::body::{node_count, sizes, vertical};
use crate::case::{BodyCase, PanCase};
use crate::case::case_file::{BodyEntry, CaseFile, Juice, MaterialEntry, PanEntry, Shape};
use crate::case::check::{Check, Checked, cooks};
use crate::solve::material::{Boiling, Material, Solid};
use saute_kitchen::data::library::Library;
use saute_kitchen::kelvin;

/// Most nodes a case may have (chosen: 0.5 GB of memory).
const MOST_NODES: f64 = 4e6;
/// Spacing over the smallest size and steepness of the grading where none is given [-] (chosen: 40 cells across, spacing
/// at a face 0.42 of the largest).
const DEFAULT_MESH: [f64; 2] = [1.0 / 40.0, 1.0];
/// The same for cooking, whose crust needs fine layers and whose inside does not (chosen: the time to a core temperature
/// is within 0.5 % of a mesh four times as fine).
const COOKING_MESH: [f64; 2] = [1.0 / 16.0, 1.5];
/// Finest spacing of a short axis over that of the longest [-] (chosen: reached by a steak's thickness, a quarter of its
/// length; a rod needs no more).
const FINEST_SHARE: f64 = 0.5;
/// Steepest grading [-] (chosen: spacing at a face is then a hundredth of the largest).
const STEEPEST_GRADING: f64 = 3.0;
/// Latent heat of water at 100 °C [J/kg]; source: steam tables.
const LATENT_HEAT: f64 = 2.257e6;

impl Check<'_> {
    /// Shape and bodies, lowest first.
    pub(super) fn bodies(&self, raw: &CaseFile) -> Checked<(Shape, Vec<BodyCase>)> {
        let Some(entries) = raw.body.as_ref().map(|b| b.all()).filter(|b| !b.is_empty()) else {
            return match raw.pan {
                Some(_) => Ok((Shape::Slab, Vec::new())),
                None => self.input.error(0, "there is neither a body nor a pan", "write [body] or [pan]"),
            };
        };
        let shape = entries[0].shape;
        let bodies: Vec<BodyCase> = entries.iter().map(|e| self.body(e, cooks(raw))).collect::<Checked<_>>()?;
        for (i, (entry, body)) in entries.iter().zip(&bodies).enumerate() {
            self.fits(shape, &bodies[0], entry, body)?;
            if let (0, None, Some(contact)) = (i, &raw.pan, &entry.contact_h_w_m2k) {
                let remedy = "leave it out, or write it into the [[body]] above";
                return self.input.error(contact.span().start, "contact_h_w_m2k: nothing lies below this body", remedy);
            }
        }
        if (bodies.len() > 1 || raw.pan.is_some()) && vertical(shape).is_none() {
            let at = entries[0].size_mm.span().start;
            return self.input.error(at, "a sphere lies on nothing", "use a slab, a box or a cylinder");
        }
        let nodes = node_count(shape, &bodies);
        if nodes > MOST_NODES {
            let given = entries[0].resolution_mm.as_ref().map_or(entries[0].size_mm.span().start, |r| r.span().start);
            let message = format!("resolution_mm makes about {nodes:.1e} nodes; at most {MOST_NODES:.1e} are allowed");
            return self.input.error(given, message, "use a larger resolution_mm");
        }
        Ok((shape, bodies))
    }

    /// Bodies of a stack have one shape and one footprint.
    fn fits(&self, shape: Shape, first: &BodyCase, entry: &BodyEntry, body: &BodyCase) -> Checked<()> {
        let across = body.size.len() - 1;
        if entry.shape == shape && body.size[..across] == first.size[..across] {
            return Ok(());
        }
        let remedy = "give all of them the shape of the lowest one, and its sizes but for the height";
        self.input.error(entry.size_mm.span().start, "the bodies of a stack do not fit onto each other", remedy)
    }

    fn body(&self, entry: &BodyEntry, cooks: bool) -> Checked<BodyCase> {
        let size = self.size(entry)?;
        let default_grading = if cooks { COOKING_MESH } else { DEFAULT_MESH }[1];
        Ok(BodyCase {
            resolution: self.resolution(entry, &size, cooks)?,
            grading: self
                .optional("grading", entry.grading.as_ref(), 0.0, STEEPEST_GRADING)?
                .unwrap_or(default_grading),
            initial: kelvin(self.input.ranged("initial_c", &entry.initial_c, -40.0, 1000.0)?),
            contact: self.optional("contact_h_w_m2k", entry.contact_h_w_m2k.as_ref(), 1e-3, 1e7)?,
            size,
        })
    }

    fn size(&self, body: &BodyEntry) -> Checked<Vec<f64>> {
        let (names, given) = (sizes(body.shape), body.size_mm.get_ref());
        let at = body.size_mm.span().start;
        if given.len() != names.len() {
            let remedy = format!("write size_mm = [{}]", names.join(", "));
            return self.input.error(at, "size_mm does not fit the shape", remedy);
        }
        for (name, mm) in names.iter().zip(given) {
            if !(0.01..=10_000.0).contains(mm) {
                let message = format!("size_mm: the {name} of {mm} mm is out of range");
                return self.input.error(at, message, format!("the {name} may be 0.01 to 10000 mm"));
            }
        }
        Ok(given.iter().map(|mm| mm * 1e-3).collect())
    }

    fn resolution(&self, body: &BodyEntry, size: &[f64], cooks: bool) -> Checked<Vec<f64>> {
        let default_share = if cooks { COOKING_MESH } else { DEFAULT_MESH }[0];
        let smallest = size.iter().copied().fold(f64::INFINITY, f64::min);
        let longest = size.iter().copied().fold(0.0, f64::max);
        let Some(given) = &body.resolution_mm else {
            // Cooking needs its layers towards every face and nothing fine inside, however long the axis.
            let share = |s: &f64| if cooks { *s } else { smallest } * default_share;
            return Ok(size.iter().map(share).collect());
        };
        let (at, all) = (given.span().start, given.get_ref().all());
        if all.len() != 1 && all.len() != size.len() {
            let remedy = format!("write one number, or {} as in size_mm", size.len());
            return self.input.error(at, "resolution_mm does not fit size_mm", remedy);
        }
        let along = |axis: usize| {
            let mm = all[axis.min(all.len() - 1)];
            let most = if all.len() == 1 { smallest } else { size[axis] } * 1e3 / 2.0;
            if (1e-3..=most).contains(&mm) {
                // One number holds for the longest axis. Heat has come through a short one sooner, with steeper profiles.
                let share = if all.len() == 1 { libm::sqrt(size[axis] / longest).max(FINEST_SHARE) } else { 1.0 };
                return Ok(mm * 1e-3 * share);
            }
            let message = format!("resolution_mm = {mm} is out of range");
            self.input.error(at, message, format!("resolution_mm may be 0.001 to {most} here, half the size"))
        };
        (0..size.len()).map(along).collect()
    }

    /// One material a body.
    pub(super) fn materials(&self, raw: &CaseFile, bodies: usize) -> Checked<Vec<Material>> {
        let Some(entry) = &raw.material else {
            if bodies == 0 {
                return Ok(Vec::new());
            }
            return self.input.error(0, "there is no [material]", "write [material] for all bodies, or one for each");
        };
        let (at, all) = (entry.span().start, entry.get_ref().all());
        if bodies == 0 || (all.len() != 1 && all.len() != bodies) {
            let message = format!("{} materials for {bodies} bodies", all.len());
            return self.input.error(
                at,
                message,
                "write one [material] for all, or one [[material]] for each [[body]]",
            );
        }
        let materials: Vec<Material> = all.iter().map(|m| self.material(m, at)).collect::<Checked<_>>()?;
        Ok((0..bodies).map(|b| materials[b.min(materials.len() - 1)].clone()).collect())
    }

    fn material(&self, m: &MaterialEntry, at: usize) -> Checked<Material> {
        match (&m.conductivity_w_mk, &m.density_kg_m3, &m.specific_heat_j_kgk, &m.food) {
            (Some(k), Some(rho), Some(c), None) => {
                let conductivity = self.input.ranged("conductivity_w_mk", k, 1e-4, 1e4)?;
                let capacity = self.input.ranged("density_kg_m3", rho, 1e-2, 1e5)?
                    * self.input.ranged("specific_heat_j_kgk", c, 1.0, 1e5)?;
                let boiling = self.boiling(m, conductivity, at)?;
                Ok(Material { solid: Solid::Constant(Constants { conductivity, capacity }), boiling })
            }
            (None, None, None, Some(food)) if !has_water(m) => self.food(food),
            _ => self.input.error(
                at,
                "the material is incomplete or given twice",
                "give conductivity_w_mk, density_kg_m3 and specific_heat_j_kgk, with water_kg_m3 if it boils, or food alone",
            ),
        }
    }

    fn boiling(&self, m: &MaterialEntry, conductivity: f64, at: usize) -> Checked<Option<Boiling>> {
        if !has_water(m) {
            return Ok(None);
        }
        let water = self.optional("water_kg_m3", m.water_kg_m3.as_ref(), 1e-3, 1e4)?;
        let unlimited = m.juice == Some(Juice::Unlimited);
        if water.is_none() && !unlimited {
            return self.input.error(
                at,
                "the material boils without water",
                "write water_kg_m3, or juice = \"unlimited\"",
            );
        }
        Ok(Some(Boiling {
            water: water.filter(|_| !unlimited),
            at: kelvin(self.optional("boiling_c", m.boiling_c.as_ref(), -40.0, 1000.0)?.unwrap_or(100.0)),
            latent: self.optional("latent_j_kg", m.latent_j_kg.as_ref(), 1.0, 1e8)?.unwrap_or(LATENT_HEAT),
            crust_conductivity: self
                .optional("crust_conductivity_w_mk", m.crust_conductivity_w_mk.as_ref(), 1e-4, 1e4)?
                .unwrap_or(conductivity),
        }))
    }

    fn food(&self, id: &Spanned<String>) -> Checked<Material> {
        let Some(food) = self.library.foods.get(id.get_ref()) else {
            let remedy = format!("use one of: {}", Library::names(&self.library.foods));
            return self.input.error(id.span().start, format!("food = \"{}\" is not a food", id.get_ref()), remedy);
        };
        let properties = Properties::new(&self.library.components, &food.lean, &food.fat_melting);
        let fractions = [food.lean.water, food.lean.lean_solids(), food.lean.fat];
        let density = 1.0 / properties.volume(&fractions, kelvin(20.0));
        let masses = fractions.map(|x| x * density);
        let solid = Solid::Food { id: id.get_ref().clone(), properties: Box::new(properties), masses };
        Ok(Material { solid, boiling: None })
    }

    /// The pan, and what lies outside its underside.
    pub(super) fn pan(&self, entry: &Spanned<PanEntry>) -> Checked<(PanCase, Boundary)> {
        let pan = entry.get_ref();
        let [thickness, density, specific_heat] = self.plate(entry)?;
        let initial = kelvin(self.input.ranged("initial_c", &pan.initial_c, -40.0, 1000.0)?);
        self.optional("conductivity_w_mk", pan.conductivity_w_mk.as_ref(), 1e-4, 1e4)?;
        let q = self.optional("q_w_m2", pan.q_w_m2.as_ref(), -1e7, 1e7)?.unwrap_or(0.0);
        let h = self.optional("h_w_m2k", pan.h_w_m2k.as_ref(), 0.0, 1e7)?.unwrap_or(0.0);
        let outside = self.optional("ambient_c", pan.ambient_c.as_ref(), -200.0, 2000.0)?.map_or(initial, kelvin);
        let plate = PanCase { capacity: thickness * density * specific_heat, initial, thickness };
        Ok((plate, Boundary::Exchange { h, source: h * outside + q }))
    }

    pub(super) fn pan_thickness(&self, raw: &CaseFile) -> Checked<f64> {
        raw.pan.as_ref().map_or(Ok(0.0), |p| self.pan(p).map(|(pan, _)| pan.thickness))
    }

    /// Thickness [m], density [kg/m³] and specific heat [J/(kg·K)] of a pan; its own numbers come before its kind's.
    fn plate(&self, entry: &Spanned<PanEntry>) -> Checked<[f64; 3]> {
        let pan = entry.get_ref();
        let own = [
            self.optional("thickness_mm", pan.thickness_mm.as_ref(), 0.01, 1000.0)?.map(|mm| mm * 1e-3),
            self.optional("density_kg_m3", pan.density_kg_m3.as_ref(), 1e-2, 1e5)?,
            self.optional("specific_heat_j_kgk", pan.specific_heat_j_kgk.as_ref(), 1.0, 1e5)?,
        ];
        if let [Some(thickness), Some(density), Some(specific_heat)] = own {
            return Ok([thickness, density, specific_heat]);
        }
        let Some(kind) = &pan.kind else {
            let remedy = "write kind = \"carbon-steel-26\", or thickness_mm, density_kg_m3 and specific_heat_j_kgk";
            return self.input.error(entry.span().start, "the pan is incomplete", remedy);
        };
        let Some(found) = self.library.pans.get(kind.get_ref()) else {
            let remedy = format!("use one of: {}", Library::names(&self.library.pans));
            return self.input.error(kind.span().start, format!("kind = \"{}\" is not a pan", kind.get_ref()), remedy);
        };
        let its = [found.floor.thickness_mm * 1e-3, found.metal.density_kg_m3, found.metal.specific_heat_j_kgk];
        Ok([0, 1, 2].map(|i| own[i].unwrap_or(its[i])))
    }
}

/// Whether any key says that the material boils.
fn has_water(m: &MaterialEntry) -> bool {
    m.water_kg_m3.is_some()
        || m.boiling_c.is_some()
        || m.latent_j_kg.is_some()
        || m.crust_conductivity_w_mk.is_some()
        || m.juice.is_some()
}
