#!/usr/bin/env bash
# Studies among faults: other processes, edits, files of others, standard streams that are full or
# closed, little memory. No result is ever wrong, lost or somebody else's.
# usage: faults.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

study() { expect "$1" "$2" "$gurney" run "${@:3}"; }  # CODE TEXT ARGUMENTS...
same() { cmp "$1" "$2" > stdout 2> stderr || complain "$1 and $2 differ"; }
gone() { [ ! -e "$1" ] || complain "$1 is left"; }
holds() { [ "$(cat "$1")" = "$2" ] || complain "$1 holds '$(head -c 100 "$1")'"; }
interrupt() {
  kill -INT "$process"
  ends 130 "gurney: interrupted"
}
fresh() {
  rm -rf a.h5 a.log a.h5.parts
  cp "$item" item.toml
}

records() {
  printf 'name, h1, unit, time_step_s, scale\nfirst, a.txt, m/s2, 0.01, 1.5\n' > list.csv
  for i in $(seq 400); do echo "$((i * 7 % 5 - 2))"; done > a.txt
}

item=$2/equipment/items/xu_trolley.toml
cp "$item" item.toml
cat > long.toml <<'TOML'
schema = "gurney-job/1"
[item]
equipment = "item.toml"
[excitation.record]
suite = "list.csv"
use = "x"
[settings]
duration_s = 50
settle_time_s = 0
[study]
angles_deg = [0, 15, 30, 45, 60, 75, 90, 105, 120, 135]
draws = 2
[study.intensity]
scales = [1, 2]
TOML
records
study 0 "runs     40, 0 overturned, 0 failed" long.toml -o whole.h5 -j 2

# A second process, whatever it is asked, gets nothing; the first goes on.
begin long.toml a.h5
for how in --overwrite --resume "--resume --overwrite"; do
  # shellcheck disable=SC2086
  study 1 "a.h5.parts: another process works on this study: process $process on " long.toml -o a.h5 $how
done
study 1 "another process works on this study: process $process on " long.toml -o a.h5
ends 0 "runs     40"
same whole.h5 a.h5

# Of two first starts one gets the study.
for _ in 1 2 3 4 5; do
  fresh
  "$gurney" run long.toml -o a.h5 -j 1 > out 2> err &
  process=$!
  "$gurney" run long.toml -o a.h5 -j 1 --overwrite > stdout 2> stderr
  second=$?
  wait "$process"
  first=$?
  [ $((first + second)) -eq 1 ] || complain "exit codes $first and $second of two first starts"
  same whole.h5 a.h5
  gone a.h5.parts
done

# Data files that are edited or removed while the study runs: it has read them.
fresh
begin long.toml a.h5
sed -i 's/value = 96.5/value = 93.5/' item.toml
echo "second, a.txt, m/s2, 0.01, 3" >> list.csv
rm item.toml a.txt
ends 0 "runs     40, 0 overturned, 0 failed"
same whole.h5 a.h5
records
cp "$item" item.toml
study 0 "a.h5 (already complete)" long.toml -o a.h5 --resume

# The results of another study are not these.
sed -i 's/value = 96.5/value = 93.5/' item.toml
study 1 "a.h5: holds the results of another study: item.toml: there '$(sha256sum "$item" | cut -d' ' -f1)', here '$(sha256sum item.toml | cut -d' ' -f1)'" \
  long.toml -o a.h5 --resume
cp "$item" item.toml
sed -i 's/1.5$/1.6/' list.csv
study 1 "a.h5: holds the results of another study: list.csv: there '" long.toml -o a.h5 --resume
sed -i 's/1.6$/1.5/' list.csv
cp a.txt kept.txt
sed -i '1s/.*/2/' a.txt
study 1 "a.h5: holds the results of another study: record first: there '" long.toml -o a.h5 --resume
cp kept.txt a.txt
sed -i 's/^duration_s = 50/duration_s = 51/' long.toml
study 1 "another study: settings.duration_s: there '50', here '51' (in the job)" long.toml -o a.h5 --resume
expect 1 "long.toml: is not the job of a.h5: settings.duration_s: there '50', here '51'" "$gurney" replay a.h5 0
sed -i 's/^duration_s = 51/duration_s = 50/' long.toml

# An output that somebody makes meanwhile is theirs; the results are kept.
fresh
begin long.toml a.h5
echo precious > a.h5
ends 1 "a.h5: was created by another process in the meantime and is kept; the finished results are in a.h5.parts/results.h5"
holds a.h5 precious
same whole.h5 a.h5.parts/results.h5
study 1 "a.h5" long.toml -o a.h5 --resume
holds a.h5 precious
mv a.h5 theirs
study 0 "runs     40" long.toml -o a.h5 --resume
same whole.h5 a.h5
gone a.h5.parts

# --overwrite, interrupted: the old results stay until --resume --overwrite replaces them.
echo old > a.h5
begin long.toml a.h5 --overwrite
interrupt
grep -qx "continue with: gurney run long.toml -o a.h5 --resume --overwrite -j 1" stderr || complain "does not say how to go on"
holds a.h5 old
study 1 "a.h5" long.toml -o a.h5 --resume
holds a.h5 old
study 0 "runs     40" long.toml -o a.h5 --resume --overwrite
same whole.h5 a.h5

# Killed between the results and the end: they are complete.
fresh
begin long.toml a.h5
interrupt
cp whole.h5 a.h5
study 0 "a.h5 (already complete)" long.toml -o a.h5 --resume
gone a.h5.parts
mkdir a.h5.parts
touch a.h5.parts/lock
study 0 "a.h5 (already complete)" long.toml -o a.h5 --resume
gone a.h5.parts

