#!/usr/bin/env bash
# `gurney equipment` from outside: exit codes, messages, and the files that are left.
# usage: equipment.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# equipment CODE TEXT ARGUMENTS...: what `gurney equipment` does
equipment() { expect "$1" "$2" "$gurney" equipment "${@:3}"; }

equipment 2 "A subcommand is required"
equipment 0 "icu_ventilator" ls
equipment 0 '"key": "icu_ventilator"' ls --json
equipment 0 "IEC 60601-1" show icu_ventilator
equipment 0 '"tilt_rad":' show icu_ventilator --json
equipment 0 "tread.patch_width_mm" show icu_ventilator --assumptions
equipment 0 "swivels, braked" show icu_ventilator --brakes on
equipment 0 "swivels, braked" show icu_ventilator --variant "brakes on"
equipment 0 "so it rocks before it slides" show bookcase
grep -q "wheel" stdout && complain "a bookcase has no wheels"
equipment 0 "coated board; friction 0.36, restitution 0.2" show bookcase --floor rubber
equipment 0 "contact.friction = 0.3 (0.2 to 0.6)" show bookcase --assumptions
equipment 0 '"rolls_from_g": null' show bookcase --json
equipment 1 "--brakes: Bookcase has no casters" show bookcase --brakes on
equipment 0 "slenderness h / b" show storage_shelving --figure shelving.svg
grep -q "wheel" shelving.svg && complain "shelving has no wheels"
equipment 1 "did you mean 'brakes on'?" show icu_ventilator --variant "brake on"
equipment 1 "did you mean 'icu_ventilator'?" show icu_ventilater
equipment 1 "unknown floor covering" show icu_ventilator --floor marble
equipment 2 "--brakes" show icu_ventilator --brakes maybe
equipment 0 "ICU" show icu_ventilator --figure plan.svg
grep -q "</svg>" plan.svg || complain "no figure"
equipment 1 "plan.svg: exists already" show icu_ventilator --figure plan.svg
equipment 0 "ICU" show icu_ventilator --figure plan.svg --overwrite

equipment 0 "item 'ICU ventilator on cart' is valid" check "$2/equipment/items/icu_ventilator.toml"
sed 's/^value = 30$/value = -30/; s/^name = "front left"/nome = "front left"/' \
  "$2/equipment/items/icu_ventilator.toml" > bad.toml
equipment 1 "bad.toml:9:9: chassis.mass_kg.value = -30" check bad.toml "$2/equipment/casters/R100.toml"
grep -q "nome: unknown key; did you mean 'name'?" stderr || complain "not all errors are reported"
grep -q "caster 'R100' is valid" stdout || complain "the others are not looked at"
printf 'schema = "gurney-job/1"\n' > job.toml
equipment 1 "gurney-item/1" check job.toml
equipment 1 'job.toml:1:10: schema = "gurney-job/1": the file is a job' check job.toml
grep -q "the command for it is: gurney check job.toml" stderr || complain "no command is named"
equipment 1 '"message": ' check bad.toml --json
[ -s stderr ] && complain "errors of --json are printed twice"
python3 - stdout << 'PYTHON' || complain "the errors are not a list"
import json, sys
(file,) = json.load(open(sys.argv[1]))["files"]
first = file["errors"][0]
assert (first["line"], first["column"], first["key"]) == (9, 9, "chassis.mass_kg.value"), first
assert first["file"] == "bad.toml" and "must be" in first["message"], first
PYTHON
equipment 2 "must end in .svg, .pdf or .png" show icu_ventilator --figure plan.eps
[ -e plan.eps ] && complain "SVG was written as EPS"
equipment 1 "none.toml" check none.toml
equipment 0 '"warnings": []' check "$2/equipment/floors/linoleum.toml" --json

exit $((failures > 0))
