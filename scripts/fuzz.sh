# Fuzzing of every reader with cargo-fuzz (fuzz/README.md). Sourced, not run.

FUZZ_BUILT=target/fuzz
FUZZ_LOGS=target/fuzz/logs
# Memory [MB] and time of one input under the sanitizer [s].
FUZZ_MEMORY_MB=512
FUZZ_TIMEOUT_S=10
# The sanitizer keeps freed memory for a while; with 16 MB the memory of the reader is what is limited.
FUZZ_SANITIZER="quarantine_size_mb=16:detect_leaks=0"

# can_fuzz: whether the tools are there; else says what is missing.
can_fuzz() {
    if ! rustup run nightly rustc --version >/dev/null 2>&1; then say "skipped: no nightly compiler"; return 1; fi
    if ! command -v cargo-fuzz >/dev/null; then say "skipped: no cargo-fuzz (cargo install cargo-fuzz)"; return 1; fi
    if ! command -v c++ >/dev/null; then say "skipped: no C++ compiler, which builds libFuzzer"; return 1; fi
}

# fuzz_targets: names of all targets.
fuzz_targets() { basename -s .rs fuzz/fuzz_targets/*.rs; }

# fuzz_build: builds the programs, with the versions of the main workspace.
fuzz_build() {
    cp Cargo.lock fuzz/Cargo.lock
    cargo +nightly fuzz build --target-dir "$FUZZ_BUILT"
}

# fuzz_goal TARGET: the executions of a campaign: fewer where a body is built or cooked.
fuzz_goal() {
    case "$1" in
        recipe | food | pan | oil | kinetics | lab | stl | obj | gltf | kitchen) echo 100000 ;;
        *) echo 1000000 ;;
    esac
}

# fuzz_run TARGET EXECUTIONS SECONDS: ends with the sooner of both; prints a line for the table. An input that breaks the
# reader is left in fuzz/artifacts.
fuzz_run() {
    local name="$1" log="$FUZZ_LOGS/$1.log" status=0 folders=()
    mkdir -p "$FUZZ_LOGS" "fuzz/corpus/$name" "fuzz/artifacts/$name"
    for kind in corpus seeds found; do [ -d "fuzz/$kind/$name" ] && folders+=("fuzz/$kind/$name"); done
    ASAN_OPTIONS="$FUZZ_SANITIZER" "$FUZZ_BUILT/$(fuzz_host)/release/$name" "${folders[@]}" \
        -dict="fuzz/dictionaries/$name.dict" -artifact_prefix="fuzz/artifacts/$name/" \
        -runs="$2" -max_total_time="$3" -timeout="$FUZZ_TIMEOUT_S" -rss_limit_mb="$FUZZ_MEMORY_MB" \
        -max_len=4096 -print_funcs=0 -print_final_stats=1 >"$log" 2>&1 || status=$?
    fuzz_line "$name" "$log"
    [ "$status" = 0 ] || { tail -25 "$log"; say "an input broke $name: fuzz/artifacts/$name; add it to fuzz/found/$name"; }
    return "$status"
}

fuzz_host() { rustc -vV | sed -n 's/^host: //p'; }

# fuzz_line TARGET LOG: executions, executions a second, memory.
fuzz_line() {
    awk -v name="$1" '
        /stat::number_of_executed_units/ { executed = $2 }
        /stat::average_exec_per_sec/ { rate = $2 }
        /stat::peak_rss_mb/ { memory = $2 }
        END { printf "%-9s %9d executions %7d/s %5d MB\n", name, executed, rate, memory }' "$2"
}

# fuzz_coverage TARGET...: lines of each reader that its kept and found inputs reach, by the compiler's own counters.
fuzz_coverage() {
    local tools name sources binary profile="$PWD/target/coverage/profiles"
    tools="$(rustc +nightly --print sysroot)/lib/rustlib/$(fuzz_host)/bin"
    if ! [ -x "$tools/llvm-cov" ]; then say "skipped: no llvm-tools (rustup component add llvm-tools --toolchain nightly)"; return 0; fi
    RUSTFLAGS="-C instrument-coverage" cargo +nightly build --release --package saute-attack --target-dir target/coverage
    binary=target/coverage/release/saute-attack
    for name in "$@"; do
        rm -rf "$profile" && mkdir -p "$profile"
        LLVM_PROFILE_FILE="$profile/%p.profraw" "$binary" "$name" "fuzz/seeds/$name" "fuzz/found/$name" "fuzz/corpus/$name"
        "$tools/llvm-profdata" merge --sparse "$profile"/*.profraw -o "$profile/all.profdata"
        mapfile -t sources < <("$binary" | awk -v name="$name" '$1 == name { for (i = 3; i <= NF; i++) print $i }')
        "$tools/llvm-cov" report --instr-profile "$profile/all.profdata" "$binary" --sources "${sources[@]}" |
            awk -v name="$name" '/^TOTAL/ { printf "%-9s %s of lines\n", name, $10 }'
    done
}
