//! A Haply Inverse3: place and force over the maker's local service, JSON over WebSocket, one answer for each message.

pub mod message;
mod service;

use std::net::SocketAddr;

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;

use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::open::{Access, Networked, OpenError, Opened};
use crate::remote::network_thread::NetworkThread;
use crate::wrench::{Twist, Wrench};

/// Silence after which the service counts as lost [s] (chosen: a hundred answers).
const SILENCE_S: f64 = 0.1;

/// Inverse3 devices, which are reached over their maker's service.
pub const HAPLY: Networked =
    Networked { id: "haply", default_place: "127.0.0.1:10001", capabilities, open: |address| open(address) };

/// What the network's thread last heard.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heard {
    /// Counts answers.
    pub number: u64,
    /// Place of the cursor from the middle of its workspace [m].
    pub place: DVec3,
    /// Its velocity [m/s].
    pub velocity: DVec3,
    /// How the grip is turned from where it was level; as it was at home where no grip is.
    pub rotation: DQuat,
    /// The force that the service makes [N].
    pub force: DVec3,
    /// Buttons of the grip.
    pub buttons: u32,
    /// Whether the service is there, with a device that is calibrated.
    pub link: Link,
    /// Answers that were thrown away.
    pub rejected: u32,
}

/// Where the talk stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Link {
    /// No service, or no device at it.
    #[default]
    Away,
    /// A device that must be calibrated first.
    Uncalibrated,
    /// At work.
    Up,
}

/// What the network's thread shall tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Told {
    /// Counts orders: one that does not change is old, and makes no force.
    pub number: u64,
    /// Force on the hand [N].
    pub force: DVec3,
}

/// An Inverse3.
pub struct Haply {
    capabilities: Capabilities,
    heard: triple_buffer::Output<Heard>,
    told: triple_buffer::Input<Told>,
    _service: Option<NetworkThread>,
    last: Heard,
    order: Told,
    silent: f64,
    time_s: f64,
    health: Health,
}

/// What an Inverse3 can do.
pub fn capabilities() -> Capabilities {
    Capabilities {
        name: "Haply Inverse3, over its maker's service".into(),
        sensed: Sensed::Place,
        dof_actuated: 3,
        limits: Limits {
            // Chosen: a hand yields to it with ease; the device itself can do a little more.
            force_n: 6.0,
            torque_nm: 0.0,
            slew_n_s: 2000.0,
            slew_nm_s: 0.0,
            energy_j: 0.5,
            // Chosen: the service answers within a millisecond or two, twice the delay of a SPIDAR.
            stiffness_n_m: 600.0,
            stiffness_nm_rad: 0.0,
        },
        workspace: Workspace { home_m: [0.0, 0.0, 0.1], half_m: [0.1; 3], tilt_rad: std::f64::consts::FRAC_PI_3 },
        rate_hz: 1000.0,
        vibration: Vibration::Wrench,
        holds_real_pan: false,
        // Chosen: hand and grip, as a light hold has them.
        real_mass_kg: 0.3,
    }
}

/// Talks to the service at an address as soon as it is there.
pub fn open(address: SocketAddr) -> Result<Opened, OpenError> {
    let (heard_in, heard) = triple_buffer::triple_buffer(&Heard::default());
    let (told, told_out) = triple_buffer::triple_buffer(&Told::default());
    let talk = move |end| service::Service::new(address, heard_in, told_out, end).run();
    let thread = NetworkThread::spawn("haply", talk)
        .map_err(|e| OpenError::place(address, format!("no thread: {e}"), "close other programs and try again"))?;
    Ok(Opened { device: Box::new(Haply::new(heard, told, Some(thread))), access: Access::at(address) })
}

impl Haply {
    /// A device whose answers come from, and whose forces go to, another thread; where it is given, it ends with the device, after it
    /// has told the service to let go.
    pub fn new(
        heard: triple_buffer::Output<Heard>,
        told: triple_buffer::Input<Told>,
        service: Option<NetworkThread>,
    ) -> Self {
        Self {
            capabilities: capabilities(),
            heard,
            told,
            _service: service,
            last: Heard::default(),
            order: Told::default(),
            silent: 0.0,
            time_s: 0.0,
            health: Health::Connecting,
        }
    }

    /// Takes what has come; tells whether that was new.
    fn listen(&mut self, dt: f64) -> bool {
        let heard = *self.heard.read();
        let fresh = heard.number != self.last.number;
        self.silent = if fresh { 0.0 } else { self.silent + dt };
        self.last = heard;
        let met = self.health != Health::Connecting;
        if self.health != Health::Stopped {
            self.health = match heard.link {
                Link::Up if self.silent < SILENCE_S && heard.number > 0 => Health::Running,
                Link::Uncalibrated if self.silent < SILENCE_S => Health::Uncalibrated,
                _ if met => Health::Lost,
                _ => Health::Connecting,
            };
        }
        fresh
    }

    /// The force to show, within its limit; none unless all is well.
    fn allowed(&self, command: &HapticCommand) -> DVec3 {
        let force = command.wrench.force;
        let well = command.enabled && self.health == Health::Running && force.is_finite();
        if well { force.clamp_length_max(self.capabilities.limits.force_n) } else { DVec3::ZERO }
    }
}

impl HapticDevice for Haply {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        let fresh = self.listen(if dt.is_finite() { dt.max(0.0) } else { 0.0 });
        self.time_s += dt;
        let force = self.allowed(command);
        self.order = Told { number: self.order.number + 1, force };
        self.told.write(self.order);
        let home = DVec3::from_array(self.capabilities.workspace.home_m);
        HapticSample {
            time_s: self.time_s,
            pose: Pose { position: home + self.last.place, rotation: self.last.rotation },
            twist: Twist { linear: self.last.velocity, ..Twist::default() },
            achieved: Wrench { force, ..Wrench::ZERO },
            total_force_n: self.last.force.length(),
            health: self.health,
            fresh,
            buttons: self.last.buttons,
            rejected: self.last.rejected,
            ..HapticSample::default()
        }
    }

    fn stop(&mut self) {
        self.health = Health::Stopped;
        self.order = Told { number: self.order.number + 1, force: DVec3::ZERO };
        self.told.write(self.order);
    }
}
