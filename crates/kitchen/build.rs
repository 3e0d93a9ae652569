//! Data and recipes are embedded: a file that is added to their folders must rebuild this crate.

fn main() {
    println!("cargo::rerun-if-changed=../../data");
    println!("cargo::rerun-if-changed=../../recipes");
}
