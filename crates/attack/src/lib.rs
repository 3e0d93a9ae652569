//! Every reader of files and messages, as a function of bytes that must neither panic, nor hang, nor take much memory.
//!
//! [`TARGETS`] lists them. The programs in `fuzz/` are one line each and call one function each, so that each contains
//! only its reader; the tests of this crate replay the kept inputs on the stable compiler. A target reads, checks, builds and, where it can be cooked, advances ten
//! ticks. Refusals are expected; a broken promise, as an energy balance that does not close, panics.

pub mod class_files;
pub mod device_messages;
pub mod dictionary;
pub mod doors;
pub mod handed_in;
mod kept_inputs;
pub mod kitchen_files;
pub mod lab_case;
pub mod machine_files;
pub mod stored;
pub mod surface_files;
pub mod sweep_files;
mod ten_ticks;

pub use kept_inputs::{Input, folder, in_folder, kept};

/// What a target does with an input that is sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Reads and checks bytes or text.
    Reads,
    /// Builds a body or a kitchen, and cooks.
    Builds,
}

/// One reader under attack.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Name of the target: of its program, its folders of inputs and its dictionary.
    pub name: &'static str,
    /// What it does.
    pub work: Work,
    /// Source files of the reader, of which the inputs must reach four lines of five; a folder ends with a slash.
    pub sources: &'static [&'static str],
    run: fn(&[u8]),
}

