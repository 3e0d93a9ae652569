//! Checks a recipe file and converts it to SI units.

use std::borrow::Cow;

use saute_food::{FoodDescription, MeshSize, Rules};
use toml::Spanned;

use crate::action::ActionKind;
use crate::check::sequence_check::Sequence;
use crate::file::recipe_file::{FoodEntry, MeshName, PanEntry, Preset, RecipeFile};
use crate::file::step_file::{StepEntry, StepKeys};
use crate::recipe::{ALL, Group, Recipe, Step, Target, Trigger};
use saute_kitchen::data::library::Library;
use saute_kitchen::hands::ranges::{MAX_S, PAN_INITIAL_C};
use saute_kitchen::kelvin;
use saute_kitchen::kitchen::PieceOrder;
use saute_kitchen::piece::memory::Load;
use saute_schema::library_error::line_of;
use saute_schema::{InputError, InputText};

impl Recipe {
    /// Parses and checks a recipe. `file` is its name in messages.
    ///
    /// # Errors
    ///
    /// Returns file, line, key and remedy of the first mistake.
    ///
    /// ```
    /// use saute_kitchen::Library;
    /// use saute_recipe::Recipe;
    ///
    /// let text = "[[step]]\nhob_w = 9000\n[[step]]\nend = true";
    /// let error = Recipe::parse(text, "hot.toml", &Library::embedded()?).expect_err("the hob has 3500 W");
    /// assert_eq!((error.file.as_str(), error.line), ("hot.toml", 2));
    /// assert_eq!(error.message, "step.hob_w = 9000 is out of range");
    /// assert!(error.remedy.contains("0 to 3500"), "{}", error.remedy);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        Check { input: InputText { text, file }, library, names_hob: false }.recipe()
    }
}

/// A recipe's text and the library with the foods and pans that it can name.
pub(crate) struct Check<'a> {
    pub(crate) input: InputText<'a>,
    pub(crate) library: &'a Library,
    /// True if the recipe names the library's hob.
    pub(crate) names_hob: bool,
}

/// The foods and groups that steps can name.
pub(crate) struct FoodNames {
    foods: Vec<PieceOrder>,
    groups: Vec<Group>,
}

pub(crate) type Checked<T> = Result<T, InputError>;

