//! Lab cases: checked, in SI units, ready to run.

use saute_food::components::Properties;
use saute_heat::tensor::End;
use toml::Spanned;

use crate::input_error::{InputError, InputText};
use crate::kelvin;
use crate::lab::body::{axes, ends, node_count, on_axes, sizes, vertical};
use crate::lab::case_file::{
    BodyEntry, BoundaryEntry, CaseFile, ExpectEntry, FlipsEntry, MaterialEntry, ProbeEntry, Quantity, Shape,
};
use crate::lab::material::Material;
use crate::lab::verdict::{Expectation, Subject};
use crate::library::Library;

/// Most nodes a body may have (chosen: 1 GB of memory).
const MOST_NODES: usize = 4_000_000;
/// Spacing over the smallest size where no resolution is given [-] (chosen: 40 cells across).
const DEFAULT_RESOLUTION: f64 = 1.0 / 40.0;

/// A case, checked.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name for people.
    pub name: String,
    /// How long [s].
    pub duration: f64,
    /// Times at which probes are read, ascending, the end included [s].
    pub outputs: Vec<f64>,
    /// Shape.
    pub shape: Shape,
    /// Sizes [m].
    pub size: Vec<f64>,
    /// Largest spacing [m].
    pub resolution: f64,
    /// Start temperature [K].
    pub initial: f64,
    /// What it is made of.
    pub material: Material,
    /// Boundary of each end of each axis: axis, end, boundary.
    pub boundaries: Vec<(usize, End, Boundary)>,
    /// Times of the flips, ascending [s].
    pub flips: Vec<f64>,
    /// Names and places on the axes [m].
    pub probes: Vec<(String, Vec<f64>)>,
    /// Stop once every point has reached this [K].
    pub stop_at: Option<f64>,
    /// Tell the share of the volume ever above these [°C].
    pub volume_above_c: Vec<f64>,
    /// Where the expected values come from.
    pub source: String,
    /// What should come out.
    pub expectations: Vec<Expectation>,
}

/// What lies outside a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Boundary {
    /// Convection [W/(m²·K)] towards a temperature [K].
    Convective {
        /// Heat transfer coefficient [W/(m²·K)].
        h: f64,
        /// Temperature outside [K].
        outside: f64,
    },
    /// A given surface temperature [K].
    Fixed(f64),
}

type Checked<T> = Result<T, InputError>;

impl Case {
    /// Reads and checks a case. `file` is its name in messages.
    pub fn parse(text: &str, file: &str, library: &Library) -> Checked<Self> {
        Check { input: InputText { text, file }, library }.case()
    }
}

struct Check<'a> {
    input: InputText<'a>,
    library: &'a Library,
}

