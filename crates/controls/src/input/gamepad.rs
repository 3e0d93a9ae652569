//! Meaning of a gamepad's sticks and buttons, without a device: a state comes in, motions and acts go out.

use glam::{DVec2, DVec3};

use crate::act::{Act, AppAct, CookAct, TimeAct, ViewAct};

/// Buttons of a gamepad, by where they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PadButton {
    /// Lowest of the four at the right thumb.
    South,
    /// Rightmost.
    East,
    /// Leftmost.
    West,
    /// Uppermost.
    North,
    /// Directions at the left thumb.
    Up,
    /// Downwards.
    Down,
    /// To the left.
    Left,
    /// To the right.
    Right,
    /// Left shoulder.
    LeftShoulder,
    /// Right shoulder.
    RightShoulder,
    /// Right one of the middle.
    Start,
    /// Left one of the middle.
    Select,
}

impl PadButton {
    /// All buttons, in their order.
    pub const ALL: [Self; 12] = [
        Self::South,
        Self::East,
        Self::West,
        Self::North,
        Self::Up,
        Self::Down,
        Self::Left,
        Self::Right,
        Self::LeftShoulder,
        Self::RightShoulder,
        Self::Start,
        Self::Select,
    ];
}

/// State of a gamepad: sticks to the right and up −1…1, triggers 0…1 [-].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PadState {
    /// Left stick.
    pub left: [f64; 2],
    /// Right stick.
    pub right: [f64; 2],
    /// Left trigger.
    pub left_trigger: f64,
    /// Right trigger.
    pub right_trigger: f64,
    /// Which buttons are down, in the order of [`PadButton::ALL`].
    pub down: [bool; PadButton::ALL.len()],
}

impl PadState {
    /// Returns true if a button is down.
    pub fn is_down(&self, button: PadButton) -> bool {
        self.down[button as usize]
    }
}

/// Requested motion of pan and tool as shares of their full speed, −1…1 [-]; to the right, away from the cook, up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PadMotion {
    /// The pan moves.
    pub pan: DVec3,
    /// The pan leans to the left and towards the cook, as share of the full tilt.
    pub lean: DVec2,
    /// The tool moves.
    pub tool: DVec3,
    /// The tool rolls to the right and lowers its front edge.
    pub twist: [f64; 2],
}

/// Deflection of a stick that means nothing, and that of a trigger from which on it counts [-] (chosen: worn sticks
/// rest there).
const DEAD: f64 = 0.15;
const PULLED: f64 = 0.5;

/// Sticks and buttons, as the help lists them.
pub const PAD: [(&str, &str); 12] = [
    ("L stick", "pad.move_pan"),
    ("LT+stick", "pad.tilt_pan"),
    ("LT+LB/RB", "pad.lift_pan"),
    ("R stick", "pad.move_tool"),
    ("RT+stick", "pad.roll_turner"),
    ("LB, RB", "pad.raise_tool"),
    ("A / cross", "pad.flip"),
    ("X / square", "pad.toss"),
    ("Y / triangle", "pad.tool"),
    ("B / circle", "pad.put_away"),
    ("D-pad", "pad.cross"),
    ("Start", "pad.start"),
];

/// What each button does when it goes down.
static ACTS: [(PadButton, Act); 10] = [
    (PadButton::South, Act::Cook(CookAct::Flip)),
    (PadButton::East, Act::Cook(CookAct::PutAway)),
    (PadButton::West, Act::Cook(CookAct::Toss)),
    (PadButton::North, Act::Cook(CookAct::Tool)),
    (PadButton::Up, Act::Cook(CookAct::Hob(1))),
    (PadButton::Down, Act::Cook(CookAct::Hob(-1))),
    (PadButton::Left, Act::Cook(CookAct::Put)),
    (PadButton::Right, Act::View(ViewAct::NextPiece)),
    (PadButton::Start, Act::Time(TimeAct::Pause)),
    (PadButton::Select, Act::App(AppAct::Help)),
];

