//! Promise: unpaired connections cannot block a phone for long, however slowly they send.

use std::io::{self, Write};
use std::net::{SocketAddr, TcpStream};
use std::thread::{JoinHandle, sleep, spawn};
use std::time::{Duration, Instant};

use saute_haptics::open;

use super::phone_client::PhoneClient;

/// Number of connection slots of the server.
const ROOM: usize = 8;
/// Interval between two bytes: shorter than the server's read timeout.
const DROP: Duration = Duration::from_millis(1);
/// Longest wait for what must come: many times the server's limits (chosen: a machine that is busy with much else).
const PATIENCE: Duration = Duration::from_secs(120);

/// Sends slowly until the server closes the connection; returns the time until then, and none if it never does.
fn drip(
    mut write: impl FnMut(&[u8]) -> io::Result<()> + Send + 'static,
    beginning: &'static [u8],
    drop: &'static [u8],
) -> JoinHandle<Option<Duration>> {
    spawn(move || {
        let begun = Instant::now();
        let mut go_on = write(beginning).is_ok();
        while go_on && begun.elapsed() < PATIENCE {
            go_on = write(drop).is_ok();
            sleep(DROP);
        }
        (!go_on).then(|| begun.elapsed())
    })
}

/// Sends the start of a 16 kB handshake byte by byte.
fn dripping_handshake(address: SocketAddr) -> JoinHandle<Option<Duration>> {
    let mut tcp = TcpStream::connect(address).unwrap();
    tcp.set_nodelay(true).unwrap();
    drip(move |bytes| tcp.write_all(bytes), &[0x16, 3, 1, 0x40, 0, 1, 0, 0x3f, 0xfc], &[3])
}

/// Sends a message in endless empty fragments over a WebSocket, without a code.
fn dripping_socket(address: SocketAddr) -> JoinHandle<Option<Duration>> {
    let mut phone = PhoneClient::connect(address);
    let write = move |bytes: &[u8]| {
        let line = phone.0.get_mut();
        line.write_all(bytes).and_then(|()| line.flush())
    };
    drip(write, &[0x01, 0x80, 0, 0, 0, 0], &[0x00, 0x80, 0, 0, 0, 0])
}

#[test]
fn eight_slow_unpaired_connections_block_a_phone_for_seconds_only() {
    let opened = open("phone@127.0.0.1:0", 0).unwrap();
    let address = opened.access.place.parse().unwrap();
    let mut dripping: Vec<_> = (0..4).map(|_| dripping_socket(address)).collect();
    dripping.extend((dripping.len()..ROOM).map(|_| dripping_handshake(address)));
    sleep(Duration::from_millis(200));
    assert!(PhoneClient::from(address, &format!("https://{address}")).is_err(), "all slots are in use");
    for one in dripping {
        let took = one.join().unwrap().expect("it loses its slot");
        println!("kept its slot for {took:?}");
    }
    PhoneClient::connect(address).pair(&opened.access.code.clone().unwrap());
}

#[test]
fn idle_connections_keep_no_phone_out_and_reset_none() {
    let opened = open("phone@127.0.0.1:0", 0).unwrap();
    let address: SocketAddr = opened.access.place.parse().unwrap();
    let code = opened.access.code.clone().unwrap();
    let connect_some = || -> Vec<TcpStream> { (0..5 * ROOM).map(|_| TcpStream::connect(address).unwrap()).collect() };
    // A port scanner is there first; the phone was never paired.
    let before = connect_some();
    let mut phone = PhoneClient::connect(address);
    // Its browser opens connections for later while the phone has not sent its code yet.
    let meanwhile = connect_some();
    sleep(Duration::from_millis(100));
    phone.pair(&code);
    let later = connect_some();
    sleep(Duration::from_millis(100));
    phone.send(r#"{"kind":"flat"}"#);
    assert!(phone.receive("flat").is_some(), "still connected");
    // Another phone of the same address pairs in addition.
    let mut second = PhoneClient::connect(address);
    drop((before, meanwhile, later));
    second.pair(&code);
}

#[test]
fn a_connection_that_says_nothing_is_closed() {
    let opened = open("phone@127.0.0.1:0", 0).unwrap();
    let address: SocketAddr = opened.access.place.parse().unwrap();
    let mut idle = TcpStream::connect(address).unwrap();
    idle.set_read_timeout(Some(PATIENCE)).unwrap();
    assert_eq!(std::io::Read::read(&mut idle, &mut [0]).unwrap(), 0, "closed by the server");
}

#[test]
fn a_paired_phone_comes_back_while_strangers_hold_idle_connections() {
    let opened = open("phone@127.0.0.1:0", 0).unwrap();
    let address: SocketAddr = opened.access.place.parse().unwrap();
    let code = opened.access.code.clone().unwrap();
    let mut phone = PhoneClient::connect(address);
    phone.pair(&code);
    drop(phone);
    // Several times as many as there are slots; they send nothing, or drip.
    let idle: Vec<TcpStream> = (0..5 * ROOM).map(|_| TcpStream::connect(address).unwrap()).collect();
    let dripping: Vec<_> = (0..ROOM).map(|_| dripping_handshake(address)).collect();
    sleep(Duration::from_millis(300));
    let begun = Instant::now();
    let mut phone = PhoneClient::connect(address);
    phone.pair(&code);
    println!("came back after {:?}", begun.elapsed());
    // And it stays: strangers cannot push out a phone that is paired.
    let more: Vec<TcpStream> = (0..5 * ROOM).map(|_| TcpStream::connect(address).unwrap()).collect();
    sleep(Duration::from_millis(300));
    phone.send(r#"{"kind":"flat"}"#);
    assert!(phone.receive("flat").is_some(), "still connected");
    drop((idle, more));
    for one in dripping {
        one.join().unwrap();
    }
}
