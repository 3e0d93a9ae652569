//! A cook by the words of the window, and one that nobody sees.

mod advice;
mod first_cook;
mod now;
mod unseen;
