//! The doors of streams: phones, OSC senders and devices.

use glam::DVec3;
use saute_attack::doors::{Range, STREAMED, Streamed, StreamedNumber};
use saute_attack::kitchen_files::LIBRARY;
use saute_haptics::control::loop_step::LoopStep;
use saute_haptics::kitchen::contact_model::Payload;
use saute_haptics::library;
use saute_haptics::remote::osc::message::{Event, read};
use saute_haptics::remote::phone::held_phone::HeldPhone;
use saute_haptics::remote::phone::message::FromPhone;
use saute_haptics::{
    Capabilities, ContactModel, HapticCommand, HapticDevice, HapticSample, Health, PanInHand, Pose, Renderer,
    TurnerInHand,
};
use saute_kitchen::{Command, FRAME_S, Kitchen, MeshSize, OutlineKind, PieceOrder, kelvin};

use super::{hostile, is_taken, names, sound};

/// Frames of a stream: ten ticks with the number and ten with good ones [-].
const FRAMES: usize = 60;

fn frying() -> Kitchen {
    let mut kitchen = Kitchen::new(&LIBRARY, "carbon-steel-26", kelvin(180.0)).expect("is shipped");
    let order = PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.06, 0.05, 0.015],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 4.0,
        rules: saute_kitchen::food::Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    };
    kitchen.add(&LIBRARY, &order).expect("fits");
    kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("puts");
    (0..30).for_each(|_| kitchen.step());
    kitchen
}

/// A sample of a device that runs and holds the pan a little above the glass.
fn sample() -> HapticSample {
    HapticSample { health: Health::Running, fresh: true, pose: Pose::at(0.02, 0.0, 0.05), ..HapticSample::default() }
}

/// A datagram of OSC with numbers of 64 bits.
fn datagram(address: &str, numbers: &[f64]) -> Vec<u8> {
    let padded = |text: &str| {
        let mut bytes = text.as_bytes().to_vec();
        bytes.resize(text.len() / 4 * 4 + 4, 0);
        bytes
    };
    let tags = format!(",{}", "d".repeat(numbers.len()));
    let arguments = numbers.iter().flat_map(|v| v.to_be_bytes());
    padded(address).into_iter().chain(padded(&tags)).chain(arguments).collect()
}

/// The sample that a message makes, as the drivers do; else why it is refused.
fn heard(message: Streamed, v: f64) -> Result<HapticSample, String> {
    let mut sample = sample();
    match message {
        Streamed::Device(set) => set(v, &mut sample),
        Streamed::Phone(text) => {
            let parsed = FromPhone::parse(&text.replace('#', &v.to_string())).map_err(|error| error.to_string())?;
            let FromPhone::Motion(measured) = parsed else { return Err("is no motion".to_owned()) };
            let mut phone = HeldPhone::default();
            phone.receive(&measured, 0.0).map_err(|error| error.to_string())?;
            sample.pose = phone.step(FRAME_S).unwrap_or(sample.pose);
        }
        Streamed::Osc(address, numbers) => {
            let events = read(&datagram(address, &numbers(v))).map_err(|error| error.to_string())?;
            let event = events.into_iter().next().expect("one message").map_err(|error| error.to_string())?;
            match event {
                Event::Pan(pose) => sample.pose = pose,
                Event::Tilt(rotation) => sample.pose.rotation = rotation,
                Event::Turner(pose) => sample.turner = Some(pose),
                Event::Pair(_) | Event::Button(..) => {}
            }
        }
    }
    Ok(sample)
}

/// Moves pan and turner by a sample for some frames.
fn follow(kitchen: &mut Kitchen, (pan, turner): &mut (PanInHand, TurnerInHand), sample: &HapticSample) {
    for _ in 0..FRAMES {
        pan.step(Some(sample), kitchen, FRAME_S);
        turner.step(sample.turner.as_ref(), kitchen);
        kitchen.advance_frame();
    }
}

fn tried(number: &StreamedNumber, frying: &Kitchen) {
    for v in hostile(number.range) {
        let case = format!("{} with {v}", number.name);
        let sample = match heard(number.message, v) {
            Ok(sample) => sample,
            Err(said) => {
                assert_ne!(is_taken(number.range, v), Some(true), "{case}: {said}");
                // JSON has no words for numbers that are none or beyond all others.
                let is_json = matches!(number.message, Streamed::Phone(_)) && !v.is_finite();
                let range = if is_json { Range::Fitting } else { number.range };
                names(&said, if is_json { &[""] } else { std::slice::from_ref(&number.named) }, range, &case);
                continue;
            }
        };
        let is_refusable = !matches!(number.message, Streamed::Device(_));
        assert!(!is_refusable || is_taken(number.range, v) != Some(false), "{case} is taken");
        renders(sample, &case);
        let (mut kitchen, mut hands) = (frying.clone(), Default::default());
        follow(&mut kitchen, &mut hands, &sample);
        sound(&kitchen, &case);
        comes_back(&mut kitchen, &mut hands, &case);
    }
}

/// A device that reports one sample.
struct Saying(HapticSample, Capabilities);

impl HapticDevice for Saying {
    fn capabilities(&self) -> &Capabilities {
        &self.1
    }

    fn exchange(&mut self, _: &HapticCommand, _: f64) -> HapticSample {
        self.0
    }

    fn stop(&mut self) {}

    fn resume(&mut self) {}
}

/// Panics if a device that reports a sample gets the command for a force that is none, or above its limit.
fn renders(sample: HapticSample, case: &str) {
    let device = library::devices().expect("are sound").remove(library::DEFAULT_DEVICE).expect("is there");
    let capabilities = device.capabilities();
    let renderer = Renderer::new(&capabilities, &library::feel().expect("is sound"));
    let most = capabilities.limits.force_n;
    let mut step = LoopStep::new(Box::new(Saying(sample, capabilities)), renderer, 0);
    for number in 1..200 {
        let payload = Payload::point(0.3, DVec3::ZERO);
        let state = step.step(&ContactModel { number, payload, ..ContactModel::default() }, 1e-3);
        let force = state.command.wrench.force.length();
        assert!(force <= most * 1.001, "{case}: {force} N");
    }
}

/// Panics unless the pan follows good poses again, whatever came before.
fn comes_back(kitchen: &mut Kitchen, hands: &mut (PanInHand, TurnerInHand), case: &str) {
    (0..4).for_each(|_| follow(kitchen, hands, &sample()));
    let off = kitchen.held_pan().position.distance(sample().pose.position);
    assert!(off < 1e-3, "{case}: the pan is {off} m from the hand");
    sound(kitchen, case);
}

#[test]
fn a_stream_with_a_bad_number_is_refused_or_held_at_the_reach_and_the_pan_follows_the_hand_again() {
    let frying = frying();
    STREAMED.iter().for_each(|number| tried(number, &frying));
}
