//! A cook by what the window says, and one that nobody sees.

mod advice;
mod first_cook;
mod now;
mod unseen;
