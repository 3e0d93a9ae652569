//! What is taught while one cooks: the coach's sentences, the alarm at the goal, the callout of the tutorial.

pub mod advice_words;
pub mod callout;
pub mod coach;