/// What sticks and triggers request.
pub fn motion(now: &PadState) -> PadMotion {
    let [left, right] = [now.left, now.right].map(response);
    let held = |button| f64::from(u8::from(now.is_down(button)));
    let rise = DVec3::Z * (held(PadButton::RightShoulder) - held(PadButton::LeftShoulder));
    let (tilts, rolls) = (now.left_trigger > PULLED, now.right_trigger > PULLED);
    let along = |stick: DVec2, turned: bool| if turned { DVec3::ZERO } else { stick.extend(0.0) };
    PadMotion {
        pan: along(left, tilts) + if tilts { rise } else { DVec3::ZERO },
        lean: if tilts { -left } else { DVec2::ZERO },
        tool: along(right, rolls) + if tilts { DVec3::ZERO } else { rise },
        twist: if rolls { [right.x, right.y] } else { [0.0; 2] },
    }
}

/// What the buttons request that have gone down since a state.
pub fn acts(before: &PadState, now: &PadState) -> impl Iterator<Item = Act> {
    let pressed = |button| now.is_down(button) && !before.is_down(button);
    ACTS.iter().filter(move |(button, _)| pressed(*button)).map(|(_, act)| act.clone())
}

/// Nothing within the dead zone, then quadratic to full deflection: gentle near the middle.
fn response(stick: [f64; 2]) -> DVec2 {
    let stick = DVec2::from_array(stick);
    let beyond = ((stick.length() - DEAD) / (1.0 - DEAD)).clamp(0.0, 1.0);
    stick.normalize_or_zero() * beyond * beyond
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(down: &[PadButton]) -> PadState {
        let mut state = PadState::default();
        down.iter().for_each(|b| state.down[*b as usize] = true);
        state
    }

    #[test]
    fn a_worn_stick_at_rest_moves_nothing_and_a_full_one_moves_at_full_speed() {
        let rest = PadState { left: [0.09, -0.09], right: [-0.1, 0.1], ..PadState::default() };
        assert_eq!(motion(&rest), PadMotion::default());
        let full = PadState { left: [1.0, 0.0], right: [0.0, -1.0], ..PadState::default() };
        let moved = motion(&full);
        assert_eq!((moved.pan, moved.tool), (DVec3::X, -DVec3::Y), "both hands at once");
        let corner = motion(&PadState { left: [1.0, 1.0], ..PadState::default() });
        assert!(corner.pan.length() <= 1.0 + 1e-12, "no faster along a diagonal");
    }

    #[test]
    fn the_response_is_gentle_near_the_middle_and_grows_steadily() {
        let speed = |x: f64| motion(&PadState { left: [x, 0.0], ..PadState::default() }).pan.x;
        assert!(speed(0.3) < 0.05, "{}", speed(0.3));
        let speeds: Vec<f64> = (0..=20u8).map(|k| speed(f64::from(k) / 20.0)).collect();
        assert!(speeds.windows(2).all(|s| s[1] >= s[0]));
        assert!((speed(-0.7) + speed(0.7)).abs() < 1e-12);
    }

    #[test]
    fn triggers_turn_moving_into_tilting() {
        let tilt = motion(&PadState { left: [1.0, 0.0], left_trigger: 1.0, ..PadState::default() });
        assert_eq!((tilt.pan, tilt.lean), (DVec3::ZERO, DVec2::new(-1.0, 0.0)));
        let roll = motion(&PadState { right: [1.0, 0.0], right_trigger: 0.8, ..PadState::default() });
        assert_eq!((roll.tool, roll.twist), (DVec3::ZERO, [1.0, 0.0]));
        let raise = with(&[PadButton::RightShoulder]);
        assert_eq!((motion(&raise).tool, motion(&raise).pan), (DVec3::Z, DVec3::ZERO));
        let lift = motion(&PadState { left_trigger: 1.0, ..raise });
        assert_eq!((lift.tool, lift.pan), (DVec3::ZERO, DVec3::Z));
    }

    #[test]
    fn a_button_acts_once_each_time_it_goes_down() {
        let (up, down) = (PadState::default(), with(&[PadButton::South, PadButton::Start]));
        assert_eq!(acts(&up, &down).collect::<Vec<_>>(), [Act::Cook(CookAct::Flip), Act::Time(TimeAct::Pause)]);
        assert_eq!(acts(&down, &down).count() + acts(&down, &up).count(), 0);
        for (button, act) in ACTS.clone() {
            assert_eq!(acts(&up, &with(&[button])).collect::<Vec<_>>(), [act]);
        }
        assert!(PadButton::ALL.iter().enumerate().all(|(i, b)| *b as usize == i));
    }
}
