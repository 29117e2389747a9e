#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Are the answers of two batches the same to the bit, but for times? same_answers.py OUT OUT; status 1 and a line where not."""
import csv
import io
import json
import pathlib
import sys

TIMES = {"seconds", "timing", "sizes"}  # files that hold times differ in length, too


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(item) for key, item in value.items() if key not in TIMES}
    return [without_times(item) for item in value] if isinstance(value, list) else value


def answer(path):
    """What is to be the same: pages hold times in their text and pictures, and are left out."""
    text = path.read_text()
    if path.suffix == ".json":
        return json.dumps(without_times(json.loads(text)))  # numbers as their shortest texts: equal for equal bits only
    if path.name == "summary.csv":
        return [row[:-1] for row in csv.reader(io.StringIO(text))]
    return text


def answers(out):
    files = (path for path in out.rglob("*") if path.is_file() and path.suffix != ".html")
    return {str(path.relative_to(out)): answer(path) for path in files}


def main():
    first, second = (answers(pathlib.Path(word)) for word in sys.argv[1:3])
    differing = sorted(name for name in first.keys() | second.keys() if first.get(name) != second.get(name))
    for name in differing[:10]:
        print(name, "differs" if name in first and name in second else "is in one of them only")
    print(f"{len(first)} files, {len(differing)} differ")
    return 1 if differing or not first else 0


if __name__ == "__main__":
    sys.exit(main())
