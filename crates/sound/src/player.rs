//! What plays on by itself: a synthesiser that receives the state of a kitchen now and then.

use crate::event::Event;
use crate::glide::Smooth;
use crate::snapshot::Snapshot;
use crate::struck::plate::{Metal, Plate};
use crate::synth::{RATES, SEED, Synth};

/// The input of a player: the state of a kitchen, and the settings of the listener.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// The state of the kitchen.
    pub snapshot: Snapshot,
    /// The pan. Another one fades the sound out and begins again.
    pub pan: Plate,
    /// True while time is stopped, or sound is off.
    pub is_paused: bool,
    /// Volume, from 0 to 1 [-].
    pub volume: f32,
}

impl Default for Told {
    /// A pause.
    fn default() -> Self {
        let pan = Plate { metal: Metal::CarbonSteel, radius_m: 0.115, thickness_m: 2.3e-3 };
        Self { snapshot: Snapshot::default(), pan, is_paused: true, volume: 0.0 }
    }
}

/// Time in which the volume reaches its goal [s].
const VOLUME_S: f32 = 0.02;
/// Time that a pan takes to fade out before another one sounds [s]: that of a pause.
const FADE_S: f32 = 0.02;
/// Time without a word after which it counts as a pause [s] (chosen: a picture that takes longer than that shows no kitchen).
const PATIENCE_S: f32 = 1.0;

/// Plays the sound of a kitchen for as long as it receives its state. It makes samples whenever a device requests them, at the device's pace: the
/// sound is that of the present moment, however fast simulated time runs.
#[derive(Clone, Debug)]
pub struct Player {
    rate: u32,
    synth: Synth,
    told: Told,
    /// The pan that sounds.
    pan: Plate,
    volume: Smooth,
    /// Samples since it received the state of the kitchen, and since the last pan began to fade.
    untold: u32,
    fading: u32,
}

impl Player {
    /// Returns a silent player for a sample rate within [`RATES`] [Hz].
    pub fn new(rate: u32) -> Self {
        let rate = rate.clamp(*RATES.start(), *RATES.end());
        let told = Told::default();
        let mut synth = Synth::new(rate, SEED, &told.pan);
        synth.set_paused(true);
        let volume = Smooth::over(VOLUME_S, rate as f32);
        Self { rate, synth, told, pan: told.pan, volume, untold: 0, fading: 0 }
    }

    /// Takes the state of the kitchen, and what happened since the last call. What happens in a pause is not heard after it.
    pub fn hear(&mut self, told: &Told, events: &[Event]) {
        let is_new = self.told.snapshot != told.snapshot;
        self.told = *told;
        self.untold = 0;
        let events = if told.is_paused { &[] } else { events };
        // Flows that are on their way to this state arrive in their time.
        if is_new || !events.is_empty() {
            self.synth.feed(&told.snapshot, events);
        }
    }

    /// Number of events that were dropped because too many waited [-].
    pub fn dropped_events(&self) -> u64 {
        self.synth.dropped_events()
    }

    /// Renders the next samples, left and right [-], from −1 to 1. Memory is allocated only where another pan begins.
    pub fn render(&mut self, block: &mut [[f32; 2]]) {
        let count = u32::try_from(block.len()).unwrap_or(u32::MAX);
        self.untold = self.untold.saturating_add(count);
        self.change_pan(count);
        let is_changed = self.pan != self.told.pan;
        let is_left = self.untold as f32 > PATIENCE_S * self.rate as f32;
        self.synth.set_paused(self.told.is_paused || is_left || is_changed);
        self.synth.render(block);
        let goal = gain(self.told.volume);
        for frame in block {
            let gain = self.volume.follow(goal);
            *frame = frame.map(|x| gain * x);
        }
    }

    /// Lets another pan sound once the last one has faded out.
    fn change_pan(&mut self, count: u32) {
        if self.pan == self.told.pan {
            self.fading = 0;
            return;
        }
        if self.fading as f32 > FADE_S * self.rate as f32 {
            self.pan = self.told.pan;
            self.synth = Synth::new(self.rate, SEED, &self.pan);
            self.synth.feed(&self.told.snapshot, &[]);
        }
        self.fading = self.fading.saturating_add(count);
    }
}

/// Gain of a volume [-]: its square (chosen: the middle of the scale is −12 dB, about half as loud).
fn gain(volume: f32) -> f32 {
    let volume = if volume.is_finite() { volume.clamp(0.0, 1.0) } else { 0.0 };
    volume * volume
}
