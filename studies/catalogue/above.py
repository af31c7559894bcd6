"""Counts for each curve, at each velocity of losses.csv, how many motions exceed just above it.

usage: above.py RESULTS TABLES

RESULTS is a folder of catalogue.py. TABLES gets above.csv, for the peak velocity of the floor (pfv) and of the ground
(PGV larger): of each motion the run of the lowest one at or above the stated one; how many exceed, of how many. As a stronger shaking is no safer, the chance at the velocity is at
most that of these runs (docs/catalogue/methods.md, Uncertainty).
"""

import glob
import os
import sys

import numpy

from losses import SPEEDS
from sufficiency import EXCEEDS, Runs
from tables import write_csv

def nearest_above(motion, speeds, speed):
    """Of each motion that has a run at `speed` or above, the index of its lowest one."""
    order = numpy.argsort(speeds, kind="stable")
    order = order[speeds[order] >= speed * (1 - 1e-9)]
    return order[numpy.unique(motion[order], return_index=True)[1]]


def rows(item, runs):
    settings = numpy.stack([runs.floor, runs.place, runs.brakes])
    measures = {"pfv": numpy.exp(runs.measures["pfv"]), "PGV larger": runs.ground}
    of = {state: exceeds(runs.items) for state, exceeds in EXCEEDS.items()}
    for floor, place, brakes in dict.fromkeys(map(tuple, settings.T)):
        own = numpy.flatnonzero((settings == numpy.array([[floor], [place], [brakes]])).all(axis=0))
        for measure, speeds in measures.items():
            chosen = {speed: own[nearest_above(runs.motion[own], speeds[own], speed)] for speed in SPEEDS}
            for state, exceeds in of.items():
                yield {"item": item, "floor": floor, "place": place, "brakes": brakes, "limit_state": state,
                       "measure": measure} | {
                    speed: f"{int(exceeds[runs_of].sum())}/{len(runs_of)}" for speed, runs_of in chosen.items()}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, tables = sys.argv[1:]
    write_csv(os.path.join(tables, "above.csv"), ["item", "floor", "place", "brakes", "limit_state", "measure", *SPEEDS],
              [row for path in sorted(glob.glob(os.path.join(results, "*.h5")))
               for row in rows(os.path.basename(path)[:-3], Runs(path))])


if __name__ == "__main__":
    main()
