//! The steam of one place: noise where bubbles are dense, single bubbles where they are few.
//!
//! The power of both together is proportional to the flow. The rate of bubbles shares it out: above the place's `dense_from` most of
//! it is noise in two bands, the bursts (air) and the cloud (body); below it is single bubbles at random times. Few of them can be
//! voices, so that each represents the bubbles without a voice, by its power.

use crate::bubbles::{Bubble, Bubbles, radius};
use crate::character::Character;
use crate::filter::Band;
use crate::glide::{Glide, Smooth};
use crate::random::Random;

/// Time in which a gain reaches its goal [s].
const GAIN_S: f32 = 0.02;
/// Quality of the bands [-] (chosen: two octaves wide, and one and a half for the cloud's few modes).
const AIR_QUALITY: f32 = 0.6;
const BODY_QUALITY: f32 = 0.9;
/// Rate of single bubbles that is never reached [1/s] (chosen: at ten milliseconds each, eight of the 64 voices ring).
const MOST_SINGLE: f32 = 800.0;
/// Share of the noise's amplitude that differs between left and right [-] (chosen: a pan in front is wider than a point).
const WIDTH: f32 = 0.35;

/// A band of noise, and how much of it is heard.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Noise {
    /// What both sides share, and what differs between them.
    band: Band,
    quality: f32,
    gain: Smooth,
    goal: f32,
}

impl Noise {
    pub(crate) fn new(hz: f32, quality: f32, rate: f32) -> Self {
        Self { band: Band::new(hz, quality, rate), quality, gain: Smooth::over(GAIN_S, rate), goal: 0.0 }
    }

    /// Sets the power, given the centre [Hz]: a band-pass lets π·f/(2·Q) of a white density through.
    pub(crate) fn set(&mut self, power: f32, hz: f32, rate: f32) {
        let passed = core::f32::consts::PI * hz / self.quality / rate;
        self.goal = libm::sqrtf(power / passed);
    }

    pub(crate) fn next(&mut self, white: [f32; 2]) -> [f32; 2] {
        let gain = self.gain.follow(self.goal);
        let [middle, sides] = self.band.pass(white);
        let (middle, side) = (gain * middle, WIDTH * gain * sides);
        [middle + side, middle - side]
    }

    pub(crate) fn is_silent(&self) -> bool {
        self.goal == 0.0 && self.gain.value() == 0.0
    }
}

/// The steam of one place.
#[derive(Clone, Debug)]
pub(crate) struct Hiss {
    character: Character,
    rate: f32,
    flow: Glide,
    celsius: Glide,
    noise: Random,
    chance: Random,
    air: Noise,
    body: Noise,
    /// Rate of single bubbles [1/s] and the mean square of their amplitude times the damping [1/s].
    single: [f32; 2],
    /// Expected number of single bubbles until the next one [-].
    wait: f32,
}

impl Hiss {
    pub(crate) fn new(character: Character, [noise, mut chance]: [Random; 2], rate: f32) -> Self {
        let celsius = crate::character::REFERENCE_C;
        Self {
            air: Noise::new(character.air_hz(celsius), AIR_QUALITY, rate),
            body: Noise::new(character.body_hz, BODY_QUALITY, rate),
            flow: Glide::at(0.0),
            celsius: Glide::at(celsius),
            single: [0.0; 2],
            wait: chance.exponential(),
            noise,
            chance,
            character,
            rate,
        }
    }

    /// Sets out for a flow [kg/s] and a temperature [°C], to be reached after a number of control steps.
    pub(crate) fn set_out(&mut self, flow: f32, celsius: f32, steps: u32) {
        self.flow.set_out(flow, steps);
        self.celsius.set_out(celsius, steps);
    }

    /// Goes a control step.
    pub(crate) fn control(&mut self) {
        if self.flow.is_zero() && self.air.goal == 0.0 && self.body.goal == 0.0 {
            return;
        }
        let (flow, celsius) = (self.flow.step(), self.celsius.step());
        let bubbles = flow * self.character.per_kg;
        let power = self.character.power(flow, celsius);
        let dense = self.character.dense_share(bubbles);
        let hz = self.character.air_hz(celsius);
        let body = self.character.body_share;
        self.air.band.tune(hz, self.rate);
        self.air.set(power * dense * (1.0 - body), hz, self.rate);
        self.body.set(power * dense * body, self.character.body_hz, self.rate);
        self.single = [0.0; 2];
        if bubbles > 0.0 {
            let single = bubbles * MOST_SINGLE / (bubbles + MOST_SINGLE);
            // A bubble that begins with amplitude A and damping d has the energy A²/(4·d).
            self.single = [single, 4.0 * power * (1.0 - dense) / single];
        }
    }

    /// Returns the next frame of noise, and starts the single bubbles that are due.
    pub(crate) fn next(&mut self, bubbles: &mut Bubbles) -> [f32; 2] {
        self.start_single(bubbles);
        if self.air.is_silent() && self.body.is_silent() {
            self.air.band.rest();
            self.body.band.rest();
            return [0.0; 2];
        }
        let white = [self.noise.white(), self.noise.white()];
        let (air, body) = (self.air.next(white), self.body.next(white));
        [air[0] + body[0], air[1] + body[1]]
    }

    fn start_single(&mut self, bubbles: &mut Bubbles) {
        let [rate, energy] = self.single;
        if rate <= 0.0 {
            return;
        }
        self.wait -= rate / self.rate;
        while self.wait < 0.0 {
            self.wait += self.chance.exponential();
            let mut bubble = Bubble {
                radius_m: radius(&mut self.chance, self.character.radius_m),
                amplitude: 0.0,
                damped: self.character.damped,
                side: WIDTH * self.chance.even(),
            };
            // Many are weak, few are strong (chosen: exponential; its mean square is 2).
            let relative = self.chance.exponential() * core::f32::consts::FRAC_1_SQRT_2;
            bubble.amplitude = relative * libm::sqrtf(energy * bubble.damping());
            bubbles.start(&bubble);
        }
    }
}
