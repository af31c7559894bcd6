#!/usr/bin/env bash
# Options of `gurney records`: empty, without effect or against each other; what is written, and where; what
# is beyond what a record may be.
# usage: record_options.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
record=$2/groundmotions/records/synthetic_3c.csv
. "$2/tests/system/cli/expect.sh"

# records CODE TEXT ARGUMENTS...: what `gurney records` does
records() { expect "$1" "$2" "$gurney" records "${@:3}"; }
absent() { for file in "$@"; do [ ! -e "$file" ] || complain "$file was left"; done; }
target="asce7 sds_g=1 sd1_g=0.6"
scenario="bssa14 magnitude=7 distance_km=10"

# An empty value is none.
printf '1\n2\n-3\n' > plain.txt
records 2 "--distance: must not be empty" model --magnitude 7 --distance ""
records 2 "--seed: must not be empty" select "$record" --target "$scenario" --seed ""
records 2 "--scale-to: must not be empty" convert "$record" -o x.csv --scale-to ""
for option in --unit --time-step --count --columns --step; do
  records 2 "$option: must not be empty" info plain.txt $option ""
  records 2 "$option: must not be empty" info plain.txt $option=
done
records 1 ": no such file or folder" info ""

# Options that exclude each other, or have no effect.
records 2 "--factors excludes --unscaled" select "$record" --target "$scenario" --unscaled --factors 0.5:2
records 2 "--figure-format: has no effect" plot "$record" -o x.svg --figure-format png
records 2 "excludes" make --list -o x.csv
records 2 "excludes" make ac156 --list sds_g=2
records 2 "--json requires --list" make ac156 --json -o x.csv
records 2 "KIND" make
records 2 "-o FILE.csv is required" make ricker period_s=1
records 0 '"kind": "ac156"' make ac156 --list --json
grep -q ricker stdout && complain "another kind than that asked for"
{ printf 'Record Sequence Number,Earthquake Name,Station Name,File Name (Horizontal 1),File Name (Horizontal 2),'
  printf 'File Name (Vertical),Lowest Usable Freq - Ave. Component (Hz),T0.010S,T1.000S,T10.000S\n'
  printf '%s,Event,Station,A.AT2,B.AT2,C.AT2,0.1,0.4,0.5,0.01\n' 1 2; } > flatfile.csv
for option in "--component RotD100" "--unit g" "--time-step 0.01" "--count 1" "--columns samples" \
  "--step taper"; do
  records 1 "${option%% *}: has no effect: a flatfile has spectra" select flatfile.csv --target "$scenario" -n 2 $option
done
records 0 "spectra of the flatfile" select flatfile.csv --target "$scenario" -n 2
absent x.csv x.svg

# Paths may follow an option that is repeated.
records 0 "PGA" info --measure PGA "$record"
records 0 "1 record" ls --step "baseline kind=mean" --step "taper start_s=1" "$record"

# Blanks between brackets are part of a value; a measure is written as `info` prints it.
records 0 "Sa(1, 2%)" info "$record" --measure "Sa(1, 2%)"
records 0 "bracket.csv" convert "$record" -o bracket.csv --scale-to "Sa(1, 2%) value=0.5 unit=g" \
  --step "band_pass corners_hz=[0.1, 25]"

# What is wrong with an option is said of the option, and of a file in the file.
records 2 "--faulting: Reverse not in {unspecified,strike-slip,normal,reverse}" model --magnitude 7 --distance 9 --faulting Reverse
records 2 "--faulting: 2 not in" model --magnitude 7 --distance 9 --faulting 2
records 0 "PGV" model --magnitude 7 --distance 9 --faulting reverse
records 2 "--per-event: -1: must be a number >= 0" select "$record" --target "$scenario" --per-event -1
records 2 "--per-station: -1: must be a number >= 0" select "$record" --target "$scenario" --per-station -1
records 1 "--factors 4:0.25: must be LOW:HIGH" scale "$record" --target "$target" --factors 4:0.25
records 1 "--floor (--storey) -1: must be roof" floor "$record" --building concrete_hospital --storey=-1 -o x.csv
printf 'period_s, sa_g\n0.01, 0.4\n5, x\n' > bad.csv
for command in scale select; do
  records 1 '"file": "bad.csv"' $command "$record" --target "table file=bad.csv" --json
  grep -q '"line": 3' stdout || complain "$command does not state the line of the target's file"
  records 1 "bad.csv:3:4: sa_g 'x': must be a number" $command "$record" --target "table file=bad.csv"
done

# A file that is left out has its place in JSON.
printf 'g; dt=0.01\n1\n2\n3 4\n' > bad.txt
for command in info ls; do
  records 1 '"refused": [' $command bad.txt --json
  python3 - << 'PY' || complain "$command --json does not say where bad.txt is wrong"
import json
[refused] = json.load(open("stdout"))["refused"]
assert refused["file"] == "bad.txt" and refused["reason"], refused
first = refused["errors"][0]
assert (first["file"], first["line"], first["column"]) == ("bad.txt", 4, 1), refused
PY
done
records 1 '"errors": [' floor bad.txt --building concrete_hospital -o x.csv --json
grep -q '"line": ' stdout || complain "floor --json does not say where bad.txt is wrong"

