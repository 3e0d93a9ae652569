#!/usr/bin/env bash
# Everything that must hold: format, lints, tests (window and pictures on software Vulkan), instruction counts, docs,
# and the web page in Chromium. Shows each step, and at the end how long each of them took.
#
#   ./test.sh                all of it
#   ./test.sh quick          format, lints and unit tests of the crates that were changed
#   ./test.sh bless          draws the reference pictures again and prints the colour difference (ΔE) of each
#   ./test.sh bless-counts   writes new instruction counts to scripts/counts.toml
#
# What takes longer by nature is in scripts/campaign.sh; this runs the share of it that is stated there.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/requirements.sh
source scripts/steps.sh
source scripts/wasm.sh
source scripts/web.sh
source scripts/counts.sh
source scripts/changed.sh
source scripts/campaign_share.sh
source scripts/fuzz.sh
source scripts/dependencies.sh
source scripts/python.sh

# Crates that must compile for the browser and are not in the page.
BROWSER_CRATES=(surface lab)

tests() {
    local output="${CARGO_TARGET_DIR:-target}/test-output.txt"
    mkdir -p "$(dirname "$output")"
    # libtest's --quiet prints dots instead of names; cargo names the programs.
    cargo test --release --workspace -- --quiet 2>&1 | tee "$output"
    TESTS_PASSED="$(awk '/^test result:/ { sum += $4 } END { print sum + 0 }' "$output")"
}

# Built with the features of the workspace, as the tests are; else its dependencies would be built anew.
soak() {
    cargo build --release --workspace --bin saute-soak
    "${CARGO_TARGET_DIR:-target}/release/saute-soak" --minutes "$SHARE_SOAK_MINUTES"
}

docs() { RUSTDOCFLAGS="-D warnings" cargo doc --release --workspace --no-deps; }

everything() {
    step "format" cargo fmt --all --check
    step "lints" cargo clippy --release --workspace --all-targets -- -D warnings
    # Apart from the tests, so that cargo can show how far it is.
    step "build of the tests" cargo test --release --workspace --no-run
    step "tests" tests
    step "soak" soak
    step "python" test_python
    step "python on ray" test_python_on_ray
    step "files for VTK" test_vtk
    step "fuzzer" fuzz_briefly "$SHARE_FUZZ_S"
    step "dependencies" judge_dependencies
    step "instruction counts" compare_counts
    step "docs" docs
    step "browser crates" check_wasm "${BROWSER_CRATES[@]}"
    step "web page" test_page
    finish "all passed: $TESTS_PASSED tests"
}

quick() {
    local packages
    mapfile -t packages < <(changed_packages)
    step "format" cargo fmt --all --check
    if [ ${#packages[@]} = 0 ]; then
        finish "no crate was changed"
        return
    fi
    say "changed: ${packages[*]}"
    step "lints" cargo clippy --release "${packages[@]/#/--package=}" --all-targets -- -D warnings
    step "unit tests" cargo test --release "${packages[@]/#/--package=}" --lib --bins -- --quiet
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

case "${1:-}" in
    "")
        need_test_packages
        everything
        ;;
    quick) quick ;;
    bless) SAUTE_BLESS=1 cargo test --release --quiet -p saute-picture --test pictures looks:: -- --nocapture ;;
    bless-counts)
        need_test_packages
        bless_counts
        ;;
    *)
        sed -n '5,8p' "$0" | sed 's/^# *//' >&2
        exit 2
        ;;
esac
