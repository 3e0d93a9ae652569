//! Hands at haptic devices: what they do to the kitchen in every frame, and what they feel.

use std::path::PathBuf;

use saute_haptics::Rumble;
use saute_haptics::strings::kept_calibration::file_in;
use saute_haptics::{HapticDevice, Health, PanInHand, TurnerInHand};
use saute_kitchen::{FRAME_S, Kitchen};

use super::connected::{ConnectError, Connected};
use super::role::Role;
use crate::input::felt::Felt;

/// Degrees of freedom that a turner's device must sense.
const TURNER_DOF: u8 = 6;

/// Devices with which the window starts.
#[derive(Clone, Debug, Default)]
pub struct HandsStart {
    /// NAME[@PLACE] of the device that holds the pan.
    pub pan: Option<String>,
    /// NAME[@PLACE] of the device that leads the turner.
    pub turner: Option<String>,
    /// Pairing code that a real device shows; 0 where it needs none.
    pub pairing: u32,
    /// Where the calibration of the pan's device is kept, instead of among the settings.
    pub calibration: Option<PathBuf>,
}

/// Devices that hands hold.
#[derive(Default)]
pub struct Hands {
    pan: Option<Connected>,
    turner: Option<Connected>,
    pan_in_hand: PanInHand,
    turner_in_hand: TurnerInHand,
    felt: Felt,
    /// Distance of the eye before it stepped back to see the strings [m]; none while they are not shown.
    pub eye_before: Option<f32>,
    /// Folder of calibrations; none where nothing is remembered.
    pub folder: Option<PathBuf>,
    /// File of the pan's calibration, instead of one in the folder.
    pub file: Option<PathBuf>,
}

impl saute_session::hands::Hands for Hands {
    /// A new kitchen: hands take hold of it gently.
    fn begin(&mut self) {
        (self.pan_in_hand, self.turner_in_hand) = Default::default();
        self.felt.forget();
    }

    /// Before a frame of the kitchen: pan and turner go where hands hold them.
    fn lead(&mut self, kitchen: &mut Kitchen) {
        let pan = self.pan.as_mut().map(|d| d.update().sample);
        let other = self.turner.as_mut().map(|d| d.update().sample).filter(|s| s.health == Health::Running);
        let running = pan.filter(|s| s.health == Health::Running);
        let led = other.and_then(|s| s.turner.or(s.leads_pan.then_some(s.pose)));
        let turner = led.or(running.and_then(|s| s.turner));
        self.pan_in_hand.step(pan.as_ref(), kitchen, FRAME_S);
        self.turner_in_hand.step(turner.as_ref(), kitchen);
    }

    /// After a frame at the pace of the clock: sends the contact model to the device that holds the pan.
    fn send(&mut self, kitchen: &Kitchen) {
        if self.pan.is_none() && !self.felt.is_listened() {
            return;
        }
        let model = self.felt.look(kitchen);
        if let Some(pan) = &mut self.pan {
            pan.send(model);
        }
    }

    fn names(&self) -> Vec<String> {
        let held = [("pan", &self.pan), ("turner", &self.turner)];
        let named = held.into_iter().filter_map(|(role, device)| Some((role, device.as_ref()?)));
        named.map(|(role, device)| format!("{role}:{}", device.name.split('@').next().unwrap_or_default())).collect()
    }
}

impl Hands {
    /// Connects a device by NAME[@PLACE] in place of the one that had its role.
    pub fn connect(&mut self, role: Role, text: &str, pairing: u32) -> Result<(), ConnectError> {
        self.disconnect(role);
        let among = self.folder.as_ref().map(|folder| file_in(folder, text));
        let file = if role == Role::Pan { self.file.clone().or(among) } else { among };
        self.take(role, Connected::open(text, pairing, file)?)
    }

    /// Connects a device that lives in this program.
    pub fn hold(&mut self, role: Role, name: &str, device: Box<dyn HapticDevice>) -> Result<(), ConnectError> {
        self.disconnect(role);
        self.take(role, Connected::start(name, device, self.file.clone())?)
    }

    fn take(&mut self, role: Role, device: Connected) -> Result<(), ConnectError> {
        let dof = device.capabilities.sensed.dof();
        match role {
            Role::Pan => self.pan = Some(device),
            Role::Turner if dof < TURNER_DOF => return Err(ConnectError::TooFew { name: device.name.clone(), dof }),
            Role::Turner => self.turner = Some(device),
        }
        Ok(())
    }

    /// Ends a device's loop; what it held is laid down.
    pub fn disconnect(&mut self, role: Role) {
        match role {
            Role::Pan => (self.pan, self.eye_before) = (None, None),
            Role::Turner => self.turner = None,
        }
    }

    /// The device of a role.
    pub fn device(&self, role: Role) -> Option<&Connected> {
        match role {
            Role::Pan => self.pan.as_ref(),
            Role::Turner => self.turner.as_ref(),
        }
    }

    /// The device of strings that holds the pan.
    pub fn strung(&self) -> Option<&Connected> {
        self.pan.as_ref().filter(|device| device.strings.is_some())
    }

    /// Returns true while strings are shown: there are some, and a person has turned them on.
    pub fn strings_are_shown(&self) -> bool {
        self.eye_before.is_some() && self.strung().is_some()
    }

    /// Returns true if any device is connected.
    pub fn any(&self) -> bool {
        self.pan.is_some() || self.turner.is_some()
    }

    /// Stops all devices; they stay stopped until `resume`.
    pub fn stop(&self) {
        self.pan.iter().chain(&self.turner).for_each(Connected::stop);
    }

    /// Lets stopped devices make forces again; only a person's hand may ask for it.
    pub fn resume(&self) {
        self.pan.iter().chain(&self.turner).for_each(Connected::resume);
    }

    /// Returns true if a device was stopped, by a hand or by a safety rule.
    pub fn is_stopped(&self) -> bool {
        self.pan.iter().chain(&self.turner).any(|device| device.state().sample.health.is_stopped())
    }

    /// Returns true if a hand holds the pan, or it is being laid down.
    pub fn has_pan(&self) -> bool {
        self.pan_in_hand.holds() || self.pan_in_hand.lays_down()
    }

    /// Reads the state of the devices; returns the files into which calibrations were written, and errors.
    pub fn update(&mut self) -> Vec<Result<PathBuf, ConnectError>> {
        let mut kept = Vec::new();
        for device in self.pan.iter_mut().chain(&mut self.turner) {
            device.update();
            kept.extend(device.keep_calibration().transpose());
        }
        kept
    }

    /// Returns the rumble of a gamepad now, `wall` after the last call [s].
    pub fn rumble(&mut self, wall: f64) -> Rumble {
        self.felt.rumble(wall)
    }
}
