//! The goal by which a cook is judged: the one that was chosen by its name, else the class that the goal of the core is in.

use crate::app::SauteApp;
use saute_kitchen::advice::class_goal;
use saute_kitchen::food::Scale;
use saute_plan::goal::Goal;

/// Goal for the core in a class: the one that its scale states, if that is in it.
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

    /// Takes over the goal of a plan: the panels show the same scale and the same class, or the same core.
    pub(crate) fn aim_at(&mut self, goal: &Goal) {
        self.settings.goal_id = None;
        if let Some(scale) = self.session.library.scale(&goal.scale.id).cloned() {
            self.settings.scale.clone_from(&scale.id);
            self.settings.set_goal(&scale, usual_goal(&scale, goal.class));
        } else if let Some(scale) = self.scale().filter(|scale| scale.measure() == goal.scale.measure()) {
            self.settings.set_goal(&scale, goal.aim);
        }
    }
}
