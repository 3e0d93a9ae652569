#!/usr/bin/env bash
# Everything that must hold: format, lints, tests (window and pictures on software Vulkan), instruction counts, docs,
# and the web page in Chromium. Steps run side by side; the first failure ends the run and prints how to run that step alone.
#
#   ./test.sh                  all of it
#   ./test.sh step NAME        one step, with what was built before: step tests saute-heat, step browser web/test/link.test.mjs
#   ./test.sh quick            format, lints of the crates that were changed and of those that need them, unit tests of the changed
#   ./test.sh bless            draws the reference pictures again and prints the colour difference (ΔE) of each
#   ./test.sh bless-counts     writes new instruction counts to scripts/counts.toml
#   ./test.sh bless-durations  writes the work of the last whole run to scripts/durations.toml
#
# Pictures that no test compares are drawn with SAUTE_PICTURES=1. What takes longer by nature is in scripts/campaign.sh;
# this runs the share of it that is stated there.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh
source scripts/steps.sh
source scripts/lanes.sh
source scripts/wasm.sh
source scripts/web.sh
source scripts/counts.sh
source scripts/changed.sh
source scripts/campaign_share.sh
source scripts/python.sh

# Test programs are compiled with less effort than what they test, and crates from outside are read once.
export RUSTC_WRAPPER="${RUSTC_WRAPPER:-$PWD/scripts/compiler-of-tests.sh}"
RELEASE="${CARGO_TARGET_DIR:-target}/release"

# Each with the steps that must have ended before it begins. Those that build natively wait for one another, as cargo
# would make them.
STEPS=(
    "format:"
    "page:"
    "build: format"
    "lints: build"
    "tests: build"
    "site: page build"
    "browser: site"
    "python: build"
    "ray: python"
    "vtk: python"
    "soak: build"
    "counts: build"
    "examples: lints"
    "docs: examples"
)

step_format() { cargo fmt --all --check; }

# After the build, whose metadata of the crates from outside it uses.
step_lints() { cargo clippy --release --workspace --all-targets -- -D warnings; }

# Tests, programs and the library for Python, each with the same features, so that nothing is built twice.
step_build() {
    cargo test --release --workspace --no-run
    cargo build --release --workspace --lib --bins
}

step_page() { compile_page; }

step_site() { make_test_page; }

step_browser() { test_page "$@"; }

# The programs that draw and record what the page is compared with belong to the step "browser".
step_tests() {
    "$RELEASE/saute-xtask" tests --kept "${CARGO_TARGET_DIR:-target}/tests" --without "saute-window page" "$@"
}

# Examples in the documentation.
step_examples() { cargo test --release --workspace --doc -- --quiet; }

step_soak() { "$RELEASE/saute-soak" --minutes "$SHARE_SOAK_MINUTES"; }

step_python() { test_python; }

step_ray() { test_python_on_ray; }

step_vtk() { test_vtk; }

step_counts() { compare_counts; }

# In a whole run, with what the build wrote about our own crates too.
step_docs() { RUSTDOCFLAGS="-D warnings" cargo doc --release --workspace --no-deps; }

# judge_durations [--bless]: the table of the last run; fails where more was counted than is allowed.
judge_durations() {
    "$RELEASE/saute-xtask" durations --steps "$STEPS_FOLDER" --budget scripts/durations.toml --saute "$RELEASE/saute" \
        --wall-s "$(cat "$STEPS_FOLDER/wall")" "$@"
}

everything() {
    export SAUTE_BUILT=yes
    side_by_side "${STEPS[@]}"
    echo "$SECONDS" >"$STEPS_FOLDER/wall"
    judge_durations
    printf '== all passed: %s tests, in %s min\n' \
        "$(awk '/^passed: / { sum += $2 } END { print sum + 0 }' "$STEPS_FOLDER"/*.log)" "$(clock "$SECONDS")"
}

quick() {
    local packages touched kinds
    mapfile -t packages < <(changed_packages)
    step "format" cargo fmt --all --check
    if [ ${#packages[@]} = 0 ]; then
        finish "no crate was changed"
        return
    fi
    say "changed: ${packages[*]}"
    mapfile -t touched < <(with_dependents "${packages[@]}")
    step "lints" cargo clippy --release "${touched[@]/#/--package=}" --all-targets -- -D warnings
    # In the profile of development, which builds again only what has changed in a crate.
    mapfile -t kinds < <(unit_kinds "${packages[@]}")
    step "unit tests" cargo test "${packages[@]/#/--package=}" "${kinds[@]}" -- --quiet
    finish "quick checks passed"
}

need_cargo
need_packages
# Tests draw on the software rasteriser wherever one is, so that pictures do not depend on the machine's GPU.
for icd in /usr/share/vulkan/icd.d/lvp_icd*.json; do
    [ -e "$icd" ] && export VK_DRIVER_FILES="$icd"
done
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$(mktemp -d)}"
fix_campaign_share

case "${1:-} ${2:+value}" in
    " ")
        need_test_packages
        everything
        ;;
    "step value")
        need_test_packages
        run_step "${@:2}"
        ;;
    "quick ") quick ;;
    "bless ") SAUTE_BLESS=1 cargo test --release --quiet -p saute-picture --test pictures looks:: -- --nocapture ;;
    "bless-counts ")
        need_test_packages
        bless_counts
        ;;
    "bless-durations ") judge_durations --bless ;;
    *)
        sed -n '5,10p' "$0" | sed 's/^# *//' >&2
        exit 2
        ;;
esac
