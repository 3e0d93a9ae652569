//! Promise: a piece that becomes non-finite is restored and frozen without a trace in pan, air or ledger.

// A failed unwrap in a test reports its line.
#![allow(clippy::unwrap_used)]

use saute_food::{MeshSize, OutlineKind, Rules};

use crate::piece::piece_state::Piece;
use crate::{Command, Kitchen, Library, PieceOrder, kelvin};

/// Largest imbalance of the ledger over the gross exchange [-].
const CLOSED: f64 = 1e-9;

fn order(id: &str, kind: &str, size: [f64; 3]) -> PieceOrder {
    PieceOrder {
        id: id.into(),
        kind: kind.into(),
        size: size.map(|mm| 1e-3 * mm),
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 2.0,
        mesh: MeshSize::Default,
        rules: Rules::Full,
        outline: OutlineKind::Plain,
    }
}

/// A hot pan with a steak in a little water, a second one on top of it, under a lid.
fn busy_kitchen() -> Kitchen {
    let library = Library::embedded().unwrap();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(200.0)).unwrap();
    kitchen.add(&library, &order("below", "beef-marbled", [70.0, 60.0, 20.0])).unwrap();
    kitchen.add(&library, &order("above", "beef-lean", [50.0, 40.0, 15.0])).unwrap();
    kitchen.apply(&Command::Hob(1500.0)).unwrap();
    for (food, heap) in [("below", false), ("above", true)] {
        kitchen.apply(&Command::Put { food: food.into(), at: [0.0, 0.0], heap }).unwrap();
        (0..100).for_each(|_| kitchen.step());
    }
    kitchen.apply(&Command::Water(0.1)).unwrap();
    (0..50).for_each(|_| kitchen.step());
    kitchen
}

fn imbalance(kitchen: &Kitchen) -> f64 {
    let e = kitchen.energy();
    let moved = e.hob.abs() + e.pan_stored.abs() + e.evaporation.abs() + e.air.abs() + e.other.abs();
    e.imbalance.abs() / moved.max(1.0)
}

/// Spoils a value that the state keeps. (Lost juice is found again: it is limited by the water of its node.)
fn spoil(piece: &mut Piece, field: usize) {
    let state = &mut piece.state;
    let fields = [&mut state.enthalpy, &mut state.temperature, &mut state.water, &mut state.fat];
    fields[field][3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][field % 3];
}

#[test]
fn the_ledger_stays_closed_whatever_value_of_a_piece_is_lost_and_when() {
    let kitchen = busy_kitchen();
    assert!(imbalance(&kitchen) < CLOSED, "{:e}", imbalance(&kitchen));
    assert!(!kitchen.touching.is_empty(), "the steaks touch");
    for field in 0..4 {
        for (piece, ticks) in [(0, field), (1, 3 - field)] {
            let mut kitchen = kitchen.clone();
            (0..ticks).for_each(|_| kitchen.step());
            spoil(&mut kitchen.pieces[piece], field);
            // The next refresh finds a lost fat, the next tick a lost heat.
            (0..6).for_each(|_| kitchen.step());
            let frozen = kitchen.pieces[piece].state.clone();
            assert!(!frozen.healthy && frozen.total_enthalpy().is_finite(), "{field} {piece}");
            (0..200).for_each(|_| kitchen.step());
            // Without the fields, which fill a screen.
            assert!(kitchen.pieces[piece].state == frozen, "{field} {piece}");
            assert!(kitchen.pieces[1 - piece].state.healthy);
            assert!(imbalance(&kitchen) < CLOSED, "{field} {piece}: {:e}", imbalance(&kitchen));
        }
    }
}
