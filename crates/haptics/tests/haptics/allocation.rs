//! Promise: the control loop allocates nothing, for any contact model, with and without a connected device.

use std::net::UdpSocket;

use glam::DVec3;
use saute_haptics::control::loop_step::LoopStep;
use saute_haptics::kitchen::contact_model::{ContactModel, Impulse, Payload};
use saute_haptics::remote::phone::{Incoming, Outgoing, Phone};
use saute_haptics::strings::wire::{DeviceState, Frame, Message, Sample, UdpLink};
use saute_haptics::{HapticDevice, Pose, Renderer, Spidar, library, remote::haply, remote::osc};

use crate::bench_caps::CAPS;

/// Answers like a device, through a real socket.
fn answer(socket: &UdpSocket, time_us: u32, count: [i32; 8], jig: u8) {
    let mut bytes = [0; 80];
    while let Ok((length, from)) = socket.recv_from(&mut bytes) {
        let Ok(frame) = Frame::decode(&bytes[..length]) else { continue };
        let message = match frame.message {
            Message::Hello(_) => Message::Caps(CAPS),
            Message::Arm | Message::Command(_) => {
                Message::Sample(Sample { state: DeviceState::Running, time_us, count, jig, ..Sample::default() })
            }
            _ => continue,
        };
        let bytes = Frame { message, ..frame }.encode();
        socket.send_to(&bytes, from).unwrap();
        socket.send_to(&bytes[..40], from).unwrap();
    }
}

#[test]
fn a_loop_step_allocates_nothing() {
    let geometry = library::devices().unwrap().remove(library::DEFAULT_DEVICE).unwrap();
    let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
    socket.set_nonblocking(true).unwrap();
    let link = UdpLink::connect(socket.local_addr().unwrap()).unwrap();
    let feel = library::feel().unwrap();
    let renderer = Renderer::new(&geometry.capabilities(), &feel);
    let mut control = LoopStep::new(Box::new(Spidar::new(link, geometry.clone(), 0)), renderer, 10_000);
    let (rig, jig) = (geometry.rig(), geometry.jig());
    let mut calibrated = false;
    for k in 0..6000u32 {
        let place = (k as usize) / 150;
        let wobble = Pose {
            position: geometry.home().position + DVec3::X * 0.02 * (f64::from(k) * 0.01).sin(),
            ..geometry.home()
        };
        let pose = jig.get(place).copied().unwrap_or(wobble);
        let count = rig.lengths(&pose).map(|l| (l / 20e-6) as i32);
        let mut model = ContactModel { number: u64::from(k / 16) + 1, vapour: 1e-4, ..ContactModel::default() };
        model.payload = Payload::point(0.3, DVec3::X * 0.05);
        model.impulses[0] =
            Impulse { number: u64::from(k / 500), impulse: DVec3::NEG_Z * 0.1, at: DVec3::ZERO, energy: 0.1 };
        // Half a second unplugged.
        if !(4000..4500).contains(&k) {
            answer(&socket, k * 1000 + 1, count, if place < jig.len() { place as u8 + 1 } else { 0 });
        }
        let mut health = None;
        let counted = allocation_counter::measure(|| health = Some(control.step(&model, 1e-3).sample.health));
        assert_eq!(counted.count_total, 0, "step {k} ({health:?})");
        calibrated |= health == Some(saute_haptics::Health::Running);
    }
    assert!(calibrated, "the whole sequence ran");
}

#[test]
fn a_phone_s_exchange_allocates_nothing() {
    let (mut incoming_in, incoming) = triple_buffer::triple_buffer(&Incoming::default());
    let (outgoing, _outgoing_out) = triple_buffer::triple_buffer(&Outgoing::default());
    let phone = Phone::new(incoming, outgoing, None);
    let publish = |number: u64| {
        let number = (number / 4).min(250);
        incoming_in.write(Incoming { number, connected: true, push: DVec3::Z, pushes: number, ..Incoming::default() });
    };
    assert!(steps_without_allocation(Box::new(phone), publish));
}

/// Steps a device with a new message of another thread each time, and checks that nothing is allocated.
fn steps_without_allocation(device: Box<dyn HapticDevice>, mut publish: impl FnMut(u64)) -> bool {
    let renderer = Renderer::new(device.capabilities(), &library::feel().unwrap());
    let mut control = LoopStep::new(device, renderer, 1000);
    let mut ran = false;
    for k in 1..2000u64 {
        publish(k);
        let model = ContactModel { number: k / 16 + 1, vapour: 1e-4, ..ContactModel::default() };
        let mut health = None;
        let counted = allocation_counter::measure(|| health = Some(control.step(&model, 1e-3).sample.health));
        assert_eq!(counted.count_total, 0, "step {k} ({health:?})");
        ran |= health == Some(saute_haptics::Health::Running);
    }
    ran
}

#[test]
fn an_inverse3_s_exchange_allocates_nothing() {
    let (mut incoming_in, incoming) = triple_buffer::triple_buffer(&haply::Incoming::default());
    let (outgoing, _outgoing_out) = triple_buffer::triple_buffer(&haply::Outgoing::default());
    let device = haply::Haply::new(incoming, outgoing, None);
    let publish = |number: u64| {
        incoming_in.write(haply::Incoming {
            number: number.min(1000),
            link: haply::Link::Up,
            ..haply::Incoming::default()
        });
    };
    assert!(steps_without_allocation(Box::new(device), publish));
}

#[test]
fn an_osc_sender_s_exchange_allocates_nothing() {
    let (mut incoming_in, incoming) = triple_buffer::triple_buffer(&osc::Incoming::default());
    let device = osc::Osc::new(incoming, None);
    let publish = |number: u64| incoming_in.write(osc::Incoming { pans: number.min(1000), ..osc::Incoming::default() });
    assert!(steps_without_allocation(Box::new(device), publish));
}
