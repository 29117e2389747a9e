#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs a build into a prefix of its own and runs abut from there: install_test.sh CMAKE BUILD_FOLDER. The sources must not be needed: what
# is looked for is found below the prefix, or this fails.
set -u

prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

fail() {
    echo "failed: $1" >&2
    exit 1
}

"$1" --install "$2" --prefix "$prefix/usr" >"$prefix/log" 2>&1 || fail "$(tail -n 3 "$prefix/log")"
mv "$prefix/usr" "$prefix/moved" # nothing may depend on the prefix that was named
abut=$prefix/moved/bin/abut
share=$prefix/moved/share
cd "$prefix" || exit 1

for file in scenes/vise.json sketches/pin_bracket_r14.dxf materials/materials.json batch/loads.csv schema/scene.schema.json verification/bar.json README.md; do
    [[ -f $share/abut/$file ]] || fail "share/abut/$file is not installed"
done
"$abut" --version | grep -q '^abut [0-9]' || fail "it does not run"
"$abut" verify E6 >/dev/null || fail "verify does not find its scenes"
"$abut" inspect "$share/abut/sketches/l_bracket.stl" >/dev/null || fail "it does not read a mesh"
reader=$prefix/moved/libexec/abut/abut-read-mesh
mv "$reader" "$reader.moved"
printf '#!/bin/sh\nexit 1\n' >"$reader" && chmod +x "$reader"
"$abut" inspect "$share/abut/sketches/l_bracket.stl" >/dev/null 2>&1 && fail "it reads a mesh by a reader from elsewhere"
mv "$reader.moved" "$reader"
"$abut" help loads.force | grep -q '^scene.loads\[\].force' || fail "help does not find the schemas"
grep -q '^\.TH ABUT 1' "$share/man/man1/abut.1" || fail "the man page is not installed"
echo '{' >"$share/abut/verification/bar.json"
"$abut" verify E6 >/dev/null 2>&1 && fail "verify reads scenes from elsewhere"
"$abut" batch "$share/abut/batch/loads.csv" --template "$share/abut/batch/pin_pushed_down.json" -o out --quiet || fail "the example of batch does not run"
[[ -f out/jobs/full/report.html ]] || fail "the example of batch writes no report"

# What bash would offer after these words.
offered() {
    bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _abut; printf "%s\n" "${COMPREPLY[@]}"' bash \
        "$share/bash-completion/completions/abut" "$abut" "$@"
}
for command in analyze contacts inspect init study verify batch merge help; do
    offered "" | grep -qx "$command" || fail "completion does not offer $command"
    for option in $("$abut" "$command" --help | sed -n 's/^  \(-[a-z-]*\).*/\1/p'); do
        offered "$command" "${option:0:2}" | grep -qx -- "$option" || fail "completion does not offer $option of $command"
    done
done
offered help loads.f | grep -qx loads.force || fail "completion does not offer loads.force"
offered help ver | grep -qx verify || fail "completion does not offer verify to help"
offered analyze --accuracy d | grep -qx draft || fail "completion does not offer draft"
[[ $(offered batch --sh) == --shard ]] || fail "completion offers more than fits"
echo "passed"
