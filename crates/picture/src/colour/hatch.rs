//! Patterns that go with the colours of classes, so that no class is shown by hue alone.
//!
//! One definition for the panels' swatches, pictures of cuts and the scene: see `hatch.wgsl` of the scene, which
//! draws the same patterns on the same grid.

use crate::colour::map::Tone;

/// A pattern; the scene's colour table carries its number with the colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// None.
    Plain = 0,
    /// Dots in rows above gaps.
    Dots = 1,
    /// Level lines.
    Levels = 2,
    /// Lines that rise to the right.
    Diagonal = 3,
    /// Lines that cross.
    Cross = 4,
}

/// Side of the grid of all patterns [pixels] (chosen: wide enough to be distinct, narrow enough for a thin band).
pub const PERIOD: f64 = 8.0;
/// Width of a line [pixels] (chosen).
pub const LINE: f64 = 1.3;
/// Radius of a dot [pixels] (chosen).
pub const DOT: f64 = 1.5;
/// Darkness of the ink over that of the ground [-] (chosen: seen at a glance, the colour still compares with the
/// legend).
pub const INK: f64 = 0.42;

impl Pattern {
    /// The pattern with a number; none where there is no such number.
    pub fn of_number(number: u8) -> Self {
        match number {
            1 => Self::Dots,
            2 => Self::Levels,
            3 => Self::Diagonal,
            4 => Self::Cross,
            _ => Self::Plain,
        }
    }

    /// Coverage with ink at a place of a picture (0–1).
    pub fn ink(self, x: f64, y: f64) -> f64 {
        // Distance from the nearest line of a family with this spacing.
        let line = |along: f64, spacing: f64| {
            let away = (along / spacing - (along / spacing).round()).abs() * spacing;
            (0.5 + 0.5 * LINE - away).clamp(0.0, 1.0)
        };
        let slant = PERIOD / core::f64::consts::SQRT_2;
        let (rising, falling) = ((x + y) / core::f64::consts::SQRT_2, (x - y) / core::f64::consts::SQRT_2);
        match self {
            Self::Plain => 0.0,
            Self::Dots => {
                let row = (y / (0.75 * PERIOD)).round();
                let shifted = x - if row.rem_euclid(2.0) > 0.5 { 0.5 * PERIOD } else { 0.0 };
                let dx = (shifted / PERIOD - (shifted / PERIOD).round()) * PERIOD;
                (0.5 + DOT - dx.hypot(y - row * 0.75 * PERIOD)).clamp(0.0, 1.0)
            }
            Self::Levels => line(y, 0.625 * PERIOD),
            Self::Diagonal => line(rising, slant),
            Self::Cross => line(rising, slant).max(line(falling, slant)),
        }
    }

    /// A colour with the pattern's ink at a place of a picture.
    pub fn over(self, colour: [u8; 3], x: f64, y: f64) -> [u8; 3] {
        let left = 1.0 - INK * self.ink(x, y);
        colour.map(|v| (f64::from(v) * left).round() as u8)
    }
}

/// The pattern of every entry of a table of classes: entries of one colour are a class, and the tones of a scale with
/// so many classes determine how it is drawn. A table that is not stepped has none.
pub fn patterns(table: &[[u8; 3]; 256], stepped: bool) -> [u8; 256] {
    if !stepped {
        return [0; 256];
    }
    let mut class = 0;
    let place: [usize; 256] = std::array::from_fn(|i| {
        class += usize::from(i > 0 && table[i] != table[i - 1]);
        class
    });
    let tones = Tone::of_scale(class + 1);
    place.map(|p| tones[p.min(tones.len() - 1)].pattern() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::map::doneness_map;

    const ALL: [Pattern; 5] = [Pattern::Plain, Pattern::Dots, Pattern::Levels, Pattern::Diagonal, Pattern::Cross];

    #[test]
    fn no_two_patterns_look_alike_and_none_hides_the_colour() {
        let drawn = |p: Pattern| -> Vec<f64> {
            (0..48 * 48).map(|i| p.ink(f64::from(i % 48) + 0.5, f64::from(i / 48) + 0.5)).collect()
        };
        for (i, a) in ALL.iter().enumerate() {
            let cover = drawn(*a).iter().sum::<f64>() / 2304.0;
            assert!(cover < 0.5, "{a:?} covers {cover}");
            for b in &ALL[i + 1..] {
                let differing = drawn(*a).iter().zip(drawn(*b)).map(|(p, q)| (p - q).abs()).sum::<f64>() / 2304.0;
                assert!(differing > 0.08, "{a:?} and {b:?} differ by {differing}");
            }
        }
    }

    #[test]
    fn every_class_of_every_scale_has_the_pattern_of_its_swatch() {
        for scale in &saute_kitchen::Library::embedded().expect("embedded data").scales {
            let map = doneness_map(scale);
            let patterns = patterns(&map.table, map.stepped);
            for (place, class) in scale.class.iter().enumerate() {
                let at = (map.coordinate(class.from() + 1.0) * 255.0) as usize;
                assert_eq!(patterns[at], Tone::of(scale, place).pattern() as u8, "{} {}", scale.id, class.name);
            }
        }
    }

    #[test]
    fn a_continuous_table_is_never_hatched() {
        let map = crate::colour::map::TemperatureMap::Uniform.map();
        assert_eq!(patterns(&map.table, map.stepped), [0; 256]);
    }
}
