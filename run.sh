#!/usr/bin/env bash
# Installs what is missing and runs saute: ./run.sh [ARGS]. Without arguments the window opens.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh

need_cargo
need_packages
# Without it graphics drivers complain on stderr while they look for a Wayland display.
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-/tmp}"
# `saute haptics check` looks for it beside saute.
cargo build --release --quiet -p saute-spidar-sim
exec cargo run --release --quiet -p saute -- "$@"
