#!/usr/bin/env bash
# Faults put in by hand, one after the other, in a copy of the last commit: the tests named with each must fail. A fault that
# they pass means that a promise has lost its test.
#
#   scripts/faults.sh             all of them
#   scripts/faults.sh NUMBER...   some of them
#
# The copy is target/faults; it uses what was built of the dependencies.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/requirements.sh

ROOT="$PWD"
COPY="${CARGO_TARGET_DIR:-$ROOT/target}/faults"
LOG="$COPY.log"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$ROOT/target}"
CHOSEN=("$@")
NUMBER=0
UNSEEN=()

# put_in FILE FROM TO: replaces a text that is there exactly once.
put_in() {
    python3 -c '
import sys
name, old, new = sys.argv[1:]
text = open(name, encoding="utf-8").read()
if text.count(old) != 1:
    sys.exit(f"{name}: the text to replace is there {text.count(old)} times: {old}")
open(name, "w", encoding="utf-8").write(text.replace(old, new))' "$@"
}

# is_chosen: whether the present number was requested.
is_chosen() { [ ${#CHOSEN[@]} = 0 ] || [[ " ${CHOSEN[*]} " == *" $NUMBER "* ]]; }

# integration NAME FILTER: the tests of one program of tests.
integration() { (cd "$COPY" && cargo test --release --workspace --test "$1" -- "$2"); }

# unit FILTER: unit tests of the libraries.
unit() { (cd "$COPY" && cargo test --release --workspace --lib -- "$1"); }

# fault WHAT FILE FROM TO TESTS...: puts a fault in and runs the tests, which must fail after they were built.
fault() {
    NUMBER=$((NUMBER + 1))
    is_chosen || return 0
    git -C "$COPY" checkout --quiet -- .
    (cd "$COPY" && put_in "$2" "$3" "$4")
    if "${@:5}" >"$LOG" 2>&1; then
        UNSEEN+=("$NUMBER")
        say "$NUMBER  NOT SEEN  $1"
    elif grep -q '^test result: FAILED\|^not ok ' "$LOG"; then
        say "$NUMBER  seen      $1: $(grep -m1 -o '^test .* FAILED$' "$LOG" || true)"
    else
        UNSEEN+=("$NUMBER")
        say "$NUMBER  NO RESULT $1"
        tail -n 5 "$LOG"
    fi
}

need_cargo
git worktree remove --force "$COPY" 2>/dev/null || true
git worktree add --quiet --force --detach "$COPY" HEAD
trap 'git worktree remove --force "$COPY"' EXIT

fault "food gives its neighbour heat of the wrong sign" crates/kitchen/src/piece/food_contact.rs \
    'b.give(j, heat);' 'b.give(j, -heat);' unit food_contact
fault "a hob of any power is accepted in a recipe" crates/recipe/src/check/action_check.rs \
    '&to.w, 0.0, hob.largest_w()' '&to.w, 0.0, 1e9' integration recipe recipes::
fault "a command is carried out and not recorded" crates/recipe/src/session/recording.rs \
    '        self.take_over(kitchen);
        self.enter(kitchen, Deed::Command(command));' '        drop(command);' integration session timeline::
fault "the panel has no button to undo" crates/window/src/panels/cook/time_strip.rs \
    '    step_button(state, ui, acts, ["strip.undo", "strip.undo_hint"], state.session.can_undo(), TimeAct::Undo);' '' \
    integration window time::
fault "food throws no shadow" crates/scene/src/shaders/light.wgsl \
    'return depth_test(shadow_map, uv, step,' 'return 1.0; return depth_test(shadow_map, uv, step,' \
    integration pictures ''
fault "the last triangle of a solid is left out" crates/surface/src/stl_file/binary.rs \
    '    Ok(soup)' '    soup.triangles.pop();
    Ok(soup)' integration surface formats::
fault "the force of a device has no limit" crates/haptics/src/control/safety_limits.rs \
    'wanted.clamped(self.limits.force_n, self.limits.torque_nm)' 'wanted.clamped(1e9, self.limits.torque_nm)' \
    integration haptics control::
fault "a table loses its units on the way to a file" crates/formats/src/parquet_file.rs \
    'notes.chain([KeyValue::new(UNITS.to_owned(), units)]).collect()' 'drop(units); notes.collect()' \
    integration formats parquet::
fault "what a killed sweep had cooked is forgotten" crates/sweep-folder/src/folder.rs \
    'results.entry(result.row).or_insert(result);' 'drop(result);' integration sweep_folder folder::
fault "what a study locks can be done" crates/window/src/app/leads/guided.rs \
    'let refused = !self.permits().allow(act.traits().needs);' 'let refused = false;' integration window guided::

[ ${#UNSEEN[@]} = 0 ] || { say "not seen: ${UNSEEN[*]}"; exit 1; }
say "every fault was seen"
