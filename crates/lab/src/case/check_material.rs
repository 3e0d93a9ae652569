//! Checks the materials of a lab case.

use saute_food::components::Properties;
use saute_heat::conduction::product::Constants;
use toml::Spanned;

use crate::case::body_file::{Juice, MaterialEntry};
use crate::case::case_file::CaseFile;
use crate::case::check::{Check, Checked};
use crate::case::ranges::{DEFAULT_BOILING_C, DEFAULT_LATENT_J_KG};
use crate::solve::material::{Boiling, Material, Solid};
use saute_kitchen::data::library::Library;
use saute_kitchen::kelvin;

impl Check<'_> {
    /// Returns one material for each body.
    pub(super) fn materials(&self, raw: &CaseFile, bodies: usize) -> Checked<Vec<Material>> {
        let Some(entry) = &raw.material else {
            if bodies == 0 {
                return Ok(Vec::new());
            }
            return self.input.error(
                0,
                "the case has no [material]",
                "write [material] for all bodies, or one for each",
            );
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
                let conductivity = *k.get_ref();
                let capacity = rho.get_ref() * c.get_ref();
                let boiling = self.boiling(m, conductivity, at)?;
                Ok(Material { solid: Solid::Constant(Constants { conductivity, capacity }), boiling })
            }
            (None, None, None, Some(food)) if !has_water(m) => self.food(food),
            _ => self.input.error(
                at,
                "the material is incomplete or defined twice",
                "give conductivity_w_mk, density_kg_m3 and specific_heat_j_kgk, with water_kg_m3 if it boils, or food alone",
            ),
        }
    }

    fn boiling(&self, m: &MaterialEntry, conductivity: f64, at: usize) -> Checked<Option<Boiling>> {
        if !has_water(m) {
            return Ok(None);
        }
        let water = m.water_kg_m3.as_ref().map(|v| *v.get_ref());
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
            at: kelvin(m.boiling_c.as_ref().map_or(DEFAULT_BOILING_C, |v| *v.get_ref())),
            latent: m.latent_j_kg.as_ref().map_or(DEFAULT_LATENT_J_KG, |v| *v.get_ref()),
            crust_conductivity: m.crust_conductivity_w_mk.as_ref().map_or(conductivity, |v| *v.get_ref()),
        }))
    }

    fn food(&self, id: &Spanned<String>) -> Checked<Material> {
        let Some(food) = self.library.foods.get(id.get_ref()) else {
            let remedy = format!("use one of: {}", Library::names(&self.library.foods));
            let why = self.library.absence("foods", id.get_ref(), "is not a food");
            return self.input.error(id.span().start, format!("food = \"{}\" {why}", id.get_ref()), remedy);
        };
        let properties =
            Properties::new(&self.library.components, &food.lean, &food.fat_melting, food.freezing.as_ref());
        let fractions = [food.lean.water, food.lean.lean_solids(), food.lean.fat];
        let density = 1.0 / properties.volume(&fractions, kelvin(20.0));
        let masses = fractions.map(|x| x * density);
        let solid = Solid::Food { id: id.get_ref().clone(), properties: Box::new(properties), masses };
        Ok(Material { solid, boiling: None })
    }
}

/// Returns true if any key of boiling is present.
fn has_water(m: &MaterialEntry) -> bool {
    m.water_kg_m3.is_some()
        || m.boiling_c.is_some()
        || m.latent_j_kg.is_some()
        || m.crust_conductivity_w_mk.is_some()
        || m.juice.is_some()
}
