//! Pictures of the foods in the pantry; `scripts/food-pictures.sh` draws them with the program itself.

use std::collections::BTreeMap;

use egui::{ColorImage, Context, TextureHandle, TextureOptions};

/// Ids of the shipped foods with their pictures.
const FILES: [(&str, &[u8]); 7] = [
    ("beef-lean", include_bytes!("../../stills/beef-lean.png")),
    ("beef-marbled", include_bytes!("../../stills/beef-marbled.png")),
    ("beef-patty", include_bytes!("../../stills/beef-patty.png")),
    ("carrot-coin", include_bytes!("../../stills/carrot-coin.png")),
    ("carrot-stick", include_bytes!("../../stills/carrot-stick.png")),
    ("leek-ring", include_bytes!("../../stills/leek-ring.png")),
    ("shrimp", include_bytes!("../../stills/shrimp.png")),
];

/// The pictures as textures, each made when it is first shown.
#[derive(Default)]
pub struct Stills(BTreeMap<&'static str, Option<TextureHandle>>);

impl Stills {
    /// Returns the picture of a food; none for a food of the user's own.
    pub fn of(&mut self, ctx: &Context, food: &str) -> Option<TextureHandle> {
        let (id, file) = FILES.into_iter().find(|(id, _)| *id == food)?;
        let load = || decoded(file).map(|image| ctx.load_texture(id, image, TextureOptions::LINEAR));
        self.0.entry(id).or_insert_with(load).clone()
    }
}

/// The pixels of a PNG file of eight bits with transparency, as the program writes them.
fn decoded(file: &[u8]) -> Option<ColorImage> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    let frame = reader.next_frame(&mut bytes).ok()?;
    let size = [frame.width as usize, frame.height as usize];
    (bytes.len() == 4 * size[0] * size[1]).then(|| ColorImage::from_rgba_unmultiplied(size, &bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_food_has_a_picture() {
        let library = saute_kitchen::Library::embedded().expect("embedded data");
        for food in library.foods.keys() {
            let (_, file) = FILES.iter().find(|(id, _)| id == food).expect("run scripts/food-pictures.sh");
            assert_eq!(decoded(file).expect("decodes").size, [108, 72], "{food}");
        }
    }
}
