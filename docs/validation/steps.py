"""Compares the runs of one study made with two time steps.

usage: python3 docs/validation/steps.py COARSE.h5 FINE.h5
Runs are paired by configuration, record, angle and intensity.
"""

import sys

import numpy

from results import runs_of

KEYS = ["level brakes", "record", "angle", "intensity"]


def changes(coarse, fine):
    """Relative changes of the pairs of one intensity or of all, and how many overturned."""
    pairs = coarse.merge(fine, on=KEYS, suffixes=("", " fine"))
    standing = pairs[~pairs.overturned & ~pairs["overturned fine"]]
    print(f"{len(pairs)} pairs; overturned: {pairs.overturned.sum()} and {pairs['overturned fine'].sum()} with the finer "
          f"step, {(pairs.overturned & pairs['overturned fine']).sum()} in both")
    for demand in ("peak_displacement", "residual_displacement"):
        change = (standing[demand] / standing[demand + " fine"] - 1).abs()
        difference = (standing[demand] - standing[demand + " fine"]).abs()
        print(f"  {demand}: {(change > 0.01).sum()} of {len(change)} change by more than 1 %, {(change > 0.05).sum()} by "
              f"more than 5 %; median {100 * change.median():.2f} %, largest {100 * change.max():.0f} %; 90th percentile "
              f"of the difference {difference.quantile(0.9):.3f} m")
    ratio = numpy.log(standing["peak_displacement fine"] / standing.peak_displacement)
    print(f"  mean of the logarithm of peak_displacement, finer over coarser: {ratio.mean():.3f} +- "
          f"{1.96 * ratio.std() / len(ratio) ** 0.5:.3f} (95 %)")
    quiet = standing[(standing.impacts == 0) & (standing["impacts fine"] == 0)]
    change = (quiet.peak_displacement / quiet["peak_displacement fine"] - 1).abs()
    print(f"  without impacts: peak_displacement of {(change <= 0.01).sum()} of {len(change)} within 1 %")
    for level, rows in pairs.groupby("intensity"):
        print(f"  at {level:g}: median peak_displacement {rows.peak_displacement.median():.3f} and "
              f"{rows['peak_displacement fine'].median():.3f} m, overturned {rows.overturned.sum()} and "
              f"{rows['overturned fine'].sum()}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    changes(runs_of(sys.argv[1]), runs_of(sys.argv[2]))
