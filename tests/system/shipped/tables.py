"""Makes tables of docs/shipped_studies.md again, those of the studies that take least.

usage: tables.py GURNEY SOURCE_FOLDER
"""

import os
import subprocess
import sys
import tempfile

NAMES = ("operating_theatre", "trolley_orientation", "icu_ventilator_fragility")

try:
    import h5py  # noqa: F401
    import pandas  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

program, source = (os.path.abspath(path) for path in sys.argv[1:3])
with tempfile.TemporaryDirectory() as folder:
    for name in NAMES:
        subprocess.run([program, "run", f"{source}/studies/jobs/{name}.toml", "-o", f"{folder}/{name}.h5"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    subprocess.run([sys.executable, "-B", f"{source}/docs/validation/tables.py", "--check", folder, *NAMES],
                   check=True, env={**os.environ, "GURNEY": program})
