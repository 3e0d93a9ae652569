//! Pictures of the foods in the pantry, which are beside the files of the foods.

use std::collections::BTreeMap;

use egui::{ColorImage, Context, TextureHandle, TextureOptions};
use saute_kitchen::Library;

/// The pictures as textures by the id of the food, each made when it is first shown.
#[derive(Default)]
pub struct Stills(BTreeMap<String, Option<TextureHandle>>);

impl Stills {
    /// Returns the picture of a food; none for the user's own food.
    pub fn of(&mut self, ctx: &Context, food: &str) -> Option<TextureHandle> {
        if !self.0.contains_key(food) {
            let image = Library::food_picture(food).and_then(decoded);
            let texture = image.map(|image| ctx.load_texture(food, image, TextureOptions::LINEAR));
            self.0.insert(food.to_owned(), texture);
        }
        self.0.get(food).cloned().flatten()
    }
}

/// The pixels of a PNG file of eight bits with transparency, of a palette as a rule.
fn decoded(file: &[u8]) -> Option<ColorImage> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::ALPHA);
    let mut reader = decoder.read_info().ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    let frame = reader.next_frame(&mut bytes).ok()?;
    let size = [frame.width as usize, frame.height as usize];
    (bytes.len() == 4 * size[0] * size[1]).then(|| ColorImage::from_rgba_unmultiplied(size, &bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_food_has_a_picture_and_one_of_the_users_has_none() {
        let library = Library::embedded().expect("embedded data");
        for food in library.foods.keys() {
            let file = Library::food_picture(food).expect("run scripts/food-pictures.sh");
            assert_eq!(decoded(file).expect("decodes").size, [108, 72], "{food}");
        }
        let ctx = Context::default();
        let mut stills = Stills::default();
        assert!(stills.of(&ctx, "leek-ring").is_some() && stills.of(&ctx, "leek-ring").is_some());
        assert!(stills.of(&ctx, "dumpling").is_none());
    }
}
