//! Checks a recipe as it is written and turns it into SI units.

use std::collections::BTreeMap;

use saute_food::{FoodDescription, Rules};
use toml::Spanned;

use crate::command::{Command, RestOn};
use crate::input_error::{InputError, InputText};
use crate::kelvin;
use crate::kitchen::PieceOrder;
use crate::library::{Library, line_of};
use crate::recipe::{Action, Quantity, Recipe, Step, Trigger};
use crate::recipe_file::{FoodEntry, MovePanEntry, PanEntry, Preset, RecipeFile, StepEntry, WhenEntry};

/// A recipe's text with what it may name.
pub(crate) struct Check<'a> {
    pub(crate) input: InputText<'a>,
    pub(crate) library: &'a Library,
}

/// Where a food is as the steps go by.
#[derive(Clone, Copy, PartialEq)]
enum Whereabouts {
    Waiting,
    Pan,
    Out,
}

type Checked<T> = Result<T, InputError>;

impl Check<'_> {
    pub(crate) fn recipe(&self) -> Checked<Recipe> {
        if self.input.text.trim().is_empty() {
            return self.input.error(0, "the file is empty", "start from a shipped recipe: saute list recipes");
        }
        let raw: RecipeFile = self.input.parse("the keys and their types are listed by: saute schema recipe")?;
        let max_s = raw.max_s.as_ref().map_or(Ok(3600.0), |s| self.input.ranged("max_s", s, 1.0, 86_400.0))?;
        let (pan_kind, pan_temperature) = self.pan(raw.pan.as_ref().map(Spanned::get_ref))?;
        let rules = if raw.preset == Some(Preset::Paper2013) { Rules::Paper2013 } else { Rules::Full };
        let foods = raw.food.iter().map(|f| self.food(f.get_ref(), rules)).collect::<Checked<Vec<_>>>()?;
        self.check_ids(&raw.food)?;
        let steps = raw.step.iter().map(|s| self.step(s, &foods)).collect::<Checked<Vec<_>>>()?;
        self.check_order(&raw, &steps, &foods)?;
        Ok(Recipe {
            title: labelled(raw.title.unwrap_or_else(|| self.input.file.to_owned()), rules),
            max_s,
            pan_kind,
            pan_temperature,
            foods,
            steps,
            file: self.input.file.to_owned(),
            text: self.input.text.to_owned(),
        })
    }

    fn pan(&self, entry: Option<&PanEntry>) -> Checked<(String, f64)> {
        let default = PanEntry::default();
        let entry = entry.unwrap_or(&default);
        let initial =
            entry.initial_c.as_ref().map_or(Ok(20.0), |c| self.input.ranged("pan.initial_c", c, 0.0, 300.0))?;
        let Some(kind) = &entry.kind else { return Ok(("carbon-steel-26".into(), kelvin(initial))) };
        if !self.library.pans.contains_key(kind.get_ref()) {
            let remedy = format!("use one of: {}", Library::names(&self.library.pans));
            return self.input.error(
                kind.span().start,
                format!("pan.kind = \"{}\" is not a pan", kind.get_ref()),
                remedy,
            );
        }
        Ok((kind.get_ref().clone(), kelvin(initial)))
    }

    fn food(&self, entry: &FoodEntry, rules: Rules) -> Checked<PieceOrder> {
        let Some(description) = self.library.foods.get(entry.kind.get_ref()) else {
            let remedy = format!("use one of: {}", Library::names(&self.library.foods));
            return self.input.error(
                entry.kind.span().start,
                format!("food kind = \"{}\" is not a food", entry.kind.get_ref()),
                remedy,
            );
        };
        let id = entry.id.get_ref();
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if id.is_empty() || !id.chars().all(plain) {
            return self.input.error(
                entry.id.span().start,
                format!("food id = \"{id}\" cannot be used"),
                "use letters, digits, - and _, as in id = \"steak\"",
            );
        }
        let size_mm = self.size(entry, description)?;
        let initial =
            entry.initial_c.as_ref().map_or(Ok(5.0), |c| self.input.ranged("food.initial_c", c, 0.0, 60.0))?;
        Ok(PieceOrder {
            id: id.clone(),
            kind: entry.kind.get_ref().clone(),
            size: size_mm.map(|v| v * 1e-3),
            temperature: kelvin(initial),
            seed: u64::from(entry.seed.unwrap_or(1)),
            coarseness: 1.0,
            rules,
        })
    }

    fn size(&self, entry: &FoodEntry, description: &FoodDescription) -> Checked<[f64; 3]> {
        let (form, range) = (description.form, &description.size);
        let (given, at) = match &entry.size_mm {
            Some(given) => (given.get_ref().as_slice(), given.span().start),
            None => (range.default_mm.as_slice(), entry.kind.span().start),
        };
        let names = form.dimensions();
        let Some(size) = form.extent(given) else {
            let defaults: Vec<String> = range.default_mm.iter().map(f64::to_string).collect();
            return self.input.error(
                at,
                format!("size_mm needs {} numbers", ["no", "one", "two", "three"][names.len()]),
                format!("write size_mm = [{}], for instance [{}]", names.join(", "), defaults.join(", ")),
            );
        };
        for (axis, name) in names.iter().enumerate() {
            let (low, high) = (range.min_mm[axis], range.max_mm[axis]);
            if !(low..=high).contains(&given[axis]) {
                let message = format!("size_mm: the {name} of {} mm is out of range", given[axis]);
                return self.input.error(at, message, format!("the {name} may be {low} to {high} mm"));
            }
        }
        if size[2] > size[0].max(size[1]) {
            let message = format!("size_mm: the thickness of {} mm is larger than length and width", size[2]);
            return self.input.error(at, message, "lay the piece on its side: write size_mm = [length, width, thickness] with the thickness not the largest");
        }
        Ok(size)
    }

    fn move_pan(&self, to: &MovePanEntry) -> Checked<Command> {
        let at = match &to.at_mm {
            None => [0.0; 2],
            Some(given) => match <[f64; 2]>::try_from(given.get_ref().clone()) {
                Ok(mm) if mm.iter().all(|v| v.abs() <= 350.0) => mm.map(|v| v * 1e-3),
                _ => {
                    let remedy = "write at_mm = [x, y] with both within ± 350 mm of the ring's centre";
                    return self.input.error(given.span().start, "move_pan.at_mm cannot be used", remedy);
                }
            },
        };
        let lift = to.lift_mm.as_ref().map_or(Ok(0.0), |mm| self.input.ranged("move_pan.lift_mm", mm, 0.0, 500.0))?;
        Ok(Command::MovePan { at, lift: lift * 1e-3 })
    }

    fn check_ids(&self, foods: &[Spanned<FoodEntry>]) -> Checked<()> {
        let mut seen = std::collections::BTreeSet::new();
        for food in foods {
            let id = &food.get_ref().id;
            if !seen.insert(id.get_ref()) {
                return self.input.error(
                    id.span().start,
                    format!("food id = \"{}\" is used twice", id.get_ref()),
                    "give every food its own id",
                );
            }
        }
        Ok(())
    }

    fn step(&self, entry: &Spanned<StepEntry>, foods: &[PieceOrder]) -> Checked<Step> {
        let at = entry.span().start;
        let step = entry.get_ref();
        Ok(Step {
            trigger: self.trigger(at, step, foods)?,
            action: self.action(at, step, foods)?,
            line: line_of(self.input.text, at),
        })
    }

    fn trigger(&self, at: usize, step: &StepEntry, foods: &[PieceOrder]) -> Checked<Trigger> {
        match (&step.at_s, &step.after_s, &step.when) {
            (None, None, None) => Ok(Trigger::After(0.0)),
            (Some(s), None, None) => Ok(Trigger::At(self.input.ranged("at_s", s, 0.0, 86_400.0)?)),
            (None, Some(s), None) => Ok(Trigger::After(self.input.ranged("after_s", s, 0.0, 86_400.0)?)),
            (None, None, Some(when)) => self.condition(when, foods),
            _ => self.input.error(at, "the step has more than one trigger", "keep one of at_s, after_s, when"),
        }
    }

    fn condition(&self, when: &Spanned<WhenEntry>, foods: &[PieceOrder]) -> Checked<Trigger> {
        let at = when.span().start;
        let w = when.get_ref();
        let given: Vec<(Quantity, f64)> = [
            (Quantity::Core, w.core_c.map(kelvin)),
            (Quantity::Top, w.top_c.map(kelvin)),
            (Quantity::Bottom, w.bottom_c.map(kelvin)),
            (Quantity::Mass, w.mass_g.map(|g| g * 1e-3)),
        ]
        .into_iter()
        .filter_map(|(q, v)| Some((q, v?)))
        .collect();
        let trigger = match (w.pan_c, &w.food, given.as_slice()) {
            (Some(c), None, []) => Trigger::Pan(kelvin(c)),
            (None, Some(food), [(quantity, value)]) => {
                Trigger::Food { food: self.known(food, "when.food", foods)?, quantity: *quantity, value: *value }
            }
            _ => {
                return self.input.error(at, "when needs one condition", "write when = { pan_c = 180 } or when = { food = \"steak\", core_c = 57 } (also top_c, bottom_c, mass_g)");
            }
        };
        let value = match &trigger {
            Trigger::Pan(v) | Trigger::Food { value: v, .. } => *v,
            _ => 0.0,
        };
        if !value.is_finite() || value < 0.0 || value > kelvin(500.0) {
            return self.input.error(
                at,
                "the condition's value is out of range",
                "temperatures may be 0 to 500 °C, masses 0 to 500 kg",
            );
        }
        Ok(trigger)
    }

    fn known(&self, id: &Spanned<String>, key: &str, foods: &[PieceOrder]) -> Checked<String> {
        if foods.iter().any(|f| &f.id == id.get_ref()) {
            return Ok(id.get_ref().clone());
        }
        let names: Vec<&str> = foods.iter().map(|f| f.id.as_str()).collect();
        let remedy = if names.is_empty() {
            "add a [[food]] with that id".to_owned()
        } else {
            format!("use one of the recipe's foods: {}", names.join(", "))
        };
        self.input.error(id.span().start, format!("{key} = \"{}\" names no food of this recipe", id.get_ref()), remedy)
    }

    fn action(&self, at: usize, step: &StepEntry, foods: &[PieceOrder]) -> Checked<Action> {
        let mut actions = Vec::new();
        if let Some(power) = &step.hob_w {
            actions.push(Command::Hob(self.input.ranged("hob_w", power, 0.0, self.library.hob.coil.largest_w)?));
        }
        if let Some(food) = &step.put {
            actions.push(Command::Put { food: self.known(food, "put", foods)?, at: self.place(step)? });
        }
        if let Some(food) = &step.flip {
            actions.push(Command::Flip { food: self.known(food, "flip", foods)? });
        }
        if let Some(food) = &step.rest {
            let on = step.on.as_ref().map_or(RestOn::default(), |on| *on.get_ref());
            actions.push(Command::Rest { food: self.known(food, "rest", foods)?, on });
        }
        if let Some(to) = &step.move_pan {
            actions.push(self.move_pan(to.get_ref())?);
        }
        if step.cool.is_some() {
            let default = self.library.room.cloth.default_s;
            let for_s = step.for_s.as_ref().map_or(Ok(default), |s| self.input.ranged("for_s", s, 0.1, 600.0))?;
            actions.push(Command::Cool { for_s });
        }
        if let Some(end) = step.end.as_ref().filter(|end| !*end.get_ref()) {
            let remedy = "write end = true, or leave the step out";
            return self.input.error(end.span().start, "end = false does nothing", remedy);
        }
        self.check_companions(step)?;
        match (actions.len(), step.end.is_some()) {
            (0, true) => Ok(Action::End),
            (1, false) => Ok(Action::Do(actions.remove(0))),
            (0, false) => {
                self.input.error(at, "the step has no action", "add one of hob_w, put, flip, rest, move_pan, cool, end")
            }
            _ => self.input.error(at, "the step has more than one action", "write one [[step]] for each action"),
        }
    }

    fn place(&self, step: &StepEntry) -> Checked<[f64; 2]> {
        let Some(at) = &step.at_mm else { return Ok([0.0, 0.0]) };
        match <[f64; 2]>::try_from(at.get_ref().clone()) {
            Ok(p) if p.iter().all(|v| v.abs() <= 200.0) => Ok(p.map(|v| v * 1e-3)),
            _ => self.input.error(
                at.span().start,
                "at_mm needs two numbers within the pan",
                "write at_mm = [x, y], for instance [20, 0]; the pan's centre is [0, 0]",
            ),
        }
    }

    /// `at_mm`, `on` and `for_s` belong to `put`, `rest` and `cool`.
    fn check_companions(&self, step: &StepEntry) -> Checked<()> {
        let lonely = |key: &str, owner: &str, at: usize| {
            self.input.error(
                at,
                format!("{key} has no {owner} beside it"),
                format!("{key} belongs to a step with {owner}"),
            )
        };
        match (&step.at_mm, &step.on, &step.for_s) {
            (Some(k), _, _) if step.put.is_none() => lonely("at_mm", "put", k.span().start),
            (_, Some(k), _) if step.rest.is_none() => lonely("on", "rest", k.span().start),
            (_, _, Some(k)) if step.cool.is_none() => lonely("for_s", "cool", k.span().start),
            _ => Ok(()),
        }
    }

    /// What can be known before the cook: foods are where a step needs them, times go forward, there is an end.
    fn check_order(&self, raw: &RecipeFile, steps: &[Step], foods: &[PieceOrder]) -> Checked<()> {
        let mut whereabouts: BTreeMap<&str, Whereabouts> =
            foods.iter().map(|f| (f.id.as_str(), Whereabouts::Waiting)).collect();
        let mut earliest = 0.0;
        for (index, (step, entry)) in steps.iter().zip(&raw.step).enumerate() {
            let at = entry.span().start;
            earliest = self.check_time(at, step, earliest)?;
            self.check_place(at, &step.action, &mut whereabouts)?;
            if step.action == Action::End && index + 1 < steps.len() {
                return self.input.error(
                    raw.step[index + 1].span().start,
                    "there is a step after the end",
                    "move end = true to the last step",
                );
            }
        }
        if steps.last().is_none_or(|s| s.action != Action::End) {
            return self.input.error(
                self.input.text.trim_end().len(),
                "the recipe has no end",
                "close it with a [[step]] that says end = true",
            );
        }
        Ok(())
    }

    fn check_time(&self, at: usize, step: &Step, earliest: f64) -> Checked<f64> {
        let start = match step.trigger {
            Trigger::At(s) if s < earliest - 1e-9 => {
                let message =
                    format!("at_s = {s} is already past: the steps before it end at {earliest} s at the earliest");
                return self.input.error(at, message, "use a later at_s, or after_s");
            }
            Trigger::At(s) => s,
            Trigger::After(s) => earliest + s,
            _ => earliest,
        };
        Ok(start + step.action.duration_s())
    }

    fn check_place<'b>(
        &self,
        at: usize,
        action: &'b Action,
        whereabouts: &mut BTreeMap<&'b str, Whereabouts>,
    ) -> Checked<()> {
        let (food, needs, then, remedy) = match action {
            Action::Do(Command::Put { food, .. }) => {
                (food, None, Whereabouts::Pan, "a food in the pan cannot be put in again: rest it first")
            }
            Action::Do(Command::Flip { food }) => {
                (food, Some(Whereabouts::Pan), Whereabouts::Pan, "put it into the pan before this step")
            }
            Action::Do(Command::Rest { food, .. }) => {
                (food, Some(Whereabouts::Pan), Whereabouts::Out, "put it into the pan before this step")
            }
            _ => return Ok(()),
        };
        let now = whereabouts.get(food.as_str()).copied().unwrap_or(Whereabouts::Waiting);
        let wrong = needs.map_or(now == Whereabouts::Pan, |n| n != now);
        if wrong {
            let place = if now == Whereabouts::Pan { "is in the pan already" } else { "is not in the pan" };
            return self.input.error(at, format!("\"{food}\" {place} at this step"), remedy);
        }
        whereabouts.insert(food, then);
        Ok(())
    }
}

/// A title that says which rules were followed, unless it was all of them.
fn labelled(title: String, rules: Rules) -> String {
    match rules {
        Rules::Full => title,
        Rules::Paper2013 => format!("{title} [rules of 2013]"),
    }
}
