//! Promise: `saute-site serve` sends a folder, compressed to those that accept it, and nothing outside of the folder.

#![allow(clippy::unwrap_used)]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};

struct Server {
    program: Child,
    address: String,
}

impl Server {
    fn start(folder: &Path, more: &[&str]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_saute-site"));
        command.arg("serve").arg(folder).args(["--port", "0"]).args(more).stdout(Stdio::piped());
        let mut program = command.spawn().unwrap();
        let mut line = String::new();
        BufReader::new(program.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.split("http://").nth(1).and_then(|rest| rest.split('/').next()).unwrap().to_owned();
        Self { program, address }
    }

    /// The answer to a request for a path, in lower case.
    fn get(&self, path: &str, accept: &str) -> String {
        let mut stream = TcpStream::connect(&self.address).unwrap();
        let request =
            format!("GET {path} HTTP/1.1\r\nHost: x\r\nAccept-Encoding: {accept}\r\nConnection: close\r\n\r\n");
        stream.write_all(request.as_bytes()).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        String::from_utf8_lossy(&answer).to_lowercase()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

/// A folder in a folder, with a file in three forms, and a secret outside.
fn folder() -> tempfile::TempDir {
    let outside = tempfile::tempdir().unwrap();
    std::fs::create_dir(outside.path().join("site")).unwrap();
    for (name, text) in
        [("secret.txt", "key"), ("site/a.wasm", "plain"), ("site/a.wasm.br", "brotli"), ("site/a.wasm.gz", "gzip")]
    {
        std::fs::write(outside.path().join(name), text).unwrap();
    }
    outside
}

#[test]
fn files_come_compressed_to_those_that_accept_it_and_are_asked_for_again_each_time() {
    let folder = folder();
    let server = Server::start(&folder.path().join("site"), &[]);
    for (accept, encoding, body) in [("gzip, br", "br", "brotli"), ("gzip", "gzip", "gzip")] {
        let answer = server.get("/a.wasm", accept);
        assert!(answer.contains(&format!("content-encoding: {encoding}")) && answer.ends_with(body), "{answer}");
        assert!(answer.contains("content-type: application/wasm"), "{answer}");
        assert!(answer.contains("cache-control: no-cache"), "{answer}");
    }
    assert!(server.get("/a.wasm", "identity").ends_with("plain"));
    let plain = Server::start(&folder.path().join("site"), &["--plain"]);
    let answer = plain.get("/a.wasm", "gzip, br");
    assert!(answer.ends_with("plain") && !answer.contains("content-encoding"), "{answer}");
}

#[test]
fn nothing_outside_of_the_folder_is_sent() {
    let folder = folder();
    let server = Server::start(&folder.path().join("site"), &[]);
    for path in ["/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "//../secret.txt", "/absent"] {
        let answer = server.get(path, "identity");
        assert!(!answer.contains("key") && !answer.starts_with("http/1.1 200"), "{path}: {answer}");
    }
}

#[test]
fn a_port_in_use_is_named_with_the_remedy() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let port = server.address.rsplit(':').next().unwrap();
    let mut second = Command::new(env!("CARGO_BIN_EXE_saute-site"));
    let output = second.arg("serve").arg(folder.path()).args(["--port", port]).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && said.contains(port) && said.contains("--port"), "{said}");
}
