//! Colour of flesh and fat from their state, in CIE L*a*b* (D65) and in linear sRGB.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use crate::description::{Colours, Kinetics, MOST_CHANGES, NoSuchChange, PerChange};

/// A colour in CIE L*a*b* (D65, 2°).
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Lab(pub [f64; 3]);

/// State of a point of flesh that determines its colour: shares from 0 to 1 [-].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Appearance {
    /// First-order changes, in the order of the kinetics [-].
    pub changed: PerChange,
    /// Browning [-].
    pub browning: f64,
    /// Charring [-].
    pub charring: f64,
    /// Second tissue: a root's core or a shaft's green [-].
    pub tissue: f64,
}

impl Lab {
    /// Linear interpolation to another colour, at a share `t` clamped to 0–1 [-].
    pub fn lerp(self, other: Lab, t: f64) -> Lab {
        let t = t.clamp(0.0, 1.0);
        Lab([0, 1, 2].map(|i| self.0[i] + t * (other.0[i] - self.0[i])))
    }

    /// Colour difference ΔE*ab (CIE 1976) [-].
    ///
    /// ```
    /// use saute_food::Lab;
    /// let (raw, cooked) = (Lab([40.0, 20.0, 10.0]), Lab([60.0, 8.0, 16.0]));
    /// assert!((raw.difference(cooked) - 24.08).abs() < 0.01);
    /// ```
    pub fn difference(self, other: Lab) -> f64 {
        libm::sqrt((0..3).map(|i| (self.0[i] - other.0[i]) * (self.0[i] - other.0[i])).sum())
    }

    /// Linear sRGB from 0 to 1, clipped to the gamut [-].
    ///
    /// CIE 15:2004 `[@cie-15-2004]` for L*a*b*, IEC 61966-2-1 `[@iec-61966-2-1]` for the matrix; white D65 (0.95047, 1,
    /// 1.08883).
    pub fn linear_srgb(self) -> [f64; 3] {
        let fy = (self.0[0] + 16.0) / 116.0;
        let inverse =
            |f: f64| if f > 6.0 / 29.0 { f * f * f } else { (f - 4.0 / 29.0) * 3.0 * (6.0 / 29.0) * (6.0 / 29.0) };
        let x = 0.95047 * inverse(fy + self.0[1] / 500.0);
        let y = inverse(fy);
        let z = 1.08883 * inverse(fy - self.0[2] / 200.0);
        [
            3.240_454 * x - 1.537_139 * y - 0.498_531 * z,
            -0.969_266 * x + 1.876_011 * y + 0.041_556 * z,
            0.055_643 * x - 0.204_026 * y + 1.057_225 * z,
        ]
        .map(|v| v.clamp(0.0, 1.0))
    }

    /// Returns the colour of 8-bit sRGB values: the inverse of [`Lab::srgb8`] within the gamut.
    pub fn from_srgb8(srgb: [u8; 3]) -> Self {
        let [r, g, b] = srgb.map(|v| decoded(f64::from(v) / 255.0));
        let f = |t: f64| {
            let knee = 6.0 / 29.0;
            if t > knee * knee * knee { libm::cbrt(t) } else { t / (3.0 * knee * knee) + 4.0 / 29.0 }
        };
        let x = f((0.412_456 * r + 0.357_576 * g + 0.180_437 * b) / 0.950_47);
        let y = f(0.212_673 * r + 0.715_152 * g + 0.072_175 * b);
        let z = f((0.019_334 * r + 0.119_192 * g + 0.950_304 * b) / 1.088_83);
        Self([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])
    }

    /// sRGB as 8-bit values, clipped to the gamut.
    ///
    /// ```
    /// use saute_food::Lab;
    /// assert_eq!(Lab([100.0, 0.0, 0.0]).srgb8(), [255, 255, 255]);
    /// assert_eq!(Lab([53.585, 0.0, 0.0]).srgb8(), [128, 128, 128]);
    /// ```
    pub fn srgb8(self) -> [u8; 3] {
        self.linear_srgb().map(|v| STEPS.partition_point(|step| *step <= v) as u8)
    }
}

/// Linear light of an sRGB value, both from 0 to 1 (IEC 61966-2-1 `[@iec-61966-2-1]`) [-].
pub fn decoded(v: f64) -> f64 {
    if v <= 0.040_45 { v / 12.92 } else { libm::pow((v + 0.055) / 1.055, 2.4) }
}

/// Linear light above which each 8-bit value except 0 is the nearest [-]; a lookup is faster than the power of 1/2.4.
static STEPS: LazyLock<[f64; 255]> = LazyLock::new(|| std::array::from_fn(|i| decoded((i as f64 + 0.5) / 255.0)));

impl Appearance {
    /// Share of the change that makes fat and muscle opaque: the first one [-].
    pub fn opaque(&self) -> f64 {
        self.changed[0]
    }
}