# Counts and percent after --resume are those of the whole study.
fresh
begin long.toml a.h5
interrupt
study 0 "runs     40" long.toml -o a.h5 --resume -j 1
[ "$(grep -cE '^100 %  40 runs, ' stderr)" -eq 1 ] || complain "the counts are not those of the whole study, once"

# Files and links of others are neither followed nor removed.
fresh
echo precious > victim
ln -s "$PWD/victim" a.h5.part
study 0 "runs     40" long.toml -o a.h5
holds victim precious
[ -L a.h5.part ] || complain "the link is gone"
rm -f a.h5 a.h5.part
mkdir a.h5.parts
echo mine > a.h5.parts/notes.txt
for how in "" --overwrite --resume; do
  # shellcheck disable=SC2086
  study 1 "a.h5.parts: is not a folder of parts, it contains 'notes.txt'; it is kept" long.toml -o a.h5 $how
done
holds a.h5.parts/notes.txt mine
[ "$(ls a.h5.parts)" = notes.txt ] || complain "the folder of somebody else holds $(ls a.h5.parts)"
fresh
mkdir elsewhere
ln -s elsewhere a.h5.parts
study 1 "a.h5.parts: is a link" long.toml -o a.h5
rm a.h5.parts
rmdir elsewhere

# Parts that are removed while the study runs are not called kept.
begin long.toml a.h5
rm -rf a.h5.parts
ends 1 "a.h5.parts: was removed while the study ran"
grep -q "kept" stderr && complain "says that runs are kept"

# A part that is changed after it was written, while the study runs.
fresh
begin long.toml a.h5
printf '\xff' | dd of=a.h5.parts/00000001.part bs=1 seek=300 conv=notrunc 2> /dev/null
ends 1 "a.h5.parts/00000001.part: was changed while the study ran: the checksum of analysis case "
study 0 "a.h5.parts/00000001.part: is damaged" long.toml -o a.h5 --resume
same whole.h5 a.h5

# A torn or foreign line of the file of crashes.
fresh
begin long.toml a.h5
interrupt
printf '50 %%  9 runs\n3 1' > a.h5.parts/crashes
study 0 "a.h5.parts/crashes:1: is not a line" long.toml -o a.h5 --resume
same whole.h5 a.h5

# Standard streams that are full or closed.
# shellcheck disable=SC2317
{
  no_error() { "$gurney" run long.toml -o a.h5 --overwrite 2>&-; }
  full_error() { "$gurney" run long.toml -o a.h5 --overwrite 2> /dev/full; }
  no_streams() { "$gurney" run long.toml -o a.h5 --overwrite >&- 2>&- <&-; }
  full() { "$gurney" "$@" > /dev/full; }
  closed() { "$gurney" "$@" >&-; }
  no_file() { "$gurney" show none.h5 2> "$1"; }
}
expect 0 "runs     40" no_error
same whole.h5 a.h5
expect 0 "runs     40" full_error
same whole.h5 a.h5
no_streams
[ $? -eq 1 ] || complain "results that cannot be reported are no success"
same whole.h5 a.h5
gone a.h5.parts
no_file /dev/full
[ $? -eq 1 ] || complain "an error that cannot be printed has another exit code"
for words in help --help --version "help run" "run --help"; do
  # shellcheck disable=SC2086
  expect 1 "cannot write to the standard output" full $words
  # shellcheck disable=SC2086
  expect 1 "" closed $words
done

# Studies that are too large, and a machine that is too small.
sed 's/^draws = .*/draws = 2147483647/' long.toml > large.toml
study 1 "large.toml: the study has 42949672940 runs, which would take about " large.toml -o large.h5
expect 1 "at most 10000000 runs are allowed" "$gurney" check large.toml
thousand="[$(seq -s, 1 1000)]"
sed "s/^draws = .*/draws = 2147483647/; s/^angles_deg.*/angles_deg = [$(seq -s, 0 0.1 99.9)]/; s/^scales.*/scales = $thousand/" long.toml > largest.toml
expect 1 "largest.toml: the study has about 2.1e+15 runs: too many" "$gurney" check largest.toml
sed 's/^draws = .*/draws = 500001/' long.toml > just.toml
expect 1 "just.toml: the study has 10000020 runs" "$gurney" check just.toml
sed 's/^draws = .*/draws = 500000/' long.toml > most.toml
expect 0 "runs    10000000" "$gurney" check most.toml
gone large.h5.parts
# shellcheck disable=SC2317
little_memory() { (ulimit -v "$1"; exec "$gurney" run long.toml -o a.h5 -j 1 --resume); }
# shellcheck disable=SC2317
too_little_to_start() { (ulimit -v "$1"; ! "$gurney" --version) > /dev/null 2>&1; }
fresh
begin long.toml a.h5
interrupt
stopped=0
for size in $(seq 30000 750 81000); do
  too_little_to_start "$size" && continue
  little_memory "$size" > stdout 2> stderr
  got=$?
  [ "$got" -eq 0 ] && break
  if [ "$got" -eq 1 ] && grep -q "not enough memory" stderr; then
    stopped=$((stopped + 1))
  else
    complain "a limit of $size kB: exit code $got"
  fi
done
[ "$stopped" -gt 0 ] || complain "no limit at which the memory ends"
study 0 "a.h5" long.toml -o a.h5 --resume
same whole.h5 a.h5

# Options that a single run has no use for.
single=$2/studies/jobs/icu_ventilator_shake.toml
study 1 "is a single run, which has no use for --resume; studies have" "$single" --resume
study 1 "is a single run, which has no use for --resume; studies have" "$single" --resume -j 2

[ "$failures" -eq 0 ] && echo "studies stood all faults"
exit $((failures > 0))
