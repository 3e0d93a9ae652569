//! Runs the command and keeps its output.

use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Output};

/// Returns the command, ready for arguments.
pub fn saute() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_saute"));
    for display in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(display);
    }
    command
}

/// Exit code and output of one run.
#[derive(Debug)]
pub struct Ran {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl From<Output> for Ran {
    fn from(output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the output is UTF-8");
        Self { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
    }
}

/// Runs the command with arguments.
pub fn run<S: AsRef<OsStr>>(args: &[S]) -> Ran {
    saute().args(args).output().expect("the command starts").into()
}

/// Returns the names of all files in a folder; none if it does not exist.
pub fn names_in(dir: &Path) -> Vec<String> {
    let Ok(entries) = std::fs::read_dir(dir) else {
        return Vec::new();
    };
    let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A steak that is fried for 20 s.
pub const SHORT: &str = r#"title = "Short"
max_s = 100
[pan]
kind = "carbon-steel-26"
initial_c = 180
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 15]
initial_c = 5
[[step]]
hob_w = 1100
[[step]]
put = "steak"
[[step]]
after_s = 10
flip = "steak"
[[step]]
after_s = 10
end = true
"#;
