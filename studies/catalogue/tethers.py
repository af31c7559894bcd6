"""What straps change for each item in its bay (docs/catalogue/methods.md, Tethers).

usage: tethers.py GURNEY OUTPUT TABLES [--items a,b] [--held HOW] [--threads N]

OUTPUT gets motions, jobs and results as of catalogue.py; TABLES gets tethers.csv: expected days out of use and chance
of lost service with nothing, brakes, straps, the tension of the straps, and how far the item goes and turns.
"""

import csv
import functools
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
HELD = ("nothing", "brakes", "one strap", "two straps", "one strap, brakes")
# Quantities of the runs at a PGV of SPEED: table and column of the results, and the unit in SI.
DEMANDS = {"tension_n": ("tethers", "peak_tension", 1), "displacement_m": ("items", "peak_displacement", 1),
           "yaw_deg": ("items", "peak_yaw", math.radians(1))}
COLUMNS = ["item", "held", "runs", "overturned", "hit at 0.8 m/s", "failed", *(
    quantity + end for quantity in ("days", "lost") for end in ("", "_low", "_high")), *(
    quantity + end for quantity in DEMANDS for end in ("_median", "_p95")), "broken", "best", "share"]


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


def job_text(gurney, item, jobs, suite, only=None):
    """The job of an item: all of HELD, or only one of them."""
    size = catalogue.sheet_of(gurney, item)["size_m"]
    with open(os.path.join(catalogue.HERE, "item_study.toml.in")) as file:
        whole = file.read()
    words = catalogue.bay_words(size) | {
        "ITEM": item, "SUITE": os.path.relpath(suite, jobs), "ROOT": os.path.relpath(catalogue.ROOT, jobs),
        "LEVELS": json.dumps(catalogue.LEVELS_OF_CURVES),
        "LIMIT_STATES": whole[whole.index("[[study.limit_state]]"):],
        "HELD": "".join(f'[study.factor.level."{name}"]\n{text}' for name, text in held(size).items() if only in (None, name))}
    return catalogue.filled("tether_study.toml.in", words)


def exported(gurney, results):
    """The tables of results as rows by column, by the table's name."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([gurney, "export", results, "--to", "csv", "-o", folder, "--overwrite"], check=True,
                       stdout=subprocess.DEVNULL)

        def read(name):
            with open(os.path.join(folder, name + ".csv"), newline="") as file:
                return list(csv.DictReader(file))[1:]  # after the units

        return {name: read(name) for name in ("configurations", "runs", "items", "tethers")}


def demands(gurney, results):
    """Values of each quantity of DEMANDS in the runs at a PGV of SPEED, increasing, and the number of straps that
    broke in all runs, both by configuration."""
    tables = exported(gurney, results)
    names = {row["row"]: row["name"] for row in tables["configurations"]}
    runs = {row["run"]: row for row in tables["runs"]}
    of_runs, broken = {}, {}
    for quantity, (table, column, unit) in DEMANDS.items():
        for row in tables[table]:
            run = runs[row["run"]]
            if float(run["intensity"]) == SPEED:
                of = of_runs.setdefault((names[run["configuration"]], quantity), {})
                of[row["run"]] = max(of.get(row["run"], 0), abs(float(row[column])) / unit)
    for row in tables["tethers"]:
        of = names[runs[row["run"]]["configuration"]]
        broken[of] = broken.get(of, 0) + (float(row["time_broken"]) >= 0)
    return {key: sorted(each.values()) for key, each in of_runs.items()}, broken


def rows(gurney, item, results):
    curves = {}
    for each in fitted(gurney, results, "--measure", "pfv"):
        curves.setdefault(each["configuration"], {})[each["limit_state"]] = curve_row(item, "pfv", each)
    of = losses.consequences()
    samples = losses.samples_of(curves, lambda quantity: of(item, quantity), SPEED, f"tethers {item}")
    best = losses.best_of(samples["days"])
    share = losses.share_of(samples["days"], best)
    of_runs, broken = demands(gurney, results)
    for name, states in curves.items():
        row = {"item": item, "held": name, "best": best, "share": share}
        row |= {key: states["overturned"][key] for key in ("runs", "failed")}
        row |= {state: states[state]["exceed"] for state in ("overturned", "hit at 0.8 m/s")}
        for quantity in ("days", "lost"):
            row |= dict(zip((quantity, quantity + "_low", quantity + "_high"), losses.cells(samples[quantity], name)))
        for quantity in DEMANDS:
            if values := of_runs.get((name, quantity)):
                row |= {f"{quantity}_median": number(statistics.median(values)),
                        f"{quantity}_p95": number(values[math.ceil(0.95 * len(values)) - 1])}
        yield row | {"broken": broken.get(name, "")}


def main():
    parser = catalogue.options_of_studies(__doc__.splitlines()[0])
    parser.add_argument("--held", help=f"one of {', '.join(HELD)} (default: all)")
    options = parser.parse_args()
    text_of = functools.partial(job_text, only=options.held)
    items = [row["item"] for row in catalogue.chosen_items(options.items)]
    found = []
    for item, results in catalogue.studied(options.gurney, options.output, items, text_of, options.threads):
        found += rows(options.gurney, item, results)
    os.makedirs(options.tables, exist_ok=True)
    write_csv(os.path.join(options.tables, "tethers.csv"), COLUMNS, found)


if __name__ == "__main__":
    main()
