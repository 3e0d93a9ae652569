//! Beef in an oven: convection, radiation from the walls and evaporation at a face that dries and browns.
//!
//! `cargo run --release -p saute-lab --example oven`

use std::io::Write;

use saute_kitchen::Library;
use saute_lab::{Case, run};

const CASE: &str = r#"
duration_s = 7200
output_every_s = 600
[body]
shape = "slab"
size_mm = [30]
initial_c = 5
[material]
food = "beef-lean"
[solver]
physics = "cooking"
[[boundary]]
face = "all"
h_w_m2k = 15
ambient_c = 180
humidity_pct = 1
radiant_c = 180
[[probe]]
name = "face"
at_mm = [30]
[[probe]]
name = "centre"
at_mm = [15]
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = Case::parse(CASE, "oven.toml", &Library::embedded()?)?;
    let report = run(&case, || 0.0);
    let mut out = std::io::stdout().lock();
    writeln!(out, "   t [s]  face [°C]  centre [°C]")?;
    for ([time, face], [_, centre]) in report.probes["face"].iter().zip(&report.probes["centre"]) {
        writeln!(out, "{time:8.0}  {face:9.1}  {centre:11.1}")?;
    }
    let [lightness, redness, yellowness] = report.surface_lab["top"];
    writeln!(out, "colour of the face: L* {lightness:.1}  a* {redness:.1}  b* {yellowness:.1}")?;
    Ok(())
}
