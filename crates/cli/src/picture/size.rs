//! The size of a picture on the command line: `1280x720`.

/// Allowed lengths of the sides [px] (chosen: every graphics adapter can render 8192).
const SIDES: std::ops::RangeInclusive<u32> = 64..=8192;

/// Reads a width and a height [px].
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    match sides {
        Some(sides) if sides.iter().all(|s| SIDES.contains(s)) => Ok(sides),
        _ => Err(format!("write WIDTHxHEIGHT in pixels, each {} to {}, as in 1280x720", SIDES.start(), SIDES.end())),
    }
}
