//! The simulated SPIDAR, run as a separate process.

use std::io::{BufRead, BufReader, Write};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use crate::open::{Named, OpenError, Opened};

/// Name of the simulator's program, without the platform's suffix.
const PROGRAM: &str = "saute-spidar-sim";

/// Timeout for the simulator's first lines (chosen: many times the start from a slow disk).
const START_TIMEOUT: Duration = Duration::from_secs(5);
/// Number of lines that it prints at its start.
const LINES: usize = 3;

/// A running simulator; dropping it ends the process.
#[derive(Debug)]
pub struct Simulator {
    child: Child,
    orders: Option<ChildStdin>,
    /// Address that it serves on.
    pub address: SocketAddr,
    /// Pairing code.
    pub pairing: u32,
}

/// Opens a device at its place, or simulates it if it has none; the simulator writes its true state to the file `truth`.
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
    /// Starts the simulator program from the folder of this program; it writes its true state to the file `truth`.
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
        let lines = first_lines(&mut child, START_TIMEOUT);
        let after = |words: &str| lines.iter().find_map(|l| l.strip_prefix(words));
        let address = after("listening on ").and_then(|a| a.parse().ok());
        let pairing = after("pairing code ").and_then(|c| c.parse().ok());
        let (Some(address), Some(pairing)) = (address, pairing) else {
            let _ = child.kill();
            let _ = child.wait();
            return Err(failed("did not print its address".into()));
        };
        Ok(Self { child, orders, address, pairing })
    }

    /// Sends an order, such as a fault to simulate.
    pub fn order(&mut self, words: &str) {
        if let Some(orders) = &mut self.orders {
            // A simulator that has ended is detected by the silence that follows.
            let _ = writeln!(orders, "{words}");
        }
    }

    /// Ends the simulator after it has written its files.
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

/// Returns the first lines of a program's output; fewer after a timeout, and the program then still runs.
fn first_lines(child: &mut Child, timeout: Duration) -> Vec<String> {
    let (sender, receiver) = mpsc::channel();
    if let Some(out) = child.stdout.take() {
        let read = move || {
            let lines = BufReader::new(out).lines().map_while(Result::ok).take(LINES);
            // Lines after the timeout have no receiver.
            lines.map(|line| sender.send(line)).take_while(Result::is_ok).for_each(drop);
        };
        // Without a thread no line arrives, and the program is ended.
        let _ = std::thread::Builder::new().name("simulator's lines".into()).spawn(read);
    }
    let until = Instant::now() + timeout;
    std::iter::from_fn(|| receiver.recv_timeout(until.saturating_duration_since(Instant::now())).ok())
        .take(LINES)
        .collect()
}

fn find() -> Result<PathBuf, OpenError> {
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    let own = std::env::current_exe().map_err(|e| {
        OpenError::place(PROGRAM, format!("cannot be searched for: {e}"), "name a device: --device NAME@ADDRESS")
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

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_prints_nothing_or_too_little_is_not_waited_for() {
        for (script, lines) in [("sleep 20", 0), ("echo one; sleep 20", 1), ("echo one; echo two; echo three; cat", 3)]
        {
            let mut command = Command::new("sh");
            command.args(["-c", script]).stdin(Stdio::piped()).stdout(Stdio::piped());
            let mut child = command.spawn().expect("a shell");
            let begun = Instant::now();
            let printed = first_lines(&mut child, Duration::from_millis(500));
            child.kill().expect("it runs");
            child.wait().expect("it ended");
            assert!(printed.len() == lines && begun.elapsed() < Duration::from_secs(5), "{script}: {printed:?}");
        }
    }
}
