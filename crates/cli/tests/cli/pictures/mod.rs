//! `saute shot` and `saute gallery`.

mod gallery;
mod looks;
mod series;
