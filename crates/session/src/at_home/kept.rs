//! The kitchen that was found: it is remembered, and cooked in until the person goes back to the typical one.

use std::borrow::Cow;
use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::fit::run::Fitted;
use serde::{Deserialize, Serialize};

/// A kitchen that was found.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct KeptKitchen {
    /// The text of the file that states it, as `saute --data` reads it.
    pub text: String,
    /// Efficiency of the hob, with the ends of its 90 % interval [-].
    pub hob_efficiency: [f64; 3],
    /// Factor on the contact conductance, with the ends of its 90 % interval [-].
    pub contact: [f64; 3],
    /// True if it is cooked in.
    pub is_used: bool,
}

impl KeptKitchen {
    /// Returns the kitchen of a fit with the data of a library.
    pub fn of(fitted: &Fitted, library: &Library, log: &str) -> Self {
        let found = &fitted.found;
        // A fit that ended has cooked on its hob.
        let there = fitted.hob.as_ref().and_then(|hob| library.on_hob(hob).ok());
        let library = there.as_deref().unwrap_or(library);
        let three = |e: &saute_plan::fit::found::Estimate| [e.value, e.low, e.high];
        Self {
            text: found.at_home(library, log).to_file(),
            hob_efficiency: three(&found.hob_efficiency),
            contact: three(&found.contact),
            is_used: true,
        }
    }

    /// Returns the library of a kitchen that is kept and used; the same one where there is none. Who starts the program with a kitchen
    /// of a `--data` folder means that one.
    pub fn library(kept: Option<&Self>, library: Arc<Library>) -> Arc<Library> {
        let text = kept.filter(|kept| kept.is_used && library.home().is_none()).map(|kept| kept.text.as_str());
        let there = text.and_then(|text| library.in_kitchen(Some(text)).ok().map(Cow::into_owned));
        there.map_or(library, Arc::new)
    }
}
