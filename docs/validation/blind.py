"""Compares trials of a laboratory with what a study predicted of them, trial by trial. Docs: docs/blind_protocol.md.

usage: python3 docs/validation/blind.py STUDY.h5 MEASURED.csv
Columns of MEASURED.csv: configuration, record, item, demand, value. Names are those of the study, values in SI units;
the demand is a dataset of /items, such as peak_displacement [m], or `overturned` (0 or 1).
needs python3-h5py and python3-pandas. Exit code 1: the file of trials cannot be used, and every error of it is said.
"""

import csv
import difflib
import hashlib
import math
import pathlib
import statistics
import sys

import h5py
import numpy

from results import binomial_cdf, clopper_pearson, tables_of

COLUMNS = ["configuration", "record", "item", "demand", "value"]
LEVEL = 0.95
SURE = 0.01  # of p: a constant that explains


def prediction_interval(values):
    """Interval between order statistics that contains one more trial, and how surely, whatever the distribution: of n
    draws and that trial any is the r-th with the same chance (Wilks 1941)."""
    ordered, n = sorted(values), len(values)
    r = max(1, math.floor((n + 1) * (1 - LEVEL) / 2 + 1e-9))
    return ordered[r - 1], ordered[n - r], (n + 1 - 2 * r) / (n + 1)


def ranks(values):
    """Ranks, of equal values their mean."""
    _, inverse, counts = numpy.unique(values, return_inverse=True, return_counts=True)
    return (numpy.cumsum(counts) - (counts + 1) / 2)[inverse]


def explains(drawn, demand, above):
    """Drawn constants by which the demand could be larger, or smaller: name and rank correlation, the strongest first.

    @param drawn   values of each constant, by its name, in the order of the demand
    """
    n, found = len(demand), []
    # The rank correlation of independent values is nearly normal with a variance of 1 / (n - 1); for as many constants
    # as there are (Bonferroni).
    least = -statistics.NormalDist().inv_cdf(SURE / 2 / max(1, len(drawn))) / math.sqrt(max(1, n - 1))
    for name, values in drawn.items():
        if numpy.ptp(values) and numpy.ptp(demand):
            rho = float(numpy.corrcoef(ranks(values), ranks(demand))[0, 1])
            if abs(rho) >= least:
                found.append((abs(rho), ("larger " if (rho > 0) == above else "smaller ") + name))
    return [words for _, words in sorted(found, reverse=True)]


class Study:
    def __init__(self, path):
        tables = tables_of(path, ("drawn", "records", "motions"))
        runs = tables["runs"].merge(tables["motions"][["row", "set"]], left_on="motion", right_on="row", suffixes=("", " of motion"))
        records = tables["records"]
        records["set"] = records["set"].astype(int)
        records["record"] = records.groupby("set").cumcount()
        names = records[["set", "record", "name"]].rename(columns={"name": "record name"})
        self.table = tables["items"].merge(runs, on="run").merge(names, on=["set", "record"])
        self.table["configuration name"] = self.table.configuration.map(
            tables["configurations"].set_index("row")["name"])
        self.table["overturned"] = (self.table.time_of_overturning >= 0).astype(float)
        self.drawn = tables["drawn"]
        self.demands = [name for name, column in tables["items"].items()
                        if column.dtype.kind == "f" and not name.startswith("time_of")] + ["overturned"]
        with h5py.File(path) as file:
            self.title = file.attrs["title"]

    def runs(self, configuration, record, item):
        of = self.table
        return of[(of["configuration name"] == configuration) & (of["record name"] == record) & (of.item == item)]

    def constants(self, rows):
        """What was drawn in these runs, by name."""
        drawn = self.drawn[self.drawn.configuration == rows.configuration.iloc[0]]
        values = drawn.pivot_table(index="draw", columns="variable", values="value", aggfunc="first")
        return {name: values[name].reindex(rows.draw).to_numpy(float) for name in values}


def nearest(name, names):
    near = difflib.get_close_matches(name, names, 1, 0)
    return f"; the nearest is '{near[0]}'" if near else ""


def cells_of(line):
    """Cells of a line, each with its column in it."""
    column, result = 1, []
    for cell in next(csv.reader([line])):
        found = line.find(cell, column - 1)
        column = found + 1 if found >= 0 else column
        result.append((cell.strip(), column))
        column += len(cell)
    return result


