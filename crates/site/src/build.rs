//! The site from its parts.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{SiteError, at};
use crate::{bind, bytes_sent, compress, docs, page, sound, stamp};

/// What the site is made of.
#[derive(clap::Args)]
pub struct Build {
    /// The module that cargo compiled from saute-web.
    #[arg(long)]
    wasm: PathBuf,
    /// The module that cargo compiled from saute-sound-page.
    #[arg(long)]
    sound: PathBuf,
    /// The folder for the site; its contents are replaced.
    #[arg(long)]
    out: PathBuf,
    /// The program wasm-opt; without it the module stays larger.
    #[arg(long)]
    wasm_opt: Option<PathBuf>,
    /// For a quick look: writes no compressed files, and checks no sizes.
    #[arg(long)]
    quick: bool,
    /// Quality of brotli, 0 to 11: less makes the site sooner and its files larger.
    #[arg(long, default_value_t = compress::BEST, value_parser = clap::value_parser!(i32).range(0..=11))]
    brotli: i32,
    /// The address at which the site will be: where it is shared, it is shown with a picture.
    #[arg(long, value_parser = page::address)]
    address: Option<String>,
    /// Bytes that the page may send before the first interaction.
    #[arg(long, default_value_t = bytes_sent::BUDGET)]
    most: u64,
}

impl Build {
    /// Makes the site, unless it is made of the same parts already.
    pub fn run(&self) -> Result<(), SiteError> {
        let root = Path::new(".");
        let stamp = stamp::of(&self.inputs(root)?, self.wasm_opt.is_some(), self.brotli, self.address.as_deref())?;
        if self.quick || !stamp::is_on(&self.out, &stamp) {
            self.make(root)?;
        }
        if self.quick {
            return Ok(());
        }
        bytes_sent::check(&self.out, self.most)?;
        stamp::put(&self.out, &stamp)
    }

    fn inputs(&self, root: &Path) -> Result<Vec<PathBuf>, SiteError> {
        let mut inputs = vec![self.wasm.clone(), self.sound.clone()];
        inputs.extend(page::sources(root)?);
        inputs.extend(docs::inputs(root)?);
        Ok(inputs)
    }

    fn make(&self, root: &Path) -> Result<(), SiteError> {
        if self.out.exists() {
            fs::remove_dir_all(&self.out).map_err(at(&self.out))?;
        }
        println!("binding the module to JavaScript");
        bind::bind(&self.wasm, &self.out)?;
        if let Some(program) = &self.wasm_opt {
            println!("wasm-opt: two minutes");
            bind::optimise(program, &self.out)?;
        }
        sound::add(&self.sound, &self.out)?;
        page::add(root, &self.out, self.address.as_deref())?;
        docs::add(root, &self.out)?;
        if self.quick {
            return Ok(());
        }
        println!("compressing: {}", if self.brotli == compress::BEST { "a minute" } else { "some seconds" });
        compress::compress(&self.out, self.brotli)
    }
}
