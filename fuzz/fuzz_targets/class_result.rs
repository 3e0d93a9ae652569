#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| saute_attack::handed_in::class_result(bytes));
