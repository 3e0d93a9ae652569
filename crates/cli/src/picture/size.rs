//! The size of a picture on the command line: `1280x720`.

/// Allowed lengths of the sides [px] (chosen: every graphics adapter can render 4096).
const SIDES: std::ops::RangeInclusive<u32> = 64..=4096;
/// Most pixels of a picture [px] (chosen: those of 2560 × 1440, which take 510 MB in the best quality; 90 bytes a pixel were measured on
/// a processor that is in for the graphics adapter).
const MOST_PIXELS: u32 = 2560 * 1440;

/// Reads a width and a height [px].
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    match sides {
        Some([w, h]) if SIDES.contains(&w) && SIDES.contains(&h) && w * h > MOST_PIXELS => Err(format!(
            "a picture has at most {MOST_PIXELS} pixels: write 2560x1440, or at most {} pixels of height for this width",
            MOST_PIXELS / w
        )),
        Some(sides) if sides.iter().all(|s| SIDES.contains(s)) => Ok(sides),
        _ => Err(format!("write WIDTHxHEIGHT in pixels, each {} to {}, as in 1280x720", SIDES.start(), SIDES.end())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_needs_too_much_memory_is_refused_with_what_fits() {
        assert_eq!(size("2560x1440"), Ok([2560, 1440]));
        assert_eq!(size("900x4096"), Ok([900, 4096]));
        let refused = size("4096x4096").expect_err("sixteen million pixels");
        assert!(refused.contains("at most 900 pixels of height"), "{refused}");
        assert!(size("8192x8192").expect_err("a side").contains("64 to 4096"));
    }
}
