//! Hands the files of folders to a target, for the coverage of its reader: `saute-attack TARGET FOLDER...`.
//! Without arguments it lists the targets, with what each does and the source files of its reader.

use std::path::Path;
use std::process::ExitCode;

use saute_attack::{TARGETS, Target, in_folder};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(name) = arguments.next() else {
        TARGETS.iter().for_each(|target| println!("{} {:?} {}", target.name, target.work, target.sources.join(" ")));
        return ExitCode::SUCCESS;
    };
    let Some(target) = Target::named(&name) else {
        eprintln!("there is no target {name}");
        return ExitCode::from(2);
    };
    for folder in arguments {
        in_folder(Path::new(&folder)).iter().for_each(|input| target.run(&input.bytes));
    }
    ExitCode::SUCCESS
}
