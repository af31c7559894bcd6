#!/usr/bin/env bash
# Runs the fuzzers of readers (tests/fuzz/*.cpp), each for some seconds, and reports how many inputs
# they were given, and how many branches ("edges") of the program these reached. What they learn is
# kept in the folder fuzz_corpus beside BUILD_FOLDER for the next time, also of another build; an
# input that breaks a reader in BUILD_FOLDER/findings; the program ends with 1 then.
# usage: fuzz.sh BUILD_FOLDER SECONDS [READER...]
#   FUZZ_PROCESSES  at once; default: the number of cores
set -euo pipefail
build=$1 seconds=$2
shift 2
readers=("$@")
if [ $# -eq 0 ]; then
  for program in "$build"/fuzz_*; do readers+=("${program##*/fuzz_}"); done
fi
corpus=$(dirname "$build")/fuzz_corpus
mkdir -p "$build/findings" "$build/log"
rm -rf "$build/seeds"
"$build/write_seeds" "$build/seeds"
if [ -w /dev/shm ]; then export TMPDIR=/dev/shm; fi  # the files that readers open

# words READER: those of its seeds, for libFuzzer to put anywhere
words() {
  cat "$build/seeds/$1"/* | tr '\0' '\n' | LC_ALL=C grep -aoE '[A-Za-z_][A-Za-z0-9_/.-]{2,40}' | sort | uniq -c |
    sort -rn | awk 'NR <= 500 {print "\"" $2 "\""}'
}

# A time-out counts time that other programs of a busy machine take: what is left is CPU time.
only_slow_machine() {  # READER LOG
  local input
  input=$(sed -n 's/^.*Test unit written to //p' "$2" | grep timeout | tail -1)
  [ -n "$input" ] && (ulimit -t 10 && "$build/fuzz_$1" -timeout=0 "$input") > /dev/null 2>&1 && rm -f "$input"
}

# last PATTERN LOG: what sed finds last, or 0
last() {
  local found
  found=$(sed -n "s/$1/\1/p" "$2" | tail -1)
  echo "${found:-0}"
}

# Limits of an input: 10 s of CPU time, and memory of some hundred times the largest one.
fuzz() {
  local reader=$1 code=0 log=$build/log/$1.log
  mkdir -p "$corpus/$reader"
  words "$reader" > "$build/log/$reader.words"
  ASAN_OPTIONS=detect_stack_use_after_return=0:exitcode=99 "$build/fuzz_$reader" -max_total_time="$seconds" -entropic=0 -timeout=30 -rss_limit_mb=2500 \
    -malloc_limit_mb=1000 -print_final_stats=1 -report_slow_units=60 -artifact_prefix="$build/findings/$reader-" -dict="$build/log/$reader.words" \
    "$corpus/$reader" "$build/seeds/$reader" > "$log" 2>&1 || code=$?
  if [ "$code" -eq 70 ] && only_slow_machine "$reader" "$log"; then code=0; fi
  local count edges
  count=$(last '^stat::number_of_executed_units: *\([0-9]*\)' "$log")
  edges=$(last '^#.* cov: \([0-9]*\) .*' "$log")
  printf '%s %s %s %s\n' "$reader" "$count" "$seconds" "$edges" >> "$build/executions"
  if [ "$code" -eq 0 ]; then
    printf '%-15s %11d inputs, %6d edges\n' "$reader" "$count" "$edges"
  else
    printf '%-15s broken, see %s\n' "$reader" "$log"
    grep -aE '^(==[0-9]+==|.*: runtime error|Test unit written|terminate|  what)' "$log" | head -5
    return 1
  fi
}
export -f words only_slow_machine last fuzz
export build seconds corpus

code=0
printf '%s\n' "${readers[@]}" | xargs -P "${FUZZ_PROCESSES:-$(nproc)}" -I {} bash -c 'fuzz {}' || code=1
awk '{s += $3; all += $2} END {printf "in total %d inputs in %.1f hours in this build folder\n", all, s / 3600}' "$build/executions"
exit "$code"
