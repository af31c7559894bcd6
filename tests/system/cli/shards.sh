#!/usr/bin/env bash
# Studies in shards: any number of processes, killed, repeated or doubled, give the same bytes as one.
# usage: shards.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

study() { expect "$1" "$2" "$gurney" run "${@:3}"; }  # CODE TEXT ARGUMENTS...
same() { cmp "$1" "$2" > stdout 2> stderr || complain "$1 and $2 differ"; }
gone() { [ ! -e "$1" ] || complain "$1 is left"; }
variables() { env -u SLURM_ARRAY_TASK_ID -u SLURM_PROCID -u OMPI_COMM_WORLD_RANK "$@"; }

item=$2/equipment/items/xu_trolley.toml
cp "$item" item.toml
cat > job.toml <<'TOML'
schema = "gurney-job/1"
[item]
equipment = "item.toml"
[excitation.record]
suite = "list.csv"
use = "x"
[settings]
duration_s = 20
settle_time_s = 0
[study]
angles_deg = [0, 15, 30]
draws = 4
[study.intensity]
scales = [1, 2]
TOML
printf 'name, h1, unit, time_step_s, scale\nshort, a.txt, m/s2, 0.01, 1.5\nlong, b.txt, m/s2, 0.01, 1\n' > list.csv
for i in $(seq 400); do echo "$((i * 7 % 5 - 2))"; done > a.txt
for i in $(seq 1200); do echo "$((i * 3 % 7 - 3))"; done > b.txt
study 0 "runs     48, 0 overturned, 0 failed" job.toml -o whole.h5 -j 1

# Shards beside each other, in any order, with threads.
for shard in 3 1 2; do
  "$gurney" run job.toml -o a.h5 --shard "$shard/3" -j 2 > "out.$shard" 2> "err.$shard" &
done
wait
grep -q "shard    2 of 3: 8 analysis cases, 16 runs, 0 overturned, 0 failed" out.2 || complain "does not report shard 2"
grep -qx "when all shards are finished: gurney merge a.h5.shards" out.2 || complain "does not say how to go on"
gone a.h5
: > a.h5.shards/job.part  # as a process that was killed leaves it
expect 0 "runs     48, 0 overturned, 0 failed" "$gurney" merge a.h5.shards
same whole.h5 a.h5
gone a.h5.shards
[ "$(grep -c " finished on " a.log)" -eq 3 ] || complain "the log does not report three shards"
expect 0 "the same results as in a.h5" "$gurney" replay a.h5 47
study 0 "a.h5 (already complete)" job.toml -o a.h5 --shard 1/3 --resume
rm a.h5 a.log

# Missing shards, and half of one. What was begun with three shards is finished with two.
study 0 "shard    1 of 3" job.toml -o a.h5 --shard 1/3
expect 1 "a.h5.shards: 16 of 24 analysis cases are missing" "$gurney" merge a.h5.shards
grep -qx "  shard 3/3 lacks 8 of 8" stderr || complain "does not name shard 3"
grep -q "^  gurney run .*/job.toml'* -o a.h5 --resume --shard 3/3$" stderr || complain "does not say how to complete shard 3"
grep -qx "  sbatch --array=2,3 job.sbatch" stderr || complain "does not say how to complete an array"
study 1 "a.h5.shards/1-of-3: contains runs of an interrupted study" job.toml -o a.h5 --shard 1/3
study 0 "shard    1 of 3" job.toml -o a.h5 --shard 1/3 --resume
study 0 "shard    1 of 2" job.toml -o a.h5 --shard 1/2
expect 1 "8 of 24 analysis cases are missing, such as 1, 2, 6, 10, " "$gurney" merge a.h5.shards/
expect 0 "16 of 24 analysis cases, 32 runs, 0 failed; 2 of 2 shards finished" "$gurney" status a.h5.shards
grep -qx "8 analysis cases are in no shard; these are of several counts" stdout || complain "does not say that cases are missing"
expect 0 '"seconds_to_go": null' "$gurney" status a.h5.shards --json
study 0 "shard    2 of 2" job.toml -o a.h5 --shard 2/2
cp -r a.h5.shards others.shards

# Shards of another study, or of other data.
sed 's/scales = .*/scales = [1, 3]/' job.toml > other.toml
expect 1 "study.intensity.scales: there '[1, 2]', here '[1, 3]' (in the job)" "$gurney" merge a.h5.shards --job other.toml
echo '# edited' >> item.toml
expect 1 "item.toml: there '" "$gurney" merge a.h5.shards
study 1 "item.toml: there '" job.toml -o a.h5 --shard 1/2 --resume
cp "$item" item.toml

