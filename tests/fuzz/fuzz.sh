#!/usr/bin/env bash
# Runs the fuzzers of readers (tests/fuzz/*.cpp), each for some seconds, and reports how many inputs
# they were given. What they learn is kept in BUILD_FOLDER/corpus for the next time, and an input
# that breaks a reader in BUILD_FOLDER/findings; the program ends with 1 then.
# usage: fuzz.sh BUILD_FOLDER SECONDS [READER...]
set -euo pipefail
build=$1 seconds=$2
shift 2
readers=("$@")
if [ $# -eq 0 ]; then
  for program in "$build"/fuzz_*; do readers+=("${program##*/fuzz_}"); done
fi
mkdir -p "$build/findings" "$build/log"
rm -rf "$build/seeds"
"$build/write_seeds" "$build/seeds"

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

# Limits of an input: 10 s of CPU time, and memory of some hundred times the largest one.
fuzz() {
  local reader=$1 code=0
  mkdir -p "$build/corpus/$reader"
  words "$reader" > "$build/log/$reader.words"
  ASAN_OPTIONS=detect_stack_use_after_return=0:exitcode=99 "$build/fuzz_$reader" -max_total_time="$seconds" -timeout=30 -rss_limit_mb=2500 \
    -malloc_limit_mb=1000 -print_final_stats=1 -report_slow_units=60 -artifact_prefix="$build/findings/$reader-" -dict="$build/log/$reader.words" \
    "$build/corpus/$reader" "$build/seeds/$reader" > "$build/log/$reader.log" 2>&1 || code=$?
  if [ "$code" -eq 70 ] && only_slow_machine "$reader" "$build/log/$reader.log"; then code=0; fi
  local count
  count=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/log/$reader.log")
  printf '%s %s %s\n' "$reader" "${count:-0}" "$seconds" >> "$build/executions"
  if [ "$code" -eq 0 ]; then
    printf '%-15s %11d inputs\n' "$reader" "$count"
  else
    printf '%-15s broken, see %s\n' "$reader" "$build/log/$reader.log"
    grep -aE '^(==[0-9]+==|.*: runtime error|Test unit written|terminate|  what)' "$build/log/$reader.log" | head -5
    return 1
  fi
}
export -f words only_slow_machine fuzz
export build seconds

code=0
printf '%s\n' "${readers[@]}" | xargs -P "$(nproc)" -I {} bash -c 'fuzz {}' || code=1
awk '{n[$1] += $2; s += $3; all += $2} END {printf "in total %d inputs in %.1f hours in this build folder\n", all, s / 3600}' "$build/executions"
exit "$code"
