//! What the motors of a gamepad let a hand feel: collisions, sliding and boiling in the pan.

use saute_haptics::{ContactModel, KitchenWatch, Rumble, RumbleRule, library};
use saute_kitchen::{FRAME_S, Kitchen};

/// A gamepad falls silent when nothing has happened for so long [s] (chosen: three frames).
const SILENT_S: f64 = 0.05;

/// The contact model, and what a gamepad makes of it.
#[derive(Default)]
pub struct Felt {
    watch: KitchenWatch,
    model: ContactModel,
    /// Time since the kitchen was looked at last [s].
    silent: f64,
    /// True if a gamepad renders what is felt.
    listened: bool,
    rule: Option<RumbleRule>,
    /// The strongest rumble since the gamepad was told, and the last one.
    strongest: Option<Rumble>,
    last: Rumble,
}

impl Felt {
    /// Returns true if a gamepad renders what is felt.
    pub fn is_listened(&self) -> bool {
        self.listened
    }

    /// Looks at the kitchen after a frame at the pace of the clock. On a slow machine a whole toss passes between two pictures: what
    /// is felt is judged here, frame by frame.
    pub fn look(&mut self, kitchen: &Kitchen) -> &ContactModel {
        self.model = self.watch.look(kitchen, FRAME_S);
        self.silent = 0.0;
        if self.listened {
            self.judge();
        }
        &self.model
    }

    fn judge(&mut self) {
        if self.rule.is_none() {
            // The program's own file is whole, or nothing at all is felt.
            self.rule = library::feel().ok().map(|feel| RumbleRule::new(&feel));
        }
        if let Some(rule) = &mut self.rule {
            self.last = rule.step(&self.model, FRAME_S);
            self.strongest = Some(self.strongest.map_or(self.last, |before| before.or(self.last)));
        }
    }

    /// Another kitchen is shown.
    pub fn forget(&mut self) {
        self.watch.forget();
    }

    /// Returns the rumble of a gamepad now, `wall` after the last call [s]: the strongest since then; none while time is stopped or
    /// runs faster.
    pub fn rumble(&mut self, wall: f64) -> Rumble {
        self.listened = true;
        self.silent += wall;
        let felt = self.strongest.take().unwrap_or(self.last);
        if self.silent > SILENT_S + wall { Rumble::default() } else { felt }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use saute_kitchen::food::Rules;
    use saute_kitchen::{Command, Library, MeshSize, OutlineKind, PieceOrder, kelvin};

    fn kitchen_with_steak() -> Kitchen {
        let library = Library::embedded().unwrap();
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).unwrap();
        let order = PieceOrder {
            id: "steak".into(),
            kind: "beef-lean".into(),
            size: [0.10, 0.092, 0.035],
            temperature: kelvin(5.0),
            seed: 1,
            coarseness: 3.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Plain,
        };
        kitchen.add(&library, &order).unwrap();
        kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: true }).unwrap();
        kitchen
    }

    fn frames(felt: &mut Felt, kitchen: &mut Kitchen, frames: u32) {
        for _ in 0..frames {
            kitchen.advance_frame();
            felt.look(kitchen);
        }
    }

    #[test]
    fn a_toss_that_passes_between_two_pictures_is_felt() {
        let (mut felt, mut kitchen) = (Felt::default(), kitchen_with_steak());
        felt.rumble(0.016);
        // Until now time went faster, and nothing was felt.
        for _ in 0..60 {
            kitchen.advance_frame();
        }
        felt.rumble(1.0);
        kitchen.apply(&Command::Toss { height: 0.12 }).unwrap();
        frames(&mut felt, &mut kitchen, 180);
        let most = |rumble: Rumble| rumble.strong.max(rumble.weak);
        assert!(most(felt.rumble(3.0)) > 0.1);
        frames(&mut felt, &mut kitchen, 1);
        assert!(most(felt.rumble(0.016)) < 0.05, "it is over");
    }
}
