//! The simulated SPIDAR as a process of its own.

use std::io::{BufRead, BufReader, Write};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};

use crate::error::CliError;

/// Name of its program, without the system's ending.
const PROGRAM: &str = "saute-spidar-sim";

/// A running simulator; it ends with this.
#[derive(Debug)]
pub struct Simulator {
    child: Child,
    orders: Option<ChildStdin>,
    /// Where it listens.
    pub address: SocketAddr,
    /// Its pairing code.
    pub pairing: u32,
}

impl Simulator {
    /// Starts the program that lies beside this one; what is true goes to the file `truth`.
    pub fn start(device: &str, truth: &Path) -> Result<Self, CliError> {
        let program = find()?;
        let failed = |message: String| {
            CliError::place(program.display(), message, "run it by hand with --help to see whether it works")
        };
        let mut child = Command::new(&program)
            .args(["--device", device, "--quiet", "--end-with-stdin", "--truth"])
            .arg(truth)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|e| failed(format!("cannot be started: {e}")))?;
        let orders = child.stdin.take();
        let lines = child.stdout.take().map(|out| BufReader::new(out).lines().map_while(Result::ok).take(3));
        let said: Vec<String> = lines.into_iter().flatten().collect();
        let after = |words: &str| said.iter().find_map(|l| l.strip_prefix(words));
        let address = after("listening on ").and_then(|a| a.parse().ok());
        let pairing = after("pairing code ").and_then(|c| c.parse().ok());
        let (Some(address), Some(pairing)) = (address, pairing) else {
            let _ = child.kill();
            let _ = child.wait();
            return Err(failed("did not say where it listens".into()));
        };
        Ok(Self { child, orders, address, pairing })
    }

    /// Tells it what shall go wrong.
    pub fn order(&mut self, words: &str) {
        if let Some(orders) = &mut self.orders {
            // A simulator that has gone away is seen by the silence that follows.
            let _ = writeln!(orders, "{words}");
        }
    }

    /// Lets it write everything down and end.
    pub fn end(&mut self) {
        self.order("quit");
        self.orders = None;
        let _ = self.child.wait();
    }
}

impl Drop for Simulator {
    fn drop(&mut self) {
        self.end();
    }
}

fn find() -> Result<PathBuf, CliError> {
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    let own = std::env::current_exe().map_err(|e| {
        CliError::place(PROGRAM, format!("cannot be looked for: {e}"), "name a device: --device NAME@ADDRESS")
    })?;
    let beside = own.with_file_name(&name);
    if beside.is_file() {
        return Ok(beside);
    }
    Err(CliError::place(
        beside.display(),
        "the simulator is not there",
        format!(
            "build it: cargo build --release -p {PROGRAM} (./run.sh does), or name a device: --device NAME@ADDRESS"
        ),
    ))
}
