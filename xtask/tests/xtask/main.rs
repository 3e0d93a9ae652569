//! What the program behind `./test.sh` promises, in one program of tests: one is linked sooner than two.

mod ceilings;
mod lanes;
