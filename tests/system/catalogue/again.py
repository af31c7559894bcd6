"""Makes a part of the fragility catalogue again: one configuration of one item gives the rows of the
shipped table, to the digit, and its page has the numbers of the table.

usage: again.py GURNEY SOURCE_DIR
"""

import csv
import os
import subprocess
import sys
import tempfile

gurney, source = sys.argv[1:]
scripts = os.path.join(source, "studies", "catalogue")
sys.path.insert(0, scripts)
import pages  # noqa: E402
import tables  # noqa: E402

ITEM, CONFIGURATION = "icu_ventilator", ("flexible building", "open", "off")
data = os.path.join(source, "docs", "catalogue", "data")

with open(os.path.join(data, "fragility.csv"), newline="") as file:
    shipped = [row for row in csv.DictReader(file)
               if row["item"] == ITEM and (row["floor"], row["place"], row["brakes"]) == CONFIGURATION]
assert len(shipped) == 12, f"{len(shipped)} rows of {CONFIGURATION} in the shipped table, expected 6 of 2 measures"

with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, os.path.join(scripts, "catalogue.py"), gurney, folder, "--items", ITEM, "--only",
                    ",".join(CONFIGURATION)], check=True, capture_output=True)
    again = list(tables.fragility_rows(gurney, ITEM, os.path.join(folder, ITEM + ".h5")))
for old, new in zip(shipped, again, strict=True):
    new = {key: str(value) for key, value in new.items()}
    assert old == new, f"shipped: {old}\nagain:   {new}"

catalogue = pages.Catalogue(data)
with open(os.path.join(source, "docs", "catalogue", ITEM + ".md")) as file:
    page = file.read()
for line in pages.item_table(catalogue, ITEM) + [catalogue.advice(ITEM)]:
    assert line in page, f"not on the page of {ITEM}: {line}"
with open(os.path.join(source, "docs", "catalogue", "items.md")) as file:
    text = file.read()
for item in catalogue.items:
    assert catalogue.advice(item) in next(line for line in text.splitlines() if f"({item}.md)" in line), item
