//! What the kitchen promises, in one program: one is linked sooner than many.

mod advice;
mod allocation;
mod bytes;
mod contact;
mod doneness;
mod door;
mod dynamics;
mod fats;
mod fond;
mod frying;
mod goals;
mod heat_tint;
mod hobs;
mod inside_colour;
mod kitchen;
mod liquids;
mod poured;
mod properties;
mod reduced;
mod ridges;
mod stove;
mod tools;
