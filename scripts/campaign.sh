#!/usr/bin/env bash
# What takes longer by nature than a test should, hours on 2 cores:
#   random cooks drawn from new seeds, and random packets for every door to a device;
#   a dish stored and restored at random instants, random sessions played again, and kills of a cook that is recorded;
#   every plan of the list in crates/plan/tests cooked by its recipe;
#   a hundred fits of a kitchen at home to simulated logs;
#   the fuzzer on every reader, where a nightly compiler and cargo-fuzz are installed, and the lines that it reached;
#   a simulated day at the stove, without and with a recorder;
#   licences, versions and known advisories of all dependencies, where cargo-deny is installed;
#   the Python package as pip builds it, and a short training of its example;
#   a sweep of 10,000 rows that is killed ten times, its memory, and its throughput beside bare cooks;
#   the haptic loop against a simulated device for a minute, and every fault;
#   the speed tables of the 2013 paper with their goals, and the speed of the heat solver.
#
#   scripts/campaign.sh               all of it
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

saute() { ./run.sh "$@"; }

random_cooks() { SAUTE_RANDOM_COOKS="$CAMPAIGN_RANDOM_COOKS" cargo test --release -p saute-kitchen --test kitchen properties::; }

random_packets() { PROPTEST_CASES="$CAMPAIGN_RANDOM_PACKETS" cargo test --release -p saute-haptics -- --quiet; }

random_instants() {
    SAUTE_RANDOM_INSTANTS="$CAMPAIGN_RANDOM_INSTANTS" cargo test --release -p saute-kitchen --test kitchen bytes::
}

random_sessions() {
    SAUTE_RANDOM_SESSIONS="$CAMPAIGN_RANDOM_SESSIONS" cargo test --release -p saute-recipe --test recipe sessions::
}

random_kills() { SAUTE_RANDOM_KILLS="$CAMPAIGN_RANDOM_KILLS" cargo test --release -p saute --test cli killed; }

plans() { SAUTE_PLANS="$CAMPAIGN_PLANS" cargo test --release -p saute-plan --test verified -- --nocapture; }

fits() {
    SAUTE_FIT_TRIALS="$CAMPAIGN_FIT_TRIALS" cargo test --release -p saute-plan --test fit -- --nocapture
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

need_cargo
if [ "${1:-}" = fuzz ]; then
    shift
    step "fuzzer" fuzz "$@"
    finish "no input broke a reader"
    exit
fi
need_packages
need_test_packages
step "random cooks" random_cooks
step "random packets" random_packets
step "random instants" random_instants
step "random sessions" random_sessions
step "random kills" random_kills
step "plans" plans
step "fits" fits
step "fuzzer" fuzz
step "a day" day
step "dependencies" judge_dependencies
step "advisories" judge_advisories
step "Python wheel" test_wheel
step "training" train_briefly
step "sweeps" scripts/sweeps.sh
step "haptic loop" haptics
step "tables of 2013" saute bench paper
step "heat solver" saute bench heat
finish "the campaign passed"
