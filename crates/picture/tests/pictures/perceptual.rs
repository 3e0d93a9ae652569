//! How different two pictures look: ΔE*ab after a slight blur, in the mean and at the worst hundredth.

use saute_kitchen::food::Lab;
use saute_kitchen::heat::sorted::{Quantile, Sorted};
use saute_picture::Picture;

/// Largest difference that passes (chosen: twice what a driver makes that rounds every channel another way, 0.23 and
/// 0.60; a tenth more browning, the least change that has to be seen, is 2.8 at the worst hundredth, and a tenth of a
/// stop 0.9 in the mean. `visible_changes_fail_and_rounding_passes` tests both sides).
pub const MOST_MEAN: f64 = 0.4;
pub const MOST_PERCENTILE: f64 = 1.6;

/// A comparison.
pub struct Difference {
    /// Mean ΔE*ab.
    pub mean: f64,
    /// The ΔE*ab that one pixel of a hundred exceeds.
    pub percentile: f64,
    /// ΔE*ab of every pixel, rows from the top.
    pub apart: Vec<f64>,
}

impl Difference {
    /// Of two pictures of one size.
    pub fn of(got: &Picture, expected: &Picture) -> Self {
        assert_eq!((got.width, got.height), (expected.width, expected.height), "another size");
        let [got, expected] = [got, expected].map(blurred);
        let apart: Vec<f64> = got.iter().zip(&expected).map(|(a, b)| a.difference(*b)).collect();
        let mean = apart.iter().sum::<f64>() / apart.len() as f64;
        let percentile = Sorted::new(apart.clone()).quantile(0.99, Quantile::After).expect("pixels");
        Self { mean, percentile, apart }
    }

    /// Returns true if the difference is invisible.
    pub fn passes(&self) -> bool {
        self.mean <= MOST_MEAN && self.percentile <= MOST_PERCENTILE
    }

    /// The difference as a picture: grey, white from a ΔE of 10.
    pub fn picture(&self, like: &Picture) -> Picture {
        let grey = |e: &f64| {
            let v = (25.5 * e).min(255.0) as u8;
            [v, v, v, 255]
        };
        Picture { rgba: self.apart.iter().flat_map(grey).collect(), width: like.width, height: like.height }
    }
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ΔE {:.2} in the mean, {:.2} at the worst hundredth", self.mean, self.percentile)
    }
}

/// L*a*b* of every pixel, blurred by the binomial of five (σ = 1 pixel).
fn blurred(picture: &Picture) -> Vec<Lab> {
    let sharp: Vec<Lab> = picture.rgba.chunks(4).map(|p| Lab::from_srgb8([p[0], p[1], p[2]])).collect();
    let (w, h) = (picture.width as isize, picture.height as isize);
    let across = filtered(&sharp, |at, k| {
        let (x, y) = (at % w, at / w);
        y * w + (x + k).clamp(0, w - 1)
    });
    filtered(&across, |at, k| {
        let (x, y) = (at % w, at / w);
        (y + k).clamp(0, h - 1) * w + x
    })
}

fn filtered(from: &[Lab], neighbour: impl Fn(isize, isize) -> isize) -> Vec<Lab> {
    let weights = [1.0, 4.0, 6.0, 4.0, 1.0].map(|w| w / 16.0);
    let at = |at: usize| {
        let mut sum = [0.0; 3];
        for (k, w) in (-2..=2).zip(weights) {
            let Lab(lab) = from[neighbour(at as isize, k) as usize];
            (0..3).for_each(|i| sum[i] += w * lab[i]);
        }
        Lab(sum)
    };
    (0..from.len()).map(at).collect()
}
