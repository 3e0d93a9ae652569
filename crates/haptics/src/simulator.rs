//! The simulated SPIDAR as a process of its own.

use std::io::{BufRead, BufReader, Write};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};

use crate::open::{Named, OpenError, Opened};

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

/// Opens a device at its place, or a simulated one where it has none; what is true of a simulated one goes to the file `truth`.
pub fn open_or_simulate(
    named: &Named,
    pairing: u32,
    truth: Option<&Path>,
) -> Result<(Opened, Option<Simulator>), OpenError> {
    if !named.is_simulated() {
        return Ok((named.open(pairing)?, None));
    }
    let simulator = Simulator::start(&named.name, truth)?;
    let opened = named.open_at(simulator.address, simulator.pairing)?;
    Ok((opened, Some(simulator)))
}

impl Simulator {
    /// Starts the program that lies beside this one; what is true goes to the file `truth`.
    pub fn start(device: &str, truth: Option<&Path>) -> Result<Self, OpenError> {
        let program = find()?;
        let failed = |message: String| {
            OpenError::place(program.display(), message, "run it by hand with --help to see whether it works")
        };
        let mut command = Command::new(&program);
        command.args(["--device", device, "--quiet", "--end-with-stdin"]);
        if let Some(truth) = truth {
            command.arg("--truth").arg(truth);
        }
        let mut child = command
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

fn find() -> Result<PathBuf, OpenError> {
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    let own = std::env::current_exe().map_err(|e| {
        OpenError::place(PROGRAM, format!("cannot be looked for: {e}"), "name a device: --device NAME@ADDRESS")
    })?;
    let beside = own.with_file_name(&name);
    if beside.is_file() {
        return Ok(beside);
    }
    Err(OpenError::place(
        beside.display(),
        "the simulator is not there",
        format!(
            "build it: cargo build --release -p {PROGRAM} (./run.sh does), or name a device: --device NAME@ADDRESS"
        ),
    ))
}
