//! `report.html`.
use saute_kitchen::{Cook, Summary};
use crate::section_files::Snapshot;
/// html
pub fn html(_cook: &Cook, _summary: &Summary, _snapshots: &[Snapshot]) -> String { String::new() }
