# Which packages were changed. Sourced, not run.

# changed_files: names of files that differ from origin/main (from HEAD, where there is none), and new files.
changed_files() {
    local base=HEAD
    if git rev-parse --quiet --verify origin/main >/dev/null; then
        base="$(git merge-base origin/main HEAD)"
    fi
    git diff --name-only "$base"
    git ls-files --others --exclude-standard
}

# packages_of FILE...: the package of each file in crates/; data, recipes and cases are inside saute-kitchen.
packages_of() {
    local file manifest
    for file in "$@"; do
        case "$file" in
            crates/*/*)
                manifest="$(cut -d/ -f1,2 <<<"$file")/Cargo.toml"
                if [ -f "$manifest" ]; then sed -n 's/^name = "\(.*\)"/\1/p' "$manifest" | head -1; fi
                ;;
            fuzz/*) echo saute-attack ;;
            xtask/* | scripts/*) echo saute-xtask ;;
            data/* | recipes/* | validation/* | gallery/*) echo saute-kitchen ;;
        esac
    done
}

# unit_kinds PACKAGE...: --lib and --bins, as far as one of them has such units: cargo refuses to look for what no package has.
unit_kinds() {
    local package folder kinds=()
    for package in "$@"; do
        folder="$(dirname "$(grep -l "^name = \"$package\"" crates/*/Cargo.toml xtask/Cargo.toml)")"
        if [ -e "$folder/src/lib.rs" ]; then kinds+=(--lib); fi
        if [ -e "$folder/src/main.rs" ]; then kinds+=(--bins); fi
    done
    printf '%s\n' "${kinds[@]}" | sort -u
}

# with_dependents PACKAGE...: these, and the packages of the workspace that need them.
with_dependents() {
    local package
    for package in "$@"; do
        cargo tree --workspace --offline --invert "$package" --edges normal,dev --prefix none --format '{p}' 2>/dev/null |
            sed -n 's/^\([^ ]*\) v[^ ]* (\/.*/\1/p'
    done | sort -u
}

# changed_packages: each once.
changed_packages() {
    local files
    mapfile -t files < <(changed_files)
    packages_of "${files[@]}" | sort -u
}
