"""Makes a part of the fragility catalogue again: one configuration of one item gives the rows of the shipped table, to the
digit, and the decisions have the numbers of the tables.

usage: again.py GURNEY SOURCE_DIR
"""

import csv
import importlib.util
import os
import statistics
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
gurney, source = sys.argv[1:]
scripts = os.path.join(source, "studies", "catalogue")
sys.path.insert(0, scripts)
import tables  # noqa: E402
from words import read  # noqa: E402

ITEM, CONFIGURATION = "icu_ventilator", ("flexible building", "open", "off")
data = os.path.join(source, "docs", "catalogue", "data")

with open(os.path.join(data, "fragility.csv"), newline="") as file:
    shipped = [row for row in csv.DictReader(file)
               if row["item"] == ITEM and (row["floor"], row["place"], row["brakes"]) == CONFIGURATION]
assert len(shipped) == 12, f"{len(shipped)} rows of {CONFIGURATION} in the shipped table, expected 6 of 2 measures"

with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, os.path.join(scripts, "catalogue.py"), gurney, folder, "--items", ITEM, "--only",
                    ",".join(CONFIGURATION)], check=True, capture_output=True)
    results = os.path.join(folder, ITEM + ".h5")
    again = list(tables.fragility_rows(gurney, ITEM, results))
    shipped += [row for row in read(data, "more_states.csv")
                if row["item"] == ITEM and (row["floor"], row["place"], row["brakes"]) == CONFIGURATION]
    again += tables.further_rows(gurney, ITEM, results)
    if importlib.util.find_spec("h5py"):
        sys.path.insert(0, os.path.join(scripts, "hospital"))
        import demands
        shipped += [row for row in read(os.path.join(scripts, "hospital"), "demands.csv")
                    if row["floor"] == CONFIGURATION[0]]
        again += demands.rows(results, CONFIGURATION[:1])
for old, new in zip(shipped, again, strict=True):
    new = {key: str(value) for key, value in new.items()}
    assert old == new, f"shipped: {old}\nagain:   {new}"

with open(os.path.join(source, "docs", "architecture.md")) as file:
    decision = " ".join(file.read().split())
curves = [row for row in read(data, "fragility.csv") if row["measure"] == "pfv" and row["theta"] and
          (row["place"], row["brakes"], row["limit_state"]) == ("open", "off", "moved 0.3 m")]

# The numbers in the prose of the decision.
for floor, words in (("ground", "0.54 m/s on the ground"), ("flexible building", "0.52 in the flexible"),
                     ("stiff building", "0.51 in the stiff"), ("yielding building", "0.47 in the yielding"),
                     ("isolated building", "0.26 in the isolated")):
    median = statistics.median(float(row["theta"]) for row in curves if row["floor"] == floor)
    assert words.startswith(f"{median:.2f}") and words in decision, (floor, median)