def wrong_value(demand, text):
    """Why a value cannot be one of this demand; empty if it can."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        return "must be a finite number"
    return "must be 0 or 1" if demand == "overturned" and value not in (0, 1) else ""


def read_trials(path, study):
    """Rows of the file of trials; every error of it at once."""
    known = {"configuration": set(study.table["configuration name"]), "record": set(study.table["record name"]),
             "item": set(study.table.item), "demand": set(study.demands)}
    errors, trials, header = [], [], None
    with open(path, encoding="utf-8-sig") as file:
        for number, line in enumerate(file.read().splitlines(), 1):
            if not line.strip() or line.startswith("#"):
                continue
            cells = cells_of(line)
            if header is None:
                header = [name for name, _ in cells]
                if header != COLUMNS:
                    raise SystemExit(f"{path}:{number}:1: columns are {', '.join(header)}; they must be {', '.join(COLUMNS)}")
                continue
            if len(cells) != len(COLUMNS):
                errors.append(f"{path}:{number}:1: {len(cells)} cells; there must be {len(COLUMNS)}")
                continue
            trial = {name: cell for name, (cell, _) in zip(COLUMNS, cells)}
            for name, (cell, column) in zip(COLUMNS, cells):
                wrong = (wrong_value(trial["demand"], cell) if name == "value" else "" if cell in known[name]
                         else f"is not in the study{nearest(cell, sorted(known[name]))}")
                if wrong:
                    errors.append(f"{path}:{number}:{column}: {name} '{cell}' {wrong}")
            trials.append(trial)
    if errors or not trials:
        raise SystemExit("\n".join(errors or [f"{path}: no trials"]))
    for trial in trials:
        trial["value"] = float(trial["value"])
        if not len(study.runs(trial["configuration"], trial["record"], trial["item"])):
            raise SystemExit(f"{path}: the study has no run of {trial['configuration']}, {trial['record']}, {trial['item']} together")
    return trials


def judged(study, trial):
    """Interval or share that was predicted of a trial, whether it lies within, how surely it should, and what explains
    it if it does not."""
    rows = study.runs(trial["configuration"], trial["record"], trial["item"])
    values = rows[trial["demand"]].to_numpy(float)
    if trial["demand"] == "overturned":
        share = values.mean()
        low, high = clopper_pearson(int(values.sum()), len(values))
        chance = high if trial["value"] else 1 - low  # the most that the draws allow
        words, within, surely = f"{share:.2f} ({low:.2f} to {high:.2f}) of the draws", chance > (1 - LEVEL) / 2, LEVEL
        above = bool(trial["value"])
    else:
        low, high, surely = prediction_interval(values)
        words, within, above = f"{numpy.median(values):.3g} ({low:.3g} to {high:.3g})", low <= trial["value"] <= high, trial["value"] > high
    reasons = [] if within else explains(study.constants(rows), values, above)
    return words, within, surely, reasons


def report(study, trials):
    found = [judged(study, trial) for trial in trials]
    for trial, (words, within, surely, reasons) in zip(trials, found):
        place = "within" if within else "OUTSIDE"
        yield (f"{trial['configuration']}; {trial['record']}; {trial['item']}; {trial['demand']}: measured "
               f"{trial['value']:.3g}, predicted {words}, {place} {100 * surely:.0f} %")
        if not within:
            yield "    would be explained by: " + (", ".join(reasons[:3]) or "no drawn constant")
    inside, n = sum(within for _, within, *_ in found), len(found)
    expected = sum(surely for *_, surely, _ in found)
    low, high = clopper_pearson(inside, n)
    yield (f"within {inside} of {n} ({low:.2f} to {high:.2f}); expected {expected:.1f}; as few or fewer with a chance of "
           f"{binomial_cdf(inside, n, expected / n):.2g} if the trials were independent (those of one specimen are not)")


def main(arguments):
    if len(arguments) != 2:
        raise SystemExit(__doc__)
    study = Study(arguments[0])
    digest = hashlib.sha256(pathlib.Path(arguments[0]).read_bytes()).hexdigest()
    lines = [f"prediction  {study.title}", f"sealed by   SHA-256 {digest}", *report(study, read_trials(arguments[1], study))]
    print("\n".join(lines))


if __name__ == "__main__":
    main(sys.argv[1:])
