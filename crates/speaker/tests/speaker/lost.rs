//! No device, no library, an unplugged device: reported once, and survived.

use saute_speaker::{Device, Speaker, Trouble};

use crate::device::{Tape, frying, silent_blocks, speaker_at, tape};

/// Waits for the speaker's next trouble, sending it the state again and again.
fn trouble(speaker: &mut Speaker) -> Trouble {
    loop {
        speaker.hear(frying(), &[]);
        match speaker.trouble() {
            Some(trouble) => return trouble,
            None => std::thread::yield_now(),
        }
    }
}

/// A machine without the library: one sentence, and everything goes on.
#[test]
fn a_system_without_sound_is_said_once() {
    let mut tries = 0;
    let open = move || {
        tries += 1;
        assert_eq!(tries, 1, "a library that is missing does not come");
        Err(Trouble::NoLibrary)
    };
    let mut speaker = Speaker::new(Box::new(open)).expect("a thread");
    assert_eq!(trouble(&mut speaker), Trouble::NoLibrary);
    (0..1000).for_each(|_| speaker.hear(frying(), &[]));
    assert_eq!(speaker.trouble(), None);
}

/// A headset that is pulled out and put in again: reported once, and it sounds again.
#[test]
fn an_unplugged_device_is_said_once_and_taken_again() {
    let (blocks, played) = tape();
    let (second, played_again) = tape();
    let tape = |blocks, left| Some(Tape { rate: 48_000, blocks, left });
    let mut devices = vec![tape(second, usize::MAX), None, tape(blocks, 20)];
    let open = move || match devices.pop().flatten() {
        Some(tape) => Ok(Box::new(tape) as Box<dyn Device>),
        None => Err(Trouble::Device("no sound card".into())),
    };
    let mut speaker = Speaker::new(Box::new(open)).expect("a thread");
    speaker.hear(frying(), &[]);
    assert_eq!(played.iter().count(), 20);
    assert_eq!(trouble(&mut speaker), Trouble::Device("unplugged".into()));
    speaker.hear(frying(), &[]);
    let mut sounds = || {
        speaker.hear(frying(), &[]);
        played_again.recv().expect("a block").iter().any(|frame| frame[0] != 0.0)
    };
    assert!((0..1000).any(|_| sounds()));
    assert_eq!(speaker.trouble(), None, "that it was still absent is not said again");
}

/// A window closes although its sound card hangs.
#[test]
fn a_device_that_hangs_does_not_keep_the_speaker() {
    let (mut speaker, played) = speaker_at(48_000);
    speaker.hear(frying(), &[]);
    assert!(silent_blocks(&played) < 100);
    // Nobody takes blocks: the device waits for ever.
    drop(speaker);
    drop(played);
}

/// A library that is not there, and one without these functions, are values.
#[cfg(target_os = "linux")]
#[test]
fn a_missing_or_foreign_library_is_an_error() {
    use saute_speaker::alsa::{Alsa, DEFAULT};
    let opened = |library: &str| Alsa::open_with(library, DEFAULT).err();
    assert_eq!(opened("libasound-that-nobody-has.so"), Some(Trouble::NoLibrary));
    assert_eq!(opened("libm.so.6"), Some(Trouble::OldLibrary("snd_lib_error_set_local")));
}

/// Where there is ALSA, its device that plays nowhere takes what is played, and an unknown one is an error with ALSA's own words.
#[cfg(target_os = "linux")]
#[test]
fn alsa_plays_where_it_is_there() {
    use saute_speaker::alsa::Alsa;
    let mut device = match Alsa::open("null") {
        Ok(device) => device,
        Err(error) => {
            println!("skipped: {error}");
            return;
        }
    };
    assert!(device.rate() > 0);
    for length in [1, 256, 4_000] {
        device.play(&vec![[0.1; 2]; length]).expect("plays");
    }
    let unknown = Alsa::open("no-such-device").err();
    assert!(matches!(&unknown, Some(Trouble::Device(words)) if words == "no sound card"), "{unknown:?}");
    let open = || Alsa::open("null").map(|device| Box::new(device) as Box<dyn Device>);
    let mut speaker = Speaker::new(Box::new(open)).expect("a thread");
    (0..100).for_each(|_| speaker.hear(frying(), &[]));
    assert_eq!(speaker.trouble(), None);
}
