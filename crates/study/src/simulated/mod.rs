//! Simulated participants: rule-based cooks in the place of people, for trying a protocol and its analysis before anybody comes.
//!
//! **They are no people and prove nothing about people.** The model is chosen, not measured:
//!
//! - A person misjudges the core at which to take the food out by a habit, drawn once (mean 4 K too hot, standard deviation 6 K), and a
//!   slip, drawn for each cook (5 K); the time of a flip by 25 % of it; the heat of the pan by 30 K; the hob by 150 W.
//! - Practice shrinks all of them by (1 + n)^−a after n cooks: the power law of practice with a = 0.6 where read-outs are shown and 0.35 where
//!   they are hidden; where they are shown the misjudgement also starts at half its size.
//! - At first the food is turned once, halfway; the pause between two flips shrinks with practice towards 45 s.
//! - A cook at a real stove is one more cook of the model with hidden read-outs, slips 1.5 times as large, and a thermometer that errs by 1 K.
//!
//! The cooks themselves are simulated as any other, on the coarse meshes of forecasts.
//!
//! [`SimulatedClass`] does the same for a lesson: students who guess and cook once, on the full meshes, so that a teacher can try how results
//! are collected before the class comes.

mod cook;
mod person;
mod student;

pub use self::cook::CookError;
pub use self::person::Simulation;
pub use self::student::SimulatedClass;
