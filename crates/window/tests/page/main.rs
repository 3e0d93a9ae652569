//! What the tests of the page compare it with: pictures that the window draws, and a cook that it records.

mod cook;
mod stills;
