"""The damage of the small hospital: the shipped numbers are those of the closed form, and of pelicun itself
where GURNEY_PELICUN names a folder that holds its package.

usage: hospital.py SOURCE_DIR
"""

import csv
import math
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
source = sys.argv[1]
folder = os.path.join(source, "studies", "catalogue", "hospital")
sys.path.insert(0, folder)
import hospital  # noqa: E402

demands = {row["floor"]: row for row in hospital.read("demands.csv")}
curves = hospital.library()


def closed_form(rows):
    """Each mean, and the sum over the hospital, against the lognormal law of capacity over demand."""
    total = {}
    for row in rows:
        state, quantity = row["limit_state"], float(row["quantity"])
        if row["item"] == "all":
            expected = total[state]
        elif hospital.component(row, state) in curves:
            expected = hospital.expected(curves[hospital.component(row, state)], demands[row["floor"]], quantity)
        else:
            assert row["mean"] == "" and row["no_curve"], row
            continue
        total[state] = total.get(state, 0) + expected
        share = expected / quantity
        # The scatter of a count is largest where all items of a row fail together: quantity^2 p (1 - p).
        # Five standard deviations of the mean of the samples, and the rounding of the table.
        most = 5 * quantity * math.sqrt(share * (1 - share) / hospital.SAMPLES) + 0.0005
        assert abs(float(row["mean"]) - expected) <= most, (row, expected, most)


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


shipped = read(os.path.join(source, "docs", "catalogue", "data", "hospital.csv"))
assert len(shipped) == len(hospital.STATES) * (len(hospital.read("contents.csv")) + 1), len(shipped)
closed_form(shipped)
with open(os.path.join(source, "docs", "catalogue", "hospital.md")) as file:
    page = " ".join(file.read().split())
for row in shipped:
    if row["item"] == "all":
        words = f"{float(row['mean']):.1f} ({row['p05']} to {row['p95']})"
        assert words in page, f"not on the page: {words}"

pelicun = os.environ.get("GURNEY_PELICUN")
if not pelicun:
    print("the closed form agrees; GURNEY_PELICUN names no pelicun")
    sys.exit(0)
with tempfile.TemporaryDirectory() as work:
    again = os.path.join(work, "hospital.csv")
    subprocess.run([sys.executable, os.path.join(folder, "hospital.py"), pelicun, again], check=True)
    closed_form(read(again))
print("the closed form and pelicun agree")
