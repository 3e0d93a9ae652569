//! Promise: a hostile or outdated device, and strangers who send in its name, cannot make the driver pull or fall out of step.

use std::collections::VecDeque;
use std::io;

use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample, Health};
use saute_haptics::strings::wire::{
    Caps, DeviceState, Frame, FrameError, Link, Message, Refusal, Refused, Sample, VERSION,
};
use saute_haptics::{Spidar, Wrench};

use crate::bench_device::{Bench, BenchLink};
use crate::random::device;

const DT: f64 = 1e-3;
type Received = Result<Frame, FrameError>;

/// A sound device behind a link into which someone else sends too.
struct Hostile {
    inner: BenchLink,
    /// Returns what is received instead of a frame of the device.
    twist: Box<dyn FnMut(Frame) -> Vec<Received> + Send>,
    coming: VecDeque<Received>,
}

impl Hostile {
    fn new(bench: &Bench, twist: impl FnMut(Frame) -> Vec<Received> + Send + 'static) -> Self {
        Self { inner: bench.link(), twist: Box::new(twist), coming: VecDeque::new() }
    }
}

impl Link for Hostile {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        self.inner.send(frame)
    }

    fn receive(&mut self) -> Option<Received> {
        while let Some(Ok(frame)) = self.inner.receive() {
            self.coming.extend((self.twist)(frame));
        }
        self.coming.pop_front()
    }
}

fn pull() -> HapticCommand {
    let wrench = Wrench { force: glam::DVec3::NEG_Z * 3.0, ..Wrench::ZERO };
    HapticCommand { wrench, enabled: true, ..HapticCommand::default() }
}

fn after(spidar: &mut Spidar<Hostile>, steps: u32) -> HapticSample {
    (0..steps).map(|_| spidar.exchange(&pull(), DT)).last().unwrap()
}

/// Runs for five seconds with a twisted link; the driver must run at the end as with a sound one.
fn assert_runs(name: &str, twist: impl FnMut(Frame) -> Vec<Received> + Send + 'static) -> HapticSample {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = Spidar::new(Hostile::new(&bench, twist), device("spidar-pan-crossed"), 42);
    let sample = after(&mut spidar, 5000);
    assert!(sample.health == Health::Running && sample.fresh, "{name}: {:?}", sample.health);
    assert!((sample.achieved.force.z + 3.0).abs() < 0.05, "{name}: {:?}", sample.achieved);
    assert!(sample.rejected > 100, "{name}: {} rejected", sample.rejected);
    sample
}

#[test]
fn frames_of_strangers_are_discarded_while_the_link_runs_on() {
    let stranger = |frame: Frame, message| Frame { session: frame.session ^ 0x5a5a, message, ..frame };
    let fault = Message::Sample(Sample { state: DeviceState::Fault, time_us: u32::MAX / 2, ..Sample::default() });
    let refused = Message::Refused(Refused { reason: Refusal::WrongCode, version: VERSION, wait_ms: 60_000 });
    assert_runs("faults", move |frame| vec![Ok(stranger(frame, fault)), Ok(frame)]);
    assert_runs("refusals", move |frame| vec![Ok(stranger(frame, refused)), Ok(frame)]);
    let caps = Message::Caps(Caps {
        strings: 8,
        units: saute_haptics::strings::wire::Units::SPOKEN,
        pitch_nm: 1,
        min_mn: 0,
        max_mn: u16::MAX,
        rate_hz: 1000,
        watchdog_ms: 50,
        boot: 9,
        name: [0; 16],
    });
    assert_runs("capabilities", move |frame| vec![Ok(stranger(frame, caps)), Ok(frame)]);
    let late = move |frame: Frame| {
        // Of this session, but only once it runs.
        let again = matches!(frame.message, Message::Sample(_)).then_some(Ok(Frame { message: caps, ..frame }));
        std::iter::once(Ok(frame)).chain(again).collect()
    };
    assert_runs("repeated sequence", late);
}

