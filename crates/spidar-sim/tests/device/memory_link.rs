//! A simulated device in memory, on a virtual clock, and links to it.

use std::io;
use std::net::SocketAddr;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use saute_haptics::strings::wire::{Frame, FrameError, Link, Message};
use saute_spidar_sim::{Device, Making};

/// Pairing code of the device.
pub const CODE: u32 = 424_242;

/// A device that several hosts can reach.
#[derive(Clone)]
pub struct Bench(Arc<Mutex<State>>);

struct State {
    device: Device,
    now: Instant,
    /// Answers that their host has not read yet.
    answers: Vec<(SocketAddr, Vec<u8>)>,
}

/// Link of a host at an address.
pub struct MemoryLink {
    bench: Bench,
    address: SocketAddr,
}

impl Bench {
    /// Switches on a device with a multiple of the usual noise.
    pub fn new(noise: f64) -> Self {
        let now = Instant::now();
        let making = Making { seed: 3, error_m: 0.5e-3, hand: 1.0, noise };
        let device = Device::named("spidar-pan-crossed", &making, CODE, now).unwrap();
        Self(Arc::new(Mutex::new(State { device, now, answers: Vec::new() })))
    }

    pub fn link(&self, address: &str) -> MemoryLink {
        MemoryLink { bench: self.clone(), address: address.parse().unwrap() }
    }

    /// Lets time pass.
    pub fn pass(&self, ms: u64) {
        let mut state = self.0.lock().unwrap();
        for _ in 0..ms {
            state.now += Duration::from_millis(1);
            let now = state.now;
            state.device.advance(now);
        }
    }

    pub fn tensions(&self) -> [f64; 8] {
        self.0.lock().unwrap().device.tensions()
    }

    pub fn is_idle(&self) -> bool {
        self.0.lock().unwrap().device.is_idle()
    }

    /// Delivers a frame from an address.
    pub fn deliver(&self, frame: &Frame, from: &str) {
        self.deliver_bytes(&frame.encode(), from.parse().unwrap());
    }

    fn deliver_bytes(&self, bytes: &[u8], from: SocketAddr) {
        let mut state = self.0.lock().unwrap();
        let now = state.now;
        state.device.receive(bytes, from, now);
        while let Some(answer) = state.device.arrived(now) {
            state.answers.push(answer);
        }
    }

    /// Executes an order, such as a fault to simulate.
    pub fn order(&self, line: &str) {
        let mut state = self.0.lock().unwrap();
        let now = state.now;
        assert!(state.device.order(&line.split(' ').collect::<Vec<_>>(), now), "{line}");
    }

    /// Returns and forgets the answers to an address.
    pub fn answers(&self, to: &str) -> Vec<Message> {
        let mut link = self.link(to);
        std::iter::from_fn(|| link.receive()).map(|frame| frame.unwrap().message).collect()
    }
}

impl Link for MemoryLink {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        self.bench.deliver_bytes(&frame.encode(), self.address);
        Ok(())
    }

    fn receive(&mut self) -> Option<Result<Frame, FrameError>> {
        let mut state = self.bench.0.lock().unwrap();
        let own = state.answers.iter().position(|(to, _)| *to == self.address)?;
        Some(Frame::decode(&state.answers.remove(own).1))
    }
}
