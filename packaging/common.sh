# Sourced by demo and test: where the project is, progress, and the packages it needs.
# shellcheck shell=bash

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
started=$SECONDS

say() { printf '\n== %s  [%d s]\n' "$*" "$((SECONDS - started))"; }
stop() { printf '\n%s\n' "$*" >&2; exit 2; }

# install_packages SECTION ...: installs what is missing of these sections of dependencies.txt; touches nothing and needs
# no rights when all is there.
install_packages() {
    local package status section= wanted=" $* " missing=()
    command -v dpkg-query >/dev/null || { say "No Debian here: packaging/dependencies.txt names what must be installed"; return; }
    while read -r package; do
        if [[ $package == "#"* ]]; then
            section=${package#"# "}
            section=${section%%:*}
            continue
        fi
        [[ -n $package && $wanted == *" $section "* ]] || continue
        status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
        [[ $status == installed ]] || missing+=("$package")
    done <"$top/packaging/dependencies.txt"
    if ((${#missing[@]} == 0)); then
        say "All packages that this needs are installed (packaging/dependencies.txt)"
        return
    fi
    say "Installing ${missing[*]}"
    local root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null || stop "Please install as root: apt-get install ${missing[*]}"
        root=(sudo)
    fi
    "${root[@]}" apt-get update -q
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
    started=$SECONDS  # what follows is timed without the installation
}

jobs=$(nproc)

# How a build folder is set up for the first time: precompiled headers and several files in one unit, whether the compiler
# cache is filled or not. A cache filled by an earlier state of the shared headers looks full and helps nothing; with these
# settings it can look into precompiled headers too.
export CCACHE_SLOPPINESS=pch_defines,time_macros
first_build() {
    [[ -e $1/CMakeCache.txt ]] || printf '%s' "-DPOLYTURN_PCH=ON -DPOLYTURN_UNITY=ON"
}

# run_ctest FOLDER WORDS …: all tests of this build; the list of those that were skipped; ctest's summary once more, which closes the output.
# The exit status is ctest's, or 1 when one was skipped that tests/skips.txt does not expect.
run_ctest() {
    local build status=0 skips=0
    build=$(realpath "$1")
    shift
    say "Tests"
    rm -f "$build/tests.xml"
    (cd "$build" && ctest --output-on-failure --test-output-size-passed 10000000 --output-junit "$build/tests.xml" -j "$jobs" "$@") | tee "$build/tests.log" || status=$?
    say "Skipped"
    python3 "$top/tests/gate/skips.py" "$build/tests.xml" || skips=1   # also when ctest has left no result
    printf '\n'
    sed -n '/^[0-9]*% tests passed/,$p' "$build/tests.log"
    if ((skips)); then
        printf 'A test was skipped that tests/skips.txt does not expect: see above\n'
        ((status)) || status=1
    fi
    return "$status"
}
