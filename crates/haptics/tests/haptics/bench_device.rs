//! A test device: it implements the protocol in memory, with a prescribed pose and visible tensions.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Mutex};

use saute_haptics::strings::Lines;
use saute_haptics::strings::wire::{
    Caps, DeviceState, Frame, FrameError, Link, Message, Refusal, Refused, Sample, Units, VERSION,
};
use saute_haptics::{Geometry, Pose, Wrench};

use crate::bench_caps::CAPS;
use crate::random::Random;

/// State that the test sets and reads.
#[derive(Clone)]
pub struct Bench(Arc<Mutex<State>>);

struct State {
    geometry: Geometry,
    pose: Pose,
    tension_mn: [u16; 8],
    offset: [f64; 8],
    boot: u32,
    pairing: u32,
    plugged: bool,
    mute: bool,
    jigging: Option<u32>,
    time_us: u32,
    stops: u32,
    least_before_stop: bool,
    caps: Caps,
    lie: Lie,
    random: Random,
    coming: VecDeque<Frame>,
}

pub struct BenchLink(Bench);

/// Samples in each place of the jig, and on the way from it into the hand; a hand is not faster.
const STANDING: u32 = 150;
const LEAVING: u32 = 150;

/// What a damaged or hostile device makes of its samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lie {
    /// Nothing: it is sound.
    None,
    /// Every count is the largest number.
    LargestCounts,
    /// This share of the counts is random.
    RandomCounts(f64),
    /// Every count is off by up to this length [m].
    Noise(f64),
    /// Every tension is reported as this [mN].
    Tensions(u16),
}

impl Bench {
    /// Creates a device exactly as drawn, with arbitrary encoder zeros.
    pub fn new(geometry: &Geometry) -> Self {
        Self(Arc::new(Mutex::new(State {
            geometry: geometry.clone(),
            pose: geometry.home(),
            tension_mn: [0; 8],
            offset: std::array::from_fn(|i| 0.01 * i as f64 - 0.03),
            caps: CAPS,
            lie: Lie::None,
            random: Random(11),
            boot: 1,
            pairing: 42,
            plugged: true,
            mute: false,
            jigging: Some(0),
            time_us: 0,
            stops: 0,
            least_before_stop: false,
            coming: VecDeque::new(),
        })))
    }

    pub fn link(&self) -> BenchLink {
        BenchLink(self.clone())
    }

    pub fn put(&self, pose: Pose) {
        self.0.lock().unwrap().pose = pose;
    }

    pub fn plug(&self, plugged: bool) {
        self.0.lock().unwrap().plugged = plugged;
    }

    /// Lets the device hear without being heard.
    pub fn mute(&self, mute: bool) {
        self.0.lock().unwrap().mute = mute;
    }

    pub fn speak(&self, units: Units) {
        self.0.lock().unwrap().caps.units = units;
    }

    /// Changes what the device states about itself.
    pub fn state_caps(&self, change: impl FnOnce(&mut Caps)) {
        change(&mut self.0.lock().unwrap().caps);
    }

    /// Restarts the random numbers of false counts.
    pub fn seed(&self, seed: u64) {
        self.0.lock().unwrap().random = Random(seed);
    }

    pub fn lie(&self, lie: Lie) {
        self.0.lock().unwrap().lie = lie;
    }

    /// Simulates a power cycle: the encoders lose their count and the pan goes to the jig.
    pub fn power_cycle(&self) {
        let mut state = self.0.lock().unwrap();
        state.boot += 1;
        state.offset[3] += 0.02;
        state.jigging = Some(0);
    }

    /// Lets a string slip on its pulley by a length [m].
    pub fn slip(&self, by: f64) {
        self.0.lock().unwrap().offset[3] += by;
    }

    pub fn is_stopped(&self) -> bool {
        self.stops() > 0
    }

    /// Returns the number of stops received since the last hello.
    pub fn stops(&self) -> u32 {
        self.0.lock().unwrap().stops
    }

    /// Returns true if all commanded tensions were least when the first stop came.
    pub fn least_before_stop(&self) -> bool {
        self.0.lock().unwrap().least_before_stop
    }