# A shard of an edited job beside one of the old is refused before its hours are spent; shards of others
# are not counted.
mkdir b.h5.shards
cp -r others.shards/1-of-2 others.shards/job b.h5.shards
study 1 "b.h5.shards/1-of-2: contains runs of another study, which \`gurney merge\` would refuse: study.intensity.scales: there '[1, 2]', here '[1, 3]' (in the job)" other.toml -o b.h5 --shard 2/2
gone b.h5.shards/2-of-2
expect 0 "12 of 24 analysis cases, 24 runs, 0 failed; 1 of 2 shards finished" "$gurney" status b.h5.shards
cp -r b.h5.shards/1-of-2 b.h5.shards/2-of-2
expect 0 "12 of 24 analysis cases, 24 runs, 0 failed; 1 of 2 shards finished" "$gurney" status b.h5.shards
grep -qx "12 analysis cases stand in the folder of another shard and are not counted" stdout || complain "does not say that shard 2 holds cases of shard 1"
expect 0 '"foreign_analysis_cases": 12' "$gurney" status b.h5.shards --json
study 0 "shard    2 of 2" other.toml -o b.h5 --shard 2/2 --overwrite
expect 0 "12 of 24 analysis cases, 24 runs, 0 failed; 1 of 2 shards finished" "$gurney" status b.h5.shards
grep -qE "^ *2/2 +0 of 12 .* of another study: not counted, and refused by merge$" stdout || complain "does not say that shard 2 is of another study"
rm -r b.h5.shards/2-of-2
ln -s ../others.shards/2-of-2 b.h5.shards/2-of-2
expect 1 "b.h5.shards/2-of-2: is a link; a shard is a folder" "$gurney" merge b.h5.shards
rm -r b.h5.shards
mkdir elsewhere
cp job.toml item.toml list.csv ?.txt elsewhere
mv job.toml moved.toml
expect 1 "job.toml does not exist any more; give its new path with --job" "$gurney" merge a.h5.shards
expect 0 "runs     48" "$gurney" merge a.h5.shards --job elsewhere/job.toml
mv moved.toml job.toml
same whole.h5 a.h5
expect 1 "a.h5: exists already" "$gurney" merge others.shards -o a.h5
expect 0 '"runs": 48' "$gurney" merge others.shards -o b.h5 --json
same whole.h5 b.h5
rm a.h5 b.h5

# Killed at its first part, run twice at the same time, resumed.
sed -i 's/^duration_s = .*/duration_s = 60/; s/^draws = .*/draws = 8/' job.toml
study 0 "runs     96" job.toml -o long.h5 -j 2
begin_in a.h5.shards/2-of-2 job.toml a.h5 --shard 2/2
study 1 "a.h5.shards/2-of-2: another process works on this study: process $process on " job.toml -o a.h5 --shard 2/2 --resume
expect 1 "a.h5.shards/2-of-2: another process works on this study: process $process on " "$gurney" merge a.h5.shards
kill -9 "$process"
wait "$process" 2> /dev/null
study 0 "shard    1 of 2" job.toml -o a.h5 --shard 1/2 -j 2
expect 1 "  shard 2/2 lacks " "$gurney" merge a.h5.shards
study 0 "shard    2 of 2: 24 analysis cases, 48 runs" job.toml -o a.h5 --shard 2/2 --resume
expect 0 "runs     96" "$gurney" merge a.h5.shards
same long.h5 a.h5
gone a.h5.shards
rm a.h5

# Interrupted: how to go on names the shard.
begin_shard() {
  "$gurney" run job.toml -o a.h5 --shard 1/2 -j 1 --no-figure > out 2> err &
  process=$!
  wait_for a.h5.shards/1-of-2/crashes
  kill -TERM "$process"
}
begin_shard
ends 143 "continue with: gurney run job.toml -o a.h5 --resume --shard 1/2 -j 1 --no-figure"
rm -rf a.h5.shards

