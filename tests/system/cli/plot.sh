#!/usr/bin/env bash
# gurney plot, and the formats of figures, from outside.
# usage: plot.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

write_ventilator_job '<b>'\''quoted'\'' & \"more\"</b>'
{
  cat run.toml
  cat << 'TOML'
[study]
measures = "PGA h1"
[study.keep]
histories = "all"
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.2, 0.4]
[[study.factor]]
name = "brakes"
[study.factor.level.off]
item.brakes = false
[study.factor.level.on]
item.brakes = true
TOML
} > study.toml

expect 2 "--figure-format eps: must be svg, pdf or png" "$gurney" run run.toml --figure-format eps
expect 2 "width 'wide': must be a number with its unit" "$gurney" run run.toml --width wide
[ -e out ] && complain "a run was made for a figure that cannot be"
expect 0 "run.pdf" "$gurney" run run.toml -o run.h5 --figure-format pdf
[ "$(head -c 5 run.pdf)" = "%PDF-" ] || complain "run.pdf is no PDF"
expect 0 "study.h5" "$gurney" run study.toml -o study.h5
for words in "share of the runs that exceed a limit state" "next:    gurney show study.h5" \
  "gurney compare study.h5" "gurney report study.h5 -o study.html" "parameters with a range keep their values"; do
  grep -qF "$words" stdout || complain "the end of a study lacks '$words'"
done
expect 0 "uncertainties not propagated, parameters with a range" "$gurney" show study.h5
grep -q "chassis.mass_kg" stdout || complain "show does not list what was not drawn"

plot() { expect "$1" "$2" "$gurney" plot "${@:3}"; }
plot 2 "no figure 'histroy'; did you mean 'history'?" run.h5 histroy
plot 2 "a figure needs its kind; gurney plot run.h5 --list" run.h5 -o x.svg
plot 2 "a figure needs -o FILE.svg, .pdf or .png; gurney plot run.h5 --list" run.h5 history
plot 2 "the file comes first: gurney plot run.h5 history" history run.h5 -o x.svg
plot 2 "the file comes first: gurney plot run.h5 KIND displacement" displacement run.h5 -o x.svg
plot 2 "--width '85': must be a number with its unit" run.h5 history -o x.svg --width 85
plot 0 "normal_force" run.h5 --list
plot 0 "intensity measures (--measure): PGA h1" study.h5 --list
plot 0 "h.svg" run.h5 history displacement normal_force -o h.svg
grep -q "&lt;b&gt;&#39;quoted&#39; &amp;" h.svg || complain "the title is not text"
plot 0 "t.png" run.h5 trajectories -o t.png --width 85mm
plot 0 "h2.svg" study.h5 history tilt --run 3 -o h2.svg
plot 0 "t.svg" study.h5 trajectories -o t.svg
for kind in fragility ida stripes cloud cdf; do
  plot 0 "$kind.pdf" study.h5 "$kind" -o "$kind.pdf" --width 85mm --font-size 7
  # 85 mm are 240.94 pt.
  grep -aq "MediaBox \[ 0 0 240.9" "$kind.pdf" || complain "$kind.pdf is not 85 mm wide"
done
plot 1 "the study drew no numbers" study.h5 tornado -o x.svg
plot 0 "spectra.pdf" study.h5 spectra --level 2 -o spectra.pdf
plot 0 "records.svg" study.h5 spectra records -o records.svg
plot 1 "no spectra of the floor: the study has no building" study.h5 spectra floor -o x.svg
plot 1 "has no level 4; it has 3" study.h5 spectra --level 4 -o x.svg
plot 1 "no item hit anything" study.h5 collisions -o x.svg
cat > wall.toml << 'TOML'
schema = "gurney-job/1"
title = "wall"
[item]
equipment = "icu_ventilator"
[[room.wall]]
name = "wall"
from_m = [0.42, -2]
to_m = [0.42, 2]
thickness_m = 0.1
height_m = 2
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.8, period_s = 0.8 }
use = "x"
TOML
expect 0 "wall.h5" "$gurney" run wall.toml -o wall.h5
plot 0 "collisions.svg" wall.h5 collisions -o collisions.svg
grep -q "impacts\? in 1 run" collisions.svg || complain "no impacts in collisions.svg"
plot 0 "hits.svg" wall.h5 collisions wall -o hits.svg
plot 1 "no item hit 'wal'; did you mean 'wall'?" wall.h5 collisions wal -o x.svg
# Width and height follow the 16th byte of a PNG; 85 mm at 300 pixels to the inch are 1004.
[ "$(od -An -tu1 -j16 -N4 t.png | awk '{print $3 * 256 + $4}')" = 1004 ] ||
  complain "t.png is not 1004 pixels wide"
plot 0 "grey.svg" study.h5 stripes peak_tilt -o grey.svg --grey --width 17cm
grep -q "#0072B2" grey.svg && complain "colour in grey.svg"
grep -q 'width="170mm"' grey.svg || complain "grey.svg is not 170 mm wide"

plot 2 "must end in .svg, .pdf or .png" study.h5 cdf -o x.eps
plot 2 "no figure 'cdff'; did you mean 'cdf'?" study.h5 cdff -o x.svg
plot 1 "needs that of a study. It has: acceleration" run.h5 cdf -o x.svg
plot 1 "no history 'tillt'; did you mean 'tilt'?" run.h5 history tillt -o x.svg
plot 1 "no demand 'peak_tlt'; did you mean 'peak_tilt'?" study.h5 cloud peak_tlt -o x.svg
plot 1 "no histories of run 99" study.h5 history tilt --run 99 -o x.svg
plot 2 "too narrow for this size of text" study.h5 cdf -o x.svg --width 40mm --font-size 20
plot 2 "--font-size big: must be" study.h5 cdf -o x.svg --font-size big
plot 2 "--list lists" study.h5
# What a figure does not take is bad usage, whatever the file.
for words in "cloud --level 2" "cdf --level 2" "cdf --measure PGA" "fragility --level 2" "fragility --run 1" \
  "cloud --run 1" "spectra --measure PGA" "tornado --method cloud" "trajectories tilt" "history --job run.toml"; do
  read -r kind option value <<< "$words"
  case $option in -*) ;; *) option=WHAT ;; esac
  plot 2 "$option is not for the figure $kind" study.h5 $words -o x.svg
done
for words in "--configuration off" "--measure PGA" "--level 1"; do
  plot 2 "is not for the figure history" run.h5 history $words -o x.svg
done
plot 2 "has no --configuration" wall.h5 collisions --configuration off -o x.svg
for words in "-o x.svg" "history" "--level 2"; do
  plot 2 "--list draws nothing" study.h5 --list $words
done
plot 1 "h.svg: exists already" run.h5 history -o h.svg
plot 0 "h.svg" run.h5 history -o h.svg --overwrite
plot 1 "missing.h5" missing.h5 cdf -o x.svg
[ -e x.svg ] && complain "x.svg was left"

exit $((failures > 0))
