//! Keys that are held, and the gamepad's left hand: they move and tilt the pan and shake it.

use crate::app::SauteApp;
use egui::{Context, Key};
use glam::{DQuat, DVec2, DVec3};
use saute_kitchen::Command;
use saute_kitchen::dynamics::{Gesture, Pose};

/// How fast keys move the pan [m/s] and tilt it [rad/s] (chosen: a calm arm).
const SPEED: f64 = 0.30;

const TILT_SPEED: f64 = 1.6;

/// How far keys tilt the pan [rad] (chosen: oil runs, food slides).
const TILT: f64 = 0.45;

/// How far and how often the pan is shaken [m, 1/s] (chosen: as in the benchmark of 2013).
const AMPLITUDE: f64 = 0.02;

const HZ: f64 = 3.0;

/// A shake goes on while its key is held, but no longer than this [s] (chosen).
const SHAKE_S: f64 = 60.0;

impl SauteApp {
    /// Moves pan and tool as held keys and the gamepad command, over `wall` seconds.
    pub(crate) fn take_hands(&mut self, ctx: &Context, wall: f64) {
        self.look_at_tool();
        let pad = self.take_pad(ctx);
        if self.session.paused || self.card_is_open() {
            self.say_if_held(ctx);
            return;
        }
        let (way, lean) = if ctx.text_edit_focused() { Default::default() } else { self.take_held_keys(ctx) };
        self.move_pan((way + pad.pan).clamp_length_max(1.0), (lean + pad.lean).clamp_length_max(1.0), wall);
        self.move_tool(pad.tool, pad.twist, wall);
    }

    /// Shows a notice that nothing moves while time is stopped.
    fn say_if_held(&self, ctx: &Context) {
        const KEYS: [Key; 9] = [Key::W, Key::A, Key::S, Key::D, Key::E, Key::Q, Key::R, Key::F, Key::Z];
        let held = ctx.input(|i| i.modifiers.shift_only() && KEYS.iter().any(|key| i.key_pressed(*key)));
        let shakes = ctx.input(|i| i.modifiers.is_none() && i.key_pressed(Key::K));
        if (held || shakes) && !self.card_is_open() && !ctx.text_edit_focused() {
            self.say("notice.paused");
        }
    }

    /// Way and lean of the pan that held keys request (−1…1).
    fn take_held_keys(&mut self, ctx: &Context) -> (DVec3, DVec2) {
        let (down, keys) = ctx.input(|i| (i.keys_down.clone(), i.modifiers));
        let shift = keys.shift_only();
        let held = |key: Key| f64::from(u8::from(down.contains(&key)));
        let push = |plus: Key, minus: Key| if shift { held(plus) - held(minus) } else { 0.0 };
        let way = DVec3::new(push(Key::D, Key::A), push(Key::W, Key::S), push(Key::E, Key::Q));
        let lean = DVec2::new(push(Key::Z, Key::C), push(Key::F, Key::R));
        self.shake_while(down.contains(&Key::K) && keys.is_none());
        (way, lean)
    }

    fn move_pan(&mut self, way: DVec3, lean: DVec2, wall: f64) {
        let before = self.inputs.pan_keys.tilt;
        let tilt = before + (lean * TILT - before).clamp_length_max(TILT_SPEED * wall);
        self.inputs.pan_keys.tilt = tilt;
        if way != DVec3::ZERO || tilt != before {
            let held = self.session.kitchen.held_pan();
            let raised = |tilt: DVec2| self.session.kitchen.world().pan_shape().floor * tilt.length().sin();
            let level = held.position - DVec3::Z * raised(before);
            // Seen from the eye: away from it is forwards.
            let turned = DQuat::from_rotation_z(f64::from(self.sights.camera.yaw)) * (way * SPEED * wall);
            let position = level + turned + DVec3::Z * raised(tilt);
            self.hold_pan(Pose { position, rotation: tilted(tilt) });
        }
    }

    fn shake_while(&mut self, down: bool) {
        let shaking = matches!(self.session.kitchen.gesture(), Some(Gesture::Shake { .. }));
        match (down, self.inputs.pan_keys.shaking) {
            (true, false) if !shaking => {
                self.command(&Command::Shake { amplitude: AMPLITUDE, hz: HZ, for_s: SHAKE_S });
                self.inputs.pan_keys.shaking = true;
            }
            (false, true) => {
                self.inputs.pan_keys.shaking = false;
                if shaking {
                    let pose = self.session.kitchen.held_pan();
                    self.command(&Command::HoldPan { pose });
                }
            }
            _ => {}
        }
    }
}

/// Leaning to the left and towards the cook [rad].
fn tilted(lean: DVec2) -> DQuat {
    DQuat::from_scaled_axis(DVec3::new(lean.y, -lean.x, 0.0))
}
