//! Promise: every field can be seen, compared with the look, read under the pointer and followed over time.

use egui::{Key, Rect, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable};
use saute_app::{SauteApp, View};
use saute_kitchen::Command;

use crate::harness::{WINDOW, click, cook, drag, press, save, steps, window};

const KEYS: [Key; 7] = [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7];

/// A marbled steak that has fried on its first side and lies cut open.
fn fried(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    let text = "[pan]\ninitial_c = 210\n[[food]]\nid = \"steak\"\nkind = \"beef-marbled\"\n\
        [[step]]\nhob_w = 800\n[[step]]\nput = \"steak\"\n[[step]]\nafter_s = 200\nflip = \"steak\"\n[[step]]\nafter_s = 900\nend = true\n";
    harness.state_mut().open_recipe(text, "fried.toml");
    cook(&mut harness, 240.0);
    harness.state_mut().session_mut().set_paused(true);
    press(&mut harness, Key::X);
    harness
}

#[test]
fn every_view_has_a_key_a_chip_and_a_legend() {
    let mut harness = fried(vec2(1280.0, 720.0));
    for (view, key) in View::ALL.into_iter().zip(KEYS) {
        press(&mut harness, key);
        steps(&mut harness, 12);
        assert_eq!(harness.state().settings().view, view);
        save(&mut harness, &format!("view-{}", view.name().to_lowercase()));
        harness.get_by_label("Look").click();
        steps(&mut harness, 2);
        harness.get_by_label(view.name()).click();
        steps(&mut harness, 2);
        assert_eq!(harness.state().settings().view, view);
        if !matches!(view, View::Look | View::Doneness) {
            harness.get_by_label_contains("Legend: ");
        }
    }
}

#[test]
fn a_phone_has_every_view_with_its_legend() {
    let mut harness = fried(vec2(390.0, 844.0));
    for view in View::ALL {
        harness.get_by_label(view.name()).click();
        steps(&mut harness, 12);
        assert_eq!(harness.state().settings().view, view);
        save(&mut harness, &format!("phone-view-{}", view.name().to_lowercase()));
    }
}