/// Colours of one food, with the colour shift of each change.
#[derive(Clone, Debug)]
pub struct Palette {
    colours: Colours,
    second: [f64; 3],
    shifts: [[f64; 3]; MOST_CHANGES],
    /// The same in the second tissue, where they differ.
    second_shifts: Option<[[f64; 3]; MOST_CHANGES]>,
}

impl Palette {
    /// Prepares the colours of a food; `second` is the raw colour of a second tissue.
    ///
    /// # Errors
    /// If the colours name a change that the kinetics lack.
    pub fn new(colours: &Colours, second: Option<[f64; 3]>, kinetics: &Kinetics) -> Result<Self, NoSuchChange> {
        let shifts = kinetics.in_order("colour", &colours.change)?;
        let second_shifts = match &colours.second_change {
            Some(changes) => Some(kinetics.in_order("colour", changes)?),
            None => None,
        };
        Ok(Self { shifts, second_shifts, second: second.unwrap_or(colours.raw), colours: colours.clone() })
    }

    /// Colour of lean flesh: the raw colour shifted by the changes, then from golden to crust and char.
    pub fn lean(&self, a: Appearance) -> Lab {
        self.lean_over(self.lean_unbrowned(a), a)
    }

    /// Browns and chars a colour of lean flesh.
    pub fn lean_over(&self, base: Lab, a: Appearance) -> Lab {
        self.browned(base, Lab(self.colours.golden), Lab(self.colours.crust), a)
    }

    /// Colour of lean flesh without browning.
    pub fn lean_unbrowned(&self, a: Appearance) -> Lab {
        let (Lab(before), second) = (self.without_second(a), self.second_tissue());
        Lab([0, 1, 2].map(|i| before[i] + a.tissue * second[i]))
    }

    /// Colour of lean flesh without browning and without what the second tissue adds to it, which is known more finely than at nodes.
    #[inline]
    pub fn without_second(&self, a: Appearance) -> Lab {
        let sum = |shifts: &[[f64; 3]; MOST_CHANGES], i: usize| -> f64 {
            a.changed.iter().zip(shifts).map(|(x, shift)| x * shift[i]).sum()
        };
        let shifted = |i: usize| {
            let first = sum(&self.shifts, i);
            self.second_shifts.as_ref().map_or(first, |second| first + a.tissue * (sum(second, i) - first))
        };
        Lab([0, 1, 2].map(|i| self.colours.raw[i] + shifted(i)))
    }

    /// Difference of L*, a*, b* between raw second tissue and raw flesh [-].
    pub fn second_tissue(&self) -> [f64; 3] {
        [0, 1, 2].map(|i| self.second[i] - self.colours.raw[i])
    }

    /// The colours of the food, as its file states them.
    pub fn colours(&self) -> &Colours {
        &self.colours
    }

    /// Colour of fat without browning: waxy when raw, translucent when molten.
    pub fn fat_unbrowned(&self, a: Appearance) -> Lab {
        Lab(self.colours.fat_raw).lerp(Lab(self.colours.fat_cooked), a.opaque())
    }

    /// Colour of fat: from waxy (raw) over translucent (molten) to brown and charred.
    pub fn fat(&self, a: Appearance) -> Lab {
        self.fat_over(self.fat_unbrowned(a), a)
    }

    /// Browns and chars a colour of fat.
    pub fn fat_over(&self, base: Lab, a: Appearance) -> Lab {
        let brown = Lab(self.colours.fat_brown);
        self.browned(base, base.lerp(brown, 0.6), brown, a)
    }

    fn browned(&self, base: Lab, golden: Lab, crust: Lab, a: Appearance) -> Lab {
        let golden_at = self.colours.golden_at;
        let brown = if a.browning < golden_at {
            base.lerp(golden, a.browning / golden_at)
        } else {
            golden.lerp(crust, (a.browning - golden_at) / (1.0 - golden_at))
        };
        brown.lerp(Lab(self.colours.char), a.charring)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_colours_convert() {
        assert_eq!(Lab([100.0, 0.0, 0.0]).srgb8(), [255, 255, 255]);
        assert_eq!(Lab([0.0, 0.0, 0.0]).srgb8(), [0, 0, 0]);
        // sRGB red is L*a*b* 53.24, 80.09, 67.20.
        let red = Lab([53.24, 80.09, 67.20]).srgb8();
        assert!(red[0] >= 254 && red[1] <= 2 && red[2] <= 2, "{red:?}");
        for lab in [[37.0, 24.0, 12.0], [31.0, 5.0, 6.0], [84.0, -5.0, 17.0], [57.0, 31.0, 42.0]].map(Lab) {
            // Half a step of 8 bits in each channel.
            assert!(Lab::from_srgb8(lab.srgb8()).difference(lab) < 0.6, "{lab:?}");
        }
    }
}