impl Check<'_> {
    pub(crate) fn recipe(&self) -> Checked<Recipe> {
        if self.input.text.trim().is_empty() {
            return self.input.error(0, "the file is empty", "start from a shipped recipe: saute list recipes");
        }
        let raw: RecipeFile = self.input.parse("the keys and their types are listed by: saute schema recipe")?;
        let Some(hob) = &raw.hob else { return self.with_hob(&raw) };
        let library = self.on_hob(&hob.kind)?;
        Check { input: self.input, library: &library, names_hob: true }.with_hob(&raw)
    }

    /// Returns the library with a hob.
    fn on_hob(&self, kind: &Spanned<String>) -> Checked<Cow<'_, Library>> {
        self.library.on_hob(kind.get_ref()).or_else(|_| {
            let why = self.library.absence("hobs", kind.get_ref(), "is not a hob");
            let remedy = format!("use one of: {}", Library::names(&self.library.hobs));
            self.input.error(kind.span().start, format!("hob.kind = \"{}\" {why}", kind.get_ref()), remedy)
        })
    }

    fn with_hob(&self, raw: &RecipeFile) -> Checked<Recipe> {
        let max_s = raw.max_s.as_ref().map_or(MAX_S.default, |s| *s.get_ref());
        let (pan_kind, pan_temperature) = self.pan(raw.pan.as_ref().map(Spanned::get_ref))?;
        let rules = if raw.preset == Some(Preset::Paper2013) { Rules::Paper2013 } else { Rules::Full };
        let names = self.food_names(&raw.food, rules)?;
        let steps = raw.step.iter().map(|s| self.step(s, &names)).collect::<Checked<Vec<_>>>()?;
        let places: Vec<usize> = raw.step.iter().map(|s| s.span().start).collect();
        self.check_floor(&pan_kind, &names.foods, &steps, &places)?;
        Sequence::new(self.input, names.foods.iter().map(|f| f.id.as_str())).check(&steps, &places)?;
        Ok(Recipe {
            title: labelled(raw.title.clone().unwrap_or_else(|| self.input.file.to_owned()), rules),
            hob_kind: raw.hob.as_ref().map(|hob| hob.kind.get_ref().clone()),
            minutes: raw.minutes.as_ref().map(|minutes| *minutes.get_ref()),
            max_s,
            oil: self.oil_at_start(raw.pan.as_ref().map(Spanned::get_ref), &steps)?,
            pan_kind,
            pan_temperature,
            foods: names.foods,
            groups: names.groups,
            steps,
            file: self.input.file.to_owned(),
            text: self.input.text.to_owned(),
        })
    }

    fn pan(&self, entry: Option<&PanEntry>) -> Checked<(String, f64)> {
        let default = PanEntry::default();
        let entry = entry.unwrap_or(&default);
        let initial = entry.initial_c.as_ref().map_or(PAN_INITIAL_C.default, |c| *c.get_ref());
        let Some(kind) = &entry.kind else { return Ok(("carbon-steel-26".into(), kelvin(initial))) };
        if !self.library.pans.contains_key(kind.get_ref()) {
            let remedy = format!("use one of: {}", Library::names(&self.library.pans));
            let why = self.library.absence("pans", kind.get_ref(), "is not a pan");
            return self.input.error(kind.span().start, format!("pan.kind = \"{}\" {why}", kind.get_ref()), remedy);
        }
        Ok((kind.get_ref().clone(), kelvin(initial)))
    }

    /// Oil at the start [kg]: what the pan's table states; nothing if a step pours some before the first food goes in; none if the
    /// recipe states none.
    fn oil_at_start(&self, pan: Option<&PanEntry>, steps: &[Step]) -> Checked<Option<f64>> {
        if let Some(oil_g) = pan.and_then(|pan| pan.oil_g.as_ref()) {
            return Ok(Some(1e-3 * oil_g.get_ref()));
        }
        let is_put = |step: &&Step| step.action.kind() != ActionKind::Put;
        let is_fat = |step: &Step| matches!(step.action.kind(), ActionKind::Oil | ActionKind::Butter);
        Ok(steps.iter().take_while(is_put).any(is_fat).then_some(0.0))
    }

    fn food_names(&self, entries: &[Spanned<FoodEntry>], rules: Rules) -> Checked<FoodNames> {
        let mut names = FoodNames { foods: Vec::new(), groups: Vec::new() };
        let mut load = Load::default();
        for entry in entries {
            let entry = entry.get_ref();
            let one = self.food(entry, rules)?;
            let count = entry.count.as_ref().map(|count| u64::from(*count.get_ref()));
            self.check_memory(&mut load, entry, &one, count)?;
            let Some(count) = count else {
                names.foods.push(one);
                continue;
            };
            let first = names.foods.len();
            names.foods.extend((0..count).map(|i| PieceOrder {
                id: format!("{}.{}", one.id, i + 1),
                seed: one.seed + i,
                ..one.clone()
            }));
            names.groups.push(Group { id: one.id, kind: one.kind, members: first..names.foods.len() });
        }
        self.check_ids(entries)?;
        Ok(names)
    }

    fn food(&self, entry: &FoodEntry, rules: Rules) -> Checked<PieceOrder> {
        let Some(description) = self.library.foods.get(entry.kind.get_ref()) else {
            let remedy = format!("use one of: {}", Library::names(&self.library.foods));
            let why = self.library.absence("foods", entry.kind.get_ref(), "is not a food");
            let message = format!("food kind = \"{}\" {why}", entry.kind.get_ref());
            return self.input.error(entry.kind.span().start, message, remedy);
        };
        self.check_id(&entry.id)?;
        let size_mm = self.size(entry, description)?;
        let initial = self.initial_c(entry, description, rules)?;
        let coarseness = entry.coarseness.as_ref().map_or(1.0, |c| *c.get_ref());
        Ok(PieceOrder {
            id: entry.id.get_ref().clone(),
            kind: entry.kind.get_ref().clone(),
            size: size_mm.map(|v| v * 1e-3),
            temperature: kelvin(initial),
            seed: u64::from(entry.seed.unwrap_or(1)),
            coarseness,
            rules,
            mesh: match entry.mesh.unwrap_or_default() {
                MeshName::Default => MeshSize::Default,
                MeshName::Paper2013 => MeshSize::Paper2013,
            },
            outline: entry.outline.unwrap_or_default(),
        })
    }

    /// Temperature of a food [°C]; below 0 only where it may be ice.
    fn initial_c(&self, entry: &FoodEntry, food: &FoodDescription, rules: Rules) -> Checked<f64> {
        let Some(given) = &entry.initial_c else { return Ok(5.0) };
        let celsius = *given.get_ref();
        if celsius >= 0.0 || food.may_be_ice(rules) {
            return Ok(celsius);
        }
        let (message, remedy) = match rules {
            Rules::Full => (
                format!("food.initial_c = {celsius}: the file of {} has no table [freezing]", entry.kind.get_ref()),
                "write 0 or more, or add [freezing] with begins_c and bound_share to the food",
            ),
            Rules::Paper2013 => (
                format!("food.initial_c = {celsius}: the rules of 2013 know no ice"),
                "write 0 or more, or leave preset out",
            ),
        };
        self.input.error(given.span().start, message, remedy)
    }

    fn check_id(&self, id: &Spanned<String>) -> Checked<()> {
        let (name, at) = (id.get_ref(), id.span().start);
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if name == ALL {
            let message = "food id = \"all\" stands for all foods of a recipe";
            return self.input.error(at, message, "choose another id, as in id = \"steak\"");
        }
        if name.is_empty() || !name.chars().all(plain) {
            let message = format!("food id = \"{name}\" cannot be used");
            return self.input.error(at, message, "use letters, digits, - and _, as in id = \"steak\"");
        }
        Ok(())
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

    fn step(&self, entry: &Spanned<StepEntry>, names: &FoodNames) -> Checked<Step> {
        let at = entry.span().start;
        let step = entry.get_ref();
        Ok(Step {
            trigger: self.trigger(at, &step.keys, names)?,
            action: self.action(at, step, names)?,
            line: line_of(self.input.text, at),
        })
    }

    fn trigger(&self, at: usize, step: &StepKeys, names: &FoodNames) -> Checked<Trigger> {
        match (&step.at_s, &step.after_s, &step.when) {
            (None, None, None) => Ok(Trigger::After(0.0)),
            (Some(s), None, None) => Ok(Trigger::At(*s.get_ref())),
            (None, Some(s), None) => Ok(Trigger::After(*s.get_ref())),
            (None, None, Some(when)) => Ok(Trigger::When(self.condition("when", when, names)?)),
            _ => self.input.error(at, "the step has more than one trigger", "keep one of at_s, after_s, when"),
        }
    }

    /// Returns the foods with a name: a piece, a group, or all. `key` is named in the error.
    pub(crate) fn target(&self, id: &Spanned<String>, key: &str, names: &FoodNames) -> Checked<Target> {
        let name = id.get_ref();
        let ids = |foods: &[PieceOrder]| foods.iter().map(|f| f.id.clone()).collect();
        let target = |foods: Vec<String>, group: bool| Ok(Target { name: name.clone(), foods, group });
        if let Some(group) = names.groups.iter().find(|g| g.id == *name) {
            return target(ids(&names.foods[group.members.clone()]), true);
        }
        if names.foods.iter().any(|f| f.id == *name) {
            return target(vec![name.clone()], false);
        }
        if name == ALL && !names.foods.is_empty() {
            return target(ids(&names.foods), true);
        }
        self.input.error(id.span().start, format!("{key} = \"{name}\" names no food of this recipe"), names.remedy())
    }
}

impl FoodNames {
    /// Returns a remedy that lists the names.
    fn remedy(&self) -> String {
        if self.foods.is_empty() {
            return "add a [[food]] with that id".to_owned();
        }
        let single = |i: &usize| !self.groups.iter().any(|g| g.members.contains(i));
        let singles = (0..self.foods.len()).filter(single).map(|i| self.foods[i].id.clone());
        let groups = self.groups.iter().map(|g| match g.members.len() {
            1 => format!("{0} ({0}.1)", g.id),
            n => format!("{0} ({0}.1 to {0}.{n})", g.id),
        });
        let names: Vec<String> = singles.chain(groups).collect();
        format!("use one of the recipe's foods: {}; or all", names.join(", "))
    }
}

/// Returns the title, marked if the recipe follows the rules of 2013.
fn labelled(title: String, rules: Rules) -> String {
    const LABEL: &str = " [rules of 2013]";
    match rules {
        Rules::Full => title,
        // The recipe of a session has its label already.
        Rules::Paper2013 if title.ends_with(LABEL) => title,
        Rules::Paper2013 => title + LABEL,
    }
}
