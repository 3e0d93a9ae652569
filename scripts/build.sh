# Builds the program and reports the progress. Sourced, not run.

RELEASE_DIR="${CARGO_TARGET_DIR:-target}/release"
# Requested together with the features of the workspace, as the tests and the scripts do: nothing is built again between them.
PROGRAMS=(--workspace --bin saute --bin saute-spidar-sim)

# build_programs: saute and the simulated device that `saute haptics check` looks for next to it.
build_programs() {
    say_that_another_builds
    if [ ! -x "$RELEASE_DIR/saute" ]; then
        first_build
    elif [ -t 2 ]; then
        cargo build --release "${PROGRAMS[@]}"
    else
        cargo build --release --quiet "${PROGRAMS[@]}"
    fi
}

# first_build: with a bar on a terminal, else with a line for each tenth.
first_build() {
    say "first build: 6 to 15 minutes on two cores, once; later starts take seconds. It can be stopped and goes on from there."
    say "meanwhile: README.md says what there is to do; docs/gallery/gallery.md shows it"
    if [ -t 2 ]; then
        cargo build --release "${PROGRAMS[@]}"
    else
        CARGO_TERM_PROGRESS_WHEN=always CARGO_TERM_PROGRESS_WIDTH=80 cargo build --release "${PROGRAMS[@]}" 2> >(tenths >&2)
    fi
}

# tenths: cargo's bar as a line for each tenth; cargo's other output as it is, but for the names of the parts.
tenths() {
    tr '\r' '\n' | awk '
        { gsub(/\033\[K/, "") }
        /^ *Building \[/ {
            if (match($0, /[0-9]+\/[0-9]+/)) {
                split(substr($0, RSTART, RLENGTH), part, "/")
                tenth = int(10 * part[1] / part[2])
                if (tenth > last) { last = tenth; printf "  %d of %d parts are built\n", part[1], part[2]; fflush() }
            }
            next
        }
        /^ *(Compiling|Downloaded) / || /^ *$/ { next }
        { print; fflush() }'
}

# say_that_another_builds: cargo waits for it in silence where its output is no terminal.
say_that_another_builds() {
    local lock="$RELEASE_DIR/.cargo-lock"
    if [ -e "$lock" ] && command -v flock >/dev/null && ! flock --nonblock "$lock" true; then
        say "another ./run.sh or ./test.sh is building here; this one goes on when it is done"
    fi
}
