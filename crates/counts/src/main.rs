//! Work whose instructions Callgrind counts: `saute-counts NAME` sets a piece of work up, does it once inside
//! [`counted::counted`], and prints the number of units that it did. Without arguments it prints the names.
//!
//! `scripts/counts.sh` runs it under Callgrind and compares the instructions per unit with `scripts/counts.toml`.

mod counted;
mod kitchens;
mod work;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let Some(name) = std::env::args().nth(1) else {
        work::WORK.iter().for_each(|(name, _)| println!("{name}"));
        return Ok(());
    };
    let known = work::WORK.iter().find(|(known, _)| *known == name);
    let (_, work) = known.ok_or_else(|| format!("there is no work of the name {name}"))?;
    println!("units {}", work()?);
    Ok(())
}
