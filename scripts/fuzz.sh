# Fuzzing of every reader with cargo-fuzz (fuzz/README.md). Sourced, not run.

# Two builds of each program: "plain", which is fast enough for the executions of a campaign, and "address", under the
# address sanitizer, which watches the unsafe code of libraries; there is none of ours. Both check overflow and debug
# assertions, and both are guided by coverage.
FUZZ_BUILT=target/fuzz
# Memory [MB] and time [s] of one input, in both builds.
FUZZ_MEMORY_MB=512
FUZZ_TIMEOUT_S=10
# The sanitizer keeps freed memory for a while; with 16 MB the memory of the reader is what is limited.
FUZZ_SANITIZER="quarantine_size_mb=16:detect_leaks=0"

# can_fuzz: whether the tools are there; else prints what is missing.
can_fuzz() {
    if ! rustup run nightly rustc --version >/dev/null 2>&1; then say "skipped: no nightly compiler"; return 1; fi
    if ! command -v cargo-fuzz >/dev/null; then say "skipped: no cargo-fuzz (cargo install cargo-fuzz)"; return 1; fi
    if ! command -v c++ >/dev/null; then say "skipped: no C++ compiler, which builds libFuzzer"; return 1; fi
}

# fuzz_targets: names of all targets.
fuzz_targets() { basename -s .rs fuzz/fuzz_targets/*.rs; }

# fuzz_build BUILD: builds the programs, with the versions of the main workspace.
fuzz_build() {
    local options=(--sanitizer "$1")
    # Traced comparisons would halve the executions; the dictionaries do their work.
    [ "$1" = plain ] && options=(--sanitizer none --no-trace-compares)
    cp Cargo.lock fuzz/Cargo.lock
    cargo +nightly fuzz build "${options[@]}" --target-dir "$FUZZ_BUILT/$1"
}

# fuzz_program BUILD TARGET: where its program is.
fuzz_program() { echo "$FUZZ_BUILT/$1/$(fuzz_host)/release/$2"; }

# fuzz_goal TARGET: the executions of a campaign: fewer where a body is built or cooked.
fuzz_goal() {
    case "$1" in
        recipe | food | pan | oil | kinetics | lab | stl | obj | gltf | kitchen | sweep | command) echo 100000 ;;
        *) echo 1000000 ;;
    esac
}

# fuzz_run BUILD TARGET EXECUTIONS SECONDS: ends with the sooner of both; prints a line for the table. An input that breaks
# the reader is left in fuzz/artifacts.
fuzz_run() {
    local name="$2" log="$FUZZ_BUILT/$1/logs/$2.log" status=0 folders=()
    mkdir -p "$FUZZ_BUILT/$1/logs" "fuzz/corpus/$name" "fuzz/artifacts/$name"
    for kind in corpus seeds found; do [ -d "fuzz/$kind/$name" ] && folders+=("fuzz/$kind/$name"); done
    ASAN_OPTIONS="$FUZZ_SANITIZER" "$(fuzz_program "$1" "$name")" "${folders[@]}" \
        -dict="fuzz/dictionaries/$name.dict" -artifact_prefix="fuzz/artifacts/$name/" \
        -runs="$3" -max_total_time="$4" -timeout="$FUZZ_TIMEOUT_S" -rss_limit_mb="$FUZZ_MEMORY_MB" \
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
    # Build scripts are measured, too; their profiles would lie about in the tree.
    LLVM_PROFILE_FILE="$PWD/target/coverage/build-%p.profraw" RUSTFLAGS="-C instrument-coverage" cargo +nightly build --release --package saute-attack --target-dir target/coverage
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
