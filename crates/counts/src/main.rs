//! Work whose instructions Callgrind counts: `saute-counts FOLDER` cooks the kitchens that it starts from, writes them to the folder and prints
//! the names of the work. `saute-counts FOLDER NAME` sets a piece of work up, does it once inside [`counted::counted`], and prints the
//! number of units that it did.
//!
//! `scripts/counts.sh` runs it under Callgrind and compares the instructions per unit with `scripts/counts.toml`.

mod counted;
mod kitchens;
mod work;

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: saute-counts FOLDER [NAME]")?);
    let Some(name) = arguments.next() else {
        kitchens::write(&folder)?;
        work::WORK.iter().for_each(|(name, _)| println!("{name}"));
        return Ok(());
    };
    let known = work::WORK.iter().find(|(known, _)| *known == name);
    let (_, work) = known.ok_or_else(|| format!("there is no work of the name {name}"))?;
    println!("units {}", work(&folder)?);
    Ok(())
}
