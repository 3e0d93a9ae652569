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
            data/* | recipes/* | validation/* | gallery/*) echo saute-kitchen ;;
        esac
    done
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
