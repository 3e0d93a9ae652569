//! Promise: the advice of the window, followed to the letter, leads to the steak that was wished; dangers are never hidden
//! and never cried without need.

use egui::{Key, Rect, vec2};
use egui_kittest::{
    Harness,
    kittest::{NodeT, Queryable},
};
use saute_controls::act::{Act, AppAct, CookAct, Setting};
use saute_kitchen::doneness::core_class;
use saute_kitchen::{Kitchen, kelvin};
use saute_session::FoodChoice;
use saute_window::SauteApp;

use crate::harness::{WINDOW, cook, press, save, steps, window};

fn says(harness: &Harness<'static, SauteApp>, words: &str) -> bool {
    harness.query_all_by_label_contains(words).next().is_some()
}

/// The button at the place of an advice that names a power: it sets the hob so.
fn hob_advice<'a>(harness: &'a Harness<'static, SauteApp>) -> Option<egui_kittest::Node<'a>> {
    harness.query_all_by_label_contains("As advised: hob to ").next()
}

/// Presses the button that the advice means; returns true once the food has rested.
fn follow(harness: &mut Harness<'static, SauteApp>) -> bool {
    let meant = [
        ("Take it out now", "Take out"),
        ("Flip the steak now", "Flip"),
        ("Put the steak in", "In the pan"),
        ("turn the hob off", "off"),
        ("Turn the hob on, to 1100 W", "1100 W"),
    ];
    if let Some((_, button)) = meant.iter().find(|(words, _)| says(harness, words)) {
        harness.get_by_label(button).click();
        steps(harness, 2);
    } else if let Some(hob) = hob_advice(harness) {
        hob.click();
        steps(harness, 2);
    }
    says(harness, "It has rested")
}

/// Sets a steak out and cooks it by the advice alone.
fn cooked(pan: &str, mm: f64) -> Harness<'static, SauteApp> {
    let mut harness = window(vec2(1280.0, 720.0));
    let choice = FoodChoice { pan: pan.to_owned(), size_mm: vec![120.0, 80.0, mm], ..FoodChoice::default() };
    let context = harness.ctx.clone();
    harness.state_mut().act(Act::App(AppAct::Set(Setting::Choice(choice))), &context);
    harness.state_mut().act(Act::Cook(CookAct::SetOut(1)), &context);
    steps(&mut harness, 2);
    let mut stages = 0;
    while !follow(&mut harness) {
        // The words of the line are looked at: a picture of every second minute.
        if harness.state().session().kitchen.time_s() >= 100.0 * f64::from(stages) {
            save(&mut harness, &format!("now-{pan}-{stages}"));
            stages += 1;
        }
        (0..50).for_each(|_| harness.state_mut().session_mut().tick().expect("ticks"));
        steps(&mut harness, 2);
        assert!(harness.state().session().kitchen.time_s() < 3600.0, "the advice leads nowhere");
    }
    harness
}

#[test]
fn whoever_follows_the_words_of_the_window_gets_a_medium_steak() {
    let (pan, mm) = ("carbon-steel-26", 25.0);
    let mut harness = cooked(pan, mm);
    let app = harness.state();
    let (steak, scale) = (app.session().shown_piece().expect("steak"), app.scale().expect("a scale"));
    assert_eq!(core_class(steak, &scale), "medium", "{pan} {mm} mm");
    assert!(says(&harness, "medium (Kato & Hasegawa 2013)"), "the window says so too");
    assert_eq!(app.session().kitchen.hob_w(), 0.0);
    save(&mut harness, &format!("advice-{pan}"));
}

/// A pan with its film of oil at a temperature.
fn oil_at(celsius: f64) -> Harness<'static, SauteApp> {
    let mut harness = window(vec2(1280.0, 720.0));
    let session = harness.state_mut().session_mut();
    session.kitchen = Kitchen::new(&session.library, "carbon-steel-26", kelvin(celsius)).expect("pan");
    harness
}

#[test]
fn smoke_that_nobody_sees_is_not_cried_and_never_hides_what_is_in_the_pan() {
    let mut harness = oil_at(245.0);
    cook(&mut harness, 1.0);
    let smoke = harness.state().session().kitchen.pan_state().smoke_mg_s();
    assert!(smoke > 0.0 && smoke < 0.5, "{smoke}");
    assert!(!says(&harness, "smokes") && says(&harness, "In the pan: "));
    let mut harness = oil_at(290.0);
    cook(&mut harness, 2.0);
    assert!(says(&harness, "the oil smokes: turn the hob down") && says(&harness, "In the pan: "));
    save(&mut harness, "smoke");
}

#[test]
fn a_fire_is_an_alarm_across_the_window_with_the_things_to_do() {
    let mut harness = oil_at(370.0);
    cook(&mut harness, 1.0);
    assert!(harness.state().session().kitchen.pan_state().liquids.smoke.burning, "the oil burns");
    harness.get_by_label("3. Never water");
    let [fire, water] = ["Fire!", "3. Never water"].map(|words| harness.get_by_label(words).rect());
    assert!(WINDOW.contains_rect(fire.union(water)) && fire.top() < 40.0);
    save(&mut harness, "fire");
    assert!(hob_advice(&harness).is_some());
    press(&mut harness, Key::H);
    assert!(hob_advice(&harness).is_none(), "the line hides with the panels");
    press(&mut harness, Key::Num2);
    harness.get_by_label("3. Never water");
    harness.get_by_label("1. Lid on").click();
    cook(&mut harness, 3.0);
    assert!(harness.state().session().kitchen.pan_state().lid.is_some());
    assert!(harness.query_by_label("3. Never water").is_none(), "the lid has put it out");
}

/// Relative luminance by WCAG 2.2.
fn luminance(pixel: &image::Rgba<u8>) -> f64 {
    let linear = |v: u8| saute_kitchen::food::change::colour::decoded(f64::from(v) / 255.0);
    0.2126 * linear(pixel[0]) + 0.7152 * linear(pixel[1]) + 0.0722 * linear(pixel[2])
}

/// Contrast of the darkest and the brightest pixel in a part of a picture (1–21).
fn contrast(image: &image::RgbaImage, rect: Rect) -> f64 {
    let (mut low, mut high) = (f64::MAX, 0.0f64);
    for y in rect.top() as u32..rect.bottom() as u32 {
        for x in rect.left() as u32..rect.right() as u32 {
            let l = luminance(image.get_pixel(x, y));
            (low, high) = (low.min(l), high.max(l));
        }
    }
    (high + 0.05) / (low + 0.05)
}

#[test]
fn what_is_chosen_can_be_read_in_both_themes() {
    for theme in ["Light", "Dark"] {
        let mut harness = window(vec2(1280.0, 720.0));
        press(&mut harness, Key::F2);
        harness.get_by_label(&format!("Panels: {theme}")).click();
        steps(&mut harness, 2);
        press(&mut harness, Key::Escape);
        harness.get_by_label("+ Probe").click();
        steps(&mut harness, 14);
        let image = harness.render().expect("renders");
        for chosen in ["Look", "1×", "click the food"] {
            let rect = harness.get_by_label(chosen).rect().shrink(4.0);
            let got = contrast(&image, rect);
            assert!(got >= 4.5, "{theme}: {chosen}: {got:.2}");
        }
        // The name of a class is at the goals and below the bar.
        let goal =
            harness.get_all_by_label("medium").find(|n| n.accesskit_node().role() == egui::accesskit::Role::Button);
        let got = contrast(&image, goal.expect("a goal").rect().shrink(4.0));
        assert!(got >= 4.5, "{theme}: the chosen goal: {got:.2}");
    }
}
