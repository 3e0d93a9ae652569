//! Checks the action of a step and converts it to SI units.

use toml::Spanned;

use crate::action::kind::{ActionEntry, ActionKind};
use crate::action::{Action, FoodAction, PanAction};
use crate::check::recipe_check::{Check, Checked, FoodNames};
use crate::file::action_file::{
    BasteTable, CoolTable, HalveTable, HobTable, MovePanTable, OilTable, PressTable, PutTable, RestTable, ShakeTable,
    TiltTable, TossTable,
};
use crate::file::step_file::{StepEntry, StepKeys};
use saute_kitchen::hands::command::RestOn;
use saute_kitchen::hands::ranges::{
    COOL_S, FOR_S, HALVE_AT_MM, LIFT_MM, Limits, PRESS_N, SHAKE_AMPLITUDE_MM, SHAKE_HZ, TOSS_HEIGHT_MM, TOWARDS_DEG,
};
use saute_kitchen::kelvin;
use saute_kitchen::pan::hold::Hold;
use saute_schema::InputError;
use saute_schema::number_text::number_text;

impl Check<'_> {
    /// Returns the one action of a step; `at` is the step's place in the text [bytes].
    pub(crate) fn action(&self, at: usize, step: &StepEntry, names: &FoodNames) -> Checked<Action> {
        self.check_companions(step)?;
        match step.actions.as_slice() {
            [entry] => self.one_action(entry, &step.keys, names),
            [] => {
                let remedy = format!("add one of {}", ActionKind::ALL.map(ActionKind::name).join(", "));
                self.input.error(at, "the step has no action", remedy)
            }
            _ => self.input.error(at, "the step has more than one action", "write one [[step]] for each action"),
        }
    }

    pub(crate) fn one_action(&self, entry: &ActionEntry, keys: &StepKeys, names: &FoodNames) -> Checked<Action> {
        let each = |food: &Spanned<String>, action: FoodAction| {
            Ok(Action::Each(self.target(food, entry.kind().name(), names)?, action))
        };
        let pan = match entry {
            ActionEntry::Put(e) => return each(&e.table.food, put(&e.table, keys.at_mm.as_ref())),
            ActionEntry::Flip(e) => return each(&e.table.food, FoodAction::Flip),
            ActionEntry::Rest(e) => return each(&e.table.food, rest(&e.table, keys.on.as_ref())),
            ActionEntry::Halve(e) => return each(&e.table.food, halve(&e.table)),
            ActionEntry::Press(e) => return each(&e.table.food, press(&e.table)),
            ActionEntry::Baste(e) => return each(&e.table.food, baste(&e.table)),
            ActionEntry::Move(e) => return each(&e.table.food, FoodAction::Move(place(e.table.to_mm.as_ref()))),
            ActionEntry::Repeat(repeat) => return self.repeat(repeat, names),
            ActionEntry::End(done) => return self.done("end", &done.0).map(|()| Action::End),
            ActionEntry::Hob(e) => self.hob(&e.table)?,
            ActionEntry::MovePan(e) => move_pan(&e.table),
            ActionEntry::Cool(e) => self.cool(&e.table, keys.for_s.as_ref()),
            ActionEntry::Oil(e) => oil(&e.table),
            ActionEntry::Butter(e) => PanAction::Butter(1e-3 * e.table.g.get_ref()),
            ActionEntry::Water(e) => PanAction::Water(1e-3 * e.table.g.get_ref()),
            ActionEntry::Toss(e) => toss(&e.table),
            ActionEntry::Shake(e) => shake(&e.table),
            ActionEntry::Tilt(e) => tilt(&e.table),
            ActionEntry::Lid(e) => PanAction::Lid(e.table.on.0),
            ActionEntry::Wipe(done) => self.done("wipe", &done.0).map(|()| PanAction::Wipe)?,
        };
        Ok(Action::Pan(pan))
    }

    fn done(&self, key: &str, value: &Spanned<bool>) -> Checked<()> {
        if *value.get_ref() {
            return Ok(());
        }
        let remedy = format!("write {key} = true, or leave the step out");
        self.input.error(value.span().start, format!("{key} = false does nothing"), remedy)
    }

    fn hob(&self, to: &HobTable) -> Checked<PanAction> {
        let hob = &self.library.hob;
        let power = self.input.ranged("hob_w", &to.w, 0.0, hob.largest_w())?;
        let given = hob.nearest_w(power);
        if self.names_hob && given != power {
            let steps: Vec<String> = hob.settings_w().iter().map(|w| number_text(*w)).collect();
            let remedy = format!("write hob_w = {}; its settings are {} W", number_text(given), steps.join(", "));
            let message = format!("hob_w = {}: the hob \"{}\" does not give this power", number_text(power), hob.name);
            return self.input.error(to.w.span().start, message, remedy);
        }
        let Some(hold_c) = &to.hold_c else { return Ok(PanAction::Hob(power)) };
        let Some(Hold { lowest_c, highest_c, .. }) = hob.hold() else {
            let message = format!("hob_w.hold_c: the hob \"{}\" has no sensor and holds no temperature", hob.name);
            let remedy = "write hob_w = a power, or cook on a hob with a sensor: [hob] kind = \"induction\"";
            return self.input.error(hold_c.span().start, message, remedy);
        };
        let temperature = kelvin(self.input.ranged("hob_w.hold_c", hold_c, *lowest_c, *highest_c)?);
        Ok(PanAction::HobHold { temperature, power })
    }

    fn cool(&self, cool: &CoolTable, companion: Option<&Spanned<f64>>) -> PanAction {
        let limits = Limits { default: self.library.room.cloth.default_s, ..COOL_S };
        PanAction::Cool { for_s: stated(cool.for_s.as_ref().or(companion), limits) }
    }

    /// Checks that `at_mm`, `on` and `for_s` accompany a bare `put`, `rest` and `cool`.
    fn check_companions(&self, step: &StepEntry) -> Checked<()> {
        let keys = &step.keys;
        let companions = [
            ("at_mm", keys.at_mm.as_ref().map(Spanned::span), ActionKind::Put),
            ("on", keys.on.as_ref().map(Spanned::span), ActionKind::Rest),
            ("for_s", keys.for_s.as_ref().map(Spanned::span), ActionKind::Cool),
        ];
        for (key, span, owner) in companions {
            let Some(span) = span else { continue };
            let bare = step.actions.iter().find(|entry| entry.kind() == owner).map(ActionEntry::is_bare);
            self.check_companion(key, span.start, owner.name(), bare)?;
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

fn rest(rest: &RestTable, companion: Option<&Spanned<RestOn>>) -> FoodAction {
    FoodAction::Rest(rest.on.or(companion.map(|on| *on.get_ref())).unwrap_or_default())
}

/// Returns what a key states, or its default.
fn stated(value: Option<&Spanned<f64>>, limits: Limits) -> f64 {
    value.map_or(limits.default, |v| *v.get_ref())
}

/// Returns a place [m]; the centre by default.
fn place(at_mm: Option<&Spanned<[f64; 2]>>) -> [f64; 2] {
    at_mm.map_or([0.0, 0.0], |at| at.get_ref().map(|v| v * 1e-3))
}

fn oil(oil: &OilTable) -> PanAction {
    let kind = oil.kind.as_ref().map(|kind| kind.get_ref().clone());
    PanAction::Oil { kind, mass: 1e-3 * oil.g.get_ref() }
}

fn toss(toss: &TossTable) -> PanAction {
    PanAction::Toss { height: 1e-3 * stated(toss.height_mm.as_ref(), TOSS_HEIGHT_MM) }
}

fn shake(shake: &ShakeTable) -> PanAction {
    PanAction::Shake {
        amplitude: 1e-3 * stated(shake.amplitude_mm.as_ref(), SHAKE_AMPLITUDE_MM),
        hz: stated(shake.hz.as_ref(), SHAKE_HZ),
        for_s: stated(shake.for_s.as_ref(), FOR_S),
    }
}

fn tilt(tilt: &TiltTable) -> PanAction {
    let towards = stated(tilt.towards_deg.as_ref(), TOWARDS_DEG).to_radians();
    PanAction::Tilt { angle: tilt.deg.get_ref().to_radians(), towards }
}

fn move_pan(to: &MovePanTable) -> PanAction {
    PanAction::MovePan { at: place(to.at_mm.as_ref()), lift: stated(to.lift_mm.as_ref(), LIFT_MM) * 1e-3 }
}

fn put(put: &PutTable, companion: Option<&Spanned<[f64; 2]>>) -> FoodAction {
    FoodAction::Put { at: place(put.at_mm.as_ref().or(companion)), heap: put.heap.unwrap_or(false) }
}

fn halve(halve: &HalveTable) -> FoodAction {
    FoodAction::Halve { at: 1e-3 * stated(halve.at_mm.as_ref(), HALVE_AT_MM) }
}

fn baste(baste: &BasteTable) -> FoodAction {
    FoodAction::Baste { for_s: stated(baste.for_s.as_ref(), FOR_S) }
}

fn press(press: &PressTable) -> FoodAction {
    FoodAction::Press { newtons: stated(press.n.as_ref(), PRESS_N), for_s: stated(press.for_s.as_ref(), FOR_S) }
}
