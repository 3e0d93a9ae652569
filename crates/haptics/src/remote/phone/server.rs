//! The server: a thread that accepts connections, and one thread for each of them.

use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use rustls::{ServerConfig, ServerConnection, StreamOwned};

use super::http::{Request, parse, read_head, response};
use super::session;
use super::slots::{Slot, Slots};
use super::waiting_room::WaitingRoom;
use super::{Incoming, Outgoing, certificate};
use crate::open::{Access, OpenError, Reach};
use crate::remote::bounded::Bounded;
use crate::remote::network_thread::NetworkThread;
use crate::remote::pairing::Pairing;
use crate::remote::reachable::reachable;

/// Timeout of handshake, request and response together (chosen: enough for slow radio).
const REQUEST_TIMEOUT: Duration = Duration::from_secs(5);
/// Polling interval for new connections and for the first words of silent ones (chosen: imperceptible).
const POLL: Duration = Duration::from_millis(20);
/// Read timeout, after which the thread checks for outgoing messages (chosen: a third of a message interval).
const READ_TIMEOUT: Duration = Duration::from_millis(5);
/// Write timeout (chosen: a phone that accepts no data for so long is gone).
pub const WRITE_TIMEOUT: Duration = Duration::from_secs(1);

/// A phone's TLS connection.
pub type TlsStream = StreamOwned<ServerConnection, Bounded>;

/// State that all connections share; the control loop never locks it.
pub struct Shared {
    /// Pairing code.
    pub pairing: Mutex<Pairing>,
    /// Buffer to the device, with its latest contents.
    pub incoming: Mutex<(triple_buffer::Input<Incoming>, Incoming)>,
    /// Buffer from the device: what phones receive.
    pub outgoing: Mutex<triple_buffer::Output<Outgoing>>,
    /// Number of the phone that was paired last; earlier phones are disconnected.
    pub holder: AtomicU64,
    /// True once the device is closed.
    pub end: Arc<AtomicBool>,
    slots: Slots,
    tls: Arc<ServerConfig>,
}

/// Starts the server at an address; returns how a person reaches it.
pub fn start(
    address: SocketAddr,
    incoming: triple_buffer::Input<Incoming>,
    outgoing: triple_buffer::Output<Outgoing>,
) -> Result<(Access, NetworkThread), OpenError> {
    let failed = |message: String| OpenError::place(address, message, "name another port: phone@HOST:PORT");
    let listener = TcpListener::bind(address).map_err(|e| failed(format!("cannot be bound: {e}")))?;
    let bound = listener.local_addr().map_err(|e| failed(e.to_string()))?;
    listener.set_nonblocking(true).map_err(|e| failed(e.to_string()))?;
    let host = reachable(bound.ip());
    let (tls, fingerprint) = certificate::make(&[host]).map_err(|e| failed(format!("no certificate: {e}")))?;
    let pairing = Pairing::new().map_err(|e| failed(e.to_string()))?;
    let access = Access {
        place: bound.to_string(),
        reach: Reach::of(bound),
        url: Some(format!("https://{}/", SocketAddr::new(host, bound.port()))),
        code: Some(pairing.code()),
        fingerprint: Some(fingerprint),
    };
    let serve = move |end| accept_phones(&listener, &Arc::new(Shared::new(pairing, incoming, outgoing, end, tls)));
    let thread = NetworkThread::spawn("phone", serve).map_err(|e| failed(format!("no thread: {e}")))?;
    Ok((access, thread))
}

impl Shared {
    fn new(
        pairing: Pairing,
        incoming: triple_buffer::Input<Incoming>,
        outgoing: triple_buffer::Output<Outgoing>,
        end: Arc<AtomicBool>,
        tls: Arc<ServerConfig>,
    ) -> Self {
        Self {
            pairing: Mutex::new(pairing),
            incoming: Mutex::new((incoming, Incoming::default())),
            outgoing: Mutex::new(outgoing),
            holder: AtomicU64::new(0),
            end,
            slots: Slots::default(),
            tls,
        }
    }
}

fn accept_phones(listener: &TcpListener, shared: &Arc<Shared>) {
    let mut room = WaitingRoom::new();
    while !shared.end.load(Ordering::Acquire) {
        match listener.accept() {
            // A connection that cannot be waited for without blocking is closed.
            Ok((stream, _)) if stream.set_nonblocking(true).is_ok() => room.admit(stream, Instant::now()),
            Ok(_) => {}
            Err(_) => std::thread::sleep(POLL),
        }
        room.spoken(Instant::now()).into_iter().for_each(|stream| spawn_connection(stream, shared));
    }
}

/// Starts a thread for a connection if a slot is free.
fn spawn_connection(stream: TcpStream, shared: &Arc<Shared>) {
    let Some(slot) = shared.slots.take(&stream) else { return };
    let shared = Arc::clone(shared);
    let serve = move || {
        // An error ends this connection only; the phone reconnects.
        let _ = serve(stream, &shared, &slot);
    };
    // Without a thread the connection is closed, and the phone reconnects.
    let _ = std::thread::Builder::new().name("phone connection".into()).spawn(serve);
}

fn serve(stream: TcpStream, shared: &Shared, slot: &Slot) -> Result<(), Box<dyn std::error::Error>> {
    stream.set_nonblocking(false)?;
    stream.set_nodelay(true)?;
    stream.set_read_timeout(Some(READ_TIMEOUT))?;
    stream.set_write_timeout(Some(WRITE_TIMEOUT))?;
    let until = Instant::now() + REQUEST_TIMEOUT;
    let mut stream = TlsStream::new(ServerConnection::new(Arc::clone(&shared.tls))?, Bounded::new(stream, until));
    let head = read_head(&mut stream, until)?;
    let request = parse(&head);
    stream.write_all(response(&request).as_bytes())?;
    stream.flush()?;
    if matches!(request, Request::Socket { .. }) {
        slot.ask();
        session::run(stream, shared, slot);
    } else {
        stream.conn.send_close_notify();
        stream.flush()?;
    }
    Ok(())
}
