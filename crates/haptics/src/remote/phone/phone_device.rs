//! Phones as a networked device.

use std::net::SocketAddr;

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;

use super::held_pan::{HALF_M, HeldPan, TILT_RAD};
use super::server;
use crate::control::rumble::Rumble;
use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::open::{Networked, OpenError, Opened};
use crate::remote::inbox::{Inbox, age};
use crate::remote::network_thread::NetworkThread;
use crate::remote::remote_pose::{SILENCE_S, limited_step};
use crate::wrench::Twist;

/// Time for which an acceleration stays valid [s] (chosen: three messages).
const PUSH_S: f64 = 0.05;

/// Phones, as networked devices.
pub const PHONE: Networked =
    Networked { id: "phone", default_place: "127.0.0.1:8443", capabilities, open: |address| open(address) };

/// Latest data from the phone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Incoming {
    /// Number of motion messages so far.
    pub number: u64,
    /// Rotation of the pan.
    pub rotation: DQuat,
    /// Acceleration in the kitchen's axes [m/s²].
    pub push: DVec3,
    /// Number of accelerations so far.
    pub pushes: u64,
    /// True if a finger touches the page.
    pub button: bool,
    /// True if a phone is connected.
    pub connected: bool,
    /// Number of rejected messages.
    pub rejected: u32,
}

/// Data to the phone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outgoing {
    /// Pose of the pan.
    pub pose: Pose,
    /// Rumble [-].
    pub rumble: Rumble,
}

/// A phone that moves the pan.
pub struct Phone {
    capabilities: Capabilities,
    inbox: Inbox<Incoming>,
    outgoing: triple_buffer::Input<Outgoing>,
    /// Age of the last motion [s].
    silent: f64,
    /// Age of the last acceleration [s].
    unpushed: f64,
    pan: HeldPan,
    time_s: f64,
    health: Health,
}

/// Returns the capabilities of a phone.
pub fn capabilities() -> Capabilities {
    Capabilities {
        name: "A phone in the hand".into(),
        sensed: Sensed::Turning,
        dof_actuated: 0,
        limits: Limits::NONE,
        // At home the pan stands on the hob; a toss lifts it.
        workspace: Workspace { home_m: [0.0; 3], half_m: HALF_M, tilt_rad: TILT_RAD },
        rate_hz: 250.0,
        vibration: Vibration::Rumble,
        holds_real_pan: false,
        real_mass_kg: 0.2,
    }
}

/// Serves the page at an address and waits for a phone.
pub fn open(address: SocketAddr) -> Result<Opened, OpenError> {
    let (incoming_in, incoming) = triple_buffer::triple_buffer(&Incoming::default());
    let (outgoing, outgoing_out) = triple_buffer::triple_buffer(&Outgoing::default());
    let (access, server) = server::start(address, incoming_in, outgoing_out)?;
    Ok(Opened { device: Box::new(Phone::new(incoming, outgoing, Some(server))), access, notices: None })
}

impl Phone {
    /// Creates a phone that exchanges data with a network thread; the thread, if given, ends with the phone.
    pub fn new(
        incoming: triple_buffer::Output<Incoming>,
        outgoing: triple_buffer::Input<Outgoing>,
        server: Option<NetworkThread>,
    ) -> Self {
        Self {
            capabilities: capabilities(),
            inbox: Inbox::new(incoming, server),
            outgoing,
            silent: 0.0,
            unpushed: 0.0,
            pan: HeldPan::default(),
            time_s: 0.0,
            health: Health::Connecting,
        }
    }

    /// Takes the latest data and updates the health; returns true if the data is new.
    fn receive(&mut self, dt: f64) -> bool {
        let before = self.inbox.receive();
        let now = self.inbox.last();
        let fresh = now.number != before.number;
        self.silent = age(self.silent, fresh, dt);
        self.unpushed = age(self.unpushed, now.pushes != before.pushes, dt);
        if self.health != Health::Stopped {
            self.health = match (fresh, self.health) {
                (true, _) => Health::Running,
                (false, Health::Running) if self.silent > SILENCE_S || !now.connected => Health::Lost,
                (false, health) => health,
            };
        }
        fresh
    }

    /// Moves the pan with the phone, or home without one; returns its twist.
    fn follow(&mut self, dt: f64) -> Twist {
        let held = self.health == Health::Running;
        let push = (held && self.unpushed < PUSH_S).then_some(self.inbox.last().push);
        self.pan.step(held.then_some((self.inbox.last().rotation, push)), dt)
    }
}

impl HapticDevice for Phone {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        let dt = limited_step(dt);
        let fresh = self.receive(dt);
        let twist = self.follow(dt);
        self.time_s += dt;
        let pose = self.pan.pose();
        let running = self.health == Health::Running;
        let rumble = if command.enabled && running { command.rumble } else { Rumble::default() };
        self.outgoing.write(Outgoing { pose, rumble });
        HapticSample {
            time_s: self.time_s,
            pose,
            twist,
            health: self.health,
            fresh,
            buttons: u32::from(running && self.inbox.last().button),
            rejected: self.inbox.last().rejected,
            ..HapticSample::default()
        }
    }

    fn stop(&mut self) {
        self.health = Health::Stopped;
    }

    fn resume(&mut self) {
        self.health = Health::Connecting;
    }
}
