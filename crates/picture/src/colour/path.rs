//! Sequential colour tables: walked along paths through L*a*b* on which lightness only rises or only falls.

use std::sync::Arc;

use saute_kitchen::food::Lab;

/// A path through L*a*b*. Lightness carries the order, so that grey prints and every kind of colour vision keep it;
/// hue only helps (way-points chosen).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourPath {
    /// Cold to hot: ink blue over teal and ochre to pale pink.
    Heat,
    /// Dry to wet: pale straw over grey-green to deep blue.
    Water,
    /// Pale to burnt: cream over gold to near black.
    Browning,
    /// Alive to killed: dark violet over blue to pale green.
    Kill,
    /// Lean to fat: wine red to cream.
    Fat,
}

impl ColourPath {
    /// All paths.
    pub const ALL: [Self; 5] = [Self::Heat, Self::Water, Self::Browning, Self::Kill, Self::Fat];

    fn way_points(self) -> &'static [[f64; 3]] {
        match self {
            Self::Heat => &[
                [12.0, 12.0, -30.0],
                [26.0, 2.0, -34.0],
                [40.0, -14.0, -20.0],
                [54.0, -16.0, 14.0],
                [67.0, 4.0, 52.0],
                [79.0, 24.0, 46.0],
                [93.0, 10.0, 12.0],
            ],
            Self::Water => &[
                [93.0, 2.0, 26.0],
                [78.0, -8.0, 20.0],
                [62.0, -16.0, 2.0],
                [46.0, -10.0, -20.0],
                [30.0, 4.0, -38.0],
                [14.0, 14.0, -34.0],
            ],
            Self::Browning => &[
                [94.0, 0.0, 14.0],
                [80.0, 8.0, 42.0],
                [62.0, 22.0, 46.0],
                [44.0, 24.0, 34.0],
                [26.0, 16.0, 18.0],
                [8.0, 4.0, 4.0],
            ],
            Self::Kill => &[
                [14.0, 22.0, -22.0],
                [32.0, 14.0, -38.0],
                [50.0, -12.0, -22.0],
                [70.0, -26.0, 8.0],
                [93.0, -10.0, 36.0],
            ],
            Self::Fat => {
                &[[18.0, 30.0, 12.0], [38.0, 38.0, 20.0], [58.0, 26.0, 20.0], [77.0, 10.0, 18.0], [96.0, 0.0, 12.0]]
            }
        }
    }

    /// 256 colours in steps of equal ΔE*ab.
    pub fn table(self) -> Arc<[[u8; 3]; 256]> {
        let smooth: Vec<Lab> = (0..=600).map(|i| self.at(f64::from(i) / 600.0)).collect();
        let mut walked = vec![0.0];
        for pair in smooth.windows(2) {
            walked.push(walked[walked.len() - 1] + pair[0].difference(pair[1]));
        }
        let whole = walked[walked.len() - 1];
        Arc::new(std::array::from_fn(|i| {
            let wanted = whole * i as f64 / 255.0;
            let upper = walked.partition_point(|&w| w < wanted).clamp(1, walked.len() - 1);
            let share = (wanted - walked[upper - 1]) / (walked[upper] - walked[upper - 1]);
            smooth[upper - 1].lerp(smooth[upper], share).srgb8()
        }))
    }

    /// Catmull–Rom curve through the way-points.
    fn at(self, t: f64) -> Lab {
        let path = self.way_points();
        let position = t * (path.len() - 1) as f64;
        let cell = (position as usize).min(path.len() - 2);
        let u = position - cell as f64;
        let at = |i: isize| path[(cell as isize + i).clamp(0, path.len() as isize - 1) as usize];
        let [a, b, c, d] = [at(-1), at(0), at(1), at(2)];
        Lab([0, 1, 2].map(|k| {
            b[k] + 0.5
                * u
                * (c[k] - a[k]
                    + u * (2.0 * a[k] - 5.0 * b[k] + 4.0 * c[k] - d[k] + u * (3.0 * (b[k] - c[k]) + d[k] - a[k])))
        }))
    }
}

#[cfg(test)]
mod tests {
    use saute_kitchen::food::change::colour::decoded;

    use super::*;

    /// sRGB as deuteranopes and protanopes see it: Machado, Oliveira & Fernandes 2009 `[@machado-2009]`, severity 1.
    const DICHROMATS: [[[f64; 3]; 3]; 2] = [
        [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]],
        [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]],
    ];

    fn linear(colour: [u8; 3]) -> [f64; 3] {
        colour.map(|v| decoded(f64::from(v) / 255.0))
    }

    fn lab(rgb: [f64; 3]) -> Lab {
        let row = |m: [f64; 3]| (0..3).map(|k| m[k] * rgb[k]).sum::<f64>();
        let f = |v: f64| if v > 0.008_856 { v.cbrt() } else { 7.787 * v + 16.0 / 116.0 };
        let x = f(row([0.412_456, 0.357_576, 0.180_438]) / 0.950_47);
        let y = f(row([0.212_673, 0.715_152, 0.072_175]));
        let z = f(row([0.019_334, 0.119_192, 0.950_304]) / 1.088_83);
        Lab([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])
    }

    #[test]
    fn lightness_goes_one_way_on_every_path() {
        for path in ColourPath::ALL {
            let l: Vec<f64> = path.table().iter().map(|&c| lab(linear(c)).0[0]).collect();
            let way = (l[255] - l[0]).signum();
            assert!(l.windows(8).all(|w| way * (w[7] - w[0]) > 0.0), "{path:?}: {l:?}");
            assert!((l[255] - l[0]).abs() > 70.0, "{path:?}");
        }
    }

    #[test]
    fn an_eighth_of_every_path_is_told_apart_with_and_without_red_or_green() {
        let normal = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for path in ColourPath::ALL {
            let table = path.table();
            for eye in [normal, DICHROMATS[0], DICHROMATS[1]] {
                let seen = |i: usize| {
                    let rgb = linear(table[i]);
                    lab(eye.map(|row| (0..3).map(|k| row[k] * rgb[k]).sum::<f64>().clamp(0.0, 1.0)))
                };
                for i in 0..256 {
                    // Not only neighbours: no two places a fan of the path apart may look alike.
                    for j in i + 32..256 {
                        let apart = seen(i).difference(seen(j));
                        assert!(apart > 6.0, "{path:?}: {i} and {j} are {apart:.1} apart");
                    }
                }
            }
        }
    }
}
