//! The goal by which a cook is judged: the one that was chosen by its name, else the class that the goal of the core lies in.

use saute_kitchen::advice::class_goal;
use saute_kitchen::data::goals::GoalDescription;
use saute_kitchen::food::Scale;
use saute_plan::goal::{Goal, Wish};

use crate::app::SauteApp;
use crate::session::Session;
use crate::settings::Settings;

/// Returns the goal of the food that the panels show; none where no scale says anything about it.
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
    let Some(piece) = session.steak() else { return Vec::new() };
    session.library.goals_for(piece.model.description()).map(AsRef::as_ref).collect()
}

/// Goal for the core in a class: the one that its scale states, if that lies in it.
fn usual_goal(scale: &Scale, class: usize) -> f64 {
    let own = scale.goal.filter(|own| scale.class_of(scale.of_nodes(*own)) == class);
    own.unwrap_or_else(|| class_goal(scale, class))
}

impl SauteApp {
    /// Chooses a goal by its id: its scale and the goal of the core follow, so that the advice leads there.
    pub(crate) fn choose_goal(&mut self, id: String) {
        let Some(goal) = self.session.library.goal(&id).cloned() else { return };
        self.settings.goal_id = Some(id);
        if let Some(scale) = &goal.scale {
            self.settings.scale.clone_from(scale);
        }
        let Some(scale) = self.scale() else { return };
        let class = goal.class.as_ref().and_then(|name| scale.class.iter().position(|class| class.name == *name));
        let Some(class) = class else { return };
        if scale.class_of(scale.of_nodes(self.settings.goal(&scale))) != class {
            self.settings.set_goal(&scale, usual_goal(&scale, class));
        }
    }

    /// Takes over the goal of a plan: the panels speak of the same scale and of the same class, or of the same core.
    pub(crate) fn aim_at(&mut self, goal: &Goal) {
        self.settings.goal_id = None;
        if let Some(scale) = self.session.library.scale(&goal.scale.id).cloned() {
            if self.scale().is_none_or(|shown| shown.id != scale.id) {
                self.choose_scale(&scale);
            }
            self.settings.set_goal(&scale, usual_goal(&scale, goal.class));
        } else if let Some(scale) = self.scale().filter(|scale| scale.measure() == goal.scale.measure()) {
            self.settings.set_goal(&scale, goal.aim);
        }
    }
}
