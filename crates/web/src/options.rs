//! What a page's script requests.

use saute_window::browser::host::{Host, Opening};
use saute_words::language::Language;
use wasm_bindgen::{JsCast, JsValue};

use crate::backend::Choice;

/// Options of a start, read from a JavaScript object.
pub(crate) struct Options {
    /// Which graphics.
    pub backend: Choice,
    /// Language of the interface; the remembered one, else the browser's, unless given.
    pub language: Option<Language>,
    /// Name of a shipped recipe to play at once, or none.
    pub recipe: Option<String>,
    /// Id of a shipped study, and the code of its participant.
    pub study: Option<(String, String)>,
    /// True if somebody has tried whether this machine sustains the speed of the study.
    pub machine_is_tried: bool,
    /// Id of a shipped scenario, the code of its student, and true if it cannot be left.
    pub lesson: Option<(String, String, bool)>,
    /// The page's script.
    pub host: Option<Host>,
    /// What is kept of the last cook.
    pub kept: Option<Vec<u8>>,
    /// Fragment of the address.
    pub link: String,
    /// True if the page is a part of another one.
    pub is_embedded: bool,
    /// What was chosen before the start.
    pub opening: Opening,
    /// The version of the page's build.
    pub version: String,
}

impl Options {
    /// Reads `{ backend, lang, recipe, study, participant, machine, scenario, student, lock, link, embed, host, kept, chosen, food, cut, version }`; absent and empty values leave the choice to the program.
    ///
    /// # Errors
    ///
    /// States which value is unknown.
    pub fn read(object: &JsValue) -> Result<Self, String> {
        let [backend, lang, recipe, link] = ["backend", "lang", "recipe", "link"].map(|key| text(object, key));
        let language = match lang.as_str() {
            "" => None,
            code => Some(Language::try_from(code.to_owned()).map_err(|unknown| format!("lang: {unknown}"))?),
        };
        let recipe = Some(recipe).filter(|name| !name.is_empty());
        let named = |key, with| Some((text(object, key), text(object, with))).filter(|(name, _)| !name.is_empty());
        let is_locked = value(object, "lock").is_some_and(|lock| lock.is_truthy());
        let study = named("study", "participant");
        let machine_is_tried = match text(object, "machine").as_str() {
            "" => false,
            "tried" => true,
            other => return Err(format!("machine: \"{other}\" is not known; write machine=tried, or leave it out")),
        };
        let lesson = named("scenario", "student").map(|(scenario, student)| (scenario, student, is_locked));
        let host = value(object, "host").map(JsCast::unchecked_into);
        let is_true = |key| value(object, key).is_some_and(|value| value.is_truthy());
        let is_embedded = is_true("embed");
        let food = Some(text(object, "food")).filter(|food| !food.is_empty());
        let opening = Opening { is_chosen: is_true("chosen"), food, is_cut: is_true("cut") };
        let version = text(object, "version");
        let kept =
            value(object, "kept").and_then(|kept| kept.dyn_into::<js_sys::Uint8Array>().ok()).map(|kept| kept.to_vec());
        let backend = Choice::read(&backend)?;
        Ok(Self {
            backend,
            language,
            recipe,
            study,
            machine_is_tried,
            lesson,
            host,
            kept,
            link,
            is_embedded,
            opening,
            version,
        })
    }
}

/// A value of the object, if there is one.
fn value(object: &JsValue, key: &str) -> Option<JsValue> {
    js_sys::Reflect::get(object, &key.into()).ok().filter(|value| !value.is_undefined() && !value.is_null())
}

/// A text of the object; empty where there is none.
fn text(object: &JsValue, key: &str) -> String {
    value(object, key).and_then(|value| value.as_string()).unwrap_or_default()
}
