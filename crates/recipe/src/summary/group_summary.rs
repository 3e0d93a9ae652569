//! The result of a group: means over its pieces and their spread.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use saute_food::Scale;
use saute_kitchen::doneness::FROZEN;
use serde::Serialize;

use crate::recipe::Group;
use crate::summary::cook_summary::{
    ByScale, ClassShares, CoreSummary, Doneness, FoodSummary, IN_PAN, LogReduction, ScaleReading, Shape, StartEnd,
    Surface, Surfaces, WaterSummary,
};

/// A group of foods.
#[derive(Clone, Debug, Serialize)]
pub struct GroupSummary {
    /// Means over the pieces, under the group's id. Log reductions are the smallest of all pieces, because safety is not an
    /// average.
    #[serde(flatten)]
    pub mean: FoodSummary,
    /// Number of pieces.
    pub count: usize,
    /// Number of pieces in the pan.
    pub in_pan: usize,
    /// Spread over the pieces.
    pub spread: Spread,
    /// Indices into the foods.
    #[serde(skip)]
    pub members: Range<usize>,
}

/// Smallest and largest value over the pieces of a group.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Spread {
    /// Core at the end [°C].
    pub core_end_c: [f64; 2],
    /// Highest core temperature [°C].
    pub core_peak_c: [f64; 2],
    /// Mass loss relative to the initial mass [%].
    pub lost_pct: [f64; 2],
    /// Browned area of both faces [%].
    pub browned_pct: [f64; 2],
}

impl GroupSummary {
    /// Summarises a group from the results of its pieces.
    pub(crate) fn new(group: &Group, pieces: &[FoodSummary], scales: &[Arc<Scale>]) -> Self {
        let extremes = |value: fn(&FoodSummary) -> f64| {
            let values = pieces.iter().map(value);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
        };
        Self {
            mean: mean_food(group, pieces, scales),
            count: pieces.len(),
            in_pan: pieces.iter().filter(|p| p.place == IN_PAN).count(),
            spread: Spread {
                core_end_c: extremes(|p| p.core_c.end),
                core_peak_c: extremes(|p| p.core_c.peak),
                lost_pct: extremes(|p| p.lost_pct),
                browned_pct: extremes(FoodSummary::browned_pct),
            },
            members: group.members.clone(),
        }
    }
}

impl FoodSummary {
    /// Returns the mean browned area of both faces [%].
    pub fn browned_pct(&self) -> f64 {
        0.5 * (self.surfaces.top.browned_pct + self.surfaces.bottom.browned_pct)
    }
}

/// At least one piece, all of one kind.
struct Pieces<'a>(&'a [FoodSummary]);

