//! Oil, butter, water and the lid: what a cook adds at once, and what is in the pan.

use saute_kitchen::advice::SMOKE_SEEN_MG_S;
use saute_kitchen::{EventKind, Kitchen};
use saute_words::language::Language;

/// What can be poured or laid into the pan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pourable {
    /// The kitchen's own oil.
    Oil,
    /// Butter.
    Butter,
    /// Water.
    Water,
}

impl Pourable {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Oil, Self::Butter, Self::Water];

    /// Its name on a button.
    pub fn name(self, l: Language) -> &'static str {
        l.text(match self {
            Self::Oil => "pour.oil",
            Self::Butter => "pour.butter",
            Self::Water => "pour.water",
        })
    }
}

/// Portion that is added at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Portion {
    /// A teaspoon of oil, a thin slice of butter, a dash of water.
    #[default]
    Little,
    /// A tablespoon.
    Some,
    /// Enough to fry or to boil in.
    Much,
}

impl Portion {
    /// Its name.
    pub fn name(self, l: Language) -> &'static str {
        l.text(match self {
            Self::Little => "pour.little",
            Self::Some => "pour.some",
            Self::Much => "pour.much",
        })
    }

    /// Mass of the portion [g] (chosen: usual portions).
    pub fn grams(self, of: Pourable) -> f64 {
        let portions = match of {
            Pourable::Oil => [5.0, 15.0, 40.0],
            Pourable::Butter => [10.0, 25.0, 50.0],
            Pourable::Water => [30.0, 100.0, 250.0],
        };
        portions[self as usize]
    }

    /// The next larger one; the smallest after the largest.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::Little => Self::Some,
            Self::Some => Self::Much,
            Self::Much => Self::Little,
        }
    }
}

/// Least mass that is named [g] (chosen: as it is shown).
const NAMED_G: f64 = 0.1;

/// What liquid is in the pan.
pub fn in_the_pan(kitchen: &Kitchen, l: Language) -> String {
    let pan = kitchen.pan_state();
    let lump = pan.liquids.butter.lump.as_ref().map_or(0.0, |lump| lump.mass);
    let parts = [("pour.of_oil", pan.oil_mass()), ("pour.of_butter", lump), ("pour.of_water", pan.water_mass())];
    let named = parts.into_iter().map(|(key, mass)| (key, 1e3 * mass)).filter(|(_, g)| *g >= NAMED_G);
    let words: Vec<String> = named.map(|(key, g)| l.fill(key, &[("mass", &grams(g))])).collect();
    if words.is_empty() { l.text("pour.nothing").to_owned() } else { words.join(" · ") }
}

/// Returns a mass in words [g].
pub fn grams(g: f64) -> String {
    if g < 10.0 { format!("{g:.1}\u{a0}g") } else { format!("{g:.0}\u{a0}g") }
}

/// Warning about the oil: on fire, or smoking so that it is seen.
pub fn danger(kitchen: &Kitchen, l: Language) -> Option<String> {
    let pan = kitchen.pan_state();
    if pan.liquids.smoke.burning {
        return Some(l.text("pour.fire").to_owned());
    }
    let smoke = pan.smoke_mg_s();
    let advice = l.called("event", EventKind::SmokeBegins.advice().unwrap_or_default());
    let seen = smoke >= SMOKE_SEEN_MG_S;
    seen.then(|| l.fill("pour.smoke", &[("rate", &format!("{smoke:.1}")), ("advice", &advice)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn portions_grow_and_begin_again() {
        let all = [Portion::Little, Portion::Some, Portion::Much];
        for of in Pourable::ALL {
            assert!(all.windows(2).all(|p| p[0].grams(of) < p[1].grams(of)));
        }
        assert!(all.iter().all(|p| p.next().next().next() == *p && p.next() != *p));
    }
}
