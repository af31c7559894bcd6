#!/usr/bin/env bash
# `gurney records` from outside: exit codes, messages, and the files that are left.
# usage: records.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
record=$2/groundmotions/records/synthetic_3c.csv
building=$2/groundmotions/buildings/lead_rubber_hospital.toml
. "$2/tests/system/cli/expect.sh"

# records CODE TEXT ARGUMENTS...: what `gurney records` does
records() { expect "$1" "$2" "$gurney" records "${@:3}"; }

records 2 "A subcommand is required"
records 2 "PATH is required" info
records 1 "none.csv: no such file or folder" info none.csv
printf '1\n2\n-3\n' > plain.txt
records 1 'state it as unit = "..."' info plain.txt
records 0 "synthetic_3c" ls "$record"
records 0 "1 record" ls plain.txt --unit g --time-step 0.01
records 0 "h2 is missing: the record has one horizontal" info plain.txt --unit g --time-step 0.01
printf 'time_s,z_g\n0,1\n1,2\n' > up.csv
records 0 "h1 and h2 are missing: the record has no horizontal" info up.csv
records 0 "residual velocity, from rest" info "$record"
records 0 '"refused": []' info "$record" --json
records 0 'Sa(0.3)' info "$record" --measure "Sa(0.3)" --measure PGV
records 1 "did you mean" info "$record" --measure PGW
records 0 "PGV" model --magnitude 7 --distance 20 --vs30 400
records 1 "magnitude 9: must be from 3 to 8.5" model --magnitude 9 --distance 20
records 1 "period 20 s: must be 0 or from 0.01 to 10 s" model --magnitude 7 --distance 20 --period 20
records 1 "did you mean 'high_pass'?" info "$record" --step "high_pas corner_hz=0.1"
records 1 "unknown key" info "$record" --step "high_pass corner_hz=0.1 ordr=4"
records 1 "must be key=value" info "$record" --step "high_pass 0.1"

# A folder goes on after what it cannot read.
mkdir mixed
cp "$record" mixed/a.csv
printf 'hello\n' > mixed/notes.txt
records 0 "1 record, 1 skipped" ls mixed
grep -q 'mixed/notes.txt:1:1: not a record in a known format' stderr || complain "no reason for notes.txt"
records 1 "not a record in a known format" ls mixed/notes.txt "$record"

records 1 '--step "high_pass corner_hz=-1": corner_hz = -1: must be' info "$record" --step "high_pass corner_hz=-1"
records 1 '--target "asce sds_g=1": target = "asce": must be one of' scale "$record" --target "asce sds_g=1"
expect 2 "unknown command 'rum'; did you mean 'run'?" "$gurney" rum
expect 2 "unknown command 'inf'; did you mean 'info'?" "$gurney" records inf "$record"
expect 0 "--target" "$gurney" help records scale
if [ -c /dev/full ]; then
  "$gurney" records info "$record" > /dev/full 2> stderr
  [ $? -eq 1 ] || complain "a full disk is no error"
  grep -q "cannot write" stderr || complain "no word of a full disk"
fi

# What a record should be known for is reported by every command.
printf 'time_s,x_m_per_s2\n0,0\n0.01,100\n0.02,-100\n0.03,0\n' > huge.csv
records 0 "warning: huge: " convert huge.csv -o huge_2.csv
records 0 "warning: huge: " plot huge.csv -o huge.svg
records 1 "no record is left to scale" scale huge.csv --target "asce7 sds_g=1 sd1_g=0.6"

# What is converted reads back as the same motion.
records 0 "b.csv" convert "$record" -o b.csv
records 1 "b.csv: exists already" convert "$record" -o b.csv
records 0 "b.csv" convert "$record" -o b.csv --overwrite
records 0 " $(sha256sum "$record" | cut -c 1-8) " ls "$record"
# All of the line but the name and the hash.
values() { "$gurney" records ls "$1" | cut -c 27- | sed 's/  [0-9a-f]\{8\} //'; }
diff <(values "$record") <(values b.csv) ||
  complain "a converted record is another one"
