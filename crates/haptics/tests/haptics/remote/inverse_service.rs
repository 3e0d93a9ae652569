//! A simulated Inverse service: first an inventory, then one answer per message.

use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use glam::DVec3;
use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

/// State that the test sets and reads.
#[derive(Clone)]
pub struct InverseService {
    pub address: SocketAddr,
    state: Arc<Mutex<State>>,
}

#[derive(Default)]
struct State {
    place: DVec3,
    grip: Option<[f64; 4]>,
    buttons: [bool; 3],
    uncalibrated: bool,
    force: DVec3,
    strongest: f64,
    first: Option<Value>,
    garbage: Vec<String>,
    hangs_up: bool,
    drips: bool,
    heard: Vec<(Instant, DVec3)>,
    messages: u64,
}

impl InverseService {
    pub fn start() -> Self {
        Self::at("127.0.0.1:0".parse().unwrap())
    }

    pub fn at(address: SocketAddr) -> Self {
        let listener = TcpListener::bind(address).unwrap();
        let service = Self { address: listener.local_addr().unwrap(), state: Arc::default() };
        let own = service.clone();
        std::thread::spawn(move || {
            while let Ok((stream, _)) = listener.accept() {
                own.serve(stream);
            }
        });
        service
    }

    pub fn put(&self, place: DVec3) {
        self.state.lock().unwrap().place = place;
    }

    pub fn hold(&self, wxyz: [f64; 4], buttons: [bool; 3]) {
        let mut state = self.state.lock().unwrap();
        (state.grip, state.buttons) = (Some(wxyz), buttons);
    }

    pub fn calibrate(&self, calibrated: bool) {
        self.state.lock().unwrap().uncalibrated = !calibrated;
    }

    /// Sets the next answers.
    pub fn babble(&self, garbage: &[&str]) {
        self.state.lock().unwrap().garbage = garbage.iter().map(|s| (*s).to_owned()).collect();
    }

    /// Closes this and all further connections while `hangs_up` is true.
    pub fn hang_up(&self, hangs_up: bool) {
        self.state.lock().unwrap().hangs_up = hangs_up;
    }

    /// Sends the answer to the next message byte by byte and never ends it.
    pub fn drip(&self) {
        self.state.lock().unwrap().drips = true;
    }

    /// Returns the forces so far, with the times at which they came.
    pub fn heard(&self) -> Vec<(Instant, DVec3)> {
        self.state.lock().unwrap().heard.clone()
    }

    /// Returns the last force, the largest force, and the number of messages.
    pub fn felt(&self) -> (DVec3, f64, u64) {
        let state = self.state.lock().unwrap();
        (state.force, state.strongest, state.messages)
    }

    pub fn first_message(&self) -> Option<Value> {
        self.state.lock().unwrap().first.clone()
    }

    fn serve(&self, stream: TcpStream) {
        stream.set_read_timeout(Some(Duration::from_secs(5))).unwrap();
        stream.set_nodelay(true).unwrap();
        let Ok(mut socket) = tungstenite::accept(stream) else { return };
        self.state.lock().unwrap().first = None;
        let inventory = self.state.lock().unwrap().answer(true);
        if socket.send(Message::text(inventory)).is_err() {
            return;
        }
        while self.exchange(&mut socket) {}
    }

    fn exchange(&self, socket: &mut WebSocket<TcpStream>) -> bool {
        let Ok(Message::Text(text)) = socket.read() else { return false };
        let answer = {
            let mut state = self.state.lock().unwrap();
            if state.hangs_up {
                return false;
            }
            state.receive(&text);
            if std::mem::take(&mut state.drips) {
                drop(state);
                return self.keep_dripping(socket);
            }
            state.garbage.pop().unwrap_or_else(|| state.answer(false))
        };
        socket.send(Message::text(answer)).is_ok()
    }
}

impl InverseService {
    /// Drips an endless answer, while it still listens.
    fn keep_dripping(&self, socket: &mut WebSocket<TcpStream>) -> bool {
        let stream = socket.get_mut().try_clone().unwrap();
        let dripping = std::thread::spawn(move || {
            let mut stream = stream;
            // A text frame of 60 000 bytes begins, and a byte follows every 5 ms.
            let begun = Instant::now();
            let mut on = stream.write_all(&[0x81, 126, 0xea, 0x60]).is_ok();
            while on && begun.elapsed() < Duration::from_secs(2) {
                on = stream.write_all(b" ").is_ok();
                std::thread::sleep(Duration::from_millis(5));
            }
        });
        while let Ok(Message::Text(text)) = socket.read() {
            self.state.lock().unwrap().receive(&text);
        }
        dripping.join().unwrap();
        false
    }
}

fn vector(v: DVec3) -> Value {
    json!({ "x": v.x, "y": v.y, "z": v.z })
}

impl State {
    fn receive(&mut self, text: &str) {
        let message: Value = serde_json::from_str(text).unwrap();
        let device = &message["inverse3"][0];
        assert_eq!(device["device_id"], "049D");
        let number = |axis: &str| device["commands"]["set_cursor_force"]["vector"][axis].as_f64().unwrap();
        self.force = DVec3::new(number("x"), number("y"), number("z"));
        self.strongest = self.strongest.max(self.force.length());
        self.heard.push((Instant::now(), self.force));
        self.messages += 1;
        self.first.get_or_insert(message);
    }

    fn answer(&self, with_config: bool) -> String {
        let mut device = json!({
            "device_id": "049D",
            "state": {
                "cursor_position": vector(self.place),
                "cursor_velocity": vector(DVec3::X * 0.1),
                "current_cursor_force": vector(self.force),
                "control_mode": "force",
            },
            "status": { "calibrated": !self.uncalibrated, "in_use": true },
        });
        if with_config {
            device["config"] = json!({ "type": "inverse3", "preset": "defaults", "handedness": "right" });
        }
        let mut answer = json!({ "session_id": 7, "inverse3": [device] });
        if let Some([w, x, y, z]) = self.grip {
            let [a, b, c] = self.buttons;
            let orientation = json!({ "w": w, "x": x, "y": y, "z": z });
            let buttons = json!({ "a": a, "b": b, "c": c });
            answer["wireless_verse_grip"] =
                json!([{ "device_id": "61548", "state": { "orientation": orientation, "buttons": buttons } }]);
        }
        answer.to_string()
    }
}
