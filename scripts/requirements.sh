# What run.sh and test.sh need from the system, and how it is installed. Sourced, not run.

# Commands that build C parts, libraries that the window loads, a software Vulkan driver for machines without a GPU,
# a font with kana and kanji for the window in Japanese.
RUN_PACKAGES=(gcc libc6-dev pkg-config libxkbcommon0 libxkbcommon-x11-0 libudev-dev libwayland-client0 libx11-6 libx11-xcb1 libxcursor1 libxi6 libxrandr2 libvulkan1 mesa-vulkan-drivers fonts-ipafont-gothic)

# What the page needs: a linker for programs that run while it is built.
WEB_PACKAGES=(gcc libc6-dev)

# What the tests need besides: a real browser that plays the phone and opens the page, and Callgrind, which counts
# instructions.
TEST_PACKAGES=(chromium valgrind)
# Node.js drives the browser; one from elsewhere than the distribution serves as well.
command -v npm >/dev/null || TEST_PACKAGES+=(nodejs npm)

say() { printf '%s\n' "$*" >&2; }

need_cargo() {
    if ! command -v cargo >/dev/null && [ -x "$HOME/.cargo/bin/cargo" ]; then
        export PATH="$HOME/.cargo/bin:$PATH"
    fi
    if ! command -v cargo >/dev/null; then
        say "cargo is missing: install the Rust toolchain (1.95 or newer), see https://rustup.rs"
        exit 2
    fi
}

as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"
    elif command -v sudo >/dev/null; then sudo "$@"
    else return 1
    fi
}

# installed PACKAGE: whether dpkg has it.
installed() { dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'; }

# install PACKAGE...: the missing ones, by apt-get.
install() {
    local missing=()
    local package
    for package in "$@"; do installed "$package" || missing+=("$package"); done
    [ ${#missing[@]} = 0 ] && return 0
    say "installing: ${missing[*]}"
    as_root apt-get update -qq >&2 || return 1
    DEBIAN_FRONTEND=noninteractive as_root apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# need_packages WHAT: installs on Debian and Ubuntu, elsewhere names the packages once and goes on.
need_packages() {
    if [ "$(uname -s)" != Linux ]; then return 0; fi
    if command -v apt-get >/dev/null; then
        install "${RUN_PACKAGES[@]}" || say "could not install packages; saute needs: ${RUN_PACKAGES[*]}"
    elif ! command -v cc >/dev/null; then
        say "saute needs a C compiler and these libraries (Debian names): ${RUN_PACKAGES[*]}"
        exit 2
    fi
}

# need_test_packages: as need_packages, for what only the tests need; without it they fail with a message.
need_test_packages() {
    if [ "$(uname -s)" != Linux ] || ! command -v apt-get >/dev/null; then return 0; fi
    install "${TEST_PACKAGES[@]}" || say "could not install ${TEST_PACKAGES[*]}: the tests with a real browser will fail, and no instructions are counted"
}
