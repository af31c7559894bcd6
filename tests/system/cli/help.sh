#!/usr/bin/env bash
# Help, manual page, completion and `gurney doctor`.
# usage: help.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# Every command, as the manual page lists them, has examples and names what its options take.
expect 0 ".TH GURNEY 1" "$gurney" help --man
grep -q "(si, m, cm" stdout && complain "the manual page lists the units twice"
mapfile -t commands < <(sed -n 's/^\.SS gurney //p' stdout)
[ "${#commands[@]}" -gt 25 ] || complain "the manual page has ${#commands[@]} commands"
for command in "${commands[@]}"; do
  [ "$command" = help ] && continue
  # shellcheck disable=SC2086
  expect 0 "Examples:" "$gurney" ${command//\\/} --help
  grep -E 'TEXT|REQUIRED|:INT|FLOAT|UINT' stdout && complain "$command: the help has a word of the library"
  [ "$(wc -L < stdout)" -le 100 ] || complain "$command: the help has long lines"
done
expect 0 "--output FILE" "$gurney" run --help
expect 0 "--threads NUMBER" "$gurney" run --help
export COLUMNS=70
"$gurney" run --help > stdout
[ "$(sed '/^Examples/,$d' stdout | wc -L)" -le 70 ] || complain "COLUMNS does not set the width"
unset COLUMNS

if command -v man > /dev/null; then
  "$gurney" help --man > gurney.1
  MANWIDTH=80 man -l --warnings ./gurney.1 > stdout 2> stderr < /dev/null
  grep -q "Examples\|gurney run studies/jobs" stdout || complain "man does not show the page"
  [ -s stderr ] && complain "man complains of the page"
fi

# completes WORD... = EXPECTED: what bash offers for the last word
completes() {
  local words=() got
  while [ "$1" != = ]; do words+=("$1"); shift; done
  shift
  got=$(COMP_WORDS=("${words[@]}") COMP_CWORD=$((${#words[@]} - 1))
    _gurney
    echo "${COMPREPLY[*]}")
  [ "$got" = "$*" ] || complain "completion of '${words[*]}' is '$got' instead of '$*'"
}
"$gurney" completion bash > completion.bash || complain "no completion for bash"
. ./completion.bash
completes gurney fra = fragility
completes gurney records p = plot
completes gurney records floor --bu = --building
completes gurney equipment show --brakes o = on off
completes gurney export x.h5 --to p = pelicun
completes gurney new j = job
completes gurney run --qu = --quiet
completes gurney run -o x =
completes gurney run x =
complete -p gurney | grep -q default || complain "files are not completed"
"$gurney" completion zsh > _gurney || complain "no completion for zsh"
if command -v zsh > /dev/null; then zsh -n _gurney || complain "zsh refuses its completion"; fi
expect 2 "fish" "$gurney" completion fish

expect 0 "the same bits" "$gurney" doctor
expect 0 '"state": "ok"' "$gurney" doctor --json
python3 -c 'import json, sys
names = [each["name"] for each in json.load(open("stdout"))["findings"]]
assert names == "program libraries cpu arithmetic data threads memory disk figures determinism".split(), names' ||
  complain "doctor --json has other lines"
GURNEY_DATA=/nowhere expect 1 "the catalogue is not there" "$gurney" doctor
expect 0 "HDF5 1." "$gurney" --version
expect 2 "--quiet" "$gurney" run job.toml --quiet --json

[ "$failures" -eq 0 ] && echo "help, manual page and completion are right"
exit $((failures > 0))
