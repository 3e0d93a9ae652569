//! How fast time may go.

/// Speeds of simulated time over wall time [-].
pub const SPEEDS: [f64; 5] = [1.0, 2.0, 3.0, 5.0, 20.0];

/// Most that is owed, as wall time at the chosen speed [s] (chosen: what a person would not notice while it is caught up).
pub const MOST_OWED_S: f64 = 1.0;
