"""Peak velocities of the floors of the small hospital, from a study of the catalogue.

usage: demands.py RESULTS OUTPUT

RESULTS is any item's file that catalogue.py made, since the floors move alike under all items. OUTPUT gets
median and dispersion of the peak floor velocity over the motions, scaled to a PGV of 0.4 m/s of the larger
horizontal component of the ground.
"""

import csv
import sys

import h5py
import numpy

PGV = 0.4  # [m/s]
LOCATIONS = {"ground": 0, "flexible building": 3}
COLUMNS = ["floor", "location", "median_m_per_s", "beta"]


def rows(results, floors=tuple(LOCATIONS)):
    with h5py.File(results) as file:
        names = [name.decode() for name in file["configurations/name"][:]]
        runs = {name: file["runs"][name][:] for name in ("configuration", "intensity", "pfv")}
    for floor in floors:
        configuration = next(i for i, name in enumerate(names) if name.startswith(floor + ", "))
        chosen = (runs["configuration"] == configuration) & numpy.isclose(runs["intensity"], PGV)
        logarithms = numpy.log(runs["pfv"][chosen])
        yield {"floor": floor, "location": LOCATIONS[floor],
               "median_m_per_s": f"{numpy.exp(logarithms.mean()):.3f}", "beta": f"{logarithms.std(ddof=1):.3f}"}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[2], "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows(sys.argv[1]))


if __name__ == "__main__":
    main()
