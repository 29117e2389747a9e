#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs a build's library into a prefix of its own, moves it, and builds and runs the example against it:
# library_test.sh CMAKE BUILD_FOLDER SOURCE_FOLDER. Neither sources nor build folder may be needed for that.
set -u

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
    echo "failed: $1" >&2
    exit 1
}

"$1" --install "$2" --prefix "$folder/usr" --component development >"$folder/log" 2>&1 || fail "$(tail -n 3 "$folder/log")"
mv "$folder/usr" "$folder/moved" # nothing may depend on the prefix that was named
[[ -x $folder/moved/bin/abut ]] && fail "the program is part of the library"
grep -rqF -e "$2" -e "$3/" "$folder/moved" --include='*.cmake' && fail "the package names the folder that it was built in"
cp -r "$3/apps/library/example" "$folder/example"
"$1" -S "$folder/example" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$folder/moved" >"$folder/log" 2>&1 ||
    fail "$(tail -n 20 "$folder/log")"
"$1" --build "$folder/build" >"$folder/log" 2>&1 || fail "$(tail -n 20 "$folder/log")"
"$folder/build/change_a_load" "$3/data/scenes/pin_bracket_cases.json" pull >"$folder/told" || fail "the example: $(tail -n 3 "$folder/told")"
grep -q '^pull times 1: ok' "$folder/told" || fail "the example does not answer: $(cat "$folder/told")"
[[ $(grep -c '  bracket - pin: [1-9]' "$folder/told") == 5 ]] || fail "not every factor has a pressure: $(cat "$folder/told")"
"$folder/build/change_a_load" "$3/data/scenes/pin_bracket_cases.json" pul 2>"$folder/told" >/dev/null && fail "a load that is not there is no error"
grep -q "did you mean 'pull'" "$folder/told" || fail "the error says nothing: $(cat "$folder/told")"
echo "passed"
