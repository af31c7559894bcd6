#!/usr/bin/env bash
# gurney show and gurney export from outside: exit codes, messages, and the files that are left.
# usage: export.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# folder NAME FILE...: the folder holds these files and no other
folder_holds() {
  local name=$1 want got
  shift
  want=$(printf '%s\n' "$@" | sort)
  got=$(find "$name" -mindepth 1 -printf '%f\n' 2> /dev/null | sort)
  [ "$got" = "$want" ] || complain "$name holds '$got' instead of '$want'"
}

"$gurney" run "$2/studies/jobs/trolley_levels.toml" -o study.h5 > stdout 2> stderr ||
  complain "the study does not run"

expect 0 "a study of 30 runs" "$gurney" show study.h5
expect 0 "0.1 g, 0.15 g, 0.2 g" "$gurney" show study.h5
expect 0 "were repeated with half the step" "$gurney" show study.h5
expect 0 '"filetype": "gurney-study"' "$gurney" show study.h5 --json
expect 1 "nothing.h5: no such file" "$gurney" show nothing.h5
expect 1 "trolley_levels.toml: is not a results file of gurney" "$gurney" show \
  "$2/studies/jobs/trolley_levels.toml"
expect 2 "FILE is required" "$gurney" show

expect 0 "omitted 'overturned': no run exceeds" "$gurney" export study.h5 --to pelicun
folder_holds study_pelicun fragility.csv fragility.json fragility_cautions.csv
expect 1 "study_pelicun/fragility.csv: exists already" "$gurney" export study.h5 --to pelicun
expect 0 "wrote    study_pelicun/fragility.csv" "$gurney" export study.h5 --to pelicun --overwrite
expect 0 "wrote    other/moved.xml" "$gurney" export study.h5 --to nrml -o other/
folder_holds other moved.xml
expect 0 "wrote    study_response-csv/response.csv" "$gurney" export study.h5 --to response-csv
expect 0 "wrote    study_csv/items.csv" "$gurney" export study.h5 --to csv

# What goes wrong leaves nothing.
expect 1 "did you mean 'moved'" "$gurney" export study.h5 --to nrml --limit moed -o new
expect 2 "openquake: the format for it is nrml" "$gurney" export study.h5 --to openquake
expect 2 "not in {csv,pelicun,nrml,response-csv,trials,xdmf,gltf,mjcf,urdf,job}; did you mean 'pelicun'?" "$gurney" export study.h5 --to pelicn
expect 1 "take one of these with --measure: 'PGA larger'" "$gurney" export study.h5 --to nrml \
  --measure pfa -o new
expect 1 "no run exceeds" "$gurney" export study.h5 --to pelicun --limit hit -o new
expect 1 "no configuration 'locked'" "$gurney" export study.h5 --to pelicun \
  --configuration locked -o new
expect 2 "--limit cannot be combined with --to csv" "$gurney" export study.h5 --to csv --limit hit -o new
expect 1 "the folder none does not exist" "$gurney" export study.h5 --to csv -o none/new
expect 1 "study.h5: is a file, the name of a folder is needed" "$gurney" export study.h5 --to csv \
  -o study.h5
expect 1 "tables.csv: is named like a file, but several are written: name a folder (-o tables)" \
  "$gurney" export study.h5 --to csv -o tables.csv
[ ! -e tables.csv ] || complain "a folder was named like a file"
expect 2 "svg" "$gurney" export study.h5 --to svg
expect 2 "--to is required" "$gurney" export study.h5
# shellcheck disable=SC2317
full_disk() { (ulimit -f 2; "$gurney" export study.h5 --to csv -o new); }  # 2 kB, less than a table
expect 1 "cannot be written, nothing was kept: File too large" full_disk
[ -e new ] && complain "an export that failed left its folder"

# A file of one run has tables, but no curves.
sed "s|file = \"../../|file = \"$2/|" "$2/studies/jobs/icu_ventilator_shake.toml" > one.toml
"$gurney" run one.toml -o one.h5 --no-figure > stdout 2> stderr || complain "the run does not run"
expect 0 "one run" "$gurney" show one.h5
expect 0 "wrote    one_csv/histories_time.csv" "$gurney" export one.h5 --to csv
expect 0 "wrote    one_xdmf/one.xdmf" "$gurney" export one.h5 --to xdmf
expect 0 "wrote    one_gltf/one.gltf" "$gurney" export one.h5 --to gltf
if command -v python3 > python3.path; then
  python3 "$2/tests/system/cli/gltf_structure.py" one_gltf/one.gltf > stdout 2> stderr ||
    complain "one.gltf is not as glTF 2.0 demands"
  # What is wrong is found: a maximum, a length, a time.
  for change in 's/"max":\[[^]]*\]/"max":[9,9,9]/' 's/"byteLength":[0-9]*,"uri"/"byteLength":7,"uri"/' \
    's/"count":[0-9]*/"count":1000000/'; do
    sed "$change" one_gltf/one.gltf > wrong.gltf
    cmp -s one_gltf/one.gltf wrong.gltf && complain "$change changes nothing"
    python3 "$2/tests/system/cli/gltf_structure.py" wrong.gltf > stdout 2> stderr && complain "$change is not found"
  done
fi
expect 1 "not the results file of a single run" "$gurney" export study.h5 --to gltf -o new
folder_holds one_xdmf one.xdmf one_shapes.h5
expect 1 "study.h5: holds many runs; make the one to be seen with gurney replay" "$gurney" export \
  study.h5 --to xdmf -o new
expect 2 "--configuration cannot be combined with --to xdmf" "$gurney" export one.h5 --to xdmf \
  --configuration a -o new
head -n 1 one_csv/histories_time.csv > stdout
grep -q 'displacement.*\.x,' stdout || complain "histories have no column for x"
expect 1 "one.h5: is the file of one run" "$gurney" export one.h5 --to pelicun -o new

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
