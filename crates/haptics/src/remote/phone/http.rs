//! A minimal HTTP server side: one page and one WebSocket.

use std::io::{self, Read};
use std::net::IpAddr;
use std::time::Instant;

use tungstenite::handshake::derive_accept_key;

use crate::remote::timeout::is_timeout;

/// Longest request head [bytes] (chosen: browsers send 1 kB).
const LONGEST_HEAD: usize = 8 << 10;
/// Maximum number of header fields (chosen: browsers send 20).
const MOST_FIELDS: usize = 64;
/// The page that the phone shows.
const PAGE: &str = include_str!("page.html");
/// Security headers of every response: no caching, no type sniffing, no framing, no referrer.
const GUARDS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\nReferrer-Policy: no-referrer\r\nConnection: close\r\n";

/// A parsed request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Request {
    /// The page, with the host name of the request.
    Page {
        /// HOST or HOST:PORT.
        host: String,
    },
    /// The WebSocket, with the key of its handshake.
    Socket {
        /// Value of Sec-WebSocket-Key.
        key: String,
    },
    /// A refused request: status and reason.
    Refused(u16, &'static str),
}

/// Reads the head of a request until a deadline, and nothing after it.
pub fn read_head(stream: &mut impl Read, deadline: Instant) -> io::Result<Vec<u8>> {
    let mut head = Vec::with_capacity(1024);
    let mut byte = [0];
    while !head.ends_with(b"\r\n\r\n") {
        if head.len() >= LONGEST_HEAD || Instant::now() > deadline {
            return Err(io::ErrorKind::InvalidData.into());
        }
        match stream.read(&mut byte) {
            Ok(0) => return Err(io::ErrorKind::UnexpectedEof.into()),
            Ok(_) => head.push(byte[0]),
            Err(e) if is_timeout(&e) => {}
            Err(e) => return Err(e),
        }
    }
    Ok(head)
}

/// Parses and checks the head of a request.
pub fn parse(head: &[u8]) -> Request {
    let mut fields = [httparse::EMPTY_HEADER; MOST_FIELDS];
    let mut parsed = httparse::Request::new(&mut fields);
    if !parsed.parse(head).is_ok_and(|s| s.is_complete()) {
        return Request::Refused(400, "Bad Request");
    }
    let field = |name: &str| {
        let found = parsed.headers.iter().find(|h| h.name.eq_ignore_ascii_case(name));
        found.and_then(|h| std::str::from_utf8(h.value).ok()).map(str::trim)
    };
    let host = field("host").unwrap_or_default();
    if !is_own(host) {
        return Request::Refused(421, "Misdirected Request");
    }
    match (parsed.method, parsed.path) {
        (Some("GET"), Some("/")) => Request::Page { host: host.to_owned() },
        (Some("GET"), Some("/pan")) => {
            // Only the page itself may open the socket, not another site in the same browser.
            let own =
                field("origin").and_then(|o| o.strip_prefix("https://")).is_some_and(|o| o.eq_ignore_ascii_case(host));
            let upgrade = field("upgrade").is_some_and(|u| u.eq_ignore_ascii_case("websocket"));
            match field("sec-websocket-key") {
                _ if !own => Request::Refused(403, "Forbidden"),
                Some(key) if upgrade => Request::Socket { key: key.to_owned() },
                _ => Request::Refused(426, "Upgrade Required"),
            }
        }
        (Some("GET"), _) => Request::Refused(404, "Not Found"),
        _ => Request::Refused(405, "Method Not Allowed"),
    }
}

/// Returns true if a host is an IP address or localhost.
///
/// Any other name may be a DNS rebinding attack: a foreign name that resolves to this machine.
fn is_own(host: &str) -> bool {
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|b| b.is_ascii_digit()) => name,
        _ => host,
    };
    let plain = name.trim_start_matches('[').trim_end_matches(']');
    name.eq_ignore_ascii_case("localhost") || plain.parse::<IpAddr>().is_ok()
}

/// Returns the whole response, or its head if a WebSocket follows.
pub fn response(request: &Request) -> String {
    match request {
        // Older versions of Safari do not include the own host's sockets in 'self'.
        Request::Page { host } => format!(
            "HTTP/1.1 200 OK\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: {}\r\n{GUARDS}Content-Security-Policy: default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; connect-src 'self' wss://{host}; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n\r\n{PAGE}",
            PAGE.len()
        ),
        Request::Socket { key } => format!(
            "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: {}\r\n\r\n",
            derive_accept_key(key.as_bytes())
        ),
        Request::Refused(status, reason) => {
            format!("HTTP/1.1 {status} {reason}\r\nContent-Length: 0\r\n{GUARDS}\r\n")
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn ask(path: &str, host: &str, origin: &str) -> Request {
        parse(format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nOrigin: {origin}\r\nUpgrade: websocket\r\nSec-WebSocket-Key: k\r\n\r\n").as_bytes())
    }

    #[test]
    fn only_the_own_page_opens_the_socket() {
        let socket = Request::Socket { key: "k".into() };
        assert_eq!(ask("/pan", "192.168.1.4:8443", "https://192.168.1.4:8443"), socket);
        assert_eq!(ask("/pan", "[::1]:8443", "https://[::1]:8443"), socket);
        for origin in ["https://evil.example", "http://192.168.1.4:8443", "null", "https://192.168.1.4:8444", ""] {
            assert_eq!(ask("/pan", "192.168.1.4:8443", origin), Request::Refused(403, "Forbidden"), "{origin}");
        }
    }

    #[test]
    fn names_of_others_and_other_paths_are_refused() {
        assert_eq!(
            ask("/", "localhost:8443", "https://localhost:8443"),
            Request::Page { host: "localhost:8443".into() }
        );
        assert_eq!(ask("/", "rebound.example:8443", ""), Request::Refused(421, "Misdirected Request"));
        assert_eq!(ask("/../etc/passwd", "127.0.0.1", ""), Request::Refused(404, "Not Found"));
        assert_eq!(parse(b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"), Request::Refused(405, "Method Not Allowed"));
        assert_eq!(parse(b"\x00\xff\r\n\r\n"), Request::Refused(400, "Bad Request"));
    }

    #[test]
    fn the_page_may_talk_to_its_own_host_alone() {
        let page = response(&ask("/", "192.168.1.4:8443", ""));
        assert!(page.contains("connect-src 'self' wss://192.168.1.4:8443; base-uri"), "{}", &page[..600]);
    }

    proptest! {
        #[test]
        fn no_bytes_open_the_socket_by_chance(bytes in prop::collection::vec(any::<u8>(), 0..400), text in "\\PC{0,60}") {
            prop_assert!(matches!(parse(&bytes), Request::Refused(..)));
            let head = format!("GET /pan HTTP/1.1\r\nHost: {text}\r\nOrigin: https://{text}\r\nUpgrade: websocket\r\nSec-WebSocket-Key: k\r\n\r\n");
            let plain = text.trim().chars().all(|c| c.is_ascii_hexdigit() || ".:[]".contains(c)) || text.contains("localhost");
            prop_assert!(plain || matches!(parse(head.as_bytes()), Request::Refused(..)));
        }
    }

    #[test]
    fn a_head_without_end_is_given_up() {
        let mut endless = std::io::repeat(b'x');
        let later = Instant::now() + std::time::Duration::from_secs(5);
        assert!(read_head(&mut endless, later).is_err());
    }
}
