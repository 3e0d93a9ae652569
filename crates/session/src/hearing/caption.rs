//! What is heard, in words and as a level, for those who do not hear it. Both come from the state that the synthesiser gets.

use saute_sound::{SILENCE_DB, Snapshot, Steam, Stove};
use saute_words::language::Language;

/// What goes on, by its sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Caption {
    /// Nothing is heard.
    Quiet,
    /// Single pops: hardly any water is left.
    Crackle,
    /// A soft sizzle.
    Soft,
    /// A steady sizzle.
    Steady,
    /// A lively sizzle.
    Lively,
    /// Steam bubbles through deep oil.
    DeepOil,
    /// Single bubbles rise in water.
    Simmer,
    /// Water boils.
    Boil,
    /// Butter's water boils off under its foam.
    Butter,
    /// Drops of water burst on the hot floor.
    Drip,
    /// The wet cloth hisses.
    Cloth,
    /// The flame of the stove, and nothing else.
    Flame,
}

/// Level below which nothing counts as heard [dBFS] (chosen: a tenth of a milligram of steam a second).
const HEARD_DB: f32 = -60.0;
/// Flows of steam under food from which a sizzle is soft, steady and lively [kg/s]: below the first, bubbles are heard one by one; the
/// others are those by which a plan states what is heard.
const SIZZLES: [f32; 3] = [1e-5, 3e-5, 1e-4];
/// Flow from water above which it boils rather than simmers [kg/s]: its bubbles become one noise.
const BOILS: f32 = 1.3e-4;
/// Level at which a meter is full [dBFS] (chosen: 5 g/s of steam under food, more than a home stove gives).
const FULL_DB: f32 = -12.0;

/// Returns what goes on in a kitchen by its sound: the loudest of all that is heard.
pub fn caption(snapshot: &Snapshot) -> Caption {
    let level = |place: &Steam| snapshot.level_of(*place);
    let loudest = Steam::ALL.into_iter().max_by(|a, b| level(a).total_cmp(&level(b)));
    let Some(place) = loudest.filter(|place| level(place) > HEARD_DB) else { return without_steam(snapshot) };
    let flow = snapshot.steam[place as usize];
    match place {
        Steam::Floor => sizzle(flow),
        Steam::Oil => Caption::DeepOil,
        Steam::Water if flow < BOILS => Caption::Simmer,
        Steam::Water => Caption::Boil,
        Steam::Butter => Caption::Butter,
        Steam::Drip => Caption::Drip,
        Steam::Cloth => Caption::Cloth,
    }
}

/// What is heard while there is no steam. The hum of a coil is left out: it tells nothing about the pan.
fn without_steam(snapshot: &Snapshot) -> Caption {
    let is_flame = snapshot.stove == Stove::Flame && snapshot.level_of_stove() > HEARD_DB;
    if is_flame { Caption::Flame } else { Caption::Quiet }
}

fn sizzle(flow: f32) -> Caption {
    let [soft, steady, lively] = SIZZLES;
    match flow {
        f if f < soft => Caption::Crackle,
        f if f < steady => Caption::Soft,
        f if f < lively => Caption::Steady,
        _ => Caption::Lively,
    }
}

/// Returns how loud a kitchen is, from 0 for silence to 1 [-]: its level in decibels over the range of a meter.
pub fn meter(snapshot: &Snapshot) -> f32 {
    let least = HEARD_DB.max(SILENCE_DB);
    let is_coil = snapshot.stove == Stove::Coil;
    // As in the caption, the hum of a coil is left out.
    let snapshot = Snapshot { stove_w: if is_coil { 0.0 } else { snapshot.stove_w }, ..*snapshot };
    ((snapshot.level() - least) / (FULL_DB - least)).clamp(0.0, 1.0)
}

/// Returns a state a share of the way to another one [-]: what is read must not flicker with every bubble.
#[must_use]
pub fn nearer(from: &Snapshot, to: &Snapshot, share: f32) -> Snapshot {
    let mut steam = to.steam;
    for (flow, last) in steam.iter_mut().zip(from.steam) {
        *flow = last + share.clamp(0.0, 1.0) * (*flow - last);
    }
    Snapshot { steam, ..*to }
}

impl Caption {
    /// The caption in words; `is_lidded` adds that the lid dims it.
    pub fn words(self, is_lidded: bool, l: Language) -> String {
        let words = l.text(self.key());
        if is_lidded && !matches!(self, Self::Quiet | Self::Flame) {
            return l.fill("heard.under_lid", &[("sound", &words)]);
        }
        words.to_owned()
    }

    fn key(self) -> &'static str {
        match self {
            Self::Quiet => "heard.quiet",
            Self::Crackle => "heard.crackle",
            Self::Soft => "heard.soft",
            Self::Steady => "heard.steady",
            Self::Lively => "heard.lively",
            Self::DeepOil => "heard.deep_oil",
            Self::Simmer => "heard.simmer",
            Self::Boil => "heard.boil",
            Self::Butter => "heard.butter",
            Self::Drip => "heard.drip",
            Self::Cloth => "heard.cloth",
            Self::Flame => "heard.flame",
        }
    }
}
