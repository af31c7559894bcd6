"""The units of the package are those that job files and limit states may have, with the same values.
That it reads the versions of files which the program writes, the other tests show."""

import math
import os
import re

import support

support.use_package()

from gurney.units import _TO_SI  # noqa: E402

CONSTANTS = {"kStandardGravity": 9.80665, "kRadiansPerDegree": math.pi / 180}
ONLY_HERE = {"J": ("J", 1.0), "1": ("1", 1.0)}  # of results that no limit state is about

program = {}
for name in ("job/scale_reader.cpp", "limit_states/limit_state_reader.cpp"):
    with open(os.path.join(support.SOURCE, "studies", name), encoding="utf-8") as file:
        rows = re.findall(r'Unit\{"([^"]+)", "([^"]+)", ([\w.]+)\}', file.read())
    assert len(rows) >= 7, (name, rows)
    for unit, si, value in rows:
        program[unit] = si, CONSTANTS[value] if value in CONSTANTS else float(value)
assert {**program, **ONLY_HERE} == _TO_SI, (program, _TO_SI)
print(f"{len(program)} units agree")
