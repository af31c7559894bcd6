#!/usr/bin/env bash
# Studies from outside: the same bytes for any number of threads and any interruption; exit codes,
# messages, and the files that are left.
# usage: studies.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# job FILE DURATION [KEY=VALUE...]: 24 units of 2 runs, each of them DURATION s long
job() {
  local file=$1 duration=$2
  shift 2
  cat > "$file" <<TOML
schema = "gurney-job/1"
[item]
equipment = "item.toml"
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
[excitation.record]
synthetic = { kind = "ricker", period_s = 0.5 }
[settings]
duration_s = $duration
settle_time_s = 0
$(printf '%s\n' "$@")
[study]
angles_deg = [0, 45, 90]
draws = 4
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
}

study() { expect "$1" "$2" "$gurney" run "${@:3}"; }  # CODE TEXT ARGUMENTS...
same() { cmp "$1" "$2" > stdout 2> stderr || complain "$1 and $2 differ"; }
gone() { [ ! -e "$1" ] || complain "$1 is left"; }
killed() {  # JOB FILE: killed at random moments, then gone on with
  local kills=0
  for _ in 1 2 3 4 5 6; do
    "$gurney" run "$1" -o "$2" --resume -j 2 > stdout 2> stderr &
    process=$!
    sleep "0.$((RANDOM % 20 + 10))"
    kill -STOP "$process" 2> /dev/null  # its next run writes a part
    sleep 1
    kill -CONT "$process" 2> /dev/null
    sleep "0.0$((RANDOM % 9))"
    kill -9 "$process" 2> /dev/null && kills=$((kills + 1))
    wait "$process" 2> /dev/null
    [ -e "$2" ] && break
  done
  [ "$kills" -gt 1 ] || complain "only $kills kills: the study is too short"
  study 0 "$2" "$1" -o "$2" --resume
  gone "$2.parts"
  gone "$2.part"
}

item=$2/equipment/items/xu_trolley.toml
cp "$item" item.toml
unedited=$(sha256sum item.toml | cut -d' ' -f1)

# Threads.
job small.toml 0.5
study 0 "runs     48, 0 overturned, 0 failed" small.toml -o one.h5 -j 1
for threads in 2 7; do
  study 0 "runs     48" small.toml -o "t$threads.h5" -j "$threads"
  same one.h5 "t$threads.h5"
  gone "t$threads.h5.parts"
done
study 1 "one.h5: exists already" small.toml -o one.h5
study 0 '"runs": 48' small.toml -o one.h5 --overwrite --json
study 0 "one.h5 (already complete)" small.toml -o one.h5 --resume
study 0 "runs     48" small.toml -o fresh.h5 --resume
same one.h5 fresh.h5

# A cart with parts and what stands on them: the same bytes wherever the heap puts its numbers.
cat > parts.toml <<TOML
schema = "gurney-job/1"
[item]
equipment = "crash_cart"
variant = "drawers and defibrillator"
[excitation.record]
synthetic = { kind = "stochastic" }
[settings]
duration_s = 3
[study]
draws = 1
synthetic_records = 1
TOML
expect 0 "parts.h5" "$gurney" run parts.toml -o parts.h5
for heap in GLIBC_TUNABLES=glibc.malloc.tcache_count=0 MALLOC_MMAP_THRESHOLD_=16; do
  expect 0 "parts_elsewhere.h5" env "$heap" "$gurney" run parts.toml -o parts_elsewhere.h5 --overwrite
  same parts.h5 parts_elsewhere.h5
done

# Killed at random moments, then gone on with.
job long.toml 80
TIMEFORMAT=%U
{ time study 0 "runs     48" long.toml -o whole.h5; } 2> spent
# check times eight of these runs, which take nearly all of its time: within a factor of 2 of what it says.
"$gurney" check long.toml --json -j 1 > stdout
estimated=$(sed -n 's/.*"time_s": \([0-9.e-]*\).*/\1/p' stdout)
awk -v e="$estimated" -v s="$(cat spent)" 'BEGIN { exit !(e > s / 2 && e < 2 * s) }' ||
  complain "check estimates $estimated s, the run takes $(cat spent) s"
killed long.toml killed.h5
same whole.h5 killed.h5

