# Compiles crates for the browser. Sourced, not run.

WASM_TARGET=wasm32-unknown-unknown
# Debian's compiler for the browser, for machines where rustup cannot fetch the target.
DEBIAN_WASM_PACKAGES=(rustc-web cargo-web rust-web-src lld)
# 128-bit vectors: browsers have them since 2021 (Safari 16.4: 2023), and their results are those of single numbers.
WASM_FLAGS='--cfg getrandom_backend="wasm_js" -C target-feature=+simd128'

# cargo_wasm COMMAND PROFILE ARGS...: cargo for the browser in a profile, by rustup's target, else by Debian's compiler.
# The folder of the results is $(wasm_folder).
cargo_wasm() {
    if rustup_has_target; then
        RUSTFLAGS="$WASM_FLAGS" cargo "$1" --profile "$2" --target "$WASM_TARGET" "${@:3}"
    elif command -v apt-get >/dev/null && install "${DEBIAN_WASM_PACKAGES[@]}"; then
        debian_wasm "$1" --profile "$2" --target-dir "$(wasm_folder)" "${@:3}"
    else
        say "the target $WASM_TARGET is missing: rustup target add $WASM_TARGET"
        return 1
    fi
}

# wasm_folder: apart for Debian's compiler, whose version differs from that of rustup.
wasm_folder() {
    if rustup_has_target; then echo "${CARGO_TARGET_DIR:-target}"; else echo "${CARGO_TARGET_DIR:-target}/debian"; fi
}

# rustup_has_target: whether rustup has the target or can add it; tried once.
rustup_has_target() {
    if [ -z "${RUSTUP_HAS_TARGET:-}" ]; then
        RUSTUP_HAS_TARGET=no
        if command -v rustup >/dev/null; then
            if rustup target list --installed 2>/dev/null | grep -qx "$WASM_TARGET" ||
                timeout 120 rustup target add "$WASM_TARGET" >/dev/null 2>&1; then
                RUSTUP_HAS_TARGET=yes
            fi
        fi
    fi
    [ "$RUSTUP_HAS_TARGET" = yes ]
}

# The standard library is built from source; nightly-only switches are allowed by RUSTC_BOOTSTRAP.
debian_wasm() {
    RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc \
        CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld RUSTFLAGS="$WASM_FLAGS" \
        /usr/bin/cargo "$1" -Zbuild-std=std,panic_abort --target "$WASM_TARGET" "${@:2}"
}
