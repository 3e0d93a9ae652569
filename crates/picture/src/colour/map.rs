//! Colour maps from values to sRGB.

use std::sync::Arc;

use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_scene::input::Colouring;

use crate::colour::hatch::{self, Pattern};
use crate::colour::path::ColourPath;

/// A table of 256 sRGB colours over a range of values, in the unit of the field that they show.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourMap {
    /// Colours from the lowest to the highest value.
    pub table: Arc<[[u8; 3]; 256]>,
    /// Lowest value.
    pub from: f64,
    /// Highest value.
    pub to: f64,
    /// True if colours are classes, not to be mixed.
    pub stepped: bool,
    /// Patterns of the table's entries, by their numbers.
    pub(crate) patterns: Arc<[u8; 256]>,
    /// First entry and number of entries of the part of the table that is this map's.
    pub(crate) part: [usize; 2],
    /// Name of the change whose share the map shows, where it shows one.
    pub(crate) change: Option<String>,
}

/// Which map shows temperatures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
pub enum TemperatureMap {
    /// Perceptually uniform, lightness rising, safe for colour-vision deficiencies.
    #[default]
    Uniform,
    /// The seven colours of the 2013 system, −50 to 250 °C.
    Paper2013,
}

/// Anchors of the 2013 map: temperature [°C] and sRGB, as that laboratory's public code states them.
const PAPER_ANCHORS: [(f64, [u8; 3]); 7] = [
    (-50.0, [0, 0, 255]),
    (0.0, [0, 255, 255]),
    (50.0, [0, 128, 0]),
    (100.0, [255, 255, 0]),
    (150.0, [255, 110, 0]),
    (200.0, [255, 0, 0]),
    (250.0, [255, 0, 242]),
];

impl TemperatureMap {
    /// The map's table and range [°C].
    pub fn map(self) -> ColourMap {
        match self {
            Self::Uniform => ColourMap::along(ColourPath::Heat, 0.0, 240.0),
            Self::Paper2013 => ColourMap::new(Arc::new(paper_table()), -50.0, 250.0, false),
        }
    }
}

/// How a class of doneness is painted: a colour, and a pattern that goes with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The least done.
    Raw,
    /// Warm and red.
    Rare,
    /// Between rare and medium, where a scale has it.
    MediumRare,
    /// Pink.
    Medium,
    /// The most done.
    WellDone,
}

impl Tone {
    /// The tones of a scale with so many classes, from the least done on.
    pub fn of_scale(classes: usize) -> &'static [Self] {
        match classes {
            0..=2 => &[Self::Raw, Self::WellDone],
            3 => &[Self::Raw, Self::Medium, Self::WellDone],
            4 => &[Self::Raw, Self::Rare, Self::Medium, Self::WellDone],
            _ => &[Self::Raw, Self::Rare, Self::MediumRare, Self::Medium, Self::WellDone],
        }
    }

    /// The tone of a class, by its place in a scale.
    pub fn of(scale: &Scale, class: usize) -> Self {
        let tones = Self::of_scale(scale.class.len());
        tones[class.min(tones.len() - 1)]
    }

    /// Its colour: lightness differs as well as hue (chosen; medium-rare is between its neighbours).
    pub fn colour(self) -> [u8; 3] {
        match self {
            Self::Raw => [120, 16, 40],
            Self::Rare => [205, 62, 72],
            Self::MediumRare => [222, 106, 98],
            Self::Medium => [236, 150, 130],
            Self::WellDone => [142, 108, 86],
        }
    }

    /// The pattern that goes with it.
    pub fn pattern(self) -> Pattern {
        match self {
            Self::Raw => Pattern::Plain,
            Self::Rare => Pattern::Dots,
            Self::MediumRare => Pattern::Levels,
            Self::Medium => Pattern::Diagonal,
            Self::WellDone => Pattern::Cross,
        }
    }
}

/// The map of a scale's classes: over peak temperatures in steps of half a kelvin, or over shares of its change.
pub fn doneness_map(scale: &Scale) -> ColourMap {
    let of_share = scale.measure() == Measure::Share;
    let (from, to) = if of_share { (0.0, 100.0) } else { (0.0, 127.5) };
    let class = |i: usize| scale.class_of(scale.of_nodes(from + (to - from) * (i as f64 + 0.01) / 255.0));
    let table = std::array::from_fn(|i| Tone::of(scale, class(i)).colour());
    let change = of_share.then(|| scale.for_change.clone());
    ColourMap { change, ..ColourMap::new(Arc::new(table), from, to, true) }
}

impl ColourMap {
    /// A continuous map along a path.
    pub fn along(path: ColourPath, from: f64, to: f64) -> Self {
        Self::new(path.table(), from, to, false)
    }

    fn new(table: Arc<[[u8; 3]; 256]>, from: f64, to: f64, stepped: bool) -> Self {
        let patterns = Arc::new(hatch::patterns(&table, stepped));
        Self { patterns, table, from, to, stepped, part: [0, 256], change: None }
    }

