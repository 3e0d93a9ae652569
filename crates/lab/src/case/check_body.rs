//! Checks the bodies of a lab case and its pan.

use saute_heat::conduction::boundary::Boundary;
use toml::Spanned;

use crate::case::body_file::{BodyEntry, PanEntry, Shape};
use crate::case::case_file::CaseFile;
use crate::case::check::{Check, Checked, cooks};
use crate::case::lab_case::{BodyCase, PanCase};
use crate::case::ranges::{RESOLUTION_MM, SIZE_MM};
use crate::solve::body::{node_count, sizes, vertical};
use saute_kitchen::data::library::Library;
use saute_kitchen::kelvin;

/// Largest number of nodes of a case [-] (chosen: 0.5 GB of memory).
const MOST_NODES: f64 = 4e6;
/// Default spacing over the smallest size, and default steepness of the grading [-] (chosen: 40 cells across, spacing
/// at a face 0.42 of the largest).
const DEFAULT_MESH: [f64; 2] = [1.0 / 40.0, 1.0];
/// The same for cooking, which needs fine layers in the crust only (chosen: the time to a core temperature is within
/// 0.5 % of that on a mesh four times as fine).
const COOKING_MESH: [f64; 2] = [1.0 / 16.0, 1.5];
/// Smallest spacing of a short axis over that of the longest [-] (chosen: the value for the thickness of a steak, a
/// quarter of its length; a rod needs no more).
const FINEST_SHARE: f64 = 0.5;

