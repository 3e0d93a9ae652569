//! Pictures as PNG bytes.

use crate::cut::section::Picture;

/// A picture that could not be encoded.
#[derive(Debug, thiserror::Error)]
#[error("the picture could not be encoded as PNG: {0}")]
pub struct PngError(#[from] png::EncodingError);

/// Encodes an RGBA picture as PNG.
pub fn png_bytes(picture: &Picture) -> Result<Vec<u8>, PngError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.width as u32, picture.height as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgba)?;
    writer.finish()?;
    Ok(bytes)
}
