//! Checks the probes of a lab case and its expected values.

use toml::Spanned;

use crate::case::body_file::Shape;
use crate::case::case_file::CaseFile;
use crate::case::check::{Check, Checked};
use crate::case::expect_file::{ExpectEntry, ProbeEntry, Quantity};
use crate::case::lab_case::{BodyCase, ProbeCase};
use crate::case::ranges::AT_MM;
use crate::result::verdict::{Expectation, Subject};
use crate::solve::body::{on_axes, vertical};

/// Remedy for a probe outside of the body.
const PLACES: &str = "write at_mm = [x, y, z] from the lowest body's corner (box), bottom centre (cylinder) or centre \
     (sphere), and [z] from the bottom of a slab or of a pan alone";

impl Check<'_> {
    /// Returns the index of a probe by its name; the index of the pan follows all others.
    pub(super) fn probe_index(&self, raw: &CaseFile, name: &str, at: usize) -> Checked<usize> {
        match raw.probe.iter().position(|p| p.get_ref().name == name) {
            Some(index) => Ok(index),
            None if raw.pan.is_some() && name == "pan" => Ok(raw.probe.len()),
            None => self.input.error(at, format!("there is no probe \"{name}\""), "name one of the [[probe]]s"),
        }
    }

    pub(super) fn probes(&self, raw: &CaseFile, shape: Shape, bodies: &[BodyCase]) -> Checked<Vec<ProbeCase>> {
        let mut names: Vec<&str> = Vec::new();
        for probe in &raw.probe {
            let (name, at) = (probe.get_ref().name.as_str(), probe.span().start);
            if names.contains(&name) || name == "pan" && raw.pan.is_some() {
                return self.input.error(at, format!("the probe name \"{name}\" is already used"), "use another name");
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
        let in_range = probe.at_mm.get_ref().iter().all(|mm| (AT_MM[0]..=AT_MM[1]).contains(mm));
        let Some(place) = place.filter(|_| in_range) else {
            return self.input.error(at, format!("the probe \"{}\" lies outside the body", probe.name), PLACES);
        };
        if probe.flux && (bodies.is_empty() || vertical(shape).is_none()) {
            return self.input.error(at, "flux = true needs a body with a bottom and a top", "leave flux out");
        }
        Ok(ProbeCase { name: probe.name.clone(), place, flux: probe.flux })
    }

    pub(super) fn expectation(&self, entry: &Spanned<ExpectEntry>, raw: &CaseFile) -> Checked<Expectation> {
        let e = entry.get_ref();
        let value = *e.value.get_ref();
        let tolerance = self.tolerance(entry, value)?;
        Ok(Expectation { subject: self.subject(entry, raw)?, value, tolerance })
    }

    /// Returns the largest absolute error, from exactly one of the two keys.
    fn tolerance(&self, entry: &Spanned<ExpectEntry>, value: f64) -> Checked<f64> {
        let e = entry.get_ref();
        match (&e.tolerance, &e.tolerance_pct) {
            (Some(t), None) => Ok(*t.get_ref()),
            (None, Some(pct)) => Ok(value.abs() * pct.get_ref() / 100.0),
            _ => {
                let remedy = "write tolerance = 0.1 or tolerance_pct = 1";
                self.input.error(entry.span().start, "the expectation needs exactly one tolerance", remedy)
            }
        }
    }

    fn subject(&self, entry: &Spanned<ExpectEntry>, raw: &CaseFile) -> Checked<Subject> {
        let (at, e) = (entry.span().start, entry.get_ref());
        let of_probe = matches!(e.quantity, Quantity::Probe | Quantity::Flux);
        match (&e.probe, &e.at_s) {
            (Some(name), Some(time)) if of_probe => {
                let probe = self.probe_index(raw, name, at)?;
                if e.quantity == Quantity::Flux && !raw.probe.get(probe).is_some_and(|p| p.get_ref().flux) {
                    let message = format!("the probe \"{name}\" does not report its flux");
                    return self.input.error(at, message, "give it flux = true");
                }
                Ok(Subject::Probe(e.quantity, name.clone(), *time.get_ref()))
            }
            _ if of_probe => {
                let remedy = "write probe = \"centre\" and at_s = 60";
                self.input.error(at, "the expectation names no probe and time", remedy)
            }
            (None, None) => Ok(Subject::Whole(e.quantity)),
            _ => {
                let message = "probe and at_s are only valid for quantity = \"probe\" or \"flux\"";
                self.input.error(at, message, "leave them out")
            }
        }
    }
}
