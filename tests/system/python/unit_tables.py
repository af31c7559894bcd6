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

with open(os.path.join(support.SOURCE, "engine", "base", "unit_table.cpp"), encoding="utf-8") as file:
    rows = re.findall(r'\{"([^"]+)", "([^"]+)", ([\w.]+)\}', file.read().split("kUnits[]")[1].split("};")[0])
program = {unit: (si, CONSTANTS[value] if value in CONSTANTS else float(value)) for unit, si, value in rows}
assert len(program) >= 14, program
assert {**program, **ONLY_HERE} == _TO_SI, (program, _TO_SI)
print(f"{len(program)} units agree")