records 1 "b.csv: the record is read from this file" convert b.csv -o b.csv --overwrite
{ printf '# h1: azimuth 318 deg\n# h1: start 1994-01-17T12:30:55.000Z\n'; cat huge.csv; } > where.csv
records 0 "where_2.csv" convert where.csv -o where_2.csv
grep -q '^# h1: azimuth 318 deg$' where_2.csv || complain "the azimuth is lost"
grep -q '^# h1: start 1994-01-17T12:30:55.000Z$' where_2.csv || complain "the start is lost"
# A scaled record has the value that was asked for, and says what was done.
records 0 "scaled.csv" convert "$record" -o scaled.csv --scale-to "PGA component=h1 value=0.5 unit=g vertical=kept"
records 0 '0.5   0.375      0.2' ls scaled.csv  # 0.4, 0.3 and 0.2 g before
grep -q "^# processing: .*PGA (h1)" scaled.csv || complain "scaled.csv does not say how it was scaled"
records 0 "scaled_2.csv" convert "$record" -o scaled_2.csv --scale-to "measure=Sa(1.0) component=RotD50 value=0.6 unit=g"
records 0 "     0.6 " ls scaled_2.csv  # Sa(1), RotD50
records 1 '--scale-to "Sa(1.0) value=1 unit=m": unit = "m": must be one of' convert "$record" -o x.csv --scale-to "Sa(1.0) value=1 unit=m"
records 1 "D5-95" convert "$record" -o x.csv --scale-to "D5-95 value=5 unit=s"
records 1 "must be key=value" convert "$record" -o x.csv --scale-to "Sa(1.0) 0.6"
records 1 "has no component h2, needed for PGA geomean" convert huge.csv -o x.csv --scale-to "PGA value=0.5 unit=g"
[ ! -e x.csv ] || complain "x.csv was left"
mkdir at2
records 0 "at2/synthetic_3c_UP.AT2" convert "$record" --format at2 -o at2
records 0 "PEER AT2" ls at2
records 0 "made_folder/synthetic_3c.csv" convert "$record" -o made_folder
records 0 "made_folder/synthetic_3c_UP.AT2" convert "$record" --format at2 -o made_folder/
records 2 "must be a file that ends in .csv, or a folder" convert "$record" -o c.txt
records 2 "AT2 files hold one component each" convert "$record" --format at2 -o c.csv
records 1 "the folder none does not exist" convert "$record" -o none/folder
records 0 "figures/synthetic_3c.svg" plot "$record" -o figures
records 2 "must end in .svg" plot "$record" -o c.jpg
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
records 0 "vertical amplified" floor "$record" --building lead_rubber_hospital --floor 3 -o named.csv
records 0 "vertical amplified" floor "$record" --building lead_rubber_hospital --floor 3 -o named2.csv --json
records 1 "--building lead_ruber_hospital: unknown building; did you mean 'lead_rubber_hospital'?" \
  floor "$record" --building lead_ruber_hospital -o x.csv
wall=$2/groundmotions/buildings/wall_hospital.toml
records 0 "rotation along it [rad]" floor "$record" --building "$wall" -o wall_roof.csv
grep -q "the floor rotates: peak" wall_roof.csv || complain "the rotation is not in the floor's processing"
records 0 "peak_dip_rad" floor "$record" --building "$wall" -o wall_roof2.csv --json
records 1 "--floor (--storey) 9: must be roof, or a number from 0 to 4" floor "$record" --building "$building" --floor 9 -o x.csv

records 0 "misfit of the mean" scale "$record" --target "eurocode8 ground=B ag_g=0.3" -o suite.csv --figure suite.svg
records 0 "1 record" ls suite.csv
records 1 "did you mean 'asce7'?" scale "$record" --target "asce sds_g=1"
records 1 "convert the records with the steps first" scale "$record" --target "eurocode8 ground=B ag_g=0.3" --step "high_pass corner_hz=0.1" -o suite_2.csv
[ ! -e suite_2.csv ] || complain "a list without the steps was written"
# In resonance with a long sine of 0.4 g, Sa = 0.4 g / (2 damping) = 10 g at 2 %. The target is
# 0.3 x 1.2 x 2.5 sqrt(10 / 7) = 1.0757 g: factor 0.108 (0.269 with a spectrum of 5 %).
records 0 "sine.csv" make harmonic frequency_hz=4 duration_s=60 -o sine.csv
records 0 " 0.108 " scale sine.csv --target "eurocode8 ground=B ag_g=0.3 damping_ratio=0.02" --component h1 --periods 0.2499:0.2501 --limits 0.01:10
grep -q "h1 spectra of 2 % damping" stdout || complain "scale does not state the damping"
records 1 "must be LOW:HIGH" scale "$record" --target "asce7 sds_g=1 sd1_g=0.6" --periods 2

# Selection: 12 of 30 motions, the same again, and other ones of another seed.
mkdir pool
for seed in $(seq 30); do
  "$gurney" records make stochastic seed="$seed" frequency_hz=$((seed % 5 + 1)) -o "pool/$seed.csv" > stdout 2> stderr ||
    complain "no motion $seed"
