//! A pan full of carrots and shrimps, as a recipe that `saute cook` plays too.

use std::fmt::Write;

use saute_kitchen::{Library, MeshSize, TICK_S};
use saute_recipe::{Cook, Recipe};

use crate::error::CliError;

/// Angle between two places of a spiral that fills a disc evenly [rad] (the golden angle).
const GOLDEN: f64 = 2.399_963;
/// Radius of that disc over the floor's [-] (chosen: a shrimp at its edge still lies on the floor).
const SPREAD: f64 = 0.7;
/// Time after the last piece until everything lies still [s] (chosen: the dynamics promise rest within it).
const SETTLING_S: f64 = 2.0;
/// How long the pan has been shaken before anything is timed [s] (chosen: three strokes).
const SHAKEN_S: f64 = 1.0;
/// Farthest the pan is moved to either side [mm], and how often [Hz], while it is shaken (the published operation).
const SHAKE: [f64; 2] = [20.0, 3.0];
/// The pan of every scene.
pub const PAN: &str = "carbon-steel-26";

/// What lies in the pan and what is done with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Carrot coins.
    pub carrots: usize,
    /// Shrimps.
    pub shrimps: usize,
    /// Fineness of their meshes.
    pub mesh: MeshSize,
    /// Whether the pan is shaken.
    pub shaking: bool,
    /// Which pan.
    pub pan: String,
}

impl Scene {
    /// How many pieces it has.
    pub fn pieces(&self) -> usize {
        self.carrots + self.shrimps
    }

    /// What it is, for the one who waits.
    pub fn in_words(&self) -> String {
        let mesh = if self.mesh == MeshSize::Paper2013 { "meshes of 2013" } else { "our meshes" };
        let pan = if self.shaking { "shaken" } else { "at rest" };
        format!("{} carrots and {} shrimps, {mesh}, {pan}", self.carrots, self.shrimps)
    }

    /// The scene as a recipe that goes on for `seconds` after everything has come to rest [s]: the foods fall into a hot pan
    /// one after the other, carrots and shrimps by turns.
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
        for (i, food) in self.by_turns().iter().enumerate() {
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

    /// Names of the foods, carrots and shrimps by turns.
    fn by_turns(&self) -> Vec<String> {
        let name = |group: &str, i: usize, count: usize| (i < count).then(|| format!("{group}.{}", i + 1));
        let most = self.carrots.max(self.shrimps);
        let pair = |i: usize| [name("carrots", i, self.carrots), name("shrimps", i, self.shrimps)];
        (0..most).flat_map(pair).flatten().collect()
    }

    /// When everything lies still, or has been shaken for a while [s].
    pub fn ready_at_s(&self) -> f64 {
        TICK_S * self.pieces() as f64 + SETTLING_S + if self.shaking { SHAKEN_S } else { 0.0 }
    }

    /// The cook, with nothing done yet; it ends `seconds` after it is ready [s].
    pub fn cook(&self, library: &Library, seconds: f64) -> Result<Cook, CliError> {
        let floor_mm = library.pans.get(&self.pan).map_or(0.0, |pan| pan.floor.radius_mm);
        let recipe = Recipe::parse(&self.recipe(floor_mm, seconds), "bench", library)?;
        Cook::new(recipe, library).map_err(|source| CliError::Setup { file: "bench".to_owned(), source })
    }
}
