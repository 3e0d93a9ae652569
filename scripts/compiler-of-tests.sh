#!/usr/bin/env bash
# rustc with less work, for the tests: cargo calls it with the compiler and its arguments (RUSTC_WRAPPER, which is no part of what
# cargo compares, so that nothing is built again with or without it).
#
# A test program is compiled with less effort. It contains the code of the tests, and for unit tests the library once more; what all other
# tests test is the library as everybody gets it, and is compiled as ever.
#
# A crate from a registry is read once. Lints and documentation need of it what is written of its types and functions, its metadata, and
# the build wrote that already: where all arguments are those of the build, and all that the crate needs is what the build gave it, the
# file is copied. Otherwise the compiler makes it. For documentation the same applies to our own crates in a run that has built them
# (SAUTE_BUILT).
set -euo pipefail

# arguments_that_count: those that decide the content of the metadata, one a line. A crate that it needs is stated by the file of the build.
arguments_that_count() {
    local argument before="" file
    for argument in "$@"; do
        case "$before $argument" in
            "-C metadata="* | "-C extra-filename="* | *" --emit="*) ;;
            "--extern "*=*/lib*.rmeta | "--extern "*=*/lib*.rlib)
                file="${argument##*/}"
                file="${file%.*}"
                [ ! -e "$kept/$file" ] || file="$(<"$kept/$file")"
                echo "${argument%%=*} $file"
                ;;
            *) echo "$argument" ;;
        esac
        before="$argument"
    done
}

# made_by_the_build: copies what the build wrote about this crate, if it wrote it.
made_by_the_build() {
    local made
    made="$(cat "$kept/$key" 2>/dev/null)" && [ -e "$folder/$made.rmeta" ] && [ -e "$folder/${made#lib}.d" ] || return 1
    sed "s|${made#lib}|${file#lib}|g" "$folder/${made#lib}.d" >"$folder/${file#lib}.d"
    cp "$folder/$made.rmeta" "$folder/$file.rmeta"
    echo "$made" >"$kept/$file"
}

line=" ${*:2} "
case "$line" in
    # Its tests integrate over millions of places.
    *" --crate-name pictures "*" --test "*) exec "$@" -C opt-level=3 -C codegen-units=4 ;;
    *" --test "*) exec "$@" -C opt-level=1 -C codegen-units=16 ;;
    *" --crate-type lib --emit=dep-info,metadata"*" --out-dir "*) ;;
    *) exec "$@" ;;
esac
case "$line" in
    *"/registry/src/"* | *" --emit=dep-info,metadata,link "*) ;;
    *) [ -n "${SAUTE_BUILT:-}" ] && [[ $1 != *clippy-driver ]] || exec "$@" ;;
esac
name="${line#* --crate-name }"
hash="${line#* extra-filename=}"
file="lib${name%% *}${hash%% *}"
folder="${line#* --out-dir }"
folder="${folder%% *}"
kept="$folder/../metadata"
mkdir -p "$kept"
key="$(arguments_that_count "${@:2}" | sha256sum)"
key="${key%% *}"
case "$line" in
    *" --emit=dep-info,metadata,link "*)
        "$@"
        echo "$file" >"$kept/$key"
        ;;
    *) made_by_the_build || exec "$@" ;;
esac
