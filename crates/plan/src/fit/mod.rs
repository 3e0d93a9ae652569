//! A fit of a kitchen at home: hob efficiency, contact with the pan and thickness of the food from a log of temperatures.
//!
//! The cook is simulated with the parameters θ; the fit minimises the weighted squares of the residuals and of the distance
//! from the prior by the Levenberg–Marquardt method, with Jacobians by forward differences:
//!
//! χ²(θ) = Σ c² ln(1 + (r/c)²) + Σ ((θ_k − θ₀_k)/s_k)², r = (predicted(θ) − observed)/σ, c = 5: small residuals count by their squares,
//! those of a probe that was not there hardly. θ stays within what a kitchen at home can state.
//!
//! The covariance is the inverse of JᵀWJ at the minimum, times the mean of w r² where the residuals are larger than their σ. Intervals
//! are the 90 % intervals of a normal distribution of θ: the logarithms of contact and thickness, and ln(η/(1 − η)) of the hob's
//! efficiency η.

pub mod compared;
pub mod curves;
pub mod found;
pub mod levels;
pub mod log;
pub mod observed;
pub mod parameters;
pub mod predict;
pub mod run;
pub mod search;
