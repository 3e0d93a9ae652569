//! OSC over UDP: any program or tracker that tells where pan and turner are, after the code on the screen has been sent.

mod listener;
pub mod message;

use std::net::SocketAddr;

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::rotation_between;

use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::open::{Networked, OpenError, Opened};
use crate::remote::network_thread::NetworkThread;
use crate::remote::remote_pose::{FOLLOW_S, HOME_S, SILENCE_S, reckoned};
use crate::remote::tilt::{eased, within_tilt};
use crate::wrench::Twist;

/// Senders of OSC, as devices that are reached over a network.
pub const OSC: Networked =
    Networked { id: "osc", default_place: "127.0.0.1:9000", capabilities, open: |address| open(address) };

/// What the network's thread last heard.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heard {
    /// Counts messages about the pan.
    pub pans: u64,
    /// Where the pan is in the kitchen [m]; at home where only its tilt was told.
    pub place: Option<DVec3>,
    /// How the pan is turned.
    pub rotation: DQuat,
    /// Counts messages about the turner.
    pub turners: u64,
    /// Where the turner is in the kitchen.
    pub turner: Pose,
    /// Buttons, one bit each.
    pub buttons: u32,
    /// Messages that were thrown away: damaged, unpaired, too many.
    pub rejected: u32,
}

/// A sender of OSC.
pub struct Osc {
    capabilities: Capabilities,
    heard: triple_buffer::Output<Heard>,
    _listener: Option<NetworkThread>,
    last: Heard,
    silent: [f64; 2],
    pose: Pose,
    time_s: f64,
    health: Health,
}

/// What a sender of OSC can do.
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

/// Listens at an address.
pub fn open(address: SocketAddr) -> Result<Opened, OpenError> {
    let (heard_in, heard) = triple_buffer::triple_buffer(&Heard::default());
    let (access, listener) = listener::start(address, heard_in)?;
    Ok(Opened { device: Box::new(Osc::new(heard, Some(listener))), access })
}

impl Osc {
    /// A sender whose messages come from another thread, which ends with it where it is given.
    pub fn new(heard: triple_buffer::Output<Heard>, listener: Option<NetworkThread>) -> Self {
        let capabilities = capabilities();
        let pose = Pose { position: DVec3::from_array(capabilities.workspace.home_m), ..Pose::default() };
        Self {
            capabilities,
            heard,
            _listener: listener,
            last: Heard::default(),
            silent: [f64::INFINITY; 2],
            pose,
            time_s: 0.0,
            health: Health::Connecting,
        }
    }

    /// Takes what has come; tells whether that was new.
    fn listen(&mut self, dt: f64) -> bool {
        let heard = *self.heard.read();
        let fresh = [heard.pans != self.last.pans, heard.turners != self.last.turners];
        for (silent, fresh) in self.silent.iter_mut().zip(fresh) {
            *silent = if fresh { 0.0 } else { *silent + dt };
        }
        self.last = heard;
        let speaks = self.silent.iter().any(|s| *s < SILENCE_S);
        self.health = match self.health {
            Health::Stopped => Health::Stopped,
            _ if speaks => Health::Running,
            Health::Running => Health::Lost,
            health => health,
        };
        fresh.contains(&true)
    }

    fn leads_pan(&self) -> bool {
        self.health == Health::Running && self.silent[0] < SILENCE_S
    }

    /// The turner, within the workspace, where it is told; it may be turned over.
    fn turner(&self) -> Option<Pose> {
        let leads = self.health == Health::Running && self.silent[1] < SILENCE_S;
        let told = self.last.turner;
        leads.then(|| Pose { position: self.within(told.position), ..told })
    }

    /// The nearest place of the workspace.
    fn within(&self, place: DVec3) -> DVec3 {
        let Workspace { home_m, half_m, .. } = self.capabilities.workspace;
        let (home, half) = (DVec3::from_array(home_m), DVec3::from_array(half_m));
        place.clamp(home - half, home + half)
    }

    /// Moves the pan to where it is told to be, within the workspace, or home where nobody tells.
    fn follow(&mut self, dt: f64) -> Twist {
        let Workspace { home_m, tilt_rad, .. } = self.capabilities.workspace;
        let home = DVec3::from_array(home_m);
        let (place, rotation, tau) = if self.leads_pan() {
            (self.within(self.last.place.unwrap_or(home)), within_tilt(self.last.rotation, tilt_rad), FOLLOW_S)
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
        let dt = reckoned(dt);
        let fresh = self.listen(dt);
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
            buttons: self.last.buttons,
            rejected: self.last.rejected,
            ..HapticSample::default()
        }
    }

    fn stop(&mut self) {
        self.health = Health::Stopped;
    }
}
