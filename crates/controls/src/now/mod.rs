//! The Now line in words: what to do at once, why, and how long it takes.

pub mod advice_words;
pub mod now_memory;
pub mod now_state;
pub mod now_words;
pub mod time_left;
