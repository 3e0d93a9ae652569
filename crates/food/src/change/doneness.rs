//! Doneness by the peak temperature of each point: scales of named classes, and their shares.

use serde::Deserialize;

use crate::description::{Confidence, Kinetics};

/// Largest number of classes of a scale [-] (chosen: as many as the eye distinguishes at a glance).
pub const MOST_CLASSES: usize = 5;

/// A class of doneness.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Class {
    /// Name of the class.
    pub name: String,
    /// Lowest peak temperature of the class [°C].
    pub from_c: f64,
}

/// A scale of doneness: two to five classes, ascending.
///
/// ```
/// use saute_food::{Scale, ZERO_C};
///
/// let scale: Scale = toml::from_str(
///     "id = 'two'\nname = 'Two classes'\nfor_change = 'myosin'\nsource = 'example'\nconfidence = 'low'\n\
///      class = [{ name = 'raw', from_c = 0 }, { name = 'done', from_c = 55 }]",
/// )?;
/// assert_eq!(scale.name_of(ZERO_C + 40.0), "raw");
/// assert_eq!(scale.name_of(ZERO_C + 60.0), "done");
/// # Ok::<(), toml::de::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scale {
    /// Name in files and on the command line.
    pub id: String,
    /// Label for people.
    pub name: String,
    /// The classes, ascending; each ends where the next begins, and the first has no lower end.
    pub class: Vec<Class>,
    /// Name of the change that a food's kinetics must contain for the scale to apply, such as a protein of meat.
    pub for_change: String,
    /// Source of the numbers.
    pub source: String,
    /// Confidence in the numbers.
    pub confidence: Confidence,
}

impl Scale {
    /// Returns the index of the class of a peak temperature [K].
    pub fn class_of(&self, peak: f64) -> usize {
        self.bounds().take_while(|bound| peak >= *bound).count()
    }

    /// Returns the name of the class of a peak temperature [K].
    pub fn name_of(&self, peak: f64) -> &str {
        self.class.get(self.class_of(peak)).map_or("", |c| c.name.as_str())
    }

    /// Returns the upper end of a class [°C], or none for the last class.
    pub fn end_c(&self, place: usize) -> Option<f64> {
        self.class.get(place + 1).map(|c| c.from_c)
    }

    /// Returns true if the scale applies to a food with these kinetics.
    pub fn fits(&self, kinetics: &Kinetics) -> bool {
        kinetics.change.iter().any(|c| c.name == self.for_change)
    }

    /// Bounds between the classes [K].
    fn bounds(&self) -> impl Iterator<Item = f64> {
        self.class.iter().skip(1).take(MOST_CLASSES - 1).map(|c| c.from_c + crate::ZERO_C)
    }

    /// Adds a segment of weight `weight` along which the peak temperature runs linearly from `a` to `b` [K]. Each class gets
    /// the part of the segment within its bounds, so that shares do not jump from node to node.
    pub(crate) fn add_stretch(&self, sums: &mut [f64; MOST_CLASSES], a: f64, b: f64, weight: f64) {
        let (low, high) = (a.min(b), a.max(b));
        let below = |bound: f64| {
            if high > low { ((bound - low) / (high - low)).clamp(0.0, 1.0) } else { f64::from(u8::from(low < bound)) }
        };
        let (mut so_far, mut last) = (0.0, 0);
        for bound in self.bounds() {
            let up_to = below(bound);
            sums[last] += weight * (up_to - so_far);
            so_far = up_to;
            last += 1;
        }
        sums[last] += weight * (1.0 - so_far);
    }
}

/// Shares of the classes of a scale, in the order of the scale; their sum is 100 [%].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares(pub [f64; MOST_CLASSES]);

impl Shares {
    pub(crate) fn from_weights(mut sums: [f64; MOST_CLASSES]) -> Self {
        let total: f64 = sums.iter().sum();
        if total > 0.0 {
            sums.iter_mut().for_each(|s| *s *= 100.0 / total);
        }
        Self(sums)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(bounds: &[f64]) -> Scale {
        let class = |c: &f64| Class { name: format!("from {c}"), from_c: *c };
        Scale {
            id: "own".into(),
            name: "Own".into(),
            class: bounds.iter().map(class).collect(),
            for_change: "myosin".into(),
            source: String::new(),
            confidence: Confidence::Low,
        }
    }

    fn kelvin(celsius: f64) -> f64 {
        celsius + crate::ZERO_C
    }

    #[test]
    fn a_linear_stretch_is_shared_out_at_the_bounds() {
        let four = scale(&[0.0, 50.0, 60.0, 70.0]);
        let mut sums = [0.0; MOST_CLASSES];
        four.add_stretch(&mut sums, kelvin(80.0), kelvin(40.0), 4.0);
        let expected = [1.0, 1.0, 1.0, 1.0, 0.0];
        assert!(sums.iter().zip(expected).all(|(s, e)| (s - e).abs() < 1e-9), "{sums:?}");
        let mut even = [0.0; MOST_CLASSES];
        four.add_stretch(&mut even, kelvin(55.0), kelvin(55.0), 2.0);
        assert_eq!(even, [0.0, 2.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn every_number_of_classes_shares_out_all_of_a_stretch() {
        for count in 1..=MOST_CLASSES {
            let own = scale(&[0.0, 50.0, 55.0, 60.0, 70.0][..count]);
            let mut sums = [0.0; MOST_CLASSES];
            own.add_stretch(&mut sums, kelvin(90.0), kelvin(-10.0), 3.0);
            assert!((sums.iter().sum::<f64>() - 3.0).abs() < 1e-12, "{count}: {sums:?}");
            assert!(sums[count..].iter().all(|s| *s == 0.0), "{count}: {sums:?}");
        }
    }

    #[test]
    fn a_class_begins_at_its_bound_and_ends_at_the_next() {
        let four = scale(&[0.0, 50.0, 60.0, 70.0]);
        let of = |c: f64| four.class_of(kelvin(c));
        assert_eq!([-5.0, 49.9, 50.1, 59.9, 60.1, 70.1, 300.0].map(of), [0, 0, 1, 1, 2, 3, 3]);
        assert_eq!((four.end_c(1), four.end_c(3)), (Some(60.0), None));
        assert_eq!(four.name_of(kelvin(65.0)), "from 60");
    }
}
