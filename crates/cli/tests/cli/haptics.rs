//! `saute haptics`: capabilities of devices, and the control loop with a simulated device in its own process.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use serde_json::Value;

use crate::running::{Ran, run};

/// Builds the simulator next to the command, as ./run.sh does.
fn build_simulator() {
    let beside = Path::new(env!("CARGO_BIN_EXE_saute")).parent().unwrap();
    let mut cargo = Command::new(env!("CARGO"));
    // With the features of the workspace, as the command was built: nothing is built again.
    cargo.args(["build", "--offline", "--quiet", "--workspace", "--bin", "saute-spidar-sim", "--target-dir"]);
    cargo.arg(beside.parent().unwrap()).current_dir(env!("CARGO_MANIFEST_DIR"));
    if beside.ends_with("release") {
        cargo.arg("--release");
    }
    assert!(cargo.status().unwrap().success(), "the simulator was not built");
}

#[test]
fn devices_are_listed_with_their_capabilities_and_what_they_can_show() {
    let list: Value = serde_json::from_str(&run(&["haptics", "list", "--json"]).out).unwrap();
    let ids: Vec<&str> = list.as_array().unwrap().iter().map(|d| d["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["spidar-frame", "spidar-pan", "spidar-pan-crossed", "phone", "haply", "osc"]);
    let pan = &list[2];
    assert_eq!(pan["capabilities"]["dof_actuated"], 6);
    assert_eq!(pan["capabilities"]["holds_real_pan"], true);
    let (up, down) = (&pan["workspace"]["home"]["plus"][2], &pan["workspace"]["home"]["minus"][2]);
    assert!(up.as_f64() < Some(4.0) && down.as_f64() > Some(15.0), "motors below pull down: {up} {down}");
    assert!((0..3).all(|i| list[i]["workspace"]["singular_poses"] == 0), "{list}");
    let shown: Vec<&str> = list.as_array().unwrap().iter().map(|d| d["rendering"].as_str().unwrap()).collect();
    assert_eq!(shown, ["wrench", "wrench", "wrench", "rumble", "force", "sound-and-picture"]);
    assert!((3..6).all(|i| list[i].get("tension_n").is_none() && list[i]["place"].is_string()), "{list}");
    let ran = run(&["haptics", "list"]).out;
    assert!(
        ran.contains("spidar-frame  Eight strings in a frame") && ran.contains("phone  A phone in the hand"),
        "{ran}"
    );
    assert!(ran.contains("at 127.0.0.1:8443 unless @HOST:PORT is given: this machine only"), "{ran}");
}

#[test]
fn the_loop_holds_through_the_real_socket_and_survives_every_fault() {
    build_simulator();
    let ran = run(&["haptics", "check", "--for-s", "5", "--faults", "--json"]);
    let report: Value = serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{e}: {}", ran.err));
    let number =
        |path: &str| report.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}: {report}"));
    // How punctual a thread is depends on the machine; that it is measured does not.
    assert!(number("/rate_hz") > 0.0 && number("/jitter_us/p50") > 0.0 && number("/jitter_us/max") > 0.0, "{report}");
    assert!(number("/jitter_us/p99") >= number("/jitter_us/p50"));
    assert!(report["scheduler"].as_str().unwrap().len() > 4);
    assert!(number("/pose_error/mm") < 0.5 && number("/pose_error/deg") < 0.2, "{report}");
    assert!(number("/wrench_error/n") < 1.0 && number("/wrench_error/nm") < 0.1, "{report}");
    assert!(number("/max_force_n") <= number("/force_limit_n") + 0.01 && number("/max_force_n") > 5.0, "{report}");
    assert!(number("/passivity_j") >= 0.0 && number("/passivity_j") <= 0.005, "{report}");
    assert!(number("/contents_kg") > 0.25, "the steak is still in the pan: {report}");
    assert!(report["dropouts"].is_u64());
    let faults = report["faults"].as_array().unwrap();
    let kinds: Vec<&str> = faults.iter().map(|f| f["kind"].as_str().unwrap()).collect();
    let expected = [
        "packet loss 1 %",
        "delay 5 ms",
        "malformed packets 5 %",
        "unplugged and plugged in",
        "wrong units",
        "no contact model",
    ];
    assert_eq!(kinds, expected);
    let outcome = |i: usize| faults[i]["outcome"].as_str().unwrap();
    // A busy machine itself may be silent for a while.
    assert!((0..3).all(|i| outcome(i).starts_with("ran on") || outcome(i).starts_with("lost for a while")), "{report}");
    assert!(outcome(3).contains("after it was plugged in") && outcome(4).starts_with("refused"), "{report}");
    assert!(outcome(5).starts_with("faded"), "{report}");
}

#[test]
fn an_uncrossed_device_is_checked_by_name_in_words() {
    build_simulator();
    let ran = run(&["haptics", "check", "--device", "spidar-pan", "--for-s", "1"]);
    for word in ["rate", "lateness", "pose error", "wrench error", "passivity", "simulated in its own process"] {
        assert!(ran.out.contains(word), "{word}: {} {}", ran.out, ran.err);
    }
}

#[test]
fn bad_orders_are_refused_with_what_to_do() {
    let refused = |args: &[&str], words: &[&str]| {
        let ran = run(&[&["haptics", "check"], args].concat());
        assert_eq!(ran.code, Some(2), "{args:?}: {}", ran.err);
        assert!(words.iter().all(|w| ran.err.contains(w)), "{args:?}: {}", ran.err);
    };
    refused(&["--device", "spidar-pot"], &["spidar-pot", "there is no such device", "spidar-pan-crossed"]);
    refused(&["--device", "spidar-pot"], &["phone, haply, osc"]);
    refused(&["--device", "phone@no-such-host"], &["no-such-host", "is no address", "give HOST:PORT"]);
    refused(&["--device", "phone", "--faults"], &["--faults", "faults cannot be injected"]);
    refused(
        &["--device", "phone@127.0.0.1:0", "--wait-s", "0.3"],
        &["does not answer", "pairing code", "this machine alone"],
    );
    refused(&["--for-s", "0"], &["--for-s 0", "1 to 3600"]);
    refused(&["--still-s", "nan"], &["--still-s NaN", "0.1 to 3600"]);
    refused(&["--faults", "--device", "spidar-pan@127.0.0.1:9"], &["--faults", "faults cannot be injected"]);
    refused(&["--device", "spidar-pan@/dev/no-such-port"], &["/dev/no-such-port", "serial port", "HOST:PORT"]);
}

#[test]
fn a_missing_simulator_is_named_with_the_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let lonely: PathBuf = folder.path().join("saute");
    let own = env!("CARGO_BIN_EXE_saute");
    if std::fs::hard_link(own, &lonely).is_err() {
        std::fs::copy(own, &lonely).unwrap();
    }
    let ran: Ran = Command::new(&lonely).args(["haptics", "check", "--for-s", "1"]).output().unwrap().into();
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("the simulator is not there") && ran.err.contains("cargo build --release"), "{}", ran.err);
}

