//! Shipped.
#![allow(missing_docs, clippy::unwrap_used)]
use saute_kitchen::Library;
use saute_plan::goal::*;
use saute_recipe::{Action, Cook, Recipe};

fn main() {
    let library = Library::embedded().unwrap();
    for (id, scale, target, crust) in [
        ("rare", "chefs", "rare", 60.0),
        ("medium", "chefs", "medium", 60.0),
        ("flip-every-30-s", "chefs", "medium", 60.0),
        ("well-done", "chefs", "well-done", 60.0),
        ("grill-pan-steak", "chefs", "medium-rare", 60.0),
        ("shrimp", "shrimp", "opaque", 0.0),
    ] {
        let recipe = Recipe::parse(&library.recipes[id], id, &library).unwrap();
        let goal = Goal::new(&target.parse().unwrap(), library.scale(scale).unwrap(), crust).unwrap();
        let mut cook = Cook::new(recipe, &library).unwrap();
        let masses: Vec<f64> = cook.kitchen.pieces().iter().map(|p| p.mass()).collect();
        while cook.stopped().is_none() {
            cook.advance().unwrap();
        }
        let o = Outcome::read(&cook.kitchen, &masses, &goal);
        let flips =
            cook.steps.iter().filter(|s| matches!(s.action, Action::Each(_, saute_recipe::FoodAction::Flip))).count();
        let s = cook.summary(0.0);
        println!(
            "{id} {target}: score {} flips {flips} smoked {:.3} g events {:?} pan {:?} {:?}",
            Score::of(&o, flips, &goal),
            s.liquids_g.smoked,
            s.events.iter().map(|e| (e.kind, e.count)).collect::<Vec<_>>(),
            s.pan_c,
            o
        );
        for s in cook.steps.iter() {
            print!(" {}@{}", s.action.words(), s.time_s);
        }
        println!();
    }
}