impl Pieces<'_> {
    fn mean(&self, value: impl Fn(&FoodSummary) -> f64) -> f64 {
        self.0.iter().map(value).sum::<f64>() / self.0.len() as f64
    }

    fn least(&self, value: impl Fn(&FoodSummary) -> f64) -> f64 {
        self.0.iter().map(value).fold(f64::INFINITY, f64::min)
    }

    fn doneness(&self, of: impl Fn(&FoodSummary) -> Doneness) -> Doneness {
        Doneness {
            raw: self.mean(|p| of(p).raw),
            rare: self.mean(|p| of(p).rare),
            medium: self.mean(|p| of(p).medium),
            well_done: self.mean(|p| of(p).well_done),
        }
    }

    /// Returns the mean reading by every scale. Pieces of one kind have the same scales in the same order.
    fn by_scale(&self, scales: &[Arc<Scale>]) -> ByScale {
        let Some(first) = self.0.first() else { return ByScale::default() };
        let reading = |(k, (id, reading)): (usize, &(String, ScaleReading))| {
            let shares = |of: fn(&ScaleReading) -> &ClassShares| self.shares(|p| of(&p.doneness.0[k].1));
            let scale = scales.iter().find(|s| s.id == *id);
            let at_core = self.mean(|p| p.doneness.0[k].1.at_core);
            let frozen = self.0.iter().all(|p| p.doneness.0[k].1.class == FROZEN);
            let of_mean = || scale.map_or(reading.class.as_str(), |s| s.name_of(at_core));
            let class = if frozen { FROZEN } else { of_mean() }.to_owned();
            let (section_pct, volume_pct) = (shares(|r| &r.section_pct), shares(|r| &r.volume_pct));
            (id.clone(), ScaleReading { label: reading.label.clone(), class, at_core, section_pct, volume_pct })
        };
        ByScale(first.doneness.0.iter().enumerate().map(reading).collect())
    }

    fn shares<'a>(&'a self, of: impl Fn(&'a FoodSummary) -> &'a ClassShares) -> ClassShares {
        let mean = |(class, (name, _)): (usize, &(String, f64))| {
            (name.clone(), self.0.iter().map(|p| of(p).0[class].1).sum::<f64>() / self.0.len() as f64)
        };
        ClassShares(self.0.first().map(|p| of(p).0.iter().enumerate().map(mean).collect()).unwrap_or_default())
    }

    fn denatured(&self) -> BTreeMap<String, f64> {
        let names = self.0.first().map(|p| p.denatured.keys()).into_iter().flatten();
        names.map(|name| (name.clone(), self.mean(|p| p.denatured[name]))).collect()
    }

    fn surface(&self, of: impl Fn(&FoodSummary) -> Surface) -> Surface {
        Surface {
            temperature_c: self.mean(|p| of(p).temperature_c),
            lab: core::array::from_fn(|k| self.mean(|p| of(p).lab[k])),
            browned_pct: self.mean(|p| of(p).browned_pct),
            charred_pct: self.mean(|p| of(p).charred_pct),
        }
    }

    fn shape(&self) -> Shape {
        Shape {
            volume_pct: self.mean(|p| p.shape.volume_pct),
            across_pct: self.mean(|p| p.shape.across_pct),
            thickness_mm: self.mean(|p| p.shape.thickness_mm),
            dome_mm: self.mean(|p| p.shape.dome_mm),
            waves_mm: self.mean(|p| p.shape.waves_mm),
            curl_deg: self.mean(|p| p.shape.curl_deg),
        }
    }

    /// Returns the place of all pieces, or "several".
    fn place(&self) -> &'static str {
        let first = self.0.first().map_or("waiting", |p| p.place);
        if self.0.iter().all(|p| p.place == first) { first } else { "several" }
    }
}

fn mean_food(group: &Group, pieces: &[FoodSummary], scales: &[Arc<Scale>]) -> FoodSummary {
    let all = Pieces(pieces);
    FoodSummary {
        id: group.id.clone(),
        kind: group.kind.clone(),
        group: None,
        place: all.place(),
        nodes: libm::round(all.mean(|p| p.nodes as f64)) as usize,
        mass_g: StartEnd { start: all.mean(|p| p.mass_g.start), end: all.mean(|p| p.mass_g.end) },
        lost_pct: all.mean(|p| p.lost_pct),
        water_g: WaterSummary {
            evaporated: all.mean(|p| p.water_g.evaporated),
            dripped: all.mean(|p| p.water_g.dripped),
        },
        fat_rendered_g: all.mean(|p| p.fat_rendered_g),
        heat_j: all.mean(|p| p.heat_j),
        core_c: CoreSummary {
            end: all.mean(|p| p.core_c.end),
            peak: all.mean(|p| p.core_c.peak),
            peak_at_s: all.mean(|p| p.core_c.peak_at_s),
        },
        halved_at_mm: pieces.iter().map(|p| p.halved_at_mm).sum::<Option<f64>>().map(|sum| sum / pieces.len() as f64),
        section_pct: all.doneness(|p| p.section_pct),
        volume_pct: all.doneness(|p| p.volume_pct),
        doneness: all.by_scale(scales),
        denatured: all.denatured(),
        elastic_modulus_kpa: all.mean(|p| p.elastic_modulus_kpa),
        hardness_index: all.mean(|p| p.hardness_index),
        juiciness_pct: all.mean(|p| p.juiciness_pct),
        shape: all.shape(),
        log_reduction: LogReduction {
            core: all.least(|p| p.log_reduction.core),
            surface: all.least(|p| p.log_reduction.surface),
            ..pieces.first().map(|p| p.log_reduction.clone()).unwrap_or_default()
        },
        surfaces: Surfaces { top: all.surface(|p| p.surfaces.top), bottom: all.surface(|p| p.surfaces.bottom) },
    }
}
