//! What a session began with.

use std::borrow::Cow;
use std::fmt::Write;

use saute_kitchen::{Library, MeshSize, OutlineKind, PieceOrder};
use saute_schema::{InputError, LibraryError};
use serde::{Deserialize, Serialize};

use crate::recipe::Recipe;

/// What a session began with: a recipe, and the program and data that it met.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Beginning {
    /// Version of the program.
    pub program: String,
    /// Hash of the data files that pan and foods are built from.
    pub data_hash: u64,
    /// Name of the recipe's file, for messages.
    pub file: String,
    /// Text of the recipe.
    pub text: String,
    /// True if its steps are carried out; false if it only sets out pan and foods.
    pub plays: bool,
    /// The text of the file that states the kitchen at home, unless it was the program's own. In a file it has its own record.
    #[serde(skip)]
    pub home: Option<String>,
}

impl Beginning {
    /// Returns the beginning with a recipe.
    pub fn of(recipe: &Recipe, plays: bool, library: &Library) -> Self {
        Self {
            program: env!("CARGO_PKG_VERSION").to_owned(),
            data_hash: data_hash(recipe, library),
            file: recipe.file.clone(),
            text: recipe.text.clone(),
            plays,
            home: library.home().map(str::to_owned),
        }
    }

    /// Returns the library of the kitchen at home in which the session was recorded: it is played there, wherever it is opened.
    ///
    /// # Errors
    ///
    /// If what the session carries states no kitchen.
    pub fn library<'a>(&self, library: &'a Library) -> Result<Cow<'a, Library>, LibraryError> {
        library.in_kitchen(self.home.as_deref())
    }

    /// Returns the recipe.
    ///
    /// # Errors
    ///
    /// If the library lacks a food or the pan, or if the text is no recipe.
    pub fn recipe(&self, library: &Library) -> Result<Recipe, InputError> {
        Recipe::parse(&self.text, &self.file, library)
    }

    /// Returns why a replay may depart, in words: another program, or other data. None if it cannot.
    pub fn difference(&self, recipe: &Recipe, library: &Library) -> Option<String> {
        let this = env!("CARGO_PKG_VERSION");
        if self.program != this {
            return Some(format!("the session was recorded by saute {}, this is saute {this}", self.program));
        }
        let is_same = self.library(library).is_ok_and(|library| self.data_hash == data_hash(recipe, &library));
        (!is_same).then(|| "the data of its pan or foods is not what it was when the session was recorded".to_owned())
    }
}

/// Hash of the data files that pan and foods of a recipe are built from.
fn data_hash(recipe: &Recipe, library: &Library) -> u64 {
    let kinds: std::collections::BTreeSet<&String> = recipe.foods.iter().map(|food| &food.kind).collect();
    let foods = kinds.into_iter().filter_map(|kind| Some(library.food_hash(kind, library.foods.get(kind)?)));
    // A multiplicative mix: the order of the kinds counts.
    let pan = recipe.library(library).map_or(0, |library| library.pan_hash(&recipe.pan_kind));
    foods.fold(pan, |mix, hash| mix.rotate_left(17).wrapping_mul(MIX) ^ hash)
}

/// Odd multiplier of the mix [-] (the golden ratio's fraction in 64 bits).
const MIX: u64 = 0x9e37_79b9_7f4a_7c15;

/// Food that is set out without a recipe.
#[derive(Clone, Debug, PartialEq)]
pub struct SetOutFood {
    /// Name: of one piece, or of a group whose pieces are called `name.1` and so on.
    pub id: String,
    /// Id of the food.
    pub kind: String,
    /// Its dimensions: those of its form [mm].
    pub size_mm: Vec<f64>,
    /// Start temperature [°C].
    pub initial_c: f64,
    /// Seed of its natural variation; the pieces of a group have seeds that follow each other.
    pub seed: u64,
    /// Number of pieces of a group; `None` for one piece with the plain name.
    pub count: Option<usize>,
    /// How it is meshed and outlined.
    pub detail: FoodDetail,
}

/// How a food is meshed and outlined; by default as recipes do that state nothing of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoodDetail {
    /// Spacing of the mesh relative to the default [-].
    pub coarseness: f64,
    /// Resolution of the mesh.
    pub mesh: MeshSize,
    /// Outline of the pieces.
    pub outline: OutlineKind,
}

impl Default for FoodDetail {
    fn default() -> Self {
        Self { coarseness: 1.0, mesh: MeshSize::Default, outline: OutlineKind::Natural }
    }
}

impl FoodDetail {
    /// That of a piece.
    pub fn of(order: &PieceOrder) -> Self {
        Self { coarseness: order.coarseness, mesh: order.mesh, outline: order.outline }
    }
}

/// Latest end of a recipe [s].
const LATEST_END_S: u32 = 86_400;

/// Returns the text of a recipe that sets out a hob, that of the kitchen at home for none, a pan, at a temperature [°C], and foods, and does nothing with them.
pub fn set_out(title: &str, hob: Option<&str>, pan: &str, pan_initial_c: f64, foods: &[SetOutFood]) -> String {
    let mut text = head(title, LATEST_END_S.into(), hob, pan, pan_initial_c);
    foods.iter().for_each(|food| write_food(&mut text, food));
    let _ = write!(text, "[[step]]\nat_s = {LATEST_END_S}\nend = true\n");
    text
}

/// Text of a recipe up to its foods.
pub(super) fn head(title: &str, max_s: f64, hob: Option<&str>, pan: &str, pan_initial_c: f64) -> String {
    let quoted = |text: &str| toml::Value::String(text.to_owned());
    let (title, pan) = (quoted(title), quoted(pan));
    let hob = hob.map_or_else(String::new, |kind| format!("[hob]\nkind = {}\n", quoted(kind)));
    format!("title = {title}\nmax_s = {max_s}\n{hob}[pan]\nkind = {pan}\ninitial_c = {pan_initial_c}\n")
}

/// Writes a food as a recipe states it.
pub(super) fn write_food(text: &mut String, food: &SetOutFood) {
    let SetOutFood { id, kind, size_mm, initial_c, seed, count, detail } = food;
    let (id, kind) = (toml::Value::String(id.clone()), toml::Value::String(kind.clone()));
    let _ = write!(
        text,
        "[[food]]\nid = {id}\nkind = {kind}\nsize_mm = {size_mm:?}\ninitial_c = {initial_c}\nseed = {seed}\n"
    );
    if let Some(count) = count {
        let _ = writeln!(text, "count = {count}");
    }
    if detail.coarseness != 1.0 {
        let _ = writeln!(text, "coarseness = {}", detail.coarseness);
    }
    if detail.mesh == MeshSize::Paper2013 {
        text.push_str("mesh = \"2013\"\n");
    }
    text.push_str(match detail.outline {
        OutlineKind::Natural => "",
        OutlineKind::Plain => "outline = \"plain\"\n",
        OutlineKind::Individual => "outline = \"individual\"\n",
    });
}
