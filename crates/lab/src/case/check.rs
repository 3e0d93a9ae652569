//! Checks a lab case as it was written and brings it into SI units.

use saute_heat::Rule;
use toml::Spanned;

use crate::solve::body::{on_axes, vertical};
use crate::case::{BodyCase, Case, CookingCase, ProbeCase};
use crate::case::case_file::{CaseFile, ExpectEntry, Physics, ProbeEntry, Quantity, RuleEntry, Shape};
use crate::result::verdict::{Expectation, Subject};
use saute_kitchen::data::library::Library;
use saute_kitchen::kelvin;
use saute_kitchen::{InputError, InputText};

/// Largest step factor [-] (chosen: steps stay stable at any length, but tell nothing beyond).
const LONGEST_STEPS: f64 = 100.0;
/// Where a probe may be written.
const PLACES: &str = "write at_mm = [x, y, z] from the lowest body's corner (box), bottom centre (cylinder) or centre \
     (sphere), and [z] from the bottom of a slab or of a pan alone";

pub(super) type Checked<T> = Result<T, InputError>;

/// A case file under examination.
pub(super) struct Check<'a> {
    /// Its text.
    pub input: InputText<'a>,
    /// Foods and pans that it may name.
    pub library: &'a Library,
}

impl Check<'_> {
    pub(super) fn case(&self) -> Checked<Case> {
        let raw: CaseFile = self.input.parse("the keys and their types are listed by: saute schema lab")?;
        let duration = self.input.ranged("duration_s", &raw.duration_s, 1e-3, 1e7)?;
        let (shape, bodies) = self.bodies(&raw)?;
        let pan = raw.pan.as_ref().map(|p| self.pan(p)).transpose()?;
        let probes: Vec<ProbeCase> = self.probes(&raw, shape, &bodies)?;
        let mut case = Case {
            name: raw.name.clone().unwrap_or_else(|| self.input.file.to_owned()),
            outputs: self.outputs(&raw, duration)?,
            physics: if cooks(&raw) { Physics::Cooking } else { Physics::Conduction },
            rule: match raw.solver.rule {
                RuleEntry::ShapeFunctions => Rule::ShapeFunctions,
                RuleEntry::Segments => Rule::Segments,
            },
            step_factor: self
                .optional("step_factor", raw.solver.step_factor.as_ref(), 1e-3, LONGEST_STEPS)?
                .unwrap_or(1.0),
            materials: self.materials(&raw, bodies.len())?,
            cooking: self.cooking(&raw, bodies.len())?,
            phases: self.phases(&raw, shape, duration)?,
            flips: self.flips(&raw, shape, duration)?,
            stop_at: self.stop_at(&raw)?,
            volume_above_c: self.volume_above(&raw)?,
            peak_of: self.peak_of(&raw)?,
            compare: None,
            source: raw.source.clone().unwrap_or_default(),
            expectations: raw.expect.iter().map(|e| self.expectation(e, &raw)).collect::<Checked<_>>()?,
            duration,
            shape,
            bodies,
            pan: pan.map(|(pan, _)| pan),
            probes,
        };
        if let Some(compare) = &raw.compare {
            let flips = self.flip_times(shape, &compare.flips, duration)?;
            case.compare = Some(Box::new(Case { flips, ..case.clone() }));
        }
        Ok(case)
    }

    /// A number in its range, if it is given.
    pub(super) fn optional(
        &self,
        key: &str,
        value: Option<&Spanned<f64>>,
        low: f64,
        high: f64,
    ) -> Checked<Option<f64>> {
        value.map(|v| self.input.ranged(key, v, low, high)).transpose()
    }

    /// What cooking needs: one body of one food, without a pan below it.
    fn cooking(&self, raw: &CaseFile, bodies: usize) -> Checked<Option<CookingCase>> {
        let Some(physics) = raw.solver.physics.as_ref().filter(|_| cooks(raw)) else { return Ok(None) };
        let at = physics.span().start;
        let materials = raw.material.as_ref().map_or(&[][..], |m| m.get_ref().all());
        let Some(food) = materials.first().and_then(|m| m.food.as_ref()).filter(|_| bodies == 1 && raw.pan.is_none())
        else {
            let remedy = "give one [body] and food = \"beef-lean\" in [material]; for a pan write contact = \"pan\" \
                          into a [[boundary]], or cook a recipe with: saute cook";
            return self.input.error(at, "physics = \"cooking\" needs one body of one food", remedy);
        };
        if raw.probe.iter().any(|p| p.get_ref().flux) || raw.compare.is_some() {
            let remedy = "leave flux and [compare] out, or write physics = \"conduction\"";
            return self.input.error(at, "physics = \"cooking\" tells no flux and compares nothing", remedy);
        }
        // `materials` has found it.
        let description = &self.library.foods[food.get_ref()];
        Ok(Some(CookingCase {
            food: description.clone(),
            kinetics: self.library.kinetics[&description.kinetics].clone(),
            components: self.library.components.clone(),
            room: self.library.room.clone(),
        }))
    }

    fn volume_above(&self, raw: &CaseFile) -> Checked<Vec<f64>> {
        raw.report.volume_above_c.iter().map(|c| self.input.ranged("volume_above_c", c, -200.0, 5000.0)).collect()
    }

    fn stop_at(&self, raw: &CaseFile) -> Checked<Option<f64>> {
        let Some(stop) = &raw.stop else { return Ok(None) };
        let key = "when_every_point_has_reached_c";
        self.input.ranged(key, &stop.when_every_point_has_reached_c, -200.0, 5000.0).map(|c| Some(kelvin(c)))
    }

    fn peak_of(&self, raw: &CaseFile) -> Checked<Option<usize>> {
        raw.report.peak_of.as_ref().map(|name| self.probe_index(raw, name.get_ref(), name.span().start)).transpose()
    }

    pub(super) fn probe_index(&self, raw: &CaseFile, name: &str, at: usize) -> Checked<usize> {
        match raw.probe.iter().position(|p| p.get_ref().name == name) {
            Some(index) => Ok(index),
            // The pan is read after all others.
            None if raw.pan.is_some() && name == "pan" => Ok(raw.probe.len()),
            None => self.input.error(at, format!("there is no probe \"{name}\""), "name one of the [[probe]]s"),
        }
    }

    fn outputs(&self, raw: &CaseFile, duration: f64) -> Checked<Vec<f64>> {
        let Some(every) = &raw.output_every_s else { return Ok(vec![duration]) };
        let every = self.input.ranged("output_every_s", every, duration * 1e-5, f64::MAX)?;
        Ok(repeated(every, duration))
    }

    fn probes(&self, raw: &CaseFile, shape: Shape, bodies: &[BodyCase]) -> Checked<Vec<ProbeCase>> {
        let mut names: Vec<&str> = Vec::new();
        for probe in &raw.probe {
            let (name, at) = (probe.get_ref().name.as_str(), probe.span().start);
            if names.contains(&name) || name == "pan" && raw.pan.is_some() {
                return self.input.error(at, format!("the probe name \"{name}\" is taken"), "give it another name");
            }
            names.push(name);
        }
        raw.probe.iter().map(|p| self.probe(raw, shape, bodies, p.get_ref())).collect()
    }

    fn probe(&self, raw: &CaseFile, shape: Shape, bodies: &[BodyCase], probe: &ProbeEntry) -> Checked<ProbeCase> {
        let p: Vec<f64> = probe.at_mm.get_ref().iter().map(|mm| mm * 1e-3).collect();
        let at = probe.at_mm.span().start;
        let place = match bodies.first() {
            None => on_axes(Shape::Slab, &[self.pan_thickness(raw)?], &p).map(|_| vec![0.0]),
            Some(first) => {
                let mut size = first.size.clone();
                let height = size.len() - 1;
                size[height] = bodies.iter().map(|b| b.size[height]).sum();
                on_axes(shape, &size, &p)
            }
        };
        let Some(place) = place else {
            return self.input.error(at, format!("the probe \"{}\" lies outside the body", probe.name), PLACES);
        };
        if probe.flux && (bodies.is_empty() || vertical(shape).is_none()) {
            return self.input.error(at, "flux = true needs a body with a bottom and a top", "leave flux out");
        }
        Ok(ProbeCase { name: probe.name.clone(), place, flux: probe.flux })
    }

    fn expectation(&self, entry: &Spanned<ExpectEntry>, raw: &CaseFile) -> Checked<Expectation> {
        let (at, e) = (entry.span().start, entry.get_ref());
        let tolerance = match (e.tolerance, e.tolerance_pct) {
            (Some(t), None) => t,
            (None, Some(pct)) => e.value.abs() * pct / 100.0,
            _ => {
                let remedy = "write tolerance = 0.1 or tolerance_pct = 1";
                return self.input.error(at, "the expectation needs one tolerance", remedy);
            }
        };
        let of_probe = matches!(e.quantity, Quantity::Probe | Quantity::Flux);
        let subject = match (&e.probe, e.at_s) {
            (Some(name), Some(time)) if of_probe => {
                let probe = self.probe_index(raw, name, at)?;
                if e.quantity == Quantity::Flux && !raw.probe.get(probe).is_some_and(|p| p.get_ref().flux) {
                    return self.input.error(at, format!("the probe \"{name}\" tells no flux"), "give it flux = true");
                }
                Subject::Probe(e.quantity, name.clone(), time)
            }
            _ if of_probe => {
                let remedy = "write probe = \"centre\" and at_s = 60";
                return self.input.error(at, "the expectation names no probe and time", remedy);
            }
            (None, None) => Subject::Whole(e.quantity),
            _ => {
                let remedy = "leave them out";
                return self.input.error(at, "probe and at_s belong to quantity = \"probe\" or \"flux\"", remedy);
            }
        };
        Ok(Expectation { subject, value: e.value, tolerance })
    }
}

/// Whether a case asks for cooking.
pub(super) fn cooks(raw: &CaseFile) -> bool {
    raw.solver.physics.as_ref().is_some_and(|p| *p.get_ref() == Physics::Cooking)
}

/// Multiples of `every` up to and with `end`.
pub(super) fn repeated(every: f64, end: f64) -> Vec<f64> {
    let mut times: Vec<f64> = (1..).map(|i| every * f64::from(i)).take_while(|t| *t < end * (1.0 - 1e-9)).collect();
    times.push(end);
    times
}
