//! `saute haptics list`.

use std::process::ExitCode;

use saute_haptics::workspace::{AXES, WorkspaceReport, report};
use saute_haptics::{Capabilities, Geometry, shelf};
use serde::Serialize;

use crate::error::CliError;
use crate::stdout;

/// `saute haptics list`.
#[derive(Debug, clap::Args)]
pub struct DevicesArgs {
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

/// A device of the list.
#[derive(Debug, Serialize)]
struct Entry {
    id: String,
    capabilities: Capabilities,
    encoder_pitch_um: f64,
    tension_n: [f64; 2],
    preload_n: f64,
    workspace: WorkspaceReport,
}

impl Entry {
    fn new((id, geometry): (String, Geometry)) -> Self {
        Self {
            id,
            capabilities: geometry.capabilities(),
            encoder_pitch_um: geometry.drive.encoder_pitch_um,
            tension_n: [geometry.drive.min_tension_n, geometry.drive.max_tension_n],
            preload_n: geometry.grip.preload_n,
            workspace: report(&geometry),
        }
    }

    fn text(&self) -> String {
        let (c, w) = (&self.capabilities, &self.workspace);
        let half = c.workspace.half_m.map(|m| format!("{:.0}", m * 1e3)).join(" × ");
        let reach = |list: &[f64; 6]| {
            let numbers = list.iter().zip(AXES).map(|(v, axis)| format!("{axis} {v:.2}"));
            numbers.collect::<Vec<_>>().join("  ")
        };
        format!(
            "{}  {}\n    senses {} and moves {} degrees of freedom, {:.0} Hz; {}\n    force up to {} N, torque {} N·m, stiffness {} N/m; workspace ±{half} mm, ±{:.0}°\n    strings {}–{} N, {} µm a count, preload {} N\n    shows at home towards +  {}\n                  towards −  {}   (N, N·m)\n    smallest singular value {:.2} at home, {:.2} over the workspace; {} of {} poses singular\n",
            self.id,
            c.name,
            c.sensed.dof(),
            c.dof_actuated,
            c.rate_hz,
            if c.holds_real_pan { "holds a real pan" } else { "renders the pan too" },
            c.limits.force_n,
            c.limits.torque_nm,
            c.limits.stiffness_n_m,
            c.workspace.tilt_rad.to_degrees(),
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

/// Prints devices and what they can do.
pub fn list(args: &DevicesArgs) -> Result<ExitCode, CliError> {
    let entries: Vec<Entry> = shelf::devices()?.into_iter().map(Entry::new).collect();
    let text = if args.json {
        serde_json::to_string_pretty(&entries)? + "\n"
    } else {
        entries.iter().map(Entry::text).collect()
    };
    stdout::print(&text)?;
    Ok(ExitCode::SUCCESS)
}