# Where an output cannot be, nothing is computed.
mkdir folder
: > there.csv
for command in "make ricker" "floor $record --building concrete_hospital" "scale $record --target $target" \
  "select $record --target $scenario -n 2"; do
  read -r -a words <<< "$command"
  case $command in *--target*)  # its value is of several words
    words=("${words[0]}" "${words[1]}" --target "$([ "${words[0]}" = scale ] && echo "$target" || echo "$scenario")") ;;
  esac
  for output in "x.at2:must be a file that ends in .csv" "x:must be a file that ends in .csv" "none/z.csv:does not exist" \
    "folder:must be a file that ends in .csv" "there.csv:exists already"; do
    code=1
    case $output in *"must be a file"*) code=2 ;; esac
    records "$code" "${output#*:}" "${words[@]}" -o "${output%%:*}"
    [ -s stdout ] && complain "${words[0]} computes for -o ${output%%:*}"
  done
done
absent x.at2 x

# Figures: all of them or none, and none over another.
mkdir same
cp "$record" same/synthetic_3c.csv
records 1 "two records have this name" plot "$record" same -o figures
absent figures
echo old > old.svg
records 1 "one figure for several records" plot "$record" same -o old.svg --overwrite
[ "$(cat old.svg)" = old ] || complain "old.svg was replaced by one of two figures"

# Spectra below ten samples in a period: one warning for all records of a command.
records 0 "coarse.csv" convert "$record" -o coarse.csv --step "resample time_step_s=0.02"
warned() {  # ARGUMENTS...: it warns once
  records 0 "Sa(0.05 s): the time step of 0.02 s gives fewer than 10 samples in a period" "$@"
  [ "$(grep -c "fewer than 10 samples" stderr)" -eq 1 ] || complain "not one warning: $*"
}
warned scale "$record" coarse.csv --target "$target" --periods 0.05:2
warned select "$record" coarse.csv --target "$scenario" -n 2 --factors 0.01:100
warned convert coarse.csv -o finer.csv --scale-to "Sa(0.05) value=0.5 unit=g"
records 0 "2 of 2 records: Sa(0.02 s): the time step of 0.02 s" plot "$record" coarse.csv -o spectra
records 0 '"warnings": [' scale coarse.csv --target "$target" --periods 0.05:2 --json
grep -q "fewer than 10 samples" stdout || complain "no warning in the JSON of scale"
records 0 "wide.csv" convert coarse.csv -o wide.csv --scale-to "Sa(1) value=0.5 unit=g"
grep -q "fewer than 10 samples" stderr && complain "a warning for Sa(1 s)"

# Nothing is written that cannot be read.
records 1 "cannot be written with a peak of" convert "$record" -o x.csv --scale-to "PGA value=500 unit=g"
records 1 "cannot be written with a peak of" convert "$record" -o at2 --format at2 --scale-to "PGA value=500 unit=g"
records 1 "cannot be written with a peak of" make half_sine pga_g=101 -o x.csv
records 1 "cannot be written with a time step of" convert "$record" -o x.csv --step "window from_s=5 to_s=5.05" \
  --step "resample time_step_s=9e-6"
absent x.csv at2

# A floor that twists moves along both horizontals, also under a record with one.
awk -F, '/^[0-9t]/ {print $1 "," $3}' "$record" > one.csv
awk -F, -v OFS=, '/^[0-9t]/ {print $1, (/^t/ ? "x_m_per_s2" : 0), $3}' "$record" > zero.csv
for ground in one zero; do
  records 0 "h1 " floor $ground.csv --building twisting_hospital --position 20,10 -o roof_$ground.csv
  grep -v '^#' roof_$ground.csv > rows_$ground
done
cmp rows_one rows_zero || complain "a missing horizontal is not one of zeros"
records 1 "--position 1e+06,0: must be within 500 m" floor one.csv --building twisting_hospital --position 1e6,0 -o x.csv

# Floor motions of another program are those of the record as it is.
sed -n '/^[0-9]/p' zero.csv > table.txt
mkdir results
cp table.txt results/one.out
cat > tables.toml << 'END'
schema = "gurney-building/1"
name = "Clinic"
kind = "tables"
floors = ["roof"]
file = "results/{record}.out"
columns = "time, roof h1, roof h2"
unit = "m/s2"
acceleration = "absolute"
END
records 0 "Clinic" floor one.csv --building ./tables.toml -o tables.csv
records 1 "--step: must not go with floor motions of another program" floor one.csv --building ./tables.toml -o x.csv \
  --step "high_pass corner_hz=0.1"
records 1 "--floor (--storey) 1: must be roof" floor one.csv --building ./tables.toml --floor 1 -o x.csv

# Storeys and their response have keys of their own.
records 0 '"storeys": 4' floor "$record" --building yielding_twisting_hospital -o yields.csv --json
grep -q '"storey_response": {' stdout || complain "no response of the storeys"

[ "$failures" -eq 0 ] && echo "all options did as they should"
exit $((failures > 0))
