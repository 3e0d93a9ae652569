# Counts instructions by Callgrind and compares them with scripts/counts.toml. Sourced, not run.

COUNTS_FILE=scripts/counts.toml
# A count that rises or falls by more is a failure [%].
COUNTS_TOLERANCE=3
# Switches off what glibc chooses by the processor; programs under Valgrind see the features that Valgrind passes on.
PLAIN_PROCESSOR=glibc.cpu.hwcaps=-AVX2,-AVX,-AVX512F,-FMA,-FMA4,-BMI2,-ERMS,-FSRM,-SSE4_1,-SSE4_2,-SSSE3

# counted_with: compiler, target and profile, in the form of the file.
counted_with() {
    local version
    version="$(rustc --version --verbose)"
    printf 'rustc = "%s"\n' "$(sed -n 's/^release: //p; s/^commit-hash: \(.\{9\}\).*/\1/p' <<<"$version" | sort -r | paste -sd' ')"
    printf 'target = "%s"\n' "$(sed -n 's/^host: //p' <<<"$version")"
    printf 'profile = "release"\n'
}

# own_instructions PROGRAM FILE: instructions of a Callgrind output that the program itself executed, without its libraries.
own_instructions() {
    awk -v program="$(realpath "$1")" '
        /^ob=/ { own = substr($0, 4) == program; next }
        /^calls=/ { called = 1; next }
        /^[0-9+*-]/ { if (!called && own) sum += $2; called = 0 }
        END { print sum + 0 }' "$2"
}

# count_one PROGRAM FOLDER NAME: writes FOLDER/NAME with the instructions per unit.
count_one() {
    local out="$2/$3.callgrind" units
    units="$(GLIBC_TUNABLES="$PLAIN_PROCESSOR" valgrind --quiet --tool=callgrind --callgrind-out-file="$out" \
        --toggle-collect='*counted::counted*' --compress-strings=no \
        "$1" "$3" | sed -n 's/^units //p')"
    echo $(($(own_instructions "$1" "$out") / units)) >"$2/$3"
    say "  $3: $(cat "$2/$3")"
}

# count FOLDER: counts all work, two pieces at a time, each into a file of FOLDER.
count() {
    local program
    rm -rf "$1"
    mkdir -p "$1"
    cargo build --release -p saute-counts
    program="$(realpath "${CARGO_TARGET_DIR:-target}/release/saute-counts")"
    export -f say count_one own_instructions
    export PLAIN_PROCESSOR
    "$program" | xargs -P 2 -I NAME bash -c 'set -euo pipefail; count_one "$@"' count "$program" "$1" NAME
}

# counts_in_file FOLDER: the file that these counts make.
counts_in_file() {
    sed '/^\[/,$d' "$COUNTS_FILE"
    printf '[counted_with]\n'
    counted_with
    printf '\n[instructions]\n'
    (cd "$1" && for name in $("$OLDPWD/${CARGO_TARGET_DIR:-target}/release/saute-counts"); do
        printf '%s = %s\n' "$name" "$(cat "$name")"
    done)
}

# bless_counts: writes the numbers of this machine.
bless_counts() {
    local folder="${CARGO_TARGET_DIR:-target}/counts"
    count "$folder"
    counts_in_file "$folder" >"$folder/new.toml"
    mv "$folder/new.toml" "$COUNTS_FILE"
    say "wrote $COUNTS_FILE"
}

# compare_counts: fails where a count left its band; where compiler, target or profile are others, prints both.
compare_counts() {
    local folder="${CARGO_TARGET_DIR:-target}/counts"
    if ! command -v valgrind >/dev/null; then
        say "skipped: valgrind is not installed"
        return 0
    fi
    count "$folder"
    local same=yes
    [ "$(sed -n '/^\[counted_with\]/,/^$/p' "$COUNTS_FILE" | sed '1d;/^$/d')" = "$(counted_with)" ] || same=no
    [ "$same" = yes ] || say "counted with another compiler or for another target than the file; nothing is compared"
    counts_in_file "$folder" | awk -v tolerance="$COUNTS_TOLERANCE" -v same="$same" '
        /^\[/ { inside = $0 == "[instructions]"; next }
        !inside || !/ = / { next }
        FNR == NR { old[$1] = $3; next }
        {
            new[$1] = $3
            if (!($1 in old)) { printf "%-20s %12s -> %12d  is new\n", $1, "-", $3; blame = 1; next }
            change = 100 * ($3 - old[$1]) / old[$1]
            verdict = change > tolerance ? "TOO MANY" : change < -tolerance ? "fewer: bless" : "holds"
            if (verdict != "holds") blame = 1
            printf "%-20s %12d -> %12d  %+6.2f %%  %s\n", $1, old[$1], $3, change, verdict
        }
        END {
            for (name in old) if (!(name in new)) { printf "%-20s is counted no more\n", name; blame = 1 }
            if (blame && same == "yes") {
                print "counts left their band of " tolerance " %: mend what got slower, or run ./test.sh bless-counts and say why"
                exit 1
            }
        }' "$COUNTS_FILE" -
}
