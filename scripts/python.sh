# The Python package: virtual environments with it, and its tests. Sourced, not run.

# What building the package needs from the system.
PYTHON_PACKAGES=(gcc libc6-dev python3 python3-venv)

# need_python: Python 3.9 or newer that can make virtual environments; on Debian it is installed if it is missing.
need_python() {
    python3 -c 'import ensurepip, venv' 2>/dev/null || install "${PYTHON_PACKAGES[@]}" || true
    python3 -c 'import ensurepip, venv, sys; sys.exit(sys.version_info < (3, 9))' 2>/dev/null && return 0
    say "Python 3.9 or newer with the module venv is needed (Debian: python3-venv)"
    return 1
}

# python_environment FOLDER REQUIREMENTS: a virtual environment with pinned packages, made again where their list changed.
python_environment() {
    local stamp="$1/.saute-stamp"
    cmp -s "$2" "$stamp" && return 0
    need_python || return 1
    rm -rf "$1"
    python3 -m venv "$1"
    "$1/bin/python" -m pip install --quiet --disable-pip-version-check --requirement "$2"
    cp "$2" "$stamp"
}

# python_with_package: a virtual environment in which `pip install ./python` was done, for people; prints its folder.
python_with_package() {
    local folder="${CARGO_TARGET_DIR:-target}/python-venv"
    python_environment "$folder" python/requirements-build.txt || return 1
    # The pinned maturin builds it; cargo detects what is up to date.
    PATH="$(realpath "$folder")/bin:$PATH" "$folder/bin/python" -m pip install --quiet --disable-pip-version-check \
        --no-build-isolation --no-deps ./python >&2
    realpath "$folder"
}

# python_prompt ARGUMENTS...: a prompt, or a script with its arguments, with the package.
python_prompt() {
    local folder
    folder="$(python_with_package)" || exit 2
    exec "$folder/bin/python" "$@"
}

# lay_package FOLDER: the package with the library that was built with the workspace, as a wheel would lay it there.
# Built apart by maturin, all dependencies would be built a second time with other features; that is for the campaign.
lay_package() {
    local target="${CARGO_TARGET_DIR:-target}" place library
    cargo build --release --workspace --lib --bin saute
    place="$("$1/bin/python" -c 'import sysconfig; print(sysconfig.get_paths()["platlib"])')/saute"
    rm -rf "$place"
    cp -R python/saute "$place"
    for library in "$target"/release/libsaute_python.{so,dylib}; do
        if [ -e "$library" ]; then cp "$library" "$place/_core.abi3.so"; fi
    done
}

# with_package NAME: an environment with the packages of python/requirements-NAME.txt and the package; sets PYTHON to its program.
with_package() {
    local folder="${CARGO_TARGET_DIR:-target}/python-$1"
    python_environment "$folder" "python/requirements-$1.txt"
    lay_package "$folder"
    PYTHON="$folder/bin/python"
}

# pytest_in NAME ARGUMENTS...: tests of the package in the environment of that name.
pytest_in() {
    with_package "$1"
    SAUTE_PROGRAM="$(realpath "${CARGO_TARGET_DIR:-target}/release/saute")" RAY_USAGE_STATS_ENABLED=0 \
        "$PYTHON" -m pytest --quiet -p no:cacheprovider "${@:2}"
}

# test_python: the tests of the package that need little besides.
test_python() { pytest_in test python/tests "$@"; }

# test_python_on_ray: sweeps on a Ray cluster on this machine.
test_python_on_ray() { pytest_in ray python/tests_ray "$@"; }

# test_vtk: VTK and meshio read what the program writes for them, and PyVista what the package gives.
test_vtk() {
    pytest_in vtk python/tests_vtk "$@"
    pytest_in vtk python/tests/test_arrays.py -k pyvista
}

# test_wheel: the package as `pip install ./python` makes it, in a clean environment with NumPy alone.
test_wheel() {
    local folder
    folder="$(python_with_package)"
    "$folder/bin/python" -c 'import saute; k = saute.Kitchen("medium"); k.step(10); print(saute.__version__, k.pan_c)'
}

# train_briefly: the training example with a third of its updates; it must score what a careful cook does with one turn.
train_briefly() {
    with_package test
    "$PYTHON" python/examples/train_steak.py --seed 2 --updates "$CAMPAIGN_TRAINING_UPDATES" --wanted 25
}
