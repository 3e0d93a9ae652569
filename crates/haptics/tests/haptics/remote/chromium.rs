//! A real browser, controlled with the DevTools protocol.

use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

const PROGRAMS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// A headless Chromium with one page; dropping it ends the process.
pub struct Chromium {
    child: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: Option<String>,
    number: u64,
    _profile: tempfile::TempDir,
}

impl Chromium {
    /// Starts the browser; panics if there is none.
    pub fn start() -> Self {
        let profile = tempfile::tempdir().unwrap();
        let child = PROGRAMS.iter().find_map(|program| launch(program, profile.path()).ok());
        let child = child
            .expect("THERE IS NO CHROMIUM: this test needs a real browser; ./test.sh installs the package chromium");
        let address = devtools(profile.path());
        let (socket, _) = tungstenite::connect(address).unwrap();
        let mut browser = Self { child, socket, session: None, number: 0, _profile: profile };
        let target = browser.call("Target.createTarget", json!({ "url": "about:blank" }))["targetId"].clone();
        let attached = browser.call("Target.attachToTarget", json!({ "targetId": target, "flatten": true }));
        browser.session = attached["sessionId"].as_str().map(str::to_owned);
        browser
    }

    /// Calls a method and returns its result.
    pub fn call(&mut self, method: &str, params: Value) -> Value {
        self.number += 1;
        let mut order = json!({ "id": self.number, "method": method, "params": params });
        if let Some(session) = &self.session {
            order["sessionId"] = json!(session);
        }
        self.socket.send(Message::text(order.to_string())).unwrap();
        loop {
            let message = self.socket.read().unwrap();
            let Ok(answer) = serde_json::from_str::<Value>(message.to_text().unwrap_or_default()) else { continue };
            if answer["id"] == self.number {
                assert!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                return answer["result"].clone();
            }
        }
    }

    /// Returns the value of an expression on the page.
    pub fn value(&mut self, expression: &str) -> Value {
        let params =
            json!({ "expression": expression, "awaitPromise": true, "returnByValue": true, "userGesture": true });
        self.call("Runtime.evaluate", params)["result"]["value"].clone()
    }

    /// Waits until an expression is true on the page.
    pub fn wait_for(&mut self, expression: &str) {
        let begun = Instant::now();
        while self.value(expression) != Value::Bool(true) {
            assert!(begun.elapsed() < Duration::from_secs(60), "timeout: {expression}");
            std::thread::sleep(Duration::from_millis(30));
        }
    }

    /// A picture of the page, as PNG.
    pub fn picture(&mut self, file: &Path) {
        let data = self.call("Page.captureScreenshot", json!({ "format": "png" }))["data"].clone();
        let bytes = data_encoding::BASE64.decode(data.as_str().unwrap().as_bytes()).unwrap();
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, bytes).unwrap();
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn launch(program: &str, profile: &Path) -> std::io::Result<Child> {
    let quiet = ["--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];
    let offline = ["--disable-component-update", "--disable-sync", "--ignore-certificate-errors"];
    Command::new(program)
        .args(["--headless", "--no-sandbox", "--remote-debugging-port=0", "--lang=en-GB"])
        .args(quiet)
        .args(offline)
        .arg(format!("--user-data-dir={}", profile.display()))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
}

/// Returns the browser's DevTools address, which it writes to a file when it is ready.
fn devtools(profile: &Path) -> String {
    let begun = Instant::now();
    loop {
        let text = std::fs::read_to_string(profile.join("DevToolsActivePort")).unwrap_or_default();
        if let [port, path] = text.lines().collect::<Vec<_>>()[..] {
            return format!("ws://127.0.0.1:{port}{path}");
        }
        assert!(begun.elapsed() < Duration::from_secs(60), "Chromium does not report its DevTools address");
        std::thread::sleep(Duration::from_millis(50));
    }
}
