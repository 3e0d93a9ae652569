//! Actions on the pan, the hob and the lid.

use serde_json::{Value, json};

use crate::action::{ActionKind, mm, tidy};
use saute_kitchen::celsius;
use saute_kitchen::hands::command::Command;

/// An action on no particular food.
#[derive(Clone, Debug, PartialEq)]
pub enum PanAction {
    /// Sets the electrical power of the hob [W].
    Hob(f64),
    /// Lets the hob hold the pan at a temperature.
    HobHold {
        /// Temperature [K].
        temperature: f64,
        /// Largest electrical power [W].
        power: f64,
    },
    /// Moves the pan over the hob, or lifts it.
    MovePan {
        /// Centre of the pan relative to the ring's [m].
        at: [f64; 2],
        /// Height above the glass [m].
        lift: f64,
    },
    /// Sets the pan on the wet cloth.
    Cool {
        /// Duration [s].
        for_s: f64,
    },
    /// Pours oil into the pan.
    Oil {
        /// Id of the oil; the kitchen's default if none.
        kind: Option<String>,
        /// Mass [kg].
        mass: f64,
    },
    /// Puts butter into the pan [kg].
    Butter(f64),
    /// Pours water into the pan [kg].
    Water(f64),
    /// Tosses the foods in the pan.
    Toss {
        /// Height of their flight [m].
        height: f64,
    },
    /// Shakes the pan to and fro.
    Shake {
        /// Amplitude to either side [m].
        amplitude: f64,
        /// Frequency [Hz].
        hz: f64,
        /// Duration [s].
        for_s: f64,
    },
    /// Tilts the pan.
    Tilt {
        /// Angle between floor and horizontal [rad].
        angle: f64,
        /// Direction of the descent, from +x over +y [rad].
        towards: f64,
    },
    /// Lays the lid on (true) or takes it off (false).
    Lid(bool),
    /// Wipes the empty pan.
    Wipe,
}

impl PanAction {
    /// Returns the kind of the action.
    pub fn kind(&self) -> ActionKind {
        match self {
            Self::Hob(_) | Self::HobHold { .. } => ActionKind::Hob,
            Self::MovePan { .. } => ActionKind::MovePan,
            Self::Cool { .. } => ActionKind::Cool,
            Self::Oil { .. } => ActionKind::Oil,
            Self::Butter(_) => ActionKind::Butter,
            Self::Water(_) => ActionKind::Water,
            Self::Toss { .. } => ActionKind::Toss,
            Self::Shake { .. } => ActionKind::Shake,
            Self::Tilt { .. } => ActionKind::Tilt,
            Self::Lid(_) => ActionKind::Lid,
            Self::Wipe => ActionKind::Wipe,
        }
    }

    /// Returns the command for the kitchen.
    pub fn command(&self) -> Command {
        match self {
            Self::Hob(power) => Command::Hob(*power),
            Self::HobHold { temperature, power } => Command::HobHold { temperature: *temperature, power: *power },
            Self::MovePan { at, lift } => Command::MovePan { at: *at, lift: *lift },
            Self::Cool { for_s } => Command::Cool { for_s: *for_s },
            Self::Oil { kind, mass } => Command::Oil { kind: kind.clone(), mass: *mass },
            Self::Butter(mass) => Command::Butter(*mass),
            Self::Water(mass) => Command::Water(*mass),
            Self::Toss { height } => Command::Toss { height: *height },
            Self::Shake { amplitude, hz, for_s } => Command::Shake { amplitude: *amplitude, hz: *hz, for_s: *for_s },
            Self::Tilt { angle, towards } => Command::Tilt { angle: *angle, towards: *towards },
            Self::Lid(on) => Command::Lid(*on),
            Self::Wipe => Command::Wipe,
        }
    }

