//! The chosen rendering quality: a level, or automatic.

use saute_scene::quality::Quality;

/// A level, or automatic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum QualityChoice {
    /// Quick on a software rasteriser, else the best that sustains 50 frames a second.
    #[default]
    Automatic,
    /// Always this one.
    #[serde(untagged)]
    Always(Quality),
}

impl QualityChoice {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::Automatic, Self::Always(Quality::Quick), Self::Always(Quality::Smooth), Self::Always(Quality::Best)];
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_choice_is_remembered_by_its_name() {
        for (choice, name) in QualityChoice::ALL.into_iter().zip(["automatic", "quick", "smooth", "best"]) {
            let text = serde_json::to_string(&choice).expect("is written");
            assert_eq!(text, format!("\"{name}\""));
            assert_eq!(serde_json::from_str::<QualityChoice>(&text).expect("is read"), choice);
        }
    }
}
