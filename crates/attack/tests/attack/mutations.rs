//! Promise: no mutation of a valid input makes a reader panic or hang. The share of the fuzzer's campaign that runs on the
//! stable compiler: the same mutations every time, without the guidance of coverage.

use std::time::{Duration, Instant};

use saute_attack::dictionary::words;
use saute_attack::{TARGETS, Target, Work, kept};
use saute_fixtures::processor;

/// Longest time of one input on the processor (chosen: three times the promised second, for slow machines).
const LONGEST: Duration = Duration::from_secs(3);

/// Pseudo-random numbers (a linear congruential generator), so that a failure repeats.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }
}

fn mutated(seed: &[u8], words: &[String], numbers: &mut Numbers) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=numbers.below(3) {
        let at = numbers.below(bytes.len());
        let end = (at + numbers.below(9)).min(bytes.len());
        match numbers.below(5) {
            0 => bytes[at] ^= 1 << numbers.below(8),
            1 => drop(bytes.drain(at..end)),
            2 => drop(bytes.splice(at..at, words[numbers.below(words.len())].bytes())),
            3 => drop(bytes.splice(at..end, words[numbers.below(words.len())].bytes())),
            _ => bytes.truncate(at + 1),
        }
        bytes.push(b' ');
    }
    bytes
}

fn attack(target: &Target, count: usize) {
    let (seeds, words) = (kept("seeds", target), words(target));
    let (mut numbers, begun) = (Numbers(17), Instant::now());
    for turn in 0..count {
        let bytes = mutated(&seeds[turn % seeds.len()].bytes, &words, &mut numbers);
        let ((), took) = processor::of_thread(|| target.run(&bytes));
        assert!(took < LONGEST, "{} {:?}", target.name, String::from_utf8_lossy(&bytes));
    }
    println!("{}: {count} in {:.1} s", target.name, begun.elapsed().as_secs_f64());
}

#[test]
fn mutations_of_text_and_messages_are_refused_or_read() {
    TARGETS.iter().filter(|t| t.work == Work::Reads).for_each(|target| attack(target, 5000));
}

#[test]
fn mutations_of_what_is_built_and_cooked_are_refused_or_cook() {
    TARGETS.iter().filter(|t| t.work == Work::Builds).for_each(|target| attack(target, 1000));
}
