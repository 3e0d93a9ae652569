//! Triangle meshes: props, pan, lid, tools, strings, and the sprites of steam and oil.

pub(crate) mod collar;
pub(crate) mod foot;
pub(crate) mod lid;
pub mod pan;
pub(crate) mod pool;
pub mod props;
pub(crate) mod rest;
pub(crate) mod solid;
pub(crate) mod spatter;
pub(crate) mod stays;
pub(crate) mod steam;
pub(crate) mod stove;
pub mod strings;
pub(crate) mod tool;
