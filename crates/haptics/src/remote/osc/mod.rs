//! OSC over UDP: any program or tracker that sends poses of pan and turner, after pairing with the code on the screen.

mod listener;
pub mod message;
mod rejections;

use std::net::SocketAddr;

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::rotation_between;

use self::listener::Started;
use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::open::{Networked, OpenError, Opened};
use crate::remote::inbox::{Inbox, age};
use crate::remote::network_thread::NetworkThread;
use crate::remote::remote_pose::{FOLLOW_S, HOME_S, SILENCE_S, limited_step};
use crate::remote::tilt::{eased, within_tilt};
use crate::wrench::Twist;

/// OSC senders, as networked devices.
pub const OSC: Networked =
    Networked { id: "osc", default_place: "127.0.0.1:9000", capabilities, open: |address| open(address) };

/// Latest data from the senders.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Incoming {
    /// Number of messages about the pan so far.
    pub pans: u64,
    /// Position of the pan in the kitchen [m]; `None` if only its tilt was sent.
    pub place: Option<DVec3>,
    /// Rotation of the pan.
    pub rotation: DQuat,
    /// Number of messages about the turner so far.
    pub turners: u64,
    /// Pose of the turner in the kitchen.
    pub turner: Pose,
    /// Buttons, one bit each.
    pub buttons: u32,
    /// Number of rejected messages: damaged, unpaired or too many.
    pub rejected: u32,
}

/// An OSC sender that moves pan or turner.
pub struct Osc {
    capabilities: Capabilities,
    inbox: Inbox<Incoming>,
    /// Ages of the last messages about pan and turner [s].
    silent: [f64; 2],
    pose: Pose,
    time_s: f64,
    health: Health,
}

/// Returns the capabilities of an OSC sender.
pub fn capabilities() -> Capabilities {
    Capabilities {
        name: "OSC: a pose from any program".into(),
        sensed: Sensed::Pose,
        dof_actuated: 0,
        limits: Limits::NONE,
        workspace: Workspace { home_m: [0.0; 3], half_m: [0.5, 0.5, 0.5], tilt_rad: std::f64::consts::FRAC_PI_3 * 2.0 },
        rate_hz: 250.0,
        vibration: Vibration::None,
        holds_real_pan: false,
        real_mass_kg: 0.2,
    }
}

/// Starts the listener at an address.
pub fn open(address: SocketAddr) -> Result<Opened, OpenError> {
    let (incoming_in, incoming) = triple_buffer::triple_buffer(&Incoming::default());
    let Started { access, thread, notices } = listener::start(address, incoming_in)?;
    Ok(Opened { device: Box::new(Osc::new(incoming, Some(thread))), access, notices: Some(notices) })
}

impl Osc {
    /// Creates a device with the data of a network thread; the thread, if given, ends with the device.
    pub fn new(incoming: triple_buffer::Output<Incoming>, listener: Option<NetworkThread>) -> Self {
        let capabilities = capabilities();
        let pose = Pose { position: DVec3::from_array(capabilities.workspace.home_m), ..Pose::default() };
        Self {
            capabilities,
            inbox: Inbox::new(incoming, listener),
            silent: [f64::INFINITY; 2],
            pose,
            time_s: 0.0,
            health: Health::Connecting,
        }
    }

    /// Takes the latest data and updates the health; returns true if the data is new.
    fn receive(&mut self, dt: f64) -> bool {
        let before = self.inbox.receive();
        let now = self.inbox.last();
        let fresh = [now.pans != before.pans, now.turners != before.turners];
        for (silent, fresh) in self.silent.iter_mut().zip(fresh) {
            *silent = age(*silent, fresh, dt);
        }
        let active = self.silent.iter().any(|s| *s < SILENCE_S);
        self.health = match self.health {
            Health::Stopped => Health::Stopped,
            _ if active => Health::Running,
            Health::Running => Health::Lost,
            health => health,
        };
        fresh.contains(&true)
    }

    fn leads_pan(&self) -> bool {
        self.health == Health::Running && self.silent[0] < SILENCE_S
    }

    /// Returns the turner's pose, limited to the workspace, if a sender moves it; any rotation is allowed.
    fn turner(&self) -> Option<Pose> {
        let leads = self.health == Health::Running && self.silent[1] < SILENCE_S;
        let turner = self.inbox.last().turner;
        leads.then(|| Pose { position: self.within(turner.position), ..turner })
    }

    /// Returns the nearest position in the workspace [m].
    fn within(&self, place: DVec3) -> DVec3 {
        let Workspace { home_m, half_m, .. } = self.capabilities.workspace;
        let (home, half) = (DVec3::from_array(home_m), DVec3::from_array(half_m));
        place.clamp(home - half, home + half)
    }

    /// Moves the pan to the sent pose within the workspace, or home without a sender; returns its twist.
    fn follow(&mut self, dt: f64) -> Twist {
        let Workspace { home_m, tilt_rad, .. } = self.capabilities.workspace;
        let home = DVec3::from_array(home_m);
        let last = self.inbox.last();
        let (place, rotation, tau) = if self.leads_pan() {
            (self.within(last.place.unwrap_or(home)), within_tilt(last.rotation, tilt_rad), FOLLOW_S)
        } else {
            (home, DQuat::IDENTITY, HOME_S)
        };
        let before = self.pose;
        let share = 1.0 - libm::exp(-dt / tau);
        self.pose =
            Pose { position: before.position.lerp(place, share), rotation: eased(before.rotation, rotation, dt, tau) };
        let per_second = 1.0 / dt.max(1e-6);
        Twist {
            linear: (self.pose.position - before.position) * per_second,
            angular: rotation_between(before.rotation, self.pose.rotation) * per_second,
        }
    }
}

impl HapticDevice for Osc {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, _command: &HapticCommand, dt: f64) -> HapticSample {
        let dt = limited_step(dt);
        let fresh = self.receive(dt);
        let twist = self.follow(dt);
        self.time_s += dt;
        HapticSample {
            time_s: self.time_s,
            pose: self.pose,
            twist,
            leads_pan: self.leads_pan(),
            turner: self.turner(),
            health: self.health,
            fresh,
            buttons: self.inbox.last().buttons,
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
