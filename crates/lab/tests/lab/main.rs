//! What the laboratory and its cases promise, in one program.

mod lab;
mod lab_cook_case;
mod lab_cooking;
mod lab_frying;
mod lab_radiation;
