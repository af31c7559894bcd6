#!/usr/bin/env bash
# Items whose parts have casters, and tethers between parts, through the commands.
# usage: parts.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

cat > tandem.toml << 'TOML'
schema = "gurney-item/1"
name = "Tandem cart"
[chassis]
mass_kg = 50
center_of_mass_mm = [0, 0, 300]
inertia_box_mm = [600, 500, 600]
[[shape]]
center_mm = [0, 0, 300]
size_mm = [600, 500, 600]
[contact]
material = "steel"
friction = 0.4
restitution = 0.2
[[caster]]
name = "front left"
type = "pu_125"
position_mm = [250, 200, 0]
[[caster]]
name = "front right"
type = "pu_125"
position_mm = [250, -200, 0]
[[caster]]
name = "rear left"
type = "pu_125"
position_mm = [-250, 200, 0]
[[caster]]
name = "rear right"
type = "pu_125"
position_mm = [-250, -200, 0]
[[caster]]
name = "trailer left"
on = "trailer"
type = "pu_125"
position_mm = [-900, 200, 0]
brake = true
[[caster]]
name = "trailer right"
on = "trailer"
type = "pu_125"
position_mm = [-900, -200, 0]
[[part]]
name = "trailer"
joint = "hinge"
axis = [0, 1, 0]
position_mm = [-320, 0, 100]
mass_kg = 20
center_of_mass_mm = [-700, 0, 200]
inertia_box_mm = [600, 500, 300]
[[part.shape]]
center_mm = [-700, 0, 200]
size_mm = [600, 500, 300]
[[part]]
name = "monitor"
joint = "slider"
axis = [0, 0, 1]
position_mm = [0, 0, 700]
mass_kg = 5
center_of_mass_mm = [0, 0, 700]
inertia_box_mm = [200, 200, 200]
stiffness_n_per_m = 5000
damping_n_s_per_m = 100
[[part.shape]]
center_mm = [0, 0, 700]
size_mm = [200, 200, 200]
[[content]]
name = "box"
on = "trailer"
position_mm = [-700, 0, 350]
size_mm = [200, 200, 200]
mass_kg = 3
[content.contact]
material = "cardboard"
friction = 0.3
restitution = 0.2
TOML
cat > job.toml << 'TOML'
schema = "gurney-job/1"
[item]
equipment = "./tandem.toml"
name = "cart"
position_m = [1, 1]
[[tether]]
name = "strap"
item = "cart/box"
point_m = [0, 0, 0.1]
anchor_item = "cart/monitor"
anchor_m = [0, 0, 0.8]
slack_length_m = 1.05
kind = "strap"
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.5, period_s = 0.8 }
use = "x"
TOML

expect 0 "item 'Tandem cart' is valid" "$gurney" equipment check tandem.toml
grep -q warning stdout && complain "$(cat stdout)"
# m g / k = 9.8 mm.
expect 0 "parts at rest" "$gurney" equipment show tandem.toml
grep -Eq "monitor +chassis +slider +5.0 +-9.8 mm" stdout || complain "the monitor does not sag"
grep -Eq "trailer left +-9" stdout || complain "the trailer's wheels are not among those at rest"
expect 0 '"coordinate": -0.0098' "$gurney" equipment show tandem.toml --json
sed 's/position_mm = \[0, 0, 700\]/position_mm = [0, 0, 7000]/; s/\[0, 0, 700\]/[0, 0, 9000]/' tandem.toml > far.toml
expect 1 "far.toml:56:15: part 'monitor': its shapes, its joint and the chassis" "$gurney" equipment check far.toml

expect 0 "tandem.xml" "$gurney" export tandem.toml --to mjcf -o mjcf
python3 - mjcf/tandem.xml << 'PYTHON' || complain "the trailer has not its own wheels in MJCF"
import sys, xml.etree.ElementTree as tree
trailer = next(b for b in tree.parse(sys.argv[1]).iter("body") if b.get("name") == "trailer")
names = [b.get("name") for b in trailer.findall("body")]
assert names == ["trailer_left_fork", "trailer_right_fork"], names
PYTHON

expect 0 "strap of cart/box" "$gurney" run job.toml -o run.h5
expect 0 "" "$gurney" export run.h5 --to csv -o csv
grep -q "cart/trailer,trailer left," csv/wheels.csv || complain "the trailer's wheels are not among the results"
expect 0 "" "$gurney" explain run.h5
expect 0 "" "$gurney" explain run.h5 --what-if
expect 0 "" "$gurney" play run.h5 -o run.html
grep -q '"anchor_item":"cart/monitor"' run.html || complain "the player does not know where the strap ends"
sed 's/slack_length_m = 1.05/slack_length_m = 0.5/' job.toml > short.toml
expect 1 "short.toml:12:18: tether[0].slack_length_m = 0.5: must be at least 0.7" "$gurney" check short.toml

exit $((failures > 0))
