//! Animations of pictures of one size: GIF and APNG.

use std::io;

use crate::cut::section::Picture;

/// Frames per second of an animation (chosen: a cook of 20 minutes at one frame each 5 s lasts 24 s).
pub const FRAMES_PER_S: u16 = 10;

/// Formats of an animation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 256 colours a frame; shown everywhere.
    Gif,
    /// All colours; shown by browsers.
    Apng,
}

impl Format {
    /// The format that the ending of a file's name requests; none for another one.
    pub fn of(name: &std::path::Path) -> Option<Self> {
        match name.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "gif" => Some(Self::Gif),
            "apng" => Some(Self::Apng),
            _ => None,
        }
    }
}

/// An animation that could not be encoded.
#[derive(Debug, thiserror::Error)]
#[error("the animation could not be encoded: {0}")]
pub struct AnimationError(#[from] io::Error);

impl From<png::EncodingError> for AnimationError {
    fn from(error: png::EncodingError) -> Self {
        Self(error.into())
    }
}

impl From<gif::EncodingError> for AnimationError {
    fn from(error: gif::EncodingError) -> Self {
        Self(io::Error::other(error))
    }
}

/// Encodes pictures of one size as an animation that repeats for ever.
pub fn animation(format: Format, pictures: &[Picture]) -> Result<Vec<u8>, AnimationError> {
    let size = pictures.first().map_or([0, 0], |first| [first.width, first.height]);
    animation_of(format, size, pictures.len(), pictures.iter().map(|picture| Ok(picture.clone())))
}

/// Encodes a number of pictures of one size [px], one after another as they are drawn.
pub fn animation_of<E: From<AnimationError>>(
    format: Format,
    size: [usize; 2],
    count: usize,
    pictures: impl Iterator<Item = Result<Picture, E>>,
) -> Result<Vec<u8>, E> {
    if count == 0 {
        return Err(AnimationError::from(io::Error::other("there is no picture")).into());
    }
    match format {
        Format::Gif => gif_bytes(size, pictures),
        Format::Apng => apng_bytes(size, count, pictures),
    }
}

fn gif_bytes<E: From<AnimationError>>(
    size: [usize; 2],
    pictures: impl Iterator<Item = Result<Picture, E>>,
) -> Result<Vec<u8>, E> {
    let mut bytes = Vec::new();
    let [width, height] = size.map(|side| side as u16);
    let mut encoder = gif::Encoder::new(&mut bytes, width, height, &[]).map_err(AnimationError::from)?;
    encoder.set_repeat(gif::Repeat::Infinite).map_err(AnimationError::from)?;
    for picture in pictures {
        let mut frame = gif::Frame::from_rgba_speed(width, height, &mut picture?.rgba, PALETTE_SPEED);
        frame.delay = 100 / FRAMES_PER_S;
        encoder.write_frame(&frame).map_err(AnimationError::from)?;
    }
    drop(encoder);
    Ok(bytes)
}

/// Effort for a palette, 1 (slow) to 30 (chosen: no bands in oil at a tenth of the time).
const PALETTE_SPEED: i32 = 10;

fn apng_bytes<E: From<AnimationError>>(
    size: [usize; 2],
    count: usize,
    pictures: impl Iterator<Item = Result<Picture, E>>,
) -> Result<Vec<u8>, E> {
    let mut bytes = Vec::new();
    let mut writer = apng_writer(&mut bytes, size, count).map_err(AnimationError::from)?;
    for picture in pictures {
        writer.write_image_data(&picture?.rgba).map_err(AnimationError::from)?;
    }
    writer.finish().map_err(AnimationError::from)?;
    Ok(bytes)
}

fn apng_writer(
    bytes: &mut Vec<u8>,
    [width, height]: [usize; 2],
    count: usize,
) -> Result<png::Writer<&mut Vec<u8>>, png::EncodingError> {
    let mut encoder = png::Encoder::new(bytes, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_animated(count as u32, 0)?;
    encoder.set_frame_delay(1, FRAMES_PER_S)?;
    encoder.write_header()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn plain(value: u8) -> Picture {
        Picture { width: 8, height: 4, rgba: [value, 40, 20, 255].repeat(32) }
    }

    #[test]
    fn an_apng_keeps_every_frame_exactly() {
        let pictures = [plain(200), plain(90), plain(10)];
        let bytes = animation(Format::Apng, &pictures).unwrap();
        let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
        for picture in &pictures {
            let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut rgba).unwrap();
            assert_eq!(rgba, picture.rgba);
        }
    }

    #[test]
    fn a_gif_has_every_frame() {
        let bytes = animation(Format::Gif, &[plain(200), plain(90)]).unwrap();
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut reader = options.read_info(io::Cursor::new(bytes)).unwrap();
        let mut seen = Vec::new();
        while let Some(frame) = reader.read_next_frame().unwrap() {
            seen.push(frame.buffer[0]);
        }
        assert_eq!(seen.len(), 2);
        assert!(seen[0].abs_diff(200) < 8 && seen[1].abs_diff(90) < 8, "{seen:?}");
    }

    #[test]
    fn the_name_chooses_the_format() {
        let of = |name: &str| Format::of(std::path::Path::new(name));
        assert_eq!(of("a.GIF"), Some(Format::Gif));
        assert_eq!(of("b.apng"), Some(Format::Apng));
        assert_eq!(of("c.png"), None);
    }
}
