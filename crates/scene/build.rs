//! Shaders without their comments, indents and the spaces that mean nothing: the page sends them.

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

/// Signs beside which a space means nothing. Not `-`: two of them would become one sign.
const SIGNS: &str = ",=+*/(){};:<>";

/// A shader's lines, each without its comment and spaces without a meaning; empty ones go.
fn bare(path: &Path) -> io::Result<String> {
    let text = fs::read_to_string(path)?;
    let lines = text.lines().map(|line| closed_up(line.split("//").next().unwrap_or_default().trim()));
    Ok(lines.filter(|line| !line.is_empty()).flat_map(|line| [line, "\n".into()]).collect())
}

/// A line without the spaces beside signs.
fn closed_up(line: &str) -> String {
    let mut found = String::with_capacity(line.len());
    for part in line.split(' ') {
        let joined = found.ends_with(|c| SIGNS.contains(c)) || part.starts_with(|c| SIGNS.contains(c));
        if !(joined || found.is_empty()) {
            found.push(' ');
        }
        found.push_str(part);
    }
    found
}
