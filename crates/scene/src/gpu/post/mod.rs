//! What follows the scene at the best level: radiances in half floats are turned into the picture.

mod chain;
mod gathering;
mod kit;
mod lens;

pub(crate) use self::chain::{Chain, bloom_levels};
pub(crate) use self::kit::{AMBIENT_FORMAT, DEPTH, HDR_FORMAT, PostKit};
pub(crate) use self::lens::{LensUniform, sharp_distance};
