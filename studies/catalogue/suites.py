"""How the medians of the catalogue differ with other suites of motions.

usage: suites.py TABLES OUTPUT NAME=OTHER_TABLES...

All folders are of tables.py, the others of results that catalogue.py made with --suite or --motions. OUTPUT gets
the medians on the peak floor velocity and their ratio, the other suite's over the shipped one's; prints a summary.
"""

import csv
import math
import os
import sys

from tables import number, write_csv

KEY = ("item", "floor", "place", "brakes", "limit_state")
LOOSE = ("extrapolated", "leave theta and beta uncertain")  # cautions of a median that may be anywhere


def curves(folder):
    with open(os.path.join(folder, "fragility.csv"), newline="") as file:
        return {tuple(row[k] for k in KEY): row for row in csv.DictReader(file)
                if row["measure"] == "pfv" and row["theta"] and not any(words in row["cautions"] for words in LOOSE)}


def within(value, row):
    return float(row["theta_low"]) <= float(value) <= float(row["theta_high"])


def pairs(first, second):
    for key in sorted(first.keys() & second.keys()):
        a, b = first[key], second[key]
        yield dict(zip(KEY, key)) | {
            "theta": a["theta"], "theta_low": a["theta_low"], "theta_high": a["theta_high"], "other": b["theta"],
            "other_low": b["theta_low"], "other_high": b["theta_high"],
            "ratio": number(float(b["theta"]) / float(a["theta"])),
            "within": "yes" if within(b["theta"], a) else "no"}


def summary(rows, keys=("brakes", "limit_state")):
    """Summaries of rows with equal keys: pairs, geometric mean and ends of the ratios, and how many of the other medians lie in
    the interval of the shipped one."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    for values, group in groups.items():
        ratios = [float(row["ratio"]) for row in group]
        yield dict(zip(keys, values)) | {
            "curves": len(group), "ratio": f"{math.exp(sum(map(math.log, ratios)) / len(ratios)):.2f}",
            "lowest": f"{min(ratios):.2f}", "highest": f"{max(ratios):.2f}",
            "within": sum(row["within"] == "yes" for row in group)}


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    shipped, rows = curves(sys.argv[1]), []
    for name, _, folder in (word.partition("=") for word in sys.argv[3:]):
        own = list(pairs(shipped, curves(folder)))
        if not own:
            sys.exit(f"suites.py: no curve is in both {sys.argv[1]} and {folder}")
        rows += [{"suite": name} | row for row in own]
        for row in summary(own):
            print(f"{name:12} {row['brakes']:7} {row['limit_state']:15} {row['curves']:3} curves, ratio {row['ratio']} "
                  f"({row['lowest']} to {row['highest']}), {row['within']} within the interval")
    write_csv(sys.argv[2], list(rows[0]), rows)


if __name__ == "__main__":
    main()
