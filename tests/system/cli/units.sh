#!/usr/bin/env bash
# The option --units of every command that has it, from outside: the same numbers in other units.
# usage: units.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"
same() { cmp "$1" "$2" > stdout 2> stderr || complain "$1 and $2 differ"; }
check() { python3 "$@" > stdout 2> stderr || complain "$*"; }

write_ventilator_job units
{
  sed '/^use/d; s/^synthetic = .*/synthetic = { kind = "ac156" }/' run.toml
  cat << 'TOML'
[settings]
duration_s = 6
[study]
synthetic_records = 8
draws = 2
seed = 1
angles_deg = [0, 30]
measures = ["PGV h1"]
[study.keep]
histories = "all"
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.15, 0.25, 0.4]
[[study.limit_state]]
name = "rolled"
demand = "peak_displacement"
above = 2.4
unit = "cm"
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
TOML
} > study.toml
expect 0 "study.h5" "$gurney" run study.toml -o study.h5

# Refused: an unknown name, and units where a format or the keys state them.
for command in "fragility study.h5" "show study.h5" "plot study.h5 stripes -o x.svg" \
  "compare study.h5" "sensitivity study.h5" "measures study.h5" "report study.h5 -o x.html" \
  "explain study.h5 --run 0" "replay study.h5 0" "run run.toml" "export study.h5 --to csv" \
  "converge run.toml"; do
  # shellcheck disable=SC2086
  expect 2 "no units 'g-cn'; did you mean 'g-cm'?" \
    "$gurney" $command --units g-cn
  expect 0 "--units UNITS" "$gurney" help "${command%% *}"
done
[ -e x.svg ] || [ -e x.html ] || [ -e out ] && complain "a refused command wrote a file"
for command in "run run.toml" "replay study.h5 0" "explain study.h5 --run 0"; do
  # shellcheck disable=SC2086
  expect 2 "--json" "$gurney" $command --json --units g-cm
done
expect 2 "--units is for --to csv; --to nrml has the units of its format" \
  "$gurney" export study.h5 --to nrml --units g-cm

# The job is in g, m and degrees: stating it changes nothing. JSON is in SI.
for command in show fragility compare "sensitivity --all-levels"; do
  # shellcheck disable=SC2086
  "$gurney" $command study.h5 > of_job.txt 2> stderr || complain "$command"
  # shellcheck disable=SC2086
  "$gurney" $command study.h5 --units g-m > stated.txt 2> stderr || complain "$command --units"
  same of_job.txt stated.txt
