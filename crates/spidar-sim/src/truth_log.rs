//! What is true at every sample, for comparison with what a driver believes.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use crate::scene::Scene;

/// A CSV file, or nothing.
#[derive(Debug, Default)]
pub struct TruthLog(Option<BufWriter<File>>);

impl TruthLog {
    /// Opens the file.
    pub fn create(path: Option<&Path>) -> std::io::Result<Self> {
        let Some(path) = path else { return Ok(Self(None)) };
        let mut file = BufWriter::new(File::create(path)?);
        writeln!(file, "time_us,x_m,y_m,z_m,qx,qy,qz,qw,fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm")?;
        Ok(Self(Some(file)))
    }

    /// Notes the pan in the hand.
    pub fn note(&mut self, time_us: u32, scene: &Scene) {
        let Some(file) = &mut self.0 else { return };
        if !scene.is_free() {
            return;
        }
        let ((f, t), pose) = (scene.wrench(), scene.pan.pose);
        let (p, q) = (pose.position, pose.rotation);
        let numbers = [p.x, p.y, p.z, q.x, q.y, q.z, q.w, f.x, f.y, f.z, t.x, t.y, t.z];
        let row = numbers.iter().fold(time_us.to_string(), |row, n| format!("{row},{n:.9}"));
        // A full disk must not stop a device; the reader sees that rows are missing.
        let _ = writeln!(file, "{row}");
    }

    /// Writes out what is still held.
    pub fn flush(&mut self) {
        if let Some(file) = &mut self.0 {
            let _ = file.flush();
        }
    }
}
