#!/usr/bin/env bash
# rustc with less effort for test programs: cargo calls it with the compiler and its arguments (RUSTC_WRAPPER, which is no part of what
# cargo compares, so that nothing is built anew with or without it). A test program holds the code of the tests, and for unit tests
# the library once more; what all other tests test is the library as everybody gets it, and is compiled as ever.
case " ${*:2} " in
    *" --test "*) exec "$@" -C opt-level=1 -C codegen-units=16 ;;
    *) exec "$@" ;;
esac
