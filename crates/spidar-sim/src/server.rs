//! The device's firmware: states, watchdog and answers.

use std::io::{BufRead, Write};
use std::net::{SocketAddr, UdpSocket};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::{Duration, Instant};

use crate::Args;
use crate::codec::{self, FRAME, Identity, Reading, Received, Request};
use crate::faults::Faults;
use crate::rig_file::{RigFile, RigFileError};
use crate::scene::Scene;
use crate::truth_log::TruthLog;

/// Watchdog: time without a command after which the device falls back to the minimum tension [ms] (chosen: a hundred commands).
const WATCHDOG_MS: u16 = 100;
/// Read timeout of the socket (chosen: one command interval, the longest delay of strings and stdin).
const READ_TIMEOUT: Duration = Duration::from_millis(1);
/// Interval between two printed states (chosen: readable).
const VIEW: Duration = Duration::from_millis(500);
/// Requested real-time priority (chosen: a microcontroller shares its time with nothing, and the driver's loop has 60).
const PRIORITY: u8 = 50;

/// Why the device cannot be served.
#[derive(Debug, thiserror::Error)]
pub enum ServeError {
    #[error(transparent)]
    Rig(#[from] RigFileError),
    #[error("{0} cannot be served on: {1}\n  remedy: choose a free port, or 127.0.0.1:0 for any")]
    Bind(SocketAddr, std::io::Error),
    #[error("{0} cannot be written: {1}\n  remedy: choose another path for --truth")]
    Truth(String, std::io::Error),
    #[error(
        "--pairing 0 would let anyone on the network pull the strings\n  remedy: give a code, or bind to 127.0.0.1"
    )]
    Open,
    #[error("--error-mm {0} and --hand {1} may be 0 to 5 and 0 to 2")]
    Range(f64, f64),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    Idle,
    Greeted,
    Armed,
    Running,
}

/// The device with its host.
struct Device {
    scene: Scene,
    identity: Identity,
    pairing: u32,
    state: State,
    session: u32,
    sequence: u32,
    obeyed: u32,
    commanded: Instant,
    started: Instant,
    host: Option<SocketAddr>,
    faults: Faults,
    truth: TruthLog,
}

/// Serves until a quit command.
pub fn serve(args: &Args, scene: Scene, file: &RigFile, pairing: u32) -> Result<(), ServeError> {
    if !(0.0..=5.0).contains(&args.error_mm) || !(0.0..=2.0).contains(&args.hand) {
        return Err(ServeError::Range(args.error_mm, args.hand));
    }
    if pairing == 0 && !args.bind.ip().is_loopback() {
        return Err(ServeError::Open);
    }
    let bind = |e| ServeError::Bind(args.bind, e);
    let socket = UdpSocket::bind(args.bind).map_err(bind)?;
    socket.set_read_timeout(Some(READ_TIMEOUT)).map_err(bind)?;
    let address = socket.local_addr().map_err(bind)?;
    announce(&address, pairing, &file.name);
    let place = args.truth.as_deref().map_or_else(String::new, |p| p.display().to_string());
    let truth = TruthLog::create(args.truth.as_deref()).map_err(|e| ServeError::Truth(place, e))?;
    ask_for_priority();
    let mut device = Device::new(scene, file, pairing, args.seed, truth);
    let commands = stdin_commands(args.end_with_stdin);
    let (mut last, mut viewed) = (Instant::now(), Instant::now());
    let mut bytes = [0; FRAME + 1];
    loop {
        let received = socket.recv_from(&mut bytes).ok();
        let now = Instant::now();
        device.advance((now - last).as_secs_f64(), now);
        last = now;
        if let Some((count, from)) = received {
            device.receive(&bytes[..count], from, now);
        }
        device.deliver(&socket);
        match execute(&mut device, &commands) {
            Executed::Quit => break,
            Executed::Continue => {}
        }
        if !args.quiet && viewed.elapsed() > VIEW {
            viewed = now;
            print(&device.view());
        }
    }
    device.truth.flush();
    Ok(())
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
fn stdin_commands(end_with_stdin: bool) -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                return;
            }
        }
        if !end_with_stdin {
            // Holds the channel open for as long as the process lives.
            loop {
                std::thread::park();
            }
        }
    });
    receive
}

enum Executed {
    Continue,
    Quit,
}

fn execute(device: &mut Device, commands: &Receiver<String>) -> Executed {
    match commands.try_recv() {
        Err(TryRecvError::Empty) => Executed::Continue,
        Err(TryRecvError::Disconnected) => Executed::Quit,
        Ok(line) => {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                ["quit"] => return Executed::Quit,
                ["units", "wrong"] => device.restate_units(2),
                ["units", "right"] => device.restate_units(1),
                ["power-cycle"] => device.power_cycle(),
                [] => {}
                words if device.faults.order(words) => {}
                _ => print(&format!("\"{line}\" is not a command: see --help")),
            }
            Executed::Continue
        }
    }
}

