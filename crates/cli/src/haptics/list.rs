//! `saute haptics list`.

use std::process::ExitCode;

use saute_haptics::open::{NETWORKED, Networked};
use saute_haptics::strings::workspace::{AXES, WorkspaceReport, report};
use saute_haptics::{Capabilities, Geometry, Rendering, library};
use serde::Serialize;

use crate::error::CliError;
use crate::output::{json, stdout};

/// `saute haptics list`.
#[derive(Debug, clap::Args)]
pub struct DevicesArgs {
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

/// A device of the list.
#[derive(Debug, Serialize)]
struct ListedDevice {
    id: String,
    capabilities: Capabilities,
    rendering: Rendering,
    /// Default address; none for string devices, which are simulated by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<&'static str>,
    #[serde(flatten)]
    strings: Option<Strings>,
}

/// Properties of string devices only.
#[derive(Debug, Serialize)]
struct Strings {
    encoder_pitch_um: f64,
    tension_n: [f64; 2],
    preload_n: f64,
    workspace: WorkspaceReport,
}

impl Strings {
    fn new(geometry: &Geometry) -> Self {
        Self {
            encoder_pitch_um: geometry.drive.encoder_pitch_um,
            tension_n: [geometry.drive.min_tension_n, geometry.drive.max_tension_n],
            preload_n: geometry.grip.preload_n,
            workspace: report(geometry),
        }
    }

    fn text(&self) -> String {
        let w = &self.workspace;
        let reach = |list: &[f64; 6]| {
            let numbers = list.iter().zip(AXES).map(|(v, axis)| format!("{axis} {v:.2}"));
            numbers.collect::<Vec<_>>().join("  ")
        };
        format!(
            "    strings {}–{} N, {} µm per count, preload {} N\n    shows at home towards +  {}\n                  towards −  {}   (N, N·m)\n    smallest singular value {:.2} at home, {:.2} over the workspace; {} of {} poses singular\n",
            self.tension_n[0],
            self.tension_n[1],
            self.encoder_pitch_um,
            self.preload_n,
            reach(&w.home.plus),
            reach(&w.home.minus),
            w.home_singular_value,
            w.least_singular_value,
            w.singular_poses,
            w.poses,
        )
    }
}

impl ListedDevice {
    fn of_strings((id, geometry): (String, Geometry)) -> Self {
        let capabilities = geometry.capabilities();
        let rendering = capabilities.rendering();
        Self { id, capabilities, rendering, place: None, strings: Some(Strings::new(&geometry)) }
    }

    fn of_network(networked: &Networked) -> Self {
        let capabilities = (networked.capabilities)();
        let rendering = capabilities.rendering();
        Self { id: networked.id.into(), capabilities, rendering, place: Some(networked.default_place), strings: None }
    }

    fn text(&self) -> String {
        let c = &self.capabilities;
        let mut text = format!(
            "{}  {}\n    senses {} and moves {} degrees of freedom, {:.0} Hz; {}\n",
            self.id,
            c.name,
            c.sensed.dof(),
            c.dof_actuated,
            c.rate_hz,
            if c.holds_real_pan { "holds a real pan" } else { "holds no real pan" },
        );
        let half = c.workspace.half_m.map(|m| format!("{:.0}", m * 1e3)).join(" × ");
        let workspace = format!("workspace ±{half} mm, ±{:.0}°", c.workspace.tilt_rad.to_degrees());
        let l = &c.limits;
        text += &match self.rendering {
            Rendering::Wrench => format!(
                "    force up to {} N, torque {} N·m, stiffness {} N/m; {workspace}\n",
                l.force_n, l.torque_nm, l.stiffness_n_m
            ),
            Rendering::Force => format!(
                "    force up to {} N, stiffness {} N/m, torques are shown on the screen; {workspace}\n",
                l.force_n, l.stiffness_n_m
            ),
            Rendering::Rumble => format!("    rumbles, weights are shown on the screen; {workspace}\n"),
            Rendering::SoundAndPicture => format!("    no forces: sound and picture only; {workspace}\n"),
        };
        let at = |p: &str| format!("    at {p} unless @HOST:PORT is given: this machine only\n");
        text += &self.place.map_or_else(String::new, at);
        text + &self.strings.as_ref().map_or_else(String::new, Strings::text)
    }
}

/// Prints the devices and their capabilities.
pub fn list(args: &DevicesArgs) -> Result<ExitCode, CliError> {
    let strings = library::devices()?.into_iter().map(ListedDevice::of_strings);
    let entries: Vec<ListedDevice> = strings.chain(NETWORKED.iter().map(ListedDevice::of_network)).collect();
    let text = if args.json { json::text(&entries)? } else { entries.iter().map(ListedDevice::text).collect() };
    stdout::print(&text)?;
    Ok(ExitCode::SUCCESS)
}
