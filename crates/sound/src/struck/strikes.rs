//! Forces on bodies: blows and rubs, and which event makes which.

use core::f32::consts::PI;

use crate::event::EventKind;
use crate::random::Random;

/// A body that can be struck.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    /// The pan.
    Pan,
    /// The lid.
    Lid,
    /// The turner.
    Tool,
    /// The board.
    Board,
    /// The food.
    Flesh,
    /// The bell.
    Bell,
}

/// Number of bodies [-].
pub(crate) const BODIES: usize = 6;

/// How a force goes with time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A blow: half a sine. The longer it lasts, the duller.
    Hit,
    /// A rub: noise that swells and fades.
    Rub,
}

/// A force on a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Force {
    /// On which body.
    pub(crate) on: Body,
    /// Shape.
    shape: Shape,
    /// How long it lasts [s].
    lasts_s: f32,
    /// Impulse of a blow of strength 1, or amplitude of a rub [-].
    gain: f32,
}

const fn hit(on: Body, lasts_s: f32, gain: f32) -> Force {
    Force { on, shape: Shape::Hit, lasts_s, gain }
}

const fn rub(on: Body, lasts_s: f32, gain: f32) -> Force {
    Force { on, shape: Shape::Rub, lasts_s, gain }
}

/// Forces of an event of strength 1. Lengths of contact are chosen by what meets: metal on metal tenths of a millisecond, flesh some
/// milliseconds; gains so that a hard clank peaks at about −12 dBFS and a piece laid down well below it.
pub(crate) const fn forces(kind: EventKind) -> &'static [Force] {
    match kind {
        EventKind::Put => const { &[hit(Body::Flesh, 6e-3, 0.5), hit(Body::Pan, 4e-3, 0.25)] },
        EventKind::Flip => {
            const { &[hit(Body::Flesh, 5e-3, 0.6), hit(Body::Pan, 3e-3, 0.3), hit(Body::Tool, 1e-3, 0.05)] }
        }
        EventKind::Slap => {
            const { &[hit(Body::Flesh, 3e-3, 0.5), rub(Body::Flesh, 30e-3, 0.06), hit(Body::Pan, 3e-3, 0.3)] }
        }
        EventKind::Scrape => const { &[rub(Body::Pan, 0.25, 3e-3), rub(Body::Tool, 0.25, 6e-3)] },
        EventKind::Clank => const { &[hit(Body::Pan, 0.4e-3, 0.6), hit(Body::Tool, 0.3e-3, 0.3)] },
        EventKind::Lid => {
            const { &[hit(Body::Lid, 0.6e-3, 0.4), hit(Body::Pan, 0.8e-3, 0.25), rub(Body::Lid, 0.15, 2e-3)] }
        }
        EventKind::WetCloth => const { &[hit(Body::Flesh, 12e-3, 0.9), hit(Body::Pan, 4e-3, 0.4)] },
        EventKind::Board => const { &[hit(Body::Board, 3e-3, 0.4), hit(Body::Flesh, 6e-3, 0.4)] },
        EventKind::Bell => const { &[hit(Body::Bell, 0.15e-3, 0.35)] },
        EventKind::Pour | EventKind::Spatter | EventKind::Drop => &[],
    }
}

/// A force that is at work.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strike {
    pub(crate) on: Body,
    shape: Shape,
    gain: f32,
    length: u32,
    age: u32,
}

/// Sample rate at which rubs were weighed [Hz]; noise of a given density that is summed has a variance that goes with 1/rate.
const WEIGHED_AT: f32 = 48_000.0;

impl Strike {
    /// Begins a force with a strength [-].
    pub(crate) fn begin(force: &Force, strength: f32, rate: f32) -> Self {
        let length = (libm::roundf(force.lasts_s * rate) as u32).max(2);
        let scale = match force.shape {
            // The samples of half a sine sum to its impulse.
            Shape::Hit => 0.5 * PI / length as f32,
            Shape::Rub => libm::sqrtf(WEIGHED_AT / rate),
        };
        Self { on: force.on, shape: force.shape, gain: scale * force.gain * strength, length, age: 0 }
    }

    /// Returns the force at the next sample; none once it is over.
    pub(crate) fn next(&mut self, random: &mut Random) -> Option<f32> {
        if self.age >= self.length {
            return None;
        }
        let swell = libm::sinf(PI * (self.age as f32 + 0.5) / self.length as f32);
        self.age += 1;
        Some(match self.shape {
            Shape::Hit => self.gain * swell,
            Shape::Rub => self.gain * swell * swell * random.white(),
        })
    }
}
