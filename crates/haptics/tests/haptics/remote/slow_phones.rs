//! Promise: nobody without the code keeps a phone out for long, however slowly he drips.

use std::io::{self, Write};
use std::net::{SocketAddr, TcpStream};
use std::thread::{JoinHandle, sleep, spawn};
use std::time::{Duration, Instant};

use saute_haptics::open;

use super::phone_client::PhoneClient;

/// Connections that are served at once.
const ROOM: usize = 8;
/// Time between two drops: short beside the server's own patience with a read.
const DROP: Duration = Duration::from_millis(1);

/// Drips until it is hung up on; tells after how long that was.
fn drip(
    mut write: impl FnMut(&[u8]) -> io::Result<()> + Send + 'static,
    beginning: &'static [u8],
    drop: &'static [u8],
) -> JoinHandle<Duration> {
    spawn(move || {
        let begun = Instant::now();
        let mut go_on = write(beginning).is_ok();
        while go_on && begun.elapsed() < Duration::from_secs(12) {
            go_on = write(drop).is_ok();
            sleep(DROP);
        }
        begun.elapsed()
    })
}

/// The beginning of a handshake of 16 kB, byte by byte.
fn dripping_handshake(address: SocketAddr) -> JoinHandle<Duration> {
    let mut tcp = TcpStream::connect(address).unwrap();
    tcp.set_nodelay(true).unwrap();
    drip(move |bytes| tcp.write_all(bytes), &[0x16, 3, 1, 0x40, 0, 1, 0, 0x3f, 0xfc], &[3])
}

/// A socket whose message goes on in empty pieces; no code is sent.
fn dripping_socket(address: SocketAddr) -> JoinHandle<Duration> {
    let mut phone = PhoneClient::connect(address);
    let write = move |bytes: &[u8]| {
        let line = phone.0.get_mut();
        line.write_all(bytes).and_then(|()| line.flush())
    };
    drip(write, &[0x01, 0x80, 0, 0, 0, 0], &[0x00, 0x80, 0, 0, 0, 0])
}

#[test]
fn eight_that_drip_without_the_code_keep_a_phone_out_for_seconds_not_for_ever() {
    let opened = open("phone@127.0.0.1:0", 0).unwrap();
    let address = opened.access.place.parse().unwrap();
    let mut dripping: Vec<_> = (0..4).map(|_| dripping_socket(address)).collect();
    dripping.extend((dripping.len()..ROOM).map(|_| dripping_handshake(address)));
    sleep(Duration::from_millis(200));
    assert!(PhoneClient::from(address, &format!("https://{address}")).is_err(), "all room is taken");
    for one in dripping {
        let took = one.join().unwrap();
        assert!(took < Duration::from_secs(9), "kept its room for {took:?}");
    }
    PhoneClient::connect(address).pair(&opened.access.code.clone().unwrap());
}
