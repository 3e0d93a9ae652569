//! The Python package `saute`: its compiled part. What has no need of Rust (frames, environments) is Python, in `python/saute`.
//!
//! It is a member of the workspace, so that the tests build everything once: apart, with its own lock, all dependencies down
//! to the graphics would be built a second time. It needs no development files of Python: the library leaves Python's symbols
//! open for the interpreter that loads it. A test program could not, so that there is none; the tests are in `python/tests`.

#[cfg(not(test))]
mod package;
