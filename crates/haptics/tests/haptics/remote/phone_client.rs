//! A phone without a browser: TLS, one request, a socket, messages.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::time::{Duration, Instant};

use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::ring::default_provider;
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::{ClientConfig, ClientConnection, DigitallySignedStruct, SignatureScheme, StreamOwned};
use serde_json::Value;
use tungstenite::{Message, WebSocket};

/// Accepts any certificate, like a person who has compared its fingerprint.
#[derive(Debug)]
struct Trusting;

impl ServerCertVerifier for Trusting {
    fn verify_server_cert(
        &self,
        _: &CertificateDer<'_>,
        _: &[CertificateDer<'_>],
        _: &ServerName<'_>,
        _: &[u8],
        _: UnixTime,
    ) -> Result<ServerCertVerified, rustls::Error> {
        Ok(ServerCertVerified::assertion())
    }

    fn verify_tls12_signature(
        &self,
        _: &[u8],
        _: &CertificateDer<'_>,
        _: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        Ok(HandshakeSignatureValid::assertion())
    }

    fn verify_tls13_signature(
        &self,
        _: &[u8],
        _: &CertificateDer<'_>,
        _: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        Ok(HandshakeSignatureValid::assertion())
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        default_provider().signature_verification_algorithms.supported_schemes()
    }
}

pub type Tls = StreamOwned<ClientConnection, TcpStream>;

/// A TLS connection to an address.
pub fn connect(address: SocketAddr) -> Tls {
    let config = ClientConfig::builder_with_provider(Arc::new(default_provider()))
        .with_safe_default_protocol_versions()
        .unwrap()
        .dangerous()
        .with_custom_certificate_verifier(Arc::new(Trusting))
        .with_no_client_auth();
    let name = ServerName::from(address.ip());
    let tcp = TcpStream::connect(address).unwrap();
    tcp.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    StreamOwned::new(ClientConnection::new(Arc::new(config), name).unwrap(), tcp)
}

/// Returns the response to a plain request.
pub fn get(address: SocketAddr, path: &str) -> String {
    let mut stream = connect(address);
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\n\r\n").unwrap();
    let mut text = String::new();
    let _ = stream.read_to_string(&mut text);
    text
}

/// A phone's socket.
pub struct PhoneClient(pub WebSocket<Tls>);

impl PhoneClient {
    pub fn connect(address: SocketAddr) -> Self {
        Self::from(address, &format!("https://{address}")).unwrap()
    }

    pub fn from(address: SocketAddr, origin: &str) -> Result<Self, String> {
        let uri: tungstenite::http::Uri = format!("wss://{address}/pan").parse().unwrap();
        let request = tungstenite::ClientRequestBuilder::new(uri).with_header("Origin", origin);
        tungstenite::client(request, connect(address)).map(|(socket, _)| Self(socket)).map_err(|e| e.to_string())
    }

    pub fn send(&mut self, text: &str) {
        // The server may close the connection; the tests check the effect.
        let _ = self.0.send(Message::text(text));
    }

    /// Returns the next message of a kind within a minute, or `None` if the connection closes.
    pub fn receive(&mut self, kind: &str) -> Option<Value> {
        let begun = Instant::now();
        while begun.elapsed() < Duration::from_secs(60) {
            let Ok(message) = self.0.read() else { return None };
            let Ok(text) = message.to_text() else { continue };
            let Ok(value) = serde_json::from_str::<Value>(text) else { continue };
            if value["kind"] == kind {
                return Some(value);
            }
        }
        None
    }

    pub fn pair(&mut self, code: &str) {
        self.send(&format!(r#"{{"kind":"hello","code":"{code}"}}"#));
        assert!(self.receive("welcome").is_some(), "the right code was refused");
    }
}
