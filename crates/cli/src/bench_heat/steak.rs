//! A steak of 10,000 nodes with all that a kitchen knows of it.

use std::time::Instant;

use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe};
use serde::Serialize;

use crate::error::CliError;

/// A steak that is fried on both sides and rests (sizes chosen: they mesh into 10,000 nodes).
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

/// The steak's numbers.
#[derive(Debug, Serialize)]
pub struct SteakBench {
    /// Nodes of the steak.
    pub nodes: usize,
    /// Simulated time over wall time [-].
    pub real_time_factor: f64,
}

/// Cooks it.
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
