//! Checks a lab case file and converts it into SI units.

use saute_heat::Rule;
use toml::Spanned;

use crate::case::case_file::{CaseFile, Physics, RuleEntry};
use crate::case::lab_case::{Case, CookingCase, ProbeCase};
use crate::case::ranges::LEAST_INTERVAL;
use saute_kitchen::data::library::Library;
use saute_kitchen::kelvin;
use saute_schema::{InputError, InputText};

pub(super) type Checked<T> = Result<T, InputError>;

/// A case file that is being checked.
pub(super) struct Check<'a> {
    /// Text of the file.
    pub input: InputText<'a>,
    /// Library of the foods and pans that it can refer to.
    pub library: &'a Library,
}

impl Check<'_> {
    pub(super) fn case(&self) -> Checked<Case> {
        let raw: CaseFile = self.input.parse("the keys and their types are listed by: saute schema lab")?;
        let duration = *raw.duration_s.get_ref();
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
            step_factor: raw.solver.step_factor.as_ref().map_or(1.0, |v| *v.get_ref()),
            materials: self.materials(&raw, bodies.len())?,
            cooking: self.cooking(&raw, bodies.len())?,
            phases: self.phases(&raw, shape, duration)?,
            flips: self.flips(&raw, shape, duration)?,
            stop_at: raw.stop.as_ref().map(|stop| kelvin(*stop.when_every_point_has_reached_c.get_ref())),
            volume_above_c: raw.report.volume_above_c.iter().map(|c| *c.get_ref()).collect(),
            peak_of: self.peak_of(&raw)?,
            compare: None,
            source: raw.source.clone().unwrap_or_default(),
            evidence: raw.evidence,
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

    /// Returns a number, or an error if it is outside of its range.
    pub(super) fn ranged(&self, key: &str, value: &Spanned<f64>, [least, most]: [f64; 2]) -> Checked<f64> {
        self.input.ranged(key, value, least, most)
    }

    /// Returns the data for cooking, which needs one body of one food, without a pan below it.
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
            return self.input.error(at, "physics = \"cooking\" supports neither flux nor [compare]", remedy);
        }
        // `materials` has checked the id.
        let description = &self.library.foods[food.get_ref()];
        Ok(Some(CookingCase {
            food: description.clone(),
            kinetics: self.library.kinetics[&description.kinetics].clone(),
            components: self.library.components.clone(),
            room: self.library.room.clone(),
        }))
    }

    fn peak_of(&self, raw: &CaseFile) -> Checked<Option<usize>> {
        raw.report.peak_of.as_ref().map(|name| self.probe_index(raw, name.get_ref(), name.span().start)).transpose()
    }

    fn outputs(&self, raw: &CaseFile, duration: f64) -> Checked<Vec<f64>> {
        let Some(every) = &raw.output_every_s else { return Ok(vec![duration]) };
        let every = self.ranged("output_every_s", every, [duration * LEAST_INTERVAL, f64::MAX])?;
        Ok(repeated(every, duration))
    }
}

/// Returns true if a case uses the full food model.
pub(super) fn cooks(raw: &CaseFile) -> bool {
    raw.solver.physics.as_ref().is_some_and(|p| *p.get_ref() == Physics::Cooking)
}

/// Returns the multiples of `every` below `end`, then `end` [s].
pub(super) fn repeated(every: f64, end: f64) -> Vec<f64> {
    let mut times: Vec<f64> = (1..).map(|i| every * f64::from(i)).take_while(|t| *t < end * (1.0 - 1e-9)).collect();
    times.push(end);
    times
}
