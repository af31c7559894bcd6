"""Makes a part of the fragility catalogue again: one configuration of one item gives the rows of the
shipped table, to the digit, and the pages have the numbers of the tables.

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
import advice  # noqa: E402
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
    results = os.path.join(folder, ITEM + ".h5")
    again = list(tables.fragility_rows(gurney, ITEM, results))
    shipped += [row for row in advice.read(data, "more_states.csv")
                if row["item"] == ITEM and (row["floor"], row["place"], row["brakes"]) == CONFIGURATION]
    again += tables.further_rows(gurney, ITEM, results)
    if importlib.util.find_spec("h5py"):
        sys.path.insert(0, os.path.join(scripts, "hospital"))
        import demands
        shipped += [row for row in advice.read(os.path.join(scripts, "hospital"), "demands.csv")
                    if row["floor"] == CONFIGURATION[0]]
        again += demands.rows(results, CONFIGURATION[:1])
for old, new in zip(shipped, again, strict=True):
    new = {key: str(value) for key, value in new.items()}
    assert old == new, f"shipped: {old}\nagain:   {new}"

catalogue, advised = pages.Catalogue(data), advice.Advice(data)
with open(os.path.join(source, "docs", "catalogue", ITEM + ".md")) as file:
    page = file.read()
for line in [*pages.item_table(catalogue, ITEM, "open"), *pages.item_table(catalogue, ITEM, "bay"),
             *pages.further_table(catalogue, ITEM), advised.line(ITEM)]:
    assert line in page, f"not on the page of {ITEM}: {line}"
with open(os.path.join(source, "docs", "catalogue", "items.md")) as file:
    text = file.read()
for item in catalogue.items:
    row = next(line for line in text.splitlines() if line.startswith("|") and f"({item}.md)" in line)
    assert row.endswith(f"| {advice.ACTIONS[advised.action(item)].lower()} |"), item

def text_of(*path):
    with open(os.path.join(source, "docs", *path)) as file:
        return " ".join(file.read().split())


methods = text_of("catalogue", "methods.md")
decision = text_of("decisions.md")

# The numbers in the prose of the methods and of the decision.
better = [row["brakes"] for row in catalogue.measures if tables.much_better(row)]
words = (f"{len(better)} of {len(catalogue.measures)} configurations, {better.count('off')} with brakes off, "
         f"{better.count('on')} on, {better.count('locked')} locked")
assert words in methods, words
named = {(row["item"], row["floor"], row["place"], row["brakes"]) for row in advice.read(data, "best_measure.csv")}
assert len(named) == len(better), len(named)


def ratios(brakes, state):
    """Of beta on the best measure to that on the peak floor velocity."""
    for row in advice.read(data, "best_measure.csv"):
        pfv = catalogue.rows[row["item"], row["floor"], row["place"], row["brakes"], row["limit_state"]]
        if ((row["brakes"], row["limit_state"]) == (brakes, state) and row["theta"] and pfv["theta"] and
                10 <= int(row["exceed"]) <= int(row["runs"]) - 10):
            yield float(row["beta"]) / float(pfv["beta"])


for brakes in pages.SETTINGS:
    found = [list(ratios(brakes, state)) for state in ("moved 0.1 m", "moved 0.3 m", "moved 1 m", "overturned")]
    words = f"| {brakes} | " + " | ".join(f"{statistics.median(each):.2f}" if each else "" for each in found)
    assert " ".join(words.split()) in methods, words
for brakes, words in (("off", "the median 2 % larger"), ("on", "with brakes on 12 %"), ("locked", "locked 13 %")):
    above = statistics.median(float(row["pfv_scatter"]) / float(row["best_scatter"]) - 1
                              for row in catalogue.measures if row["brakes"] == brakes)
    assert f"{100 * above:.0f} %" in words and words in methods, (brakes, above)
for floor, words in (("ground", "0.54 m/s on the ground"), ("flexible building", "0.52 in the flexible"),
                     ("stiff building", "0.50 in the stiff"), ("isolated building", "0.26 in the isolated")):
    median = statistics.median(float(catalogue.rows[item, floor, "open", "off", "moved 0.3 m"]["theta"])
                               for item in catalogue.items)
    assert words.startswith(f"{median:.2f}") and words in decision, (floor, median)
