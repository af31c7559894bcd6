"""What the studies of the catalogue consist of: counts of runs, and how the floors move.

usage: runs.py RESULTS TABLES

RESULTS is a folder of catalogue.py. TABLES gets runs.csv (a row for each item: how many overturned and failed) and floors.csv (a row for each floor and level: peaks of the floor, and in how many motions the
building is beyond what its model is good for).
"""

import glob
import os
import sys

import h5py
import numpy

from tables import number, write_csv

RUNS = ["item", "runs", "overturned", "failed", "failed_runs"]
FLOORS = ["floor", "pgv", "motions", "pfv", "pfv_p16", "pfv_p84", "pfa_g", "pfa_p16_g", "pfa_p84_g", "beyond_drift",
          "beyond_capacity"]
DRIFT, CAPACITY = b"peak storey drift", b"isolators: peak displacement"


def warned(file, beginning):
    """Runs with a warning that begins so."""
    return {int(run) for run, text in zip(file["warnings/run"][:], file["warnings/warning"][:])
            if text.startswith(beginning)}


def run_row(item, path):
    with h5py.File(path) as file:
        outcome = file["runs/outcome"][:]
        failed = sorted(int(run) for run in file["failures/run"][:])
    return {"item": item, "runs": len(outcome), "overturned": int((outcome == b"overturned").sum()),
            "failed": len(failed), "failed_runs": " ".join(map(str, failed))}


def quantiles(name, values, unit=""):
    low, middle, high = numpy.quantile(values, [0.16, 0.5, 0.84])
    return {name + unit: number(middle), f"{name}_p16{unit}": number(low), f"{name}_p84{unit}": number(high)}


def floor_rows(path):
    """The floors move alike under all items."""
    with h5py.File(path) as file:
        floor_of = numpy.array([name.decode() for name in file["configurations/floor"][:]])
        runs = {name: file[f"runs/{name}"][:] for name in ("configuration", "intensity", "pfv", "pfa", "run")}
        beyond = {"beyond_drift": warned(file, DRIFT), "beyond_capacity": warned(file, CAPACITY)}
    levels = numpy.round(runs["intensity"], 6)
    for floor in dict.fromkeys(floor_of):
        first = int(numpy.argmax(floor_of == floor))  # its configurations have the same motions
        for level in numpy.unique(levels):
            at = (runs["configuration"] == first) & (levels == level)
            of_floor = {int(run) for run in runs["run"][at]}
            yield ({"floor": floor, "pgv": number(level), "motions": int(at.sum())} |
                   quantiles("pfv", runs["pfv"][at]) | quantiles("pfa", runs["pfa"][at] / 9.80665, "_g") |
                   {name: len(of_floor & all_runs) for name, all_runs in beyond.items()})


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, tables = sys.argv[1:]
    files = sorted(glob.glob(os.path.join(results, "*.h5")))
    write_csv(os.path.join(tables, "runs.csv"), RUNS, [run_row(os.path.basename(path)[:-3], path) for path in files])
    write_csv(os.path.join(tables, "floors.csv"), FLOORS, floor_rows(files[0]))


if __name__ == "__main__":
    main()
