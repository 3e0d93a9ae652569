//! Promise: an invalid geometry file is refused with line, key and remedy.

use saute_haptics::{Feel, Geometry, library};

fn refused(change: impl Fn(&str) -> String) -> String {
    let text = library::device_texts().remove(library::DEFAULT_DEVICE).unwrap();
    let changed = change(&text);
    assert_ne!(text, changed, "the change has no effect");
    Geometry::parse(&changed, "mine.toml").unwrap_err().to_string()
}

#[test]
fn three_devices_are_shipped() {
    let names: Vec<String> = library::devices().unwrap().into_keys().collect();
    assert_eq!(names, ["spidar-frame", "spidar-pan", "spidar-pan-crossed"]);
}

#[test]
fn an_error_names_line_key_and_remedy() {
    let said = refused(|t| t.replace("max_tension_n = 12", "max_tension_n = 900"));
    assert!(
        said.starts_with("mine.toml:") && said.contains("max_tension_n = 900") && said.contains("0.1 to 60"),
        "{said}"
    );
    let said = refused(|t| t.replace("[60, 350, -200], [-60, 350, -200],", ""));
    assert!(said.contains("motor_mm has 6 places") && said.contains("give eight"), "{said}");
    let said = refused(|t| t.replace("max_tension_n = 12", "max_tension_n = 0.2"));
    assert!(said.contains("no more than min_tension_n"), "{said}");
    let said = refused(|t| t.replace("preload_n", "preloud_n"));
    assert!(said.contains("preloud_n") && said.contains("remedy"), "{said}");
    let said = refused(|t| t.replacen("source = ", "sauce = ", 1));
    assert!(said.contains("sauce"), "{said}");
}

#[test]
fn places_that_are_not_finite_are_refused_with_their_key() {
    for key in ["motor_mm", "attachment_mm", "home_mm", "half_mm", "pose"] {
        for bad in ["nan", "inf", "-inf", "1e308"] {
            let said = refused(|text| with_first_number(text, &format!("{key} = ["), bad));
            assert!(said.contains(key) && said.contains("out of range") && said.contains("5000 mm"), "{key}: {said}");
        }
    }
    let said = refused(|t| {
        let (head, tail) = t.split_once("pose = [").unwrap();
        format!("{head}pose = [{}{tail}", "[0, 0, 100, 0, 0, 0],\n".repeat(64))
    });
    assert!(said.contains("8 to 64"), "{said}");
}

/// Returns the text with another first number after `key`.
fn with_first_number(text: &str, key: &str, number: &str) -> String {
    let (head, tail) = text.split_once(key).unwrap();
    let begins = tail.find(|c: char| c.is_ascii_digit() || c == '-').unwrap();
    let ends = begins + tail[begins..].find([',', ']']).unwrap();
    format!("{head}{key}{}{number}{}", &tail[..begins], &tail[ends..])
}

#[test]
fn a_feel_out_of_range_is_refused() {
    let text = saute_kitchen::Library::embedded_files().remove("haptics/feel.toml").unwrap();
    let said =
        Feel::parse(&text.replace("frequency_hz = 12", "frequency_hz = 400"), "feel.toml").unwrap_err().to_string();
    assert!(said.contains("frequency_hz = 400") && said.contains("0.5 to 40"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_device_file_that_is_a_pipe_or_has_no_end_is_refused_before_it_is_opened() {
    let dir = tempfile::tempdir().unwrap();
    let pipe = dir.path().join("mine.toml");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    for place in [pipe.to_str().unwrap(), "/dev/zero"] {
        let said = saute_haptics::Named::parse(place).unwrap_err().to_string();
        assert!(said.contains(place) && said.contains("is a pipe or a device") && said.contains("remedy"), "{said}");
    }
}
