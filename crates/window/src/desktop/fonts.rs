//! Fonts of the system, and those that come with the program.

use std::sync::{Arc, OnceLock};

use egui::{FontData, FontDefinitions};

/// Where systems keep their fonts for Japanese, the plainest sans-serif first; in a collection the number is the face.
const PLACES: [(&str, u32); 21] = [
    // Debian, Ubuntu: fonts-noto-cjk, fonts-ipafont-gothic, fonts-ipaexfont-gothic, fonts-vlgothic, fonts-takao-gothic.
    ("/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 0),
    ("/usr/share/fonts/opentype/noto/NotoSansCJKjp-Regular.otf", 0),
    ("/usr/share/fonts/opentype/ipafont-gothic/ipagp.ttf", 0),
    ("/usr/share/fonts/opentype/ipafont-gothic/ipag.ttf", 0),
    ("/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf", 0),
    ("/usr/share/fonts/truetype/vlgothic/VL-PGothic-Regular.ttf", 0),
    ("/usr/share/fonts/truetype/takao-gothic/TakaoPGothic.ttf", 0),
    // Whatever Debian's alternatives chose.
    ("/usr/share/fonts/truetype/fonts-japanese-gothic.ttf", 0),
    // Fedora, Arch, openSUSE.
    ("/usr/share/fonts/google-noto-sans-cjk-fonts/NotoSansCJK-Regular.ttc", 0),
    ("/usr/share/fonts/google-noto-cjk/NotoSansCJK-Regular.ttc", 0),
    ("/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc", 0),
    ("/usr/share/fonts/truetype/NotoSansCJK-Regular.ttc", 0),
    ("/usr/share/fonts/OTF/ipag.ttf", 0),
    ("/run/current-system/sw/share/X11/fonts/NotoSansCJK-Regular.ttc", 0),
    // macOS.
    ("/System/Library/Fonts/ヒラギノ角ゴシック W3.ttc", 0),
    ("/Library/Fonts/Osaka.ttf", 0),
    // Windows.
    ("C:\\Windows\\Fonts\\YuGothM.ttc", 0),
    ("C:\\Windows\\Fonts\\YuGothR.ttc", 0),
    ("C:\\Windows\\Fonts\\meiryo.ttc", 0),
    ("C:\\Windows\\Fonts\\BIZ-UDGothicR.ttc", 0),
    ("C:\\Windows\\Fonts\\msgothic.ttc", 1),
];
/// A part of Noto Sans CJK JP that `scripts/japanese-font.sh` makes.
const SHIPPED: &[u8] = include_bytes!("../../fonts/japanese.otf");

/// The fonts of egui, for Latin letters.
pub(crate) fn latin() -> FontDefinitions {
    FontDefinitions::default()
}

/// The first font at those places, else the shipped one; read once.
pub(crate) fn japanese() -> Option<Arc<FontData>> {
    static FOUND: OnceLock<Arc<FontData>> = OnceLock::new();
    let first = || PLACES.iter().find_map(|(path, face)| read(path, *face));
    Some(FOUND.get_or_init(|| Arc::new(first().unwrap_or_else(|| FontData::from_static(SHIPPED)))).clone())
}

fn read(path: &str, face: u32) -> Option<FontData> {
    let bytes = std::fs::read(path).ok()?;
    Some(FontData { index: face, ..FontData::from_owned(bytes) })
}

#[cfg(test)]
mod tests {
    use egui::FontId;

    use super::*;
    use crate::ui::japanese_font::install_font;
    use saute_words::language::Language;

    /// Promise: with the shipped font, which is the only one of a page, no letter of the interface is missing.
    #[test]
    fn the_shipped_font_has_every_letter_of_the_japanese_texts() {
        let ctx = egui::Context::default();
        install_font(&ctx, Arc::new(FontData::from_static(SHIPPED)));
        let _ = ctx.run_ui(egui::RawInput::default(), |_| {});
        let library = saute_kitchen::Library::embedded().expect("embedded data");
        let foods = library.foods.values().flat_map(|food| food.words.values().map(|words| format!("{words:?}")));
        let texts = Language::all().map(|l| l.file().to_owned()).chain(foods).collect::<String>();
        let font = FontId::proportional(15.0);
        let is_missing = |letter: &char| !ctx.fonts_mut(|fonts| fonts.has_glyph(&font, *letter));
        let missing: String = texts.chars().filter(|letter| !letter.is_control()).filter(is_missing).collect();
        assert!(missing.is_empty(), "run scripts/japanese-font.sh: {missing}");
        assert!(texts.contains('焼') && is_missing(&'麤'), "letters are told apart");
    }
}
