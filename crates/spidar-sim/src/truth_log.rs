//! Ground truth at every sample, for comparison with the driver's estimates.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use crate::scene::Scene;

/// A CSV file, or none.
#[derive(Debug, Default)]
pub struct TruthLog(Option<BufWriter<File>>);

impl TruthLog {
    /// Creates the file and writes its header.
    pub fn create(path: Option<&Path>) -> std::io::Result<Self> {
        let Some(path) = path else { return Ok(Self(None)) };
        let mut file = BufWriter::new(File::create(path)?);
        writeln!(file, "time_us,x_m,y_m,z_m,qx,qy,qz,qw,fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm")?;
        Ok(Self(Some(file)))
    }

    /// Writes a row while the pan is in the hand.
    pub fn note(&mut self, time_us: u32, scene: &Scene) {
        let Some(file) = &mut self.0 else { return };
        if !scene.is_free() {
            return;
        }
        let ((f, t), pose) = (scene.wrench(), scene.pan.pose);
        let (p, q) = (pose.position, pose.rotation);
        let numbers = [p.x, p.y, p.z, q.x, q.y, q.z, q.w, f.x, f.y, f.z, t.x, t.y, t.z];
        let row = numbers.iter().fold(time_us.to_string(), |row, n| format!("{row},{n:.9}"));
        // A full disk must not stop the device; missing rows are visible to the reader.
        let _ = writeln!(file, "{row}");
    }

    /// Flushes the buffer.
    pub fn flush(&mut self) {
        if let Some(file) = &mut self.0 {
            let _ = file.flush();
        }
    }
}
