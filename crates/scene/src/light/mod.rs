//! The light of the room, shadows and the white balance.

pub(crate) mod environment;
pub mod gathered;
pub mod photo;
pub mod room_light;
pub(crate) mod shadow;
pub mod white_balance;