    pub fn tensions(&self) -> [f64; 8] {
        self.0.lock().unwrap().tension_mn.map(|t| f64::from(t) * 1e-3)
    }

    /// Returns the wrench of the strings on the pan [N, N·m].
    pub fn wrench(&self) -> Wrench {
        let state = self.0.lock().unwrap();
        let lines: Lines = state.geometry.rig().lines(&state.pose);
        lines.wrench(&state.tension_mn.map(|t| f64::from(t) * 1e-3))
    }
}

const WRONG_CODE: Refused = Refused { reason: Refusal::WrongCode, version: VERSION, wait_ms: 0 };

impl State {
    fn receive(&mut self, frame: &Frame) {
        self.time_us += 1000;
        let answer = match frame.message {
            Message::Hello(hello) if hello.pairing != self.pairing => Message::Refused(WRONG_CODE),
            Message::Hello(_) => {
                self.stops = 0;
                Message::Caps(Caps { boot: self.boot, ..self.caps })
            }
            Message::Arm => self.sample(DeviceState::Armed),
            Message::Command(command) => {
                self.tension_mn = command.tension_mn;
                self.sample(DeviceState::Running)
            }
            Message::Stop => {
                if self.stops == 0 {
                    self.least_before_stop = self.tension_mn == [self.caps.min_mn; 8];
                }
                (self.stops, self.tension_mn) = (self.stops + 1, [0; 8]);
                return;
            }
            _ => return,
        };
        self.coming.push_back(Frame { message: answer, ..*frame });
    }

    /// Returns the pose on the way from the last place of the jig into the hand.
    fn off_the_jig(&self, last: Pose, left_at: u32) -> Pose {
        let Some(time) = self.jigging else { return self.pose };
        let share = f64::from(time - left_at) / f64::from(LEAVING);
        let position = last.position.lerp(self.pose.position, share);
        Pose { position, rotation: last.rotation.slerp(self.pose.rotation, share) }
    }

    /// Returns the count that the device reports instead of the true one.
    fn told(&mut self, count: i32) -> i32 {
        match self.lie {
            Lie::LargestCounts => i32::MAX,
            Lie::RandomCounts(share) if 0.5 * (self.random.signed() + 1.0) < share => {
                (self.random.signed() * f64::from(i32::MAX)) as i32
            }
            Lie::Noise(length) => count + (self.random.signed() * length / 20e-6) as i32,
            _ => count,
        }
    }

    fn sample(&mut self, state: DeviceState) -> Message {
        let jig = self.geometry.jig();
        let place = self.jigging.map(|t| (t / STANDING) as usize).filter(|p| *p < jig.len());
        let left_at = jig.len() as u32 * STANDING;
        let pose = place.map_or_else(|| self.off_the_jig(*jig.last().unwrap(), left_at), |p| jig[p]);
        let end = left_at + LEAVING;
        self.jigging = self.jigging.map(|t| t + 1).filter(|t| *t < end);
        let lengths = self.geometry.rig().lengths(&pose);
        let unstretched = |i: usize| {
            lengths[i] / (1.0 + f64::from(self.tension_mn[i]) * 1e-3 / self.geometry.drive.axial_stiffness_n)
        };
        let sound: [i32; 8] = std::array::from_fn(|i| ((unstretched(i) - self.offset[i]) / 20e-6).floor() as i32);
        let count = sound.map(|count| self.told(count));
        let reported = match self.lie {
            Lie::Tensions(mn) => [mn; 8],
            _ => self.tension_mn,
        };
        Message::Sample(Sample {
            state,
            jig: place.map_or(0, |p| p as u8 + 1),
            time_us: self.time_us,
            count,
            tension_mn: reported,
            ..Sample::default()
        })
    }
}

impl Link for BenchLink {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        let mut state = self.0.0.lock().unwrap();
        if state.plugged {
            state.receive(frame);
        }
        Ok(())
    }

    fn receive(&mut self) -> Option<Result<Frame, FrameError>> {
        let mut state = self.0.0.lock().unwrap();
        if state.plugged && !state.mute { state.coming.pop_front().map(Ok) } else { None }
    }
}
