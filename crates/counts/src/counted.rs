//! The one function inside which Callgrind collects.

/// Does the work. Callgrind collects from its entry to its return (`--toggle-collect='*counted*'`), so its name is
/// in the program.
#[inline(never)]
pub fn counted(work: &mut dyn FnMut()) {
    work();
    // Keeps the call above from becoming a jump, after which there would be no return to see.
    std::hint::black_box(());
}
