//! Promise: every input that once broke a reader, and every seed of the fuzzer, is read within a second on a quiet machine.

use std::time::Duration;

use saute_attack::dictionary::dictionary;
use saute_attack::{Input, TARGETS, Target, folder, kept};
use saute_fixtures::processor;

/// Longest time of one input on the processor (chosen: three times the promised second, for slow machines).
const LONGEST: Duration = Duration::from_secs(3);

fn replay(target: &Target, inputs: &[Input]) {
    for input in inputs {
        let ((), took) = processor::of_thread(|| target.run(&input.bytes));
        println!("{} {:?}", input.path.display(), took);
        assert!(took < LONGEST, "{} took {took:?}", input.path.display());
    }
}

#[test]
fn every_seed_is_read_soon() {
    for target in TARGETS {
        let seeds = kept("seeds", target);
        assert!(!seeds.is_empty(), "{} has no seed", target.name);
        replay(target, &seeds);
    }
}

#[test]
fn every_found_case_is_read_soon() {
    TARGETS.iter().for_each(|target| replay(target, &kept("found", target)));
}

/// `SAUTE_BLESS=1` writes them.
#[test]
fn dictionaries_are_those_of_the_schemas_and_seeds() {
    for target in TARGETS {
        let path = folder("dictionaries", target).with_extension("dict");
        let made = dictionary(target);
        if std::env::var_os("SAUTE_BLESS").is_some() {
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(&path, &made).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == made, "{} is not as generated: SAUTE_BLESS=1 writes it", path.display());
    }
}

#[test]
fn every_target_has_a_program_of_its_own() {
    let manifest = std::fs::read_to_string(folder("Cargo.toml", &TARGETS[0]).parent().unwrap()).unwrap();
    for target in TARGETS {
        assert!(manifest.contains(&format!("name = \"{}\"", target.name)), "{}", target.name);
        let program = folder("fuzz_targets", target).with_extension("rs");
        let text = std::fs::read_to_string(&program).unwrap();
        assert!(text.contains(&format!("::{}(bytes)", target.name)), "{}", program.display());
    }
}
