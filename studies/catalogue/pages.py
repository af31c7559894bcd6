"""Writes the pages of the fragility catalogue, docs/catalogue, from the tables of tables.py.

usage: pages.py GURNEY RESULTS TABLES PAGES

PAGES gets items.md (the overview), a page for each item, and their figures.
"""

import csv
import json
import math
import os
import subprocess
import sys

SPEEDS = (0.4, 0.8)  # [m/s] peak floor velocities of the overview
WHERE = ("flexible building", "open")  # of the overview
LIMITS = ["moved 0.1 m", "moved 0.3 m", "moved 1 m", "hit at 0.4 m/s", "hit at 0.8 m/s", "overturned"]
SETTINGS = ["off", "on", "locked"]
FEW = 0.05  # a probability that counts as small in the advice


def probability(row, speed):
    """At a peak floor velocity: of the curve, or of the bounds of runs that have no curve."""
    if row["theta"]:
        return 0.5 * math.erfc(-math.log(speed / float(row["theta"])) / float(row["beta"]) / math.sqrt(2))
    if int(row["exceed"]) == 0:
        return 0.0
    return 1.0 if int(row["exceed"]) == int(row["runs"]) else int(row["exceed"]) / int(row["runs"])


def percent(value):
    if value < 0.005:
        return "0 %"
    return "100 %" if value > 0.995 else f"{100 * value:.0f} %"


def cell(row):
    if row["theta"]:
        mark = "*" if row["cautions"] and ("only" in row["cautions"] or "extrapolated" in row["cautions"]) else ""
        return f"{float(row['theta']):.2f} ({float(row['beta']):.2f}){mark}"
    return f"{row['exceed']} of {row['runs']}"


class Catalogue:
    def __init__(self, tables):
        with open(os.path.join(tables, "fragility.csv"), newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["measure"] == "pfv"]
        self.rows = {(r["item"], r["floor"], r["place"], r["brakes"], r["limit_state"]): r for r in rows}
        self.items = sorted({r["item"] for r in rows})
        self.floors = list(dict.fromkeys(r["floor"] for r in rows))
        with open(os.path.join(tables, "measures.csv"), newline="") as file:
            self.measures = list(csv.DictReader(file))

    def at(self, item, brakes, limit, speed, where=WHERE):
        return probability(self.rows[(item, *where, brakes, limit)], speed)

    def advice(self, item):
        """One line, by the rule of docs/catalogue/methods.md, at the higher speed of the overview."""
        speed = SPEEDS[1]
        travels = self.at(item, "off", "moved 1 m", speed)
        held = self.at(item, "on", "moved 1 m", speed)
        falls = max(self.at(item, s, "overturned", speed) for s in ("on", "locked"))
        falls_free = self.at(item, "off", "overturned", speed)
        if falls_free > FEW:
            return "**Tether it high**: it overturns even on free casters"
        if falls > FEW:
            return "**Tether it**: free it travels, with its brakes on it overturns"
        if travels <= FEW:
            return "**Leave it**: it stays within 1 m in any state of its brakes"
        if held < travels / 2:
            return "**Set the brakes**: it stays nearer and does not overturn"
        return "**Tether it**: its brakes do not hold it"


