//! The thread that waits for phones, and one for each that has come.

use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use rustls::{ServerConfig, ServerConnection, StreamOwned};

use super::bounded::Bounded;
use super::http::{Asked, answer, asked, read_head};
use super::session;
use super::{Heard, Told, certificate};
use crate::open::{Access, OpenError, Reach};
use crate::remote::network_thread::NetworkThread;
use crate::remote::pairing::Pairing;
use crate::remote::reachable::reachable;

/// Connections at once (chosen: a page, a socket, and some that hang).
const MOST_CONNECTIONS: usize = 8;
/// How long handshake, request and answer may take together (chosen: a slow radio).
const PATIENCE: Duration = Duration::from_secs(5);
/// Time between two looks for a new phone (chosen: nobody notices).
const LOOK: Duration = Duration::from_millis(20);
/// How long a read waits before the thread looks whether there is something to tell (chosen: a third of a message).
const TURN: Duration = Duration::from_millis(5);
/// How long a write may take (chosen: a phone that takes nothing for so long is away).
pub const WRITE: Duration = Duration::from_secs(1);

/// A phone's encrypted connection.
pub type Line = StreamOwned<ServerConnection, Bounded>;

/// What all connections share; the control loop never touches it.
pub struct Shared {
    /// The code.
    pub pairing: Mutex<Pairing>,
    /// Where motion goes; together with what is counted.
    pub heard: Mutex<(triple_buffer::Input<Heard>, Heard)>,
    /// What phones shall be told.
    pub told: Mutex<triple_buffer::Output<Told>>,
    /// Number of the phone that was paired last; earlier ones are let go.
    pub holder: AtomicU64,
    /// Whether the device is gone.
    pub end: Arc<AtomicBool>,
    connections: AtomicUsize,
    tls: Arc<ServerConfig>,
}

/// Room for one connection, given back whatever ends it.
struct Slot(Arc<Shared>);

/// Listens at an address; tells what a person must know.
pub fn start(
    address: SocketAddr,
    heard: triple_buffer::Input<Heard>,
    told: triple_buffer::Output<Told>,
) -> Result<(Access, NetworkThread), OpenError> {
    let failed = |message: String| OpenError::place(address, message, "name another port: phone@HOST:PORT");
    let listener = TcpListener::bind(address).map_err(|e| failed(format!("cannot be listened at: {e}")))?;
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
    let serve = move |end| wait_for_phones(&listener, &Arc::new(Shared::new(pairing, heard, told, end, tls)));
    let thread = NetworkThread::spawn("phone", serve).map_err(|e| failed(format!("no thread: {e}")))?;
    Ok((access, thread))
}

impl Shared {
    fn new(
        pairing: Pairing,
        heard: triple_buffer::Input<Heard>,
        told: triple_buffer::Output<Told>,
        end: Arc<AtomicBool>,
        tls: Arc<ServerConfig>,
    ) -> Self {
        Self {
            pairing: Mutex::new(pairing),
            heard: Mutex::new((heard, Heard::default())),
            told: Mutex::new(told),
            holder: AtomicU64::new(0),
            end,
            connections: AtomicUsize::new(0),
            tls,
        }
    }
}

impl Slot {
    /// Room for one more, where there is any.
    fn take(shared: &Arc<Shared>) -> Option<Self> {
        let before = shared.connections.fetch_add(1, Ordering::AcqRel);
        let slot = Self(Arc::clone(shared));
        (before < MOST_CONNECTIONS).then_some(slot)
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        self.0.connections.fetch_sub(1, Ordering::AcqRel);
    }
}

fn wait_for_phones(listener: &TcpListener, shared: &Arc<Shared>) {
    while !shared.end.load(Ordering::Acquire) {
        match listener.accept() {
            Ok((stream, _)) => welcome(stream, shared),
            Err(_) => std::thread::sleep(LOOK),
        }
    }
}

/// A thread for a connection, as long as there are not too many.
fn welcome(stream: TcpStream, shared: &Arc<Shared>) {
    let Some(slot) = Slot::take(shared) else { return };
    let serve = move || {
        // What ends a connection ends it alone; the phone tries again.
        let _ = serve(stream, &slot.0);
    };
    // Without a thread the connection is closed, and the phone tries again.
    let _ = std::thread::Builder::new().name("phone connection".into()).spawn(serve);
}

fn serve(stream: TcpStream, shared: &Shared) -> Result<(), Box<dyn std::error::Error>> {
    stream.set_nonblocking(false)?;
    stream.set_nodelay(true)?;
    stream.set_read_timeout(Some(TURN))?;
    stream.set_write_timeout(Some(WRITE))?;
    let until = Instant::now() + PATIENCE;
    let mut line = Line::new(ServerConnection::new(Arc::clone(&shared.tls))?, Bounded::new(stream, until));
    let head = read_head(&mut line, until)?;
    let asked = asked(&head);
    line.write_all(answer(&asked).as_bytes())?;
    line.flush()?;
    if matches!(asked, Asked::Socket { .. }) {
        session::run(line, shared);
    } else {
        line.conn.send_close_notify();
        line.flush()?;
    }
    Ok(())
}
