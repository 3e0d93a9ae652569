//! `saute` and `saute open`: the window.

use std::process::ExitCode;

use saute_kitchen::Recipe;

use crate::error::CliError;
use crate::shelf::Shelf;

/// Opens the window, playing a recipe if one is given.
pub fn open(_shelf: &Shelf, _recipe: Option<Recipe>) -> Result<ExitCode, CliError> {
    if !has_display() {
        return Err(CliError::NoDisplay(NO_DISPLAY.to_owned()));
    }
    Err(CliError::NoDisplay("the window is not built yet".to_owned()))
}

const NO_DISPLAY: &str = "there is no display; without one you can use\n  \
    saute cook RECIPE.toml                            to cook and read the numbers\n  \
    saute shot RECIPE.toml --at 300 --out steak.png   to draw a picture";

/// Whether a window can be shown. Only X11 and Wayland systems can tell before trying.
fn has_display() -> bool {
    if !cfg!(all(unix, not(target_os = "macos"))) {
        return true;
    }
    ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"].iter().any(|key| std::env::var_os(key).is_some_and(|v| !v.is_empty()))
}
