"""pelicun itself loads the exported fragilities and demands, and finds the probabilities of the
curves. Skipped unless GURNEY_PELICUN names a folder that holds its package `pelicun`: 3.6.1 with
the pandas of Debian 12, 3.7 and later with pandas 2.2.
"""

import math
import os
import sys
import tempfile
import warnings

import support

folder = os.environ.get("GURNEY_PELICUN")
if not folder:
    support.skip("GURNEY_PELICUN names no folder with the package pelicun")
support.need("pandas", "scipy", "numexpr", "jsonschema", "colorama", "tqdm", "requests", "sklearn")

SAMPLES = 20000

with tempfile.TemporaryDirectory() as temporary:
    # pelicun downloads its library of models when it is imported. This test brings its own model:
    # an empty library, and no network.
    os.environ["DLML_DATA_DIR"] = temporary
    os.environ["PELICUN_GITHUB_API_URL"] = "http://127.0.0.1:9"
    open(os.path.join(temporary, "model_files.txt"), "w", encoding="utf-8").close()
    sys.path.insert(0, folder)
    sys.dont_write_bytecode = True
    warnings.simplefilter("ignore")
    import pandas
    try:  # pelicun 3.4 to 3.6 allow Debian's pandas 1.5, and set an option of 2.2 all the same
        pandas.get_option("future.no_silent_downcasting")
    except pandas.errors.OptionError:
        pandas._config.config.register_option("future.no_silent_downcasting", False)
    from pelicun.assessment import Assessment

    study = os.path.join(temporary, "trolley.h5")
    support.gurney("run", os.path.join(support.SOURCE, "studies/jobs/trolley_levels.toml"), "-o",
                   study)
    exported, demands = (os.path.join(temporary, name) for name in ("fragility", "demands"))
    support.gurney("export", study, "--to", "pelicun", "--separate", "-o", exported)
    support.gurney("export", study, "--to", "response-csv", "-o", demands)


    def with_incomplete(library):
        """A copy of which pelicun takes all rows: those of few outcomes or records, `Incomplete`, it
        leaves out."""
        table = pandas.read_csv(library, index_col="ID")
        assert (table["Incomplete"] == 1).all(), table["Incomplete"]  # ten records
        table["Incomplete"] = 0
        table.to_csv(library[:-4] + "_all.csv")
        return library[:-4] + "_all.csv"

    library = with_incomplete(os.path.join(exported, "fragility.csv"))
    rows = pandas.read_csv(library, index_col="ID")
    assert len(rows) > 0 and (rows["Demand-Type"] == "Peak Ground Acceleration").all(), rows
    curves = support.fragilities(study)

    def damage(library, name, pga):
        """Probabilities of no damage and of each damage state, of a demand without scatter [g]."""
        assessment = Assessment({"PrintLog": False, "Seed": 7,
                                 "NonDirectionalMultipliers": {"ALL": 1.0}})
        marginals = pandas.DataFrame(
            {"Theta_0": [pga], "Theta_1": [1e-9], "Family": ["lognormal"], "Units": ["g"]},
            index=pandas.MultiIndex.from_tuples([("PGA", "0", "1")]))
        assessment.demand.load_model({"marginals": marginals})
        assessment.demand.generate_sample({"SampleSize": SAMPLES})
        assessment.stories = 0
        quantities = pandas.DataFrame(
            {"Units": ["ea"], "Location": ["0"], "Direction": ["1"], "Theta_0": [1.0],
             "Blocks": [1]}, index=[name])
        assessment.asset.load_cmp_model({"marginals": quantities})
        assessment.asset.generate_cmp_sample(SAMPLES)
        assessment.damage.load_model_parameters([library], {name})
        assessment.damage.calculate()
        return assessment.damage.ds_model.probabilities().iloc[0].to_numpy()

    def exceeded(curve, im):
        return 0.5 * math.erfc(-math.log(im / curve["theta"]) / curve["beta"] / math.sqrt(2))

    def compare(found, expected, *about):
        # The share of SAMPLES that exceed: five standard deviations of a binomial share.
        most = 5 * math.sqrt(max(expected * (1 - expected), 1 / SAMPLES) / SAMPLES)
        assert abs(found - expected) <= most, (*about, found, expected)

    for pga in (0.8, 1.0, 1.3):
        for name, row in rows.iterrows():
            curve = next(each["curve"] for each in curves.values() if each["curve"] and
                         abs(each["curve"]["theta"] / 9.80665 / row["LS1-Theta_0"] - 1) < 1e-9)
            at = pga * row["LS1-Theta_0"]
            compare(damage(library, name, at)[1], exceeded(curve, at * 9.80665), name, pga)

    # Damage states of one component: who exceeds the second is not counted in the first.
    states = os.path.join(temporary, "states")
    support.gurney("export", study, "--to", "pelicun", *support.STATES, "-o", states)
    library = with_incomplete(os.path.join(states, "fragility.csv"))
    (name,) = pandas.read_csv(library, index_col="ID").index
    assert name == "trolley_levels.near_far", name
    near, far = (each["curve"] for _, each in sorted(
        support.fragilities(study, *support.STATES).items(), reverse=True))
    assert near["theta"] < far["theta"]
    for pga in (0.1, 0.14, 0.17, 0.2):
        found = damage(library, name, pga)
        beyond = exceeded(far, pga * 9.80665)
        compare(found[2], beyond, name, pga)
        compare(found[1], exceeded(near, pga * 9.80665) - beyond, name, pga)

    samples = [name for name in os.listdir(demands) if name.startswith("demands_")]
    assert len(samples) == 3, os.listdir(demands)
    for name in samples:
        assessment = Assessment({"PrintLog": False})
        assessment.demand.load_sample(os.path.join(demands, name))
        loaded = assessment.demand.sample  # in SI units
        assert len(loaded) == 10 and ("PFA", "0", "1") in loaded.columns, loaded.columns
        written = pandas.read_csv(os.path.join(demands, name), index_col=0, skiprows=[1])
        for kind in ("PFA", "PFV"):
            error = loaded[(kind, "0", "1")].to_numpy() / written[f"{kind}-0-1"].to_numpy() - 1
            assert abs(error).max() < 1e-12, (kind, error)
print(f"pelicun agrees on {len(rows)} curves at three intensities and a sequence of two, and "
      f"loads {len(samples)} samples")
