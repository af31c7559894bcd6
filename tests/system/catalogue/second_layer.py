"""The layer above the curves: halves of the motions. Checks the functions on
made-up numbers, and the numbers in the prose of the methods on the shipped tables.

usage: second_layer.py SOURCE_DIR
"""

import csv
import os
import sys

sys.dont_write_bytecode = True
source = sys.argv[1]
sys.path.insert(0, os.path.join(source, "studies", "catalogue"))
import halves  # noqa: E402

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


check_halves()
