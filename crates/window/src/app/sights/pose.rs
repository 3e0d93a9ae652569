//! The window in a stated condition: a recipe at an instant, with view, cut and camera. Pictures of it can be compared.

use crate::app::SauteApp;
use saute_controls::pose::Pose;
use saute_controls::settings::quality_choice::QualityChoice;
use saute_kitchen::TICK_S;
use saute_recipe::Recipe;

impl SauteApp {
    /// Takes a condition on; time is then stopped, and its picture is smoothed at once.
    ///
    /// # Errors
    ///
    /// States what is wrong with the recipe.
    pub fn pose(&mut self, pose: &Pose) -> Result<(), String> {
        self.cook_to(pose)?;
        self.sights.scene.rest.at_once = true;
        self.settings.view = pose.view;
        self.settings.split = pose.split;
        self.settings.panels_hidden = !pose.panels;
        self.set_quality(QualityChoice::Always(pose.quality));
        self.desk.card = None;
        // They come when they are ready; pictures that are compared do not wait for them.
        self.settings.forecasts = false;
        self.sights.camera_preset = (pose.camera + 2) % 3;
        self.next_camera();
        // The eye is where the condition states it, whatever was seen before, and all controls are there.
        (self.sights.looked_for, self.sights.looks_again) = (Some(self.session.generation), false);
        (self.sights.glance, self.sights.stands_back, self.settings.few) = (None, false, false);
        self.sights.slice = None;
        if let Some(place) = pose.cut {
            self.toggle_slice();
            self.sights.slice = Some(place);
        }
        Ok(())
    }

    /// Cooks a condition's recipe to its instant. The cook of the last condition goes on, where it has not come too far.
    fn cook_to(&mut self, pose: &Pose) -> Result<(), String> {
        let library = std::sync::Arc::clone(&self.session.library);
        let text = library.recipes.get(&pose.recipe).unwrap_or(&pose.recipe);
        let recipe = Recipe::parse(text, "pose.toml", &library).map_err(|e| e.to_string())?;
        pose.check(&recipe)?;
        let posed = Some((pose.recipe.clone(), self.session.generation));
        if self.sights.scene.posed != posed || self.session.kitchen.time_s() > pose.at_s + 0.5 * TICK_S {
            self.session.play(recipe).map_err(|e| e.to_string())?;
            self.sights.scene.posed = Some((pose.recipe.clone(), self.session.generation));
        }
        self.session.set_paused(false);
        while self.session.kitchen.time_s() < pose.at_s - 0.5 * TICK_S && !self.session.paused {
            self.session.tick()?;
        }
        self.session.set_paused(true);
        Ok(())
    }
}
