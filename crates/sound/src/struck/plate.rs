//! Pans and lids as round plates: the frequencies of their modes from size and metal, their decay from the metal.

use core::f32::consts::PI;

use crate::struck::modes::Mode;

/// What a pan is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metal {
    /// Grey cast iron: dull.
    CastIron,
    /// Carbon steel: rings.
    CarbonSteel,
    /// Stainless steel with a core of aluminium.
    StainlessClad,
    /// Aluminium.
    Aluminium,
}

impl Metal {
    /// All metals, in declaration order.
    pub const ALL: [Self; 4] = [Self::CastIron, Self::CarbonSteel, Self::StainlessClad, Self::Aluminium];

    /// Young's modulus [Pa] and density [kg/m³] (handbook values; of the clad pan those of its layers, by their thickness).
    const fn stiffness(self) -> [f32; 2] {
        match self {
            Self::CastIron => [1.1e11, 7200.0],
            Self::CarbonSteel => [2.05e11, 7850.0],
            Self::StainlessClad => [1.1e11, 4405.0],
            Self::Aluminium => [0.7e11, 2700.0],
        }
    }

    /// Quality of a mode [-]: thin steel 100 to 500, cast iron 20 to 50, aluminium between; chosen within these.
    pub const fn quality(self) -> f32 {
        match self {
            Self::CastIron => 35.0,
            Self::CarbonSteel => 300.0,
            Self::StainlessClad => 150.0,
            Self::Aluminium => 80.0,
        }
    }
}

/// A round plate of metal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    /// Metal.
    pub metal: Metal,
    /// Radius [m]; of a pan the mean of floor and rim.
    pub radius_m: f32,
    /// Thickness [m].
    pub thickness_m: f32,
}

/// Number of modes [-]: within the 20 to 60 that struck metal is made of.
pub(crate) const MODES: usize = 20;
/// λ² of a round plate with a free rim, ν = 0.33, ascending [-] (`[@leissa-1969]`, recalled). A pan's wall stiffens
/// its rim: the ratios are those of a plate, not of one pan.
const LAMBDA_2: [f32; MODES] = [
    5.253, 9.084, 12.23, 20.52, 21.6, 33.1, 35.25, 38.55, 52.91, 59.86, 73.1, 83.9, 87.8, 95.8, 111.3, 119.0, 142.8,
    154.0, 175.0, 192.1,
];
/// Poisson's ratio [-].
const POISSON: f32 = 0.33;
/// Frequency below which a plate sends out less and less [Hz] (chosen: a disc of 26 cm is small against the wave below it).
const SMALL_BELOW_HZ: f32 = 600.0;

impl Plate {
    /// Frequency of a mode, ascending from 0 [Hz]: f = λ²/(2π·R²)·√(D/(ρ·h)), D = E·h³/(12·(1 − ν²)).
    pub fn frequency(&self, mode: usize) -> f32 {
        let [modulus, density] = self.metal.stiffness();
        let wave = libm::sqrtf(modulus / (12.0 * density * (1.0 - POISSON * POISSON)));
        LAMBDA_2[mode.min(MODES - 1)] / (2.0 * PI * self.radius_m * self.radius_m) * self.thickness_m * wave
    }

    /// The modes.
    pub(crate) fn modes(self) -> impl Iterator<Item = Mode> + Clone {
        (0..MODES).map(move |index| {
            let hz = self.frequency(index);
            Mode { hz, quality: self.metal.quality(), weight: hz / (hz + SMALL_BELOW_HZ) }
        })
    }
}
