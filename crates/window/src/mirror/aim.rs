//! Moving the calibration's marks by mouse and keys.

use egui::{Key, Modifiers, Rect, Response, Ui};
use glam::DVec2;

use super::pattern::nearest;
use saute_mirror::calibration::Calibration;
use saute_mirror::rig::{MARKS, Rig};

/// Which mark is chosen, and how the mouse holds it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Aim {
    /// The mark that keys move.
    pub chosen: usize,
    /// From the pointer to the mark that it drags [pixels].
    held: Option<DVec2>,
}

/// How far an arrow key moves a mark, and with Shift [pixels] (chosen: less than an eye sees on the table).
const STEP: f64 = 1.0;
const FINE_STEP: f64 = 0.1;
/// Keys that choose a mark, and arrow keys with where they move it as the eye sees it, x to the right, y downwards.
const NUMBERS: [Key; MARKS] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];
const ARROWS: [(Key, DVec2); 4] = [
    (Key::ArrowLeft, DVec2::NEG_X),
    (Key::ArrowRight, DVec2::X),
    (Key::ArrowUp, DVec2::NEG_Y),
    (Key::ArrowDown, DVec2::Y),
];

impl Aim {
    /// Takes keys and mouse; returns true if a mark was moved.
    pub fn take(
        &mut self,
        ui: &Ui,
        response: &Response,
        calibration: &mut Calibration,
        rig: &Rig,
        size: DVec2,
    ) -> bool {
        let before = calibration.clone();
        self.take_keys(ui, calibration, rig, size);
        self.take_mouse(ui, response, calibration, rig, size);
        *calibration != before
    }

    fn take_keys(&mut self, ui: &Ui, calibration: &mut Calibration, rig: &Rig, size: DVec2) {
        if let Some(mark) = NUMBERS.iter().position(|key| ui.input(|i| i.key_pressed(*key))) {
            self.chosen = mark;
        }
        if ui.input_mut(|i| i.consume_key(Modifiers::SHIFT, Key::Tab)) {
            self.chosen = (self.chosen + MARKS - 1) % MARKS;
        } else if ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Tab)) {
            self.chosen = (self.chosen + 1) % MARKS;
        }
        let step = if ui.input(|i| i.modifiers.shift) { FINE_STEP } else { STEP };
        for (key, towards) in ARROWS {
            for _ in 0..ui.input(|i| i.num_presses(key)) {
                calibration.nudge(self.chosen, towards * step, rig, size);
            }
        }
        if ui.input(|i| i.key_pressed(Key::Backspace)) {
            let all = ui.input(|i| i.modifiers.shift);
            calibration.put_back(if all { None } else { Some(self.chosen) });
        }
    }

    fn take_mouse(&mut self, ui: &Ui, response: &Response, calibration: &mut Calibration, rig: &Rig, size: DVec2) {
        let scale = ui.ctx().pixels_per_point();
        let pixel = |at: egui::Pos2, rect: Rect| {
            let from = (at - rect.min) * scale;
            DVec2::new(f64::from(from.x), f64::from(from.y))
        };
        if response.drag_started() || response.clicked() {
            let origin = ui.input(|i| i.pointer.press_origin()).or(response.interact_pointer_pos());
            let shown = calibration.pixels(rig, size);
            let grabbed = origin.zip(shown).and_then(|(at, shown)| {
                let mark = nearest(&shown, at, response.rect, scale)?;
                Some((mark, shown[mark] - pixel(at, response.rect)))
            });
            if let Some((mark, _)) = grabbed {
                self.chosen = mark;
            }
            self.held = grabbed.map(|(_, from)| from);
        }
        if let (true, Some(from), Some(at)) = (response.dragged(), self.held, response.interact_pointer_pos()) {
            calibration.place(self.chosen, pixel(at, response.rect) + from, rig, size);
        }
        if response.drag_stopped() {
            self.held = None;
        }
    }
}
