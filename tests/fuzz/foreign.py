#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged files of formats that other libraries read, thrown at the whole program: foreign.py ABUT FOUND SECONDS SEED FILE...

Takes FILEs in turn, changes some bytes, numbers or lines, and runs `abut inspect` on what results. A run must end with status 0,
or with status 2 and sentences on standard error that name the file, in less than the reader's own limits; anything else is kept in
the folder FOUND and told. Ends with status 1 if there was any.
"""
import collections
import os
import random
import re
import subprocess
import sys
import time

LONGEST = 300  # seconds, above the limits of any small file
NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?")
ODD_NUMBERS = [b"0", b"-1", b"1e308", b"-1e-308", b"nan", b"4294967295", b"99999999999", b"1e30", b"3", b"#1", b"$", b"*"]


def mutated(data, pick):
    data = bytearray(data)
    for _ in range(pick.choice([1, 1, 2, 5, 20])):
        at = pick.randrange(len(data)) if data else 0
        way = pick.randrange(7)
        if way == 0:
            data[at : at + 1] = bytes([pick.randrange(256)])
        elif way == 1:
            del data[at : at + pick.choice([1, 4, 100, 1000])]
        elif way == 2:
            part = data[at : at + pick.choice([1, 10, 200])]
            to = pick.randrange(len(data) + 1)
            data[to:to] = part
        elif way == 3:
            number = NUMBER.search(data, at)
            if number:
                data[number.start() : number.end()] = pick.choice(ODD_NUMBERS)
        elif way == 4:
            first, second = NUMBER.search(data, at), NUMBER.search(data, pick.randrange(len(data) or 1))
            if first and second:
                data[first.start() : first.end()] = bytes(second.group())
        elif way == 5:
            begin, end = data.rfind(b"\n", 0, at) + 1, data.find(b"\n", at)
            del data[begin : end + 1 if end >= 0 else len(data)]
        else:
            data[at:] = b"" if pick.randrange(8) == 0 else data[at:]
    return bytes(data)


def fault_of(run, seconds, path):
    errors = run.stderr.decode(errors="replace").splitlines()
    if seconds > LONGEST:
        return "too long"
    if run.returncode not in (0, 2):
        return "status %d: %s" % (run.returncode, errors[:1])
    if run.returncode == 2 and not errors:
        return "refused without a word"
    strange = [line for line in errors if not line.startswith("abut: ")]
    if strange:
        return "not a sentence: " + strange[0][:200]
    if run.returncode == 2 and not any(path in line for line in errors):
        return "names no file: " + errors[0][:200]
    return ""


def ending_of(run):
    """What became of a file, in a few words."""
    if run.returncode == 0:
        return "read"
    text = run.stderr.decode(errors="replace")
    for words in ("broke down", "comes to no end", "more memory", "answered nonsense", "cannot read it", "said nothing", "damaged"):
        if words in text:
            return words
    return "refused"


def main():
    program, found, seconds, seed, files = sys.argv[1], sys.argv[2], float(sys.argv[3]), int(sys.argv[4]), sys.argv[5:]
    os.makedirs(found, exist_ok=True)
    pick, begin, n_faults, longest = random.Random(seed), time.monotonic(), 0, 0.0
    counts = collections.Counter()
    while time.monotonic() - begin < seconds:
        file = pick.choice(files)
        with open(file, "rb") as source:
            data = mutated(source.read(), pick)
        path = os.path.join(found, "trial-%d%s" % (seed, os.path.splitext(file)[1]))
        with open(path, "wb") as trial:
            trial.write(data)
        start = time.monotonic()
        run = subprocess.run([program, "inspect", path], capture_output=True, check=False)
        took = time.monotonic() - start
        longest = max(longest, took)
        counts[ending_of(run)] += 1
        fault = fault_of(run, took, path)
        if fault:
            n_faults += 1
            kept = os.path.join(found, "fault-%d-%d%s" % (seed, sum(counts.values()), os.path.splitext(file)[1]))
            os.replace(path, kept)
            print(kept, fault, flush=True)
    print("%d files, %d faults, the longest took %.1f s; %s" % (sum(counts.values()), n_faults, longest, dict(counts.most_common())))
    return 1 if n_faults else 0


if __name__ == "__main__":
    sys.exit(main())
