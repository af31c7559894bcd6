"""Makes parts of the catalogue's tables of further studies again, of an item whose runs are short: the rows are those
shipped, to the digit.

usage: parts.py GURNEY SOURCE_DIR
"""

import os
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
gurney, source = sys.argv[1:]
scripts = os.path.join(source, "studies", "catalogue")
sys.path.insert(0, scripts)
from words import read  # noqa: E402

data = os.path.join(source, "docs", "catalogue", "data")
ITEM, FLOOR, PLACE, BRAKES = "linen_cart", "flexible building", "open", "on"
HELD, WITH_PARTS = "two straps", "hospital_bed"
OF_ALL = ("best", "share")  # columns of tethers.csv that need all ways to hold an item
BY_LEVEL = os.path.join(scripts, "motions_by_level")
STUDIES = {  # options of catalogue.py by the table of suites.py that they give
    "six_draws.csv": ["--draws", "6"],
    "jittered.csv": ["--levels", "0.1425,0.1575,0.38,0.42,0.76,0.84,1.425,1.575"],
    "by_level.csv": ["--motions", *(os.path.join(BY_LEVEL, f"{level}.csv") for level in ("0.15", "0.4", "0.8", "1.5"))],
}


def script(name, *arguments):
    subprocess.run([sys.executable, os.path.join(scripts, name), *arguments], check=True, capture_output=True)


def compare(shipped, again, apart=()):
    assert shipped and len(shipped) == len(again), (len(shipped), len(again))
    for old, new in zip(shipped, again):
        for column in old:
            assert column in apart or old[column] == new[column], f"{column}: shipped {old}, again {new}"


with tempfile.TemporaryDirectory() as folder:
    for table, options in STUDIES.items():
        results, tables = os.path.join(folder, table + ".results"), os.path.join(folder, table + ".tables")
        script("catalogue.py", gurney, results, "--items", ITEM, "--only", f"{FLOOR},{PLACE},{BRAKES}", *options)
        script("tables.py", gurney, results, tables)
        shipped = [row for row in read(data, table)
                   if (row["item"], row["floor"], row["place"], row["brakes"]) == (ITEM, FLOOR, PLACE, BRAKES)]
        script("suites.py", data, os.path.join(folder, table), f"{shipped[0]['suite']}={tables}")
        compare(shipped, read(folder, table))
        print(f"{table}: {len(shipped)} rows are as shipped")
    script("tethers.py", gurney, os.path.join(folder, "held"), folder, "--items", ITEM, "--held", HELD)
    compare([row for row in read(data, "tethers.csv") if (row["item"], row["held"]) == (ITEM, HELD)],
            read(folder, "tethers.csv"), OF_ALL)
    for name in ("fragility.csv", "more_states.csv"):
        shutil.copy(os.path.join(data, name), folder)
    script("contents.py", gurney, os.path.join(folder, "parts"), folder, "--items", WITH_PARTS)
    compare([row for row in read(data, "contents.csv") if row["item"] == WITH_PARTS], read(folder, "contents.csv"))
