#!/usr/bin/env bash
# Everything that must hold: format, lints, tests (window and pictures on software Vulkan), docs, and the browser build.
# `./test.sh bless` draws the reference pictures anew instead and tells by how much (ΔE) each of them has changed.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh
source scripts/wasm.sh

step() { printf '\n== %s\n' "$*"; }

need_cargo
need_packages
need_test_packages

# Tests draw on the software rasteriser wherever one is, so that pictures do not depend on the machine's GPU.
for icd in /usr/share/vulkan/icd.d/lvp_icd*.json; do
    [ -e "$icd" ] && export VK_DRIVER_FILES="$icd"
done
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$(mktemp -d)}"

if [ "${1:-}" = bless ]; then
    SAUTE_BLESS=1 cargo test --release --quiet -p saute-app --test pictures looks:: -- --nocapture
    exit
fi

step "format"
cargo fmt --all --check
step "lints"
cargo clippy --release --workspace --all-targets --quiet -- -D warnings
step "tests"
cargo test --release --workspace --quiet
step "docs"
RUSTDOCFLAGS="-D warnings" cargo doc --release --workspace --no-deps --quiet
step "browser"
check_wasm heat surface food kitchen recipe lab scene picture window
step "all passed"
