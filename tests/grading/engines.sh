#!/usr/bin/env bash
# A class on several machines, by the scripts that `course grade --on` writes: GNU parallel over ssh and Slurm really
# run, on two machines each, of which one is lost midway. The marks must be those of one run over the class, and nothing
# may be left. Run by .ci/run, which sets COURSE_ROOT and COURSE_BUILD, as root; ends with 77 where it cannot be done.
# shellcheck disable=SC2317  # wait_for calls functions by their names
set -eu
skip() { echo "skipped: $1"; exit 77; }
[ "$(id -u)" = 0 ] || skip "only root can start these daemons"
for tool in parallel ssh sshd ssh-keygen munged slurmctld slurmd sbatch unshare; do
    command -v $tool >/dev/null || skip "there is no $tool here"
done

# All of it happens in namespaces, so that whatever goes wrong leaves no process and no mount. The network is the
# machine's, because by names in it graders on one machine share the uids of boxes.
if [ -z "${COURSE_ENGINES:-}" ]; then
    place=$(mktemp -d)
    trap 'rm -rf "$place"' EXIT
    COURSE_ENGINES=$place unshare --mount --pid --fork --kill-child --mount-proc bash "$0"
    exit
fi
place=$COURSE_ENGINES
trap 'exit 130' INT TERM
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "$0")/../program/scratch/copy.sh"
course=$COURSE_ROOT/course
chmod 755 "$place"  # boxes and munged have uids of their own
mkdir "$place"/{tmp,log,ssh,slurm}
export TMPDIR=$place/tmp
# Neither this machine's settings nor marks that were kept before have a part in it.
mount -t tmpfs none /run
mkdir /run/sshd
mount -t tmpfs none /etc/ssh/ssh_config.d
mkdir -p "$COURSE_ROOT/.course/grades"
mount -t tmpfs none "$COURSE_ROOT/.course/grades"
port=$((20000 + RANDOM % 10000))  # and those that follow

# ------------------------------------------------------------------------------------------- machines

# start NAME COMMAND...: a daemon; what it says goes to log/NAME.
declare -A started
start() {
    local name=$1
    shift
    "$@" >"$place/log/$name" 2>&1 </dev/null &
    started[$name]=$!
}

# A machine is a namespace of processes: when its first one ends, all end, as if the power had failed.
start_machine() { start "$1" unshare --pid --fork --kill-child --mount-proc "${@:2}"; }

stop() {  # stop SIGNAL NAME...
    local name
    for name in "${@:2}"; do
        kill "-$1" "${started[$name]}"
        wait "${started[$name]}" 2>/dev/null || true
    done
}

# wait_for SECONDS WHAT COMMAND...: until the command succeeds.
wait_for() {
    local end=$((SECONDS + $1)) what=$2
    shift 2
    until "$@" >/dev/null 2>&1; do
        [ $SECONDS -lt $end ] || { fail "$what" "$(tail -n 20 "$place"/log/*)"; finish; }
        sleep 0.1
    done
}

# ------------------------------------------------------------------------------------------ the class

