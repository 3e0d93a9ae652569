//! The chosen food and pan, and the orders that follow from it.

use saute_kitchen::food::{FoodDescription, Form, Rules};
use saute_kitchen::pan::hob::HobDescription;
use saute_kitchen::{Library, MeshSize, OutlineKind, PieceOrder, kelvin};
use saute_recipe::Recipe;
use saute_recipe::session::{FoodDetail, SetOutFood, set_out};
use saute_schema::InputError;
use saute_words::language::Language;

/// What the person chooses before putting the food in.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(default)]
pub struct FoodChoice {
    /// Id of the food.
    pub kind: String,
    /// Its dimensions: those of its form [mm].
    pub size_mm: Vec<f64>,
    /// Start temperature [°C].
    pub initial_c: f64,
    /// Id of the hob; none for that of the kitchen at home.
    #[serde(default)]
    pub hob: Option<String>,
    /// Id of the pan.
    pub pan: String,
    /// Temperature to which the pan is preheated [°C]; room temperature starts cold.
    pub preheat_c: f64,
}

impl FoodChoice {
    /// The chosen hob; that of the kitchen at home where none is chosen, or it is not there any more.
    pub fn hob<'a>(&self, library: &'a Library) -> &'a HobDescription {
        self.hob.as_ref().and_then(|id| library.hobs.get(id)).unwrap_or(&library.hob)
    }
}

impl Default for FoodChoice {
    fn default() -> Self {
        Self {
            kind: FIRST_FOOD.into(),
            size_mm: vec![120.0, 80.0, 25.0],
            initial_c: 5.0,
            hob: None,
            pan: "carbon-steel-26".into(),
            preheat_c: 20.0,
        }
    }
}

/// The food that is chosen until a person chooses another.
pub(super) const FIRST_FOOD: &str = "beef-lean";

/// Noun for a kind of food in a sentence.
pub fn noun(library: &Library, kind: &str, l: Language) -> String {
    library.foods.get(kind).map_or_else(|| kind.to_lowercase(), |food| food.noun_in(l.code()))
}

/// Name of a food that is set out, as its file states it.
pub(super) fn base_name(library: &Library, kind: &str) -> String {
    library.foods.get(kind).map_or_else(|| kind.to_owned(), |food| food.piece_id(kind))
}

/// The recipe that sets out a choice and does nothing with it.
pub(super) fn as_recipe(library: &Library, choice: &FoodChoice, count: usize) -> Result<Recipe, InputError> {
    let food = SetOutFood {
        id: base_name(library, &choice.kind),
        kind: choice.kind.clone(),
        size_mm: size_of(library, choice),
        initial_c: choice.initial_c,
        seed: 1,
        count: (count > 1).then_some(count),
        detail: FoodDetail::default(),
    };
    let title = noun(library, &choice.kind, Language::ENGLISH);
    let text = set_out(&title, choice.hob.as_deref(), &choice.pan, choice.preheat_c, &[food]);
    Recipe::parse(&text, SET_OUT, library)
}

/// Name of the recipe of a choice, where it is refused.
const SET_OUT: &str = "set-out.toml";

/// The chosen dimensions, or the food's own where they do not belong to its form [mm].
fn size_of(library: &Library, choice: &FoodChoice) -> Vec<f64> {
    let fits = |f: &FoodDescription| f.form.extent(&choice.size_mm).is_some();
    match library.foods.get(&choice.kind) {
        Some(food) if !fits(food) => food.size.default_mm.clone(),
        _ => choice.size_mm.clone(),
    }
}

/// Orders of pieces under one name; each has its own seed, so that no two are the same.
pub(super) fn orders(library: &Library, choice: &FoodChoice, group: &str, count: usize) -> Vec<PieceOrder> {
    let food = library.foods.get(&choice.kind);
    let form = food.map_or(Form::Steak, |f| f.form);
    let default = || food.and_then(|f| form.extent(&f.size.default_mm)).unwrap_or_default();
    let size = form.extent(&choice.size_mm).unwrap_or_else(default);
    let order = |k: usize| PieceOrder {
        id: if count == 1 { group.to_owned() } else { format!("{group}.{}", k + 1) },
        kind: choice.kind.clone(),
        size: size.map(|mm| mm * 1e-3),
        temperature: kelvin(choice.initial_c),
        seed: k as u64 + 1,
        coarseness: 1.0,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    };
    (0..count).map(order).collect()
}
