# Steps side by side: each begins when those that it needs have ended. Sourced, not run.
#
# A step NAME is the function step_NAME. LANES steps run at once; the first failure ends the others. What each prints is
# in STEPS_FOLDER/NAME.log too, its times in STEPS_FOLDER/NAME.times, and what it counts in STEPS_FOLDER/WHAT.count.

LANES="${SAUTE_LANES:-2}"
STEPS_FOLDER="${CARGO_TARGET_DIR:-$PWD/target}/steps"
# Process group of each running step, by its name; names of those that have ended.
declare -A STEP_GROUPS=()
declare -A STEPS_ENDED=()

# run_step NAME ARGUMENTS...: one step in this shell, in the foreground; writes its times.
run_step() {
    if ! declare -F "step_$1" >/dev/null; then
        say "there is no step \"$1\"; steps: $(compgen -A function step_ | sed 's/^step_//' | paste -sd ' ')"
        exit 2
    fi
    mkdir -p "$STEPS_FOLDER"
    # Tests note here what they open.
    export SAUTE_TALLY="$STEPS_FOLDER"
    STEP_NAME="$1"
    STEP_BEGUN="$EPOCHREALTIME"
    trap 'note_times' EXIT
    "step_$1" "${@:2}"
}

# note_times: time on the clock [s], then the processor's, of this shell and of what it ran.
note_times() {
    {
        awk -v from="${STEP_BEGUN/,/.}" -v to="${EPOCHREALTIME/,/.}" 'BEGIN { printf "%.3f\n", to - from }'
        times
    } >"$STEPS_FOLDER/$STEP_NAME.times"
}

# launch NAME: begins a step in the background, in its own process group.
launch() {
    local label
    label="$(printf '%-8s' "$1")"
    { "$BASH" "$0" step "$1" 2>&1 | tee "$STEPS_FOLDER/$1.log" | sed -u "s/^/$label | /"; } &
    STEP_GROUPS["$1"]=$!
    say "== $1 begins"
}

# can_begin "NAME: NEEDED...": whether a step has neither begun nor waits for another.
can_begin() {
    local name="${1%%:*}" needed
    if [ -n "${STEP_GROUPS[$name]:-}" ] || [ -n "${STEPS_ENDED[$name]:-}" ]; then return 1; fi
    for needed in ${1#*:}; do [ -n "${STEPS_ENDED[$needed]:-}" ] || return 1; done
}

# end_steps: ends all that runs.
end_steps() {
    local group
    # Else the shell would report each of them.
    disown -a
    for group in "${STEP_GROUPS[@]}"; do kill -TERM -- "-$group" 2>/dev/null || true; done
    STEP_GROUPS=()
}

# await_one: waits until one step has ended; fails with its status, its name in STEP_FAILED.
await_one() {
    local group name status=0
    wait -n -p group || status=$?
    for name in "${!STEP_GROUPS[@]}"; do
        if [ "${STEP_GROUPS[$name]}" != "${group:-}" ]; then continue; fi
        unset "STEP_GROUPS[$name]"
        if [ "$status" = 0 ]; then
            STEPS_ENDED["$name"]=yes
            say "== $name ended after $(clock "$(sed -n '1s/[.,].*//p' "$STEPS_FOLDER/$name.times")")"
        else
            STEP_FAILED="$name"
        fi
    done
    return "$status"
}

# side_by_side "NAME: NEEDED..."...: runs all steps, the earlier ones of the list first.
side_by_side() {
    local step status=0
    rm -rf "$STEPS_FOLDER"
    mkdir -p "$STEPS_FOLDER"
    # Each step gets its own process group, which can be ended as a whole.
    set -m
    trap end_steps EXIT
    trap 'exit 130' INT TERM
    while [ ${#STEPS_ENDED[@]} -lt $# ]; do
        for step in "$@"; do
            if [ ${#STEP_GROUPS[@]} -lt "$LANES" ] && can_begin "$step"; then launch "${step%%:*}"; fi
        done
        await_one || status=$?
        if [ "$status" != 0 ]; then
            end_steps
            say ""
            say "== failed: $STEP_FAILED, after $(clock "$SECONDS") min; again: ./test.sh step $STEP_FAILED"
            say "   what it said: $STEPS_FOLDER/$STEP_FAILED.log"
            exit 1
        fi
    done
    trap - EXIT
}
