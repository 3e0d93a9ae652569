#!/usr/bin/env bash
# What takes longer by nature than a test should, hours on 2 cores:
#   the pages of validation with all their charts, and all figures of the gallery;
#   random cooks drawn from new seeds, and random packets for every door to a device;
#   a dish stored and restored at random instants, random sessions played again, and kills of a cook that is recorded;
#   every plan of the list in crates/plan/tests cooked by its recipe;
#   36 cooks by the lit button of the line that states what to do, and four first visits to the page that obey it;
#   a hundred fits of a kitchen at home to simulated logs;
#   the fuzzer on every reader, where a nightly compiler and cargo-fuzz are installed, and the lines that it reached;
#   a simulated day at the stove, without and with a recorder;
#   licences, versions and known advisories of all dependencies, where cargo-deny is installed;
#   the page as people get it, with its size limit, and its tests with every pose in WebGPU too;
#   the Python package as pip builds it, and a short training of its example;
#   ten faults that are put in by hand, each of which a test must see;
#   a sweep of 10,000 rows that is killed ten times, its memory, and its throughput against bare cooks;
#   the haptic loop against a simulated device for a minute, and every fault;
#   the speed tables of the 2013 paper with their goals, and the speed of the heat solver.
#
#   scripts/campaign.sh               all of it
#   scripts/campaign.sh last          when each part ran last on this machine
#   scripts/campaign.sh fuzz NAME...  the fuzzer on these readers only, or on all
#
# ./test.sh runs the share of it that scripts/campaign_share.sh states.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/requirements.sh
source scripts/steps.sh
source scripts/campaign_share.sh
source scripts/fuzz.sh
source scripts/dependencies.sh
source scripts/python.sh
source scripts/build.sh
source scripts/wasm.sh
source scripts/web.sh

# Test programs are compiled with less effort than what they test.
export RUSTC_WRAPPER="${RUSTC_WRAPPER:-$PWD/scripts/compiler-of-tests.sh}"
# Each part is the function of its name.
PARTS=(pages_of_validation figures longer_lists random_cooks random_packets random_instants random_sessions random_kills plans lit_button first_cook fits fuzz day
    judge_dependencies judge_advisories real_page quick_endings faults test_wheel train_briefly sweeps haptics tables_of_2013 heat_solver)
# One file for each part: when it last passed, and of which commit.
LAST="${CARGO_TARGET_DIR:-target}/campaign"

saute() { ./run.sh "$@"; }

random_cooks() { SAUTE_RANDOM_COOKS="$CAMPAIGN_RANDOM_COOKS" cargo test --release --workspace --test kitchen properties::; }

random_packets() {
    PROPTEST_CASES="$CAMPAIGN_RANDOM_PACKETS" "$RELEASE_DIR/saute-xtask" tests --kept "$LAST/tests" saute-haptics
}

random_instants() {
    SAUTE_RANDOM_INSTANTS="$CAMPAIGN_RANDOM_INSTANTS" cargo test --release --workspace --test kitchen bytes::
}

random_sessions() {
    SAUTE_RANDOM_SESSIONS="$CAMPAIGN_RANDOM_SESSIONS" cargo test --release --workspace --test recipe sessions::
}

# Also of a window on a virtual screen.
random_kills() {
    install xvfb xdotool || say "could not install xvfb and xdotool: the window that is killed needs them"
    SAUTE_RANDOM_KILLS="$CAMPAIGN_RANDOM_KILLS" cargo test --release --workspace --test cli killed -- --include-ignored
}

lit_button() { SAUTE_NOW=all cargo test --release --workspace --test window now:: -- --nocapture; }

first_cook() {
    compile_page
    make_test_page
    test_page web/campaign/first_cook.test.mjs
}

plans() { SAUTE_PLANS="$CAMPAIGN_PLANS" cargo test --release --workspace --test plan verified:: -- --nocapture; }

fits() {
    SAUTE_FIT_TRIALS="$CAMPAIGN_FIT_TRIALS" cargo test --release --workspace --test plan fit:: -- --nocapture
}

haptics() {
    local device
    for device in spidar-pan-crossed spidar-pan spidar-frame; do
        saute haptics check --device "$device" --for-s "$CAMPAIGN_HAPTICS_S" --faults
    done
}

# fuzz NAME...: the fuzzer on these targets, or on all. All of them run, also after one was broken.
fuzz() {
    local name broken=()
    can_fuzz || return 0
    [ $# -gt 0 ] || mapfile -t -O 0 names < <(fuzz_targets)
    [ $# = 0 ] || names=("$@")
    fuzz_build plain
    fuzz_build address
    for name in "${names[@]}"; do
        fuzz_run plain "$name" "$(fuzz_goal "$name")" "$CAMPAIGN_FUZZ_S" || broken+=("$name")
        fuzz_run address "$name" "$(fuzz_goal "$name")" "$CAMPAIGN_SANITIZER_S" || broken+=("$name")
    done
    fuzz_coverage "${names[@]}"
    [ ${#broken[@]} = 0 ]
}

day() {
    scripts/soak.sh
    scripts/soak.sh --record
}

# The pages of all cases with the charts that are cooked for them; the table must be the kept one.
pages_of_validation() {
    local folder saute
    folder="$(mktemp -d)"
    saute="$(realpath "$RELEASE_DIR/saute")"
    (cd "$folder" && "$saute" validate --write >/dev/null)
    diff -q "$folder/VALIDATION.md" VALIDATION.md
    rm -rf "$folder"
}

# The six figures of the gallery, small.
figures() {
    local folder
    folder="$(mktemp -d)"
    saute gallery --size 96x64 --out "$folder"
    [ "$(find "$folder" -name '*.png' | wc -l)" = 6 ]
    rm -rf "$folder"
}

# Tests that go through a longer list with SAUTE_CAMPAIGN.
longer_lists() {
    SAUTE_CAMPAIGN=1 cargo test --release --workspace --test plan --test kitchen --test pictures -- advised:: advice:: marbling:: rim:: --nocapture
}

# Forces that must end within 50 ms, on a quiet machine.
quick_endings() { SAUTE_CAMPAIGN=1 cargo test --release --workspace --test haptics drips; }

sweeps() { scripts/sweeps.sh; }

tables_of_2013() { saute bench paper; }

heat_solver() { saute bench heat; }

# Faults that are put in by hand: a test must see each.
faults() { scripts/faults.sh; }

# The page as people get it.
real_page() {
    build_page
    SAUTE_CAMPAIGN=1 SAUTE_PAGE="$PAGE_DIR" SAUTE_PAGE_BYTES="$PAGE_BYTES" test_page
}

# table_of_last: when each part last passed.
table_of_last() {
    local part
    for part in "${PARTS[@]}"; do printf '   %-20s %s\n' "$part" "$(cat "$LAST/$part" 2>/dev/null || echo never)"; done
}

# run_part NAME: as a step; notes that it passed.
run_part() {
    step "$1" "$1"
    mkdir -p "$LAST"
    printf '%s, commit %s\n' "$(date '+%Y-%m-%d %H:%M')" "$(git rev-parse --short HEAD)" >"$LAST/$1"
}

if [ "${1:-}" = last ]; then
    table_of_last
    exit
fi
need_cargo
if [ "${1:-}" = fuzz ]; then
    shift
    step "fuzzer" fuzz "$@"
    finish "no input broke a reader"
    exit
fi
need_packages
need_test_packages
say "last passed on this machine:"
table_of_last >&2
build_programs
cargo test --release --workspace --no-run
for part in "${PARTS[@]}"; do run_part "$part"; done
table_of_last
finish "the campaign passed"
