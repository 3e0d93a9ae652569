//! Promise: a kitchen in steady state steps without allocating.

use saute_kitchen::Library;
use saute_recipe::{Action, Recipe};

#[test]
fn a_step_in_steady_state_allocates_nothing() {
    let library = Library::embedded().expect("embedded data");
    let recipe = Recipe::parse(&library.recipes["medium"], "medium.toml", &library).expect("recipe");
    let mut kitchen = recipe.kitchen(&library).expect("kitchen");
    for step in recipe.steps.iter().take(3) {
        let Action::Pan(action) = &step.action else { continue };
        kitchen.apply(&action.command()).expect("applies");
    }
    (0..1200).for_each(|_| kitchen.step());
    let info = allocation_counter::measure(|| (0..600).for_each(|_| kitchen.step()));
    assert_eq!(info.count_total, 0, "{} bytes", info.bytes_total);
}
