//! Oil, water, butter and fond on the pan, and what leaves them as spatter and smoke.
//!
//! Oil (by kind of fat) and water are on the pan's nodes, wall included, and flow as thin films. Each tick makes one
//! forward and one backward Gauss–Seidel sweep over the faces; each face is solved implicitly for its two nodes. No
//! face passes more than equalises its two surfaces or more than the upper node contains. Masses are conserved to
//! rounding, and a liquid at rest costs nothing. Oil has the temperature of the metal below it and adds to its heat
//! capacity. Water has its own temperature, spreads to puddles of 0.7 mm and boils by one curve from nucleate to film
//! boiling, whether it is juice, water of butter or poured in.

pub mod bath;
pub mod butter;
pub mod drop_flight;
pub mod film_flow;
pub mod fond;
pub mod liquid_layer;
pub mod oil;
pub mod oil_film;
pub mod smoke;
pub mod solids_rates;
pub mod spatter;
pub mod water_film;

pub use liquid_layer::{LiquidModel, LiquidSolver, Liquids, PanSurroundings};
