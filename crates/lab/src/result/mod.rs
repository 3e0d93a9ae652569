//! Results of a run: probe series, the report, and verdicts on expectations.

pub mod evidence;
pub mod recording;
pub mod report;
pub mod verdict;