# Progress, of shards that run, have finished, have stopped and have not started.
begin_in a.h5.shards/1-of-3 job.toml a.h5 --shard 1/3
study 0 "shard    2 of 3" job.toml -o a.h5 --shard 2/3
expect 0 "of 48 analysis cases, " "$gurney" status a.h5.shards
grep -qE "^ *1/3 +[0-9]+ of 16 .* running: process $process on " stdout || complain "does not show that shard 1 runs"
grep -qE "^ *2/3 +16 of 16 +32 +0 +0 failed .* finished$" stdout || complain "does not show that shard 2 has finished"
grep -qE "^ *3/3 +0 of 16 +0 .* not started$" stdout || complain "does not show that shard 3 is missing"
tr '\n' ' ' < stdout | grep -qE "; 1 of 3 shards finished, 1 running, [0-9.]+ runs/s, .* to go " || complain "no rate"
expect 0 '"seconds_to_go": null' "$gurney" status a.h5.shards --json  # of shard 3, and so of all
[ "$(grep -c '"seconds_to_go": null' stdout)" -eq 2 ] || complain "a time to go of a shard that has not started"
grep -q '"seconds_to_go": 0[.,]' stdout || complain "no time to go of a finished shard"
expect 0 "of 48 analysis cases; all below is of these alone" "$gurney" show a.h5.shards
grep -q "^UNFINISHED: [0-9]" stdout || complain "an unfinished study is not marked as such"
expect 0 '"analysis_cases": 48' "$gurney" show a.h5.shards --json
expect 0 "of 48 analysis cases" "$gurney" show a.h5.shards --job job.toml
{ echo 'title = "another"'; cat job.toml; } > another.toml
expect 1 "another.toml: is not the job of a.h5.shards: " "$gurney" show a.h5.shards --job another.toml
expect 1 "another.toml: is not the job of a.h5.shards: " "$gurney" report a.h5.shards --job another.toml -o another.html
grep -q "gurney replay" stdout && complain "offers to repeat runs whose numbers will change"
kill -TERM "$process"
ends 143 "continue with"
expect 0 " stopped" "$gurney" status a.h5.shards
grep -qx "slowest records  *runs  *CPU time of a run \[s\]" stdout || complain "names no slowest records"
grep -qE "^long +[0-9]+ +[0-9.e-]+$" stdout || complain "does not say how long the record 'long' takes"
expect 0 '"cpu_seconds_per_run": ' "$gurney" status a.h5.shards --json

# A damaged file `study` is written again from what its parts state.
cp a.h5.shards/2-of-3/study study.whole
printf X | dd of=a.h5.shards/2-of-3/study bs=1 seek=90 conv=notrunc 2> /dev/null
expect 1 "a.h5.shards/2-of-3/study: is damaged (its checksum does not match)" "$gurney" status a.h5.shards
expect 0 "a.h5.shards/2-of-3/study: is damaged; it is written again" "$gurney" run job.toml -o a.h5 --shard 2/3 --resume
same study.whole a.h5.shards/2-of-3/study
expect 1 "none: is not a folder of shards" "$gurney" status none
mkdir none.parts
expect 1 "none.parts" "$gurney" show none.parts
rm -rf a.h5.shards

# A script for Slurm: what it runs, with a program in place of srun.
expect 0 "submit   sbatch job.sbatch" "$gurney" submit job.toml --slurm --shards 3 -j 2 --time 00:10:00 --sbatch=--partition=short --program "$gurney"
for line in "#SBATCH --array=1-3" "#SBATCH --cpus-per-task=2" "#SBATCH --time=00:10:00" "#SBATCH --requeue" "#SBATCH --partition=short"; do
  grep -qx -- "$line" job.sbatch || complain "the script has no line $line"