def overview(catalogue, names):
    lines = ["| item | moves 0.3 m, brakes off | moves 1 m, off | moves 1 m, on | overturns, on | overturns, locked | what to do |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for item in catalogue.items:
        both = lambda brakes, limit: ", ".join(percent(catalogue.at(item, brakes, limit, s)) for s in SPEEDS)
        lines.append(f"| [{names[item]}]({item}.md) | {both('off', 'moved 0.3 m')} | {both('off', 'moved 1 m')} | "
                     f"{both('on', 'moved 1 m')} | {both('on', 'overturned')} | {both('locked', 'overturned')} | "
                     f"{catalogue.advice(item)} |")
    return lines


def item_table(catalogue, item):
    lines = ["| floor | place | brakes | " + " | ".join(LIMITS) + " |", "| --- " * (3 + len(LIMITS)) + "|"]
    for floor in catalogue.floors:
        for place in ("open", "bay"):
            for brakes in SETTINGS:
                cells = [cell(catalogue.rows[(item, floor, place, brakes, limit)]) for limit in LIMITS]
                lines.append(f"| {floor} | {place} | {brakes} | " + " | ".join(cells) + " |")
    return lines


def best_measures(catalogue, item):
    """How often each measure predicts the displacement best."""
    count = {}
    for row in catalogue.measures:
        if row["item"] == item and row["best"]:
            count[row["best"]] = count.get(row["best"], 0) + 1
    ranked = sorted(count.items(), key=lambda each: (-each[1], each[0]))
    return ", ".join(f"{name} ({n})" for name, n in ranked[:3])


def item_page(catalogue, item, sheet):
    size = " x ".join(f"{1000 * each:.0f}" for each in sheet["size_m"])
    return [
        f"# {sheet['name']}", "", sheet["description"] + ".", "",
        f"{sheet['mass_kg']:.0f} kg, {size} mm, base over height {sheet['base_over_height']:.2f}, tips from "
        f"{sheet['tips_from_g']:.2f} g where its wheels cannot roll. Data: `equipment/items/{item}.toml`.", "",
        f"{catalogue.advice(item)} ([rule](methods.md#what-to-do)).", "",
        f"![Plan and sides](images/{item}.svg)", "",
        f"![Fragility on an upper floor of the flexible building](images/{item}_fragility.svg)", "",
        "## Fragility", "",
        "Median peak floor velocity [m/s] and, in brackets, the standard deviation of its logarithm. Without a curve: runs "
        "that exceed. `*`: few runs exceed, or the median is beyond the runs. Intervals of 95 % and the curves for the PGV of "
        "the ground are in [fragility.csv](data/fragility.csv). A hit on an open floor is that of an item that overturns.", "",
        *item_table(catalogue, item), "",
        "## Intensity measure", "",
        f"Best predictors of the peak displacement, with the number of configurations: {best_measures(catalogue, item)}.", ""]


def figures(gurney, item, results, images):
    def run(*arguments):
        subprocess.run([gurney, *arguments, "--overwrite"], check=True, stdout=subprocess.DEVNULL)

    run("equipment", "show", item, "--figure", os.path.join(images, item + ".svg"))
    chosen = [f"{WHERE[0]}, {WHERE[1]}, {brakes}" for brakes in SETTINGS]
    run("fragility", os.path.join(results, item + ".h5"), "--measure", "pfv",
        *[word for name in chosen for word in ("--configuration", name)],
        *[word for limit in ("moved 0.3 m", "moved 1 m", "overturned") for word in ("--limit", limit)],
        "--figure", os.path.join(images, item + "_fragility.svg"))


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    gurney, results, tables, pages = sys.argv[1:]
    catalogue = Catalogue(tables)
    os.makedirs(os.path.join(pages, "images"), exist_ok=True)
    names = {}
    for item in catalogue.items:
        sheet = json.loads(subprocess.run([gurney, "equipment", "show", item, "--json"], check=True,
                                          capture_output=True, text=True).stdout)
        names[item] = sheet["name"]
        figures(gurney, item, results, os.path.join(pages, "images"))
        with open(os.path.join(pages, item + ".md"), "w") as file:
            file.write("\n".join(item_page(catalogue, item, sheet)))
    with open(os.path.join(pages, "items.md"), "w") as file:
        file.write("\n".join([
            "# What to brake, what to tether, what to leave", "",
            f"Probabilities at peak floor velocities of {SPEEDS[0]} and {SPEEDS[1]} m/s on an upper floor of a flexible "
            "building, on an open floor. [Methods](methods.md), with what these numbers must not be used for.", "",
            *overview(catalogue, names), ""]))


if __name__ == "__main__":
    main()
