//! The frying-pan simulator as a web page. A page's script makes a [`page::Page`] and starts it on a canvas; elsewhere than
//! in a browser the crate is empty.
#![cfg(target_arch = "wasm32")]

mod backend;
pub mod job_executor;
mod led;
mod options;
pub mod page;
mod shared_app;
mod stats;
