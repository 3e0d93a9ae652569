//! The natural variation inside a piece: marbling, a second tissue, and the seeded noise that places them.

pub mod marbling;
pub mod marbling_volume;
pub(crate) mod node_means;
pub mod noise;
pub mod second_tissue;

pub use marbling_volume::MarblingVolume;
pub use second_tissue::TissueField;
