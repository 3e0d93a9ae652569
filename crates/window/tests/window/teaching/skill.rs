//! Skill mode: no reading anywhere while one cooks, chips that show why they are off, and a result that reveals all.

use egui::Key;
use egui_kittest::kittest::Queryable;
use saute_controls::act::Setting;
use saute_picture::View;

use super::{PHONE, WIDE, rested, says, set};
use crate::harness::{press, save, steps};

#[test]
fn skill_mode_hides_all_readings_and_the_result_reveals_them() {
    for size in [WIDE, PHONE] {
        let mut harness = rested(size, 54.0, |harness| {
            set(harness, Setting::SkillMode(true));
            steps(harness, 12);
            let readings = ["°C", "Core", "well-done", "Taken out now", "A cold pan", "Underside"];
            let shown: Vec<_> = readings.into_iter().filter(|words| says(harness, words)).collect();
            assert!(shown.is_empty(), "{shown:?}");
            press(harness, Key::Num2);
            assert!(says(harness, "Off in skill mode"));
            assert_eq!(harness.state().settings().view, View::Look);
            press(harness, Key::X);
            press(harness, Key::G);
            assert!(!harness.state().settings().curves_open && !says(harness, "Core"));
            save(harness, if size == WIDE { "skill" } else { "skill-phone" });
        });
        assert!(says(&harness, "Grey band") && says(&harness, "°C"), "the result reveals all");
        save(&mut harness, if size == WIDE { "skill-result" } else { "skill-result-phone" });
        press(&mut harness, Key::Escape);
        set(&mut harness, Setting::SkillMode(false));
        press(&mut harness, Key::Num2);
        assert_eq!(harness.state().settings().view, View::Temperature);
    }
}

#[test]
fn a_view_that_is_off_says_why_when_it_is_clicked() {
    let mut harness = super::small_steak(WIDE);
    press(&mut harness, Key::Num4);
    set(&mut harness, Setting::SkillMode(true));
    assert_eq!(harness.state().settings().view, View::Look, "what was shown is hidden too");
    harness.get_by_label("Doneness").click();
    steps(&mut harness, 3);
    assert!(says(&harness, "Off in skill mode") && harness.state().settings().view == View::Look);
    harness.get_by_label("End skill mode").click();
    steps(&mut harness, 3);
    assert!(says(&harness, "Core"));
}
