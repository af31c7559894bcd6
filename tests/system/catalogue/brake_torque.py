"""Makes one row of the shipped table of brake torques again.

usage: brake_torque.py GURNEY SOURCE_DIR
"""

import csv
import importlib.util
import os
import subprocess
import sys
import tempfile

gurney, source = sys.argv[1:]
if importlib.util.find_spec("h5py") is None:
    print("skipped: Python has no h5py, which the study reads its results with")
    sys.exit(77)
shipped = os.path.join(source, "docs", "catalogue", "data", "brake_torque.csv")
script = os.path.join(source, "studies", "catalogue", "brake_torque.py")


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


rows = read(shipped)
with tempfile.TemporaryDirectory() as folder:
    again = os.path.join(folder, "again.csv")
    subprocess.run([sys.executable, "-B", script, gurney, folder, again, rows[0]["torque_n_m"]], check=True,
                   capture_output=True)
    assert read(again) == rows[:1], f"shipped: {rows[0]}\nagain:   {read(again)}"
