//! What is taught while one cooks: the coach's sentences, the alarm at the goal.

pub mod coach;
