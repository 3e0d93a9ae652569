//! `saute completions` and `saute man`: completions and manual page of the command, made from its arguments.

use std::process::ExitCode;

use clap::CommandFactory;
use clap_complete::Shell;

use crate::args::Args;
use crate::error::CliError;
use crate::output::stdout;

/// Prints the completions of a shell.
pub fn completions(shell: Shell) -> Result<ExitCode, CliError> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "saute", &mut script);
    stdout::print(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}

/// Prints the manual page of the command, or of the one with these names below it.
pub fn page(names: &[String]) -> Result<ExitCode, CliError> {
    let mut command = Args::command();
    command.build();
    for name in names {
        let Some(found) = command.find_subcommand(name) else {
            let known: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
            let remedy = format!("name one of: {}", known.join(", "));
            return Err(CliError::place(format!("saute man {}", names.join(" ")), "there is no such command", remedy));
        };
        command = found.clone();
    }
    let title = ["saute"].into_iter().chain(names.iter().map(String::as_str)).collect::<Vec<_>>().join("-");
    let mut roff = Vec::new();
    let written = clap_mangen::Man::new(command).title(title.to_uppercase()).render(&mut roff);
    written
        .map_err(|e| CliError::place("the manual page", e.to_string(), "report this as a mistake of the program"))?;
    stdout::print(&String::from_utf8_lossy(&roff))?;
    Ok(ExitCode::SUCCESS)
}
