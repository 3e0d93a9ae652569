//! How a stove heats, as far as it is heard, and how loud it is.

/// How a stove heats, as far as it is heard.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stove {
    /// An iron plate, or an element behind glass.
    #[default]
    Silent,
    /// A gas burner.
    Flame,
    /// An induction coil.
    Coil,
}

impl Stove {
    /// All of them, in declaration order.
    pub const ALL: [Self; 3] = [Self::Silent, Self::Flame, Self::Coil];

    /// Power of its sound, over that of a full-scale square [-], at a power that it draws [W].
    ///
    /// The noise of a turbulent flame is proportional to its heat; the force on a pan, and with it the amplitude, to the power of a coil.
    pub(crate) fn loudness(self, drawn_w: f32) -> f32 {
        let share = drawn_w / REFERENCE_W;
        match self {
            Self::Silent => 0.0,
            Self::Flame => FLAME * share,
            Self::Coil => COIL * share * share,
        }
    }
}

/// Power at which the levels are stated [W].
const REFERENCE_W: f32 = 2000.0;
/// Power of the sound of a flame and of a coil at the reference [-] (chosen: −48 and −58 dBFS, far below a sizzle; no level is
/// published).
const FLAME: f32 = 1.6e-5;
const COIL: f32 = 1.6e-6;
