//! Checks the action of a step and turns it into SI units.

use toml::Spanned;

use crate::check::recipe_check::{Cast, Check, Checked};
use crate::file::action_file::{
    ButterTable, COOL_S, CoolTable, FAT_G, FOR_S, HALVE_AT_MM, HalveTable, HobTable, LIFT_MM, Limits, MovePanTable,
    MoveTable, OilTable, PRESS_N, PressTable, PutTable, SHAKE_AMPLITUDE_MM, SHAKE_HZ, ShakeTable, TILT_DEG,
    TOSS_HEIGHT_MM, TOWARDS_DEG, TiltTable, TossTable, WATER_G, WaterTable,
};
use crate::file::recipe_file::StepEntry;
use crate::file::shorthand::Entry;
use crate::recipe::{Action, Deed};
use saute_kitchen::InputError;
use saute_kitchen::hands::command::Command;

/// Actions that a step may have, in words.
const ACTIONS: &str =
    "hob_w, put, flip, rest, halve, move_pan, cool, oil_g, butter_g, water_g, toss, shake, tilt, press, move, lid, end";

impl Check<'_> {
    pub(crate) fn action(&self, at: usize, step: &StepEntry, cast: &Cast) -> Checked<Action> {
        self.check_companions(step)?;
        let mut actions = self.pan_actions(step);
        actions.extend(self.food_actions(step, cast));
        actions.extend(step.end.as_ref().map(|end| self.end(end)));
        match actions.len() {
            0 => self.input.error(at, "the step has no action", format!("add one of {ACTIONS}")),
            1 => actions.remove(0),
            _ => self.input.error(at, "the step has more than one action", "write one [[step]] for each action"),
        }
    }

    /// Actions that concern no single food.
    fn pan_actions(&self, step: &StepEntry) -> Vec<Checked<Action>> {
        let commands = [
            step.hob_w.as_ref().map(|e| self.hob(&e.table)),
            step.move_pan.as_ref().map(|e| self.move_pan(&e.table)),
            step.cool.as_ref().map(|e| self.cool(e, step.for_s.as_ref())),
            step.oil_g.as_ref().map(|e| self.oil(&e.table)),
            step.butter_g.as_ref().map(|e| self.butter(&e.table)),
            step.water_g.as_ref().map(|e| self.water(&e.table)),
            step.toss.as_ref().map(|e| self.toss(&e.table)),
            step.shake.as_ref().map(|e| self.shake(&e.table)),
            step.tilt.as_ref().map(|e| self.tilt(&e.table)),
            step.lid.as_ref().map(|e| Ok(Command::Lid(e.table.on.0))),
        ];
        commands.into_iter().flatten().map(|command| command.map(Action::Do)).collect()
    }

    /// Actions on foods.
    fn food_actions(&self, step: &StepEntry, cast: &Cast) -> Vec<Checked<Action>> {
        let each = |food: &Spanned<String>, key: &str, deed: Checked<Deed>| {
            Ok(Action::Each(self.target(food, key, cast)?, deed?))
        };
        let actions = [
            step.put.as_ref().map(|e| each(&e.table.food, "put", self.put(&e.table, step.at_mm.as_ref()))),
            step.flip.as_ref().map(|e| each(&e.table.food, "flip", Ok(Deed::Flip))),
            step.rest.as_ref().map(|e| {
                let on = e.table.on.or(step.on.as_ref().map(|on| *on.get_ref()));
                each(&e.table.food, "rest", Ok(Deed::Rest(on.unwrap_or_default())))
            }),
            step.halve.as_ref().map(|e| each(&e.table.food, "halve", self.halve(&e.table))),
            step.press.as_ref().map(|e| each(&e.table.food, "press", self.press(&e.table))),
            step.move_to.as_ref().map(|e| each(&e.table.food, "move", self.move_to(&e.table))),
        ];
        actions.into_iter().flatten().collect()
    }

    fn end(&self, end: &Spanned<bool>) -> Checked<Action> {
        if *end.get_ref() {
            return Ok(Action::End);
        }
        self.input.error(end.span().start, "end = false does nothing", "write end = true, or leave the step out")
    }

    fn hob(&self, to: &HobTable) -> Checked<Command> {
        Ok(Command::Hob(self.input.ranged("hob_w", &to.w, 0.0, self.library.hob.coil.largest_w)?))
    }

    fn cool(&self, entry: &Entry<CoolTable>, beside: Option<&Spanned<f64>>) -> Checked<Command> {
        let default = self.library.room.cloth.default_s;
        let limits = Limits { default, ..COOL_S };
        Ok(Command::Cool { for_s: self.limited("for_s", entry.table.for_s.as_ref().or(beside), limits)? })
    }

    fn oil(&self, oil: &OilTable) -> Checked<Command> {
        let kind = oil.kind.as_ref().map(|kind| kind.get_ref().clone());
        Ok(Command::Oil { kind, mass: self.grams("oil_g", &oil.g, FAT_G)? })
    }

    fn butter(&self, butter: &ButterTable) -> Checked<Command> {
        Ok(Command::Butter(self.grams("butter_g", &butter.g, FAT_G)?))
    }

    fn water(&self, water: &WaterTable) -> Checked<Command> {
        Ok(Command::Water(self.grams("water_g", &water.g, WATER_G)?))
    }

    /// Grams in their range [kg].
    fn grams(&self, key: &str, g: &Spanned<f64>, [low, high]: [f64; 2]) -> Checked<f64> {
        Ok(1e-3 * self.input.ranged(key, g, low, high)?)
    }

    fn toss(&self, toss: &TossTable) -> Checked<Command> {
        let height = self.limited("toss.height_mm", toss.height_mm.as_ref(), TOSS_HEIGHT_MM)?;
        Ok(Command::Toss { height: 1e-3 * height })
    }

    fn shake(&self, shake: &ShakeTable) -> Checked<Command> {
        let amplitude = self.limited("shake.amplitude_mm", shake.amplitude_mm.as_ref(), SHAKE_AMPLITUDE_MM)?;
        let hz = self.limited("shake.hz", shake.hz.as_ref(), SHAKE_HZ)?;
        let for_s = self.limited("shake.for_s", shake.for_s.as_ref(), FOR_S)?;
        Ok(Command::Shake { amplitude: 1e-3 * amplitude, hz, for_s })
    }

    fn tilt(&self, tilt: &TiltTable) -> Checked<Command> {
        let angle = self.input.ranged("tilt.deg", &tilt.deg, TILT_DEG[0], TILT_DEG[1])?;
        let towards = self.limited("tilt.towards_deg", tilt.towards_deg.as_ref(), TOWARDS_DEG)?;
        Ok(Command::Tilt { angle: angle.to_radians(), towards: towards.to_radians() })
    }

    fn move_pan(&self, to: &MovePanTable) -> Checked<Command> {
        let at = self.place("move_pan.at_mm", to.at_mm.as_ref(), 350.0, "of the ring's centre")?;
        let lift = self.limited("move_pan.lift_mm", to.lift_mm.as_ref(), LIFT_MM)?;
        Ok(Command::MovePan { at, lift: lift * 1e-3 })
    }

    fn put(&self, put: &PutTable, beside: Option<&Spanned<Vec<f64>>>) -> Checked<Deed> {
        let at = self.place("at_mm", put.at_mm.as_ref().or(beside), 200.0, "of the pan's centre")?;
        Ok(Deed::Put { at, heap: put.heap.unwrap_or(false) })
    }

    fn halve(&self, halve: &HalveTable) -> Checked<Deed> {
        Ok(Deed::Halve { at: 1e-3 * self.limited("halve.at_mm", halve.at_mm.as_ref(), HALVE_AT_MM)? })
    }

    fn press(&self, press: &PressTable) -> Checked<Deed> {
        let newtons = self.limited("press.n", press.n.as_ref(), PRESS_N)?;
        Ok(Deed::Press { newtons, for_s: self.limited("press.for_s", press.for_s.as_ref(), FOR_S)? })
    }

    fn move_to(&self, to: &MoveTable) -> Checked<Deed> {
        Ok(Deed::Move(self.place("move.to_mm", to.to_mm.as_ref(), 200.0, "of the pan's centre")?))
    }

    /// A number within its limits, or its default.
    fn limited(&self, key: &str, value: Option<&Spanned<f64>>, limits: Limits) -> Checked<f64> {
        value.map_or(Ok(limits.default), |v| self.input.ranged(key, v, limits.low, limits.high))
    }

    /// Two numbers within `farthest` [mm] as a place [m]; the middle unless given.
    fn place(&self, key: &str, at: Option<&Spanned<Vec<f64>>>, farthest: f64, of: &str) -> Checked<[f64; 2]> {
        let Some(at) = at else { return Ok([0.0, 0.0]) };
        match <[f64; 2]>::try_from(at.get_ref().as_slice()) {
            Ok(mm) if mm.iter().all(|v| v.abs() <= farthest) => Ok(mm.map(|v| v * 1e-3)),
            _ => {
                let own = key.rsplit('.').next().unwrap_or(key);
                let remedy =
                    format!("write {own} = [x, y], for instance [20, 0], with both within ± {farthest} mm {of}");
                self.input.error(at.span().start, format!("{key} needs two numbers within reach"), remedy)
            }
        }
    }

    /// `at_mm`, `on` and `for_s` belong beside a bare `put`, `rest` and `cool`.
    fn check_companions(&self, step: &StepEntry) -> Checked<()> {
        let companions = [
            ("at_mm", step.at_mm.as_ref().map(Spanned::span), "put", step.put.as_ref().map(|e| e.bare)),
            ("on", step.on.as_ref().map(Spanned::span), "rest", step.rest.as_ref().map(|e| e.bare)),
            ("for_s", step.for_s.as_ref().map(Spanned::span), "cool", step.cool.as_ref().map(|e| e.bare)),
        ];
        for (key, span, owner, bare) in companions {
            let Some(span) = span else { continue };
            self.check_companion(key, span.start, owner, bare)?;
        }
        Ok(())
    }

    fn check_companion(&self, key: &str, at: usize, owner: &str, bare: Option<bool>) -> Result<(), InputError> {
        match bare {
            Some(true) => Ok(()),
            Some(false) => {
                let message = format!("{key} stands beside the table of {owner}");
                self.input.error(at, message, format!("write it into the table: {owner} = {{ …, {key} = … }}"))
            }
            None => {
                let message = format!("{key} has no {owner} beside it");
                self.input.error(
                    at,
                    message,
                    format!("{key} belongs to a step with {owner}, or into the action's own table"),
                )
            }
        }
    }
}
