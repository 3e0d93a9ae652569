//! What the driver of string devices promises: poses, tensions, calibration, protocol, and what a hand feels.

// A test that unwraps in vain says where.
#![allow(clippy::unwrap_used)]

mod bench_device;
mod calibration;
mod chromium;
mod control_loop;
mod degrade;
mod driver;
mod feel;
mod geometry_file;
mod hands;
mod haply;
mod inverse_service;
mod kept_calibration;
mod kitchen;
mod osc;
mod passivity;
mod phone;
mod phone_client;
mod phone_page;
mod pose;
mod random;
mod slow_phones;
mod tension;
mod wire;
