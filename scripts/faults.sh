#!/usr/bin/env bash
# Faults put in by hand, one after the other, in a copy of the tree: the tests named with each must fail. A fault that they
# pass means that a promise has lost its test.
#
#   scripts/faults.sh             all of them
#   scripts/faults.sh NUMBER...   some of them
#
# The copy is built with its own target folder, which is kept between runs in target/faults.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/requirements.sh

COPY="$(realpath -m "${CARGO_TARGET_DIR:-target}/faults")"
CHOSEN=("$@")
NUMBER=0
UNSEEN=()

# put_in FILE FROM TO: replaces a text that is there exactly once.
put_in() {
    python3 - "$@" <<'PYTHON'
import sys
name, old, new = sys.argv[1:4]
text = open(name, encoding="utf-8").read()
if text.count(old) != 1:
    sys.exit(f"{name}: the text to replace is there {text.count(old)} times: {old}")
open(name, "w", encoding="utf-8").write(text.replace(old, new))
PYTHON
}

# is_chosen: whether the present number was asked for.
is_chosen() {
    local number
    [ ${#CHOSEN[@]} -gt 0 ] || return 0
    for number in "${CHOSEN[@]}"; do [ "$number" != "$NUMBER" ] || return 0; done
    return 1
}

# fault WHAT FILE FROM TO COMMAND...: puts a fault in, builds, runs the tests, and takes it out again.
fault() {
    local what="$1" file="$2" log="$COPY/fault.log"
    NUMBER=$((NUMBER + 1))
    is_chosen || return 0
    git -C "$COPY/tree" checkout --quiet -- .
    (cd "$COPY/tree" && put_in "$file" "$3" "$4")
    # A fault that does not compile shows nothing.
    if ! (cd "$COPY/tree" && cargo build --quiet "${PROFILE[@]}" --workspace --lib) >"$log" 2>&1; then
        say "$NUMBER  DOES NOT COMPILE  $what"
        tail -n 20 "$log"
        UNSEEN+=("$NUMBER")
    elif (cd "$COPY/tree" && "${@:5}") >"$log" 2>&1; then
        say "$NUMBER  NOT SEEN  $what"
        UNSEEN+=("$NUMBER")
    else
        say "$NUMBER  seen      $what: $(grep -m1 -oE '^test [^ ]+ \.\.\. FAILED|^    [a-z_:]+$|not ok [0-9]+ - .*' "$log" || tail -n 1 "$log")"
    fi
}
