//! What hands hold: devices that lead the pan and the tools of a session.

use saute_kitchen::Kitchen;

/// Devices in the hands of a person. The session lets them lead before each frame of the world and feel after it.
pub trait Hands: Default {
    /// Another cook has begun.
    fn begin(&mut self);
    /// Gives the kitchen the commands of the devices for the next frame.
    fn lead(&mut self, kitchen: &mut Kitchen);
    /// Sends the devices what they feel; only at real time.
    fn send(&mut self, kitchen: &Kitchen);
    /// What hands hold, and the names of the devices that are connected, without their places: `pan:spidar-frame`.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

/// No device.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoHands;

impl Hands for NoHands {
    fn begin(&mut self) {}

    fn lead(&mut self, _: &mut Kitchen) {}

    fn send(&mut self, _: &Kitchen) {}
}
