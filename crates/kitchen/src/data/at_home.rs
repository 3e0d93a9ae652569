//! What a kitchen at home has otherwise than the hob's and the room's data: another hob, and two factors that a fit finds.

use std::borrow::Cow;
use std::sync::Arc;

use saute_food::description::Confidence;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::bytes::hash_of;
use crate::data::library::Library;
use crate::data::room::Room;
use crate::data::shelf::{Shelved, shipped_files};
use crate::pan::hob::HobDescription;
use saute_schema::{DataFile, LibraryError};

/// The file of what a kitchen at home has otherwise.
pub(crate) const AT_HOME_FILE: &str = "kitchen-at-home.toml";

/// The hob on which is cooked unless another is named.
pub const DEFAULT_HOB: &str = "induction";

/// Least and largest factor on the hob's efficiency [-].
pub const HOB_FACTOR: [f64; 2] = [0.3, 1.5];

/// Least and largest factor on the contact conductance [-].
pub const CONTACT_FACTOR: [f64; 2] = [0.2, 5.0];

/// `data/kitchen-at-home.toml`: the hob, and factors on the program's kitchen.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute kitchen-at-home")]
pub struct KitchenAtHome {
    /// Id of the hob that is cooked on; see `saute list hobs`.
    #[serde(default = "default_hob")]
    #[schemars(example = &"gas")]
    pub hob: String,
    /// Factor on the hob's efficiency [-]; the efficiency is 1 at most.
    #[schemars(range(min = HOB_FACTOR[0], max = HOB_FACTOR[1]), example = 0.93)]
    pub hob_factor: f64,
    /// Factor on the contact conductance between food and pan [-].
    #[schemars(range(min = CONTACT_FACTOR[0], max = CONTACT_FACTOR[1]), example = 1.1)]
    pub contact_factor: f64,
    /// Source of the numbers.
    #[schemars(example = &"fitted to steak.csv")]
    pub source: String,
    /// Confidence in the numbers.
    #[schemars(example = &"medium")]
    pub confidence: Confidence,
}

fn default_hob() -> String {
    DEFAULT_HOB.to_owned()
}

impl Default for KitchenAtHome {
    fn default() -> Self {
        let source = "the program's kitchen".to_owned();
        Self { hob: default_hob(), hob_factor: 1.0, contact_factor: 1.0, source, confidence: Confidence::High }
    }
}

impl KitchenAtHome {
    /// Returns the text of the file that states it, with factors to four decimals.
    pub fn to_file(&self) -> String {
        let source: String = self.source.chars().filter(|c| !c.is_control() && !['"', '\\'].contains(c)).collect();
        let confidence = match self.confidence {
            Confidence::High => "high",
            Confidence::Medium => "medium",
            Confidence::Low => "low",
        };
        let hob = if self.hob == DEFAULT_HOB { String::new() } else { format!("hob = \"{}\"\n", self.hob) };
        format!(
            "{hob}hob_factor = {:.4}\ncontact_factor = {:.4}\nsource = \"{source}\"\nconfidence = \"{confidence}\"\n",
            self.hob_factor, self.contact_factor
        )
    }

    /// Sets the factors in the data of hob and room.
    ///
    /// The conductance of a gap that is not filled by the layer of steam is proportional to 1/gap and to that of the
    /// asperities; both get the factor. The layer of steam stays, as it follows from the load.
    pub fn set_in(&self, hob: &mut HobDescription, room: &mut Room) {
        hob.scale_efficiency(self.hob_factor);
        room.contact.gap_mm /= self.contact_factor;
        room.contact.settling_gap_mm /= self.contact_factor;
        room.contact.asperity_w_m2k *= self.contact_factor;
    }
}

impl Library {
    /// Returns the text of the file that states the kitchen at home; none of the program's own.
    pub fn home(&self) -> Option<&str> {
        self.home.as_deref()
    }

    /// Sets hob and room as they are in a kitchen at home, else states why its hob cannot be used.
    pub(crate) fn settle(&mut self, at_home: &KitchenAtHome) -> Result<(), String> {
        let id = &at_home.hob;
        let Some(hob) = self.hobs.get(id) else {
            let why = self.absence("hobs", id, "is not a hob");
            return Err(format!("hob = \"{id}\" {why}; there are: {}", Self::names(&self.hobs)));
        };
        let (mut hob, mut room) = (hob.clone(), (*self.typical).clone());
        at_home.set_in(&mut hob, &mut room);
        (self.hob, self.room) = (hob, room);
        Ok(())
    }

