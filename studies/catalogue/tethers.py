"""What straps change for each item in its bay (docs/catalogue/methods.md, Tethers).

usage: tethers.py GURNEY OUTPUT TABLES [--items a,b] [--threads N]

OUTPUT gets motions, jobs and results as of catalogue.py; TABLES gets tethers.csv: expected days out of use and chance
of lost service with nothing, brakes, straps, and the tension of the straps.
"""

import argparse
import csv
import json
import math
import os
import statistics
import subprocess
import tempfile

import catalogue
import losses
from tables import curve_row, fitted, number, write_csv

SPEED = 0.8  # [m/s] peak floor velocity of the losses, PGV of the tensions
HEIGHT = 0.7  # of the strap over that of the item, an assumption between 0.5 and 1
SLACK = 0.05  # [m] beyond the distance to the anchor, an assumption between 0 and 0.2
BESIDE = 0.2  # [m] from the corners of the item to the anchors of two straps, along the wall
COLUMNS = ["item", "held", "runs", "overturned", "hit at 0.8 m/s", "failed", *(
    quantity + end for quantity in ("days", "lost") for end in ("", "_low", "_high")),
    "tension_median_n", "tension_p95_n", "broken", "best", "share"]


def strap(name, point, anchor):
    slack = math.dist(point, anchor) + SLACK
    place = lambda at: "[" + ", ".join(f"{x:.3f}" for x in at) + "]"
    return (f'{{ name = "{name}", kind = "strap", point_m = {place(point)}, anchor_m = {place(anchor)}, '
            f"slack_length_m = {slack:.3f} }}")


def held(size):
    """The levels of the study: how the item is held."""
    length, width, height = size
    back, up = -length / 2, HEIGHT * height
    wall = back - catalogue.GAP_BACK
    one = strap("strap", (back, 0, up), (wall, 0, up))
    two = [strap(f"{side} strap", (back, sign * width / 2, up), (wall, sign * (width / 2 + BESIDE), up))
           for side, sign in (("left", 1), ("right", -1))]
    free, braked = "item.brakes = false\n", "item.brakes = true\n"
    return {"nothing": free, "brakes": braked, "one strap": free + f"tether = [{one}]\n",
            "two straps": free + f"tether = [{', '.join(two)}]\n",
            "one strap, brakes": braked + f"tether = [{one}]\n"}


def job_text(gurney, item, jobs, suite):
    size = catalogue.sheet_of(gurney, item)["size_m"]
    with open(os.path.join(catalogue.HERE, "item_study.toml.in")) as file:
        whole = file.read()
    words = catalogue.bay_words(size) | {
        "ITEM": item, "SUITE": os.path.relpath(suite, jobs), "ROOT": os.path.relpath(catalogue.ROOT, jobs),
        "LEVELS": json.dumps(catalogue.LEVELS_OF_CURVES),
        "LIMIT_STATES": whole[whole.index("[[study.limit_state]]"):],
        "HELD": "".join(f'[study.factor.level."{name}"]\n{text}' for name, text in held(size).items())}
    return catalogue.filled("tether_study.toml.in", words)


def tensions(gurney, results):
    """By configuration: the largest tension of each run at a PGV of SPEED, and how many straps broke in all runs."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([gurney, "export", results, "--to", "csv", "-o", folder, "--overwrite"], check=True,
                       stdout=subprocess.DEVNULL)

        def read(name):
            with open(os.path.join(folder, name), newline="") as file:
                return list(csv.DictReader(file))[1:]  # after the units

        names = {row["row"]: row["name"] for row in read("configurations.csv")}
        runs, largest, broken = {row["run"]: row for row in read("runs.csv")}, {}, {}
        for row in read("tethers.csv"):
            run = runs[row["run"]]
            of = names[run["configuration"]]
            broken[of] = broken.get(of, 0) + (float(row["time_broken"]) >= 0)
            if float(run["intensity"]) == SPEED:
                by_run = largest.setdefault(of, {})
                by_run[row["run"]] = max(by_run.get(row["run"], 0), float(row["peak_tension"]))
    return {of: sorted(each.values()) for of, each in largest.items()}, broken


def rows(gurney, item, results):
    curves = {}
    for each in fitted(gurney, results, "--measure", "pfv"):
        curves.setdefault(each["configuration"], {})[each["limit_state"]] = curve_row(item, "pfv", each)
    of = losses.consequences()
    samples = losses.samples_of(curves, lambda quantity: of(item, quantity), SPEED, f"tethers {item}")
    best, share = losses.best_of(samples["days"])
    pulled, broken = tensions(gurney, results)
    for name, states in curves.items():
        row = {"item": item, "held": name, "best": best, "share": share}
        row |= {key: states["overturned"][key] for key in ("runs", "failed")}
        row |= {state: states[state]["exceed"] for state in ("overturned", "hit at 0.8 m/s")}
        for quantity in ("days", "lost"):
            row |= dict(zip((quantity, quantity + "_low", quantity + "_high"), losses.cells(samples[quantity], name)))
        if name in pulled:
            of_runs = pulled[name]
            row |= {"tension_median_n": number(statistics.median(of_runs)),
                    "tension_p95_n": number(of_runs[math.ceil(0.95 * len(of_runs)) - 1]), "broken": broken[name]}
        yield row


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gurney")
    parser.add_argument("output")
    parser.add_argument("tables")
    parser.add_argument("--items", help="of items.csv (default: all)")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_args()
    jobs, suite = os.path.join(options.output, "jobs"), os.path.join(options.output, "motions")
    os.makedirs(jobs, exist_ok=True)
    catalogue.make_motions(options.gurney, suite, catalogue.MOTIONS)
    found = []
    for item in (row["item"] for row in catalogue.chosen_items(options.items)):
        print(item, flush=True)
        job, results = os.path.join(jobs, item + ".toml"), os.path.join(options.output, item + ".h5")
        with open(job, "w") as file:
            file.write(job_text(options.gurney, item, jobs, suite))
        catalogue.run(options.gurney, job, results, options.threads)
        found += rows(options.gurney, item, results)
    os.makedirs(options.tables, exist_ok=True)
    write_csv(os.path.join(options.tables, "tethers.csv"), COLUMNS, found)


if __name__ == "__main__":
    main()
