//! Forecasts of a running cook: what comes of its present state if one does nothing, turns the piece over, takes it out or
//! lowers the heat.
//!
//! A [`Question`] is an action that one may take now. [`Ahead`] answers it on a coarse mesh, five minutes ahead, in a few
//! thousandths of the time; its [`Band`] states how far from a full cook it may be, from comparisons with full cooks. [`Exact`]
//! answers it with the full model, as far as one lets it run: "as it is" then equals the later state of the kitchen bit for
//! bit. [`Desk`] keeps the answers of one piece fresh: it states when it needs the present kitchen, and works in parts.
//!
//! Nothing here reads a clock: a shell calls [`Desk::advance`] as often as it has time for.

mod ahead;
mod band;
mod desk;
mod exact;
mod outlook;
mod question;

pub use ahead::{Ahead, HORIZON_S};
pub use band::{Band, Bands, BandsError, Confidence, SPANS_S};
pub use desk::{Desk, Foreseen, Wanted};
pub use exact::{EXACT_S, Exact};
pub use outlook::{Outlook, Peak, SAMPLE_S, Sample};
pub use question::{Ask, Question};
