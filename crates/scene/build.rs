//! Shaders without their comments and indents: the page sends them.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src/shaders");
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?);
    for folder in ["src/shaders", "src/shaders/post"] {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if let (Some("wgsl"), Some(name)) = (path.extension().and_then(|e| e.to_str()), path.file_name()) {
                fs::write(to.join(name), bare(&path)?)?;
            }
        }
    }
    Ok(())
}

/// A shader's lines, each without its comment and the space round it; empty ones go.
fn bare(path: &Path) -> io::Result<String> {
    let text = fs::read_to_string(path)?;
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default().trim());
    Ok(lines.filter(|line| !line.is_empty()).flat_map(|line| [line, "\n"]).collect())
}