# Stages, each planned from those before.
job staged.toml 40
sed -i 's/^levels = .*/levels = [0.1, 1]\nadaptive = { stages = 2, limit_state = "moved" }/' staged.toml
study 0 "runs     144, 0 overturned, 0 failed" staged.toml -o staged.h5 -j 1
study 0 "runs     144" staged.toml -o staged7.h5 -j 7
same staged.h5 staged7.h5
killed staged.toml staged_killed.h5
same staged.h5 staged_killed.h5
expect 0 "the same results as in staged.h5" "$gurney" replay staged.h5 143

# Interrupted.
for pair in INT:130 TERM:143; do
  rm -f stopped.h5
  begin long.toml stopped.h5
  kill -s "${pair%:*}" "$process"
  ends "${pair#*:}" "gurney: interrupted; "
  grep -qE '^gurney: interrupted; [1-9][0-9]* of 24 analysis cases are finished and kept in stopped.h5.parts$' stderr ||
    complain "does not say what is kept"
  grep -qx "continue with: gurney run long.toml -o stopped.h5 --resume -j 1" stderr || complain "does not say how to go on"
  gone stopped.h5
  study 1 "stopped.h5.parts: contains runs of an interrupted study; continue with --resume" long.toml -o stopped.h5
  sed 's/levels = .*/levels = [0.1, 0.2]/' long.toml > other.toml
  study 1 "contains runs of another study: study.intensity.levels: there '[0.1, 0.3]', here '[0.1, 0.2]' (in the job)" \
    other.toml -o stopped.h5 --resume
  echo '# edited' >> item.toml
  study 1 "item.toml: there '$unedited', here '$(sha256sum item.toml | cut -d' ' -f1)'" long.toml -o stopped.h5 --resume
  cp "$item" item.toml
  truncate -s -10 stopped.h5.parts/00000001.part
  study 0 "stopped.h5.parts/00000001.part: is damaged" long.toml -o stopped.h5 --resume
  same whole.h5 stopped.h5
  gone stopped.h5.parts
done
grep -q " interrupted on " stopped.log && grep -q " finished on " stopped.log || complain "the log does not report both attempts"
sed 's/levels = .*/levels = [0.1, 0.2]/' small.toml > other.toml
study 1 "one.h5: holds the results of another study: study.intensity.levels: there" other.toml -o one.h5 --resume

# A run that crashed the program twice is a failed row; a crash is reported and leaves a line.
# Between two runs a crash names none: then once more.
for _ in $(seq 10); do
  rm -rf crashed.h5.parts
  begin long.toml crashed.h5
  kill -CONT "$process"
  sleep 0.02
  kill -s SEGV "$process"
  wait "$process"
  code=$?
  cp err stderr
  grep -q "crashed (signal 11) in run " stderr && break
done
[ "$code" -eq 139 ] || complain "exit code $code instead of 139"
grep -q 'gurney: crashed (signal 11) in run [01] of analysis case [0-9]*; finished runs are kept' stderr || complain "does not report the crash"
cat crashed.h5.parts/crashes > crashes.once
cat crashes.once >> crashed.h5.parts/crashes
study 3 "runs     48, 0 overturned, 1 failed" long.toml -o crashed.h5 --resume
gone crashed.h5.parts

# A full disk: what is there stays, and the study goes on from it.
# shellcheck disable=SC2317
full_disk() { (ulimit -f "$1"; exec "$gurney" run long.toml -o full.h5 -j 2 "${@:2}"); }
expect 1 "continue with: gurney run long.toml -o full.h5 --resume -j 2" full_disk 20
[ "$(wc -L < stderr)" -lt 200 ] || complain "the reason has more than a line"
grep -q "File too large" stderr || complain "does not say why"
gone full.h5
gone full.h5.part
[ -e full.h5.parts/study ] || complain "the parts are gone"
study 0 "full.h5" long.toml -o full.h5 --resume
same whole.h5 full.h5