/// Starts the simulator as a device that is already switched on; returns it with its address.
fn switched_on(pairing: &str, hand: &str) -> (Child, String) {
    build_simulator();
    let program = Path::new(env!("CARGO_BIN_EXE_saute")).with_file_name("saute-spidar-sim");
    let args = ["--device", "spidar-pan", "--quiet", "--end-with-stdin", "--pairing", pairing, "--hand", hand];
    let mut child = Command::new(program).args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let lines = BufReader::new(child.stdout.take().unwrap()).lines().map_while(Result::ok);
    let address = lines.take(2).last().unwrap().strip_prefix("listening on ").unwrap().to_owned();
    (child, address)
}

#[test]
fn a_device_at_an_address_is_used_with_its_pairing_code_and_only_with_it() {
    let (mut child, address) = switched_on("424242", "1");
    let device = format!("spidar-pan@{address}");
    let check =
        |code: &str| run(&["haptics", "check", "--device", &device, "--pairing", code, "--for-s", "1", "--json"]);
    let stranger = check("1");
    assert_eq!(stranger.code, Some(2));
    assert!(
        stranger.err.contains("refuses the pairing code") && stranger.err.contains("--pairing CODE"),
        "{}",
        stranger.err
    );
    let report: Value = serde_json::from_str(&check("424242").out).unwrap();
    assert_eq!((&report["simulated"], &report["pose_error"]), (&false.into(), &Value::Null));
    assert!(report["max_force_n"].as_f64() > Some(3.0), "{report}");
    drop(child.stdin.take());
    child.wait().unwrap();
}

/// Starts a check of a device that is switched on and waits until it is measured. Its later output is read and dropped.
fn measured(address: &str, args: &[&str]) -> Child {
    measured_by(Command::new(env!("CARGO_BIN_EXE_saute")), address, args)
}

