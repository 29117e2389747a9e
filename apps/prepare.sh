# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2034,SC2154 # the files that source this one set root and program, and use the lists
# Sourced by apps/abut and tests/run: installs what a build needs and builds. Expects `root`, the source folder, and `program`, the
# name that messages begin with. Everything that fails prints one line (a failed build: the end of its log) and exits with status 1.

build_packages=(
    libcgal-dev libeigen3-dev libsuitesparse-dev libassimp-dev lib3mf-dev nlohmann-json3-dev libutfcpp-dev libxxhash-dev libboost-dev
    libgmp-dev libmpfr-dev
    # not the reference BLAS, which takes several times as long; the first one may be called from several threads
    "libopenblas-pthread-dev|libopenblas-serial-dev|libopenblas-openmp-dev"
)
test_packages=(libgtest-dev libbenchmark-dev)
# STEP files need OpenCASCADE (libocct-data-exchange-dev): 134 packages more, 115 MB to load and 442 MB installed, beside 203 and
# 1168 MB of the above and the compiler. So it is not installed here; where it is there, its reader is built.
step_header=/usr/include/opencascade/STEPCAFControl_Reader.hxx
sources=(geometry solver src apps data/materials data/drafting_layers.csv CMakeLists.txt CMakePresets.json)

fail() {
    printf '%s: %s\n' "$program" "$1" >&2
    exit 1
}

note() { printf '%s: %s\n' "$program" "$1" >&2; }

at_least() { # at_least 3.25 3.30.1: is the second version not below the first?
    [[ $(printf '%s\n' "$1" "$2" | sort -V | head -n 1) == "$1" ]]
}

# Prints the packages of the commands that are not there; fails where one is there but too old, which no installation cures.
missing_commands() {
    if [[ -z ${CXX:-} ]]; then
        if ! command -v g++ >/dev/null; then
            echo g++
        elif ! at_least 12 "$(g++ -dumpversion)"; then
            fail "g++ $(g++ -dumpversion) is too old, 12 is needed; install a newer one, or name another compiler in CXX"
        fi
    fi
    if ! command -v cmake >/dev/null; then
        echo cmake
    else
        local version
        version=$(cmake --version | sed -n 's/^cmake version \([0-9.]*\).*/\1/p')
        at_least 3.25 "$version" || fail "cmake $version is too old, 3.25 is needed; install a newer one"
    fi
    command -v ninja >/dev/null || echo ninja-build
}

