//! A kitchen whose pan and slices have coarse meshes, for forecasts: the same physics in a few per cent of the time.
//!
//! [`Kitchen::reduced`](crate::Kitchen::reduced) carries the present state over: heat, water and fat of the pieces are
//! conserved ([`saute_food::reduced`]), and so are those of the pan and its liquids; electronics and lid are the same. A [`ReducedKitchen`] takes
//! [`LAPSE_S`] in one step. Its bodies lie still, but in the pan they sink as they grow thinner; a flip lays a piece on its
//! other face, level, after the time that the motion takes. Pieces that are no slices keep their meshes.
//!
//! ```
//! use saute_kitchen::food::Rules;
//! use saute_kitchen::reduced::Reductions;
//! use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};
//!
//! let library = Library::embedded()?;
//! let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(200.0))?;
//! let steak = PieceOrder {
//!     id: "steak".into(),
//!     kind: "beef-lean".into(),
//!     size: [0.080, 0.060, 0.012],
//!     temperature: kelvin(20.0),
//!     seed: 1,
//!     coarseness: 2.0,
//!     rules: Rules::Full,
//!     mesh: MeshSize::Default,
//!     outline: OutlineKind::Plain,
//! };
//! kitchen.add(&library, &steak)?;
//! kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false })?;
//! (0..200).for_each(|_| kitchen.step());
//! let mut ahead = kitchen.reduced(&mut Reductions::default())?;
//! ahead.apply(&Command::Flip { food: "steak".into() })?;
//! (0..120).for_each(|_| ahead.step());
//! let warmer_k = ahead.kitchen().pieces()[0].core() - kitchen.pieces()[0].core();
//! assert!(warmer_k > 5.0, "{warmer_k} K in a minute");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod coarse_pan;
mod laying;
mod reduced_kitchen;
mod reductions;

pub use reduced_kitchen::{LAPSE_S, ReducedKitchen};
pub use reductions::Reductions;
