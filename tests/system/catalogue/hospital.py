"""The damage of the small hospital: the shipped numbers are those of the closed form, of `gurney hospital`, and of
pelicun itself where GURNEY_PELICUN names a folder that holds its package.

usage: hospital.py GURNEY SOURCE_DIR
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
gurney, source = sys.argv[1:]
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

PGV = 0.4  # [m/s] of demands.csv


def bed_of(row, number, state):
    """A room for each piece, with a bed that is out of use where the piece exceeds the state."""
    return f"""[[room]]
name = "{number}"
storey = "{row["floor"]}"
count = {row["quantity"]}
beds = 1
works = 'not_reached(piece, "{state}")'
[[room.item]]
name = "piece"
equipment = "{row["item"]}"
place = "{row["place"]}"
brakes = "{row["brakes"]}"
"""


def by_gurney(work, state):
    """Mean number of items that exceed the state, with the curves that pelicun has."""
    columns = [name for name in hospital.catalogue()[0] if name not in ("runs", "exceed")]  # no rule of few outcomes
    with open(os.path.join(work, "curves.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(hospital.catalogue())
    storeys = "".join(f"""[[storey]]
name = "{name}"
floor = "{name}"
pfv_over_pgv = {float(row["median_m_per_s"]) / PGV}
pfv_beta = {row["beta"]}
""" for name, row in demands.items())
    rooms = "".join(bed_of(row, i, state) for i, row in enumerate(hospital.read("contents.csv")))
    path = os.path.join(work, "hospital.toml")
    with open(path, "w") as file:
        file.write(f'''schema = "gurney-hospital/1"
curves = ["curves.csv"]
[motion]
pgv_m_per_s = [{PGV}]
''' + storeys + rooms)
    answer = subprocess.run([gurney, "hospital", path, "--samples", str(hospital.SAMPLES), "--json"], check=True,
                            capture_output=True, text=True)
    return json.loads(answer.stdout)["levels"][0]["beds_out"]


with tempfile.TemporaryDirectory() as work:
    for row in shipped:
        if row["item"] != "all":
            continue
        mean, spread = by_gurney(work, row["limit_state"]), (float(row["p95"]) - float(row["p05"])) / 3.29
        # Both are means of samples whose counts vary by about the width of their 90 % over 3.29; each of gurney's
        # storeys has one velocity with all others, so that its counts vary more: twice that for both, four of them.
        most = 4 * 2 * spread * math.sqrt(2 / hospital.SAMPLES)
        assert abs(mean - float(row["mean"])) < most, (row, mean, most)
        print(f"{row['limit_state']}: {mean:.3f} by gurney hospital, {row['mean']} by pelicun")
pelicun = os.environ.get("GURNEY_PELICUN")
if not pelicun:
    print("the closed form agrees; GURNEY_PELICUN names no pelicun")
    sys.exit(0)
with tempfile.TemporaryDirectory() as work:
    again = os.path.join(work, "hospital.csv")
    subprocess.run([sys.executable, os.path.join(folder, "hospital.py"), pelicun, again], check=True)
    closed_form(read(again))
print("the closed form and pelicun agree")
