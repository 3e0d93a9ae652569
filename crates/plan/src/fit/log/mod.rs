//! Logs of thermometers, as their makers' programs, loggers, phones and spreadsheets write them.
//!
//! A log is read in steps: bytes to text (`decode`), text to a table below whatever preamble it has (`table`), the columns' roles by
//! their headers (`roles`) or a maker's preset (`logger`), times by the whole column (`times`), units by what states them
//! (`unit`). What is not stated is assumed where only one reading makes sense, and reported; where two do, the log is refused with both
//! (`log_error`).

mod clock_words;
mod decode;
mod header_words;
pub mod log_error;
pub mod log_file;
pub mod logger;
mod long_table;
mod moment;
mod plausible;
pub mod reading;
mod roles;
mod stamp;
mod table;
pub mod times;
pub mod unit;
mod values;
