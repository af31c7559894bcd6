# For the tests of the command line: run in a folder of their own, count failures.

complain() {
  printf 'FAILED: %s\n--- stdout\n%s\n--- stderr\n%s\n' "$1" "$(head -c 2000 stdout)" "$(head -c 2000 stderr)"
  failures=$((failures + 1))
}

# expect CODE TEXT COMMAND...: it exits with CODE and says TEXT somewhere
expect() {
  local code=$1 text=$2
  shift 2
  "$@" > stdout 2> stderr
  local got=$?
  [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*"
  grep -qF -- "$text" stdout stderr || complain "does not say '$text': $*"
}

wait_for() {  # FILE: it is there
  for _ in $(seq 1000); do
    [ -e "$1" ] && return
    sleep 0.01
  done
  complain "$1 does not come"
}

# begin_in PARTS JOB FILE ARGUMENTS...: a study in the background, stopped when its first part is written,
# however fast the machine is: the first run that ends a second after the start writes it, and a
# stopped process has seconds. What is to happen to it then: kill -CONT, or a signal and kill -CONT.
begin_in() {
  "$gurney" run "$2" -o "$3" -j 1 "${@:4}" > out 2> err &
  process=$!
  wait_for "$1/crashes"
  kill -STOP "$process"
  sleep 1
  kill -CONT "$process"
  wait_for "$1/00000001.part"
  kill -STOP "$process"
}
begin() { begin_in "$2.parts" "$@"; }  # JOB FILE ARGUMENTS...

# ends CODE TEXT: what was begun goes on to its end, exits with CODE and says TEXT somewhere
ends() {
  kill -CONT "$process"
  wait "$process"
  local got=$?
  cp out stdout
  cp err stderr
  [ "$got" -eq "$1" ] || complain "exit code $got instead of $1"
  grep -qF -- "$2" stdout stderr || complain "does not say '$2'"
}

unset COLUMNS  # the width of text
failures=0
folder=$(mktemp -d "${TMPDIR:-/tmp}/gurney cli XXXXXX") || exit 1
trap 'chmod -R u+w "$folder"; rm -rf "$folder"' EXIT
cd "$folder" || exit 1

# write_ventilator_job TITLE [PERIOD]: run.toml, a ventilator under a pulse of PERIOD s (0.5); TITLE as TOML
# has it between quotes
write_ventilator_job() {
  cat > run.toml << TOML
schema = "gurney-job/1"
title = "$1"
[item]
equipment = "icu_ventilator"
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.3, period_s = ${2:-0.5} }
use = "x"
TOML
}
