#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Instructions of the solution (all of solve_adaptively: search, grids, assembly, factors, contact, stresses) with every effect
# off, in two builds: that of the code as it is, and one without an effect's code (the commit before it came, built alike).
# valgrind's counts are repeatable; the difference is to be below 0.1 %. The plan's text and the checks afterwards are not in it.
#   instructions_off.sh ABUT ABUT_WITHOUT [SCENE]
set -e
with=$1 without=$2 scene=$3
[ -x "$with" ] && [ -x "$without" ] || { echo "usage: instructions_off.sh ABUT ABUT_WITHOUT [SCENE]" >&2; exit 2; }
command -v valgrind > /dev/null || { echo "valgrind is missing: apt-get install valgrind" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [ -z "$scene" ]; then
  scene=$folder/plate.json
  cat > "$scene" <<'SCENE'
{"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [{"name": "plate", "material": "m", "geometry": {"difference": [
   {"rectangle": {"min": [0, 0], "max": [4, 2]}}, {"circle": {"center": [2.1, 0.9], "radius": 0.4}}]}}],
 "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}], "loads": [{"on": "plate/top", "pressure": 10}],
 "accuracy": {"cell_size": 0.1}, "output": {"formats": ["json"]}}
SCENE
fi
# counts of one run: OpenBLAS on one thread, and told its kernels, so that it does not look for them anew
count() {
  rm -rf "$folder/result"
  OPENBLAS_NUM_THREADS=1 OPENBLAS_CORETYPE=Haswell valgrind --tool=callgrind --toggle-collect='*solve_adaptively*' --callgrind-out-file="$folder/out" \
    "$1" analyze "$scene" -o "$folder/result" --quiet --threads 1 2>&1 | sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
  [ -f "$folder/result/result.json" ] || { echo "$1 did not solve the scene" >&2; exit 1; }
}
a=$(count "$with") b=$(count "$without") c=$(count "$with")
awk -v a="$a" -v b="$b" -v c="$c" 'BEGIN {
  printf "instructions: %.0f with the code, %.0f without, %.0f with it again\n", a, b, c
  d = (a - b) / b; if (d < 0) d = -d
  printf "difference %.4f %%, repeatable to %.4f %%\n", 100 * (a - b) / b, 100 * (c - a) / a
  exit !(d < 1e-3) }'