#[test]
fn repeated_and_overtaken_samples_are_discarded() {
    assert_runs("repeated", |frame| vec![Ok(frame); 3]);
    let mut held = VecDeque::new();
    assert_runs("overtaken", move |frame| {
        held.push_back(frame);
        let old = if held.len() > 5 { held.pop_front() } else { None };
        std::iter::once(Ok(frame)).chain(old.map(Ok)).collect()
    });
    let mut first: Option<Frame> = None;
    assert_runs("recorded", move |frame| {
        let recorded = *first.get_or_insert(frame);
        vec![Ok(frame), Ok(Frame { session: frame.session, ..recorded })]
    });
}

#[test]
fn frames_of_another_version_do_not_break_a_running_link() {
    assert_runs("versions", |frame| match frame.message {
        Message::Sample(_) => vec![Err(FrameError::Version(1)), Ok(frame), Err(FrameError::Version(3))],
        _ => vec![Ok(frame)],
    });
}

#[test]
fn a_flood_of_damaged_frames_does_not_hide_the_device() {
    let sample = assert_runs("flood", |frame| {
        let damaged = [Err(FrameError::Checksum), Err(FrameError::Magic), Err(FrameError::Length(3))];
        damaged.into_iter().chain([Ok(frame)]).collect()
    });
    assert!(sample.rejected > 10_000);
}

#[test]
fn a_device_that_says_it_is_busy_is_waited_for() {
    let mut refusals = 3;
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let busy = move |frame: Frame| {
        let reason = Message::Refused(Refused { reason: Refusal::Busy, version: VERSION, wait_ms: 200 });
        let refuse = refusals > 0;
        refusals -= i32::from(refuse);
        vec![Ok(if refuse { Frame { message: reason, ..frame } } else { frame })]
    };
    let mut spidar = Spidar::new(Hostile::new(&bench, busy), device("spidar-pan-crossed"), 42);
    assert_eq!(after(&mut spidar, 100).health, Health::Busy);
    assert_eq!(after(&mut spidar, 3100).health, Health::Uncalibrated);
}

/// A device that answers hellos of one other version alone, without being understood.
struct OtherVersion(u8, bool, u32);

impl Link for OtherVersion {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        self.1 |= match frame.message {
            Message::HelloOfVersion1(_) => self.0 == 1,
            Message::Hello(_) => self.0 > VERSION,
            _ => {
                self.2 += 1;
                false
            }
        };
        Ok(())
    }

    fn receive(&mut self) -> Option<Received> {
        std::mem::take(&mut self.1).then_some(Err(FrameError::Version(self.0)))
    }
}

#[test]
fn a_device_of_version_1_is_refused_as_outdated_and_one_of_version_3_asks_for_another_program() {
    for (version, expected) in [(1, Health::DeviceOutdated), (3, Health::ProgramOutdated)] {
        let mut spidar = Spidar::new(OtherVersion(version, false, 0), device("spidar-pan-crossed"), 0);
        let health = (0..3000).map(|_| spidar.exchange(&pull(), DT).health).last().unwrap();
        assert_eq!(health, expected);
    }
}

#[test]
fn every_hello_has_another_random_session() {
    struct Listening(std::sync::Arc<std::sync::Mutex<Vec<u32>>>);
    impl Link for Listening {
        fn send(&mut self, frame: &Frame) -> io::Result<()> {
            self.0.lock().unwrap().push(frame.session);
            Ok(())
        }
        fn receive(&mut self) -> Option<Received> {
            None
        }
    }
    let heard = std::sync::Arc::default();
    let mut spidar = Spidar::new(Listening(std::sync::Arc::clone(&heard)), device("spidar-pan-crossed"), 0);
    (0..10_000).for_each(|_| {
        spidar.exchange(&pull(), DT);
    });
    let sessions: std::collections::BTreeSet<u32> = heard.lock().unwrap().iter().copied().collect();
    assert!(sessions.len() > 90, "{} sessions in ten seconds", sessions.len());
    let high = sessions.iter().filter(|s| **s > u32::MAX / 2).count();
    assert!((20..80).contains(&high), "{high} of a hundred in the upper half");
}
