#!/usr/bin/env bash
# Compares the results of two saute programs byte for byte, for changes that must not change any number.
#
#   scripts/same-bytes.sh BASE [PATTERN]       compares with BASE; exit code 1 if a result differs
#   scripts/same-bytes.sh save DIR [BINARY]    saves the results of a program in DIR
#
# BASE is a folder of saved results, a saute program, or a git revision, which is built once into target/same-bytes.
# PATTERN is a regular expression; only the runs whose names match it are made.
# The program of the working tree is built, unless the variable SAUTE names another program. JOBS: runs at a time (2).
#
# Runs:  cook-*      every recipe in recipes/ (by its id) and gallery/, every recipe inside a case of validation/:
#                    series.csv, and the JSON of `saute cook --json`
#        lab-*       every other case of validation/: the JSON of `saute lab --json`
#        validate-*  every case of validation/: the verdicts of `saute validate --json`
#        table       the table of `saute validate`, of one case
# All of them take 4 minutes on 2 idle cores, those of PATTERN "^cook" half of that.
# Both programs read the same recipe files: those saved with BASE. Shipped recipes are inside the programs.
#
# Allowed differences: the line `wall_s` of a JSON; the texts in `warnings` (their number counts); the name of the second
# column of series.csv, `hob_w` before and `hob_drawn_w` now; the sources of validation cases. Checksums of the pictures
# of cross-sections (sections.sums) are compared too, but a difference there is only a notice.
set -euo pipefail
here="$(cd "$(dirname "$0")/.." && pwd)"

say() { printf '%s\n' "$*" >&2; }

# without_timings: JSON without wall times, each text in `warnings` replaced.
without_timings() {
    awk '/^ *"wall_s":/ { next }
         /"warnings": \[$/ { inside = 1; print; next }
         inside && /^ *\]/ { inside = 0 }
         inside { sub(/".*"/, "\"(a warning)\"") }
         { print }'
}

# series CSV: with today's name of the second column.
with_todays_header() { sed '1s/^time_s,hob_w,/time_s,hob_drawn_w,/' "$1"; }

# first_values FILE: commands of sed that put the first value in each place that a case varies.
first_values() {
    awk -F'"' '/^replace = / { place = $2 }
               /^values = / { value = $2; if (NF == 1) { value = $0; sub(/^values = \[ */, "", value); sub(/ *[],].*/, "", value) }
                              print "s|" place "|" value "|g" }' "$1"
}

# text_of KEY FILE: the multi-line text of a key in a cook case, with the first of the values that it varies.
text_of() {
    awk -v start="$1 = '''" 'index($0, start) == 1 { inside = 1; next } index($0, "'"'''"'") == 1 { inside = 0 } inside' "$2" |
        sed -f <(first_values "$2")
}

