//! Closed surfaces and the cells inside them: defects, conservation, and accuracy.

mod bodies;
mod closing;
mod exact;
mod filling;
