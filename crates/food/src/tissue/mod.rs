//! The natural variation inside a piece: marbling, a second tissue, and the seeded noise that places them.

mod fat_cap;
pub mod marbling;
pub mod marbling_volume;
mod node_means;
mod node_tissue;
pub mod noise;
mod seam_blocks;
pub mod second_tissue;

pub use marbling_volume::MarblingVolume;
pub use second_tissue::TissueField;

pub(crate) use node_tissue::NodeTissue;
