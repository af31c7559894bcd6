"""Shares of record, parameters and chaos in the variance of the displacement, and which constants matter.

usage: variance.py RESULTS TABLES

RESULTS is a folder of catalogue.py --variance: motions with draws of each, and replicas of each draw.
TABLES gets variance.csv and constants.csv. docs/catalogue/methods.md says what is in them.
"""

import glob
import os
import sys

import h5py
import numpy

from tables import number, setting_of, write_csv

AT_LEAST = 0.01  # [m] less is the noise of an item at rest
OVERTURNED = 1.0  # [m] at least; how far an item goes that overturns is no displacement on its wheels
PERMUTATIONS, SEED = 9999, 1
CONSTANTS = [  # what a laboratory can measure; the means of the casters of an item
    "chassis.mass_kg", "chassis.center_of_mass_mm.x", "chassis.center_of_mass_mm.y", "chassis.center_of_mass_mm.z",
    "payload[0].mass_kg", "tread.rolling_resistance_mm", "tread.static_friction", "tread.patch_width_mm",
    "tread.normal_stiffness_n_per_m", "tread.normal_damping_n_s_per_m", "trail_mm", "brake_torque_n_m", "floor slope"]


def components(values):
    """Variance components of values[record, draw, replica], a balanced nested design of random effects.

    Each mean square has the expectation (Searle, Casella & McCulloch 1992, Variance Components, chapter 4)
        E(MS_chaos) = s_c^2,  E(MS_draw) = s_c^2 + r s_d^2,  E(MS_record) = s_c^2 + r s_d^2 + r d s_r^2
    with r replicas and d draws. Components below 0 are set to 0.
    """
    records, draws, replicas = values.shape
    of_draw, of_record = values.mean(axis=2), values.mean(axis=(1, 2))
    chaos = ((values - of_draw[:, :, None]) ** 2).sum() / (records * draws * (replicas - 1))
    draw = replicas * ((of_draw - of_record[:, None]) ** 2).sum() / (records * (draws - 1))
    record = replicas * draws * ((of_record - of_record.mean()) ** 2).sum() / (records - 1)
    return (max(0.0, (record - draw) / (replicas * draws)), max(0.0, (draw - chaos) / replicas), chaos)


def shares(values):
    parts = numpy.array(components(values))
    return parts / parts.sum() if parts.sum() > 0 else numpy.full(3, numpy.nan)


def intervals(values, resamples=2000):
    """Intervals of 95 % of the shares: percentiles over resampled records."""
    random = numpy.random.default_rng(SEED)
    found = [shares(values[random.integers(len(values), size=len(values))]) for _ in range(resamples)]
    return numpy.nanpercentile(found, [2.5, 97.5], axis=0)


def text(value):
    return value.decode() if isinstance(value, bytes) else value


class Study:
    """Runs of one configuration as arrays [record, draw, replica]."""

    def __init__(self, path):
        self.file = h5py.File(path)
        self.names = [text(name) for name in self.file["configurations/name"][:]]
        self.runs = {name: self.file["runs"][name][:] for name in ("configuration", "record", "draw", "replica")}
        self.items = {name: self.file["items"][name][:]
                      for name in ("run", "peak_displacement", "time_of_overturning")}

    def responses(self, configuration):
        """The draws of each record, and of each run ln displacement and whether it overturned. A record with a
        failed run is left out."""
        row, index = {run: i for i, run in enumerate(self.items["run"])}, {}
        for run in numpy.flatnonzero(self.runs["configuration"] == configuration):
            of_record = index.setdefault(self.runs["record"][run], {})
            of_record.setdefault(int(self.runs["draw"][run]), []).append(row.get(run))
        complete = [of_record for of_record in index.values() if None not in sum(of_record.values(), [])]
        rows = numpy.array([[of_record[draw] for draw in sorted(of_record)] for of_record in complete])
        draws = numpy.array([sorted(of_record) for of_record in complete])
        moved = self.items["peak_displacement"][rows]
        fell = self.items["time_of_overturning"][rows] >= 0
        moved = numpy.where(fell, numpy.maximum(moved, OVERTURNED), numpy.maximum(moved, AT_LEAST))
        return draws, numpy.log(moved), fell

    def constants(self, configuration, draws):
        """Name and values [record, draw] of each constant that is drawn."""
        drawn = self.file["drawn"]
        own = drawn["configuration"][:] == configuration
        variables = numpy.array([text(name) for name in drawn["variable"][:][own]])
        values, of_draw = drawn["value"][:][own], drawn["draw"][:][own]
        for constant in CONSTANTS:
            is_slope = constant == "floor slope"
            members = {v for v in variables if (v in ("floor/slope", "floor/cross_slope") if is_slope
                                                else v == constant or v.endswith("/" + constant))}
            if members:
                tables = [dict(zip(of_draw[variables == v], values[variables == v])) for v in sorted(members)]
                stack = numpy.array([[[table[d] for d in row] for row in draws] for table in tables])
                yield constant, numpy.hypot(*stack) if is_slope else stack.mean(axis=0)