/// [`measured`] by a command that starts the program.
fn measured_by(mut command: Command, address: &str, args: &[&str]) -> Child {
    let device = format!("spidar-pan@{address}");
    command.args(["haptics", "check", "--pairing", "424242", "--json", "--device", &device]).args(args);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines().map_while(Result::ok);
    assert!(lines.any(|line| line.starts_with("measuring for")), "it is found and calibrated");
    std::thread::spawn(move || lines.count());
    child
}

/// Returns exit code, state of the device and the missed goals.
fn verdict(child: Child) -> (Option<i32>, String, String) {
    let ran: Ran = child.wait_with_output().unwrap().into();
    let report: Value = serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{e}: {} {}", ran.out, ran.err));
    let text = |path: &str| report.pointer(path).and_then(Value::as_str).unwrap_or_default().to_owned();
    (ran.code, text("/health"), report["missed"].to_string())
}

#[test]
fn a_device_that_dies_or_reports_a_fault_falls_short() {
    let (mut dying, address) = switched_on("424242", "1");
    let check = measured(&address, &["--for-s", "2"]);
    dying.kill().unwrap();
    dying.wait().unwrap();
    let (code, health, missed) = verdict(check);
    assert_eq!((code, health.as_str()), (Some(1), "lost"));
    assert!(missed.contains("went silent") && missed.contains("cable"), "{missed}");

    let (mut ill, address) = switched_on("424242", "1");
    let check = measured(&address, &["--for-s", "2"]);
    std::io::Write::write_all(ill.stdin.as_mut().unwrap(), b"fault 1\n").unwrap();
    let (code, health, missed) = verdict(check);
    assert_eq!((code, health.as_str()), (Some(1), "fault"));
    assert!(missed.contains("reports a fault"), "{missed}");
    // It is found at once, and still falls short.
    let args = ["haptics", "check", "--pairing", "424242", "--for-s", "1", "--device"];
    let ran = run(&[&args[..], &[&format!("spidar-pan@{address}")]].concat());
    assert!(ran.code == Some(1) && ran.err.contains("reports a fault"), "{:?} {}", ran.code, ran.err);
    drop(ill.stdin.take());
    ill.wait().unwrap();
}

#[test]
fn a_pan_that_stands_still_for_longer_than_stated_falls_short_and_its_passivity_is_not_judged() {
    let (mut still, address) = switched_on("424242", "1");
    let check = measured(&address, &["--for-s", "4", "--still-s", "1.5"]);
    // A free pan would drift when a busy machine is late with its tensions: a device that measures nothing is still on any machine.
    std::io::Write::write_all(still.stdin.as_mut().unwrap(), b"encoders stuck\n").unwrap();
    let (code, _, missed) = verdict(check);
    assert_eq!(code, Some(1));
    assert!(missed.contains("stood still for") && missed.contains("1.5 s are allowed"), "{missed}");
    drop(still.stdin.take());
    still.wait().unwrap();
}

#[cfg(target_os = "linux")]
#[test]
fn a_closed_terminal_ends_a_check() {
    use std::os::unix::process::ExitStatusExt;
    let (mut device, address) = switched_on("424242", "1");
    // A run that was started by `nohup` passes on that a closed terminal is ignored: here it is not.
    let mut command = Command::new("env");
    command.args(["--default-signal=HUP", env!("CARGO_BIN_EXE_saute")]);
    let mut check = measured_by(command, &address, &["--for-s", "60"]);
    assert!(Command::new("kill").args(["-s", "HUP", &check.id().to_string()]).status().unwrap().success());
    assert_eq!(check.wait().unwrap().signal(), Some(1));
    drop(device.stdin.take());
    device.wait().unwrap();
}

#[test]
fn the_simulator_refuses_places_that_are_not_finite_with_the_reason() {
    build_simulator();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    let shipped = include_str!("../../../../data/haptics/devices/spidar-pan.toml");
    let program = Path::new(env!("CARGO_BIN_EXE_saute")).with_file_name("saute-spidar-sim");
    for number in ["nan", "inf", "-inf"] {
        std::fs::write(&file, shipped.replacen("home_mm = [0,", &format!("home_mm = [{number},"), 1)).unwrap();
        let ran: Ran = Command::new(&program).arg("--device").arg(&file).output().unwrap().into();
        assert_eq!(ran.code, Some(2), "{number}: {}", ran.err);
        assert!(["mine.toml", "home_mm has", "-5000 to 5000"].iter().all(|w| ran.err.contains(w)), "{}", ran.err);
        let device = file.to_str().unwrap();
        let ran = run(&["haptics", "check", "--for-s", "1", "--device", device]);
        assert!(ran.code == Some(2) && ran.err.contains("home_mm has"), "{}", ran.err);
    }
}

