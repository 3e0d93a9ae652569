#!/usr/bin/env bash
# What takes longer by nature than a test should, about an hour on 2 cores:
#   random cooks drawn from new seeds, and random packets for every door to a device;
#   the haptic loop against a simulated device for a minute, and every fault;
#   the speed tables of the 2013 paper with their goals, and the speed of the heat solver.
# ./test.sh runs the share of it that scripts/campaign_share.sh states.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/requirements.sh
source scripts/steps.sh
source scripts/campaign_share.sh

saute() { ./run.sh "$@"; }

random_cooks() { SAUTE_RANDOM_COOKS="$CAMPAIGN_RANDOM_COOKS" cargo test --release -p saute-kitchen --test properties; }

random_packets() { PROPTEST_CASES="$CAMPAIGN_RANDOM_PACKETS" cargo test --release -p saute-haptics -- --quiet; }

haptics() {
    local device
    for device in spidar-pan-crossed spidar-pan spidar-frame; do
        saute haptics check --device "$device" --for-s "$CAMPAIGN_HAPTICS_S" --faults
    done
}

need_cargo
need_packages
need_test_packages
step "random cooks" random_cooks
step "random packets" random_packets
step "haptic loop" haptics
step "tables of 2013" saute bench paper
step "heat solver" saute bench heat
finish "the campaign passed"
