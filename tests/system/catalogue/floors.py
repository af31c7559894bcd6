"""Makes the rows of one floor of floors.csv again, to the digit.

usage: floors.py GURNEY SOURCE_DIR
"""

import importlib.util
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
gurney, source = sys.argv[1:]
if importlib.util.find_spec("h5py") is None:
    print("skipped: Python has no h5py, which the results are read with")
    sys.exit(77)
scripts = os.path.join(source, "studies", "catalogue")
sys.path.insert(0, scripts)
import runs  # noqa: E402
from words import read  # noqa: E402

FLOOR, ITEM = "yielding building", "icu_bed"  # under any item
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, os.path.join(scripts, "catalogue.py"), gurney, folder, "--items", ITEM, "--only",
                    f"{FLOOR},open,on"], check=True, capture_output=True)
    again = [{key: str(value) for key, value in row.items()}
             for row in runs.floor_rows(os.path.join(folder, ITEM + ".h5"))]
    counts = runs.run_row(ITEM, os.path.join(folder, ITEM + ".h5"))
shipped = [row for row in read(os.path.join(source, "docs", "catalogue", "data"), "floors.csv") if row["floor"] == FLOOR]
assert len(shipped) == 4
for old, new in zip(shipped, again, strict=True):
    assert old == new, f"shipped: {old}\nagain:   {new}"
assert (counts["item"], counts["runs"], counts["failed"]) == (ITEM, 128, 0), counts