class=$place/"a class"
mkdir -p "$class"
cd "$class" || exit
hand_in() {  # hand_in NAME FILE...: chapter 1 with these files solved
    local to="submissions/$1/chapters/01_ray_casting" file
    mkdir -p "$to"
    cp "$COURSE_ROOT"/chapters/01_ray_casting/*.cpp "$to"
    for file in "${@:2}"; do cp "$COURSE_ROOT/solutions/01_ray_casting/$file.cpp" "$to"; done
}
# Of three parts, the first two have one that takes long, and then another.
hand_in -ada camera plane raycast
hand_in "ben o'neill" camera
# shellcheck disable=SC2016  # names, and nothing to be expanded
hand_in 'cleo "$HOME" *'
hand_in dan camera plane raycast
hand_in eve plane
# shellcheck disable=SC2016
hand_in 'fay \ `x`'

# Boxes as good as this machine has them.
for level in bwrap user none; do
    ask=(grade submissions/* --chapter 01 --seed 5 --isolation "$level")
    "$course" "${ask[@]}" -o one.csv 2>said && break
    grep -q "is not possible here" said || break
done
[ -s one.csv ] || { fail "the class is marked by one run" "$(cat said)"; finish; }
rm said
marks() { sed -E 's/,[^,]*,[^,]*(,[^,]*,[^,]*),[^,]*(,[^,]*)$/\1\2/' "$1"; }  # without what was measured
begun() { [ -n "$(find "$COURSE_ROOT/.course/grades" -type f)" ]; }

# mark_on ENGINE: by its script; when both machines work and the first submission is marked, the second one is lost.
mark_on() {
    local engine=$1 script="mark on $1.sh" running
    find "$COURSE_ROOT/.course/grades" -mindepth 1 -delete
    "$course" "${ask[@]}" --on "$engine" --parts 3 -o "$script" || { fail "$engine: the script"; return; }
    # Names may have in quotes what looks like an expansion.
    ! command -v shellcheck >/dev/null || shellcheck -e SC2016 "$script" || fail "$engine: shellcheck has nothing to say"
    sh "$script" >"$place/log/$engine" 2>&1 </dev/null &
    running=$!
    wait_for 120 "$engine: the second machine works" "second_works_on_$engine"
    wait_for 120 "$engine: the first submission is marked" begun
    stop KILL "second_$engine"
    wait $running || fail "$engine: the script ends well" "$(cat "$place/log/$engine")"
    rm "$script"
    [ "$(marks marks.csv)" = "$(marks one.csv)" ] || fail "$engine: the marks of one run" "$(diff one.csv marks.csv)"
    rm -f marks.csv
    [ "$(ls)" = "$(printf '%s\n' "${here[@]}")" ] || fail "$engine: nothing else is left in the class" "$(ls)"
}

# --------------------------------------------------------------------------------- GNU parallel over ssh

ssh-keygen -q -t ed25519 -N '' -f "$place/ssh/id"
cat >/etc/ssh/ssh_config.d/course.conf <<CONF
Host first second
    IdentityFile $place/ssh/id
    UserKnownHostsFile $place/ssh/known
    StrictHostKeyChecking accept-new
Host first
    HostName 127.0.0.1
    Port $port
Host second
    HostName 127.0.0.2
    Port $((port + 1))
CONF
sshd_machine() {  # sshd_machine NAME ADDRESS PORT
    ssh-keygen -q -t ed25519 -N '' -f "$place/ssh/host_$1"
    cat >"$place/ssh/$1" <<CONF
ListenAddress $2
Port $3
HostKey $place/ssh/host_$1
PidFile none
AuthorizedKeysFile $place/ssh/id.pub
PasswordAuthentication no
KbdInteractiveAuthentication no
PermitRootLogin prohibit-password
UsePAM no
StrictModes no
SetEnv TMPDIR=$TMPDIR
ForceCommand echo >>"$place/ssh/parts_$1"; eval "\$SSH_ORIGINAL_COMMAND"
CONF
    start_machine "$1_parallel" "$(command -v sshd)" -D -e -f "$place/ssh/$1"
    wait_for 20 "sshd of the $1 machine" ssh -o BatchMode=yes "$1" true
    rm "$place/ssh/parts_$1"
}
sshd_machine first 127.0.0.1 $port
sshd_machine second 127.0.0.2 $((port + 1))
second_works_on_parallel() { [ -s "$place/ssh/parts_second" ]; }

printf '%s\n' '# two machines, a part at a time' 1/first 1/second >hosts
here=(hosts one.csv submissions)
mark_on parallel
[ "$(cat "$place"/ssh/parts_* | wc -l)" = 4 ] || fail "parallel: one of three parts was begun twice"
rm hosts
stop KILL first_parallel

# ------------------------------------------------------------------------------------------------ Slurm

install -d -o munge -g munge -m 711 "$place/munge"
dd if=/dev/urandom of="$place/munge/key" bs=128 count=1 status=none
chown munge "$place/munge/key"
chmod 400 "$place/munge/key"
start munge setpriv --reuid=munge --regid=munge --clear-groups munged --foreground --key-file="$place/munge/key" \
    --socket="$place/munge/socket" --pid-file="$place/munge/pid" --log-file="$place/munge/log" \
    --seed-file="$place/munge/seed"
export SLURM_CONF=$place/slurm/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=class
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$((port + 2))
SlurmUser=root
AuthInfo=socket=$place/munge/socket,cred_expire=5
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation=$place/slurm/state
SlurmdSpoolDir=$place/slurm/%n
SlurmctldPidFile=$place/slurm/controller.pid
SlurmdPidFile=$place/slurm/%n.pid
ProctrackType=proctrack/linuxproc
ReturnToService=2
SlurmdTimeout=10
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=2,bf_interval=5
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
NodeName=first,second NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=[$((port + 3))-$((port + 4))] CPUs=1 RealMemory=4000
PartitionName=all Nodes=ALL Default=YES
CONF
mkdir "$place/slurm/state"
wait_for 20 "munge" [ -S "$place/munge/socket" ]
start slurmctld slurmctld -D
start_machine first_slurm slurmd -D -N first
start_machine second_slurm slurmd -D -N second
both_idle() { [ "$(sinfo -h -N -t idle | wc -l)" = 2 ]; }
wait_for 20 "both machines of Slurm" both_idle
second_works_on_slurm() { [ -n "$(squeue -h -t running -w second)" ]; }
here=(one.csv submissions)
mark_on slurm
[ "$(grep -c Requeuing "$place/log/slurmctld")" = 1 ] || fail "slurm: one part was begun twice"
stop KILL first_slurm
stop TERM slurmctld munge

# -------------------------------------------------------------------------------------- what is left

for process in /proc/[0-9]*; do
    [ "$process" = /proc/$$ ] || fail "no process is left" "$(tr '\0' ' ' <"$process/cmdline")"
done
[ -z "$(ls -A "$TMPDIR")" ] || fail "no file is left" "$(find "$TMPDIR" | head)"
finish
