#!/usr/bin/env bash
# Sets up a one-node Slurm (Debian: slurm-wlm, munge) with files of its own, submits the job array of docs/sweeps.md, merges
# the shards and compares with the sweep of one process. Skipped (exit code 77) without Slurm or when not root.
#   tests/cluster/slurm_test.sh FASTER_SIM SOURCE_FOLDER
set -euo pipefail

readonly skipped=77
readonly faster_sim="$1"
readonly source_folder="$2"

for program in munged slurmctld slurmd sbatch sinfo scontrol; do
    if ! PATH="$PATH:/usr/sbin" command -v "$program" >/dev/null; then
        echo "skipped: $program is not installed (Debian: slurm-wlm, munge)"
        exit "$skipped"
    fi
done
if ((EUID != 0)); then
    echo "skipped: not root"
    exit "$skipped"
fi

export PATH="$PATH:/usr/sbin"
folder="$(mktemp -d /tmp/faster-slurm-XXXXXX)"
chmod 755 "$folder"
daemons=()

finish() {
    local code=$?
    if ((code != 0)); then
        tail -n 20 "$folder"/*.log "$folder"/slurm-*.out 2>/dev/null || true
    fi
    for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
        kill "${daemons[i]}" 2>/dev/null || true
        wait "${daemons[i]}" 2>/dev/null || true
    done
    rm -rf "$folder"
}
trap finish EXIT

start() {  # NAME COMMAND...: in the background, with a log
    local log="$folder/$1.log"
    shift
    "$@" >"$log" 2>&1 &
    daemons+=($!)
}

wait_until() {  # SECONDS COMMAND...
    local left=$(($1 * 5))
    shift
    until "$@" >/dev/null 2>&1; do
        if ((left-- == 0)); then
            echo "gave up waiting for: $*" >&2
            return 1
        fi
        sleep 0.2
    done
}

# munged wants its folders to belong to the one it runs as, and to nobody else.
start_munge() {
    mkdir -m 755 "$folder/munge"
    dd if=/dev/urandom of="$folder/munge/key" bs=1 count=1024 status=none
    chmod 400 "$folder/munge/key"
    start munged munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
        --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" --log-file="$folder/munge/log"
    wait_until 20 test -S "$folder/munge/socket"
}

write_configuration() {
    local host
    host="$(hostname -s)"
    mkdir "$folder/state" "$folder/spool"
    cat >"$folder/slurm.conf" <<END
ClusterName=faster
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$((20000 + RANDOM % 5000))
SlurmdPort=$((25000 + RANDOM % 5000))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
    echo "CgroupPlugin=cgroup/v1" >"$folder/cgroup.conf"
    export SLURM_CONF="$folder/slurm.conf"
}

node_is_idle() { [[ "$(sinfo --noheader --format=%T)" == idle ]]; }

start_slurm() {
    start slurmctld slurmctld -D -f "$SLURM_CONF"
    start slurmd slurmd -D -f "$SLURM_CONF"
    wait_until 60 node_is_idle
}

write_sweep() {
    cat >"$folder/sweep.yaml" <<END
format: faster-sweep
version: 1
set: {workload.samples.count: 3, accelerator.window: 40}
dimensions:
  - {key: workload.object, values: [banana, tomato_soup_can]}
  - {key: accelerator.fifos.fragment_depth.depth, values: [1, 2, 8]}
  - {key: accelerator.raster_cores, values: [1, 2]}
END
}

start_munge
write_configuration
start_slurm
write_sweep
cd "$folder"
FASTER_SIM="$faster_sim" sbatch --wait --array=1-3 "$source_folder/scripts/sweep.sbatch" sweep.yaml shards
cat slurm-*.out
"$faster_sim" sweep merge shards/* --out merged
"$faster_sim" sweep sweep.yaml --out whole
for file in results.csv index.html sweep.json; do
    cmp "merged/$file" "whole/$file"
done
echo "three tasks of a Slurm job array found what one process finds: $(wc -l <merged/results.csv) lines"
