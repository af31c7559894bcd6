#!/usr/bin/env bash
# A study of many short runs keeps no more memory for its last runs than for its first.
# usage: memory.sh GURNEY SOURCE_FOLDER [RUNS]
set -uo pipefail
gurney=$1 runs=${3:-20000}
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
# The least of a quarter is what is kept; the most includes a part in the making, some 5 MB for a thousand runs.
# A kilobyte kept of each run is half of the runs in kilobytes from the second to the last quarter, here 10 MB:
# the limit is half of that. Heaps that settle differ by up to 2 MB.
awk -v runs="$runs" 'NF {size[++n] = $1}
function least(first, last,  i, value) {
  value = size[last]
  for (i = first; i < last; ++i) if (size[i] < value) value = size[i]
  return value
}
END {
  early = least(int(n / 4) + 1, int(n / 2)); late = least(int(3 * n / 4) + 1, n)
  printf "%d runs: %.1f MB kept in the second quarter, %.1f MB in the last\n", runs, early / 1e3, late / 1e3
  exit n < 40 || late > early + runs / 4
}' sizes || complain "the memory grows"
[ "$failures" -eq 0 ] || exit 1
