//! Carries out what is done about the kitchen at home.

use super::AtHomeAct;
use crate::act::Card;
use crate::app::SauteApp;
use saute_session::at_home::kept::KeptKitchen;
use saute_session::at_home::why_not::WhyNot;
use saute_session::export::Export;
use saute_session::plan::live::Live;
use saute_session::work::Kind;
use std::sync::Arc;

/// Scale in whose classes what was seen on the cut is stated.
pub const SCALE: &str = "chefs";
