//! Rebuilds the crate when an embedded device file is changed or added.

fn main() {
    println!("cargo::rerun-if-changed=../../data/haptics");
}
