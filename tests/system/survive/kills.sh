#!/usr/bin/env bash
# Studies that are killed, stopped, starved and damaged at random moments, and resumed: each ends with
# the bytes of the undisturbed one, and no file under the name of the results is ever anything else.
# usage: kills.sh GURNEY SOURCE_FOLDER [TRIALS [SEED]]
set -uo pipefail
gurney=$1 trials=${3:-8} seed=${4:-$RANDOM}
. "$2/tests/system/cli/expect.sh"
. "$2/tests/system/survive/faults_of_files.sh"
workers=$((6 * $(nproc)))
[ "$workers" -le "$trials" ] || workers=$trials

cp "$2/equipment/items/xu_trolley.toml" item.toml
cat > plain.toml <<'TOML'
schema = "gurney-job/1"
[item]
equipment = "item.toml"
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
[excitation.record]
synthetic = { kind = "ricker", period_s = 0.5 }
[settings]
duration_s = 4
settle_time_s = 0
[study]
angles_deg = [0, 45, 90]
draws = 8
[study.intensity]
measure = "PGA"
unit = "g"
component = "h1"
levels = [0.1, 0.3]
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
TOML
sed 's/^levels = .*/levels = [0.1, 1]\nadaptive = { stages = 2, limit_state = "moved" }/; s/^draws = .*/draws = 4/' plain.toml > staged.toml
for job in plain staged; do
  expect 0 " 0 failed" "$gurney" run "$job.toml" -o "$job.h5" -j 1
done

chance() { [ $((RANDOM % 100)) -lt "$1" ]; }               # PERCENT
nap() { sleep "$(printf '0.%03d' $((RANDOM % $1)))"; }     # below so many ms
tally() { echo "$*" >> "$tallies"; }

# Whether the memory of the last attempt is too little to load the program, and to set it up.
not_even_version() {
  ! (ulimit -v "$memory_kb" && exec "$gurney" --version) > /dev/null 2>&1
}

# What was begun is disturbed, and is gone.
disturb() {  # FOLDER of parts, LIMIT of the attempt
  local limit=$2
  nap 300
  # A process that was stopped for a second writes a part when its next run ends.
  if chance 80; then
    kill -STOP "$process" 2> /dev/null
    sleep 1.01
    if chance 15; then damage "$1"; fi
    kill -CONT "$process" 2> /dev/null
    nap 120
  fi
  local signal=KILL
  if chance 30; then signal=TERM; elif chance 30; then signal=INT; fi
  kill -s $signal "$process" 2> /dev/null && tally "signal $signal"
  wait "$process" 2> /dev/null
  local code=$?
  tally "exit $code"
  case $code.$limit in
    0.* | 1.* | 130.* | 137.* | 143.*) ;;
    127.memory | 134.memory)  # of the loader, and of what precedes the commands
      not_even_version || complain "exit code $code with $memory_kb kB of memory, after its start"
      ;;
    *) complain "exit code $code after $signal" ;;
  esac
}

# No file of this name is half a result.
whole() { [ ! -e a.h5 ] || cmp -s "../$job.h5" a.h5 || complain "a.h5 is not the result of $job"; }

# attempt LIMIT ARGUMENTS...: goes on with the study, under a limit of this process
attempt() {
  local limit=$1
  shift
  memory_kb=$((RANDOM % 60000 + 30000))
  (
    case $limit in
      file_size) ulimit -f $((RANDOM % 300 + 1)) ;;
      memory) ulimit -v "$memory_kb" ;;
    esac
    exec "$gurney" run "../$job.toml" -o a.h5 --resume -j $((RANDOM % 2 + 1)) "$@"
  ) > stdout 2> stderr &
  process=$!
}

# harry FOLDER ARGUMENTS...: a few disturbed attempts, with parts in FOLDER
harry() {
  local limit parts=$1
  shift
  for ((i = RANDOM % 3; i >= 0; --i)); do
    limit=none
    if chance 10; then limit=file_size; elif chance 10; then limit=memory; fi
    [ $limit = none ] || tally "limit $limit"
    attempt $limit "$@"
    disturb "$parts" $limit
    whole
    if chance 25; then damage "$parts"; fi
    if chance 30; then read_only "$@"; fi
  done
}

finish() {  # ARGUMENTS...
  "$gurney" run "../$job.toml" -o a.h5 --resume -j 2 "$@" > stdout 2> stderr || complain "exit code $? of the last --resume"
}

trial() {
  job=plain
  if chance 20; then job=staged; fi
  if [ $job = plain ] && chance 20; then
    tally "kind shards"
    for shard in 1/2 2/2; do
      harry "a.h5.shards/${shard/\//-of-}" --shard $shard
      finish --shard $shard
    done
    "$gurney" merge a.h5.shards > stdout 2> stderr || complain "exit code $? of merge"
  else
    tally "kind $job"
    if small_disk; then tally "limit disk"; fi
    harry a.h5.parts
    ample_disk
    finish
  fi
  [ -e a.h5 ] || complain "no results"
  whole
  rm -f a.h5 a.log
  local left
  left=$(find . -mindepth 1 ! -name stdout ! -name stderr | tr '\n' ' ')
  [ -z "$left" ] || complain "left behind: $left"
}

work() {  # WORKER: every so many trials
  local number
  for ((number = $1; number <= trials; number += workers)); do
    RANDOM=$((seed + number))
    tallies=$folder/tallies.$1
    mkdir "$folder/trial.$number"
    cd "$folder/trial.$number" || exit 1
    local before=$failures
    trial
    cd "$folder" || exit 1
    [ "$failures" -eq "$before" ] || echo "in trial $number of seed $seed"
    no_disk "$folder/trial.$number"
    rm -rf "$folder/trial.$number"
    echo trial >> "$tallies"
  done
  exit $((failures > 0))
}

echo "$trials trials with seed $seed"
pids=()
for ((worker = 1; worker <= workers; ++worker)); do
  work "$worker" &
  pids+=($!)
done
for pid in "${pids[@]}"; do
  wait "$pid" || failures=$((failures + 1))
done
sort tallies.* | uniq -c | sort -k2,2 -k1,1rn | awk '{n = $1; $1 = ""; printf "%7d %s\n", n, $0}'
can_mount || echo "skipped: full and read-only disks, which need root and the right to mount"
[ "$failures" -eq 0 ] && echo "all results have the bytes of undisturbed studies"
exit $((failures > 0))
