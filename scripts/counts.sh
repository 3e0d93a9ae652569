# Counts instructions by Callgrind and compares them with scripts/counts.toml. Sourced, not run.

COUNTS_FILE=scripts/counts.toml
# A count that rises or falls by more is a failure [%].
COUNTS_TOLERANCE=3
# Switches off what glibc chooses by the processor; programs under Valgrind see the features that Valgrind passes on.
PLAIN_PROCESSOR=glibc.cpu.hwcaps=-AVX2,-AVX,-AVX512F,-FMA,-FMA4,-BMI2,-ERMS,-FSRM,-SSE4_1,-SSE4_2,-SSSE3

# counts_folder: where counts and Callgrind's outputs are kept.
counts_folder() { echo "${CARGO_TARGET_DIR:-$PWD/target}/counts"; }

# counts_program: the program that does the work.
counts_program() { realpath "${CARGO_TARGET_DIR:-target}/release/saute-counts"; }

# counted_with: compiler, target, profile and flags, in the form of the file.
counted_with() {
    printf 'rustc = "%s"\n' "$(rustc --version | sed 's/^rustc //')"
    printf 'target = "%s"\n' "$(rustc --version --verbose | sed -n 's/^host: //p')"
    printf 'profile = "release"\n'
    printf 'rustflags = "%s"\n' "${RUSTFLAGS:-}"
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
        "$1" "$2" "$3" | sed -n 's/^units //p')"
    echo $(($(own_instructions "$1" "$out") / units)) >"$2/$3"
    say "  $3: $(cat "$2/$3")"
}

# count: counts all work, two pieces at a time.
count() {
    local folder program
    folder="$(counts_folder)"
    rm -rf "$folder"
    mkdir -p "$folder"
    # With the same features of dependencies as the tests, so that nothing is built twice.
    cargo test --release --workspace --no-run 2> >(grep -v '^  Executable' >&2)
    program="$(counts_program)"
    export -f say count_one own_instructions
    export PLAIN_PROCESSOR
    "$program" "$folder" >"$folder/names"
    <"$folder/names" xargs -P 2 -I NAME bash -c 'set -euo pipefail; count_one "$@"' count "$program" "$folder" NAME
}

# counts_in_file: the file that the new counts make.
counts_in_file() {
    local name
    sed '/^\[/,$d' "$COUNTS_FILE"
    printf '[counted_with]\n'
    counted_with
    printf '\n[instructions]\n'
    while read -r name; do printf '%s = %s\n' "$name" "$(cat "$(counts_folder)/$name")"; done <"$(counts_folder)/names"
}

# bless_counts: writes the numbers of this machine.
bless_counts() {
    count
    counts_in_file >"$(counts_folder)/new.toml"
    mv "$(counts_folder)/new.toml" "$COUNTS_FILE"
    say "wrote $COUNTS_FILE"
}

# counted_alike: succeeds where compiler, target, profile and flags are those of the file.
counted_alike() { [ "$(sed -n '/^\[counted_with\]/,/^$/p' "$COUNTS_FILE" | sed '1d;/^$/d')" = "$(counted_with)" ]; }

# compare_counts: prints old and new counts; fails where one left its band and was counted alike.
compare_counts() {
    local alike=yes
    if ! command -v valgrind >/dev/null; then
        say "skipped: valgrind is not installed"
        return 0
    fi
    count
    if ! counted_alike; then
        alike=no
        say "counted with another compiler, target, profile or flags than $COUNTS_FILE: differences are no failures"
    fi
    counts_in_file | table_of_counts "$alike"
}

# table_of_counts ALIKE: the file's counts and those of stdin; fails where a name is in one of them alone, and where ALIKE is yes and a
# count left its band.
table_of_counts() {
    awk -v tolerance="$COUNTS_TOLERANCE" -v alike="$1" '
        /^\[/ { inside = $0 == "[instructions]"; next }
        !inside || !/ = / { next }
        FNR == NR { old[$1] = $3; next }
        {
            new[$1] = $3
            if (!($1 in old)) { printf "%-20s %12s -> %12d  is new: bless\n", $1, "", $3; unnamed = 1; next }
            change = 100 * ($3 - old[$1]) / old[$1]
            verdict = change > tolerance ? "TOO MANY" : change < -tolerance ? "FEWER: bless" : "holds"
            if (verdict != "holds") left = 1
            printf "%-20s %12d -> %12d  %+7.2f %%  %s\n", $1, old[$1], $3, change, verdict
        }
        END {
            for (name in old) if (!(name in new)) { printf "%-20s is counted no more: bless\n", name; unnamed = 1 }
            if (unnamed) {
                print "the file does not name exactly the work that is counted: ./test.sh bless-counts"
                exit 1
            }
            if (left && alike == "yes") {
                print "counts left their band of " tolerance " %: mend what got slower; or ./test.sh bless-counts, and say why"
                exit 1
            }
        }' "$COUNTS_FILE" -
}
