//! Serves the device on a UDP socket, with orders on stdin.

use std::io::{BufRead, Write};
use std::net::{SocketAddr, UdpSocket};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::{Duration, Instant};

use crate::args::Args;
use crate::codec::FRAME;
use crate::firmware::Device;
use crate::pairing::{self, NoRandom};
use crate::rig_file::{self, RigFileError};
use crate::scene::Making;

/// Read timeout of the socket (chosen: one command interval, the longest delay of strings and stdin).
const READ_TIMEOUT: Duration = Duration::from_millis(1);
/// Interval between two printed states (chosen: readable).
const VIEW: Duration = Duration::from_millis(500);
/// Requested real-time priority (chosen: a microcontroller shares its time with nothing, and the driver's loop has 60).
const PRIORITY: u8 = 50;

/// Why the device cannot be served.
#[derive(Debug, thiserror::Error)]
pub enum ServeError {
    /// Its file cannot be used.
    #[error(transparent)]
    Rig(#[from] RigFileError),
    /// Its address cannot be bound.
    #[error("{0} cannot be served on: {1}\n  remedy: choose a free port, or 127.0.0.1:0 for any")]
    Bind(SocketAddr, std::io::Error),
    /// The file of true states cannot be written.
    #[error("{0} cannot be written: {1}\n  remedy: choose another path for --truth")]
    Truth(String, std::io::Error),
    /// It would be open to the network without a code.
    #[error(
        "--pairing 0 would let anyone on the network pull the strings\n  remedy: give a code, or bind to 127.0.0.1"
    )]
    Open,
    /// A number is out of range.
    #[error(
        "--error-mm {0}, --hand {1}, --noise {2}: out of range\n  remedy: write numbers from 0 to 5, from 0 to 2 and from 0 to 10"
    )]
    Range(f64, f64, f64),
    /// No pairing code could be drawn.
    #[error(transparent)]
    Random(#[from] NoRandom),
}

/// Serves a device until a quit command.
pub fn run(args: &Args) -> Result<(), ServeError> {
    let file = rig_file::load(&args.device)?;
    let in_range = (0.0..=5.0).contains(&args.error_mm) && (0.0..=2.0).contains(&args.hand);
    if !in_range || !(0.0..=10.0).contains(&args.noise) {
        return Err(ServeError::Range(args.error_mm, args.hand, args.noise));
    }
    let pairing = args.pairing.map_or_else(pairing::draw, Ok)?;
    if pairing == 0 && !args.bind.ip().is_loopback() {
        return Err(ServeError::Open);
    }
    let socket = bind(args.bind).map_err(|e| ServeError::Bind(args.bind, e))?;
    let address = socket.local_addr().map_err(|e| ServeError::Bind(args.bind, e))?;
    announce(&address, pairing, &file.name);
    let making = Making { seed: args.seed, error_m: args.error_mm * 1e-3, hand: args.hand, noise: args.noise };
    let mut device = Device::new(&file, &making, pairing, Instant::now());
    let place = args.truth.as_deref().map_or_else(String::new, |p| p.display().to_string());
    device.log_truth(args.truth.as_deref()).map_err(|e| ServeError::Truth(place, e))?;
    ask_for_priority();
    serve(&socket, &mut device, args);
    device.flush();
    Ok(())
}

fn bind(address: SocketAddr) -> std::io::Result<UdpSocket> {
    let socket = UdpSocket::bind(address)?;
    socket.set_read_timeout(Some(READ_TIMEOUT))?;
    Ok(socket)
}

fn serve(socket: &UdpSocket, device: &mut Device, args: &Args) {
    let orders = stdin_orders(args.end_with_stdin);
    let mut viewed = Instant::now();
    let mut bytes = [0; FRAME + 1];
    loop {
        let received = socket.recv_from(&mut bytes).ok();
        let now = Instant::now();
        device.advance(now);
        if let Some((count, from)) = received {
            device.receive(&bytes[..count], from, now);
        }
        while let Some((host, answer)) = device.arrived(now) {
            // The loss of a host does not stop the device.
            let _ = socket.send_to(&answer, host);
        }
        if execute(device, &orders, now) == Executed::Quit {
            return;
        }
        if !args.quiet && viewed.elapsed() > VIEW {
            viewed = now;
            print(&device.view(now));
        }
    }
}

fn announce(address: &SocketAddr, pairing: u32, name: &str) {
    let mut out = std::io::stdout().lock();
    let _ = writeln!(out, "{name}\nlistening on {address}\npairing code {pairing}");
    let _ = out.flush();
    if !address.ip().is_loopback() {
        print("this device can be reached from the network; hosts need the pairing code");
    }
}

fn print(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

fn ask_for_priority() {
    use thread_priority::{RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy};
    if let Ok(priority) = PRIORITY.try_into() {
        // A refusal is no error: the device only has more jitter.
        let _ = thread_priority::set_thread_priority_and_policy(
            thread_priority::thread_native_id(),
            ThreadPriority::Crossplatform(priority),
            ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo),
        );
    }
}

/// Returns the lines of stdin; the channel closes with stdin if that should end the device.
fn stdin_orders(end_with_stdin: bool) -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                return;
            }
        }
        if !end_with_stdin {
            // Keeps the channel open until the process ends.
            loop {
                std::thread::park();
            }
        }
    });
    receive
}

#[derive(Clone, Copy, PartialEq)]
enum Executed {
    Continue,
    Quit,
}

fn execute(device: &mut Device, orders: &Receiver<String>, now: Instant) -> Executed {
    match orders.try_recv() {
        Err(TryRecvError::Empty) => {}
        Err(TryRecvError::Disconnected) => return Executed::Quit,
        Ok(line) => {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                ["quit"] => return Executed::Quit,
                [] => {}
                words if device.order(words, now) => {}
                _ => print(&format!("\"{line}\" is not a command: see --help")),
            }
        }
    }
    Executed::Continue
}