done
for command in fragility compare "sensitivity --all-levels" measures "fragility --and pfv"; do
  name=${command//[^a-z]/_}
  name=${name%___all_levels}
  # shellcheck disable=SC2046,SC2086
  for units in "" si cm g-in; do
    "$gurney" ${command/ / study.h5 } $([ "$command" = "${command/ /}" ] && echo study.h5) --json \
      ${units:+--units $units} > "$name$units.json" 2> stderr || complain "$command $units"
  done
  same "$name.json" "${name}si.json"
done

cat > scaled.py << 'PY'
"""Every number of the second file is that of the first, in the units that it states."""
import json, math, sys
G = 9.80665
IN_SI = {"m": 1, "m/s": 1, "m/s2": 1, "rad": 1, "N": 1, "N s": 1, "cm": .01, "cm/s": .01, "cm/s2": .01,
         "deg": math.pi / 180, "g": G, "in": .0254, "in/s": .0254, "lbf": .45359237 * G,
         "lbf s": .45359237 * G, "1": 1, "s": 1}
OF_IM = {"theta", "theta_interval", "median_between", "lowest_im", "highest_im", "im", "above",
         "at_most"}
OF_DEMAND = {"a", "b", "difference", "interval", "mean", "standard_deviation", "mean_below",
             "mean_above", "mean_below_error", "mean_above_error", "swing", "floor", "values",
             "scatter"}
seen = set()


def compare(si, other, factor, path):
    if isinstance(si, dict):
        assert si.keys() == other.keys(), (path, si.keys() ^ other.keys())
        for key in si:
            inner = factor
            for name in ("units", "measure_units", "floor_units"):
                if isinstance(si.get(name), str):
                    inner = IN_SI[si[name]] / IN_SI[other[name]]
            if key == "cloud" and si[key]:
                check_cloud(si[key], other[key], inner)
            elif key in ("cautions", "verdict", "reason"):
                continue
            elif key == "inputs":
                compare(si[key], other[key], inner, path + (key,))
            elif key == "band":
                for a, b in zip(si[key], other[key]):
                    near(a[0] * inner, b[0], path + (key,))
                    assert a[1:] == b[1:]
            else:
                compare(si[key], other[key], inner, path + (key,))
    elif isinstance(si, list):
        assert len(si) == len(other), path
        for a, b in zip(si, other):
            compare(a, b, factor, path)
    elif isinstance(si, float) and path[-1] in OF_IM | OF_DEMAND and "tests" not in path:
        if path[-1] == "interval" and "inputs" in path:  # of an index
            assert si == other, path
            return
        seen.add(path[-1])
        near(si * factor, other, path)
    elif path[-1] not in ("units", "measure_units", "floor_units"):
        assert si == other, (path, si, other)


def check_cloud(si, other, factor):
    demand = IN_SI[si["demand_units"]] / IN_SI[other["demand_units"]]
    # ln(d f_d) = a' + b ln(im f)
    near(si["a"] + math.log(demand) - si["b"] * math.log(factor), other["a"], ("cloud",))
    assert si["b"] == other["b"] and si["sigma"] == other["sigma"]
    near(si["curve"]["theta"] * factor, other["curve"]["theta"], ("cloud", "theta"))


def near(wanted, got, path):
    # two divisions here and one there, each rounded
    assert abs(wanted - got) <= 4 * sys.float_info.epsilon * max(1, abs(wanted)), (path, wanted, got)


compare(json.load(open(sys.argv[1])), json.load(open(sys.argv[2])), 1, ("",))
assert seen >= set(sys.argv[3:]), seen
PY
for units in cm g-in; do
  check scaled.py fragility.json "fragility$units.json" theta theta_interval im lowest_im
  check scaled.py compare.json "compare$units.json" a b difference interval
  check scaled.py sensitivity.json "sensitivity$units.json" mean standard_deviation mean_below
  check scaled.py measures.json "measures$units.json" floor
done

# The same curve: P at an intensity is the same number, whatever the unit.
check - << 'PY'
import json, math
from statistics import NormalDist
curves = 0
for (name, unit) in (("fragilitycm.json", .01), ("fragilityg-in.json", 9.80665)):
    for si, other in zip(*(json.load(open(f))["fragilities"] for f in ("fragility.json", name))):
        assert si["units"] == "m/s2"
        if not si["curve"]:
            assert not other["curve"]
            continue
        curves += 1
        for im in (0.5, 1, 3):
            p = [NormalDist().cdf(math.log(x / c["curve"]["theta"]) / c["curve"]["beta"])
                 for x, c in ((im, si), (im / unit, other))]
            assert abs(p[0] - p[1]) < 1e-14, p
        assert other["curve"]["theta"] == si["curve"]["theta"] / unit
assert curves > 0
# Two measures: the plane at the same motion.
si, cm = (json.load(open(f))["fragilities"][0] for f in ("fragility___and_pfv.json", "fragility___and_pfvcm.json"))
assert cm["units"] == ["cm/s2", "cm/s"], cm["units"]
if si["plane"]:
    z = [f["plane"][0] * math.log(a) + f["plane"][1] * math.log(v) + f["plane"][2]
         for f, a, v in ((si, 2, .3), (cm, 200, 30))]
    assert abs(z[0] - z[1]) < 1e-12 * (1 + abs(z[0])), z
PY

for units in "" si g-in; do
  "$gurney" converge run.toml --json ${units:+--units $units} > "converge$units.json" 2> stderr ||
    complain "converge $units"
done
same converge.json convergesi.json
check scaled.py converge.json convergeg-in.json values

expect 0 "98.0665 cm/s2" "$gurney" show study.h5 --units cm
expect 0 "0, 0.523599 rad" "$gurney" show study.h5 --units si
expect 0 "PGA h1 [cm/s2]" "$gurney" fragility study.h5 --units cm
expect 0 "peak_displacement [in]" "$gurney" compare study.h5 --units g-in
expect 0 "peak_displacement, false: mean " "$gurney" sensitivity study.h5 --all-levels --units g-mm
grep -q " mm, standard deviation .* mm, " stdout || complain "sensitivity is not in mm"
expect 0 "below 0.000945 in: at most that" "$gurney" measures study.h5 --units g-in

# Figures: the labels carry the unit; stating that of the job changes nothing.
plot() { expect 0 "$1.svg" "$gurney" plot study.h5 "${@:2}" -o "$1.svg" --overwrite; }
labelled() { grep -qF ">$2" "$1.svg" || complain "$1.svg has no label '$2'"; }
for kind in stripes ida cloud cdf fragility; do
  plot of_job "$kind"
  plot "$kind" "$kind" --units g-m
  same of_job.svg "$kind.svg"
  plot "$kind" "$kind" --units cm
done
labelled stripes "Peak displacement (cm)"
labelled stripes "PGA h1 (cm/s²)"
labelled ida "PGA h1 (cm/s²)"
labelled cloud "Peak displacement (cm)"
labelled cdf "98.0665 cm/s2"
expect 1 "and a mean needs 10" "$gurney" plot study.h5 tornado -o few.svg
[ ! -e few.svg ] || complain "a tornado without bars"
labelled fragility "PGA h1 (cm/s²)"
plot history history displacement tilt --units g-in
labelled history "Displacement relative to the floor (in)"
plot trajectories trajectories --units g-cm
labelled trajectories "x from the start (cm)"
plot spectra spectra --units cm
labelled spectra "Sa h1 (cm/s²)"
for command in fragility compare sensitivity; do
  # shellcheck disable=SC2046
  expect 0 "" "$gurney" "$command" study.h5 --figure "$command.svg" --overwrite --units cm \
    $([ $command = sensitivity ] && echo --configuration false --all-levels)
done
labelled fragility "PGA h1 (cm/s²)"
labelled compare "PGA h1 (cm/s²)"
labelled sensitivity "Mean (cm)"

# One run: the report and the figure, not the results file.
expect 0 "peak displacement" "$gurney" run run.toml -o run.h5 --verbose
cp stdout run.txt
expect 0 "PGA" "$gurney" run run.toml -o run_cm.h5 --units g-cm --verbose
cp stdout run_cm.txt
same run.h5 run_cm.h5
labelled run_cm "Displacement (cm)"
labelled run_cm "x (cm)"
labelled run "Displacement (m)"
check - << 'PY'
import re
def table(name):
    rows = re.findall(r"^  (\w[\w ]*?) {2,}(-?[\d.]+) ([^\s,]+)(?:,? .*)?$", open(name).read(), re.M)
    return {row[0]: (float(row[1]), row[2]) for row in rows}
si, cm = table("run.txt"), table("run_cm.txt")
assert si.keys() == cm.keys() and len(si) > 12, si
lengths = 0
for name, (value, unit) in si.items():
    got, now = cm[name]
    if unit in ("m", "m/s"):
        lengths += 1
        assert now == "c" + unit, (name, now)
        # both have four digits
        assert abs(100 * value - got) <= 1e-3 * abs(got) + 0.006, (name, value, got)
    elif unit != "m/s2":
        assert (got, now) == (value, unit), name
assert lengths > 5, lengths
for name, unit in (("run.txt", "mm"), ("run_cm.txt", "cm")):
    assert re.search(rf"at most [\d.]+ {unit} from its start", open(name).read()), name
PY
"$gurney" show run.h5 --json > run.json && "$gurney" show run.h5 --json --units g-in > run_in.json ||
  complain "show --json"
check - << 'PY'
import json, math
si, us = (json.load(open(f)) for f in ("run.json", "run_in.json"))
assert us["units"]["peak_displacement"] == "in" and us["units"]["peak_tilt"] == "deg"
for a, b in zip(si["items"], us["items"]):
    assert b["peak_displacement"] == a["peak_displacement"] / .0254
    assert b["peak_velocity"] == a["peak_velocity"] / .0254
    assert b["peak_tilt"] == a["peak_tilt"] / (math.pi / 180)
PY
expect 0 "in/s" "$gurney" show run.h5 --units g-in
expect 0 "replay   the same" "$gurney" replay study.h5 5 --units g-mm -o replayed.h5
grep -q "peak displacement .* mm" stdout || complain "replay is not in mm"
labelled replayed "Displacement (mm)"
expect 0 "why.svg" "$gurney" explain run.h5 --units g-cm --what-if -o why.svg
grep -Eq "[0-9] (m|m/s|m/s2)( |,|\.|$)" stdout && complain "explain has metres"
grep -q " cm/s" stdout || complain "explain is not in cm"
labelled why "Distance (cm)"

# A page: titles and numbers.
expect 0 "report.html" "$gurney" report study.h5 -o report.html --units g-cm
expect 0 "run.html" "$gurney" report run.h5 -o run.html --units g-cm
check - << 'PY'
import json, re
DRAWING_OF_AN_ITEM = re.compile(r"(forward|left|z) \(m\)")  # its data sheet
page = DRAWING_OF_AN_ITEM.sub("", open("report.html").read())
cases = json.loads(re.search(r'({"replay":.*?})</script>', page, re.S).group(1))
column = {each["title"]: each for each in cases["columns"]}
assert column["Peak displacement (cm)"]["in_si"] == .01, column.keys()
assert column["Peak tilt (deg)"]
assert ">Peak displacement (cm)<" in page and "(m)" not in page and " m/s" not in page
run = DRAWING_OF_AN_ITEM.sub("", open("run.html").read())
assert "Peak displacement (cm)" in run and "(m)" not in run and "(m/s)" not in run
PY

# Tables: units in the second row; SI reads back exactly.
expect 0 "items.csv" "$gurney" export study.h5 --to csv -o si
expect 0 "items.csv" "$gurney" export study.h5 --to csv -o us --units g-in
check - << 'PY'
import csv, math, pathlib
FACTOR = {("m", "in"): .0254, ("m/s", "in/s"): .0254, ("m/s2", "g"): 9.80665,
          ("rad", "deg"): math.pi / 180, ("rad/s", "deg/s"): math.pi / 180,
          ("N", "lbf"): .45359237 * 9.80665, ("N s", "lbf s"): .45359237 * 9.80665,
          ("J", "lbf in"): .45359237 * 9.80665 * .0254}
changed = set()
for path in sorted(pathlib.Path("si").iterdir()):
    si, us = (list(csv.reader(open(p, newline=""))) for p in (path, pathlib.Path("us") / path.name))
    assert si[0] == us[0] and len(si) == len(us), path
    for i, pair in enumerate(zip(si[1], us[1])):
        if pair[0] != pair[1]:
            changed.add(pair)
        for a, b in zip(si[2:], us[2:]):
            if pair[0] == pair[1] or a[i] == "":
                assert a[i] == b[i], (path, si[0][i])
            else:
                assert float(b[i]) == float(a[i]) / FACTOR[pair], (path, si[0][i], a[i], b[i])
assert {("m", "in"), ("m/s2", "g"), ("rad", "deg"), ("N", "lbf")} <= changed, changed
PY

[ "$failures" -eq 0 ] && echo "every command has the units that it is asked for"
exit $((failures > 0))
