# Compiles crates for the browser. Sourced, not run.

WASM_TARGET=wasm32-unknown-unknown
# Debian's compiler for the browser, for machines where rustup cannot fetch the target.
DEBIAN_WASM_PACKAGES=(rustc-web cargo-web rust-web-src lld)

# check_wasm CRATE...: by rustup's target, else under CI by Debian's compiler, else skipped with a notice.
check_wasm() {
    local crates=()
    local crate
    for crate in "$@"; do crates+=(-p "saute-$crate"); done
    if rustup_has_target; then
        RUSTFLAGS='--cfg getrandom_backend="wasm_js"' cargo build --release --target "$WASM_TARGET" "${crates[@]}"
    elif [ "${CI:-}" = true ] && command -v apt-get >/dev/null && install "${DEBIAN_WASM_PACKAGES[@]}"; then
        debian_wasm "${crates[@]}"
    else
        say "skipped: the target $WASM_TARGET is not installed and could not be added"
    fi
}

rustup_has_target() {
    command -v rustup >/dev/null || return 1
    rustup target list --installed 2>/dev/null | grep -qx "$WASM_TARGET" && return 0
    timeout 120 rustup target add "$WASM_TARGET" >/dev/null 2>&1
}

# The standard library is built from source; nightly-only switches are allowed by RUSTC_BOOTSTRAP.
debian_wasm() {
    RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc \
        CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld \
        RUSTFLAGS='--cfg getrandom_backend="wasm_js"' \
        /usr/bin/cargo build -Zbuild-std=std,panic_abort --target "$WASM_TARGET" --release \
        --target-dir target/web "$@"
}