def ranks(values):
    """Ranks among all draws, less the mean of each record: what the records differ by is gone."""
    order = values.ravel().argsort(kind="stable").argsort().reshape(values.shape).astype(float)
    return order - order.mean(axis=1, keepdims=True)


def rank_correlation(constant, response):
    a, b = ranks(constant).ravel(), ranks(response).ravel()
    return float(a @ b / numpy.sqrt((a @ a) * (b @ b)))


def p_value(constant, response):
    """Share of permutations of the draws within records with a correlation at least as large; exact but for
    the number of permutations."""
    random, found = numpy.random.default_rng(SEED), abs(rank_correlation(constant, response))
    a, b = ranks(constant), ranks(response)
    most = found * numpy.sqrt((a ** 2).sum() * (b ** 2).sum()) * (1 - 1e-12)
    beyond = sum(abs((a * random.permuted(b, axis=1)).sum()) >= most for _ in range(PERMUTATIONS))
    return (beyond + 1) / (PERMUTATIONS + 1)


def holm(p):
    """Adjusted for the number of constants (Holm 1979, Scandinavian J. of Statistics 6(2), 65-70)."""
    adjusted, worst = numpy.empty(len(p)), 0.0
    for rank, i in enumerate(numpy.argsort(p)):
        worst = max(worst, min(1.0, (len(p) - rank) * p[i]))
        adjusted[i] = worst
    return adjusted


def variance_rows(item, study):
    for configuration, name in enumerate(study.names):
        _, moved, fell = study.responses(configuration)
        for response, values in (("ln displacement", moved), ("overturned", fell.astype(float))):
            if values.std() == 0:
                continue
            low, high = intervals(values)
            row = {"item": item, "brakes": setting_of(name)[2], "response": response, "records": values.shape[0],
                   "draws": values.shape[1], "replicas": values.shape[2], "overturned": int(fell.sum()),
                   "runs": fell.size, "deviation": number(numpy.sqrt(sum(components(values))))}
            for i, part in enumerate(("record", "parameters", "chaos")):
                row |= {part: f"{shares(values)[i]:.2f}", part + "_low": f"{low[i]:.2f}",
                        part + "_high": f"{high[i]:.2f}"}
            yield row


def constant_rows(item, study):
    for configuration, name in enumerate(study.names):
        draws, moved, _ = study.responses(configuration)
        response = moved.mean(axis=2)
        found = [(constant, rank_correlation(values, response), p_value(values, response))
                 for constant, values in study.constants(configuration, draws)]
        adjusted = holm([p for _, _, p in found])
        for (constant, r, p), holm_p in sorted(zip(found, adjusted), key=lambda each: -abs(each[0][1])):
            yield {"item": item, "brakes": setting_of(name)[2], "constant": constant, "correlation": f"{r:.2f}",
                   "p": f"{p:.4f}", "p_holm": f"{holm_p:.4f}"}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, tables = sys.argv[1:]
    variances, constants = [], []
    for path in sorted(glob.glob(os.path.join(results, "*.h5"))):
        item, study = os.path.basename(path)[:-3], Study(path)
        variances += variance_rows(item, study)
        constants += constant_rows(item, study)
    parts = [part + end for part in ("record", "parameters", "chaos") for end in ("", "_low", "_high")]
    write_csv(os.path.join(tables, "variance.csv"),
              ["item", "brakes", "response", "records", "draws", "replicas", "runs", "overturned", "deviation", *parts],
              variances)
    write_csv(os.path.join(tables, "constants.csv"),
              ["item", "brakes", "constant", "correlation", "p", "p_holm"], constants)


if __name__ == "__main__":
    main()
