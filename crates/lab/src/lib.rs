//! Heat conduction and cooking of plain bodies, for comparison with exact solutions and measurements.
//!
//! A [`Case`] is a box, cylinder, sphere or slab, or a stack of them, with Robin, fixed-temperature or fixed-flux
//! boundaries on any face. [`run`] solves it on a product mesh by the method of lines and returns a [`LabReport`];
//! [`verdicts`] compares the report with the expectations of the case.
//!
//! Bodies are products of one-dimensional meshes (straight, cylindrical or spherical axes), stacked in layers where
//! there are several. With constant properties a second-order Runge–Kutta–Legendre scheme `[@meyer-2014]` integrates
//! them, with steps that grow with the time since the last sudden change. Properties that change, boiling and
//! `rule = "segments"` are computed edge by edge.
//!
//! A slab between two temperatures, compared with its [exact series](exact::FixedSlab):
//!
//! ```
//! use saute_lab::exact::FixedSlab;
//! use saute_lab::{Case, run};
//!
//! let text = r#"
//!     duration_s = 600
//!     [body]
//!     shape = "slab"
//!     size_mm = [20]
//!     initial_c = 5
//!     [material]
//!     conductivity_w_mk = 0.5
//!     density_kg_m3 = 1000
//!     specific_heat_j_kgk = 3600
//!     [[boundary]]
//!     face = "bottom"
//!     fixed = true
//!     ambient_c = 100
//!     [[boundary]]
//!     face = "top"
//!     fixed = true
//!     ambient_c = 20
//!     [[probe]]
//!     name = "centre"
//!     at_mm = [10]
//! "#;
//! let library = saute_kitchen::Library::embedded()?;
//! let report = run(&Case::parse(text, "slab.toml", &library)?, || 0.0);
//! let [_, centre_c] = report.probes["centre"][1];
//!
//! let slab = FixedSlab {
//!     thickness: 0.02,
//!     diffusivity: 0.5 / (1000.0 * 3600.0),
//!     initial_c: 5.0,
//!     bottom_c: 100.0,
//!     top_c: 20.0,
//! };
//! let exact_c = slab.temperature(0.01, 600.0);
//! assert!((centre_c - exact_c).abs() < 0.05, "{centre_c} °C, exact {exact_c} °C");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod case;
pub mod cook_case;
pub mod exact;
mod result;
mod solve;

pub use case::{
    BodyCase, Case, CaseFile, CookingCase, Medium, PanCase, Phase, Physics, ProbeCase, Quantity, Radiation, Shape,
    Until, validation_cases, validation_list,
};
pub use cook_case::CookCase;
pub use result::evidence::Evidence;
pub use result::report::LabReport;
pub use result::verdict::{Expectation, Subject, Verdict, verdicts};
pub use solve::material::{Boiling, Material, Solid};
pub use solve::watch::{Told, Watch};
pub use solve::work::{MOST_WORK, work};
pub use solve::{run, run_watched};
