#!/usr/bin/env bash
# A study of many short runs takes no more memory at its end than with its first part.
# usage: memory.sh GURNEY SOURCE_FOLDER [RUNS]
set -uo pipefail
gurney=$1 runs=${3:-10000}
. "$2/tests/system/cli/expect.sh"

cat > job.toml <<TOML
schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
[excitation.record]
synthetic = { kind = "ricker", period_s = 0.1 }
[settings]
duration_s = 0.2
settle_time_s = 0
[study]
draws = $runs
TOML

# resident PID: [kB]
resident() { awk '/^VmRSS/ {print $2}' "/proc/$1/status" 2> /dev/null; }

"$gurney" run job.toml -o a.h5 -j 1 > stdout 2> stderr &
process=$!
: > sizes
wait_for a.h5.parts/00000001.part  # with the first part all is there that is kept
while kill -0 "$process" 2> /dev/null; do
  # While runs are made: the merge has memory of its own.
  [ ! -e a.h5.parts/results.h5 ] || break
  size=$(resident "$process") && echo "$size" >> sizes
  sleep 0.1
done
wait "$process" || complain "exit code $? of the study"
# Ten parts of a kilobyte a run would be 10 MB; heaps that settle are some 0.3 MB.
awk -v runs="$runs" 'NF {size[++n] = $1} END {
  early = size[1]; late = size[n]
  printf "%d runs: %.1f MB with the first part, %.1f MB at the end\n", runs, early / 1e3, late / 1e3
  exit n < 10 || late > early + 2048
}' sizes || complain "the memory grows"
[ "$failures" -eq 0 ] || exit 1
