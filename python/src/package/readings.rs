//! Readings of the kitchens of a batch: the columns of a structured array.

use pyo3::prelude::*;
use saute_kitchen::{Kitchen, Piece, Place, celsius};

use crate::package::expected::seven;

/// Columns of a kitchen with one number.
const OF_KITCHEN: [&str; 7] = ["time_s", "hob_w", "hob_drawn_w", "pan_c", "busy", "oil_g", "water_g"];
/// Column of the pan's pose.
const PAN_POSE: (&str, usize) = ("pan_pose_m", 7);
/// Columns of each of its pieces.
const OF_PIECE: [&str; 20] = [
    "core_c",
    "core_peak_c",
    "top_c",
    "bottom_c",
    "mass_g",
    "lost_pct",
    "top_browned_pct",
    "bottom_browned_pct",
    "top_charred_pct",
    "bottom_charred_pct",
    "top_lab_l",
    "top_lab_a",
    "top_lab_b",
    "in_pan",
    "upside_down",
    "spilled",
    "x_mm",
    "y_mm",
    "z_mm",
    "pan_force_n",
];

fn truth(value: bool) -> f64 {
    f64::from(u8::from(value))
}

/// Reads the columns of a kitchen, column after column, as a structured array has them.
pub(crate) fn row(kitchen: &Kitchen) -> Vec<f64> {
    let liquids = kitchen.pan_state();
    let own = [
        kitchen.time_s(),
        kitchen.hob_w(),
        kitchen.hob_drawn_w(),
        celsius(kitchen.pan_temperature()),
        truth(kitchen.busy()),
        1e3 * liquids.oil_mass(),
        1e3 * liquids.water_mass(),
    ];
    let pieces: Vec<_> = kitchen.pieces().iter().map(|piece| of_piece(kitchen, piece)).collect();
    let columns = (0..OF_PIECE.len()).flat_map(|k| pieces.iter().map(move |piece| piece[k]));
    own.into_iter().chain(seven(&kitchen.world().motion.pose)).chain(columns).collect()
}

fn of_piece(kitchen: &Kitchen, piece: &Piece) -> [f64; OF_PIECE.len()] {
    let face = |below: bool| piece.model.face_reading(&piece.state, piece.up().map(|u| if below { u } else { -u }));
    let (top, bottom) = (face(false), face(true));
    let mass = piece.mass();
    let pan = kitchen.world().motion.pose;
    let at = 1e3 * (pan.rotation.inverse() * (piece.pose.position - pan.position));
    [
        celsius(piece.core()),
        celsius(piece.core_peak.0),
        celsius(piece.face(false)),
        celsius(piece.face(true)),
        1e3 * mass,
        100.0 * (1.0 - mass / piece.model.raw_mass()),
        top.browned_pct,
        bottom.browned_pct,
        top.charred_pct,
        bottom.charred_pct,
        top.lab.0[0],
        top.lab.0[1],
        top.lab.0[2],
        truth(piece.in_pan()),
        truth(piece.upside_down()),
        truth(matches!(piece.place, Place::Glass | Place::Table)),
        at.x,
        at.y,
        at.z,
        piece.pan_force(),
    ]
}

/// Returns NumPy's type of a row of readings.
pub(crate) fn kind(py: Python<'_>, pieces: usize) -> PyResult<Py<PyAny>> {
    let own = OF_KITCHEN.map(|name| (name, "<f8").into_pyobject(py).map(Bound::into_any));
    let pose = (PAN_POSE.0, "<f8", (PAN_POSE.1,)).into_pyobject(py).map(Bound::into_any);
    let piece = OF_PIECE.map(|name| (name, "<f8", (pieces,)).into_pyobject(py).map(Bound::into_any));
    let columns: Vec<Bound<'_, PyAny>> = own.into_iter().chain([pose]).chain(piece).collect::<PyResult<_>>()?;
    Ok(py.import("numpy")?.getattr("dtype")?.call1((columns,))?.unbind())
}
