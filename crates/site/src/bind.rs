//! The compiled module, bound to JavaScript and made small.

use std::fs;
use std::path::Path;
use std::process::Command;

use wasm_bindgen_cli_support::Bindgen;

use crate::error::{SiteError, at};
use crate::page::{MODULE, SCRIPT};

/// What every browser of the last years has. `--all-features` would make wasm-opt write compact imports, which Chromium
/// refuses.
const FEATURES: [&str; 7] = [
    "--enable-bulk-memory",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
    "--enable-simd",
];

/// Writes the module and its JavaScript into a folder.
pub fn bind(wasm: &Path, folder: &Path) -> Result<(), SiteError> {
    let words = |error| SiteError::Bind(format!("{error:#}"));
    let mut bindgen = Bindgen::new();
    bindgen.input_path(wasm).out_name(SCRIPT.trim_end_matches(".js"));
    bindgen.web(true).map_err(words)?.typescript(false).remove_name_section(true).remove_producers_section(true);
    // The loader passes the module; without it a second copy of its address would be in the JavaScript.
    bindgen.omit_default_module_path(true);
    bindgen.generate(folder).map_err(words)
}

/// Lets wasm-opt rewrite the module in a folder.
pub fn optimise(program: &Path, folder: &Path) -> Result<(), SiteError> {
    let failed = |reason: String| SiteError::Optimise { program: program.to_owned(), reason };
    let (module, smaller) = (folder.join(MODULE), folder.join("smaller.wasm"));
    let run = Command::new(program).arg("-O2").args(FEATURES).arg(&module).arg("-o").arg(&smaller).output();
    let output = run.map_err(|error| failed(error.to_string()))?;
    if !output.status.success() {
        return Err(failed(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    fs::rename(&smaller, &module).map_err(at(&smaller))
}
