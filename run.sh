#!/usr/bin/env bash
# Installs what is missing and runs saute: ./run.sh [ARGS]. Without arguments the window opens.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh

need_cargo
need_packages
exec cargo run --release --quiet -p saute -- "$@"