impl Check<'_> {
    /// Returns the shape and the bodies, lowest first.
    pub(super) fn bodies(&self, raw: &CaseFile) -> Checked<(Shape, Vec<BodyCase>)> {
        let Some(entries) = raw.body.as_ref().map(|b| b.all()).filter(|b| !b.is_empty()) else {
            return match raw.pan {
                Some(_) => Ok((Shape::Slab, Vec::new())),
                None => self.input.error(0, "the case has neither a body nor a pan", "write [body] or [pan]"),
            };
        };
        let shape = entries[0].shape;
        let bodies: Vec<BodyCase> = entries.iter().map(|e| self.body(e, cooks(raw))).collect::<Checked<_>>()?;
        for (i, (entry, body)) in entries.iter().zip(&bodies).enumerate() {
            self.fits(shape, &bodies[0], entry, body)?;
            if let (0, None, Some(contact)) = (i, &raw.pan, &entry.contact_h_w_m2k) {
                let remedy = "leave it out, or move it to the [[body]] above";
                return self.input.error(
                    contact.span().start,
                    "contact_h_w_m2k: there is no body or pan below this body",
                    remedy,
                );
            }
        }
        if (bodies.len() > 1 || raw.pan.is_some()) && vertical(shape).is_none() {
            let at = entries[0].size_mm.span().start;
            return self.input.error(
                at,
                "a sphere cannot be stacked or lie on a pan",
                "use a slab, a box or a cylinder",
            );
        }
        let nodes = node_count(shape, &bodies);
        if nodes > MOST_NODES {
            let given = entries[0].resolution_mm.as_ref().map_or(entries[0].size_mm.span().start, |r| r.span().start);
            let message = format!("resolution_mm makes about {nodes:.1e} nodes; at most {MOST_NODES:.1e} are allowed");
            return self.input.error(given, message, "use a larger resolution_mm");
        }
        Ok((shape, bodies))
    }

    /// Returns an error unless the body has the shape and the footprint of the first.
    fn fits(&self, shape: Shape, first: &BodyCase, entry: &BodyEntry, body: &BodyCase) -> Checked<()> {
        let across = body.size.len() - 1;
        if entry.shape == shape && body.size[..across] == first.size[..across] {
            return Ok(());
        }
        let remedy = "give all of them the shape of the lowest one and its sizes except for the height";
        self.input.error(entry.size_mm.span().start, "the bodies of a stack differ in shape or footprint", remedy)
    }

    fn body(&self, entry: &BodyEntry, cooks: bool) -> Checked<BodyCase> {
        let size = self.size(entry)?;
        let default_grading = if cooks { COOKING_MESH } else { DEFAULT_MESH }[1];
        Ok(BodyCase {
            resolution: self.resolution(entry, &size, cooks)?,
            grading: entry.grading.as_ref().map_or(default_grading, |v| *v.get_ref()),
            initial: kelvin(*entry.initial_c.get_ref()),
            contact: entry.contact_h_w_m2k.as_ref().map(|v| *v.get_ref()),
            size,
        })
    }

    fn size(&self, body: &BodyEntry) -> Checked<Vec<f64>> {
        let (names, given) = (sizes(body.shape), body.size_mm.get_ref());
        let at = body.size_mm.span().start;
        if given.len() != names.len() {
            let remedy = format!("write size_mm = [{}]", names.join(", "));
            return self.input.error(at, "size_mm does not match the shape", remedy);
        }
        for (name, mm) in names.iter().zip(given) {
            let [least, most] = SIZE_MM;
            if !(least..=most).contains(mm) {
                let message = format!("size_mm: the {name} of {mm} mm is out of range");
                return self.input.error(at, message, format!("the {name} may be {least} to {most} mm"));
            }
        }
        Ok(given.iter().map(|mm| mm * 1e-3).collect())
    }

    fn resolution(&self, body: &BodyEntry, size: &[f64], cooks: bool) -> Checked<Vec<f64>> {
        let default_share = if cooks { COOKING_MESH } else { DEFAULT_MESH }[0];
        let smallest = size.iter().copied().fold(f64::INFINITY, f64::min);
        let longest = size.iter().copied().fold(0.0, f64::max);
        let Some(given) = &body.resolution_mm else {
            // Cooking needs fine layers at every face and a coarse interior, so each axis is divided by its own size.
            let share = |s: &f64| if cooks { *s } else { smallest } * default_share;
            return Ok(size.iter().map(share).collect());
        };
        let (at, all) = (given.span().start, given.get_ref().all());
        if all.len() != 1 && all.len() != size.len() {
            let remedy = format!("write one number, or {} as in size_mm", size.len());
            return self.input.error(at, "resolution_mm does not match size_mm", remedy);
        }
        let along = |axis: usize| {
            let mm = all[axis.min(all.len() - 1)];
            let most = if all.len() == 1 { smallest } else { size[axis] } * 1e3 / 2.0;
            if (RESOLUTION_MM[0]..=most).contains(&mm) {
                // One number applies to the longest axis. A shorter axis heats through sooner, with steeper profiles.
                let share = if all.len() == 1 { libm::sqrt(size[axis] / longest).max(FINEST_SHARE) } else { 1.0 };
                return Ok(mm * 1e-3 * share);
            }
            let message = format!("resolution_mm = {mm} is out of range");
            self.input.error(
                at,
                message,
                format!("resolution_mm may be {} to {most} here, half the size", RESOLUTION_MM[0]),
            )
        };
        (0..size.len()).map(along).collect()
    }

    /// Returns the pan and the Robin boundary of its underside.
    pub(super) fn pan(&self, entry: &Spanned<PanEntry>) -> Checked<(PanCase, Boundary)> {
        let pan = entry.get_ref();
        let [thickness, density, specific_heat] = self.plate(entry)?;
        let initial = kelvin(*pan.initial_c.get_ref());
        let q = pan.q_w_m2.as_ref().map_or(0.0, |v| *v.get_ref());
        let h = pan.h_w_m2k.as_ref().map_or(0.0, |v| *v.get_ref());
        let outside = pan.ambient_c.as_ref().map_or(initial, |c| kelvin(*c.get_ref()));
        let plate = PanCase { capacity: thickness * density * specific_heat, initial, thickness };
        Ok((plate, Boundary::Exchange { h, source: h * outside + q }))
    }

    pub(super) fn pan_thickness(&self, raw: &CaseFile) -> Checked<f64> {
        raw.pan.as_ref().map_or(Ok(0.0), |p| self.pan(p).map(|(pan, _)| pan.thickness))
    }

    /// Returns thickness [m], density [kg/m³] and specific heat [J/(kg·K)] of a pan; explicit numbers override those of
    /// its kind.
    fn plate(&self, entry: &Spanned<PanEntry>) -> Checked<[f64; 3]> {
        let pan = entry.get_ref();
        let own = [
            pan.thickness_mm.as_ref().map(|mm| mm.get_ref() * 1e-3),
            pan.density_kg_m3.as_ref().map(|v| *v.get_ref()),
            pan.specific_heat_j_kgk.as_ref().map(|v| *v.get_ref()),
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
            let why = self.library.absence("pans", kind.get_ref(), "is not a pan");
            return self.input.error(kind.span().start, format!("kind = \"{}\" {why}", kind.get_ref()), remedy);
        };
        let its = [found.floor.thickness_mm * 1e-3, found.metal.density_kg_m3, found.metal.specific_heat_j_kgk];
        Ok([0, 1, 2].map(|i| own[i].unwrap_or(its[i])))
    }
}
