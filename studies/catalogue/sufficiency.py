"""Tests whether the peak floor velocity (PFV) is sufficient: whether floors of equal PFV have equal chances.

usage: sufficiency.py RESULTS TABLES

RESULTS is a folder of catalogue.py. TABLES gets sufficiency.csv, a row for each item, place, setting of the brakes and
limit state: the test with the PFV, and with the PFV and the peak floor acceleration (PFA), whose coefficients are the
curve on both. docs/catalogue/checks.md has the outcome. Needs statsmodels.
"""

import glob
import os
import sys
import warnings

import h5py
import numpy
from statsmodels.discrete.discrete_model import Probit
from statsmodels.tools.sm_exceptions import ConvergenceWarning, PerfectSeparationError

from tables import number, setting_of, write_csv
from variance import holm, text

def overturned(items):
    return items["time_of_overturning"] >= 0


def moved(metres):
    return lambda items: (items["peak_displacement"] > metres) | overturned(items)


def hit(speed):
    return lambda items: items["largest_approach_speed"] > speed


EXCEEDS = {  # the limit states of item_study.toml.in
    "moved 0.1 m": moved(0.1), "moved 0.3 m": moved(0.3), "moved 1 m": moved(1),
    "hit at 0.4 m/s": hit(0.4), "hit at 0.8 m/s": hit(0.8), "overturned": overturned,
}
TESTED = ("moved 0.3 m", "moved 1 m", "overturned")
LEAST = 5  # outcomes of either kind that a floor has, or it is left out
MEASURES = {"pfv": ["pfv"], "vector": ["pfv", "pfa"]}
COLUMNS = ["item", "place", "brakes", "limit_state", "floors", "runs", "exceed", "ratio_pfv",
           *(name + end for end in MEASURES for name in ("p_", "p_holm_", "off_")), "constant", "ln_pfv", "ln_pfa"]


def fitted(exceeds, columns, motion):
    """Probit whose covariance lets runs of a motion depend on each other (Liang & Zeger 1986, Biometrika 73)."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", ConvergenceWarning)
        return Probit(exceeds, columns).fit(disp=False, cov_type="cluster", cov_kwds={"groups": motion})


def sufficiency(exceeds, measures, floor, motion):
    """Wald test of P = Phi(sum b_i ln m_i + a_floor) against one a for all floors.

    Returns p and the ratio of the largest to the smallest median of the floors, exp((max a - min a) / b) with b that
    of the first measure and the others held; p is of F with as many degrees of freedom as motions less one, as few
    clusters make a chi-squared reject too often.

    @param exceeds   of each run
    @param measures  [run, measure] logarithms
    """
    floors = numpy.unique(floor)
    indicators = (floor[:, None] == floors).astype(float)
    result = fitted(exceeds, numpy.hstack([measures, indicators]), motion)
    contrasts = numpy.zeros((len(floors) - 1, measures.shape[1] + len(floors)))
    contrasts[:, measures.shape[1]] = -1
    contrasts[:, measures.shape[1] + 1:] = numpy.eye(len(floors) - 1)
    found = result.wald_test(contrasts, use_f=True, scalar=True, df_constraints=len(contrasts))
    of_floors = result.params[measures.shape[1]:]
    return float(found.pvalue), float(numpy.exp(numpy.ptp(of_floors) / result.params[0]))


def pooled(exceeds, measures, floor, motion):
    """Coefficients of one curve for all floors, and the most that its chance is off on a floor: |mean of what it
    expects - share that exceeds|."""
    columns = numpy.column_stack([numpy.ones(len(exceeds)), measures])
    result = fitted(exceeds, columns, motion)
    rest = exceeds - result.predict(columns)
    return result.params, max(abs(rest[floor == each].mean()) for each in numpy.unique(floor))


class Runs:
    """Floors, motions, measures and outcomes of the runs of an item's study that did not fail."""

    def __init__(self, path):
        with h5py.File(path) as file:
            self.items = {name: file["items"][name][:] for name in ("run", "peak_displacement",
                                                                       "largest_approach_speed", "time_of_overturning")}
            run = self.items["run"]
            settings = numpy.array([setting_of(text(name)) for name in file["configurations/name"][:]])
            self.floor, self.place, self.brakes = settings[file["runs/configuration"][:][run]].T
            self.motion = file["runs/record"][:][run]
            self.ground = file["runs/intensity"][:][run]  # [m/s] PGV, larger
            self.measures = {name: numpy.log(file["runs"][name][:][run]) for name in ("pfv", "pfa")}

    def rows(self):
        for place, brakes in dict.fromkeys(zip(self.place, self.brakes)):
            own = (self.place == place) & (self.brakes == brakes)
            for state in TESTED:
                yield {"place": place, "brakes": brakes, "limit_state": state} | self.row(own, EXCEEDS[state](self.items))

    def row(self, own, exceeds):
        counts = {floor: exceeds[own & (self.floor == floor)] for floor in numpy.unique(self.floor[own])}
        used = [floor for floor, of in counts.items() if LEAST <= of.sum() <= len(of) - LEAST]
        own = own & numpy.isin(self.floor, used)
        row = {"floors": len(used), "runs": int(own.sum()), "exceed": int(exceeds[own].sum())}
        if len(used) < 2:
            return row
        outcome, floor, motion = exceeds[own].astype(float), self.floor[own], self.motion[own]
        try:
            for end, names in MEASURES.items():
                measures = numpy.column_stack([self.measures[name][own] for name in names])
                row["p_" + end], ratio = sufficiency(outcome, measures, floor, motion)
                coefficients, row["off_" + end] = pooled(outcome, measures, floor, motion)
                row.setdefault("ratio_pfv", ratio)
        except (PerfectSeparationError, ConvergenceWarning, numpy.linalg.LinAlgError):
            return {name: row[name] for name in ("floors", "runs", "exceed")}
        return row | dict(zip(("constant", "ln_pfv", "ln_pfa"), map(number, coefficients)))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, tables = sys.argv[1:]
    rows = [{"item": os.path.basename(path)[:-3]} | row for path in sorted(glob.glob(os.path.join(results, "*.h5")))
            for row in Runs(path).rows()]
    tested = [row for row in rows if "constant" in row]
    for end in MEASURES:
        for row, adjusted in zip(tested, holm(numpy.array([row["p_" + end] for row in tested]))):
            row["p_holm_" + end] = f"{adjusted:.4f}"
    for row in tested:
        row["ratio_pfv"] = f"{row['ratio_pfv']:.2f}"
        row |= {name + end: f"{row[name + end]:{form}}" for end in MEASURES for name, form in (("p_", ".2g"), ("off_", ".3f"))}
    write_csv(os.path.join(tables, "sufficiency.csv"), COLUMNS, rows)


if __name__ == "__main__":
    main()
