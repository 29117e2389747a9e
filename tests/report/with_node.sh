#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# with_node.sh SOURCES TEST ARGUMENTS...: runs TEST by node where that and the packages of src/report/web are there; else the test is skipped.
set -u
sources=$1
if ! command -v node >/dev/null; then
    echo "skipped: node is not installed"
    exit 77
fi
if [[ ! -d $sources/src/report/web/node_modules ]]; then
    echo "skipped: the packages are not installed (npm ci in src/report/web)"
    exit 77
fi
exec node "$2" "$sources" "${@:3}"
