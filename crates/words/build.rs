//! The texts are embedded: a language that is added to their folder must rebuild this crate.

fn main() {
    println!("cargo::rerun-if-changed=texts");
}