/// All targets.
pub const TARGETS: &[Target] = &[
    Target {
        name: "recipe",
        work: Work::Builds,
        sources: &["crates/recipe/src/file/", "crates/recipe/src/check/", "crates/recipe/src/condition.rs"],
        run: kitchen_files::recipe,
    },
    Target {
        name: "food",
        work: Work::Builds,
        sources: &[
            "crates/food/src/description/shape.rs",
            "crates/food/src/description/tissue.rs",
            "crates/food/src/description/properties.rs",
            "crates/food/src/description/lab_colour.rs",
            "crates/kitchen/src/data/relations/food.rs",
            "crates/kitchen/src/data/schema_walk.rs",
            "crates/kitchen/src/data/data_file.rs",
            "crates/kitchen/src/data/loading.rs",
        ],
        run: kitchen_files::food,
    },
    Target {
        name: "pan",
        work: Work::Builds,
        sources: &["crates/kitchen/src/data/relations/pan.rs", "crates/kitchen/src/pan/pan_description.rs"],
        run: kitchen_files::pan,
    },
    Target {
        name: "oil",
        work: Work::Builds,
        sources: &["crates/kitchen/src/data/relations/oil.rs", "crates/kitchen/src/liquids/oil.rs"],
        run: kitchen_files::oil,
    },
    Target {
        name: "kinetics",
        work: Work::Builds,
        sources: &["crates/food/src/description/kinetics.rs", "crates/kitchen/src/data/relations/kinetics.rs"],
        run: kitchen_files::kinetics,
    },
    Target {
        name: "lab",
        work: Work::Builds,
        sources: &["crates/lab/src/case/", "crates/lab/src/solve/work.rs"],
        run: lab_case::lab,
    },
    Target {
        name: "protocol",
        work: Work::Reads,
        sources: &["crates/study/src/protocol.rs", "crates/study/src/protocol_file.rs", "crates/study/src/check.rs"],
        run: class_files::protocol,
    },
    Target {
        name: "scenario",
        work: Work::Reads,
        sources: &["crates/study/src/class/scenario.rs", "crates/study/src/class/scenario_file.rs"],
        run: class_files::scenario,
    },
    Target {
        name: "goals",
        work: Work::Builds,
        sources: &["crates/kitchen/src/data/goals.rs", "crates/plan/src/aimed.rs"],
        run: class_files::goals,
    },
    Target {
        name: "study_log",
        work: Work::Reads,
        sources: &["crates/study/src/log_row.rs"],
        run: class_files::study_log,
    },
    Target {
        name: "class_result",
        work: Work::Reads,
        sources: &["crates/study/src/csv_rows.rs", "crates/study/src/class/result_row.rs"],
        run: handed_in::class_result,
    },
    Target { name: "log", work: Work::Reads, sources: &["crates/plan/src/fit/log/"], run: handed_in::log },
    Target { name: "link", work: Work::Reads, sources: &["crates/session/src/kept/link.rs"], run: handed_in::link },
    Target {
        name: "command",
        work: Work::Builds,
        sources: &["crates/kitchen/src/hands/ranges.rs"],
        run: handed_in::command,
    },
    Target {
        name: "sweep",
        work: Work::Builds,
        sources: &["crates/sweep/src/spec/", "crates/sweep/src/place.rs", "crates/sweep/src/documents.rs"],
        run: sweep_files::sweep,
    },
    Target {
        name: "stl",
        work: Work::Builds,
        sources: &["crates/surface/src/stl_file/", "crates/heat/src/mesh/surface/weld.rs"],
        run: surface_files::stl,
    },
    Target {
        name: "obj",
        work: Work::Builds,
        sources: &[
            "crates/surface/src/obj_file.rs",
            "crates/surface/src/text_lines.rs",
            "crates/heat/src/mesh/surface/defect.rs",
            "crates/heat/src/mesh/surface/crossing.rs",
        ],
        run: surface_files::obj,
    },
    Target { name: "gltf", work: Work::Builds, sources: &["crates/surface/src/gltf_file/"], run: surface_files::gltf },
    Target { name: "kitchen", work: Work::Builds, sources: &["crates/kitchen/src/bytes/"], run: stored::kitchen },
    Target {
        name: "session",
        work: Work::Reads,
        sources: &["crates/recipe/src/session/session_file.rs"],
        run: stored::session,
    },
    Target {
        name: "rig",
        work: Work::Reads,
        sources: &["crates/mirror/src/rig_file.rs", "crates/mirror/src/registration.rs"],
        run: machine_files::rig,
    },
    Target {
        name: "geometry",
        work: Work::Reads,
        sources: &["crates/haptics/src/strings/geometry.rs", "crates/haptics/src/strings/kept_calibration.rs"],
        run: machine_files::geometry,
    },
    Target {
        name: "settings",
        work: Work::Reads,
        sources: &["crates/controls/src/settings/remembered.rs", "crates/controls/src/settings/stored_zoom.rs"],
        run: machine_files::settings,
    },
    Target {
        name: "wire",
        work: Work::Reads,
        sources: &[
            "crates/haptics/src/strings/wire/frame.rs",
            "crates/haptics/src/strings/wire/message.rs",
            "crates/haptics/src/strings/wire/stuffing.rs",
            "crates/haptics/src/strings/caps_verdict.rs",
            "crates/haptics/src/strings/session.rs",
            "crates/spidar-sim/src/codec.rs",
        ],
        run: device_messages::wire,
    },
    Target {
        name: "phone",
        work: Work::Reads,
        sources: &[
            "crates/haptics/src/remote/phone/message.rs",
            "crates/haptics/src/remote/phone/orientation.rs",
            "crates/haptics/src/remote/phone/http.rs",
        ],
        run: device_messages::phone,
    },
    Target {
        name: "osc",
        work: Work::Reads,
        sources: &["crates/haptics/src/remote/osc/message.rs"],
        run: device_messages::osc,
    },
    Target {
        name: "haply",
        work: Work::Reads,
        sources: &["crates/haptics/src/remote/haply/message.rs"],
        run: device_messages::haply,
    },
];

impl Target {
    /// Returns the target with a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        TARGETS.iter().find(|target| target.name == name)
    }

    /// Hands an input to the reader.
    pub fn run(&self, bytes: &[u8]) {
        (self.run)(bytes);
    }
}

/// Returns an input as text; what is not UTF-8 is refused before any reader of text.
fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}
