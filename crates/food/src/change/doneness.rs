//! Doneness of each point: scales of named classes, by peak temperature or by the share of a change, and their shares.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::description::{Confidence, Kinetics};

/// Largest number of classes of a scale [-] (chosen: as many as the eye distinguishes at a glance).
pub const MOST_CLASSES: usize = 5;

/// A class of doneness. All classes of a scale have their lower bound in the same key.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Class {
    /// Name of the class.
    #[schemars(example = &"medium")]
    pub name: String,
    /// The name in other languages, by their codes; without it that which the program knows for the English one.
    #[serde(default)]
    #[schemars(extend("examples" = [{ "ja": "ミディアム" }]))]
    pub names: BTreeMap<String, String>,
    /// Lowest peak temperature of the class [°C].
    #[schemars(range(min = 0.0, max = 120.0), example = 60.0)]
    pub from_c: Option<f64>,
    /// Lowest share of the scale's `for_change` that has taken place, instead of `from_c` [%].
    #[schemars(range(min = 0.0, max = 100.0), example = 40.0)]
    pub from_pct: Option<f64>,
}

impl Class {
    /// Lower bound of the class, in the unit of its scale [°C or %].
    pub fn from(&self) -> f64 {
        self.from_c.or(self.from_pct).unwrap_or_default()
    }
}

/// What the classes of a scale are bounds of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Highest temperature so far.
    Peak,
    /// Share of a change that has taken place.
    Share,
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
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scale {
    /// Name in files and on the command line.
    #[schemars(example = &"my-scale")]
    pub id: String,
    /// Label for people.
    #[schemars(example = &"My scale")]
    pub name: String,
    /// The label in other languages, by their codes; without it that which the program knows for the English one.
    #[serde(default)]
    #[schemars(extend("examples" = [{ "ja": "わたしの目盛り" }]))]
    pub names: BTreeMap<String, String>,
    /// The classes, ascending; each ends where the next begins, and the first has no lower end.
    #[schemars(length(min = 2, max = MOST_CLASSES))]
    pub class: Vec<Class>,
    /// Name of the change that a food's kinetics must contain for the scale to apply, such as a protein of meat.
    #[schemars(example = &"myosin")]
    pub for_change: String,
    /// Ids of the kinetics that this scale is made for; without it, every kinetics with the change for which no scale is
    /// made. Foods with these kinetics have the scales made for them and no others.
    #[serde(default)]
    #[schemars(extend("examples" = [["shrimp"]]))]
    pub for_kinetics: Vec<String>,
    /// True if it is about the second tissue alone, such as the yolk of an egg.
    #[serde(default)]
    pub of_second: bool,
    /// True if the file of a food states it: it is that food's own. The reader of the files sets it.
    #[serde(skip)]
    pub is_of_one_food: bool,
    /// Goal for the core unless the cook sets another, in the unit of the classes [°C or %]; without it the goal that was
    /// last set for another scale without one.
    #[schemars(range(min = 0.0, max = 120.0), example = 63.0)]
    pub goal: Option<f64>,
    /// Source of the numbers.
    #[schemars(example = &"chosen: …")]
    pub source: String,
    /// Confidence in the numbers.
    #[schemars(example = &"low")]
    pub confidence: Confidence,
}

impl Scale {
    /// Returns what the classes are bounds of.
    pub fn measure(&self) -> Measure {
        if self.class.iter().any(|c| c.from_pct.is_some()) { Measure::Share } else { Measure::Peak }
    }

    /// Returns the index of the class of a peak temperature [K], or of a share [-] where the scale measures one.
    pub fn class_of(&self, value: f64) -> usize {
        self.bounds().take_while(|bound| value >= *bound).count()
    }

    /// Returns the name of the class of a peak temperature [K], or of a share [-] where the scale measures one.
    pub fn name_of(&self, value: f64) -> &str {
        self.class.get(self.class_of(value)).map_or("", |c| c.name.as_str())
    }

    /// Returns the lower end of a class [°C or %]; 0 for the first class and for a class that the scale does not have.
    pub fn from(&self, place: usize) -> f64 {
        self.class.get(place).map_or(0.0, Class::from)
    }

    /// Returns the upper end of a class [°C or %], or none for the last class.
    pub fn end(&self, place: usize) -> Option<f64> {
        self.class.get(place + 1).map(Class::from)
    }

    /// Returns true if a food's kinetics contain the change that the scale is about.
    pub fn applies_to(&self, kinetics: &Kinetics) -> bool {
        kinetics.change.iter().any(|c| c.name == self.for_change)
    }

    /// Returns true if the scale is made for the kinetics with an id.
    pub fn is_made_for(&self, kinetics: &str) -> bool {
        self.for_kinetics.iter().any(|id| id == kinetics)
    }

    /// Returns true if the scale is made for no food and no kinetics.
    pub fn is_general(&self) -> bool {
        self.for_kinetics.is_empty() && !self.is_of_one_food
    }

    /// Returns a value in the unit of the classes [°C or %] in the unit of the nodes [K or -].
    pub fn of_nodes(&self, value: f64) -> f64 {
        match self.measure() {
            Measure::Peak => value + crate::ZERO_C,
            Measure::Share => 0.01 * value,
        }
    }

    /// Bounds between the classes, in the unit of the nodes [K or -].
    fn bounds(&self) -> impl Iterator<Item = f64> {
        self.class.iter().skip(1).take(MOST_CLASSES - 1).map(|c| self.of_nodes(c.from()))
    }

    /// Adds a segment of weight `weight` along which the measure runs linearly from `a` to `b` [K or -]. Each class gets
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
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
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
        let class = |c: &f64| Class { name: format!("from {c}"), from_c: Some(*c), ..Class::default() };
        Scale {
            id: "own".into(),
            name: "Own".into(),
            names: BTreeMap::new(),
            class: bounds.iter().map(class).collect(),
            for_change: "myosin".into(),
            for_kinetics: Vec::new(),
            of_second: false,
            is_of_one_food: false,
            goal: None,
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
        assert_eq!((four.end(1), four.end(3)), (Some(60.0), None));
        assert_eq!(four.name_of(kelvin(65.0)), "from 60");
    }
    #[test]
    fn a_scale_of_shares_counts_percent_where_one_of_temperatures_counts_degrees() {
        let by_share = |c: Class| Class { from_pct: c.from_c, from_c: None, ..c };
        let mut three = scale(&[0.0, 40.0, 85.0]);
        assert_eq!(three.measure(), Measure::Peak);
        three.class = three.class.into_iter().map(by_share).collect();
        assert_eq!(three.measure(), Measure::Share);
        assert_eq!([0.0, 0.39, 0.41, 0.84, 0.86, 1.0].map(|share| three.class_of(share)), [0, 0, 1, 1, 2, 2]);
        let mut sums = [0.0; MOST_CLASSES];
        three.add_stretch(&mut sums, 0.2, 1.0, 8.0);
        assert!(sums.iter().zip([2.0, 4.5, 1.5, 0.0, 0.0]).all(|(s, e)| (s - e).abs() < 1e-9), "{sums:?}");
    }
}
