#!/usr/bin/env bash
# A day at the stove: the dish of 23 pieces on the meshes of 2013, disturbed every ten minutes by a toss, oil, a lid or water.
# Ends with exit code 1 if memory grows by more than 1 MB after the first hour (with --record: by more than 64 MB), or
# energy or mass do not balance to 1e-9 of what was exchanged.
#
#   scripts/soak.sh                  24 simulated hours
#   scripts/soak.sh --record         the same with a recorder, whose series is thinned
#   scripts/soak.sh --minutes 60     another length
#
# Each finished hour is written to target/soak.log and its kitchen to target/soak.kitchen. After an interruption the same
# command goes on from there; with --record it begins again, because the series is not stored.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/requirements.sh
need_cargo
mkdir -p target
cargo build --release --quiet --workspace --bin saute-soak
exec "${CARGO_TARGET_DIR:-target}/release/saute-soak" --log "target/soak.log" "$@"
