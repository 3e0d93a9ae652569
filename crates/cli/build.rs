//! The cooks of the looks are embedded: a file that is added to their folder must rebuild this crate.

fn main() {
    println!("cargo::rerun-if-changed=../../gallery/looks");
}
