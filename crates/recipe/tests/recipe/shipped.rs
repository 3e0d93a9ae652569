//! Promise: the shipped recipes fire their steps when they did before conditions had sides: no bare temperature is passed when
//! its step is reached, and each fires at the tick at which it is crossed.

// A test that unwraps in vain states where.
#![allow(clippy::unwrap_used)]

use saute_fixtures::campaign;
use saute_kitchen::Library;
use saute_recipe::{Condition, Cook, Recipe, StoppedBy, Trigger};

/// Differences below this are rounding errors [K, kg].
const SAME_VALUE: f64 = 1e-7;

/// Pieces of a recipe that ./test.sh cooks.
const MOST_PIECES: usize = 2;

/// The old rule: a condition fires once each of its quantities has been on the side on which they did not all start.
struct Crossing {
    above: Vec<bool>,
    below: Vec<bool>,
    started_above: bool,
    started_below: bool,
}

impl Crossing {
    fn new(d: &[f64]) -> Self {
        Self {
            above: vec![false; d.len()],
            below: vec![false; d.len()],
            started_above: d.iter().all(|d| *d >= SAME_VALUE),
            started_below: d.iter().all(|d| *d <= -SAME_VALUE),
        }
    }

    fn update(&mut self, d: &[f64]) -> bool {
        for (i, d) in d.iter().enumerate() {
            self.above[i] |= *d > -SAME_VALUE;
            self.below[i] |= *d < SAME_VALUE;
        }
        let all = |side: &[bool]| side.iter().all(|reached| *reached);
        (!self.started_above && all(&self.above)) || (!self.started_below && all(&self.below))
    }
}

/// Differences of a condition's quantities from its value [K, kg].
fn differences(condition: &Condition, cook: &Cook) -> Vec<f64> {
    condition.values(&cook.kitchen).iter().map(|v| v - condition.value).collect()
}

/// The condition of the step for which a cook waits now, if it looks at it.
fn looked_at(cook: &Cook) -> Option<(usize, Condition)> {
    let step = cook.runner.waiting_step();
    let ready = !cook.kitchen.busy() && cook.kitchen.time_s() > cook.runner.ready_at_s() - 1e-6;
    match &cook.runner.recipe().steps.get(step)?.trigger {
        Trigger::When(condition) if ready && cook.stopped().is_none() => Some((step, condition.clone())),
        _ => None,
    }
}

/// Cooks a recipe on a coarse mesh with both rules; returns the number of conditions that fired.
fn both_rules(id: &str, text: &str, library: &Library) -> usize {
    let mut recipe = Recipe::parse(text, id, library).unwrap();
    recipe.foods.iter_mut().for_each(|food| food.coarseness = 2.5);
    let mut cook = Cook::new(recipe, library).unwrap();
    let (mut armed, mut fired): (Option<(usize, Condition, Crossing)>, usize) = (None, 0);
    while cook.stopped().is_none() {
        cook.fire().unwrap();
        if let Some((step, condition, mut old)) = armed.take() {
            let goes_on = cook.runner.waiting_step() > step || cook.stopped() == Some(StoppedBy::End);
            assert_eq!(old.update(&differences(&condition, &cook)), goes_on, "{id}: step {}", step + 1);
            fired += usize::from(goes_on);
            armed = (!goes_on).then_some((step, condition, old));
        }
        if armed.is_none()
            && let Some((step, condition)) = looked_at(&cook)
        {
            let now = differences(&condition, &cook);
            let mut old = Crossing::new(&now);
            assert!(!old.update(&now), "{id}: step {} does not wait", step + 1);
            assert!(!old.started_above, "{id}: step {} is passed when it is reached", step + 1);
            armed = Some((step, condition, old));
        }
        cook.tick();
    }
    assert_eq!(cook.stopped(), Some(StoppedBy::End), "{id}: {}", cook.runner.waiting_for());
    assert!(cook.runner.warnings().is_empty(), "{id}: {:?}", cook.runner.warnings());
    let conditions = cook.runner.recipe().steps.iter().filter(|s| matches!(s.trigger, Trigger::When(_)));
    assert_eq!(fired, conditions.count(), "{id}: every condition was compared");
    fired
}

/// Dishes of many pieces take most of the time: they are cooked in the campaign.
#[test]
fn the_shipped_recipes_fire_at_the_same_steps_as_before() {
    let library = Library::embedded().unwrap();
    let is_cooked = |text: &str, id: &str| {
        campaign::runs() || Recipe::parse(text, id, &library).unwrap().foods.len() <= MOST_PIECES
    };
    let chosen: Vec<_> = library.recipes.iter().filter(|(id, text)| is_cooked(text, id)).collect();
    let fired: usize = chosen.iter().map(|(id, text)| both_rules(id, text, &library)).sum();
    let [recipes, conditions] = if campaign::runs() { [7, 12] } else { [5, 8] };
    assert!(chosen.len() >= recipes && fired >= conditions, "{} recipes, {fired} conditions", chosen.len());
}
