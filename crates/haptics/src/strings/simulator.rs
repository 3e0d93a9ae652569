//! The simulated SPIDAR as a process of its own.

use std::io::{BufRead, BufReader, Write};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use crate::open::{Named, OpenError, Opened};

/// Name of its program, without the system's ending.
const PROGRAM: &str = "saute-spidar-sim";

/// How long it may take to say where it listens (chosen: a slow disk's start, many times over).
const PATIENCE: Duration = Duration::from_secs(5);
/// Lines that it says at its start.
const LINES: usize = 3;

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
        let said = first_lines(&mut child, PATIENCE);
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

/// What a program says first; less where it takes too long, and then it still runs.
fn first_lines(child: &mut Child, patience: Duration) -> Vec<String> {
    let (says, hears) = mpsc::channel();
    if let Some(out) = child.stdout.take() {
        let read = move || {
            let lines = BufReader::new(out).lines().map_while(Result::ok).take(LINES);
            // Nobody hears any more what comes too late.
            lines.map(|line| says.send(line)).take_while(Result::is_ok).for_each(drop);
        };
        // Without a thread nothing is heard, and the program is ended.
        let _ = std::thread::Builder::new().name("simulator's lines".into()).spawn(read);
    }
    let until = Instant::now() + patience;
    std::iter::from_fn(|| hears.recv_timeout(until.saturating_duration_since(Instant::now())).ok())
        .take(LINES)
        .collect()
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

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_says_nothing_or_too_little_is_not_waited_for() {
        for (script, lines) in [("sleep 20", 0), ("echo one; sleep 20", 1), ("echo one; echo two; echo three; cat", 3)]
        {
            let mut command = Command::new("sh");
            command.args(["-c", script]).stdin(Stdio::piped()).stdout(Stdio::piped());
            let mut child = command.spawn().expect("a shell");
            let begun = Instant::now();
            let said = first_lines(&mut child, Duration::from_millis(500));
            child.kill().expect("it runs");
            child.wait().expect("it ended");
            assert!(said.len() == lines && begun.elapsed() < Duration::from_secs(5), "{script}: {said:?}");
        }
    }
}
