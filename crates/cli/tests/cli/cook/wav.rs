//! `saute cook --wav`: the sound of a cook as a file that any program plays.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::running::{SHORT, names_in, run, saute};

/// Cooks a recipe with `--wav` in a folder; returns the output on stderr and the file.
fn recorded(dir: &Path, name: &str, more: &[&str]) -> (Option<i32>, String, Vec<u8>) {
    let (recipe, wav) = (dir.join("short.toml"), dir.join(name));
    // The put waits for two seconds, so that the pan is heard alone first.
    fs::write(&recipe, SHORT.replace("put = \"steak\"", "at_s = 2\nput = \"steak\"")).unwrap();
    let args = [&["cook", recipe.to_str().unwrap(), "--wav", wav.to_str().unwrap()], more].concat();
    let ran = run(&args);
    (ran.code, ran.err, fs::read(&wav).unwrap_or_default())
}

fn number(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

/// Root mean square of the samples between two times [s], over full scale [-].
fn loudness(wav: &[u8], from: f64, to: f64) -> f64 {
    let at = |s: f64| 44 + 4 * (48e3 * s) as usize;
    let samples: Vec<f64> = wav[at(from)..at(to)]
        .chunks_exact(2)
        .map(|bytes| f64::from(i16::from_le_bytes([bytes[0], bytes[1]])) / 32767.0)
        .collect();
    (samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64).sqrt()
}

#[test]
fn a_cook_is_heard_from_the_put_on_and_twice_the_same() {
    let dir = tempfile::tempdir().unwrap();
    let (code, err, wav) = recorded(dir.path(), "first.wav", &[]);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert_eq!(
        (&wav[..4], &wav[8..16], &wav[36..40]),
        (b"RIFF".as_slice(), b"WAVEfmt ".as_slice(), b"data".as_slice())
    );
    // PCM of two channels, 48 kHz, 16 bits: 22 s.
    assert_eq!((number(&wav, 20), number(&wav, 24), number(&wav, 34) & 0xffff), (0x2_0001, 48_000, 16));
    assert_eq!((number(&wav, 40), wav.len()), (22 * 48_000 * 4, 44 + 22 * 48_000 * 4));
    assert_eq!(number(&wav, 4) as usize, wav.len() - 8);
    // Of a hot pan with nothing wet in it the hum of the coil alone is heard, below −60 dB; then a piece falls into it, and fries.
    let hum = loudness(&wav, 0.0, 2.0);
    assert!((1e-4..1e-3).contains(&hum), "{hum}");
    assert!(loudness(&wav, 2.0, 2.3) > 1e-3, "{}", loudness(&wav, 2.0, 2.3));
    assert!(loudness(&wav, 9.0, 11.0) > 1e-3, "{}", loudness(&wav, 9.0, 11.0));
    let (_, _, again) = recorded(dir.path(), "second.wav", &[]);
    assert!(wav == again, "two runs give the same bytes");
    assert_eq!(names_in(dir.path()), ["first.wav", "second.wav", "short.toml"], "nothing unfinished is left");
}

#[test]
fn a_rate_is_asked_for_and_one_that_is_none_is_refused_with_an_example() {
    let dir = tempfile::tempdir().unwrap();
    let (code, _, wav) = recorded(dir.path(), "low.wav", &["--wav-rate", "11025"]);
    assert_eq!((code, number(&wav, 24), number(&wav, 40)), (Some(0), 11_025, 22 * 11_025 * 4));
    for rate in ["7999", "0", "1e9", "fast", "-48000"] {
        let rate = format!("--wav-rate={rate}");
        let (code, err, wav) = recorded(dir.path(), "none.wav", &[rate.as_str()]);
        assert_eq!((code, wav.len()), (Some(2), 0), "{rate}");
        assert!(err.contains("as in 44100"), "{rate}: {err}");
    }
}

#[test]
fn a_place_that_cannot_hold_the_sound_is_refused_before_it_cooks() {
    let dir = tempfile::tempdir().unwrap();
    for (name, said) in [("sound.mp3", "write --wav FILE.wav"), ("nowhere/sound.wav", "write permission")] {
        let (code, err, _) = recorded(dir.path(), name, &[]);
        assert_eq!(code, Some(2), "{name}");
        assert!(err.contains("--wav") && err.contains(said), "{name}: {err}");
    }
}

#[test]
fn a_cook_that_fails_leaves_the_old_file_as_it_was() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("old.wav"), b"old").unwrap();
    let recipe = dir.path().join("wrong.toml");
    fs::write(&recipe, SHORT.replace("after_s = 10\nflip = \"steak\"", "flip = \"stake\"")).unwrap();
    let ran = run(&["cook", recipe.to_str().unwrap(), "--wav", dir.path().join("old.wav").to_str().unwrap()]);
    assert_eq!(ran.code, Some(2));
    assert_eq!(fs::read(dir.path().join("old.wav")).unwrap(), b"old");
}

#[cfg(unix)]
#[test]
fn an_interrupted_cook_leaves_the_old_file_and_nothing_unfinished() {
    let dir = tempfile::tempdir().unwrap();
    let wav = dir.path().join("old.wav");
    fs::write(&wav, b"old").unwrap();
    let mut cook = saute().args(["cook", "medium", "--wav", wav.to_str().unwrap()]).spawn().unwrap();
    let unfinished = dir.path().join(".saute-unfinished-old.wav");
    // Half a megabyte of samples: it cooks.
    while cook.try_wait().unwrap().is_none() && fs::metadata(&unfinished).map_or(0, |file| file.len()) < 500_000 {
        std::thread::yield_now();
    }
    let asked = Command::new("kill").args(["-TERM", &cook.id().to_string()]).status().unwrap();
    assert!(asked.success() && !cook.wait().unwrap().success());
    assert_eq!(
        (fs::read(&wav).unwrap().as_slice(), names_in(dir.path())),
        (b"old".as_slice(), vec!["old.wav".to_owned()])
    );
}
