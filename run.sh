#!/usr/bin/env bash
# Installs what is missing, builds saute and runs it: ./run.sh [ARGS]. Without arguments the window opens.
# ./run.sh web [--port N] builds the web page and serves it here; ./run.sh web --build DIR writes it as static files.
# ./run.sh python [SCRIPT...] opens Python with the package saute, or runs a script.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh
source scripts/wasm.sh
source scripts/web.sh
source scripts/python.sh

need_cargo
if [ "${1:-}" = python ]; then
    shift
    python_prompt "$@"
fi
if [ "${1:-}" = web ]; then
    shift
    web "$@"
    exit
fi
need_packages
# Without it graphics drivers complain on stderr while they look for a Wayland display.
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-/tmp}"

# Cargo shows its progress on a terminal as a bar, elsewhere as lines. Later builds are silent unless on a terminal.
progress=()
if [ ! -x "${CARGO_TARGET_DIR:-target}/release/saute" ]; then
    say "first build: about 6 minutes on 2 cores; later starts take seconds"
elif [ ! -t 2 ]; then
    progress=(--quiet)
fi
# `saute haptics check` looks for the simulator beside saute.
cargo build --release ${progress[@]+"${progress[@]}"} -p saute -p saute-spidar-sim
exec cargo run --release --quiet -p saute -- "$@"
