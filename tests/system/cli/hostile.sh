#!/usr/bin/env bash
# Files and names of somebody else, from outside: nothing that a terminal obeys is printed, no file in TMPDIR
# is touched, no library is loaded for a file, and no run is begun that a job could not ask for.
# usage: hostile.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

escape=$'\e]0;owned\a\e[31m'
# quiet ARGUMENTS...: the command prints something, and no escape character
quiet() {
  "$gurney" "$@" > stdout 2> stderr
  [ -s stdout ] || [ -s stderr ] || complain "prints nothing: $*"
  LC_ALL=C grep -q $'[\x1b\x07]' stdout stderr && complain "prints an escape character: $*"
}

cat > study.toml << 'TOML'
schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[excitation.record]
synthetic = { kind = "ricker", period_s = 0.5 }
[settings]
duration_s = 1
[study]
angles_deg = [0, 45]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.3]
TOML
write_ventilator_job run
expect 0 "study.h5" "$gurney" run study.toml -o study.h5
expect 0 "run.h5" "$gurney" run run.toml -o run.h5 --no-figure

# Names on the command line, of files that are there and of such that are not.
for file in study.h5 run.h5 study.toml run.toml; do cp "$file" "$escape.${file/./_}.${file##*.}"; done
for kind in study run; do
  named="$escape.${kind}_h5.h5"
  for command in show show\ --json fragility sensitivity measures compare explain report plot\ fragility \
      replay export\ --to\ csv converge status; do
    # shellcheck disable=SC2086
    quiet $command "$named"
    # shellcheck disable=SC2086
    quiet $command "missing $named"
  done
  quiet check "$escape.${kind}_toml.toml"
  quiet run "$escape.${kind}_toml.toml" -o "$escape.h5" --overwrite
  quiet run "$escape.${kind}_toml.toml" -o "$escape.h5"
done
quiet replay "$escape.study_h5.h5" 0
quiet explain "$escape.study_h5.h5" --run 0
quiet play "$escape.run_h5.h5" -o "$escape.html"
quiet submit "$escape.study_toml.toml" --shards 2
printf 'time,h1\n0,0\n0.01,0.1\n0.02,-0.1\n0.03,0.05\n' > "$escape.csv"
quiet records info "$escape.csv" --unit g
quiet records ls "$escape.csv" --unit g
quiet equipment show "$escape"
quiet calibrate "$escape"
quiet "$escape"
quiet run --"$escape"
quiet plot "$escape" study.h5

# Names within files: titles, items, limit states, values of factors.
escaped='\u001b]0;owned\u0007'
sed "s/^schema.*/&\ntitle = \"$escaped\"/; s/^\[item\]/&\nname = \"a$escaped\"/" study.toml > inside.toml
cat >> inside.toml << TOML
[[study.limit_state]]
name = "b$escaped"
demand = "peak_displacement"
above = 1
unit = "cm"
[[study.factor]]
name = "c$escaped"
[study.factor.level."d$escaped"]
item.brakes = true
[study.factor.level.e]
item.brakes = false
TOML
quiet check inside.toml
quiet run inside.toml -o inside.h5
if [ -e inside.h5 ]; then
  for command in show fragility compare sensitivity measures report; do quiet "$command" inside.h5; done
  quiet explain inside.h5 --run 0
fi

# A file in TMPDIR that has the name of this process: `play` simulates a run of a study again.
mkdir shared
# shellcheck disable=SC2016
TMPDIR=$PWD/shared expect 0 "page.html" bash -c \
  'for name in gurney_$$.h5 gurney_$$ run.h5; do echo mine > "$TMPDIR/$name"; done
   echo $$ > process; exec "$0" play study.h5 --run 0 -o page.html' "$gurney"
for name in "gurney_$(cat process).h5" "gurney_$(cat process)" run.h5; do
  [ "$(cat "shared/$name")" = mine ] || complain "$name in TMPDIR is replaced"
done
[ "$(ls shared | wc -l)" -eq 3 ] || complain "left in TMPDIR: $(ls shared)"

# A file whose checksum is cut off, or no longer at its end.
printf '\n' | cat study.h5 - > longer.h5
head -c -80 study.h5 > cut.h5
for file in longer.h5 cut.h5; do
  expect 0 "$file: caution: no checksum at its end: cut off, or changed by another program" "$gurney" show "$file"
done
"$gurney" show study.h5 > stdout 2> stderr
[ -s stderr ] && complain "a caution on a file as it was written"

if /usr/bin/python3 -c 'import h5py' 2> /dev/null; then
  # crafted NAME: study.h5, changed
  crafted() { cp study.h5 "$1" && /usr/bin/python3 - "$1" > stdout 2> stderr || complain "no $1"; }

  # An intensity that no job may ask for, before the run of 2^31 times the record.
  crafted scaled.h5 << 'PYTHON'
import h5py, sys
with h5py.File(sys.argv[1], "r+") as file:
    file["runs/scale"][0] = 2.0**31
PYTHON
  expect 1 "/runs/scale[0] = 2.14748e+09: must be at most" timeout 60 "$gurney" replay scaled.h5 0 --job study.toml

  # A filter that HDF5 would look for in a folder of libraries: their constructors would run.
  crafted filtered.h5 << 'PYTHON'
import h5py, sys
with h5py.File(sys.argv[1], "r+") as file:
    values, attributes = file["runs/pfa"][:], dict(file["runs/pfa"].attrs)
    del file["runs/pfa"]
    file.create_dataset("runs/pfa", data=values, fletcher32=True).attrs.update(attributes)
data = bytearray(open(sys.argv[1], "rb").read())
at = data.rfind(b"fletcher32\0")
assert data[at - 8:at - 6] == b"\3\0", data[at - 8:at]
data[at - 8:at - 6] = (32700).to_bytes(2, "little")  # of nobody
open(sys.argv[1], "wb").write(data)
PYTHON
  mkdir plugins
  echo '#include <fcntl.h>
__attribute__((constructor)) static void run(void) { open("loaded", O_CREAT | O_WRONLY, 0644); }' |
    "${CC:-cc}" -shared -fPIC -x c - -o plugins/libfilter.so > stdout 2> stderr || complain "no library"
  export HDF5_PLUGIN_PATH=$PWD/plugins
  /usr/bin/python3 -c 'import h5py; h5py.File("filtered.h5")["runs/pfa"][:]' > stdout 2> stderr
  [ -e loaded ] || complain "the library is not loaded by others: this shows nothing"
  rm -f loaded
  for command in show fragility "replay --run 0" report; do
    # shellcheck disable=SC2086
    "$gurney" ${command%% *} filtered.h5 > stdout 2> stderr && complain "$command reads an unknown filter"
    [ -e loaded ] && complain "$command loads a library for a file"
  done
else
  echo "skipped: crafted results, python3-h5py is not here"
fi

[ "$failures" -eq 0 ] && echo "nothing hostile gets through"
exit $((failures > 0))
