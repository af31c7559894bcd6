#!/usr/bin/env bash
# `cmake --install`: the program with its data, in a folder that is moved afterwards, gives the same
# bits as that of the build folder, and a program of somebody else embeds the engine.
# usage: install.sh GURNEY SOURCE_FOLDER BUILD_FOLDER CMAKE
set -uo pipefail
gurney=$1 source=$2 build=$3 cmake=$4
. "$source/tests/system/cli/expect.sh"
unset GURNEY_DATA

expect 0 "bin/gurney" "$cmake" --install "$build" --prefix "$folder/first"
mkdir moved
mv first "moved/to here"
prefix="$folder/moved/to here"
installed="$prefix/bin/gurney"

# Nothing knows where it was built: a folder of that name could be anybody's on another machine.
grep -rlaF -e "$source" -e "$build" "$prefix" > stdout && complain "paths of the build are installed"

# Its own data: an item that only this folder has.
cp "$prefix/share/gurney/equipment/items/xu_trolley.toml" \
  "$prefix/share/gurney/equipment/items/only_here.toml"
expect 0 "only_here" "$installed" equipment ls
GURNEY_DATA=$source expect 0 "xu_trolley" "$installed" equipment ls
grep -q only_here stdout && complain "GURNEY_DATA does not go before the folder of the program"
rm "$prefix/share/gurney/equipment/items/only_here.toml"

# Every shipped file is there, and the same bits come out.
for part in equipment groundmotions/records groundmotions/buildings studies/jobs studies/assessment \
    studies/calibration/example; do
  while IFS= read -r -d '' file; do
    cmp -s "$source/$file" "$prefix/share/gurney/$file" || complain "$file is not installed"
  done < <(cd "$source" && find "$part" \( -name '*.toml' -o -name '*.csv' \) -print0)
done
for job in icu_ventilator_shake icu_bay; do
  expect 0 "results" "$installed" run "$prefix/share/gurney/studies/jobs/$job.toml" -o installed.h5 \
    --overwrite --no-figure
  expect 0 "results" "$gurney" run "$source/studies/jobs/$job.toml" -o built.h5 --overwrite --no-figure
  cmp built.h5 installed.h5 || complain "$job: the installed program gives other results"
done

# The Python package finds its module, and the module the data of its folder.
packages="$prefix/lib/python3/dist-packages"
[ -f "$packages/gurney/simulation.py" ] || complain "the Python package is not installed"
if compgen -G "$packages/gurney/_engine.*.so" > /dev/null && /usr/bin/python3 -c 'import h5py, pandas' 2> /dev/null; then
  cp "$prefix/share/gurney/equipment/items/xu_trolley.toml" \
    "$prefix/share/gurney/equipment/items/only_here.toml"
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$packages expect 0 "only_here" /usr/bin/python3 -c "
import gurney, sys
gurney.simulate_job(sys.argv[1]).save('python.h5')
print(gurney.simulate('only_here', settings={'duration_s': 0.1}).outcome, 'only_here')" \
    "$prefix/share/gurney/studies/jobs/icu_bay.toml"
  cmp built.h5 python.h5 || complain "the installed module gives other results"
  rm "$prefix/share/gurney/equipment/items/only_here.toml"
fi

if [ -e "$source/build/workbench/workbench.html" ]; then
  expect 0 "filled.html" "$installed" workbench icu_bed -o filled.html
else
  expect 1 "share/gurney/workbench.html: the page of the workbench is not there" "$installed" workbench -o filled.html
fi

for page in share/man/man1/gurney.1 share/bash-completion/completions/gurney \
    share/zsh/vendor-completions/_gurney; do
  [ -s "$prefix/$page" ] || complain "$page is not installed"
done

# Twenty lines of somebody else.
expect 0 "Build files" "$cmake" -S "$source/tests/system/install/embed" -B embed -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_BUILD_TYPE=Release
expect 0 "embed" "$cmake" --build embed
mkdir single
printf 'Name: bullet\nDescription: made up\nVersion: 1.25\nLibs:\nCflags:\n' > single/bullet.pc
PKG_CONFIG_LIBDIR=$folder/single expect 1 "needs Bullet in double precision" "$cmake" \
  -S "$source/tests/system/install/embed" -B refused -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_DISABLE_FIND_PACKAGE_Bullet=ON
record="$prefix/share/gurney/groundmotions/records/synthetic_3c.csv"
expect 0 "0.5 " embed/embed "$record"
cp stdout embedded
for scale in 0.5 1; do
  printf 'schema = "gurney-job/1"\n[item]\nequipment = "icu_ventilator"\n[excitation.record]\nfile = "%s"\nscale = %s\n' \
    "$record" "$scale" > job.toml
  expect 0 '"peak_displacement"' "$gurney" run job.toml -o job.h5 --overwrite --no-figure --json
  python3 - stdout embedded "$scale" << 'PYTHON' || complain "the embedded engine gives other results"
import json, sys
def found(tree):
    for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ():
        if key == "peak_displacement":
            yield value["value"] if isinstance(value, dict) else value
        yield from found(value)
embedded = dict(line.split() for line in open(sys.argv[2]))
asked = next(found(json.load(open(sys.argv[1]))))
assert float(embedded[sys.argv[3]]) == asked, (embedded, asked)
PYTHON
done

[ "$failures" -eq 0 ] && echo "installed, moved and embedded"
exit $((failures > 0))
