//! What a page's script asks for.

use saute_window::Language;
use wasm_bindgen::JsValue;

use crate::backend::Choice;

/// Options of a start, read from a JavaScript object.
pub(crate) struct Options {
    /// Which graphics.
    pub backend: Choice,
    /// Language of the interface; the remembered one, else the browser's, unless given.
    pub language: Option<Language>,
    /// Name of a shipped recipe to play at once, or none.
    pub recipe: Option<String>,
}

impl Options {
    /// Reads `{ backend, lang, recipe }`; absent and empty values leave the choice to the program.
    ///
    /// # Errors
    ///
    /// Says which value is unknown.
    pub fn read(object: &JsValue) -> Result<Self, String> {
        let [backend, lang, recipe] = ["backend", "lang", "recipe"].map(|key| text(object, key));
        let language = match lang.as_str() {
            "" => None,
            "en" => Some(Language::English),
            "ja" => Some(Language::Japanese),
            other => return Err(format!("lang: \"{other}\" is neither \"en\" nor \"ja\"")),
        };
        Ok(Self { backend: Choice::read(&backend)?, language, recipe: Some(recipe).filter(|name| !name.is_empty()) })
    }
}

/// A text of the object; empty where there is none.
fn text(object: &JsValue, key: &str) -> String {
    js_sys::Reflect::get(object, &key.into()).ok().and_then(|value| value.as_string()).unwrap_or_default()
}
