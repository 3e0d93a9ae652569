//! A Haply Inverse3: position and force over the maker's local service, JSON over WebSocket with one answer per message.

pub mod message;
mod service;

use std::net::SocketAddr;

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;

use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::open::{Access, Networked, OpenError, Opened};
use crate::remote::inbox::{Inbox, age};
use crate::remote::network_thread::NetworkThread;
use crate::wrench::{Twist, Wrench};

/// Timeout after which the service counts as lost [s] (chosen: a hundred answers).
const SILENCE_S: f64 = 0.1;

/// Inverse3 devices, as networked devices.
pub const HAPLY: Networked =
    Networked { id: "haply", default_place: "127.0.0.1:10001", capabilities, open: |address| open(address) };

/// Latest data from the service.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Incoming {
    /// Number of answers so far.
    pub number: u64,
    /// Position of the cursor from the centre of its workspace [m].
    pub place: DVec3,
    /// Velocity of the cursor [m/s].
    pub velocity: DVec3,
    /// Rotation of the grip from level; the identity without a grip.
    pub rotation: DQuat,
    /// Present force of the device [N].
    pub force: DVec3,
    /// Buttons of the grip, one bit each.
    pub buttons: u32,
    /// State of the connection.
    pub link: Link,
    /// Number of rejected answers.
    pub rejected: u32,
}

/// State of the connection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Link {
    /// No service, or a service without a device.
    #[default]
    Away,
    /// A device that is not calibrated.
    Uncalibrated,
    /// A calibrated device.
    Up,
}

/// Data to the service.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outgoing {
    /// Number of commands so far: a command that does not change is stale and makes no force.
    pub number: u64,
    /// Force on the hand [N].
    pub force: DVec3,
}

/// An Inverse3 that moves the pan.
pub struct Haply {
    capabilities: Capabilities,
    inbox: Inbox<Incoming>,
    outgoing: triple_buffer::Input<Outgoing>,
    command: Outgoing,
    /// Age of the last answer [s].
    silent: f64,
    time_s: f64,
    health: Health,
}

/// Returns the capabilities of an Inverse3.
pub fn capabilities() -> Capabilities {
    Capabilities {
        name: "Haply Inverse3, over its maker's service".into(),
        sensed: Sensed::Place,
        dof_actuated: 3,
        limits: Limits {
            // Chosen: a hand overcomes it easily; the device itself makes a little more.
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
        // Chosen: hand and grip in a light hold.
        real_mass_kg: 0.3,
    }
}

/// Starts a thread that connects to the service at an address, now or later.
pub fn open(address: SocketAddr) -> Result<Opened, OpenError> {
    let (incoming_in, incoming) = triple_buffer::triple_buffer(&Incoming::default());
    let (outgoing, outgoing_out) = triple_buffer::triple_buffer(&Outgoing::default());
    let run = move |end| service::Service::new(address, incoming_in, outgoing_out, end).run();
    let thread = NetworkThread::spawn("haply", run)
        .map_err(|e| OpenError::place(address, format!("no thread: {e}"), "close other programs and try again"))?;
    let device = Box::new(Haply::new(incoming, outgoing, Some(thread)));
    Ok(Opened { device, access: Access::at(address), notices: None })
}

impl Haply {
    /// Creates a device that exchanges data with a network thread; the thread, if given, sends a zero force and ends with the device.
    pub fn new(
        incoming: triple_buffer::Output<Incoming>,
        outgoing: triple_buffer::Input<Outgoing>,
        service: Option<NetworkThread>,
    ) -> Self {
        Self {
            capabilities: capabilities(),
            inbox: Inbox::new(incoming, service),
            outgoing,
            command: Outgoing::default(),
            silent: 0.0,
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
        let met = self.health != Health::Connecting;
        if self.health != Health::Stopped {
            self.health = match now.link {
                Link::Up if self.silent < SILENCE_S && now.number > 0 => Health::Running,
                Link::Uncalibrated if self.silent < SILENCE_S => Health::Uncalibrated,
                _ if met => Health::Lost,
                _ => Health::Connecting,
            };
        }
        fresh
    }

    /// Returns the commanded force within its limit [N]; zero unless the device is running and forces are enabled.
    fn allowed(&self, command: &HapticCommand) -> DVec3 {
        let force = command.wrench.force;
        let enabled = command.enabled && self.health == Health::Running && force.is_finite();
        if enabled { force.clamp_length_max(self.capabilities.limits.force_n) } else { DVec3::ZERO }
    }

    fn send(&mut self, force: DVec3) {
        self.command = Outgoing { number: self.command.number + 1, force };
        self.outgoing.write(self.command);
    }
}

impl HapticDevice for Haply {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        let fresh = self.receive(if dt.is_finite() { dt.max(0.0) } else { 0.0 });
        self.time_s += dt;
        let force = self.allowed(command);
        self.send(force);
        let home = DVec3::from_array(self.capabilities.workspace.home_m);
        let last = self.inbox.last();
        HapticSample {
            time_s: self.time_s,
            pose: Pose { position: home + last.place, rotation: last.rotation },
            twist: Twist { linear: last.velocity, ..Twist::default() },
            achieved: Wrench { force, ..Wrench::ZERO },
            total_force_n: last.force.length(),
            health: self.health,
            fresh,
            buttons: last.buttons,
            rejected: last.rejected,
            ..HapticSample::default()
        }
    }

    fn stop(&mut self) {
        self.health = Health::Stopped;
        self.send(DVec3::ZERO);
    }

    fn resume(&mut self) {
        self.health = Health::Connecting;
    }
}