    /// The map as the renderer reads it.
    pub fn colouring(&self) -> Colouring {
        let classes = self.stepped.then(|| Arc::clone(&self.patterns));
        Colouring::Field { table: Arc::clone(&self.table), classes }
    }

    /// Name of the change whose share the map shows; none for maps of other fields.
    pub fn change(&self) -> Option<&str> {
        self.change.as_deref()
    }

    /// Coordinate of a value in the table (0–1).
    pub fn coordinate(&self, value: f64) -> f32 {
        let within = ((value - self.from) / (self.to - self.from)).clamp(0.0, 1.0);
        match self.part {
            [0, 256] => within as f32,
            // A little within the part: rounding must not lead into a neighbour's.
            [first, room] => ((first as f64 + 0.02 + within * (room as f64 - 1.04)) / 255.0) as f32,
        }
    }

    /// Colour of a value.
    pub fn colour(&self, value: f64) -> [u8; 3] {
        let position = f64::from(self.coordinate(value)) * 255.0;
        if self.stepped {
            return self.table[(position as usize).min(255)];
        }
        self.between(position).map(|v| v.round() as u8)
    }

    /// Colour of a value at a place of a picture [pixels], with the pattern of its class.
    pub fn hatched(&self, value: f64, x: f64, y: f64) -> [u8; 3] {
        let entry = (f64::from(self.coordinate(value)) * 255.0) as usize;
        Pattern::of_number(self.patterns[entry.min(255)]).over(self.colour(value), x, y)
    }

    /// Value whose colour is nearest to the given one, and the distance in 8-bit units.
    pub fn decode(&self, colour: [u8; 3]) -> (f64, f64) {
        let steps = 255 * 8;
        let mut best = (0.0, f64::INFINITY);
        for i in 0..=steps {
            let value = self.from + (self.to - self.from) * f64::from(i) / f64::from(steps);
            let near = self.between(f64::from(self.coordinate(value)) * 255.0);
            let distance = (0..3).map(|k| (near[k] - f64::from(colour[k])).powi(2)).sum::<f64>().sqrt();
            if distance < best.1 {
                best = (value, distance);
            }
        }
        best
    }

    /// The colour between two entries of the table.
    fn between(&self, position: f64) -> [f64; 3] {
        let low = (position as usize).min(254);
        let share = position - low as f64;
        [0, 1, 2].map(|k| f64::from(self.table[low][k]) * (1.0 - share) + f64::from(self.table[low + 1][k]) * share)
    }
}

fn paper_table() -> [[u8; 3]; 256] {
    std::array::from_fn(|i| {
        let celsius = -50.0 + 300.0 * i as f64 / 255.0;
        let upper = PAPER_ANCHORS.partition_point(|a| a.0 < celsius).clamp(1, 6);
        let ((t0, c0), (t1, c1)) = (PAPER_ANCHORS[upper - 1], PAPER_ANCHORS[upper]);
        let share = (celsius - t0) / (t1 - t0);
        [0, 1, 2].map(|k| (f64::from(c0[k]) + share * (f64::from(c1[k]) - f64::from(c0[k]))).round() as u8)
    })
}

#[cfg(test)]
mod tests {
    use saute_kitchen::food::change::colour::decoded;

    use super::*;

    fn lightness([r, g, b]: [u8; 3]) -> f64 {
        let linear = |v: u8| decoded(f64::from(v) / 255.0);
        let y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        116.0 * y.cbrt() - 16.0
    }

    #[test]
    fn temperatures_decode_from_8_bit_colours_within_a_kelvin() {
        for kind in [TemperatureMap::Uniform, TemperatureMap::Paper2013] {
            let map = kind.map();
            for i in 5..230 {
                let celsius = f64::from(i) + 0.37;
                let (decoded, _) = map.decode(map.colour(celsius));
                assert!((decoded - celsius).abs() < 1.0, "{kind:?} {celsius}: {decoded}");
            }
        }
    }

    #[test]
    fn classes_change_where_their_scale_says() {
        let library = saute_kitchen::Library::embedded().expect("embedded data");
        for scale in &library.scales {
            let map = doneness_map(scale);
            for (place, class) in scale.class.iter().enumerate().skip(1) {
                let near = |c: f64| map.colour(class.from() + c);
                assert_eq!(near(-0.6), Tone::of(scale, place - 1).colour(), "{} {}", scale.id, class.name);
                assert_eq!(near(0.6), Tone::of(scale, place).colour(), "{} {}", scale.id, class.name);
            }
            assert_eq!(map.colour(150.0), Tone::WellDone.colour(), "{}", scale.id);
        }
    }

    #[test]
    fn medium_rare_lies_between_its_neighbours_and_no_two_neighbours_are_of_one_lightness() {
        let l: Vec<f64> = Tone::of_scale(5).iter().map(|t| lightness(t.colour())).collect();
        assert!(l.windows(2).all(|w| (w[0] - w[1]).abs() > 8.0), "{l:?}");
        assert!(l[1] < l[2] && l[2] < l[3], "{l:?}");
    }
}
