//! A kitchen as input of the synthesiser, and its sound tick by tick.
//!
//! All of it is read from the kitchen after each tick. Nothing of it is stored in a kitchen or a session, and nothing is required of
//! the tick: flows and happenings are differences between two looks.

pub mod caption;
pub mod example;
mod happenings;
pub mod shown;
mod steam_heard;

use saute_kitchen::pan::heater::Heater;
use saute_kitchen::{Kitchen, TICKS_PER_S, celsius};
use saute_sound::{Event, Metal, Plate, SEED, Snapshot, Steam, Stove, Synth};

use self::happenings::Happenings;
use self::steam_heard::SteamHeard;

/// Ticks between two looks from which the kitchen counts as another one [-] (chosen: a slow picture at twenty times real time has 20).
const LEAP: u64 = 50;

/// Listens to a kitchen. It may look after each tick, or whenever a picture is drawn.
#[derive(Clone, Debug)]
pub struct Ear {
    steam: SteamHeard,
    happenings: Happenings,
    tick: u64,
    /// What the last tick sounded like.
    flows: [f32; Steam::ALL.len()],
}

impl Ear {
    /// Begins to listen: what has happened so far is not heard.
    pub fn new(kitchen: &Kitchen) -> Self {
        Self {
            steam: SteamHeard::new(kitchen),
            happenings: Happenings::new(kitchen),
            tick: kitchen.tick(),
            flows: Default::default(),
        }
    }

    /// Returns what is heard now, and what happened since the last look. Within a tick flows are those of the last one, and what hands do
    /// is heard at once. Where time leapt or went back, it begins to listen again.
    pub fn hear(&mut self, kitchen: &Kitchen) -> (Snapshot, Vec<Event>) {
        match kitchen.tick().checked_sub(self.tick) {
            Some(0) => {}
            Some(ticks) if ticks < LEAP => {
                self.flows = self.steam.flows(kitchen, ticks).map(|flow| flow as f32);
                self.tick = kitchen.tick();
            }
            _ => *self = Self::new(kitchen),
        }
        (self.snapshot(kitchen), self.happenings.since(kitchen))
    }

    fn snapshot(&self, kitchen: &Kitchen) -> Snapshot {
        let floor_c = celsius(kitchen.pan_temperature()) as f32;
        Snapshot {
            steam: self.flows,
            floor_c,
            // Oil has the temperature of the metal below it.
            oil_c: floor_c,
            lid: kitchen.pan_state().lid.is_some(),
            covered: steam_heard::covered(kitchen) as f32,
            stove: stove(kitchen),
            stove_w: kitchen.hob_drawn_w() as f32,
        }
    }
}

/// The sound of a kitchen.
#[derive(Clone, Debug)]
pub struct Sound {
    ear: Ear,
    synth: Synth,
    rate: u64,
    tick: u64,
    samples: Vec<[f32; 2]>,
}

impl Sound {
    /// Begins the sound of a kitchen for a sample rate [Hz].
    pub fn new(kitchen: &Kitchen, rate: u32) -> Self {
        Self {
            ear: Ear::new(kitchen),
            synth: Synth::new(rate, SEED, &plate(kitchen)),
            rate: u64::from(rate),
            tick: kitchen.tick(),
            samples: Vec::new(),
        }
    }

    /// Returns true if it can go on with a kitchen at a sample rate [Hz]: no tick of it was missed.
    pub fn goes_on(&self, kitchen: &Kitchen, rate: u32) -> bool {
        self.tick == kitchen.tick() && self.rate == u64::from(rate)
    }

    /// Returns the samples of the tick that has just ended; none if none has since the last call, or the kitchen went back in time.
    pub fn follow(&mut self, kitchen: &Kitchen) -> &[[f32; 2]] {
        let from = core::mem::replace(&mut self.tick, kitchen.tick());
        // Samples up to a tick; a rate need not be a multiple of ten.
        let until = |tick: u64| (tick * self.rate / u64::from(TICKS_PER_S)) as usize;
        self.samples.clear();
        self.samples.resize(until(self.tick).saturating_sub(until(from)), [0.0; 2]);
        if !self.samples.is_empty() {
            let (snapshot, events) = self.ear.hear(kitchen);
            self.synth.feed(&snapshot, &events);
            self.synth.render(&mut self.samples);
        }
        &self.samples
    }
}

/// How the stove is heard.
fn stove(kitchen: &Kitchen) -> Stove {
    match kitchen.hob().heater() {
        Some(Heater::Flame(_)) => Stove::Flame,
        Some(Heater::Coil(_)) => Stove::Coil,
        Some(Heater::Element(_) | Heater::Plate(_)) | None => Stove::Silent,
    }
}

/// Density between light metal and a pan with a core of it, between that and cast iron, and between cast iron and steel [kg/m³]
/// (chosen: between 2700, 4400, 7200 and 7850).
const DENSITIES: [f64; 3] = [3500.0, 6000.0, 7500.0];

/// The pan as the plate that rings.
pub fn plate(kitchen: &Kitchen) -> Plate {
    let pan = &kitchen.pan_model().description;
    let heavier = DENSITIES.iter().filter(|density| pan.metal.density_kg_m3 > **density).count();
    let metal = [Metal::Aluminium, Metal::StainlessClad, Metal::CastIron, Metal::CarbonSteel][heavier];
    let radius_mm = 0.5 * (pan.floor.radius_mm + pan.wall.rim_radius_mm);
    Plate { metal, radius_m: 1e-3 * radius_mm as f32, thickness_m: 1e-3 * pan.floor.thickness_mm as f32 }
}
