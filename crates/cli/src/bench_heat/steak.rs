//! A steak of 10,000 nodes with the full physics of a kitchen.

use std::time::Instant;

use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe};
use serde::Serialize;

use crate::error::CliError;

/// A steak that is fried on both sides and rests (size chosen: its mesh has 10,000 nodes).
const RECIPE: &str = r#"title = "Steak"
[pan]
kind = "carbon-steel-26"
initial_c = 220
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [121, 81, 25]
initial_c = 5
[[step]]
hob_w = 500
[[step]]
put = "steak"
[[step]]
after_s = 240
flip = "steak"
[[step]]
after_s = 240
rest = "steak"
[[step]]
hob_w = 0
[[step]]
after_s = 120
end = true
"#;

/// Size and speed of the steak.
#[derive(Debug, Serialize)]
pub struct SteakBench {
    /// Number of nodes.
    pub nodes: usize,
    /// Simulated time over wall time [-].
    pub real_time_factor: f64,
}

/// Cooks the steak.
pub fn measure(library: &Library) -> Result<SteakBench, CliError> {
    let recipe = Recipe::parse(RECIPE, "steak", library)?;
    let mut cook = Cook::new(recipe, library).map_err(|source| CliError::Setup { file: "steak".to_owned(), source })?;
    let nodes = cook.kitchen.pieces().iter().map(|p| p.model.mesh().node_count()).sum();
    let start = Instant::now();
    while cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(SteakBench { nodes, real_time_factor: cook.kitchen.time_s() / start.elapsed().as_secs_f64() })
}
