#!/usr/bin/env bash
# Makes the pictures of the foods in the window's pantry again: crates/window/stills/, one for each shipped food, raw in the
# pan. Run it after the look of a food has changed.
set -euo pipefail
cd "$(dirname "$0")/.."

SAUTE="${SAUTE:-${CARGO_TARGET_DIR:-target}/release/saute}"
OUT=crates/window/stills
mkdir -p "$OUT"

# food DISTANCE: a picture from that far [mm], so that every food fills it.
food() {
    "$SAUTE" shot "gallery/looks/$1.toml" --at 2 --camera "48,20,$2" --size 108x72 --quality best --out "$OUT/$1.png"
}

food beef-lean 260
food beef-marbled 260
food beef-patty 250
food carrot-coin 150
food carrot-stick 190
food leek-ring 150
food shrimp 190
