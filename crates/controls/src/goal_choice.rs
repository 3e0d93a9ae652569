//! The goal by which a cook is judged: the one that was chosen by its name, else the class that the goal of the core is in.

use crate::session::Session;
use crate::settings::Settings;
use saute_kitchen::data::goals::GoalDescription;
use saute_plan::goal::{Goal, Wish};

/// Returns the goal of the food that the panels show; none where no scale covers it.
pub fn goal_of(session: &Session, settings: &Settings) -> Option<Goal> {
    if let Some(named) = named_goal(session, settings) {
        let scale = match &named.scale {
            Some(id) => session.library.scale(id)?.clone(),
            None => session.scale(&settings.scale)?,
        };
        if let Ok(goal) = Goal::described(named, &scale) {
            return Some(goal);
        }
    }
    let scale = session.scale(&settings.scale)?;
    let class = scale.class.get(scale.class_of(scale.of_nodes(settings.goal(&scale))))?.name.clone();
    let is_of_class = |goal: &&GoalDescription| goal.core_counts && goal.class.as_ref() == Some(&class);
    let described = goals_for(session).into_iter().filter(|goal| goal.is_on(&scale)).find(is_of_class);
    match described {
        Some(described) => Goal::described(described, &scale).ok(),
        None => Goal::new(&Wish::Class(class), &scale, 0.0).ok(),
    }
}

/// Returns the goal that was chosen by its name, if it fits the food that the panels show.
pub fn named_goal<'a>(session: &'a Session, settings: &Settings) -> Option<&'a GoalDescription> {
    let id = settings.goal_id.as_deref()?;
    goals_for(session).into_iter().find(|goal| goal.id == id)
}

/// Returns the goals that fit the food that the panels show.
pub fn goals_for(session: &Session) -> Vec<&GoalDescription> {
    let Some(piece) = session.shown_piece() else { return Vec::new() };
    session.library.goals_for(piece.model.description()).map(AsRef::as_ref).collect()
}
