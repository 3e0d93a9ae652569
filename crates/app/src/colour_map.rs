//! Colour maps for temperatures and classes.

use std::sync::Arc;

use saute_kitchen::food::{Lab, Scale, ZERO_C};

/// A table of 256 sRGB colours over a range of temperatures.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourMap {
    /// Colours from the coldest to the hottest.
    pub table: Arc<[[u8; 3]; 256]>,
    /// Coldest temperature [°C].
    pub from_c: f64,
    /// Hottest temperature [°C].
    pub to_c: f64,
    /// Whether colours are classes, not to be mixed.
    pub stepped: bool,
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

/// Way-points of the uniform map in L*a*b*: lightness rises evenly from ink blue over teal and ochre to pale pink, and
/// blue–yellow carries the hue, which the common colour-vision deficiencies keep (chosen).
const UNIFORM_PATH: [[f64; 3]; 7] = [
    [12.0, 12.0, -30.0],
    [26.0, 2.0, -34.0],
    [40.0, -14.0, -20.0],
    [54.0, -16.0, 14.0],
    [67.0, 4.0, 52.0],
    [79.0, 24.0, 46.0],
    [93.0, 10.0, 12.0],
];

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
    /// The map's table and range.
    pub fn map(self) -> ColourMap {
        match self {
            Self::Uniform => ColourMap { table: Arc::new(uniform_table()), from_c: 0.0, to_c: 240.0, stepped: false },
            Self::Paper2013 => ColourMap { table: Arc::new(paper_table()), from_c: -50.0, to_c: 250.0, stepped: false },
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
    /// Between rare and medium, where a scale knows it.
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

    /// Its colour: lightness differs as well as hue (chosen; medium-rare lies between its neighbours).
    pub fn colour(self) -> [u8; 3] {
        match self {
            Self::Raw => [120, 16, 40],
            Self::Rare => [205, 62, 72],
            Self::MediumRare => [222, 106, 98],
            Self::Medium => [236, 150, 130],
            Self::WellDone => [142, 108, 86],
        }
    }
}

/// The map of a scale's classes over peak temperatures, in steps of half a kelvin.
pub fn doneness_map(scale: &Scale) -> ColourMap {
    let (from_c, to_c) = (0.0, 127.5);
    let class = |i: usize| scale.class_of(ZERO_C + from_c + (to_c - from_c) * (i as f64 + 0.01) / 255.0);
    let table = std::array::from_fn(|i| Tone::of(scale, class(i)).colour());
    ColourMap { table: Arc::new(table), from_c, to_c, stepped: true }
}

impl ColourMap {
    /// Coordinate of a temperature [°C] in the table (0–1).
    pub fn coordinate(&self, celsius: f64) -> f32 {
        ((celsius - self.from_c) / (self.to_c - self.from_c)).clamp(0.0, 1.0) as f32
    }

    /// Colour of a temperature [°C].
    pub fn colour(&self, celsius: f64) -> [u8; 3] {
        let position = self.coordinate(celsius) * 255.0;
        let low = (position as usize).min(254);
        let share = position - low as f32;
        if self.stepped {
            return self.table[(position as usize).min(255)];
        }
        let mix = |k: usize| {
            f32::from(self.table[low][k]) + share * (f32::from(self.table[low + 1][k]) - f32::from(self.table[low][k]))
        };
        [0, 1, 2].map(|k| mix(k).round() as u8)
    }

    /// Temperature whose colour is nearest to the given one [°C], and the distance in 8-bit units.
    pub fn decode(&self, colour: [u8; 3]) -> (f64, f64) {
        let steps = 255 * 8;
        let mut best = (0.0, f64::INFINITY);
        for i in 0..=steps {
            let celsius = self.from_c + (self.to_c - self.from_c) * f64::from(i) / f64::from(steps);
            let near = self.exact(celsius);
            let distance = (0..3).map(|k| (near[k] - f64::from(colour[k])).powi(2)).sum::<f64>().sqrt();
            if distance < best.1 {
                best = (celsius, distance);
            }
        }
        best
    }

    fn exact(&self, celsius: f64) -> [f64; 3] {
        let position = f64::from(self.coordinate(celsius)) * 255.0;
        let low = (position as usize).min(254);
        let share = position - low as f64;
        [0, 1, 2].map(|k| f64::from(self.table[low][k]) * (1.0 - share) + f64::from(self.table[low + 1][k]) * share)
    }
}

/// Walks the path in steps of equal ΔE*ab.
fn uniform_table() -> [[u8; 3]; 256] {
    let smooth: Vec<Lab> = (0..=600).map(|i| along_spline(f64::from(i) / 600.0)).collect();
    let mut walked = vec![0.0];
    for pair in smooth.windows(2) {
        walked.push(walked[walked.len() - 1] + pair[0].difference(pair[1]));
    }
    let whole = walked[walked.len() - 1];
    std::array::from_fn(|i| {
        let wanted = whole * i as f64 / 255.0;
        let upper = walked.partition_point(|&w| w < wanted).clamp(1, walked.len() - 1);
        let share = (wanted - walked[upper - 1]) / (walked[upper] - walked[upper - 1]);
        smooth[upper - 1].lerp(smooth[upper], share).srgb8()
    })
}

/// Catmull–Rom curve through the way-points.
fn along_spline(t: f64) -> Lab {
    let position = t * (UNIFORM_PATH.len() - 1) as f64;
    let cell = (position as usize).min(UNIFORM_PATH.len() - 2);
    let u = position - cell as f64;
    let at = |i: isize| UNIFORM_PATH[(cell as isize + i).clamp(0, UNIFORM_PATH.len() as isize - 1) as usize];
    let [a, b, c, d] = [at(-1), at(0), at(1), at(2)];
    Lab([0, 1, 2].map(|k| {
        b[k] + 0.5
            * u
            * (c[k] - a[k]
                + u * (2.0 * a[k] - 5.0 * b[k] + 4.0 * c[k] - d[k] + u * (3.0 * (b[k] - c[k]) + d[k] - a[k])))
    }))
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
    use super::*;

    fn lightness([r, g, b]: [u8; 3]) -> f64 {
        let linear = |v: u8| {
            let v = f64::from(v) / 255.0;
            if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
        };
        let y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        116.0 * y.cbrt() - 16.0
    }

    #[test]
    fn the_uniform_map_gets_lighter_with_every_step() {
        let map = TemperatureMap::Uniform.map();
        let l: Vec<f64> = map.table.iter().map(|&c| lightness(c)).collect();
        assert!(l.windows(8).all(|w| w[7] > w[0]), "{l:?}");
        assert!(l[255] - l[0] > 70.0);
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
                let near = |c: f64| map.colour(class.from_c + c);
                assert_eq!(near(-0.6), Tone::of(scale, place - 1).colour(), "{} {}", scale.id, class.name);
                assert_eq!(near(0.6), Tone::of(scale, place).colour(), "{} {}", scale.id, class.name);
            }
            assert_eq!(map.colour(150.0), Tone::WellDone.colour());
        }
    }

    #[test]
    fn medium_rare_lies_between_its_neighbours_and_no_two_neighbours_are_of_one_lightness() {
        let l: Vec<f64> = Tone::of_scale(5).iter().map(|t| lightness(t.colour())).collect();
        assert!(l.windows(2).all(|w| (w[0] - w[1]).abs() > 8.0), "{l:?}");
        assert!(l[1] < l[2] && l[2] < l[3], "{l:?}");
    }
}
