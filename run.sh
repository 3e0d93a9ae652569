#!/usr/bin/env bash
# Installs what is missing, builds saute and runs it: ./run.sh [ARGS]. Without arguments the window opens.
# ./run.sh web [--port N] builds the web page and serves it here; ./run.sh web --build DIR writes it as static files.
# ./run.sh python [SCRIPT...] opens Python with the package saute, or runs a script.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh
source scripts/build.sh
source scripts/wasm.sh
source scripts/web.sh
source scripts/python.sh

# need_display ARGUMENTS...: before a long build, where the window cannot be opened. Help needs none, nor do the commands of studies.
need_display() {
    case " $* " in
        *" --help "* | *" -h "* | " study simulate "* | " study analyse "* | " study help "*) return 0 ;;
        "  " | " open "* | " study "* | " --device "*) ;;
        *) return 0 ;;
    esac
    if [ "$(uname -s)" != Linux ] || [ -n "${WAYLAND_DISPLAY:-}${WAYLAND_SOCKET:-}${DISPLAY:-}" ]; then return 0; fi
    say "there is no display, which the window needs; without one:"
    say "  ./run.sh web                                             the same in a browser"
    say "  ./run.sh cook medium                                     cook and print the numbers"
    say "  ./run.sh shot medium --at 300 --out steak.png            render a picture"
    exit 2
}

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
need_display "$@"
need_packages
# Without it graphics drivers complain on stderr while they look for a Wayland display.
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-/tmp}"
build_programs
exec "$RELEASE_DIR/saute" "$@"
