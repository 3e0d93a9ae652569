//! `saute` and `saute open`: the window.

use std::process::ExitCode;
use std::sync::Arc;

use saute_app::Start;
use saute_app::hand::HandsStart;
use saute_recipe::Recipe;

use crate::args::HandArgs;
use crate::error::CliError;
use crate::shelf::Shelf;

/// Opens the window, playing a recipe if one is given.
pub fn open(shelf: &Shelf, recipe: Option<Recipe>, hands: HandArgs) -> Result<ExitCode, CliError> {
    if !has_display() {
        return Err(CliError::NoDisplay(NO_DISPLAY.to_owned()));
    }
    let HandArgs { device, turner, pairing, calibration } = hands;
    let hands = HandsStart { pan: device, turner, pairing, calibration };
    let start = Start { library: Some(Arc::new(shelf.library.clone())), recipe, hands };
    saute_app::window::run(start)
        .map_err(|e| CliError::NoDisplay(format!("the window could not be opened: {e}\n{NO_DISPLAY}")))?;
    Ok(ExitCode::SUCCESS)
}

const NO_DISPLAY: &str = "there is no display; without one you can use\n  \
    saute cook RECIPE.toml                            to cook and read the numbers\n  \
    saute shot RECIPE.toml --at 300 --out steak.png   to draw a picture";

/// Whether a window can be shown. Only X11 and Wayland systems can tell before trying.
fn has_display() -> bool {
    if !cfg!(all(unix, not(target_os = "macos"))) {
        return true;
    }
    ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"]
        .iter()
        .any(|key| std::env::var_os(key).is_some_and(|v| !v.is_empty()))
}
