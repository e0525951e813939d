# shellcheck shell=sh
# A Slurm cluster of two nodes on the loopback interface, in the folder $cluster; to be sourced. Needs slurm-wlm and munge.
# The test that sources it sets the folder.
# shellcheck disable=SC2154


# has_slurm: whether the programs are there.
has_slurm() {
    for program in munged slurmctld slurmd sbatch squeue scontrol; do
        PATH=$PATH:/usr/sbin:/sbin command -v "$program" >/dev/null 2>&1 || return 1
    done
}

# free_ports COUNT: prints ports that nobody listens on, one after the other.
free_ports() {
    port=$((20000 + $$ % 20000))
    count=$1
    while [ "$count" -gt 0 ]; do
        port=$((port + 1))
        hexadecimal=$(printf ':%04X ' "$port")
        grep -q "$hexadecimal" /proc/net/tcp || { echo "$port"; count=$((count - 1)); }
    done
}

# start_node NODE: starts the daemon of a node.
start_node() {
    slurmd -N "$1" -f "$cluster/slurm.conf" -D >"$cluster/$1.out" 2>&1 &
    echo $! >"$cluster/$1.started"
}

# start_cluster: starts all daemons, and waits until both nodes are idle.
start_cluster() {
    PATH=$PATH:/usr/sbin:/sbin
    mkdir -p "$cluster/state" "$cluster/spool-n1" "$cluster/spool-n2"
    chmod 755 "$cluster"
    head -c 1024 /dev/urandom >"$cluster/munge.key"
    chmod 600 "$cluster/munge.key"
    munged --force --socket="$cluster/munge.socket" --key-file="$cluster/munge.key" --pid-file="$cluster/munged.pid" \
        --log-file="$cluster/munged.log" --seed-file="$cluster/munged.seed" >"$cluster/munged.out" 2>&1 || return 1
    # shellcheck disable=SC2046
    set -- $(free_ports 3)
    cat >"$cluster/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$1
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.socket
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0
SlurmdParameters=config_overrides
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool-%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd-%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd-%n.log
SlurmdTimeout=3
JobRequeue=1
ReturnToService=2
MpiDefault=none
KillWait=1
NodeName=n1 NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=$2 CPUs=2
NodeName=n2 NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=$3 CPUs=2
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
CONF
    export SLURM_CONF="$cluster/slurm.conf"
    slurmctld -f "$cluster/slurm.conf" -D >"$cluster/slurmctld.out" 2>&1 &
    echo $! >"$cluster/slurmctld.started"
    start_node n1
    start_node n2
    waited=0
    until [ "$(sinfo -h -N -t idle 2>/dev/null | wc -l)" -eq 2 ]; do
        waited=$((waited + 1))
        [ "$waited" -lt 150 ] || return 1
        sleep 0.2
    done
}

# job_processes NODE: prints the processes of the jobs on a node.
job_processes() {
    for process in /proc/[0-9]*; do
        { tr '\0' '\n' <"$process/environ"; } 2>/dev/null | grep -q -x -F "SLURM_CONF=$cluster/slurm.conf" || continue
        { tr '\0' '\n' <"$process/environ"; } 2>/dev/null | grep -q -x -F "SLURMD_NODENAME=$1" || continue
        echo "${process#/proc/}"
    done
}

# kill_node NODE: kills the daemon of a node and all that runs on it, as a power cut would: first what could still tell the
# controller how a job ended.
kill_node() {
    kill -9 "$(cat "$cluster/$1.started")" 2>/dev/null || true
    jobs_there=$(job_processes "$1")
    for process in $jobs_there; do
        parent=$(sed -n 's/^PPid:[[:space:]]*//p' "/proc/$process/status" 2>/dev/null || true)
        { tr '\0' ' ' <"/proc/$parent/cmdline"; } 2>/dev/null | grep -q slurmstepd && kill -9 "$parent" 2>/dev/null
    done
    for process in $jobs_there; do kill -9 "$process" 2>/dev/null || true; done
}

# end_requeue_delay: lets tasks that were queued again start now; Slurm would wait two minutes.
end_requeue_delay() {
    for job in $(squeue -h -r -t pending -o %A 2>/dev/null); do
        scontrol update JobId="$job" StartTime=now 2>/dev/null || true
    done
}

# stop_cluster: ends all daemons that start_cluster started, and their jobs.
stop_cluster() {
    scancel -u "$(id -un)" 2>/dev/null || true
    for node in n1 n2; do kill_node "$node"; done
    kill -9 "$(cat "$cluster/slurmctld.started")" "$(cat "$cluster/munged.pid")" 2>/dev/null || true
}
