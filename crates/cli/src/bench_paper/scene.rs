//! A pan full of carrots and shrimps, as a recipe that `saute cook` could play too.

use std::fmt::Write;

use saute_kitchen::{Library, MeshSize, TICK_S};
use saute_recipe::{Cook, Recipe};

use crate::error::CliError;

/// Angle between consecutive places on a spiral that fills a disc evenly: the golden angle [rad].
const GOLDEN: f64 = 2.399_963;
/// Radius of the disc over the radius of the floor [-] (chosen: a shrimp at its edge still lies on the floor).
const SPREAD: f64 = 0.7;
/// Time from the last piece until everything is at rest [s] (chosen: the dynamics promise rest within it).
const SETTLING_S: f64 = 2.0;
/// Time that the pan is shaken before the measurement [s] (chosen: three strokes).
const SHAKEN_S: f64 = 1.0;
/// Amplitude [mm] and frequency [Hz] of the shaking (source: as in the 2013 paper).
const SHAKE: [f64; 2] = [20.0, 3.0];
/// Id of the pan.
pub const PAN: &str = "carbon-steel-26";

/// The contents of the pan and its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Number of carrot coins.
    pub carrots: usize,
    /// Number of shrimps.
    pub shrimps: usize,
    /// Size of their meshes.
    pub mesh: MeshSize,
    /// True if the pan is shaken.
    pub shaking: bool,
    /// Id of the pan.
    pub pan: String,
}

impl Scene {
    /// Returns the number of pieces.
    pub fn pieces(&self) -> usize {
        self.carrots + self.shrimps
    }

    /// Returns a description for the progress bar.
    pub fn in_words(&self) -> String {
        let mesh = if self.mesh == MeshSize::Paper2013 { "meshes of 2013" } else { "default meshes" };
        let pan = if self.shaking { "shaken" } else { "at rest" };
        format!("{} carrots and {} shrimps, {mesh}, {pan}", self.carrots, self.shrimps)
    }

    /// Returns the scene as a recipe that runs for `seconds` after everything is at rest [s]. The foods fall into a hot pan
    /// one after the other, carrots and shrimps alternating.
    fn recipe(&self, floor_mm: f64, seconds: f64) -> String {
        let paper = self.mesh == MeshSize::Paper2013;
        let preset = if paper { "preset = \"2013\"\n" } else { "" };
        let mut text = format!("title = \"Bench\"\n{preset}[pan]\nkind = \"{}\"\ninitial_c = 180\n", self.pan);
        for (id, kind, count) in [("carrots", "carrot-coin", self.carrots), ("shrimps", "shrimp", self.shrimps)] {
            if count > 0 {
                let mesh = if paper { "2013" } else { "default" };
                let _ =
                    writeln!(text, "[[food]]\nid = \"{id}\"\nkind = \"{kind}\"\ncount = {count}\nmesh = \"{mesh}\"");
            }
        }
        text.push_str("[[step]]\nhob_w = 900\n");
        for (i, food) in self.alternating().iter().enumerate() {
            let angle = GOLDEN * i as f64;
            let radius = SPREAD * floor_mm * ((i as f64 + 0.5) / self.pieces() as f64).sqrt();
            let [x, y] = [radius * angle.cos(), radius * angle.sin()];
            let put = format!("put = {{ food = \"{food}\", at_mm = [{x:.3}, {y:.3}], heap = true }}");
            let _ = writeln!(text, "[[step]]\nafter_s = 0.1\n{put}");
        }
        let [amplitude, hz] = SHAKE;
        let (settled, on) = (SETTLING_S, SHAKEN_S + seconds);
        if self.shaking {
            let shake = format!("shake = {{ amplitude_mm = {amplitude}, hz = {hz}, for_s = {on} }}");
            let _ = writeln!(text, "[[step]]\nafter_s = {settled}\n{shake}\n[[step]]\nend = true");
        } else {
            let _ = writeln!(text, "[[step]]\nafter_s = {}\nend = true", settled + seconds);
        }
        text
    }

    /// Returns the ids of the pieces, carrots and shrimps alternating.
    fn alternating(&self) -> Vec<String> {
        let name = |group: &str, i: usize, count: usize| (i < count).then(|| format!("{group}.{}", i + 1));
        let most = self.carrots.max(self.shrimps);
        let pair = |i: usize| [name("carrots", i, self.carrots), name("shrimps", i, self.shrimps)];
        (0..most).flat_map(pair).flatten().collect()
    }

    /// Returns the time at which everything is at rest, or has been shaken for a while [s].
    pub fn ready_at_s(&self) -> f64 {
        TICK_S * self.pieces() as f64 + SETTLING_S + if self.shaking { SHAKEN_S } else { 0.0 }
    }

    /// Returns the cook at its start; it ends `seconds` after it is ready [s].
    pub fn cook(&self, library: &Library, seconds: f64) -> Result<Cook, CliError> {
        let floor_mm = library.pans.get(&self.pan).map_or(0.0, |pan| pan.floor.radius_mm);
        let recipe = Recipe::parse(&self.recipe(floor_mm, seconds), "bench", library)?;
        Cook::new(recipe, library).map_err(|source| CliError::Setup { file: "bench".to_owned(), source })
    }
}
