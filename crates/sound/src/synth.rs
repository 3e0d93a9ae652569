//! The synthesiser: from snapshots and events to samples.

use alloc::vec::Vec;

use crate::bubbles::{Bubble, Bubbles, radius};
use crate::character::Character;
use crate::event::{Event, EventKind, TICK_S};
use crate::event_queue::EventQueue;
use crate::hiss::Hiss;
use crate::lid::LidFilter;
use crate::limiter::Limiter;
use crate::pour::Pour;
use crate::random::Random;
use crate::snapshot::{Snapshot, Steam};
use crate::stove_sound::StoveSound;
use crate::struck::Struck;
use crate::struck::plate::Plate;

/// Sample rates that can be requested [Hz].
pub const RATES: core::ops::RangeInclusive<u32> = 8_000..=192_000;

/// Seed of the noise [-] (chosen: the same cook gives the same samples).
pub const SEED: u64 = 0x5a07e;

/// Control steps in a second [1/s] (chosen: a millisecond is shorter than any change that is heard).
const CONTROLS: u32 = 1000;
/// Time in which a pause falls silent, and ends [s]; with rounding below the 20 ms that are promised.
const FADE_S: f32 = 0.018;
/// A bubble of spatter: radii [m], damping [-] and amplitude at strength 1 [-] (chosen: sharper than those under food).
const SPATTER: ([f32; 2], f32, f32) = ([0.5e-3, 2e-3], 2.5, 0.25);
/// A bubble that a drop draws in (chosen: rings freely).
const DROP: ([f32; 2], f32, f32) = ([1.2e-3, 3e-3], 1.0, 0.12);

/// Makes the sound of one pan.
#[derive(Clone, Debug)]
pub struct Synth {
    rate: f32,
    /// Samples made since the beginning.
    now: u64,
    control_every: u32,
    until_control: u32,
    steam: Vec<Hiss>,
    bubbles: Bubbles,
    pour: Pour,
    struck: Struck,
    stove: StoveSound,
    events: EventQueue,
    chance: Random,
    is_lid_on: bool,
    lid: LidFilter,
    limiter: Limiter,
    is_paused: bool,
    /// Gain of the pause [-], and its change in a sample.
    fade: f32,
    fade_step: f32,
}

impl Synth {
    /// Returns the synthesiser of a pan for a sample rate within [`RATES`] [Hz]. Equal seeds give equal samples.
    pub fn new(rate: u32, seed: u64, pan: &Plate) -> Self {
        let rate = rate.clamp(*RATES.start(), *RATES.end());
        let control_every = ((rate + CONTROLS / 2) / CONTROLS).max(1);
        let rate = rate as f32;
        let stream = |number| Random::new(seed, number);
        let hiss = |place: Steam| {
            let number = 2 * place as u64;
            Hiss::new(Character::of(place), [stream(number), stream(number + 1)], rate)
        };
        Self {
            now: 0,
            control_every,
            until_control: 0,
            steam: Steam::ALL.map(hiss).into(),
            bubbles: Bubbles::new(rate),
            pour: Pour::new(stream(100)),
            struck: Struck::new(pan, stream(101), rate),
            stove: StoveSound::new(stream(103), rate),
            events: EventQueue::new(),
            chance: stream(102),
            is_lid_on: false,
            lid: LidFilter::new(rate),
            limiter: Limiter::new(rate),
            is_paused: false,
            fade: 1.0,
            fade_step: 1.0 / (FADE_S * rate),
            rate,
        }
    }

    /// Takes the state of a tick and the events in it. Flows glide to it over [`TICK_S`] from the next sample on; events start at
    /// their samples.
    pub fn feed(&mut self, snapshot: &Snapshot, events: &[Event]) {
        let snapshot = snapshot.within_ranges();
        let steps = libm::roundf(TICK_S * self.rate / self.control_every as f32) as u32;
        for (place, hiss) in Steam::ALL.into_iter().zip(&mut self.steam) {
            let celsius = if place == Steam::Oil { snapshot.oil_c } else { snapshot.floor_c };
            hiss.set_out(snapshot.steam[place as usize], celsius, steps);
        }
        self.is_lid_on = snapshot.lid;
        self.struck.cover(snapshot.covered);
        self.stove.set(snapshot.stove, snapshot.stove_w);
        for event in events.iter().filter_map(Event::within_ranges) {
            self.events.push(self.now + (event.at_s * self.rate) as u64, event);
        }
    }

    /// Pauses or goes on. A pause is silent within 20 ms; time is stopped in it.
    pub fn set_paused(&mut self, is_paused: bool) {
        self.is_paused = is_paused;
    }

    /// Number of events that were dropped because too many waited [-].
    pub fn dropped_events(&self) -> u64 {
        self.events.dropped()
    }

    /// Renders the next samples, left and right [-], from −1 to 1.
    pub fn render(&mut self, block: &mut [[f32; 2]]) {
        for frame in block {
            let change = if self.is_paused { -self.fade_step } else { self.fade_step };
            self.fade = (self.fade + change).clamp(0.0, 1.0);
            *frame = if self.fade > 0.0 { self.next() } else { [0.0; 2] };
        }
    }

    fn next(&mut self) -> [f32; 2] {
        if self.until_control == 0 {
            self.until_control = self.control_every;
            self.control();
        }
        self.until_control -= 1;
        while let Some(event) = self.events.due(self.now) {
            self.begin(&event);
        }
        self.now += 1;
        let [inside, outside] = self.struck.next();
        let within = self.steam_and_bubbles().map(|x| x + inside);
        let pan = self.lid.pass(within, self.is_lid_on);
        let [left, right] = self.stove.next();
        let all = [pan[0] + outside + left, pan[1] + outside + right];
        let fade = self.fade;
        self.limiter.pass(all).map(|x| x * fade)
    }

    fn steam_and_bubbles(&mut self) -> [f32; 2] {
        let mut sum = [0.0; 2];
        for hiss in &mut self.steam {
            let heard = hiss.next(&mut self.bubbles);
            sum = [sum[0] + heard[0], sum[1] + heard[1]];
        }
        let single = self.bubbles.next();
        [sum[0] + single[0], sum[1] + single[1]]
    }

    fn control(&mut self) {
        self.steam.iter_mut().for_each(Hiss::control);
        self.bubbles.clear_out();
        self.pour.go_on(self.control_every as f32 / self.rate, &mut self.bubbles);
        self.struck.settle();
        self.stove.control();
    }

    fn begin(&mut self, event: &Event) {
        match event.kind {
            EventKind::Pour => self.pour.begin(event.strength),
            EventKind::Spatter => self.start(event, SPATTER),
            EventKind::Drop => self.start(event, DROP),
            _ => self.struck.strike(event),
        }
    }

    fn start(&mut self, event: &Event, (radii, damped, amplitude): ([f32; 2], f32, f32)) {
        let radius_m = radius(&mut self.chance, radii);
        self.bubbles.start(&Bubble { radius_m, amplitude: amplitude * event.strength, damped, side: event.side });
    }
}
