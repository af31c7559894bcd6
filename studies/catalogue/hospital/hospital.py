"""Damage of a small hospital, computed by pelicun with the curves of the catalogue.

usage: hospital.py PELICUN OUTPUT [SAMPLES]

PELICUN is a folder that holds the package pelicun, OUTPUT a CSV file. contents.csv lists the items of the
hospital, demands.csv the peak floor velocities of its floors (docs/catalogue/hospital.md). Each limit state is
counted by itself, so each is a component of its own here; a loss needs the ordered states of data/pelicun.
"""

import csv
import math
import os
import re
import sys
import tempfile
import warnings

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(HERE, "..", "..", "..", "docs", "catalogue", "data")
STATES = ["moved 1 m", "overturned"]
SAMPLES, SEED = 10000, 7


def read(name):
    with open(os.path.join(HERE, name), newline="") as file:
        return list(csv.DictReader(file))


def catalogue():
    with open(os.path.join(DATA, "fragility.csv"), newline="") as file:
        return [row for row in csv.DictReader(file) if row["measure"] == "pfv"]


def library():
    """Median and dispersion of each component."""
    return {component(row, row["limit_state"]): (float(row["theta"]), float(row["beta"])) for row in catalogue()
            if row["theta"]}


def write_library(path):
    """In the columns that pelicun reads."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional",
                         "LS1-Family", "LS1-Theta_0", "LS1-Theta_1", "LS1-DamageStateWeights"])
        for name, (theta, beta) in library().items():
            writer.writerow([name, 0, "Peak Floor Velocity", "mps", 0, 0, "lognormal", theta, beta, ""])


def reasons():
    """Why the catalogue has no curve."""
    return {(r["item"], r["floor"], r["place"], r["brakes"], r["limit_state"]): r["reason"] for r in catalogue()}


def component(row, state):
    words = ["_".join([row["floor"], row["place"], row["brakes"]]), state]
    return ".".join([row["item"], *(re.sub(r"\W+", "_", each) for each in words)])


def expected(curve, demand, quantity):
    """Capacity and demand are independent and lognormal, so that their ratio is."""
    distance = math.log(float(demand["median_m_per_s"]) / curve[0])
    return quantity * 0.5 * math.erfc(-distance / math.hypot(curve[1], float(demand["beta"])) / math.sqrt(2))


def import_pelicun(folder, work):
    """pelicun without a network and its own library, which it would download."""
    os.environ["DLML_DATA_DIR"] = work
    os.environ["PELICUN_GITHUB_API_URL"] = "http://127.0.0.1:9"
    open(os.path.join(work, "model_files.txt"), "w").close()
    sys.path.insert(0, folder)
    sys.dont_write_bytecode = True
    warnings.simplefilter("ignore")
    import pandas
    try:  # an option of pandas 2.2 that pelicun 3.4 to 3.6 set with any
        pandas.get_option("future.no_silent_downcasting")
    except pandas.errors.OptionError:
        pandas._config.config.register_option("future.no_silent_downcasting", False)
    from pelicun.assessment import Assessment
    return Assessment


def load_demands(assessment, demands, samples):
    import pandas
    rows = [(d["location"], float(d["median_m_per_s"]), float(d["beta"])) for d in demands]
    marginals = pandas.DataFrame(
        {"Theta_0": [r[1] for r in rows], "Theta_1": [r[2] for r in rows], "Family": "lognormal", "Units": "mps"},
        index=pandas.MultiIndex.from_tuples([("PFV", r[0], "1") for r in rows]))
    assessment.demand.load_model({"marginals": marginals})
    assessment.demand.generate_sample({"SampleSize": samples})


def damaged(Assessment, library_file, state, samples):
    """For each row of the contents a sample of the number of its items that exceed the state; None where the
    library has no curve."""
    import pandas
    contents, demands = read("contents.csv"), read("demands.csv")
    curves = library()
    # pelicun takes the PFV of location n from the floor n - 1
    location = {d["floor"]: str(int(d["location"]) + 1) for d in demands}
    known = [row for row in contents if component(row, state) in curves]
    assessment = Assessment({"PrintLog": False, "Seed": SEED, "NonDirectionalMultipliers": {"ALL": 1.0}})
    load_demands(assessment, demands, samples)
    assessment.stories = 4
    quantity = [float(row["quantity"]) for row in known]
    marginals = pandas.DataFrame(
        {"Units": "ea", "Location": [location[row["floor"]] for row in known], "Direction": "1", "Theta_0": quantity,
         "Blocks": [int(each) for each in quantity]}, index=[component(row, state) for row in known])
    assessment.asset.load_cmp_model({"marginals": marginals})
    assessment.asset.generate_cmp_sample(samples)
    assessment.damage.load_model_parameters([library_file], set(marginals.index))
    assessment.damage.calculate()
    sample = assessment.damage.ds_model.sample
    exceeding = sample.loc[:, sample.columns.get_level_values("ds") == "1"]
    counts = exceeding.groupby(level="cmp", axis=1).sum()
    never = 0 * sample.iloc[:, 0]
    return [counts.get(name, never) if name in curves else None
            for name in (component(row, state) for row in contents)]


def lines(Assessment, library_file, samples):
    why = reasons()
    for state in STATES:
        total = 0
        for row, count in zip(read("contents.csv"), damaged(Assessment, library_file, state, samples)):
            total = total if count is None else total + count
            reason = why[row["item"], row["floor"], row["place"], row["brakes"], state]
            yield summary(row, state, count) | {"no_curve": reason}
        everything = {"room": "hospital", "item": "all", "floor": "", "place": "", "brakes": "",
                      "quantity": sum(int(row["quantity"]) for row in read("contents.csv"))}
        yield summary(everything, state, total) | {"no_curve": ""}


def summary(row, state, count):
    if count is None:
        return row | {"limit_state": state, "mean": "", "p05": "", "p95": ""}
    return row | {"limit_state": state, "mean": f"{count.mean():.3f}", "p05": f"{count.quantile(0.05):.0f}",
                  "p95": f"{count.quantile(0.95):.0f}"}


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as work:
        Assessment = import_pelicun(os.path.abspath(sys.argv[1]), work)
        library_file = os.path.join(work, "fragility.csv")
        write_library(library_file)
        rows = list(lines(Assessment, library_file, int(sys.argv[3]) if len(sys.argv) == 4 else SAMPLES))
    with open(sys.argv[2], "w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
