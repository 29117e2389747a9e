#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a batch as a job array of a real Slurm of one node, started here and ended again: slurm_test.sh ABUT SOURCES.
# Skipped (status 77) where Slurm, munge or the rights to run them are missing.
set -u

abut=$1
sources=$2
tasks=3
here=$(mktemp -d)
services=()

skip() {
    echo "skipped: $1"
    exit 77
}

fail() {
    echo "failed: $1" >&2
    tail -n 5 "$here"/*.log >&2
    exit 1
}

# shellcheck disable=SC2317 # called by the trap
end_services() {
    for process in "${services[@]}"; do kill "$process" 2>/dev/null; done
    wait 2>/dev/null
    rm -rf "$here"
}
trap end_services EXIT

wait_for() { # wait_for SECONDS COMMAND...: until the command succeeds
    local end=$((SECONDS + $1))
    shift
    until "$@" >/dev/null 2>&1; do
        ((SECONDS < end)) || return 1
        sleep 0.2
    done
}

for program in munged slurmctld slurmd sbatch squeue scontrol; do
    PATH=$PATH:/usr/sbin command -v $program >/dev/null || skip "$program is not installed (apt install slurm-wlm munge)"
done
PATH=$PATH:/usr/sbin
[[ $(id -u) == 0 ]] || skip "the services of Slurm are started as root"

start_munge() {
    (umask 077 && head -c 1024 /dev/urandom >"$here/munge.key")
    munged --foreground --force --key-file="$here/munge.key" --socket="$here/munge.socket" --pid-file="$here/munge.pid" \
        --log-file="$here/munge.log" --seed-file="$here/munge.seed" >"$here/munged.log" 2>&1 &
    services+=($!)
    wait_for 10 test -S "$here/munge.socket" || fail "munge does not start"
}

start_slurm() {
    local name port
    name=$(hostname -s)
    port=$((20000 + $$ % 20000))
    mkdir -p "$here/state" "$here/spool"
    cat >"$here/slurm.conf" <<CONF
ClusterName=abut
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$here/munge.socket
CredType=cred/munge
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
    export SLURM_CONF=$here/slurm.conf
    slurmctld -D -c >"$here/slurmctld.log" 2>&1 &
    services+=($!)
    slurmd -D >"$here/slurmd.log" 2>&1 &
    services+=($!)
    wait_for 30 node_is_idle || skip "Slurm's node does not come up here: $(tail -n 1 "$here/slurmd.log")"
}

node_is_idle() { scontrol show node | grep -q 'State=IDLE'; }
queue_is_empty() { [[ -z $(squeue -h) ]]; }

# What users are told to submit (README): every task is a shard by itself.
submit() { # submit OUT
    cat >"$here/job.sh" <<JOB
#!/bin/bash
#SBATCH --array=1-$tasks --cpus-per-task=1 --output=$here/task_%a.log
"$abut" batch "$here/sketches/jobs.csv" --template "$here/sketches/template.json" -o "$1"
JOB
    sbatch "$here/job.sh" >"$here/sbatch.log" 2>&1 || fail "sbatch refuses the job"
    wait_for 180 queue_is_empty || fail "the array does not end"
}

python3 "$sources/tests/batch/sketches.py" "$here/sketches" --count 12 --two-parts
start_munge
start_slurm
submit "$here/out"
for ((task = 1; task <= tasks; ++task)); do
    grep -q "shard $task of $tasks" "$here/task_$task.log" || fail "task $task is no shard of its own"
    grep -q "4 done now" "$here/task_$task.log" || fail "task $task did not do its third"
done
"$abut" merge "$here/out" --quiet || fail "the shards are not complete"
"$abut" batch "$here/sketches/jobs.csv" --template "$here/sketches/template.json" -o "$here/alone" --quiet || fail "the batch alone fails"
python3 "$sources/tests/batch/same_answers.py" "$here/out" "$here/alone" || fail "the array's answers differ from those of one run"
echo "passed: $tasks tasks of a Slurm array, merged, are the same as one run"