done
bash -n job.sbatch || complain "the script is no script"
mkdir bin
printf '#!/bin/sh\nexec "$@"\n' > bin/srun
printf '#!/bin/sh\necho "scontrol $*"\n' > bin/scontrol
chmod +x bin/*
for task in 1 2 3; do
  expect 0 "shard    $task of 3" env PATH="$PWD/bin:$PATH" SLURM_ARRAY_JOB_ID=9 SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=2 bash job.sbatch
done
expect 0 "runs     96" "$gurney" merge job.h5.shards
same long.h5 job.h5
rm job.h5
expect 1 "job.sbatch: exists already" "$gurney" submit job.toml --slurm --shards 3
expect 0 "sbatch one.sbatch" "$gurney" submit job.toml --slurm --shards 1 --mode allocation --script one.sbatch --program "$gurney"
expect 0 "runs     96" env PATH="$PWD/bin:$PATH" SLURM_JOB_ID=9 SLURM_PROCID=0 SLURM_NTASKS=1 SLURM_CPUS_PER_TASK=2 bash one.sbatch
same long.h5 job.h5
rm job.h5
printf '#!/bin/sh\nexit 143\n' > bin/srun
expect 0 "scontrol requeue 9_2" env PATH="$PWD/bin:$PATH" SLURM_ARRAY_JOB_ID=9 SLURM_ARRAY_TASK_ID=2 SLURM_CPUS_PER_TASK=2 bash job.sbatch
expect 1 "--shards 49: the study has 48 analysis cases" "$gurney" submit job.toml --slurm --shards 49
expect 2 "needs one scheduler: --slurm, --pbs or --lsf" "$gurney" submit job.toml --shards 2
expect 2 "needs one scheduler" "$gurney" submit job.toml --slurm --lsf --shards 2
expect 2 "--time 1h: must be as sbatch takes it" "$gurney" submit job.toml --slurm --shards 2 --time 1h
expect 2 "--time: must not be empty" "$gurney" submit job.toml --slurm --shards 2 --time ""
for control in $'\n' $'\r' $'\v' $'\x7f'; do
  expect 1 "--directive: has the control character 0x" "$gurney" submit job.toml --slurm --shards 2 --script never --sbatch "--comment=a${control}touch pwned"
  cp job.toml "a${control}touch pwned${control}#.toml"
  expect 1 "the name of the job file: has the control character 0x" "$gurney" submit "a${control}touch pwned${control}#.toml" --slurm --shards 2 --script never
done
gone never
cp job.toml ./-j.toml
expect 0 "sbatch ./-j.sbatch" "$gurney" submit ./-j.toml --slurm --shards 2
grep -q -- ' -o ./-j.h5 ' ./-j.sbatch || complain "a results file looks like an option"

# Scripts for PBS and LSF, with their variables; arrays beyond the largest index of Slurm.
expect 0 "submit   qsub job.pbs" "$gurney" submit job.toml --pbs --shards 3 --at-most 2 -j 2 --time 00:10:00 "--directive=-q short" --program "$gurney"
for line in "#PBS -J 1-3%2" "#PBS -l select=1:ncpus=2" "#PBS -l walltime=00:10:00" "#PBS -q short"; do
  grep -qx -- "$line" job.pbs || complain "the script of PBS has no line $line"
done
expect 0 "submit   bsub < job.bsub" "$gurney" submit job.toml --lsf --shards 3 --at-most 2 --time 00:10 --program "$gurney"
for line in "#BSUB -J 'job[[]1-3[]]%2'" "#BSUB -n 1" "#BSUB -W 00:10" '#BSUB -Q "143"'; do
  grep -qx -- "$line" job.bsub || complain "the script of LSF has no line $line"
done
expect 0 "shard    1 of 3" env PBS_O_WORKDIR="$PWD" PBS_ARRAY_INDEX=1 bash job.pbs
expect 0 "shard    2 of 3" env LSB_JOBINDEX=2 bash job.bsub
expect 0 "shard    3 of 3" env LSB_JOBINDEX=3 bash job.bsub
expect 0 "runs     96" "$gurney" merge job.h5.shards
same long.h5 job.h5
rm job.h5
expect 2 "--mode allocation is for --slurm" "$gurney" submit job.toml --pbs --shards 2 --mode allocation
expect 2 "--time 1-12:00: must be hours:minutes:seconds" "$gurney" submit job.toml --pbs --shards 2 --time 1-12:00
sed 's/^draws = .*/draws = 300/' job.toml > many.toml
expect 0 "GURNEY_SHARDS_BEFORE=1000 sbatch --array=1-200%50 many.sbatch" "$gurney" submit many.toml --slurm --shards 1200 --at-most 50
grep -qx "#SBATCH --array=1-1000%50" many.sbatch || complain "the array has indices that Slurm refuses"
grep -q 'shard "$((SLURM_ARRAY_TASK_ID + ${GURNEY_SHARDS_BEFORE:-0}))/1200"' many.sbatch || complain "the second array does not go on"

# The job and its data are never replaced by an output.
for script in job.toml item.toml a.txt list.csv; do
  cp "$script" before
  expect 1 "$script: is read by this command and cannot be its output too" "$gurney" submit job.toml --slurm --shards 2 --script "$script" --overwrite
  same before "$script"
done
ln job.toml other_name.toml
expect 1 "other_name.toml: is read by this command" "$gurney" submit job.toml --slurm --shards 2 --script other_name.toml --overwrite
cp job.toml q.log
study 1 "q.log: is read by this command" q.log -o q.h5 --overwrite
same job.toml q.log
gone q.h5.parts
cp job.toml q.h5
study 1 "q.h5: is read by this command" q.h5 -o q.h5 --overwrite
same job.toml q.h5
expect 2 "must be one option of the scheduler, such as --partition=short" "$gurney" submit job.toml --slurm --shards 2 --sbatch partition=x
expect 2 "--shards" "$gurney" submit job.toml --slurm

