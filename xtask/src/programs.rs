//! The test programs of the workspace, as cargo has built them.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::Deserialize;

use crate::error::TaskError;

/// A test program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TestProgram {
    /// Package and target, as in `saute-heat exact`; unit tests have the name of their library or program.
    pub name: String,
    /// The package.
    pub package: String,
    /// Folder of the package, in which its tests run.
    pub folder: PathBuf,
    /// The program.
    pub executable: PathBuf,
}

/// A message of cargo, as far as it is needed.
#[derive(Deserialize)]
struct Message {
    #[serde(default)]
    executable: Option<PathBuf>,
    #[serde(default)]
    manifest_path: PathBuf,
    profile: Option<Profile>,
    target: Option<Target>,
}

#[derive(Deserialize)]
struct Profile {
    test: bool,
}

#[derive(Deserialize)]
struct Target {
    name: String,
    kind: Vec<String>,
}

/// Builds what is not built yet, and returns all test programs.
///
/// # Errors
///
/// If the build fails.
pub fn built() -> Result<Vec<TestProgram>, TaskError> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["test", "--release", "--workspace", "--no-run", "--quiet", "--message-format=json"]);
    let output = cargo.stderr(Stdio::inherit()).output();
    let output = output.map_err(|source| TaskError::Start { program: "cargo".to_owned(), source })?;
    if !output.status.success() {
        return Err(TaskError::Failed("the tests are not built".to_owned()));
    }
    Ok(in_messages(&String::from_utf8_lossy(&output.stdout)))
}

/// Returns the test programs in cargo's messages.
fn in_messages(messages: &str) -> Vec<TestProgram> {
    messages.lines().filter_map(|line| serde_json::from_str(line).ok().and_then(program)).collect()
}

fn program(message: Message) -> Option<TestProgram> {
    let (executable, profile, target) = (message.executable?, message.profile?, message.target?);
    let folder = message.manifest_path.parent()?.to_owned();
    if !profile.test {
        return None;
    }
    let package = package_of(&message.manifest_path)?;
    let is_named = ["test", "bin"].contains(&target.kind.first()?.as_str());
    let name = format!("{package} {}", if is_named { &target.name } else { "lib" });
    Some(TestProgram { name, package, folder, executable })
}

/// The name in a manifest: the first line of its kind.
fn package_of(manifest: &Path) -> Option<String> {
    let text = std::fs::read_to_string(manifest).ok()?;
    let line = text.lines().find(|line| line.starts_with("name = "))?;
    Some(line.split('"').nth(1)?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_test_program_is_known_by_its_message_and_other_messages_are_passed_over() {
        let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
        let message = |test: bool, kind: &str| {
            format!(
                r#"{{"reason":"compiler-artifact","manifest_path":"{manifest}","profile":{{"test":{test}}},
                "target":{{"name":"judging","kind":["{kind}"]}},"executable":"/t/judging-1"}}"#
            )
            .replace('\n', "")
        };
        let messages = [
            message(true, "test"),
            message(false, "bin"),
            message(true, "lib"),
            r#"{"reason":"build-finished","success":true}"#.to_owned(),
        ];
        let found = in_messages(&messages.join("\n"));
        let names: Vec<_> = found.iter().map(|program| program.name.as_str()).collect();
        assert_eq!(names, ["saute-xtask judging", "saute-xtask lib"]);
        assert_eq!(found[0].folder, Path::new(env!("CARGO_MANIFEST_DIR")));
    }
}
