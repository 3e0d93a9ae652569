# Makes the page: the module, wasm-opt, the site. Sourced, not run.

PAGE_DIR="${CARGO_TARGET_DIR:-target}/web/site"
# What saute-site allows the page [bytes with brotli].
PAGE_BYTES=4000000
# The page for tests is the same program, made sooner: less optimised, without wasm-opt, compressed by a fraction. It has a
# separate size limit [bytes with brotli] (chosen: a tenth above what it had with optimising across units; without it has 5,050,000); that of the real page is in saute-site.
TEST_PAGE_DIR="${CARGO_TARGET_DIR:-target}/web/test-site"
TEST_PAGE_BYTES=5100000
# The oldest Node that the tools in web/package.json run on.
OLDEST_NODE=18

# node_is_there: whether Node and npm are there and new enough; prints what is missing.
node_is_there() {
    local version
    if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
        say "Node.js with npm is not installed (version $OLDEST_NODE or newer)"
        return 1
    fi
    version="$(node --version)"
    version="${version#v}"
    if [ "${version%%.*}" -lt "$OLDEST_NODE" ]; then
        say "Node.js $version is too old: $OLDEST_NODE or newer is needed"
        return 1
    fi
}

# need_web_tools: installs the packages of web/package-lock.json once; no package runs its scripts.
need_web_tools() {
    local stamp=web/node_modules/.saute-stamp
    node_is_there || return 1
    cmp -s web/package-lock.json "$stamp" && return 0
    (cd web && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >&2) || return 1
    cp web/package-lock.json "$stamp"
}

# site COMMAND...: the program that makes and serves sites.
site() { "${CARGO_TARGET_DIR:-target}/release/saute-site" "$@"; }

# module PROFILE CRATE: where cargo put the module of a crate.
module() { echo "$(wasm_folder)/$WASM_TARGET/$1/saute_$2.wasm"; }

# build_page [--address URL]: the whole site in PAGE_DIR; seconds where nothing has changed.
build_page() {
    local optimise=()
    cargo_wasm build web -p saute-web -p saute-sound-page
    if need_web_tools; then
        optimise=(--wasm-opt web/node_modules/.bin/wasm-opt)
    else
        say "the page is made without wasm-opt and is larger for it"
    fi
    site build --wasm "$(module web web)" --sound "$(module web sound_page)" --out "$PAGE_DIR" "$@" ${optimise[@]+"${optimise[@]}"}
}

# compile_page: the module of the page for tests, and crates that must work in a browser and are not in the page.
compile_page() { cargo_wasm build web-test -p saute-web -p saute-sound-page -p saute-surface -p saute-lab; }

# make_test_page: the page for tests in TEST_PAGE_DIR, of the module that compile_page made.
make_test_page() {
    site build --wasm "$(module web-test web)" --sound "$(module web-test sound_page)" --out "$TEST_PAGE_DIR" --brotli 5 \
        --most "$TEST_PAGE_BYTES"
}

# test_files: all tests of the page, the longest first, so that no browser is left alone with it.
test_files() {
    local file longest=(likeness scenario foresee lost)
    for file in "${longest[@]}"; do echo "web/test/$file.test.mjs"; done
    for file in web/test/*.test.mjs; do
        case " ${longest[*]} " in *" $(basename -s .test.mjs "$file") "*) ;; *) echo "$file" ;; esac
    done
}

# test_page FILE...: lets Chromium use the page for tests, two browsers at a time, or only these files of web/test.
test_page() {
    local target="${CARGO_TARGET_DIR:-target}" files=("$@")
    need_web_tools
    [ $# -gt 0 ] || mapfile -t files < <(test_files)
    "$target/release/saute-xtask" tests --kept "$target/tests-of-the-page" "saute-window page"
    CHROMIUM="${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome)}" \
        SAUTE_SITE="$(realpath "$target/release/saute-site")" SAUTE_PAGE="${SAUTE_PAGE:-$TEST_PAGE_DIR}" \
        SAUTE_PAGE_BYTES="${SAUTE_PAGE_BYTES:-$TEST_PAGE_BYTES}" SAUTE_PICTURES="$target/web/pictures" \
        SAUTE_STILLS="$target/tmp/page-stills" SAUTE_PROGRAM="$(realpath "$target/release/saute")" \
        node --test --test-concurrency=2 "${files[@]}"
}

# need_page_packages: a linker, for programs that run while the page is built.
need_page_packages() {
    if [ "$(uname -s)" != Linux ] || ! command -v apt-get >/dev/null; then return 0; fi
    install "${WEB_PACKAGES[@]}" || say "could not install packages; the page needs: ${WEB_PACKAGES[*]}"
}

# make_page [--address URL]: builds the page and the program that serves it.
make_page() {
    need_page_packages
    cargo build --release --workspace --bin saute-site
    build_page "$@"
}

# web [--port N] | --build DIR [--address URL]: serves the page here, or writes it.
web() {
    case "${1:-} ${2:+value}" in
        " " | "--port value")
            make_page
            site serve "$PAGE_DIR" "$@"
            ;;
        "--build value")
            if [ $# -gt 2 ] && { [ "$3" != --address ] || [ $# != 4 ]; }; then
                say "usage: ./run.sh web --build DIR [--address URL]"
                exit 2
            fi
            make_page "${@:3}"
            mkdir -p "$2"
            cp -R "$PAGE_DIR/." "$2/"
            say "the site is in $2; what hosts should send: docs/hosting.md"
            ;;
        *)
            say "usage: ./run.sh web [--port N] | ./run.sh web --build DIR [--address URL]"
            exit 2
            ;;
    esac
}