# Prints those of the packages "a" or "a|b|c" (any of them will do) of which none is installed, by the first name.
missing_packages() {
    command -v dpkg-query >/dev/null || return 0 # not Debian: cmake will say what it does not find
    local names installed package
    IFS='|' read -r -a names <<<"$(IFS='|' && echo "$*")"
    # shellcheck disable=SC2016 # dpkg-query's own variables
    installed=" $(dpkg-query -W -f='${Package}=${db:Status-Status} ' "${names[@]}" 2>/dev/null)"
    for package in "$@"; do
        local alternative found=no
        for alternative in ${package//|/ }; do
            [[ $installed == *" $alternative=installed "* ]] && found=yes
        done
        [[ $found == yes ]] || echo "${package%%|*}"
    done
}

as_root() {
    if [[ $(id -u) == 0 ]]; then
        "$@"
    elif [[ -t 0 ]]; then
        sudo "$@"
    else
        sudo -n "$@" # nobody could type a password
    fi
}

apt_get() { # its own output goes to the log; stdin is left alone for sudo, apt-get asks nothing
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@" \
        >>"$root/build/install.log" 2>&1
}

lists_are_empty() { ! compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null; }

install_packages() {
    local by_hand="install by hand: $*"
    command -v apt-get >/dev/null || fail "missing and no apt-get to install it; $by_hand"
    [[ $(id -u) == 0 ]] || command -v sudo >/dev/null || fail "missing, and installing needs root or sudo; $by_hand"
    note "installing $*"
    : >"$root/build/install.log"
    if lists_are_empty; then
        apt_get update # a failure shows again in the installation, with a better message
    fi
    apt_get install --no-install-recommends "$@" && return
    # The lists may be older than what the server still has.
    apt_get update && apt_get install --no-install-recommends "$@" && return
    local reason
    reason=$(grep -E '^(E:|sudo:)' "$root/build/install.log" | tail -n 1)
    fail "installation failed (${reason:-no reason given}); is there a network? log: $root/build/install.log; $by_hand"
}

install_what_is_missing() {
    local commands packages
    commands=$(missing_commands) || exit 1
    packages=$(missing_packages "$@")
    local missing
    mapfile -t missing < <(printf '%s\n%s\n' "$commands" "$packages" | sed '/^$/d')
    ((${#missing[@]} == 0)) || install_packages "${missing[@]}"
}

# One compilation of the exact geometry takes about 1.5 GB: as many at once as there are cores and memory.
count_jobs() {
    local memory
    memory=$(awk '/^MemAvailable:/ {print int($2 / 1500000)}' /proc/meminfo 2>/dev/null)
    local jobs
    jobs=$(nproc)
    ((${memory:-$jobs} >= jobs)) || jobs=$memory
    echo $((jobs > 0 ? jobs : 1))
}

# Standard input into the log and, where standard error is a terminal, its "[3/40] ..." lines into one line there.
follow() {
    if [[ ! -t 2 ]]; then
        cat >>"$1"
        return
    fi
    local line
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$1"
        [[ $line != \[*/*\]* ]] || printf '\r\033[K%s: building %.60s' "$program" "$line" >&2
    done
    printf '\r\033[K' >&2
}

configure() {
    local cache=$1/CMakeCache.txt fresh=()
    # A build folder that was moved or copied with its sources belongs to the old place.
    if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then fresh=(--fresh); fi
    cmake "${fresh[@]}" -S "$root" --preset "$2"
}

configure_then_build() {
    configure "$1" "$2" && cmake --build "$1" -j "$(count_jobs)"
}

# No source is newer than the start of the last build that succeeded? Folders count, so that removed files do.
is_fresh() {
    local stamp=$root/build/$1/built
    [[ -f $stamp && -x $root/build/$1/apps/abut ]] || return 1
    local newer places=("${sources[@]}")
    [[ ! -e $step_header ]] || places+=("$step_header")
    # Packages keep the times of their files: when it was installed is when its state changed.
    newer=$(cd -- "$root" && find "${places[@]}" \( -newer "$stamp" -o -path "$step_header" -newercm "$stamp" \) -print -quit) &&
        [[ -z $newer ]]
}

build() {
    local preset=$1
    local folder=$root/build/$preset
    local log=$folder/build.log
    mkdir -p "$folder" 2>/dev/null || fail "the folder $folder cannot be made; is $root writable?"
    : 2>/dev/null >"$log" || fail "$log cannot be written; is $root writable?"
    touch "$folder/built.next"
    (set -o pipefail && configure_then_build "$folder" "$preset" 2>&1 </dev/null | follow "$log")
    local status=$?
    if ((status != 0)); then
        tail -n 20 "$log" >&2
        fail "the build failed; log: $log"
    fi
    mv -f "$folder/built.next" "$folder/built"
}

# Only one at a time installs or builds in this source folder; the lock ends with `unlock`.
lock() {
    mkdir -p "$root/build" 2>/dev/null || fail "the folder $root/build cannot be made; is $root writable?"
    command -v flock >/dev/null || return 0
    { exec 9>"$root/build/lock"; } 2>/dev/null || fail "$root/build/lock cannot be written; is $root writable?"
    flock -n 9 && return
    [[ ! -t 2 ]] || note "waiting for another build of the same folder"
    flock 9
}

unlock() { exec 9>&-; }