# Runs that fail are rows; the rest of the study is made.
cat > failing.toml <<'TOML'
schema = "gurney-job/1"
[[item]]
equipment = "xu_trolley"
[[item]]
equipment = "xu_trolley"
position_m = { value = [2, 0], source = "plan", distribution = { x = { kind = "uniform", low = 0, high = 2, source = "plan" } } }
[settings]
duration_s = 0.1
[study]
draws = 40
TOML
study 3 " failed" failing.toml -o failing.h5
[ -e failing.h5 ] || complain "no results of a study with failed runs"
expect 3 "failing.h5: " "$gurney" run failing.toml -o failing.h5 --overwrite --quiet
expect 3 '"failed": ' "$gurney" run failing.toml -o failing.h5 --resume --json
# A configuration of which all do is named, and the others are answered for.
cat > half.toml <<'TOML'
schema = "gurney-job/1"
[[item]]
name = "first"
equipment = "hospital_bed"
[[item]]
name = "second"
equipment = "hospital_bed"
position_m = [2.4, 0]
[excitation.record]
synthetic = { kind = "ricker", period_s = 1 }
[settings]
duration_s = 0.1
[study]
draws = 2
[[study.factor]]
name = "place"
[study.factor.level.far]
[study.factor.level.near]
item.second.position_m = { value = [2.4, 0], source = "plan", distribution = { x = { kind = "uniform", low = 0.1, high = 2.4, source = "plan" }, y = { kind = "uniform", low = -0.1, high = 0.1, source = "plan" } } }
TOML
study 3 "2 failed" half.toml -o half.h5
expect 0 "far" "$gurney" loss half.h5 --measure pfv
grep -q "half.h5: all runs of near failed" stderr || complain "loss leaves a configuration out without a word"

# Files that cannot be.
study 2 "must end in .h5" small.toml -o a.txt
study 1 "the folder none does not exist" small.toml -o none/a.h5
gone none
study 1 "cannot be written" small.toml -o /proc/a.h5
mkdir folder.h5
study 1 "is a folder" small.toml -o folder.h5
study 2 "--threads" small.toml -j 0
study 1 "studies have a table [study]" "$2/studies/jobs/icu_ventilator_shake.toml" --resume
printf 'hello' > text.h5
study 1 "text.h5" small.toml -o text.h5 --resume

# What would run, and nothing is written.
mkdir quiet
cp small.toml item.toml quiet
cd quiet || exit 1
expect 0 "cases   24" "$gurney" check small.toml -j 1
grep -qE "^levels +2: 0.1, 0.3 g of PGA h1$" stdout || complain "no levels"
grep -qE "^runs +48$" stdout || complain "no runs"
grep -qE "^time +about .* with 1 threads on as many idle cores \([0-9] runs were timed: " stdout || complain "no time"
grep -qE "^disk +about .*bytes a run" stdout || complain "no disk"
expect 0 '"runs": 48' "$gurney" check small.toml --json
# Its time is that of the runs, at most twice it: eight of 48 are timed. A study this small spends more
# on reading and writing files, which no run is charged for.
"$gurney" check small.toml --json -j 1 > stdout
estimated=$(sed -n 's/.*"time_s": \([0-9.e-]*\).*/\1/p' stdout)
{ time "$gurney" run small.toml -o timed.h5 -j 1 > /dev/null 2>&1; } 2> spent
awk -v e="$estimated" -v s="$(cat spent)" 'BEGIN { exit !(e > 0 && e < 2 * s) }' ||
  complain "check estimates $estimated s, the run takes $(cat spent) s"
rm -f timed.* spent
expect 0 "a valid single run" "$gurney" check "$2/studies/jobs/icu_ventilator_shake.toml"
sed 's/equipment = .*/equipment = "xu_troley"/; s/values = .*/values = [false, 2]/; s/draws = 4/draws = 0/' small.toml > bad.toml
expect 1 "bad.toml:15:9: study.draws = 0" "$gurney" check bad.toml
grep -q "^bad.toml:3:13: item.equipment = .xu_troley.: " stderr || complain "errors of the job are hidden"
printf '{"schema": "gurney-job/1", "item": {"equipment": "xu_trolley", "yaw_deg": "x"}}' > bad.json
expect 1 "bad.json:/item/yaw_deg: item.yaw_deg = \"x\"" "$gurney" check bad.json
rm -f stdout stderr bad.toml bad.json item.toml
[ "$(ls)" = small.toml ] || complain "check leaves $(ls)"
cd ..

[ "$failures" -eq 0 ] && echo "studies did as they should"
exit $((failures > 0))
