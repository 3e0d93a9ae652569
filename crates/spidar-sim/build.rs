//! Devices are embedded: a file that is changed or added must rebuild this crate.

fn main() {
    println!("cargo::rerun-if-changed=../../data/haptics");
}