impl Check<'_> {
    fn case(&self) -> Checked<Case> {
        let raw: CaseFile = self.input.parse("the keys and their types are listed by: saute schema lab")?;
        let duration = self.input.ranged("duration_s", &raw.duration_s, 1e-3, 1e7)?;
        let body = raw.body.get_ref();
        let size = self.size(body)?;
        Ok(Case {
            name: raw.name.clone().unwrap_or_else(|| self.input.file.to_owned()),
            outputs: self.outputs(&raw, duration)?,
            duration,
            resolution: self.resolution(body, &size)?,
            initial: kelvin(self.input.ranged("initial_c", &body.initial_c, -40.0, 400.0)?),
            material: self.material(&raw.material)?,
            boundaries: self.boundaries(body.shape, &raw.boundary)?,
            flips: self.flips(body.shape, raw.flips.as_ref(), duration)?,
            probes: raw.probe.iter().map(|p| self.probe(body.shape, &size, p.get_ref())).collect::<Checked<_>>()?,
            stop_at: raw.stop.as_ref().map(|s| kelvin(s.when_every_point_has_reached_c)),
            volume_above_c: raw.report.as_ref().map(|r| r.volume_above_c.clone()).unwrap_or_default(),
            source: raw.source.clone().unwrap_or_default(),
            expectations: raw.expect.iter().map(|e| self.expectation(e, &raw)).collect::<Checked<_>>()?,
            shape: body.shape,
            size,
        })
    }

    fn size(&self, body: &BodyEntry) -> Checked<Vec<f64>> {
        let (names, given) = (sizes(body.shape), body.size_mm.get_ref());
        let at = body.size_mm.span().start;
        if given.len() != names.len() {
            return self.input.error(
                at,
                "size_mm does not fit the shape",
                format!("write size_mm = [{}]", names.join(", ")),
            );
        }
        for (name, mm) in names.iter().zip(given) {
            if !(0.01..=10_000.0).contains(mm) {
                return self.input.error(
                    at,
                    format!("size_mm: the {name} of {mm} mm is out of range"),
                    format!("the {name} may be 0.01 to 10000 mm"),
                );
            }
        }
        Ok(given.iter().map(|mm| mm * 1e-3).collect())
    }

    fn resolution(&self, body: &BodyEntry, size: &[f64]) -> Checked<f64> {
        let smallest = size.iter().copied().fold(f64::INFINITY, f64::min);
        let Some(given) = &body.resolution_mm else { return Ok(smallest * DEFAULT_RESOLUTION) };
        let resolution = 1e-3 * self.input.ranged("resolution_mm", given, 1e-3, 1e3 * smallest / 2.0)?;
        let nodes: f64 = size.iter().map(|s| s / resolution + 3.0).product();
        if nodes > MOST_NODES as f64 || node_count(&axes(body.shape, size, resolution)) > MOST_NODES {
            let message = format!("resolution_mm makes about {nodes:.1e} nodes; at most {MOST_NODES} are allowed");
            return self.input.error(given.span().start, message, "use a larger resolution_mm");
        }
        Ok(resolution)
    }

    fn material(&self, entry: &Spanned<MaterialEntry>) -> Checked<Material> {
        let (at, m) = (entry.span().start, entry.get_ref());
        match (&m.conductivity_w_mk, &m.density_kg_m3, &m.specific_heat_j_kgk, &m.food) {
            (Some(k), Some(rho), Some(c), None) => Ok(Material::Constant {
                conductivity: self.input.ranged("conductivity_w_mk", k, 1e-4, 1e4)?,
                capacity: self.input.ranged("density_kg_m3", rho, 1e-2, 1e5)?
                    * self.input.ranged("specific_heat_j_kgk", c, 1.0, 1e5)?,
            }),
            (None, None, None, Some(food)) => self.food(food),
            _ => self.input.error(
                at,
                "the material is incomplete or given twice",
                "give conductivity_w_mk, density_kg_m3 and specific_heat_j_kgk, or food alone",
            ),
        }
    }

    fn food(&self, id: &Spanned<String>) -> Checked<Material> {
        let Some(food) = self.library.foods.get(id.get_ref()) else {
            let remedy = format!("use one of: {}", Library::names(&self.library.foods));
            return self.input.error(id.span().start, format!("food = \"{}\" is not a food", id.get_ref()), remedy);
        };
        let properties = Properties::new(&self.library.components, &food.lean, &food.fat_melting);
        let fractions = [food.lean.water, food.lean.lean_solids(), food.lean.fat];
        let density = 1.0 / properties.volume(&fractions, kelvin(20.0));
        Ok(Material::Food { properties: Box::new(properties), masses: fractions.map(|x| x * density) })
    }

    fn expectation(&self, entry: &Spanned<ExpectEntry>, raw: &CaseFile) -> Checked<Expectation> {
        let (at, e) = (entry.span().start, entry.get_ref());
        let tolerance = match (e.tolerance, e.tolerance_pct) {
            (Some(t), None) => t,
            (None, Some(pct)) => e.value.abs() * pct / 100.0,
            _ => {
                return self.input.error(
                    at,
                    "the expectation needs one tolerance",
                    "write tolerance = 0.1 or tolerance_pct = 1",
                );
            }
        };
        let subject = match (e.quantity, &e.probe, e.at_s) {
            (Quantity::Probe, Some(name), Some(time)) if raw.probe.iter().any(|p| &p.get_ref().name == name) => {
                Subject::Probe(name.clone(), time)
            }
            (Quantity::Probe, _, _) => {
                return self.input.error(
                    at,
                    "the expectation names no probe and time",
                    "write probe = \"centre\" and at_s = 60",
                );
            }
            (other, None, None) => Subject::Whole(other),
            _ => return self.input.error(at, "probe and at_s belong to quantity = \"probe\"", "leave them out"),
        };
        Ok(Expectation { subject, value: e.value, tolerance })
    }

    /// Boundaries by end, a later entry in place of an earlier one.
    fn boundaries(&self, shape: Shape, entries: &[Spanned<BoundaryEntry>]) -> Checked<Vec<(usize, End, Boundary)>> {
        let mut found: Vec<(usize, End, Boundary)> = Vec::new();
        for entry in entries {
            let b = entry.get_ref();
            let Some(ends) = ends(shape, *b.face.get_ref()) else {
                return self.input.error(
                    b.face.span().start,
                    "the body has no such face",
                    "use all, bottom, top, side, x, y or z as far as the shape has them",
                );
            };
            let outside = kelvin(self.input.ranged("ambient_c", &b.ambient_c, -200.0, 2000.0)?);
            let boundary = match (&b.h_w_m2k, b.fixed) {
                (Some(h), false) => Boundary::Convective { h: self.input.ranged("h_w_m2k", h, 0.0, 1e7)?, outside },
                (None, true) => Boundary::Fixed(outside),
                _ => {
                    return self.input.error(
                        entry.span().start,
                        "the boundary needs one of h_w_m2k and fixed",
                        "write h_w_m2k = 25, or fixed = true",
                    );
                }
            };
            for (axis, end) in ends {
                found.retain(|f| (f.0, f.1) != (axis, end));
                found.push((axis, end, boundary));
            }
        }
        Ok(found)
    }

    fn outputs(&self, raw: &CaseFile, duration: f64) -> Checked<Vec<f64>> {
        let Some(every) = &raw.output_every_s else { return Ok(vec![duration]) };
        let every = self.input.ranged("output_every_s", every, duration * 1e-5, f64::INFINITY)?;
        Ok(repeated(every, duration))
    }

    fn flips(&self, shape: Shape, entry: Option<&Spanned<FlipsEntry>>, duration: f64) -> Checked<Vec<f64>> {
        let Some(entry) = entry else { return Ok(Vec::new()) };
        let (at, flips) = (entry.span().start, entry.get_ref());
        if vertical(shape).is_none() {
            return self.input.error(at, "a sphere has no bottom to flip", "leave [flips] out");
        }
        match (&flips.at_s, flips.every_s) {
            (Some(times), None) if times.iter().all(|t| (0.0..=duration).contains(t)) && times.is_sorted() => {
                Ok(times.clone())
            }
            (None, Some(every)) if every > duration * 1e-5 => {
                let mut times = repeated(every, duration);
                times.pop();
                Ok(times)
            }
            _ => self.input.error(
                at,
                "flips need at_s, ascending and within the duration, or every_s > 0",
                "write at_s = [300] or every_s = 30",
            ),
        }
    }

    fn probe(&self, shape: Shape, size: &[f64], probe: &ProbeEntry) -> Checked<(String, Vec<f64>)> {
        let p: Vec<f64> = probe.at_mm.get_ref().iter().map(|mm| mm * 1e-3).collect();
        match on_axes(shape, size, &p) {
            Some(place) => Ok((probe.name.clone(), place)),
            None => {
                let message = format!("the probe \"{}\" lies outside the body", probe.name);
                self.input.error(probe.at_mm.span().start, message, "write at_mm = [x, y, z] from the body's corner (box, slab), bottom centre (cylinder) or centre (sphere); a slab needs z alone")
            }
        }
    }
}

/// Multiples of `every` up to and with `end`.
fn repeated(every: f64, end: f64) -> Vec<f64> {
    let mut times: Vec<f64> = (1..).map(|i| every * f64::from(i)).take_while(|t| *t < end * (1.0 - 1e-9)).collect();
    times.push(end);
    times
}