done
scenario="magnitude=7 distance_km=10 vs30_m_per_s=400"
given="conditional $scenario period_s=1 sa_g=0.6"
records 0 "12 records of 30 selected" select pool --target "$given" -n 12 --factors 0.05:20 -o chosen.csv --figure chosen.svg
grep -q "target Sa(1 s) = 0.6 g, epsilon" stdout || complain "the target is not stated"
grep -q "97.5 %" chosen.svg || complain "no fractiles in the figure"
records 0 "12 records" ls chosen.csv
# Sa(1), RotD50, of each is the given one.
[ "$(grep -c ' 0\.6  ' stdout)" -eq 12 ] || complain "a selected record does not have Sa(1 s) = 0.6 g"
cp chosen.csv again.csv
records 0 "12 records of 30" select pool --target "$given" -n 12 --factors 0.05:20 -o again.csv --overwrite
cmp -s chosen.csv again.csv || complain "the same selection is another one"
records 0 "12 records of 30" select pool --target "$given" -n 12 --factors 0.05:20 --seed 2 -o again.csv --overwrite
cmp -s chosen.csv again.csv && complain "another seed gives the same list"
records 1 "exists already" select pool --target "$given" -n 12 --factors 0.05:20 -o again.csv
records 0 '"excluded_by_factor": 0' select pool --target "$given" -n 12 --factors 0.05:20 --json
records 0 "--per-event: 30 of 30 records do not state theirs" select pool --target "bssa14 $scenario" -n 5 --per-event 1
records 0 "geomean spectra of 5 % damping" select pool --target "bssa14 $scenario" -n 5 --component geomean --unscaled
records 1 "30 of 30 records are there: 40 are to be selected" select pool --target "bssa14 $scenario" -n 40
records 1 "of 30 records have a factor from 0.99 to 1.01" select pool --target "$given" -n 12 --factors 0.99:1.01
records 1 '--target "conditional magnitude=9 distance_km=10 period_s=1 epsilon=1": magnitude = 9: must be' \
  select pool --target "conditional magnitude=9 distance_km=10 period_s=1 epsilon=1"
records 1 "needs epsilon or sa_g, one of the two" select pool --target "conditional $scenario period_s=1"
records 1 "did you mean 'conditional'?" select pool --target "conditonal $scenario"
records 1 "must be LOW:HIGH" select pool --target "bssa14 $scenario" --factors 2
records 1 "convert the records with the steps first" select pool --target "bssa14 $scenario" -o x.csv \
  --step "high_pass corner_hz=0.1"
printf 'period_s, sa_g, sigma_ln\n0.05, 0.4, 0.6\n1, 0.6, x\n5, 0.05, 0.7\n' > median.csv
records 1 "median.csv:3:9: sigma_ln 'x': must be a number" select pool --target "table file=median.csv"
sed -i 's/x/0.0/' median.csv
records 0 "table median.csv, conditional on Sa(1 s)" select pool -n 12 --factors 0.05:20 \
  --target "table file=median.csv period_s=1"
printf 'poe,stat,period,mea,std\n0.02,mean,0.05,0.4,0.6\n0.02,mean,5,0.05,0.7\n' > openquake.csv
records 0 "OpenQuake openquake.csv" select pool -n 5 --target "openquake file=openquake.csv"
records 1 "poe 0.1: must be one of 0.02" select pool -n 5 --target "openquake file=openquake.csv poe=0.1"

records 0 "Sa(5 s) = 0.1 g" select pool --target "conditional $scenario period_s=5 sa_g=0.1" -n 2 --factors 0.001:1000

# Real records, of six earthquakes that PEER names, at most one of each.
if [ -n "${GURNEY_RECORDS:-}" ]; then
  records 0 '"event": "Chi-Chi Taiwan, 9/20/1999"' select "$GURNEY_RECORDS/peer_nga_at2" --target "bssa14 $scenario" \
    -n 6 --per-event 1 --factors 0.05:20 --json
  [ "$(grep '"event"' stdout | sort -u | wc -l)" -eq 6 ] || complain "two records of one earthquake"
fi

# A flatfile: three records, of which one is not usable to 5 s; the files come later.
{ printf 'Record Sequence Number,Earthquake Name,Station Name,File Name (Horizontal 1),File Name (Horizontal 2),'
  printf 'File Name (Vertical),Lowest Usable Freq - Ave. Component (Hz),T0.010S,T1.000S,T10.000S\n'
  for n in 1 2 3; do
    printf '%s,Event %s,Station,Q\\A.AT2,Q\\B.AT2,Q\\C.AT2,0.%s,0.4,0.5,0.0%s\n' $n $n $n $n
  done; } > flatfile.csv
records 0 "2 records of 2 selected" select flatfile.csv --target "bssa14 $scenario" -n 2 -o flat.csv --periods 0.05:5
grep -q "1 records are excluded: not usable up to the longest period" stderr || complain "record 3 is not excluded"
grep -q "the files of 2 selected records are not in the folder" stderr || complain "no note of absent files"
grep -q '^"RSN1","RSN1_Q_A.AT2;RSN1_Q_B.AT2;RSN1_Q_C.AT2"' flat.csv || complain "the list does not name the files"

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
