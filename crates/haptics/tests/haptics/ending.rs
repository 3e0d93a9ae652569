//! Promise: however a program ends, its device is sent a stop three times. Separate processes, because signals end them.

use std::net::{SocketAddr, UdpSocket};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use saute_haptics::control::control_loop::ControlLoop;
use saute_haptics::strings::wire::{DeviceState, Frame, Message, Sample, UdpLink};
use saute_haptics::{Spidar, library};

use crate::bench_caps::CAPS;

/// Names the device's address to a program that a test starts.
const ADDRESS: &str = "SAUTE_TEST_DEVICE";

/// A device on a socket that counts the stops.
struct Device {
    socket: UdpSocket,
    commands: u32,
    stops: u32,
}

impl Device {
    fn start() -> Self {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_read_timeout(Some(Duration::from_millis(5))).unwrap();
        Self { socket, commands: 0, stops: 0 }
    }

    fn address(&self) -> SocketAddr {
        self.socket.local_addr().unwrap()
    }

    /// Answers until a condition is true; returns false after a minute.
    fn until(&mut self, enough: impl Fn(&Self) -> bool) -> bool {
        let begun = Instant::now();
        while begun.elapsed() < Duration::from_secs(60) {
            self.answer();
            if enough(self) {
                return true;
            }
        }
        false
    }

    fn answer(&mut self) {
        let mut bytes = [0; 80];
        let Ok((length, from)) = self.socket.recv_from(&mut bytes) else { return };
        let Ok(frame) = Frame::decode(&bytes[..length]) else { return };
        let message = match frame.message {
            Message::Hello(_) => Message::Caps(CAPS),
            Message::Arm | Message::Command(_) => {
                self.commands += 1;
                let time_us = self.commands * 1000;
                Message::Sample(Sample { state: DeviceState::Running, time_us, ..Sample::default() })
            }
            Message::Stop => {
                self.stops += 1;
                return;
            }
            _ => return,
        };
        self.socket.send_to(&Frame { message, ..frame }.encode(), from).unwrap();
    }
}

fn start(address: SocketAddr) -> ControlLoop {
    let geometry = library::devices().unwrap().remove(library::DEFAULT_DEVICE).unwrap();
    let device = Spidar::new(UdpLink::connect(address).unwrap(), geometry, 0);
    ControlLoop::start(Box::new(device), &library::feel().unwrap(), 0).unwrap()
}

/// A program with a loop, and a thread that does nothing else than wait. It is not itself a test.
#[test]
#[ignore = "the program that the other tests start and end"]
fn program_with_a_loop() {
    let Ok(address) = std::env::var(ADDRESS) else { return };
    let _control = start(address.parse().unwrap());
    std::thread::sleep(Duration::from_secs(60));
}

/// Starts the program through a shell that runs `first` in the same process.
fn program(device: &Device, first: &str) -> Child {
    let mut command = Command::new("sh");
    command.arg("-c").arg(format!("{first} exec \"$0\" --ignored --exact ending::program_with_a_loop"));
    command.arg(std::env::current_exe().unwrap()).env(ADDRESS, device.address().to_string());
    command.stdout(Stdio::null()).spawn().unwrap()
}

fn send(names: &[&str], child: &Child) {
    let pid = child.id().to_string();
    // The first one may have ended the program already.
    let kills: String = names.iter().map(|name| format!("kill -s {name} {pid}; ")).collect();
    assert!(Command::new("sh").args(["-c", &format!("{kills} true")]).status().unwrap().success());
}

#[test]
fn a_signal_stops_the_device_before_it_ends_the_program() {
    for (name, number) in [("TERM", 15), ("INT", 2), ("HUP", 1)] {
        let mut device = Device::start();
        let mut child = program(&device, "");
        assert!(device.until(|d| d.commands > 100), "the loop runs");
        assert!(device.stops == 0);
        send(&[name], &child);
        assert!(device.until(|d| d.stops == 3), "{name}: {} stops", device.stops);
        assert_eq!(child.wait().unwrap().signal(), Some(number), "{name} ends the program as usual");
    }
}

#[test]
fn a_terminal_that_hangs_up_several_times_does_not_cut_the_stops_short() {
    for rest in [["HUP", "HUP"], ["HUP", "TERM"], ["TERM", "HUP"]] {
        let mut device = Device::start();
        let mut child = program(&device, "");
        assert!(device.until(|d| d.commands > 100), "the loop runs");
        send(&rest, &child);
        assert!(device.until(|d| d.stops == 3), "{rest:?}: {} stops", device.stops);
        assert!(child.wait().unwrap().signal().is_some(), "{rest:?} end the program");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_program_that_was_started_to_outlive_its_terminal_goes_on() {
    let mut device = Device::start();
    let mut child = program(&device, "trap '' HUP;");
    assert!(device.until(|d| d.commands > 100), "the loop runs");
    send(&["HUP"], &child);
    let before = device.commands;
    assert!(device.until(|d| d.commands > before + 300) && device.stops == 0, "{} stops", device.stops);
    send(&["TERM"], &child);
    assert!(device.until(|d| d.stops == 3) && child.wait().unwrap().signal() == Some(15));
}

#[test]
fn closing_the_window_stops_the_device() {
    let mut device = Device::start();
    let control = start(device.address());
    assert!(device.until(|d| d.commands > 100), "the loop runs");
    // A window that closes drops its loops.
    let closing = std::thread::spawn(move || drop(control));
    assert!(device.until(|d| d.stops == 3), "{} stops", device.stops);
    closing.join().unwrap();
}
