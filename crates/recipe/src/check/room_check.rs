//! Checks that there is room for the pieces of a recipe, in memory and in the pan, before one of them is built.

use saute_kitchen::kitchen::PieceOrder;
use saute_kitchen::piece::memory::{Load, NoRoom};

use crate::action::{Action, FoodAction};
use crate::check::recipe_check::{Check, Checked};
use crate::file::recipe_file::FoodEntry;
use crate::recipe::{ALL, Step, Target};

/// Least share of the rectangle around a piece that it covers [-] (chosen: below that of an ellipse, π/4, for natural outlines and
/// tapering shrimps; what it lets pass is found when the pieces are laid out).
const LEAST_COVER: f64 = 0.4;

impl Check<'_> {
    /// Refuses pieces that need more memory than a kitchen has in addition to those before.
    pub(super) fn check_memory(
        &self,
        load: &mut Load,
        entry: &FoodEntry,
        one: &PieceOrder,
        count: Option<u64>,
    ) -> Checked<()> {
        let food = &self.library.foods[&one.kind];
        // What else is wrong with a piece is reported where it is built.
        let Err(NoRoom::TooMuch { excess, .. }) = load.add(&one.id, &one.spec(), food, count.unwrap_or(1) as usize)
        else {
            return Ok(());
        };
        let remedy = match excess.fit {
            0 => "write fewer or smaller pieces, or a coarser mesh: coarseness = 2".to_owned(),
            fit => format!("write count = {fit}, smaller pieces, or a coarser mesh: coarseness = 2"),
        };
        let at = entry.count.as_ref().map_or(entry.id.span().start, |count| count.span().start);
        self.input.error(at, format!("food \"{}\": {excess}", one.id), remedy)
    }

    /// Refuses a group that has more area than the floor of the pan on which it is laid; `places` are those of the steps in the
    /// text [bytes].
    pub(super) fn check_floor(
        &self,
        pan_kind: &str,
        foods: &[PieceOrder],
        steps: &[Step],
        places: &[usize],
    ) -> Checked<()> {
        let Some(pan) = self.library.pans.get(pan_kind) else { return Ok(()) };
        let radius = 1e-3 * pan.floor.radius_mm;
        let floor = core::f64::consts::PI * radius * radius;
        for (step, at) in steps.iter().zip(places) {
            let Action::Each(target, FoodAction::Put { heap: false, .. }) = &step.action else { continue };
            if let Some(fit) = most_on(floor, target, foods) {
                let (name, all) = (&target.name, target.foods.len());
                let message =
                    format!("not all of \"{name}\" find room on the floor of the pan: at most {fit} of {all} fit");
                let heap = format!("write put = {{ food = \"{name}\", heap = true }} to drop them onto each other");
                return self.input.error(*at, message, format!("choose fewer or smaller pieces, or {heap}"));
            }
        }
        Ok(())
    }
}

/// Returns how many pieces of a group have room by their area on a floor [m²]; none if all have.
fn most_on(floor: f64, target: &Target, foods: &[PieceOrder]) -> Option<usize> {
    let one = foods.iter().find(|food| target.foods.first() == Some(&food.id))?;
    let fit = floor / (LEAST_COVER * one.size[0] * one.size[1]);
    (target.group && target.name != ALL && target.foods.len() as f64 > fit).then_some(fit as usize)
}
