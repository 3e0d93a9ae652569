//! The ranges of what hands may request, stated once in the units of a recipe. Whatever gives a kitchen a command passes here: recipes,
//! Python, sessions, links, phones and devices. Recipes and Python also keep to the ranges of masses, of tilt and toss and of the pan's
//! place, for which the kitchen has wider bounds.
//!
//! | command | what is checked here | what its execution checks |
//! |---|---|---|
//! | `Hob`, `HobHold` | – | power and temperature of the hob that is there |
//! | `Oil`, `Butter`, `Water` | – | room in the pan |
//! | `MovePan` | – | reach |
//! | `Put`, `Move` | place | floor, other food |
//! | `Halve` | that its place is a number | length of the piece |
//! | `Cool`, `Toss`, `Shake`, `Tilt`, `Press` | all numbers | – |
//! | `Lead`, `HoldPan` | – | that the pose is one, and reach: beyond it the hand stays at its edge |

use crate::dynamics::Pose;
use crate::hands::command::{Command, Refused};
use saute_schema::number_text::number_text;

/// Smallest, largest and default value of a key, in the unit of the key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// Default value.
    pub default: f64,
}

const fn limits(low: f64, high: f64, default: f64) -> Limits {
    Limits { low, high, default }
}

/// Range of the mass of oil or butter of one step [g] (chosen: more is deep frying).
pub const FAT_G: [f64; 2] = [0.0, 300.0];
/// Range of the mass of water of one step [g] (chosen: the shipped pans overflow at 2 kg).
pub const WATER_G: [f64; 2] = [0.0, 1000.0];
/// Range of the tilt of the pan [°] (chosen: beyond 80° everything falls out).
pub const TILT_DEG: [f64; 2] = [0.0, 80.0];
/// Height of a toss [mm] (chosen: a cook's toss clears the rim by the width of a hand).
pub const TOSS_HEIGHT_MM: Limits = limits(50.0, 500.0, 250.0);
/// Amplitude of shaking [mm] (chosen: ± 20 mm is comfortable for an arm; ± 100 mm leaves the hob).
pub const SHAKE_AMPLITUDE_MM: Limits = limits(0.0, 100.0, 20.0);
/// Frequency of shaking [Hz] (chosen: a cook shakes at about 3 Hz; 8 Hz exceeds what an arm can do).
pub const SHAKE_HZ: Limits = limits(0.0, 8.0, 3.0);
/// Duration of shaking and pressing [s] (chosen: a few strokes).
pub const FOR_S: Limits = limits(0.1, 600.0, 5.0);
/// Direction of a tilt [°] (chosen: any; by default to the right).
pub const TOWARDS_DEG: Limits = limits(-360.0, 360.0, 0.0);
/// Force of pressing [N] (chosen: by default the weight of 1 kg; a hand on a turner hardly exceeds 100 N).
pub const PRESS_N: Limits = limits(0.0, 100.0, 10.0);
/// Distance of the knife's cut from the middle of a food [mm] (chosen: half of the longest food).
pub const HALVE_AT_MM: Limits = limits(-150.0, 150.0, 0.0);
/// Height of the pan above the glass [mm] (chosen: within reach of an arm; by default on the glass).
pub const LIFT_MM: Limits = limits(0.0, 500.0, 0.0);
/// Duration of the pan on the cloth [s]; the checked default is that of `kitchen.toml`.
pub const COOL_S: Limits = limits(0.1, 600.0, 3.0);
/// Tilt that a kitchen carries out [°] (chosen: a pan may be turned over; a recipe keeps to what a cook does on purpose).
pub const ANY_TILT_DEG: Limits = limits(-180.0, 180.0, 0.0);
/// Height of a toss that a kitchen carries out [mm] (chosen: food hardly leaves the pan at the least).
pub const ANY_TOSS_MM: Limits = limits(0.0, TOSS_HEIGHT_MM.high, TOSS_HEIGHT_MM.default);
/// Start temperature of the pan [°C] (chosen: by default that of a room; hotter ones only burn oil).
pub const PAN_INITIAL_C: Limits = limits(0.0, 300.0, 20.0);
/// Range of the mass of oil in the pan at the start [g] (chosen: more is deep frying).
pub const PAN_OIL_G: [f64; 2] = [0.0, 100.0];
/// Time at which a cook stops that no step has ended [s] (chosen: a day; by default an hour).
pub const MAX_S: Limits = limits(1.0, 86_400.0, 3600.0);
/// How long a recipe is said to take [min] (chosen: a day at most).
pub const MINUTES: Limits = limits(1.0, 1440.0, 15.0);
/// Place of food relative to the pan's centre along each axis [mm] (chosen: beyond the rim of the widest pan).
pub const PLACE_MM: Limits = limits(-200.0, 200.0, 0.0);
/// Place of the pan relative to the ring's centre along each axis [mm] (chosen: within reach of an arm).
pub const PAN_MM: Limits = limits(-350.0, 350.0, 0.0);

