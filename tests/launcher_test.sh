#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests of apps/abut: a copy of it, in a folder with blanks in its name, builds a program of a few lines. Package tools are replaced
# by scripts, so nothing is ever installed. Prints what fails; exit status 0 if nothing does.
# shellcheck disable=SC2317 # the tests are called by name
set -u

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
top="$work/check out"
tools=$work/tools
failures=0

expect() { # expect WHAT COMMAND...: the command must succeed
    local what=$1
    shift
    "$@" && return
    echo "failed: $what"
    sed 's/^/    /' "$work/stdout" "$work/stderr"
    failures=$((failures + 1))
}

says() { grep -qF -- "$2" "$work/$1"; }
is_one_line() { [[ $(wc -l <"$work/stderr") == 1 ]]; }
is_empty() { [[ ! -s $work/$1 ]]; }

# run STATUS [ARGUMENT...] from another folder and without a terminal, the tools first in the path
run() {
    local wanted=$1
    shift
    (cd "$work/elsewhere" && PATH=$tools:$PATH "$work/a link" "$@" >"$work/stdout" 2>"$work/stderr" </dev/null)
    local status=$?
    expect "exit status $wanted (was $status)" test "$status" == "$wanted"
}

tool() { # tool NAME: a script from standard input
    { echo '#!/usr/bin/env bash' && cat; } >"$tools/$1"
    chmod +x "$tools/$1"
}

# The program prints its first line of source, its arguments, and whether the last of them is a file.
program_of() {
    cat >"$top/apps/main.cpp" <<END
#include <cstdio>
int main(int n, char** words) {
    std::printf("$1\n");
    for (int i = 1; i < n; ++i) std::printf("[%s]\n", words[i]);
    if (std::FILE* file = std::fopen(words[n - 1], "r")) std::printf("found\n"), std::fclose(file);
    return n > 1 ? 0 : 7;
}
END
}

