//! What sounds for as long as it goes on: the state of a kitchen at a tick.

use crate::stove::Stove;

/// Where steam rises. Each has its own sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steam {
    /// Under food on the hot floor, through a thin film of oil.
    Floor,
    /// From food that is in oil.
    Oil,
    /// From water that boils in the pan.
    Water,
    /// From the water of butter, through its foam.
    Butter,
    /// From drops and puddles on the hot floor.
    Drip,
    /// From the wet cloth under the hot pan.
    Cloth,
}

impl Steam {
    /// All places, in declaration order.
    pub const ALL: [Self; 6] = [Self::Floor, Self::Oil, Self::Water, Self::Butter, Self::Drip, Self::Cloth];
}

/// The state of a kitchen at a tick, as far as it sounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot {
    /// Steam from each place [kg/s], in the order of [`Steam::ALL`].
    pub steam: [f32; Steam::ALL.len()],
    /// Temperature of the pan's floor [°C].
    pub floor_c: f32,
    /// Temperature of the oil [°C].
    pub oil_c: f32,
    /// True while the lid is on.
    pub lid: bool,
    /// Share of the floor under food or liquid, which damps the metal [-].
    pub covered: f32,
    /// How the stove heats.
    pub stove: Stove,
    /// Power that the stove draws [W].
    pub stove_w: f32,
}

impl Default for Snapshot {
    /// A cold, empty pan without a lid.
    fn default() -> Self {
        Self {
            steam: [0.0; Steam::ALL.len()],
            floor_c: 20.0,
            oil_c: 20.0,
            lid: false,
            covered: 0.0,
            stove: Stove::Silent,
            stove_w: 0.0,
        }
    }
}

impl Snapshot {
    /// Returns the snapshot with the steam of one place [kg/s].
    #[must_use]
    pub fn with(mut self, place: Steam, flow: f32) -> Self {
        self.steam[place as usize] = flow;
        self
    }

    /// Returns the snapshot within its ranges; what is not a finite number counts as 0.
    pub(crate) fn within_ranges(&self) -> Self {
        let finite = |x: f32, most: f32| if x.is_finite() { x.clamp(0.0, most) } else { 0.0 };
        Self {
            steam: self.steam.map(|flow| finite(flow, MOST_STEAM)),
            floor_c: finite(self.floor_c, HOTTEST_C),
            oil_c: finite(self.oil_c, HOTTEST_C),
            lid: self.lid,
            covered: finite(self.covered, 1.0),
            stove: self.stove,
            stove_w: finite(self.stove_w, MOST_W),
        }
    }
}

/// Largest flow of steam [kg/s] (chosen: 100 kW, more than any stove gives; the limiter is at work long before).
const MOST_STEAM: f32 = 0.04;
/// Largest power of a stove [W] (chosen: more than any at home).
const MOST_W: f32 = 1e4;
/// Highest temperature [°C] (chosen: above the fire of any oil).
const HOTTEST_C: f32 = 600.0;