    /// Returns the library with another hob, all else as it is at home; a factor on the hob's efficiency was found on the hob
    /// before and is left there.
    ///
    /// # Errors
    ///
    /// If there is no such hob.
    pub fn on_hob(&self, id: &str) -> Result<Cow<'_, Self>, LibraryError> {
        if self.at_home.hob == id {
            return Ok(Cow::Borrowed(self));
        }
        let there = KitchenAtHome { hob: id.to_owned(), hob_factor: 1.0, ..self.at_home.clone() };
        let is_own = there == KitchenAtHome { source: there.source.clone(), ..KitchenAtHome::default() };
        if is_own { self.in_kitchen(None) } else { self.in_kitchen(Some(&there.to_file())) }
    }

    /// Returns the library of another kitchen at home, by the text of the file that states it; of the program's own for none.
    ///
    /// # Errors
    ///
    /// If the text states no kitchen.
    pub fn in_kitchen(&self, home: Option<&str>) -> Result<Cow<'_, Self>, LibraryError> {
        if self.home() == home {
            return Ok(Cow::Borrowed(self));
        }
        let shipped = shipped_files().get(AT_HOME_FILE).map_or("", String::as_str);
        let text = home.unwrap_or(shipped);
        let file = DataFile { name: AT_HOME_FILE, text };
        let at_home = KitchenAtHome::shelf().read(&file)?;
        let mut library = self.clone();
        library.settle(&at_home).map_err(|cause| file.error("hob", cause))?;
        (library.at_home, library.home) = (at_home, home.map(Arc::from));
        library.hashes.insert(AT_HOME_FILE.to_owned(), text_hash(text));
        Ok(Cow::Owned(library))
    }
}

/// Hash of the text of a file, as that of a file without a surface.
pub(crate) fn text_hash(text: &str) -> u64 {
    // Line ends of another system do not change the content of a file.
    let without_surface: &[u8] = &[];
    hash_of([text.replace('\r', "").as_bytes(), without_surface])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fitted() -> KitchenAtHome {
        let source = "fitted to \"steak\".csv".to_owned();
        KitchenAtHome {
            hob_factor: 0.9,
            contact_factor: 1.2,
            source,
            confidence: Confidence::Medium,
            ..Default::default()
        }
    }

    #[test]
    fn a_library_goes_into_another_kitchen_and_back_as_if_it_had_been_loaded_there() {
        let typical = Library::embedded().expect("embedded data");
        let text = fitted().to_file();
        let there = typical.in_kitchen(Some(&text)).expect("a kitchen").into_owned();
        let loaded = Library::with(&[(AT_HOME_FILE.to_owned(), text.clone())]).expect("a library");
        assert_eq!((there.home(), loaded.home()), (Some(text.as_str()), Some(text.as_str())));
        assert_eq!(there.hob.efficiency(), loaded.hob.efficiency());
        assert_eq!(there.room.contact.gap_mm, loaded.room.contact.gap_mm);
        assert_eq!(there.pan_hash("carbon-steel-26"), loaded.pan_hash("carbon-steel-26"));
        assert!(there.hob.efficiency() < typical.hob.efficiency());
        let back = there.in_kitchen(None).expect("a kitchen");
        assert_eq!(back.pan_hash("carbon-steel-26"), typical.pan_hash("carbon-steel-26"));
        assert_eq!(back.hob.efficiency(), typical.hob.efficiency());
        assert!(matches!(back.in_kitchen(None), Ok(Cow::Borrowed(_))));
    }

    #[test]
    fn a_library_goes_to_another_hob_and_back() {
        let typical = Library::embedded().expect("embedded data");
        let gas = typical.on_hob("gas").expect("a gas burner");
        assert!(gas.hob.flame.is_some() && gas.hob.electronics().is_none());
        assert_ne!(gas.pan_hash("carbon-steel-26"), typical.pan_hash("carbon-steel-26"));
        assert_eq!(gas.on_hob(DEFAULT_HOB).expect("the program's own").home(), None);
        let fitted = typical.in_kitchen(Some(&fitted().to_file())).expect("a kitchen");
        let both = fitted.on_hob("gas").expect("a gas burner");
        assert_eq!(both.hob.efficiency(), typical.hobs["gas"].efficiency(), "the factor was the other hob's");
        assert_eq!(both.room.contact.gap_mm, fitted.room.contact.gap_mm, "that of the contact stays");
        let error = typical.on_hob("campfire").expect_err("no such hob").to_string();
        assert!(error.contains("there are: gas, induction, iron-plate, radiant"), "{error}");
    }

    #[test]
    fn a_text_that_states_no_kitchen_is_refused() {
        let typical = Library::embedded().expect("embedded data");
        for text in ["", "hob_factor = 9", &fitted().to_file().replace("0.9000", "99")] {
            assert!(typical.in_kitchen(Some(text)).is_err(), "{text}");
        }
    }
}
