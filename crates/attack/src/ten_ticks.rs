//! Ten ticks of a kitchen with a piece in its pan, and what must hold after them.

use std::sync::LazyLock;

use saute_kitchen::food::{MeshSize, OutlineKind, Rules};
use saute_kitchen::{Command, Kitchen, Library, PieceOrder, kelvin};

use crate::kitchen_files::LIBRARY;

/// Ticks that a kitchen advances [-].
const TICKS: usize = 10;
/// Power of the hob [W].
const HOB_W: f64 = 1500.0;
/// Temperature of the pan [°C], so that water boils and surfaces brown.
const PAN_C: f64 = 180.0;
/// Spacing of the mesh over the default [-], so that many inputs are tried.
const COARSE: f64 = 3.0;
/// Largest error of the energy balance over the gross exchange [-].
const IMBALANCE: f64 = 1e-9;

/// A shipped pan, hot and empty: built once, since it is not what is attacked.
static HOT: LazyLock<Kitchen> =
    LazyLock::new(|| Kitchen::new(&LIBRARY, "carbon-steel-26", kelvin(PAN_C)).expect("the pan is shipped"));

/// Cooks a piece of a food at its default size in a shipped pan; what cannot be built is refused.
pub fn fry(library: &Library, food: &str) {
    cook(HOT.clone(), library, food, None, MeshSize::Default);
}

/// Cooks a shrimp in a shipped pan or another one, on the mesh of 2013: it is built fast, and is not what is attacked.
pub fn fry_shrimp(library: &Library, pan: Option<&str>, oil: &str) {
    let kitchen = pan.map_or_else(|| Ok(HOT.clone()), |pan| Kitchen::new(library, pan, kelvin(PAN_C)));
    if let Ok(kitchen) = kitchen {
        cook(kitchen, library, "shrimp", Some(oil), MeshSize::Paper2013);
    }
}

fn cook(mut kitchen: Kitchen, library: &Library, food: &str, oil: Option<&str>, mesh: MeshSize) {
    if let Some(oil) = oil {
        let _ = kitchen.apply(&Command::Oil { kind: Some(oil.to_owned()), mass: 0.01 });
    }
    let Some(order) = order(library, food, mesh) else { return };
    if kitchen.add(library, &order).is_err() {
        return;
    }
    let _ = kitchen.apply(&Command::Hob(HOB_W));
    let _ = kitchen.apply(&Command::Put { food: order.id, at: [0.0, 0.0], heap: false });
    (0..TICKS).for_each(|_| kitchen.step());
    check(&kitchen);
}

fn order(library: &Library, food: &str, mesh: MeshSize) -> Option<PieceOrder> {
    let description = library.foods.get(food)?;
    let size = description.form.extent(&description.size.default_mm)?.map(|mm| 1e-3 * mm);
    Some(PieceOrder {
        id: "piece".into(),
        kind: food.into(),
        size,
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: COARSE,
        mesh,
        rules: Rules::Full,
        outline: OutlineKind::Natural,
    })
}

/// Panics if a number of the kitchen is not finite, or its energy does not balance.
pub fn check(kitchen: &Kitchen) {
    let energy = kitchen.energy();
    let gross = energy.hob.abs() + energy.pan_stored.abs() + energy.evaporation.abs() + energy.air.abs();
    assert!(energy.imbalance.abs() <= IMBALANCE * gross.max(1.0), "{energy:?}");
    assert!(kitchen.pan_temperature().is_finite());
    for piece in kitchen.pieces() {
        assert!(piece.core().is_finite() && piece.mass().is_finite(), "{}", piece.id);
    }
}
