//! What heat does for good to the colour of a pan's surface: temper colours, seasoning that burns off, a coating that browns.

use saute_food::sourced_table;

sourced_table! {
    /// Reflectance of a surface by the highest temperature that it has had.
    HeatTint {
        /// Highest temperatures, rising [°C]; below the first one the surface is as new at `new_c`.
        #[schemars(inner(range(min = -50.0, max = 3000.0)), extend("examples" = [[300.0, 400.0]]))]
        celsius: Vec<f64>,
        /// Reflectance of red, green and blue light there over that of the new surface, 0–2 [-].
        #[schemars(inner(inner(range(min = 0.0, max = 2.0))), extend("examples" = [[[1.2, 1.1, 0.9], [1.6, 1.2, 0.8]]]))]
        share: Vec<[f64; 3]>,
        /// Up to here nothing changes [°C].
        #[schemars(range(min = -100.0, max = 3000.0), example = 255.0)]
        new_c: f64,
    }
}

impl HeatTint {
    /// Reflectance by colour over that of the new surface, linear between the points and constant beyond them [-].
    pub fn share_at(&self, highest_c: f64) -> [f64; 3] {
        let mut below = (self.new_c, [1.0; 3]);
        for (&celsius, &share) in self.celsius.iter().zip(&self.share) {
            if highest_c < celsius {
                let along = ((highest_c - below.0) / (celsius - below.0)).max(0.0);
                return core::array::from_fn(|k| below.1[k] + along * (share[k] - below.1[k]));
            }
            below = (celsius, share);
        }
        below.1
    }

    /// Returns the key that is wrong and what to write instead, if its lists do not fit.
    pub(crate) fn fault(&self) -> Option<(&'static str, &'static str)> {
        let rises = core::iter::once(&self.new_c).chain(&self.celsius).is_sorted_by(|a, b| a < b);
        if self.celsius.is_empty() || !rises {
            Some(("celsius", "write temperatures that rise from above new_c"))
        } else if self.share.len() != self.celsius.len() {
            Some(("share", "write one colour for each temperature"))
        } else {
            None
        }
    }
}