/// Share of a range by which a value may be beyond it [-] (chosen: rounding of units).
const ROUNDING: f64 = 1e-9;
/// Miss of a unit quaternion from which it is made one [-] (chosen: above that of 32-bit numbers).
const NOT_UNIT: f64 = 1e-4;

impl Limits {
    /// Refuses a value beyond the range of a key, and one that is no number.
    fn check(&self, key: &'static str, value: f64) -> Result<(), Refused> {
        let more = ROUNDING * (self.high - self.low);
        // What is zero in one unit is zero in the other.
        let less = if self.low == 0.0 { 0.0 } else { more };
        if (self.low - less..=self.high + more).contains(&value) { Ok(()) } else { Err(self.refusal(key)) }
    }

    fn refusal(&self, key: &'static str) -> Refused {
        Refused::Range { key, low: number_text(self.low), high: number_text(self.high) }
    }
}

impl Command {
    /// Refuses values beyond the ranges.
    pub(crate) fn check_ranges(&self) -> Result<(), Refused> {
        match self {
            Self::Put { at, .. } => place("put.at_mm", *at),
            Self::Move { to, .. } => place("move.to_mm", *to),
            // A knife outside the food has a separate reason.
            Self::Halve { at, .. } if at.is_finite() => Ok(()),
            Self::Halve { .. } => Err(HALVE_AT_MM.refusal("halve.at_mm")),
            Self::Cool { for_s } => COOL_S.check("cool.for_s", *for_s),
            Self::Toss { height } => ANY_TOSS_MM.check("toss.height_mm", 1e3 * height),
            Self::Shake { amplitude, hz, for_s } => SHAKE_AMPLITUDE_MM
                .check("shake.amplitude_mm", 1e3 * amplitude)
                .and(SHAKE_HZ.check("shake.hz", *hz))
                .and(FOR_S.check("shake.for_s", *for_s)),
            Self::Tilt { angle, towards } => ANY_TILT_DEG
                .check("tilt.deg", angle.to_degrees())
                .and(TOWARDS_DEG.check("tilt.towards_deg", towards.to_degrees())),
            Self::Press { newtons, for_s, .. } => {
                PRESS_N.check("press.n", *newtons).and(FOR_S.check("press.for_s", *for_s))
            }
            Self::Baste { for_s, .. } => FOR_S.check("baste.for_s", *for_s),
            Self::Lead { .. } | Self::HoldPan { .. } => Ok(()),
            Self::Hob(_) | Self::HobHold { .. } | Self::MovePan { .. } => Ok(()),
            Self::Oil { .. } | Self::Butter(_) | Self::Water(_) => Ok(()),
            Self::Flip { .. } | Self::Rest { .. } | Self::LetGo | Self::Lid(_) | Self::Wipe => Ok(()),
        }
    }
}

fn place(key: &'static str, [x, y]: [f64; 2]) -> Result<(), Refused> {
    PLACE_MM.check(key, 1e3 * x).and(PLACE_MM.check(key, 1e3 * y))
}

/// Returns a pose of finite numbers whose orientation is one; a hand whose pose is refused stays where it is.
///
/// # Errors
///
/// If a number is not finite, or the orientation is zero.
pub fn usable(pose: &Pose) -> Result<Pose, Refused> {
    let largest = pose.rotation.to_array().into_iter().fold(0.0_f64, |most, part| most.max(part.abs()));
    if !pose.is_finite() || largest == 0.0 {
        return Err(Refused::NoPose);
    }
    if (pose.rotation.length_squared() - 1.0).abs() <= NOT_UNIT {
        return Ok(*pose);
    }
    Ok(Pose { rotation: (pose.rotation / largest).normalize(), ..*pose })
}