impl Device {
    fn new(scene: Scene, file: &RigFile, pairing: u32, seed: u64, truth: TruthLog) -> Self {
        let drive = &file.drive;
        let identity = Identity {
            tension_unit: 1,
            pitch_nm: (drive.encoder_pitch_um * 1e3) as u32,
            min_mn: (drive.min_tension_n * 1e3) as u16,
            max_mn: (drive.max_tension_n * 1e3) as u16,
            rate_hz: drive.rate_hz as u16,
            watchdog_ms: WATCHDOG_MS,
            boot: seed as u32 ^ std::process::id(),
            name: "simulated".into(),
        };
        Self {
            scene,
            identity,
            pairing,
            state: State::Idle,
            session: 0,
            sequence: 0,
            obeyed: 0,
            commanded: Instant::now(),
            started: Instant::now(),
            host: None,
            faults: Faults::new(seed),
            truth,
        }
    }

    /// Advances the scene [s]; the watchdog reduces tensions to the minimum.
    fn advance(&mut self, seconds: f64, now: Instant) {
        let silent = now - self.commanded > Duration::from_millis(u64::from(WATCHDOG_MS));
        if self.state == State::Running && silent {
            self.state = State::Armed;
            self.scene.drives.iter_mut().for_each(|d| d.idle());
        }
        self.scene.advance(seconds);
    }

    fn receive(&mut self, bytes: &[u8], from: SocketAddr, now: Instant) {
        if self.faults.loses() {
            return;
        }
        let Some(received) = codec::parse(bytes) else { return };
        self.sequence = self.sequence.wrapping_add(1);
        match received.request {
            Request::Hello { pairing } => self.greet(&received, pairing, from, now),
            _ if self.host != Some(from) || received.session != self.session => {}
            Request::Arm if self.state != State::Idle => {
                self.state = State::Armed;
                self.scene.drives.iter_mut().for_each(|d| d.idle());
                self.scene.armed();
                self.send_sample(from, now);
            }
            Request::Command { tension_mn } if matches!(self.state, State::Armed | State::Running) => {
                self.state = State::Running;
                (self.commanded, self.obeyed) = (now, received.sequence);
                for (drive, t) in self.scene.drives.iter_mut().zip(tension_mn) {
                    drive.command(f64::from(t) * 1e-3);
                }
                self.send_sample(from, now);
            }
            Request::Stop => {
                self.state = State::Idle;
                self.scene.drives.iter_mut().for_each(|d| d.release());
            }
            Request::Arm | Request::Command { .. } => {
                self.faults.send(from, codec::refused(2, self.sequence, self.session));
            }
        }
    }

    fn greet(&mut self, received: &Received, pairing: u32, from: SocketAddr, now: Instant) {
        let is_busy = self.state == State::Running && self.host.is_some_and(|h| h != from);
        let reason = match () {
            () if self.pairing != 0 && pairing != self.pairing => Some(0),
            () if is_busy && now - self.commanded < Duration::from_secs(1) => Some(1),
            () => None,
        };
        if let Some(reason) = reason {
            return self.faults.send(from, codec::refused(reason, self.sequence, received.session));
        }
        (self.host, self.session, self.state) = (Some(from), received.session, State::Greeted);
        self.scene.drives.iter_mut().for_each(|d| d.release());
        self.faults.send(from, codec::caps(&self.identity, self.sequence, self.session));
    }

    fn send_sample(&mut self, to: SocketAddr, now: Instant) {
        let time_us = (now - self.started).as_micros() as u32;
        let reading = Reading {
            state: self.state as u8,
            jig: self.scene.jig_contact(),
            time_us,
            obeyed: self.obeyed,
            count: std::array::from_fn(|i| self.scene.drives[i].count()),
            tension_mn: std::array::from_fn(|i| (self.scene.drives[i].by_current() * 1e3) as u16),
        };
        self.truth.note(time_us, &self.scene);
        self.faults.send(to, codec::sample(&reading, self.sequence, self.session));
    }

    fn deliver(&mut self, socket: &UdpSocket) {
        while let Some((host, bytes)) = self.faults.arrived() {
            // The loss of a host does not stop the device.
            let _ = socket.send_to(&bytes, host);
        }
    }

    fn restate_units(&mut self, tension_unit: u8) {
        self.identity.tension_unit = tension_unit;
        self.state = State::Idle;
    }

    fn power_cycle(&mut self) {
        self.identity.boot = self.identity.boot.wrapping_add(1);
        self.state = State::Idle;
        self.scene.power_cycle();
    }

    fn view(&self) -> String {
        let p = self.scene.pan.pose.position * 1e3;
        let tensions: Vec<String> = self.scene.drives.iter().map(|d| format!("{:4.1}", d.tension())).collect();
        let place = match self.scene.jig_contact() {
            _ if self.scene.is_free() => "in the hand".to_owned(),
            0 => "between places of the jig".to_owned(),
            place => format!("jig, place {place}"),
        };
        let silent = if self.faults.is_silent() { ", unplugged" } else { "" };
        let state = format!("{:?}{silent}", self.state).to_lowercase();
        format!("{state:8}  {place}  pan {:6.1} {:6.1} {:6.1} mm  strings {} N", p.x, p.y, p.z, tensions.join(" "))
    }
}
