//! Heat conduction through a slab with fixed surface temperatures: the solver and the exact series.
//!
//! ∂T/∂t = α ∂²T/∂z², T(z, 0) = T₀, T(0, t) = T₁, T(L, t) = T₂. The exact solution is
//! T = T₁ + (T₂ − T₁) z/L + Σ 2/(nπ) (T₀ − T₁ − (−1)ⁿ (T₀ − T₂)) sin(nπz/L) exp(−n²π²αt/L²).
//! Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), § 3.4.
//!
//! `cargo run --release -p saute-lab --example slab`

use std::io::Write;

use saute_kitchen::Library;
use saute_lab::exact::FixedSlab;
use saute_lab::{Case, run};

const CASE: &str = r#"
duration_s = 1200
output_every_s = 120
[body]
shape = "slab"
size_mm = [20]
initial_c = 5
[material]
conductivity_w_mk = 0.5
density_kg_m3 = 1000
specific_heat_j_kgk = 3600
[[boundary]]
face = "bottom"
fixed = true
ambient_c = 100
[[boundary]]
face = "top"
fixed = true
ambient_c = 20
[[probe]]
name = "centre"
at_mm = [10]
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let slab = FixedSlab {
        thickness: 0.02,
        diffusivity: 0.5 / (1000.0 * 3600.0),
        initial_c: 5.0,
        bottom_c: 100.0,
        top_c: 20.0,
    };
    let report = run(&Case::parse(CASE, "slab", &Library::embedded()?)?, || 0.0);
    let mut out = std::io::stdout().lock();
    writeln!(out, "  time [s]  centre [°C]  exact [°C]  error [K]")?;
    for [time, centre] in report.probes["centre"].iter().skip(1) {
        let exact = slab.temperature(0.01, *time);
        writeln!(out, "{time:10.0}  {centre:11.4}  {exact:10.4}  {:9.4}", centre - exact)?;
    }
    Ok(())
}
