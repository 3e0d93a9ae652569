//! The session with the hands that a person has here.

use crate::hands::Hands;

/// A cook that goes on, in the hands of the devices of a desktop or of a page.
pub type Session = saute_session::Session<Hands>;
