//! Checks the boundary conditions of a lab case.

use saute_food::water::{ATMOSPHERE, VAPOUR_GAS_CONSTANT, saturation_pressure};
use saute_heat::conduction::boundary::Boundary;
use toml::Spanned;

use crate::case::boundary_file::{BoundaryEntry, Contact};
use crate::case::case_file::CaseFile;
use crate::case::check::{Check, Checked, cooks};
use crate::case::lab_case::{Medium, Radiation};
use saute_kitchen::kelvin;

impl Check<'_> {
    /// Returns the boundary condition of an entry and the medium at its faces.
    pub(super) fn boundary(&self, raw: &CaseFile, entry: &Spanned<BoundaryEntry>) -> Checked<(Boundary, Medium)> {
        let b = entry.get_ref();
        self.suits_physics(raw, entry)?;
        self.suits_medium(b)?;
        let radiation = self.radiation(raw, b)?;
        let vapour_density = self.vapour_density(b)?;
        // Only air radiates and has a humidity.
        let air = cooks(raw) && (radiation.is_some() || vapour_density.is_some());
        let contact = b.contact.or(air.then_some(Contact::Air));
        Ok((self.condition(entry)?, Medium { contact, radiation, vapour_density }))
    }

    /// Returns an error for a key that the physics does not support.
    fn suits_physics(&self, raw: &CaseFile, entry: &Spanned<BoundaryEntry>) -> Checked<()> {
        let (b, cooks) = (entry.get_ref(), cooks(raw));
        let cooking = "leave it out, or write physics = \"cooking\" into [solver] and food into [material]";
        if b.contact.is_some() && !cooks {
            return self.input.error(entry.span().start, "contact is only valid for cooking", cooking);
        }
        if let (false, Some(humidity)) = (cooks, &b.humidity_pct) {
            return self.input.error(humidity.span().start, "humidity_pct is only valid for cooking", cooking);
        }
        if let (true, Some(flux)) = (cooks, &b.q_w_m2) {
            let remedy = "write h_w_m2k and ambient_c, or contact = \"pan\" and ambient_c";
            return self.input.error(flux.span().start, "q_w_m2 is not supported with physics = \"cooking\"", remedy);
        }
        Ok(())
    }

    /// Returns an error for radiation or humidity at a face that no air reaches.
    fn suits_medium(&self, b: &BoundaryEntry) -> Checked<()> {
        let keys = [("radiant_c", &b.radiant_c), ("emissivity", &b.emissivity), ("humidity_pct", &b.humidity_pct)];
        let Some((key, value)) = keys.iter().find_map(|(key, value)| value.as_ref().map(|v| (key, v))) else {
            return Ok(());
        };
        let at = value.span().start;
        if b.fixed {
            let remedy = "leave it out, or write h_w_m2k in place of fixed = true";
            return self.input.error(at, format!("{key} has no effect on a fixed temperature"), remedy);
        }
        if matches!(b.contact, Some(Contact::Solid | Contact::Pan)) {
            let remedy = "leave it out, or write contact = \"air\"";
            return self.input.error(at, format!("{key} is only valid for a face in air"), remedy);
        }
        Ok(())
    }

    fn radiation(&self, raw: &CaseFile, b: &BoundaryEntry) -> Checked<Option<Radiation>> {
        let Some(radiant) = &b.radiant_c else {
            return match &b.emissivity {
                Some(emissivity) => {
                    let remedy = "write radiant_c, the temperature of the surroundings, or leave emissivity out";
                    self.input.error(emissivity.span().start, "emissivity has no effect without radiant_c", remedy)
                }
                None => Ok(None),
            };
        };
        let surroundings = kelvin(*radiant.get_ref());
        let own = b.emissivity.as_ref().map(|v| *v.get_ref());
        match own.or_else(|| self.emissivity_of_food(raw)) {
            Some(emissivity) => Ok(Some(Radiation { surroundings, emissivity })),
            None => {
                let remedy = "write emissivity = 0.95 with it";
                self.input.error(radiant.span().start, "radiant_c needs an emissivity, which only a food has", remedy)
            }
        }
    }

    /// Returns the emissivity of the food if there is a single material, and that is a food [-].
    fn emissivity_of_food(&self, raw: &CaseFile) -> Option<f64> {
        let [material] = raw.material.as_ref()?.get_ref().all() else { return None };
        let food = self.library.foods.get(material.food.as_ref()?.get_ref())?;
        Some(food.surface.emissivity)
    }

    /// Returns the vapour density of the air of a boundary [kg/m³]; none if the file gives no humidity.
    fn vapour_density(&self, b: &BoundaryEntry) -> Checked<Option<f64>> {
        let Some(humidity) = &b.humidity_pct else { return Ok(None) };
        let at = humidity.span().start;
        let share = humidity.get_ref() / 100.0;
        let Some(ambient) = b.ambient_c.as_ref().map(|v| *v.get_ref()) else {
            let remedy = "write ambient_c, the temperature of the air";
            return self.input.error(at, "humidity_pct needs ambient_c", remedy);
        };
        let saturated = saturation_pressure(kelvin(ambient));
        // Steam of one atmosphere at 100 °C is within the error of the saturation pressure.
        if share * saturated > 1.002 * ATMOSPHERE {
            let most = 100.0 * ATMOSPHERE / saturated;
            let message = format!("humidity_pct: the vapour pressure exceeds one atmosphere at {ambient} °C");
            return self.input.error(at, message, format!("write at most humidity_pct = {most:.1}, pure steam"));
        }
        Ok(Some(share * saturated / (VAPOUR_GAS_CONSTANT * kelvin(ambient))))
    }

    fn condition(&self, entry: &Spanned<BoundaryEntry>) -> Checked<Boundary> {
        let b = entry.get_ref();
        let flux = b.q_w_m2.as_ref().map(|v| *v.get_ref());
        let outside = b.ambient_c.as_ref().map(|c| kelvin(*c.get_ref()));
        let h = b.h_w_m2k.as_ref().map(|v| *v.get_ref());
        match (h, b.fixed, outside, flux) {
            // The contact model computes the coefficient; 1 is a placeholder.
            (None, false, Some(outside), None) if b.contact == Some(Contact::Pan) => {
                Ok(Boundary::convective(1.0, outside))
            }
            (Some(h), false, Some(outside), q) => Ok(Boundary::Exchange { h, source: h * outside + q.unwrap_or(0.0) }),
            (None, true, Some(outside), None) => Ok(Boundary::Fixed(outside)),
            (None, false, None, Some(source)) => Ok(Boundary::Exchange { h: 0.0, source }),
            (None, false, None, None) if b.radiant_c.is_some() => Ok(Boundary::Exchange { h: 0.0, source: 0.0 }),
            _ => self.input.error(
                entry.span().start,
                "the boundary needs one of h_w_m2k and fixed, with ambient_c, or q_w_m2 or radiant_c alone",
                "write h_w_m2k = 25 and ambient_c = 180, or fixed = true and ambient_c = 180, or q_w_m2 = 20000, or \
                 radiant_c = 180 and emissivity = 0.95",
            ),
        }
    }
}
