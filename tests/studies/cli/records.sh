#!/usr/bin/env bash
# `gurney records` from outside: exit codes, messages, and the files that are left.
# usage: records.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
record=$2/groundmotions/records/synthetic_3c.csv
building=$2/groundmotions/buildings/lead_rubber_hospital.toml
folder=$(mktemp -d "${TMPDIR:-/tmp}/gurney records XXXXXX") || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

complain() {
  printf 'FAILED: %s\n--- stdout\n%s\n--- stderr\n%s\n' "$1" "$(head -c 2000 stdout)" "$(head -c 2000 stderr)"
  failures=$((failures + 1))
}

# expect CODE TEXT COMMAND...: it exits with CODE and says TEXT somewhere
expect() {
  local code=$1 text=$2
  shift 2
  "$gurney" records "$@" > stdout 2> stderr
  local got=$?
  [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: records $*"
  grep -qF -- "$text" stdout stderr || complain "does not say '$text': records $*"
}

expect 2 "A subcommand is required"
expect 2 "PATH is required" info
expect 1 "none.csv: no such file or folder" info none.csv
printf '1\n2\n-3\n' > plain.txt
expect 1 'state it as unit = "..."' info plain.txt
expect 0 "synthetic_3c" ls "$record"
expect 0 "1 records" ls plain.txt --unit g --time-step 0.01
expect 0 "residual velocity, from rest" info "$record"
expect 0 '"refused": []' info "$record" --json
expect 1 "did you mean 'high_pass'?" info "$record" --step "high_pas corner_hz=0.1"
expect 1 "unknown key" info "$record" --step "high_pass corner_hz=0.1 ordr=4"
expect 1 "must be key=value" info "$record" --step "high_pass 0.1"

# A folder goes on after what it cannot read.
mkdir mixed
cp "$record" mixed/a.csv
printf 'hello\n' > mixed/notes.txt
expect 0 "1 records, 1 left out" ls mixed
grep -q 'mixed/notes.txt:1:1: not a record in a known format' stderr || complain "no reason for notes.txt"
expect 1 "not a record in a known format" ls mixed/notes.txt "$record"

# What is converted reads back as the same motion.
expect 0 "b.csv" convert "$record" -o b.csv
expect 1 "b.csv: exists already" convert "$record" -o b.csv
expect 0 "b.csv" convert "$record" -o b.csv --overwrite
diff <("$gurney" records ls "$record" | cut -c 31-) <("$gurney" records ls b.csv | cut -c 31-) ||
  complain "a converted record is another one"
mkdir at2
expect 0 "at2/synthetic_3c_UP.AT2" convert "$record" --format at2 -o at2
expect 0 "PEER AT2" ls at2
expect 1 "must be a file that ends in .csv, or a folder" convert "$record" -o nowhere
expect 1 "one file for several records" convert "$record" mixed/a.csv -o c.csv
[ ! -e c.csv ] || complain "c.csv was left"

expect 0 "p.svg" plot "$record" -o p.svg
grep -q "RotD50" p.svg || complain "no spectrum in the figure"
expect 0 "ricker" make --list
expect 0 "period_s" make ricker --list
expect 0 "ricker.csv" make ricker period_s=0.5 -o ricker.csv
grep -q "synthetic: never recorded" ricker.csv || complain "a synthetic motion does not say so"
expect 1 "did you mean" make rickr -o x.csv
expect 1 "perod_s" make ricker perod_s=1 -o x.csv
[ ! -e x.csv ] || complain "x.csv was left"

expect 0 "isolators" floor "$record" --building "$building" -o roof.csv
grep -q "energy closes" roof.csv || complain "the building is not in the processing of its floor"
expect 1 "--floor 9: must be roof, or a number from 0 to 4" floor "$record" --building "$building" --floor 9 -o x.csv

expect 0 "misfit of the mean" scale "$record" --target "eurocode8 ground=B ag_g=0.3" -o suite.csv --figure suite.svg
expect 0 "1 records" ls suite.csv
expect 1 "did you mean 'asce7'?" scale "$record" --target "asce sds_g=1"
expect 1 "must be LOW:HIGH" scale "$record" --target "asce7 sds_g=1 sd1_g=0.6" --periods 2

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