make_copy() {
    rm -rf -- "${work:?}"/*
    mkdir -p "$top"/{apps,geometry,solver,src,tests,data/materials} "$tools" "$work/elsewhere"
    cp "$here/../apps/abut" "$here/../apps/prepare.sh" "$top/apps"
    cp "$here/../CMakePresets.json" "$top"
    : >"$top/data/drafting_layers.csv"
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(trial LANGUAGES CXX)' 'add_subdirectory(apps)' >"$top/CMakeLists.txt"
    echo 'add_executable(abut main.cpp)' >"$top/apps/CMakeLists.txt"
    program_of first
    ln -s "$top/apps/abut" "$work/a link"
    echo >"$work/elsewhere/my scene.json"
    # All packages are installed but those in $work/missing; apt-get notes what it is asked and installs what it is asked to.
    : >"$work/missing"
    tool dpkg-query <<END
for word; do
    [[ \$word == -* ]] || grep -qx "\$word" "$work/missing" || printf '%s=installed ' "\$word"
done
END
    tool apt-get <<END
echo "\$*" >>"$work/asked"
END
    tool id <<<'echo 0'
}

test_first_run_builds_and_passes_everything_on() {
    make_copy
    run 0 analyze 'a  b*' 'my scene.json'
    expect 'arguments arrive unchanged' says stdout '[a  b*]'
    expect 'relative paths hold' says stdout found
    expect 'nothing on standard error' is_empty stderr
    run 7
}

test_second_run_does_not_build() {
    make_copy
    run 0 x
    tool cmake <<<'exit 9'
    tool find <<<"echo x >>'$work/find_calls'; exec $(command -v find) \"\$@\""
    run 0 x
    expect 'one look for newer files' test "$(wc -l <"$work/find_calls")" == 1
}

test_changed_sources_are_built() {
    make_copy
    run 0 x
    program_of second
    run 0 x
    expect 'the new program runs' says stdout second
    program_of 'broken" +'
    run 1 x
    expect 'the old program does not run' is_empty stdout
    expect 'the compiler is heard' says stderr main.cpp
    expect 'the log is named' says stderr "$top/build/release/build.log"
    expect 'at most 21 lines' test "$(wc -l <"$work/stderr")" -le 21
    program_of third
    run 0 x
    expect 'the repaired program runs' says stdout third
}

test_moved_folder() {
    make_copy
    run 0 x
    mv "$top" "$work/moved"
    ln -sfn "$work/moved/apps/abut" "$work/a link"
    run 0 x
    sed -i 's/first/elsewhere/' "$work/moved/apps/main.cpp"
    run 0 x
    expect 'it builds in its new place' says stdout elsewhere
}

test_two_first_runs_at_once() {
    make_copy
    local status=0 first second
    PATH=$tools:$PATH "$work/a link" x >"$work/stdout" 2>"$work/stderr" </dev/null &
    first=$!
    PATH=$tools:$PATH "$work/a link" x >"$work/stdout2" 2>"$work/stderr2" </dev/null &
    second=$!
    wait "$first" || status=1
    wait "$second" || status=1
    expect 'both succeed' test "$status" == 0
    expect 'the first says its line' says stdout first
    expect 'the second says its line' says stdout2 first
    expect 'only one has compiled' test "$(grep -c 'Building CXX' "$top/build/release/build.log")" == 1
}

test_missing_packages_are_installed() {
    make_copy
    printf '%s\n' libassimp-dev libopenblas-pthread-dev libgmp-dev libgtest-dev >"$work/missing"
    run 0 x
    expect 'it says what it installs' says stderr 'installing libassimp-dev libgmp-dev'
    expect 'one line' is_one_line
    expect 'no package of the tests, no second BLAS' bash -c "grep -q ' install .* libassimp-dev libgmp-dev\$' '$work/asked'"
    expect 'no recommended packages' grep -q -- --no-install-recommends "$work/asked"
}

test_no_blas_at_all() {
    make_copy
    printf '%s\n' libopenblas-serial-dev libopenblas-pthread-dev libopenblas-openmp-dev >"$work/missing"
    run 0 x
    expect 'the first choice is installed, a reference BLAS does not count' says stderr 'installing libopenblas-pthread-dev'
}

test_failed_installation_is_tried_again_with_new_lists() {
    make_copy
    echo libgmp-dev >"$work/missing"
    tool apt-get <<END
echo "\$*" >>"$work/asked"
[[ \$* != *" install "* ]] || [[ \$(grep -c ' install ' "$work/asked") -gt 1 ]]
END
    run 0 x
    expect 'the lists were renewed between' bash -c "tail -n 2 '$work/asked' | head -n 1 | grep -q ' update\$'"
}

test_impossible_installations_say_so_in_one_line() {
    make_copy
    echo libgmp-dev >"$work/missing"
    tool apt-get <<<'[[ $* == *update* ]] || { echo "E: Unable to fetch some archives"; exit 100; }'
    run 1 x
    expect 'apt-get is quoted' says stderr 'E: Unable to fetch some archives'
    expect 'the package is named' says stderr libgmp-dev
    expect 'the announcement and one line' test "$(wc -l <"$work/stderr")" == 2

    tool id <<<'echo 1000'
    tool sudo <<<'echo "sudo: a password is required"; exit 1'
    run 1 x
    expect 'sudo is quoted' says stderr 'sudo: a password is required'
}

# A path with the stand-ins and links to what else the launcher needs, so that commands can be absent.
bare_path() {
    local name
    for name in bash cat sed sort head tail tr grep wc mkdir mv touch readlink dirname find flock nproc awk env ln g++ cmake ninja; do
        [[ -e $tools/$name ]] || ln -s "$(command -v "$name")" "$tools/$name"
    done
}

run_bare() {
    PATH=$tools "$tools/bash" "$work/a link" x >"$work/stdout" 2>"$work/stderr" </dev/null
    expect 'exit status 1' test $? == 1
    expect 'one line' is_one_line
    expect 'the package is named' says stderr libgmp-dev
}

test_without_root_sudo_or_apt() {
    make_copy
    echo libgmp-dev >"$work/missing"
    bare_path
    tool id <<<'echo 1000'
    run_bare
    expect 'root is asked for' says stderr 'needs root or sudo'
    rm "$tools/apt-get"
    run_bare
    expect 'apt-get is missed' says stderr 'no apt-get'
}

test_missing_and_old_commands() {
    make_copy
    bare_path
    rm "$tools/ninja" "$tools/g++"
    tool apt-get <<<'echo "E: nothing works"; exit 100'
    PATH=$tools "$tools/bash" "$work/a link" x >"$work/stdout" 2>"$work/stderr" </dev/null
    expect 'their packages are asked for' says stderr 'installing g++ ninja-build'

    make_copy
    tool cmake <<<'echo "cmake version 3.18.4"'
    run 1 x
    expect 'it is too old' says stderr 'cmake 3.18.4 is too old, 3.25 is needed'
    expect 'one line' is_one_line
    rm "$tools/cmake"
    tool g++ <<<'echo 9'
    run 1 x
    expect 'it is too old' says stderr 'g++ 9 is too old, 12 is needed'
    expect 'one line' is_one_line
}

unset CXX
run=0
for name in $(declare -F | sed -n 's/^declare -f \(test_.*\)/\1/p'); do
    before=$failures
    "$name"
    run=$((run + 1))
    ((failures == before)) || echo "in $name"
done
((run > 0)) || failures=1
exit $((failures > 0))
