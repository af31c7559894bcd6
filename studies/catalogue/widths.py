"""How many motions are needed: widths of the intervals of the medians with a quarter, a half and all of the motions.

usage: widths.py GURNEY RESULTS MOTIONS.csv OUTPUT.csv

The parts are taken by turns, so that they are disjoint and each has motions of all kinds. The width is the
upper end of the interval of 95 % over the lower one, infinite where one of them is missing.
"""

import glob
import math
import os
import statistics
import sys
from concurrent.futures import ThreadPoolExecutor

from catalogue import motion_rows, record_name
from halves import STATES, configurations, curves
from tables import number, write_csv

COLUMNS = ["limit_state", "motions", "curves", "bounded", "median_width", "no_curve"]


def parts(names):
    """The disjoint parts of a quarter, a half, and all."""
    for step in (4, 2, 1):
        yield len(names) // step, [names[first::step] for first in range(step)]


def width(interval):
    low, high = interval
    return high / low if low and high is not None else math.inf


def rows(gurney, files, names):
    for size, sets in parts(names):
        widths, without = {state: [] for state in STATES}, dict.fromkeys(STATES, 0)
        def of_item(file):
            return [curves(gurney, file, configurations(gurney, file), part) for part in sets]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for found in (each for parts_of_item in pool.map(of_item, files) for each in parts_of_item):
                for (state, _), each in found.items():
                    if each["curve"]:
                        widths[state].append(width(each["theta_interval"]))
                    else:
                        without[state] += 1
        for state, found in widths.items():
            yield {"limit_state": state, "motions": size, "curves": len(found),
                   "bounded": sum(map(math.isfinite, found)), "no_curve": without[state],
                   "median_width": number(statistics.median(found)) if found else ""}


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    gurney, results, motions, output = sys.argv[1:]
    names = [record_name(motion) for motion in motion_rows(motions)]
    found = sorted(rows(gurney, sorted(glob.glob(os.path.join(results, "*.h5"))), names),
                   key=lambda row: STATES.index(row["limit_state"]))
    write_csv(output, COLUMNS, found)
    for row in found:
        print(f"{row['limit_state']:13} {row['motions']:3} motions: {row['curves']:3} curves, {row['bounded']:3} with both "
              f"ends, median width {row['median_width']}")


if __name__ == "__main__":
    main()