#[test]
fn the_simulator_does_not_open_itself_to_the_network_without_a_code() {
    build_simulator();
    let program = Path::new(env!("CARGO_BIN_EXE_saute")).with_file_name("saute-spidar-sim");
    let ran: Ran = Command::new(program).args(["--bind", "0.0.0.0:0", "--pairing", "0"]).output().unwrap().into();
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("remedy: give a code"), "{}", ran.err);
}

/// Starts a check that listens for OSC; returns it with its address and pairing code.
fn listening() -> (Child, String, String) {
    let args = ["haptics", "check", "--device", "osc@127.0.0.1:0", "--for-s", "2", "--wait-s", "20", "--json"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_saute"));
    let mut child =
        command.args(args).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines().map_while(Result::ok);
    let place = lines.find_map(|l| Some(l.strip_prefix("at ")?.split(',').next()?.to_owned())).unwrap();
    let code = lines.find_map(|l| Some(l.strip_prefix("pairing code ")?.to_owned())).unwrap();
    // The rest must be read, or the child would block on a full pipe.
    std::thread::spawn(move || lines.count());
    (child, place, code)
}

/// What a check gives while somebody sends, sixty times a second or so.
fn ran_while(check: std::process::Child, send: impl Fn() + Sync) -> Ran {
    let sending = std::sync::atomic::AtomicBool::new(true);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while sending.load(std::sync::atomic::Ordering::Acquire) {
                send();
                std::thread::sleep(std::time::Duration::from_millis(15));
            }
        });
        let output = check.wait_with_output().unwrap();
        sending.store(false, std::sync::atomic::Ordering::Release);
        output.into()
    })
}

/// Returns the report of a check that missed nothing but what a busy machine makes late: rate and silence.
fn unless_late(ran: &Ran) -> Value {
    let report: Value = serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{e}: {}", ran.err));
    let missed: Vec<&str> = report["missed"].as_array().unwrap().iter().map(|m| m.as_str().unwrap()).collect();
    let late = |m: &&str| m.contains("messages/s") || m.contains("it went silent");
    assert!(missed.iter().all(late), "{report}");
    assert_eq!(ran.code, Some(i32::from(!missed.is_empty())), "{report}");
    report
}

#[test]
fn a_sender_of_floats_alone_pairs_and_reads_why_a_message_was_rejected() {
    let (child, place, code) = listening();
    let socket = std::net::UdpSocket::bind("127.0.0.1:0").unwrap();
    let send = |addr: &str, floats: &[f32]| {
        let args = floats.iter().map(|v| rosc::OscType::Float(*v)).collect();
        let packet = rosc::OscPacket::Message(rosc::OscMessage { addr: addr.into(), args });
        let _ = socket.send_to(&rosc::encoder::encode(&packet).unwrap(), &place);
    };
    send("/saute/pair/", &[code.parse().unwrap()]);
    let ran = ran_while(child, || {
        send("/saute/pan/tilt", &[10.0, 0.0]);
        send("/saute/button", &[1.0, 1.0]);
        send("/saute/pan/tilt", &[f32::NAN, 0.0]);
    });
    let report = unless_late(&ran);
    assert!((report["tilted_deg"].as_f64().unwrap() - 10.0).abs() < 0.1, "{report}");
    let why = report["rejections"].as_array().unwrap();
    assert_eq!(why.len(), 1, "each reason once: {report}");
    assert!(why[0].as_str().unwrap().contains("a number that is not finite"), "{report}");
}

#[test]
fn a_sender_of_osc_is_checked_with_the_code_that_the_screen_shows() {
    let (child, place, code) = listening();
    let socket = std::net::UdpSocket::bind("127.0.0.1:0").unwrap();
    let send = |addr: &str, args: Vec<rosc::OscType>| {
        let packet = rosc::OscPacket::Message(rosc::OscMessage { addr: addr.into(), args });
        // Nobody listens once the check is over.
        let _ = socket.send_to(&rosc::encoder::encode(&packet).unwrap(), &place);
    };
    send("/saute/pair", vec![rosc::OscType::String(code)]);
    let ran = ran_while(child, || {
        send("/saute/pan/tilt", vec![rosc::OscType::Float(0.0), rosc::OscType::Float(12.0)]);
        send("/saute/nonsense", Vec::new());
    });
    let report = unless_late(&ran);
    assert!((report["tilted_deg"].as_f64().unwrap() - 12.0).abs() < 0.1, "{report}");
    assert!(report["messages_hz"].as_f64() > Some(0.0) && report["rejected"].as_u64() > Some(0), "{report}");
}
