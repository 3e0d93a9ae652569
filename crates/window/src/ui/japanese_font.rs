//! A font for Japanese: one that the system has.

use std::sync::{Arc, OnceLock};

use egui::{FontData, FontDefinitions, FontFamily};

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
/// The font's name among those of egui.
const NAME: &str = "japanese";

/// Adds the system's Japanese font behind egui's own, which keep Latin letters and digits; returns true if there is
/// one.
pub fn install(ctx: &egui::Context) -> bool {
    let Some(font) = found() else { return false };
    install_font(ctx, font);
    true
}

/// Adds a Japanese font likewise.
pub(crate) fn install_font(ctx: &egui::Context, font: Arc<FontData>) {
    let mut fonts = FontDefinitions::default();
    fonts.font_data.insert(NAME.to_owned(), font);
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.entry(family).or_default().push(NAME.to_owned());
    }
    ctx.set_fonts(fonts);
}

/// The first font at those places; read once.
fn found() -> Option<Arc<FontData>> {
    static FOUND: OnceLock<Option<Arc<FontData>>> = OnceLock::new();
    FOUND.get_or_init(|| PLACES.iter().find_map(|(path, face)| read(path, *face)).map(Arc::new)).clone()
}

#[cfg(not(target_arch = "wasm32"))]
fn read(path: &str, face: u32) -> Option<FontData> {
    let bytes = std::fs::read(path).ok()?;
    Some(FontData { index: face, ..FontData::from_owned(bytes) })
}

/// A page has no fonts of the system.
#[cfg(target_arch = "wasm32")]
fn read(_path: &str, _face: u32) -> Option<FontData> {
    None
}