    /// Returns the action that gives a command; none for a command on a food and for motions of a hand.
    pub fn of_command(command: &Command) -> Option<Self> {
        Some(match command {
            Command::Hob(power) => Self::Hob(*power),
            Command::HobHold { temperature, power } => Self::HobHold { temperature: *temperature, power: *power },
            Command::MovePan { at, lift } => Self::MovePan { at: *at, lift: *lift },
            Command::Cool { for_s } => Self::Cool { for_s: *for_s },
            Command::Oil { kind, mass } => Self::Oil { kind: kind.clone(), mass: *mass },
            Command::Butter(mass) => Self::Butter(*mass),
            Command::Water(mass) => Self::Water(*mass),
            Command::Toss { height } => Self::Toss { height: *height },
            Command::Shake { amplitude, hz, for_s } => Self::Shake { amplitude: *amplitude, hz: *hz, for_s: *for_s },
            Command::Tilt { angle, towards } => Self::Tilt { angle: *angle, towards: *towards },
            Command::Lid(on) => Self::Lid(*on),
            Command::Wipe => Self::Wipe,
            Command::Put { .. } | Command::Flip { .. } | Command::Rest { .. } | Command::Halve { .. } => return None,
            Command::Press { .. } | Command::Baste { .. } | Command::Move { .. } => return None,
            Command::Lead { .. } | Command::LetGo | Command::HoldPan { .. } => return None,
        })
    }

    /// Returns the action's value in the units of the recipe, as JSON.
    pub fn value(&self) -> Value {
        match self {
            Self::Hob(power) => (*power).into(),
            Self::HobHold { temperature, power } => json!({ "hold_c": tidy(celsius(*temperature)), "w": power }),
            Self::MovePan { at, lift } => json!({ "at_mm": at.map(mm), "lift_mm": mm(*lift) }),
            Self::Cool { for_s } => (*for_s).into(),
            Self::Oil { kind, mass } => json!({ "g": mm(*mass), "kind": kind }),
            Self::Butter(mass) | Self::Water(mass) => mm(*mass).into(),
            Self::Toss { height } => json!({ "height_mm": mm(*height) }),
            Self::Shake { amplitude, hz, for_s } => {
                json!({ "amplitude_mm": mm(*amplitude), "hz": hz, "for_s": for_s })
            }
            Self::Tilt { angle, towards } => {
                json!({ "deg": tidy(angle.to_degrees()), "towards_deg": tidy(towards.to_degrees()) })
            }
            Self::Lid(on) => (*on).into(),
            Self::Wipe => true.into(),
        }
    }

    /// Returns the action in English: `hob 2000 W`.
    pub fn words(&self) -> String {
        match self {
            Self::Hob(power) => format!("hob {power} W"),
            Self::HobHold { temperature, power } => {
                format!("hob holds {} °C with up to {power} W", tidy(celsius(*temperature)))
            }
            Self::MovePan { at, lift } => format!("pan to {} mm, lifted by {} mm", json!(at.map(mm)), mm(*lift)),
            Self::Cool { for_s } => format!("pan on a wet cloth for {for_s} s"),
            Self::Oil { kind: None, mass } => format!("{} g oil", mm(*mass)),
            Self::Oil { kind: Some(kind), mass } => format!("{} g {kind} oil", mm(*mass)),
            Self::Butter(mass) => format!("{} g butter", mm(*mass)),
            Self::Water(mass) => format!("{} g water", mm(*mass)),
            Self::Toss { height } => format!("toss {} mm high", mm(*height)),
            Self::Shake { amplitude, hz, for_s } => {
                format!("shake ± {} mm at {hz} Hz for {for_s} s", mm(*amplitude))
            }
            Self::Tilt { angle, towards } => match tidy(angle.to_degrees()) {
                0.0 => "level the pan".to_owned(),
                degrees => format!("tilt by {degrees}° towards {}°", tidy(towards.to_degrees())),
            },
            Self::Lid(on) => if *on { "lid on" } else { "lid off" }.to_owned(),
            Self::Wipe => "wipe the pan".to_owned(),
        }
    }

    /// Returns the time for which the next step waits at least [s].
    pub fn duration_s(&self) -> f64 {
        match self {
            Self::Cool { for_s } | Self::Shake { for_s, .. } => *for_s,
            Self::Hob(_)
            | Self::HobHold { .. }
            | Self::MovePan { .. }
            | Self::Oil { .. }
            | Self::Butter(_)
            | Self::Water(_) => 0.0,
            Self::Toss { .. } | Self::Tilt { .. } | Self::Lid(_) | Self::Wipe => 0.0,
        }
    }
}