# collect_inputs DIR: the recipes and cases of the working tree, and the list of runs.
collect_inputs() {
    local dir="$1" file id
    mkdir -p "$dir/inputs/recipes" "$dir/inputs/gallery" "$dir/inputs/validation" "$dir/inputs/cooks"
    cp "$here"/recipes/*.toml "$dir/inputs/recipes/"
    cp "$here"/gallery/*.toml "$dir/inputs/gallery/"
    cp "$here"/validation/*.toml "$dir/inputs/validation/"
    cd "$dir/inputs"
    {
        for file in validation/*.toml; do
            id="$(basename "$file" .toml)"
            if grep -q '^recipe = ' "$file"; then
                text_of recipe "$file" >"cooks/$id.toml"
                echo "cook cook-validation-$id cooks/$id.toml"
                if grep -q '^against = ' "$file"; then
                    text_of against "$file" >"cooks/$id-against.toml"
                    echo "cook cook-validation-$id-against cooks/$id-against.toml"
                fi
            else
                echo "lab lab-$id $file"
            fi
            echo "validate validate-$id $id"
        done
        echo "table table step-coin"
        for file in recipes/*.toml; do echo "cook cook-$(basename "$file" .toml) $(basename "$file" .toml)"; done
        for file in gallery/*.toml; do echo "cook cook-gallery-$(basename "$file" .toml) $file"; done
    } >runs.any
    # The longest run goes first, so that no job is left alone with it.
    { grep 'validate-seen-' runs.any; grep -v 'validate-seen-' runs.any; } >runs
    rm runs.any
    cd "$here"
}

# one KIND NAME ARGUMENT: makes one run; its results are files RESULTS/NAME.*.
one() {
    local kind="$1" name="$2" argument="$3" start="$SECONDS" code=0 out
    out="$RESULTS/$name"
    case "$kind" in
        cook)
            "$SAUTE" cook "$argument" --json --out "$out.files" >"$out.raw" 2>"$out.err" || code=$?
            if [ -f "$out.files/series.csv" ]; then
                with_todays_header "$out.files/series.csv" >"$out.csv"
                (cd "$out.files" && sha256sum -- *.png 2>/dev/null) >"$out.sections.sums" || true
            fi
            without_timings <"$out.raw" >"$out.json"
            rm -rf "$out.files"
            ;;
        lab)
            "$SAUTE" lab "$argument" --json >"$out.raw" 2>"$out.err" || code=$?
            without_timings <"$out.raw" >"$out.json"
            ;;
        validate)
            "$SAUTE" validate --case "$argument" --json >"$out.json" 2>"$out.err" || code=$?
            ;;
        table) "$SAUTE" validate --case "$argument" >"$out.txt" 2>"$out.err" || code=$? ;;
    esac
    rm -f "$out.raw"
    echo "$code" >"$out.exit"
    [ "$code" -le 1 ] || say "$name ended with exit code $code: $(tail -3 "$out.err")"
    rm -f "$out.err"
    echo >>"$RESULTS/.done"
    say "$(printf '%3d of %d  %-50s %4d s' "$(wc -l <"$RESULTS/.done")" "$RUNS" "$name" $((SECONDS - start)))"
}

# make_results DIR RESULTS PATTERN: makes the runs listed in DIR with $SAUTE.
make_results() {
    local inputs="$1/inputs" begun="$SECONDS"
    RESULTS="$2"
    mkdir -p "$RESULTS"
    rm -f "$RESULTS/.done"
    RUNS="$(awk -v p="$3" '$2 ~ p' "$inputs/runs" | wc -l)"
    if [ "$RUNS" = 0 ]; then say "no run matches $3"; exit 2; fi
    for icd in /usr/share/vulkan/icd.d/lvp_icd*.json; do
        [ -e "$icd" ] && export VK_DRIVER_FILES="$icd"
    done
    export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-/tmp}"
    export SAUTE RESULTS RUNS
    export -f one say without_timings with_todays_header
    (cd "$inputs" && awk -v p="$3" '$2 ~ p' runs | xargs -P "${JOBS:-2}" -L 1 bash -c 'set -euo pipefail; one "$@"' one)
    rm -f "$RESULTS/.done"
    say "$RUNS runs in $((SECONDS - begun)) s"
}

# build_revision REVISION: builds it in a separate worktree and prints where the program is.
build_revision() {
    local sha tree program
    sha="$(git -C "$here" rev-parse --verify --quiet "$1^{commit}")" || {
        say "$1 is no folder of saved results, no program and no git revision"
        exit 2
    }
    program="$here/target/same-bytes/saute-$sha"
    if [ ! -x "$program" ]; then
        tree="$(mktemp -d)"
        git -C "$here" worktree add --quiet --detach "$tree/base" "$sha"
        say "building $1"
        (cd "$tree/base" && cargo build --release --workspace --bin saute --target-dir "$here/target/same-bytes/target" >&2)
        cp "$here/target/same-bytes/target/release/saute" "$program"
        git -C "$here" worktree remove --force "$tree/base"
        rmdir "$tree"
    fi
    echo "$program"
}

# own_program: the program of the working tree, or $SAUTE.
own_program() {
    if [ -z "${SAUTE:-}" ]; then
        say "building the working tree"
        (cd "$here" && cargo build --release --workspace --bin saute >&2)
        SAUTE="$here/target/release/saute"
    fi
    SAUTE="$(realpath "$SAUTE")"
}

# save DIR PATTERN: saves the results of $SAUTE with their inputs.
save() {
    rm -rf "$1/inputs" "$1/results"
    mkdir -p "$1"
    collect_inputs "$(realpath "$1")"
    make_results "$(realpath "$1")" "$(realpath "$1")/results" "$2"
}

# comparable FILE: what counts of a result: the sources of validation cases are texts for people.
comparable() {
    case "$(basename "$1")" in
        validate-*.json) sed '/^ *"source":/d' "$1" ;;
        table.txt) sed '/^  [^ ]/d' "$1" ;;
        *) cat "$1" ;;
    esac
}

# differences BASE MINE: prints what differs; fails if a result does.
differences() {
    local file name bad=0 pictures=0
    for file in "$1"/*; do
        name="$(basename "$file")"
        # With PATTERN only some runs were made.
        [ -e "$2/${name%%.*}.exit" ] || continue
        if cmp -s <(comparable "$file") <(comparable "$2/$name" 2>&1); then continue; fi
        case "$name" in
            *.sections.sums)
                pictures=$((pictures + 1))
                say "notice: pictures of ${name%%.*} differ"
                ;;
            *)
                bad=$((bad + 1))
                say "DIFFERS: $name"
                diff <(comparable "$file") <(comparable "$2/$name") 2>&1 | head -8 >&2 || true
                ;;
        esac
    done
    [ "$bad" = 0 ] && say "all results are the same, byte for byte"
    [ "$pictures" = 0 ] || say "notice: pictures of cross-sections of $pictures cooks differ"
    [ "$bad" = 0 ] || { say "$bad files differ; the new ones are in $2"; return 1; }
}

usage() { sed -n '2,7p' "${BASH_SOURCE[0]}" | sed 's/^# \{0,1\}//' >&2; exit 2; }

case "${1:-}" in
    "" | -h | --help) usage ;;
    save)
        [ -n "${2:-}" ] || usage
        [ -n "${3:-}" ] && SAUTE="$3"
        own_program
        save "$2" .
        ;;
    *)
        base="$1" pattern="${2:-.}" work="$here/target/same-bytes"
        mkdir -p "$work"
        # The working tree's program is kept for after the base's runs.
        own_program
        mine="$SAUTE"
        if [ ! -d "$base" ]; then
            if [ -x "$base" ]; then SAUTE="$(realpath "$base")"; else SAUTE="$(build_revision "$base")"; fi
            base="$work/base"
            say "results of the base"
            save "$base" "$pattern"
        fi
        SAUTE="$mine"
        mine="$work/mine.$$"
        say "results of $SAUTE"
        make_results "$(realpath "$base")" "$mine" "$pattern"
        differences "$(realpath "$base")/results" "$mine"
        rm -rf "$mine"
        ;;
esac
