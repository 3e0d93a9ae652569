# Steps one after the other, with a table of their durations. Sourced, not run. Steps side by side: scripts/lanes.sh.

STEP_NAMES=()
STEP_SECONDS=()
STEP_RUNNING=

# clock SECONDS: as minutes and seconds.
clock() { printf '%d:%02d' $(($1 / 60)) $(($1 % 60)); }

# step NAME COMMAND...: runs a command under a heading and notes how long it took. A failure ends the script.
step() {
    local begun="$SECONDS"
    STEP_RUNNING="$1"
    STEP_BEGUN="$begun"
    printf '\n== %s\n' "$1"
    shift
    "$@"
    STEP_NAMES+=("$STEP_RUNNING")
    STEP_SECONDS+=($((SECONDS - begun)))
    STEP_RUNNING=
}

# table_of_steps: one line a step, the running one as failed.
table_of_steps() {
    local i
    printf '\n'
    for i in "${!STEP_NAMES[@]}"; do
        printf '   %-20s %7s\n' "${STEP_NAMES[$i]}" "$(clock "${STEP_SECONDS[$i]}")"
    done
    if [ -n "$STEP_RUNNING" ]; then
        printf '   %-20s %7s  FAILED\n' "$STEP_RUNNING" "$(clock $((SECONDS - STEP_BEGUN)))"
    fi
}

# finish WORDS: the table, and the words as the last line.
finish() {
    table_of_steps
    printf '== %s, in %s min\n' "$1" "$(clock "$SECONDS")"
}

failed_step() { if [ -n "$STEP_RUNNING" ]; then table_of_steps; printf '== failed: %s\n' "$STEP_RUNNING"; fi; }
trap failed_step EXIT
