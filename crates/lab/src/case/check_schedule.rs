//! Checks the phases of a lab case and its flips.

use saute_heat::conduction::axis::End;
use toml::Spanned;

use crate::case::body_file::Shape;
use crate::case::boundary_file::{BoundaryEntry, Face, FlipsEntry, PhaseEntry};
use crate::case::case_file::CaseFile;
use crate::case::check::{Check, Checked, repeated};
use crate::case::lab_case::{Phase, Until};
use crate::case::ranges::{LEAST_INTERVAL, TIME_S};
use crate::solve::body::{ends, vertical};
use saute_kitchen::kelvin;

impl Check<'_> {
    /// Returns the phases, each with the common boundaries and its own; a single endless phase by default.
    pub(super) fn phases(&self, raw: &CaseFile, shape: Shape, duration: f64) -> Checked<Vec<Phase>> {
        let mut always = Phase { boundaries: Vec::new(), media: Vec::new(), until: Until::Forever };
        if let Some(pan) = &raw.pan {
            always.boundaries.push((vertical(shape).unwrap_or(0), End::Low, self.pan(pan)?.1));
        }
        self.add_boundaries(raw, shape, &raw.boundary, &mut always)?;
        if raw.phase.is_empty() {
            return Ok(vec![always]);
        }
        let phase = |(i, entry): (usize, &Spanned<PhaseEntry>)| {
            let mut phase = always.clone();
            self.add_boundaries(raw, shape, &entry.get_ref().boundary, &mut phase)?;
            phase.until = self.until(raw, entry, i + 1 == raw.phase.len(), duration)?;
            Ok(phase)
        };
        raw.phase.iter().enumerate().map(phase).collect()
    }

    fn until(&self, raw: &CaseFile, entry: &Spanned<PhaseEntry>, last: bool, duration: f64) -> Checked<Until> {
        let at = entry.get_ref().until.as_ref().map_or(entry.span().start, |u| u.span().start);
        let until = entry.get_ref().until.as_ref().map(Spanned::get_ref);
        match until.map(|u| (&u.at_s, &u.probe, &u.reaches_c)) {
            None if last => Ok(Until::Forever),
            Some((Some(time), None, None)) => Ok(Until::Time(self.ranged("at_s", time, [TIME_S[0], duration])?)),
            Some((None, Some(probe), Some(c))) => {
                let target = kelvin(*c.get_ref());
                Ok(Until::Probe(self.probe_index(raw, probe, at)?, target))
            }
            _ => self.input.error(
                at,
                "the phase has no end",
                "write until = { at_s = 60 } within the duration, or until = { probe = \"centre\", reaches_c = 50 }; \
                 it is optional in the last phase",
            ),
        }
    }

    /// Adds boundaries to the ends of the axes; a later entry replaces an earlier one.
    fn add_boundaries(
        &self,
        raw: &CaseFile,
        shape: Shape,
        entries: &[Spanned<BoundaryEntry>],
        found: &mut Phase,
    ) -> Checked<()> {
        for entry in entries {
            let face = &entry.get_ref().face;
            let Some(mut ends) = ends(shape, *face.get_ref()) else {
                let remedy = "use those of all, bottom, top, side, x, y and z that the shape has";
                return self.input.error(face.span().start, "the shape has no such face", remedy);
            };
            if raw.pan.is_some() {
                if *face.get_ref() == Face::Bottom || raw.body.is_none() {
                    let remedy = "write h_w_m2k, ambient_c and q_w_m2 of the pan into [pan]";
                    return self.input.error(face.span().start, "the bottom lies on the pan", remedy);
                }
                ends.retain(|(axis, end)| (Some(*axis), *end) != (vertical(shape), End::Low));
            }
            let (boundary, medium) = self.boundary(raw, entry)?;
            for (axis, end) in ends {
                found.boundaries.retain(|f| (f.0, f.1) != (axis, end));
                found.media.retain(|f| (f.0, f.1) != (axis, end));
                found.boundaries.push((axis, end, boundary));
                found.media.push((axis, end, medium));
            }
        }
        Ok(())
    }

    pub(super) fn flips(&self, raw: &CaseFile, shape: Shape, duration: f64) -> Checked<Vec<f64>> {
        let Some(entry) = &raw.flips else { return Ok(Vec::new()) };
        if raw.pan.is_some() {
            let remedy =
                "leave [flips] out, or put the plate's h_w_m2k and ambient_c into [[boundary]] instead of [pan]";
            return self.input.error(entry.span().start, "a body on a pan cannot be flipped", remedy);
        }
        self.flip_times(shape, entry, duration)
    }

    pub(super) fn flip_times(&self, shape: Shape, entry: &Spanned<FlipsEntry>, duration: f64) -> Checked<Vec<f64>> {
        let (at, flips) = (entry.span().start, entry.get_ref());
        if vertical(shape).is_none() {
            return self.input.error(at, "a sphere has no bottom to flip", "leave [flips] out");
        }
        match (&flips.at_s, &flips.every_s) {
            (Some(times), None) if times.iter().all(|t| (TIME_S[0]..=duration).contains(t)) && times.is_sorted() => {
                Ok(times.clone())
            }
            (None, Some(every)) => {
                let every = self.ranged("every_s", every, [duration * LEAST_INTERVAL, f64::MAX])?;
                let mut times = repeated(every, duration);
                times.pop();
                Ok(times)
            }
            _ => self.input.error(
                at,
                "flips need either at_s, ascending and within the duration, or every_s",
                "write at_s = [300] or every_s = 30",
            ),
        }
    }
}
