//! `saute` and `saute open`: the window.

use std::process::ExitCode;
use std::sync::Arc;

use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_window::Start;
use saute_window::hand::HandsStart;

use crate::args::HandArgs;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::session_source::Source;

/// Opens the window, and plays a recipe or goes on with a session if there is one.
pub fn run(data: DataLibrary, source: Option<Source>, hands: HandArgs) -> Result<ExitCode, CliError> {
    // The window states doneness in the words of a scale.
    data.scales(DEFAULT_SCALE)?;
    for device in [&hands.device, &hands.turner].into_iter().flatten() {
        saute_haptics::Named::parse(device)?;
    }
    if !has_display() {
        return Err(CliError::NoDisplay(NO_DISPLAY.to_owned()));
    }
    let HandArgs { device, turner, pairing, calibration } = hands;
    let hands = HandsStart { pan: device, turner, pairing, calibration };
    let (recipe, recorded) = match source {
        Some(Source::Recipe(recipe)) => (Some(recipe), None),
        Some(Source::Session(recording)) => (None, Some(*recording)),
        None => (None, None),
    };
    let start =
        Start { library: Some(Arc::new(data.library)), recipe, recorded, hands, threads: true, ..Start::default() };
    saute_window::window::run(start)
        .map_err(|e| CliError::NoDisplay(format!("the window cannot be opened: {e}\n{NO_DISPLAY}")))?;
    Ok(ExitCode::SUCCESS)
}

const NO_DISPLAY: &str = "there is no display; commands that need none:\n  \
    saute cook RECIPE.toml                            cook and print the numbers\n  \
    saute shot RECIPE.toml --at 300 --out steak.png   render a picture";

/// Returns false if the environment names no display. Only X11 and Wayland systems can be asked.
fn has_display() -> bool {
    if !cfg!(all(unix, not(target_os = "macos"))) {
        return true;
    }
    ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"]
        .iter()
        .any(|key| std::env::var_os(key).is_some_and(|v| !v.is_empty()))
}
