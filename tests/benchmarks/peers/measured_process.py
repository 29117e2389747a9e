# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a program to its end and says what it took."""
import dataclasses
import os
import subprocess
import threading
import time

# One thread each, whichever library computes. A Python program leaves nothing in the source folder; the compiled files of
# its libraries are read as ever (with another folder for them GetFEM took 0.3 s longer to start).
ENVIRONMENT = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "CCX_NPROC_EQUATION_SOLVER")}
ENVIRONMENT["PYTHONDONTWRITEBYTECODE"] = "1"


@dataclasses.dataclass
class Usage:
    wall: float = 0.0  # seconds
    cpu: float = 0.0  # seconds, user and system
    memory: float = 0.0  # MiB, largest resident set

    def __add__(self, other):
        return Usage(self.wall + other.wall, self.cpu + other.cpu, max(self.memory, other.memory))


def run(command, folder, time_limit=900):
    """Usage and output (both streams). Raises RuntimeError where the program fails or takes longer than time_limit seconds."""
    log_path = os.path.join(folder, os.path.basename(command[0]) + ".log")
    with open(log_path, "w") as log:
        begin = time.perf_counter()
        process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=subprocess.STDOUT, env={**os.environ, **ENVIRONMENT})
        status, resources = wait(process, begin + time_limit)
        wall = time.perf_counter() - begin
    with open(log_path, errors="replace") as log:
        output = log.read()
    if status != 0:
        raise RuntimeError(f"{' '.join(command)}: status {status}: {output[-300:].strip()}")
    return Usage(wall, resources.ru_utime + resources.ru_stime, resources.ru_maxrss / 1024), output


def wait(process, deadline):
    """Exit status and resources; kills the process at the deadline."""
    timer = threading.Timer(deadline - time.perf_counter(), process.kill)
    timer.start()
    _, status, resources = os.wait4(process.pid, 0)
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, resources
