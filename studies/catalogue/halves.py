"""Do two halves of the motions predict each other? Fits the curves on the peak floor velocity to each half.

usage: halves.py GURNEY RESULTS TABLES

TABLES gets halves.csv: for each limit state and division the number of medians that lie within the interval of
95 % which the other half gives, and how many do not.
"""

import glob
import json
import os
import sys
from concurrent.futures import ThreadPoolExecutor

from catalogue import motion_rows, record_name
from tables import output_of, write_csv

COUNTS = ["medians", "within", "bounded", "within_bounded", "no_curve"]
PLACE = "open"  # where a hit is that of an item that overturns
STATES = ["moved 0.1 m", "moved 0.3 m", "moved 1 m", "overturned"]


def divisions():
    """By turns, each half with spectra of all shapes, and the first half, of slow motions, against the last, of
    fast ones: the file has the slowest first."""
    names = [record_name(motion) for motion in motion_rows()]
    middle = len(names) // 2
    return {"by turns": (names[0::2], names[1::2]), "by shape": (names[:middle], names[middle:])}


def configurations(gurney, file):
    done = json.loads(output_of(gurney, "show", file, "--json"))
    return [each for each in done["configurations"] if each.split(", ")[1] == PLACE]


def curves(gurney, file, names, records):
    limits = [word for state in STATES for word in ("--limit", state)]
    text = output_of(gurney, "fragility", file, "--measure", "pfv", "--json", *limits, "--configuration", *names,
                     "--record", *records)
    return {(each["limit_state"], each["configuration"]): each | {"theta_interval": each.get("theta_interval") or [None, None]}
            for each in json.loads(text)["fragilities"]}  # what no interval can be stated of has one without ends


def within(median, interval):
    low, high = interval
    return (low or 0) <= median <= (float("inf") if high is None else high)


def count(first, second):
    """Of medians of each half against the interval of the other: how many there are, are within, and are
    within an interval that has both ends."""
    found = {}
    for key in first:
        for own, other in ((first[key], second[key]), (second[key], first[key])):
            tally = found.setdefault(key[0], dict.fromkeys(COUNTS, 0))
            if not (own["curve"] and other["curve"]):
                tally["no_curve"] += 1
                continue
            interval, inside = other["theta_interval"], within(own["curve"]["theta"], other["theta_interval"])
            tally["medians"] += 1
            tally["within"] += inside
            if interval[0] and interval[1] is not None:
                tally["bounded"] += 1
                tally["within_bounded"] += inside
    return found


def rows(gurney, files):
    for division, halves in divisions().items():
        def of_item(file):
            names = configurations(gurney, file)
            return count(*(curves(gurney, file, names, records) for records in halves))
        total = {}
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for found in pool.map(of_item, files):
                for state, tally in found.items():
                    for name, n in tally.items():
                        total.setdefault(state, {}).setdefault(name, 0)
                        total[state][name] += n
        for state, tally in total.items():
            yield {"division": division, "limit_state": state} | tally


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    gurney, results, tables = sys.argv[1:]
    files = sorted(glob.glob(os.path.join(results, "*.h5")))
    write_csv(os.path.join(tables, "halves.csv"),
              ["division", "limit_state", *COUNTS], rows(gurney, files))


if __name__ == "__main__":
    main()
