//! Pictures of one cook at several instants.

use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe};

use crate::cut::section::Picture;
use crate::still::headless::Gpu;
use crate::still::shot::{ShotError, ShotOptions, advance_to, cook_to_end, drawn};

/// A cook that is drawn as it goes on.
pub struct Series {
    cook: Cook,
    gpu: Gpu,
    options: ShotOptions,
    size: [u32; 2],
}

impl Series {
    /// Sets up the kitchen of a recipe and a graphics device for pictures of a size [px].
    pub fn new(recipe: Recipe, library: &Library, options: ShotOptions, size: [u32; 2]) -> Result<Self, ShotError> {
        Self::of(Cook::new(recipe, library)?, options, size)
    }

    /// A graphics device for pictures of a cook, or of a session that is played again, of a size [px].
    pub fn of(cook: Cook, options: ShotOptions, size: [u32; 2]) -> Result<Self, ShotError> {
        let gpu = Gpu::open()?;
        Ok(Self { cook, gpu, options, size })
    }

    /// Cooks on to an instant [s], which must not be before the last one, and draws it; none if the recipe ends
    /// earlier.
    pub fn at(&mut self, at_s: f64) -> Result<Option<Picture>, ShotError> {
        if !advance_to(&mut self.cook, at_s)? {
            return Ok(None);
        }
        Ok(Some(drawn(&self.gpu, &self.cook.kitchen, &self.options, self.size, None)))
    }

    /// End of the recipe [s]: it is cooked once more ahead, without pictures.
    ///
    /// # Errors
    ///
    /// If a step fails.
    pub fn end_s(&self) -> Result<f64, ShotError> {
        cook_to_end(&mut self.cook.clone())
    }

    /// The error that an instant past the end of the recipe is [s].
    pub fn past_the_end(&self, at_s: f64) -> ShotError {
        ShotError::past_the_end(&self.cook, at_s)
    }
}