# From the variables of Slurm and Open MPI.
auto() { expect "$1" "$2" variables "${@:3}" "$gurney" run job.toml -o a.h5 --shard auto --resume; }
auto 1 "--shard auto: neither SLURM_ARRAY_TASK_ID nor SLURM_PROCID nor OMPI_COMM_WORLD_RANK is set; give --shard I/N"
auto 1 "--shard auto: the array has 2 tasks with indices from 3 to 5, which are not consecutive" \
  SLURM_ARRAY_TASK_ID=3 SLURM_ARRAY_TASK_MIN=3 SLURM_ARRAY_TASK_MAX=5 SLURM_ARRAY_TASK_COUNT=2
auto 0 "shard    7 of 12" SLURM_ARRAY_TASK_ID=6 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_MAX=11 SLURM_ARRAY_TASK_COUNT=12 SLURM_PROCID=0 SLURM_NTASKS=1
auto 0 "shard    2 of 12" SLURM_PROCID=1 SLURM_NTASKS=12
auto 0 "shard    12 of 12" OMPI_COMM_WORLD_RANK=11 OMPI_COMM_WORLD_SIZE=12
auto 1 "--shard auto: SLURM_NTASKS = 'x' must be a whole number" SLURM_PROCID=1 SLURM_NTASKS=x
for wrong in 0/3 4/3 1/0 a/3 1-3 3 /3 1/ 1/200000; do
  study 2 "--shard: $wrong must be I/N with 1 <= I <= N <= 100000, or auto" job.toml -o b.h5 --shard "$wrong"
done
gone b.h5.shards

# Stages of a study: each rests on all shards of the one before.
sed 's/^duration_s = .*/duration_s = 20/; s/^draws = .*/draws = 4/; s/^scales = .*/measure = "PGA"\nunit = "g"\ncomponent = "h1"\nlevels = [0.1, 1]\nadaptive = { stages = 2, limit_state = "moved" }/' job.toml > staged.toml
cat >> staged.toml <<'TOML'
[[study.limit_state]]
name = "moved"
demand = "peak_displacement"
above = 0.1
unit = "m"
TOML
study 0 "next:" staged.toml -o staged_whole.h5
study 0 "stage    1 is finished here and lacks" staged.toml -o s.h5 --shard 1/2
expect 0 "stage 1 of 3 finished, goes on with --resume" "$gurney" status s.h5.shards
study 0 "stage    1 is finished here and lacks" staged.toml -o s.h5 --shard 1/2 --resume
expect 1 "analysis cases are missing" "$gurney" merge s.h5.shards
study 0 "stage    2 is finished here and lacks" staged.toml -o s.h5 --shard 2/2
study 0 "when all shards are finished: gurney merge" staged.toml -o s.h5 --shard 1/2 --resume
expect 1 "gurney run" "$gurney" merge s.h5.shards
study 0 "when all shards are finished: gurney merge" staged.toml -o s.h5 --shard 2/2 --resume
expect 0 "s.h5" "$gurney" merge s.h5.shards
same staged_whole.h5 s.h5
expect 0 "sbatch --dependency=singleton s.sbatch, in all 3 times" \
  "$gurney" submit staged.toml --slurm --shards 2 --script s.sbatch
expect 0 "a.sbatch" "$gurney" submit staged.toml --slurm --shards 2 --mode allocation --script a.sbatch
grep -q '^for stage in $(seq 3); do$' a.sbatch || complain "an allocation without its stages"
# Its loop, with both shards at once in place of what srun does.
mkdir staged_bin
cat > staged_bin/srun <<'SRUN'
#!/usr/bin/env bash
SLURM_PROCID=0 SLURM_NTASKS=2 "$@" &
SLURM_PROCID=1 SLURM_NTASKS=2 "$@"
code=$?
wait $! && exit "$code"
SRUN
chmod +x staged_bin/srun
expect 0 "a.sbatch" "$gurney" submit staged.toml --slurm --shards 2 --mode allocation --script a.sbatch \
  --overwrite --program "$gurney" -o t.h5
PATH=$PWD/staged_bin:$PATH SLURM_CPUS_PER_TASK=1 SLURM_JOB_ID=1 bash a.sbatch > stdout 2> stderr ||
  complain "an allocation of a study in stages fails"
same staged_whole.h5 t.h5

# What shards cannot do.
study 1 "is a single run, which has no use for --shard" "$2/studies/jobs/icu_ventilator_shake.toml" --shard 1/2
expect 1 "none: is not a folder of shards" "$gurney" merge none
mkdir empty
expect 1 "empty: holds no shards" "$gurney" merge empty

[ "$failures" -eq 0 ] && echo "shards give the bytes of one process"
exit $((failures > 0))
