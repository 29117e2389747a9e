#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Packs a build and looks into the package: deb_test.sh CPACK BUILD_FOLDER. The package is unpacked and run, not installed.
set -u

command -v dpkg-shlibdeps >/dev/null || exit 77 # skipped: no Debian
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
    echo "failed: $1" >&2
    exit 1
}

"$1" -G DEB --config "$2/CPackConfig.cmake" -B "$folder" >"$folder/log" 2>&1 || fail "$(tail -n 5 "$folder/log")"
package=$(echo "$folder"/abut_*.deb)
dpkg -c "$package" >"$folder/list" || fail "there is no package"
for file in bin/abut libexec/abut/abut-read-mesh share/abut/scenes/vise.json share/abut/schema/scene.schema.json share/abut/verification/bar.json share/man/man1/abut.1 \
    share/abut/materials/materials.json share/bash-completion/completions/abut share/zsh/vendor-completions/_abut \
    share/fish/vendor_completions.d/abut.fish share/doc/abut/LICENSE; do
    grep -q " ./usr/$file\$" "$folder/list" || fail "usr/$file is not in the package"
done
depends=$(dpkg-deb -f "$package" Depends)
libraries="libc6 libstdc++6 libassimp5 lib3mf1"
# The reader of STEP is built, and packed, where OpenCASCADE is installed.
if [ -e "$2/apps/readers/abut-read-step" ]; then
    grep -q " ./usr/libexec/abut/abut-read-step\$" "$folder/list" || fail "the reader of STEP is not in the package"
    libraries+=" libocct-data-exchange libocct-foundation libocct-modeling-algorithms libocct-modeling-data libocct-ocaf"
fi
for library in $libraries; do
    [[ $depends == *"$library"* ]] || fail "the package does not depend on $library: $depends"
done
dpkg -x "$package" "$folder/root" || fail "it cannot be unpacked"
"$folder/root/usr/bin/abut" verify E6 >/dev/null || fail "the packed program does not find its scenes"
"$folder/root/usr/bin/abut" inspect "$folder/root/usr/share/abut/sketches/l_bracket.stl" >/dev/null || fail "the packed program does not read a mesh"
sketch="$folder/root/usr/share/abut/sketches/pin_bracket.step"
if [ -e "$folder/root/usr/libexec/abut/abut-read-step" ]; then
    "$folder/root/usr/bin/abut" inspect "$sketch" >"$folder/said" 2>&1 || fail "the packed program does not read STEP: $(cat "$folder/said")"
else
    "$folder/root/usr/bin/abut" inspect "$sketch" >"$folder/said" 2>&1 && fail "the packed program reads STEP without its reader"
    grep -q OpenCASCADE "$folder/said" || fail "the packed program does not name what reads STEP: $(cat "$folder/said")"
fi
echo "passed"
