#!/usr/bin/env bash
# Sweeps at full size: memory of many rows against few, random kills, and throughput against bare cooks.
#
#   scripts/sweeps.sh [ROWS] [KILLS]    10000 rows and 10 kills unless they are given
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/requirements.sh
source scripts/steps.sh

ROWS="${1:-10000}"
KILLS="${2:-10}"
PROGRAM="${CARGO_TARGET_DIR:-target}/release/saute"

# spec ROWS: a sweep of so many short cooks on a coarse mesh, in a pan that is hot from the start.
spec() {
    printf 'recipe = "medium"\nfor_s = 30\ncoarseness = 3\n[vary]\n"food.steak.size_mm[2]" = { from = 15, to = 30 }\n'
    printf '"pan.initial_c" = { from = 220, to = 240 }\n[design]\nkind = "latin-hypercube"\nn = %s\n' "$1"
}

# watched COMMAND...: runs it; prints its highest resident memory [MB].
watched() {
    local process peak=0 now
    "$@" >/dev/null &
    process=$!
    while now="$(awk '/^VmHWM/ { print $2 }' "/proc/$process/status" 2>/dev/null)" && [ -n "$now" ]; do
        peak="$now"
        sleep 0.2
    done
    wait "$process"
    echo "$((peak / 1024))"
}

# killed FOLDER: a sweep that is killed at random times, then goes on to its end.
killed() {
    local folder="$1" process kill
    for ((kill = 1; kill <= KILLS; kill++)); do
        "$PROGRAM" sweep "$folder/many.toml" --out "$folder/many" >/dev/null &
        process=$!
        sleep "$((RANDOM % SPREAD_S + 1)).$((RANDOM % 10))"
        kill -9 "$process" 2>/dev/null || say "kill $kill came too late: the sweep had ended"
        wait "$process" 2>/dev/null || true
        say "kill $kill: $(find "$folder/many/rows" -name '*.parquet' | wc -l) complete parts"
    done
    say "$ROWS rows: $(watched "$PROGRAM" sweep "$folder/many.toml" --out "$folder/many") MB at most, from the last kill to the end"
    # Opening the folder reads every part: each of its rows must be there once.
    "$PROGRAM" sweep "$folder/many.toml" --out "$folder/many" --json | tee "$folder/end.json"
    grep -q "\"done\": $ROWS,"  "$folder/end.json"
    grep -q '"cooked": 0,' "$folder/end.json"
}

need_cargo
cargo build --release --workspace --bin saute
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
SPREAD_S="${SPREAD_S:-30}"
spec "$((ROWS / 10))" > "$folder/few.toml"
spec "$ROWS" > "$folder/many.toml"
say "$((ROWS / 10)) rows: $(watched "$PROGRAM" sweep "$folder/few.toml" --out "$folder/few") MB at most"
killed "$folder"
cargo test --release --workspace --test sweep_folder throughput:: -- --ignored --nocapture
