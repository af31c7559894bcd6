"""The layer above the curves: halves of the motions, other suites. Checks the functions on
made-up numbers, and the numbers in the prose of the methods on the shipped tables.

usage: second_layer.py SOURCE_DIR
"""

import csv
import math
import os
import sys

sys.dont_write_bytecode = True
source = sys.argv[1]
sys.path.insert(0, os.path.join(source, "studies", "catalogue"))
import halves  # noqa: E402
import suites  # noqa: E402

data = os.path.join(source, "docs", "catalogue", "data")
with open(os.path.join(source, "docs", "catalogue", "methods.md")) as file:
    methods = " ".join(file.read().split())


def read(name):
    with open(os.path.join(data, name), newline="") as file:
        return list(csv.DictReader(file))


def states(words):
    assert words in methods, f"the methods do not state: {words}"


def curve(theta, low, high):
    return {"curve": {"theta": theta}, "theta_interval": [low, high]}


def check_halves():
    key = ("moved 1 m", "any")
    one, other = {key: curve(1, 0.5, 2)}, {key: curve(3, 0.9, None)}
    found = halves.count(one, other)["moved 1 m"]  # 1 is within (0.9, inf); 3 is not within (0.5, 2)
    assert found == {"medians": 2, "within": 1, "bounded": 1, "within_bounded": 0, "no_curve": 0}, found
    none = {key: {"curve": None}}
    assert halves.count(one, none)["moved 1 m"]["no_curve"] == 2
    for division in halves.divisions().values():
        first, second = map(set, division)
        assert len(first) == len(second) == 8 and not first & second, division
    for row in read("halves.csv"):
        states(f"{row['within_bounded']} of {row['bounded']}")
    for division in ("by turns", "by kind"):
        rows = [row for row in read("halves.csv") if row["division"] == division]
        inside, medians = (sum(int(row[name]) for row in rows) for name in ("within_bounded", "bounded"))
        states(f"{100 * inside / medians:.0f} % of {medians} medians {division}")


def check_suites():
    base = dict.fromkeys(suites.KEY, "x") | {"theta": "1", "theta_low": "0.5", "theta_high": "inf"}
    [row] = suites.pairs({("x",) * 5: base}, {("x",) * 5: base | {"theta": "2"}})
    assert float(row["ratio"]) == 2 and row["within"] == "yes", row
    [row] = suites.summary([row, row | {"ratio": "0.5", "within": "no"}])
    assert (row["ratio"], row["lowest"], row["within"]) == ("1.00", "0.50", 1), row
    rows = read("suites.csv")
    inside = sum(row["within"] == "yes" for row in rows)
    ratio = math.exp(sum(math.log(float(row["ratio"])) for row in rows) / len(rows))
    states(f"{inside} of {len(rows)} medians with records lie within the interval")
    states(f"{ratio:.2f} times the synthetic one")


check_halves()
check_suites()
