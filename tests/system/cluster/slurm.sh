#!/usr/bin/env bash
# A study on a real Slurm of three nodes on this machine: an array of nine tasks, one node killed
# while it runs, and the merged results are those of one process with one thread.
# Needs slurmctld, slurmd and slurm-client of Debian; exit code 77 where they are missing. Without
# munge: authentication is switched off, which is for tests alone.
# usage: slurm.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
source=$2
PATH=$PATH:/usr/sbin
plugins=$(find /usr/lib -name auth_none.so -printf '%h\n' 2> /dev/null | head -1)
for program in slurmctld slurmd sbatch squeue scontrol; do
  command -v "$program" > /dev/null && continue
  echo "skipped: $program is missing; ./dev test-cluster installs it"
  exit 77
done
if [ "$(id -u)" -ne 0 ] || [ -z "$plugins" ]; then
  echo "skipped: slurmd needs root and the plug-in auth_none"
  exit 77
fi

folder=$(mktemp -d /tmp/gurney_slurm_XXXXXX) || exit 1
cd "$folder" || exit 1
failures=0
fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}
stop() {
  pkill -9 -f "slurmd -N gurney[123] -f $folder/slurm.conf"
  pkill -9 -f "slurmctld -f $folder/slurm.conf"
  [ "$failures" -eq 0 ] && rm -rf "$folder"
}
trap stop EXIT

cat > slurm.conf <<CONF
ClusterName=gurney_test
SlurmctldHost=$(hostname -s)
SlurmUser=root
SlurmctldPort=28617
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
SlurmctldTimeout=10
SlurmdTimeout=10
KillWait=5
MaxJobCount=100
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool.%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.%n.log
NodeName=gurney[1-3] NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=[28611-28613] CPUs=1
PartitionName=test Nodes=ALL Default=YES MaxTime=60 State=UP
CONF
mkdir state spool.gurney1 spool.gurney2 spool.gurney3
export SLURM_CONF=$folder/slurm.conf
skip() {
  echo "skipped: $1"
  tail -n 3 slurmctld.log slurmd.*
  exit 77
}
slurmctld -f "$SLURM_CONF" -c || skip "slurmctld does not start here"
declare -A node
start_node() {
  setsid slurmd -N "gurney$1" -f "$SLURM_CONF" -D > "slurmd.$1" 2>&1 &
  node[$1]=$!
}
for i in 1 2 3; do start_node "$i"; done

wait_until() {  # SECONDS COMMAND...
  local seconds=$1
  shift
  for _ in $(seq "$seconds"); do
    "$@" && return
    sleep 1
  done
  fail "after $seconds s: $*"
  return 1
}
all_idle() { [ "$(sinfo -h -o '%D %t' 2> /dev/null)" = "3 idle" ]; }
none_left() { [ -z "$(squeue -h 2> /dev/null)" ]; }
held() { [ -s held_shard ]; }
for _ in $(seq 60); do
  all_idle && break
  sleep 1
done
all_idle || skip "three nodes of Slurm do not start here"

cp "$source/equipment/items/xu_trolley.toml" item.toml
cat > study.toml <<'TOML'
schema = "gurney-job/1"
[item]
equipment = "item.toml"
[excitation.record]
synthetic = { kind = "ac156" }
[settings]
duration_s = 60
[study]
synthetic_records = 6
angles_deg = [0, 45, 90]
draws = 20
[study.intensity]
measure = "PGA"
component = "larger"
unit = "g"
levels = [0.1, 0.2]
TOML
"$gurney" run study.toml -o one.h5 -j 1 > one.out 2>&1 || fail "the undisturbed study"
cp one.h5 reference.h5

# Node 2 holds its first shard that has written a part and is not finished, however fast it runs.
mkdir program
cat > program/gurney <<PROGRAM
#!/usr/bin/env bash
"$gurney" "\$@" &
if [ "\$SLURMD_NODENAME" = gurney2 ] && [ ! -e "$folder/held_shard" ]; then
  part=$folder/study.h5.shards/\$SLURM_ARRAY_TASK_ID-of-9/00000001.part
  until [ -e "\$part" ] || ! kill -0 \$!; do sleep 0.02; done
  kill -STOP \$! && echo "\$SLURM_ARRAY_TASK_ID" > "$folder/held_shard"
fi
wait \$!
PROGRAM
chmod +x program/gurney

"$gurney" submit study.toml --slurm --shards 9 --time 10 -o study.h5 --program "$folder/program/gurney" || fail "submit"
sbatch study.sbatch || fail "sbatch"
if wait_until 600 held; then
  shard=$(cat held_shard)
  echo "killing node gurney2 in shard $shard"
  id=$(squeue -h -t running -w gurney2 -o %A)
  kill -9 "${node[2]}"
  pkill -9 -f "^slurmstepd: \\[$id\\."
  pkill -9 -f "spool.gurney2/.*slurm_script|gurney run study.toml .* --shard $shard/9"
fi
"$gurney" status study.h5.shards
wait_until 900 none_left
"$gurney" status study.h5.shards
grep -q "gurney2" slurmctld.log || fail "the node was not lost"
"$gurney" merge study.h5.shards > merge.out 2>&1 || fail "merge: $(head -c 500 merge.out)"
# The name of the results is not in them, that of the job is.
cmp reference.h5 study.h5 || fail "the merged results are not those of one process"
grep -h "restart\|requeue" slurmctld.log | head -3
[ "$failures" -eq 0 ] && echo "an array of nine tasks with a lost node gives the bytes of one process"
exit $((failures > 0))
