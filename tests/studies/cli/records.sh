#!/usr/bin/env bash
# `gurney records` from outside: exit codes, messages, and the files that are left.
# usage: records.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
record=$2/groundmotions/records/synthetic_3c.csv
building=$2/groundmotions/buildings/lead_rubber_hospital.toml
. "$2/tests/studies/cli/expect.sh"

# records CODE TEXT ARGUMENTS...: what `gurney records` does
records() { expect "$1" "$2" "$gurney" records "${@:3}"; }

records 2 "A subcommand is required"
records 2 "PATH is required" info
records 1 "none.csv: no such file or folder" info none.csv
printf '1\n2\n-3\n' > plain.txt
records 1 'state it as unit = "..."' info plain.txt
records 0 "synthetic_3c" ls "$record"
records 0 "1 record" ls plain.txt --unit g --time-step 0.01
records 0 "residual velocity, from rest" info "$record"
records 0 '"refused": []' info "$record" --json
records 1 "did you mean 'high_pass'?" info "$record" --step "high_pas corner_hz=0.1"
records 1 "unknown key" info "$record" --step "high_pass corner_hz=0.1 ordr=4"
records 1 "must be key=value" info "$record" --step "high_pass 0.1"

# A folder goes on after what it cannot read.
mkdir mixed
cp "$record" mixed/a.csv
printf 'hello\n' > mixed/notes.txt
records 0 "1 record, 1 left out" ls mixed
grep -q 'mixed/notes.txt:1:1: not a record in a known format' stderr || complain "no reason for notes.txt"
records 1 "not a record in a known format" ls mixed/notes.txt "$record"

# What is converted reads back as the same motion.
records 0 "b.csv" convert "$record" -o b.csv
records 1 "b.csv: exists already" convert "$record" -o b.csv
records 0 "b.csv" convert "$record" -o b.csv --overwrite
diff <("$gurney" records ls "$record" | cut -c 31-) <("$gurney" records ls b.csv | cut -c 31-) ||
  complain "a converted record is another one"
mkdir at2
records 0 "at2/synthetic_3c_UP.AT2" convert "$record" --format at2 -o at2
records 0 "PEER AT2" ls at2
records 1 "must be a file that ends in .csv, or a folder" convert "$record" -o nowhere
records 1 "one file for several records" convert "$record" mixed/a.csv -o c.csv
[ ! -e c.csv ] || complain "c.csv was left"

records 0 "p.svg" plot "$record" -o p.svg
grep -q "RotD50" p.svg || complain "no spectrum in the figure"
records 0 "ricker" make --list
records 0 "period_s" make ricker --list
records 0 "ricker.csv" make ricker period_s=0.5 -o ricker.csv
grep -q "synthetic: never recorded" ricker.csv || complain "a synthetic motion does not say so"
records 1 "did you mean" make rickr -o x.csv
records 1 "perod_s" make ricker perod_s=1 -o x.csv
[ ! -e x.csv ] || complain "x.csv was left"

records 0 "isolators" floor "$record" --building "$building" -o roof.csv
grep -q "energy closes" roof.csv || complain "the building is not in the processing of its floor"
records 1 "--floor 9: must be roof, or a number from 0 to 4" floor "$record" --building "$building" --floor 9 -o x.csv

records 0 "misfit of the mean" scale "$record" --target "eurocode8 ground=B ag_g=0.3" -o suite.csv --figure suite.svg
records 0 "1 record" ls suite.csv
records 1 "did you mean 'asce7'?" scale "$record" --target "asce sds_g=1"
records 1 "must be LOW:HIGH" scale "$record" --target "asce7 sds_g=1 sd1_g=0.6" --periods 2

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
