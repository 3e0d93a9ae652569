//! Checks the action of a step and converts it to SI units.

use toml::Spanned;

use crate::action::kind::{ActionEntry, ActionKind};
use crate::action::{Action, FoodAction, PanAction};
use crate::check::recipe_check::{Check, Checked, FoodNames};
use crate::file::action_file::{
    ButterTable, CoolTable, HalveTable, HobTable, MovePanTable, MoveTable, OilTable, PressTable, PutTable, RestTable,
    ShakeTable, TiltTable, TossTable, WaterTable,
};
use crate::file::step_file::{StepEntry, StepKeys};
use saute_kitchen::hands::command::RestOn;
use saute_kitchen::hands::ranges::{
    COOL_S, FAT_G, FOR_S, HALVE_AT_MM, LIFT_MM, Limits, PAN_MM, PLACE_MM, PRESS_N, SHAKE_AMPLITUDE_MM, SHAKE_HZ,
    TILT_DEG, TOSS_HEIGHT_MM, TOWARDS_DEG, WATER_G,
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
        let each = |food: &Spanned<String>, action: Checked<FoodAction>| {
            Ok(Action::Each(self.target(food, entry.kind().name(), names)?, action?))
        };
        let pan = match entry {
            ActionEntry::Put(e) => return each(&e.table.food, self.put(&e.table, keys.at_mm.as_ref())),
            ActionEntry::Flip(e) => return each(&e.table.food, Ok(FoodAction::Flip)),
            ActionEntry::Rest(e) => return each(&e.table.food, Ok(rest(&e.table, keys.on.as_ref()))),
            ActionEntry::Halve(e) => return each(&e.table.food, self.halve(&e.table)),
            ActionEntry::Press(e) => return each(&e.table.food, self.press(&e.table)),
            ActionEntry::Move(e) => return each(&e.table.food, self.move_to(&e.table)),
            ActionEntry::Repeat(repeat) => return self.repeat(repeat, names),
            ActionEntry::End(done) => return self.done("end", &done.0).map(|()| Action::End),
            ActionEntry::Hob(e) => self.hob(&e.table),
            ActionEntry::MovePan(e) => self.move_pan(&e.table),
            ActionEntry::Cool(e) => self.cool(&e.table, keys.for_s.as_ref()),
            ActionEntry::Oil(e) => self.oil(&e.table),
            ActionEntry::Butter(e) => self.butter(&e.table),
            ActionEntry::Water(e) => self.water(&e.table),
            ActionEntry::Toss(e) => self.toss(&e.table),
            ActionEntry::Shake(e) => self.shake(&e.table),
            ActionEntry::Tilt(e) => self.tilt(&e.table),
            ActionEntry::Lid(e) => Ok(PanAction::Lid(e.table.on.0)),
            ActionEntry::Wipe(done) => self.done("wipe", &done.0).map(|()| PanAction::Wipe),
        };
        pan.map(Action::Pan)
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

    fn cool(&self, cool: &CoolTable, companion: Option<&Spanned<f64>>) -> Checked<PanAction> {
        let default = self.library.room.cloth.default_s;
        let limits = Limits { default, ..COOL_S };
        Ok(PanAction::Cool { for_s: self.limited("for_s", cool.for_s.as_ref().or(companion), limits)? })
    }

    fn oil(&self, oil: &OilTable) -> Checked<PanAction> {
        let kind = oil.kind.as_ref().map(|kind| kind.get_ref().clone());
        Ok(PanAction::Oil { kind, mass: self.grams("oil_g", &oil.g, FAT_G)? })
    }

    fn butter(&self, butter: &ButterTable) -> Checked<PanAction> {
        Ok(PanAction::Butter(self.grams("butter_g", &butter.g, FAT_G)?))
    }

    fn water(&self, water: &WaterTable) -> Checked<PanAction> {
        Ok(PanAction::Water(self.grams("water_g", &water.g, WATER_G)?))
    }

    /// Returns a mass of at least `low` and at most `high` grams [kg].
    fn grams(&self, key: &str, g: &Spanned<f64>, [low, high]: [f64; 2]) -> Checked<f64> {
        Ok(1e-3 * self.input.ranged(key, g, low, high)?)
    }

    fn toss(&self, toss: &TossTable) -> Checked<PanAction> {
        let height = self.limited("toss.height_mm", toss.height_mm.as_ref(), TOSS_HEIGHT_MM)?;
        Ok(PanAction::Toss { height: 1e-3 * height })
    }

    fn shake(&self, shake: &ShakeTable) -> Checked<PanAction> {
        let amplitude = self.limited("shake.amplitude_mm", shake.amplitude_mm.as_ref(), SHAKE_AMPLITUDE_MM)?;
        let hz = self.limited("shake.hz", shake.hz.as_ref(), SHAKE_HZ)?;
        let for_s = self.limited("shake.for_s", shake.for_s.as_ref(), FOR_S)?;
        Ok(PanAction::Shake { amplitude: 1e-3 * amplitude, hz, for_s })
    }

    fn tilt(&self, tilt: &TiltTable) -> Checked<PanAction> {
        let angle = self.input.ranged("tilt.deg", &tilt.deg, TILT_DEG[0], TILT_DEG[1])?;
        let towards = self.limited("tilt.towards_deg", tilt.towards_deg.as_ref(), TOWARDS_DEG)?;
        Ok(PanAction::Tilt { angle: angle.to_radians(), towards: towards.to_radians() })
    }

    fn move_pan(&self, to: &MovePanTable) -> Checked<PanAction> {
        let at = self.place("move_pan.at_mm", to.at_mm.as_ref(), PAN_MM, "of the ring's centre")?;
        let lift = self.limited("move_pan.lift_mm", to.lift_mm.as_ref(), LIFT_MM)?;
        Ok(PanAction::MovePan { at, lift: lift * 1e-3 })
    }

    fn put(&self, put: &PutTable, companion: Option<&Spanned<Vec<f64>>>) -> Checked<FoodAction> {
        let at = self.place("at_mm", put.at_mm.as_ref().or(companion), PLACE_MM, "of the pan's centre")?;
        Ok(FoodAction::Put { at, heap: put.heap.unwrap_or(false) })
    }

    fn halve(&self, halve: &HalveTable) -> Checked<FoodAction> {
        Ok(FoodAction::Halve { at: 1e-3 * self.limited("halve.at_mm", halve.at_mm.as_ref(), HALVE_AT_MM)? })
    }

    fn press(&self, press: &PressTable) -> Checked<FoodAction> {
        let newtons = self.limited("press.n", press.n.as_ref(), PRESS_N)?;
        Ok(FoodAction::Press { newtons, for_s: self.limited("press.for_s", press.for_s.as_ref(), FOR_S)? })
    }

    fn move_to(&self, to: &MoveTable) -> Checked<FoodAction> {
        Ok(FoodAction::Move(self.place("move.to_mm", to.to_mm.as_ref(), PLACE_MM, "of the pan's centre")?))
    }

    /// Returns a number within its limits, or its default.
    fn limited(&self, key: &str, value: Option<&Spanned<f64>>, limits: Limits) -> Checked<f64> {
        value.map_or(Ok(limits.default), |v| self.input.ranged(key, v, limits.low, limits.high))
    }

    /// Returns a place with both coordinates within limits [m]; the centre by default.
    fn place(&self, key: &str, at: Option<&Spanned<Vec<f64>>>, limits: Limits, of: &str) -> Checked<[f64; 2]> {
        let Some(at) = at else { return Ok([0.0, 0.0]) };
        match <[f64; 2]>::try_from(at.get_ref().as_slice()) {
            Ok(mm) if mm.iter().all(|v| (limits.low..=limits.high).contains(v)) => Ok(mm.map(|v| v * 1e-3)),
            _ => {
                let own = key.rsplit('.').next().unwrap_or(key);
                let remedy =
                    format!("write {own} = [x, y], for instance [20, 0], with both within ± {} mm {of}", limits.high);
                self.input.error(at.span().start, format!("{key} needs two numbers within reach"), remedy)
            }
        }
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
