//! A phone as a pan: its page sends how it is turned and pushed, over TLS, after the code on the screen has been typed.

mod bounded;
mod certificate;
mod http;
pub mod message;
pub mod orientation;
mod server;
mod session;
pub mod toss;

use std::net::SocketAddr;

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::rotation_between;

use crate::control::rumble::Rumble;
use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::open::{Networked, OpenError, Opened};
use crate::remote::network_thread::NetworkThread;
use crate::remote::remote_pose::{FOLLOW_S, HOME_S, SILENCE_S, reckoned};
use crate::remote::tilt::{eased, within_tilt};
use crate::wrench::Twist;
use toss::Toss;

/// How long an acceleration counts [s] (chosen: three messages).
const PUSH_S: f64 = 0.05;

/// Phones, as devices that are reached over a network.
pub const PHONE: Networked =
    Networked { id: "phone", default_place: "127.0.0.1:8443", capabilities, open: |address| open(address) };

/// What the network's thread last heard.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heard {
    /// Counts messages of motion.
    pub number: u64,
    /// How the pan shall be turned.
    pub rotation: DQuat,
    /// Acceleration in the kitchen's directions [m/s²].
    pub push: DVec3,
    /// Counts accelerations.
    pub pushes: u64,
    /// Whether a finger is on the page.
    pub button: bool,
    /// Whether a phone is there.
    pub connected: bool,
    /// Messages that were thrown away.
    pub rejected: u32,
}

/// What the network's thread shall tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Told {
    /// How the pan is held.
    pub pose: Pose,
    /// How hard to shake.
    pub rumble: Rumble,
}

/// A phone.
pub struct Phone {
    capabilities: Capabilities,
    heard: triple_buffer::Output<Heard>,
    told: triple_buffer::Input<Told>,
    _server: Option<NetworkThread>,
    last: Heard,
    silent: f64,
    unpushed: f64,
    toss: Toss,
    rotation: DQuat,
    time_s: f64,
    health: Health,
}

/// What a phone can do.
pub fn capabilities() -> Capabilities {
    Capabilities {
        name: "A phone in the hand".into(),
        sensed: Sensed::Turning,
        dof_actuated: 0,
        limits: Limits::NONE,
        // The pan stands on the hob at home; a toss lifts it.
        workspace: Workspace {
            home_m: [0.0; 3],
            half_m: [0.15, 0.15, 0.2],
            tilt_rad: std::f64::consts::FRAC_PI_3 * 2.0,
        },
        rate_hz: 250.0,
        vibration: Vibration::Rumble,
        holds_real_pan: false,
        real_mass_kg: 0.2,
    }
}

/// Serves the page at an address and waits for a phone.
pub fn open(address: SocketAddr) -> Result<Opened, OpenError> {
    let (heard_in, heard) = triple_buffer::triple_buffer(&Heard::default());
    let (told, told_out) = triple_buffer::triple_buffer(&Told::default());
    let (access, server) = server::start(address, heard_in, told_out)?;
    Ok(Opened { device: Box::new(Phone::new(heard, told, Some(server))), access })
}

impl Phone {
    /// A phone whose messages come from, and whose orders go to, another thread, which ends with it where it is given.
    pub fn new(
        heard: triple_buffer::Output<Heard>,
        told: triple_buffer::Input<Told>,
        server: Option<NetworkThread>,
    ) -> Self {
        Self {
            capabilities: capabilities(),
            heard,
            told,
            _server: server,
            last: Heard::default(),
            silent: 0.0,
            unpushed: 0.0,
            toss: Toss::default(),
            rotation: DQuat::IDENTITY,
            time_s: 0.0,
            health: Health::Connecting,
        }
    }

    /// Takes what has come; tells whether that was new.
    fn listen(&mut self, dt: f64) -> bool {
        let heard = *self.heard.read();
        let fresh = heard.number != self.last.number;
        self.silent = if fresh { 0.0 } else { self.silent + dt };
        self.unpushed = if heard.pushes != self.last.pushes { 0.0 } else { self.unpushed + dt };
        self.last = heard;
        if self.health != Health::Stopped {
            self.health = match (fresh, self.health) {
                (true, _) => Health::Running,
                (false, Health::Running) if self.silent > SILENCE_S || !heard.connected => Health::Lost,
                (false, health) => health,
            };
        }
        fresh
    }

    /// Moves the pan where the phone is, or home where there is none.
    fn follow(&mut self, dt: f64) -> Twist {
        let held = self.health == Health::Running;
        let push = (held && self.unpushed < PUSH_S).then_some(self.last.push);
        let workspace = &self.capabilities.workspace;
        self.toss.step(push, DVec3::from_array(workspace.half_m), dt);
        let (target, tau) = if held { (self.last.rotation, FOLLOW_S) } else { (DQuat::IDENTITY, HOME_S) };
        let before = self.rotation;
        self.rotation = eased(before, within_tilt(target, workspace.tilt_rad), dt, tau);
        let angular = rotation_between(before, self.rotation) / dt.max(1e-6);
        Twist { linear: self.toss.velocity, angular }
    }
}

impl HapticDevice for Phone {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        let dt = reckoned(dt);
        let fresh = self.listen(dt);
        let twist = self.follow(dt);
        self.time_s += dt;
        let home = DVec3::from_array(self.capabilities.workspace.home_m);
        let pose = Pose { position: home + self.toss.place, rotation: self.rotation };
        let running = self.health == Health::Running;
        let lively = command.enabled && running;
        let rumble = if lively { command.rumble } else { Rumble::default() };
        self.told.write(Told { pose, rumble });
        HapticSample {
            time_s: self.time_s,
            pose,
            twist,
            health: self.health,
            fresh,
            buttons: u32::from(running && self.last.button),
            rejected: self.last.rejected,
            ..HapticSample::default()
        }
    }

    fn stop(&mut self) {
        self.health = Health::Stopped;
    }
}
