"""The package `gurney` on files of single runs and studies; its fits against the program's."""

import json
import math
import os
import shutil
import tempfile
import unittest
import warnings

import support

support.need_module()
support.use_package()

import gurney  # noqa: E402
import numpy  # noqa: E402
import pandas  # noqa: E402

STRIPES = """
schema = "gurney-job/1"
title = "Ventilator, two levels of brakes"
[item]
equipment = "icu_ventilator"
yaw_deg = { value = 0, distribution = { kind = "uniform", low = -180, high = 180, assumption = "any" } }
[excitation.record]
synthetic = { kind = "ac156" }
[settings]
duration_s = 12
[study]
synthetic_records = 9
angles_deg = [0, 45]
draws = 1
measures = ["PGV geomean", "Sa(1.0) RotD50"]
[study.keep]
histories = "all"
wheels = true
energy = true
[study.intensity]
measure = "PGA"
component = "larger"
unit = "g"
levels = [0.05, 0.1, 0.2, 0.4, 0.8]
[[study.factor]]
name = "brakes"
[study.factor.level.free]
item.brakes = false
[study.factor.level.locked]
item.brakes = true
[[study.limit_state]]
name = "far"
demand = "peak_displacement"
above = 15
unit = "cm"
[[study.limit_state]]
name = "shaken"
point = "ventilator"
demand = "peak_absolute_acceleration"
above = 0.5
unit = "g"
[[study.limit_state]]
name = "either"
any_of = ["far", "shaken"]
[[study.limit_state]]
name = "both"
all_of = ["far", "shaken"]
"""

IDA = STRIPES.split("[study.keep]")[0] + """
[study.intensity]
measure = "PGA"
component = "larger"
unit = "g"
ida = { first = 0.05, increment = 0.05, most_runs = 8, resolution = 0.2, until = "far" }
[[study.limit_state]]
name = "far"
demand = "peak_displacement"
above = 15
unit = "cm"
[[study.limit_state]]
name = "moved"
demand = "residual_displacement"
above = 2
unit = "cm"
"""



def score(curve):
    """Slopes of the ln likelihood of outcomes over ln theta and ln beta, by the definition of the curve and
    no code of the program, over the sum of the sizes of their terms."""
    slopes, sizes = numpy.zeros(2), numpy.zeros(2)
    for im, runs, exceeded in curve.stripes[["im", "runs", "exceeded"]].to_numpy():
        z = math.log(im / curve.theta) / curve.beta
        p = 0.5 * math.erfc(-z / math.sqrt(2))
        density = math.exp(-z * z / 2) / math.sqrt(2 * math.pi)
        for outcomes, sign, of in ((exceeded, 1, p), (runs - exceeded, -1, 1 - p)):
            terms = -sign * outcomes * density / of * numpy.array([1, z]) / curve.beta
            slopes += terms
            sizes += abs(terms)
    return slopes / sizes


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.stripes, cls.ida, cls.bay = (os.path.join(cls.folder, name)
                                         for name in ("stripes.h5", "ida.h5", "bay.h5"))
        for text, path in ((STRIPES, cls.stripes), (IDA, cls.ida)):
            job = path.replace(".h5", ".toml")
            with open(job, "w", encoding="utf-8") as file:
                file.write(text)
            support.gurney("run", job, "-o", path)
        support.gurney("run", os.path.join(support.SOURCE, "studies/jobs/icu_bay.toml"), "-o",
                       cls.bay, "--no-figure")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_runs_have_names_measures_and_drawn_values(self):
        with gurney.open(self.stripes) as study:
            runs = study.runs
            self.assertEqual(len(runs), 2 * 9 * 2 * 5)
            self.assertEqual(set(runs["brakes"]), {"free", "locked"})
            self.assertEqual(runs["configuration"].tolist(), runs["brakes"].tolist())
            self.assertEqual(runs["record"].nunique(), 9)
            self.assertTrue((runs["record"] == "ac156 " + (runs["record_index"] + 1).astype(str))
                            .all())
            units = runs.attrs["units"]
            self.assertEqual(set(units), set(runs.columns))
            self.assertEqual((units["intensity"], units["PGV geomean"], units["pfa"],
                              units["item.yaw_deg"]), ("m/s2", "m/s", "m/s2", "deg"))
            # A motion scaled to a PGA has measures that are proportional to it.
            ratio = runs["PGV geomean"] / runs["scale"]
            by_record = ratio.groupby(runs["record"])
            self.assertLess((by_record.max() / by_record.min() - 1).max(), 1e-12)
            yaw = study.parameters["item.yaw_deg"]
            for _, run in runs.iterrows():
                self.assertEqual(run["item.yaw_deg"], yaw[run["configuration_index"], run["draw"]])

    def test_runs_agree_with_the_exported_table(self):
        table = os.path.join(self.folder, "csv")
        support.gurney("export", self.stripes, "--to", "csv", "-o", table)
        for name in ("runs", "items", "points"):
            exported = pandas.read_csv(os.path.join(table, name + ".csv"), skiprows=[1],
                                       float_precision="round_trip")
            with gurney.open(self.stripes) as study:
                frame = study.table(name, raw=True)
            for column in exported:
                pandas.testing.assert_series_equal(exported[column], frame[column],
                                                   check_dtype=False, rtol=0, atol=0)

    def test_demands_join_runs(self):
        with gurney.open(self.stripes) as study:
            joined = study.demands.join(study.runs)
            self.assertEqual(joined.index.names, ["run", "item"])
            self.assertEqual(len(joined), len(study.runs))
            stands = joined["outcome"] != "overturned"
            self.assertTrue(joined.loc[stands, "time_of_overturning"].isna().all())
            self.assertEqual(study.points.index.names, ["run", "item", "point"])
            self.assertEqual(study.wheels.index.names, ["run", "item", "wheel"])

    def test_histories_have_the_same_form_in_both_kinds_of_file(self):
        support.need("xarray")
        with gurney.open(self.stripes) as study, gurney.open(self.bay) as run:
            of_study, of_run = study.histories(7), run.histories()
            for histories in (of_study, of_run):
                self.assertEqual(histories["displacement"].dims, ("time", "item", "axis"))
                self.assertEqual(histories["displacement"].attrs["units"], "m")
                self.assertEqual(histories["tilt"].dims, ("time", "item"))
            horizontal = numpy.hypot(of_study["displacement"].sel(axis="x"),
                                     of_study["displacement"].sel(axis="y"))
            peak = study.demands["peak_displacement"][7].iloc[0]
            self.assertLessEqual(float(horizontal.max()), peak * (1 + 1e-12))
            residual = study.demands["residual_displacement"][7].iloc[0]
            self.assertAlmostEqual(float(horizontal[-1, 0]), residual, delta=1e-12)
            name = str(of_run["item"].values[0])
            self.assertEqual(run.histories(item=name)["tilt"].dims, ("time",))
            self.assertEqual(of_run["mode"].attrs["flag_meanings"].split()[0][0].isalpha(), True)

    def test_single_run(self):
        with gurney.open(self.bay) as run:
            self.assertEqual(run.kind, "run")
            self.assertEqual(run.runs["outcome"].iloc[0] in ("rested", "overturned"), True)
            self.assertIn("record_pga.x", run.runs)
            self.assertEqual(run.runs.attrs["units"]["record_pga.x"], "m/s2")
            self.assertEqual(len(run.impacts), run.demands["impacts"].sum())
            self.assertGreater(len(run.zones), 0)
            self.assertGreater(len(run.tethers), 0)
            self.assertEqual(len(run.records), len(run.records["sha256"].unique()))
            printed = json.loads(support.gurney("show", self.bay, "--json"))
            self.assertEqual(run.provenance["job_sha256"], printed["job_sha256"])
            self.assertEqual(run.job["schema"], "gurney-job/1")

    def check_fits(self, path, methods):
        expected = support.fragilities(path)
        with gurney.open(path) as study:
            self.assertEqual(study.limit_states, {state: theirs["says"]
                                                  for (_, state), theirs in expected.items()})
            for (configuration, state), theirs in expected.items():
                mine = study.fragility(state, configuration=configuration)
                where = (path, configuration, state)
                self.assertEqual((mine.runs, mine.exceeded, mine.words, mine.units),
                                 (theirs["runs"], theirs["exceeded"], theirs["says"],
                                  theirs["units"]), where)
                self.assertEqual(list(mine.cautions), theirs["cautions"], where)
                outcomes = study.exceeded(state)[study.runs["configuration"] == configuration]
                self.assertEqual(outcomes.sum(), mine.exceeded, where)
                if theirs["curve"] is None:
                    self.assertEqual((mine.status, math.isnan(mine.theta)),
                                     (theirs["reason"], True), where)
                    continue
                methods.add(mine.method)
                self.assertEqual((mine.status, mine.theta, mine.beta, mine.effective_records),
                                 ("fitted", theirs["curve"]["theta"], theirs["curve"]["beta"],
                                  theirs["effective_records"]), where)
                self.assertEqual(mine.covariance.tolist(),
                                 theirs["covariance_of_ln_theta_ln_beta"], where)
                for name in ("theta_interval", "beta_interval"):
                    given = theirs[name] and tuple(
                        end if each is None else each
                        for end, each in zip((0, math.inf), theirs[name]))
                    self.assertEqual(getattr(mine, name), given, where)
                self.assertEqual(mine.band.to_numpy().tolist(), theirs["band"] or [], where)
                if mine.method == "outcomes":
                    # Newton's method ends at steps below 1e-10 of ln theta and ln beta; the slope changes
                    # by the information, of the order of the terms, times the step.
                    self.assertLess(abs(score(mine)).max(), 1e-8, where)

    def test_fits_are_those_of_the_program(self):
        methods = set()
        self.check_fits(self.stripes, methods)
        self.check_fits(self.ida, methods)
        self.assertEqual(methods, {"outcomes", "capacities"})

    def test_confidence_and_cloud(self):
        with gurney.open(self.stripes) as study:
            wide = study.fragility("far", configuration="free", confidence=0.99)
            usual = study.fragility("far", configuration="free")
            self.assertLess(wide.theta_interval[0], usual.theta_interval[0])
            self.assertGreater(wide.theta_interval[1], usual.theta_interval[1])
            cloud = study.fragility("far", configuration="free", method="cloud")
            theirs = support.fragilities(self.stripes, "--method", "cloud")["free", "far"]
            self.assertEqual((cloud.method, cloud.theta), ("cloud", theirs["curve"]["theta"]))
            for wrong in (0, 1, -2):
                with self.assertRaisesRegex(gurney.InputError, "between 0 and 1"):
                    study.fragility("far", configuration="free", confidence=wrong)
            with self.assertRaisesRegex(gurney.InputError, "None or 'cloud'"):
                study.fragility("far", configuration="free", method="probit")

    def test_other_measures_and_limit_states_after_the_runs(self):
        for line, measure in (("peak_displacement > 8 cm", "PGV geomean"),
                              ("wide = peak_displacement > 0.08 m", "Sa(1) RotD50"),
                              ("ventilator: peak_absolute_acceleration > 0.4 g", "pfa"),
                              ("at least 1 items: peak_yaw > 3 deg", "pfv")):
            expected = support.fragilities(self.stripes, "--limit-state", line, "--measure",
                                           measure)
            with gurney.open(self.stripes) as study:
                for (configuration, state), theirs in expected.items():
                    mine = study.fragility(line, measure, configuration)
                    self.assertEqual((mine.words, mine.exceeded),
                                     (theirs["says"], theirs["exceeded"]))
                    if theirs["curve"]:
                        self.assertEqual(mine.theta, theirs["curve"]["theta"])

    def test_own_outcomes_are_a_series(self):
        with gurney.open(self.stripes) as study:
            demands = study.demands.groupby("run")["peak_displacement"].max()
            mine = study.fragility(demands > 0.15, configuration="free")
            job = study.fragility("far", configuration="free")
            self.assertEqual((mine.theta, mine.beta, mine.theta_interval, mine.exceeded),
                             (job.theta, job.beta, job.theta_interval, job.exceeded))
            some = (demands > 0.15).astype(object)
            some.iloc[::3] = numpy.nan
            fewer = study.fragility(some, configuration="free")
            self.assertLess(fewer.runs, mine.runs)
            with self.assertRaisesRegex(gurney.InputError, "must be True, False or NaN"):
                study.fragility(demands, configuration="free")
            with self.assertRaisesRegex(gurney.InputError, "no run 999; it has 180"):
                study.fragility(pandas.Series({3: True, 999: False}), configuration="free")
            for index, message in (([0.0, 1.0], "not the number of a run"), ([-1, 1], "not the number of a run"),
                                   ([1, 1], "run 1 has several outcomes")):
                with self.assertRaisesRegex(gurney.InputError, message):
                    study.fragility(pandas.Series([True, False], index), configuration="free")
            self.assertTrue(numpy.isnan(job.probability([numpy.nan, 1])[0]))
            self.assertGreaterEqual(job.probability([numpy.nan, 1])[1], 0)
            with self.assertRaisesRegex(gurney.InputError, "im = -1: an intensity is 0 or more"):
                job.probability([1, -1])

    def test_annual_rate_is_that_of_the_program(self):
        path = os.path.join(self.folder, "hazard.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write('schema = "gurney-hazard/1"\nmeasure = "PGA"\ncomponent = "larger"\n'
                       'unit = "g"\nim = [0.05, 0.1, 0.2, 0.4, 0.8]\n'
                       'rate_per_year = [2e-2, 8e-3, 2e-3, 4e-4, 5e-5]\n')
        expected = support.fragilities(self.stripes, "--hazard", path)
        hazard, count = gurney.read_hazard(path), 0
        with gurney.open(self.stripes) as study:
            for (configuration, state), theirs in expected.items():
                if theirs["curve"] is None:
                    continue
                mine = study.fragility(state, configuration=configuration)
                rate = mine.rate(hazard)
                for name, of in (("per_year", "per_year"), ("cautions", "cautions"),
                                 ("supported", "complete")):
                    self.assertEqual(rate[name], theirs["rate"][of])
                self.assertEqual(rate["interval"] is None, theirs["rate"]["interval_per_year"] is None)
                with warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    self.assertEqual(mine.annual_rate(hazard), rate["per_year"])
                self.assertEqual(len(caught), len(rate["cautions"]))
                count += 1
            with self.assertRaisesRegex(gurney.Error, "the hazard is of PGA larger"):
                study.fragility("far", "pfv", "free").annual_rate(hazard)
            points = gurney.Hazard([0.05, 0.1, 0.2, 0.4, 0.8], [2e-2, 8e-3, 2e-3, 4e-4, 5e-5],
                                   measure="PGA", component="larger", unit="g")
            far = study.fragility("far", configuration="free")
            self.assertEqual(far.rate(points), far.rate(hazard))
            self.assertAlmostEqual(points.rate(0.1 * 9.80665) / 8e-3, 1, delta=1e-14)  # some roundings
            self.assertEqual(list(points.to_frame().index), list(numpy.array([0.05, 0.1, 0.2, 0.4, 0.8]) * 9.80665))
            self.assertIn("0.008", points._repr_html_())
            # The same numbers in m/s2 are another site: a unit is never guessed.
            metric = gurney.Hazard([0.05, 0.1, 0.2, 0.4, 0.8], [2e-2, 8e-3, 2e-3, 4e-4, 5e-5],
                                   measure="PGA", component="larger", unit="m/s2")
            self.assertTrue(math.isnan(metric.rate(0.1 * 9.80665)))
        self.assertGreater(count, 1)

    def test_hazards_that_are_none(self):
        im, rate = [0.1, 0.2], [1e-2, 1e-3]
        with self.assertRaises(TypeError):
            gurney.Hazard(im, rate)  # without a unit
        for given, message in (((im, rate, "PGA", "m/s"), "unit"), ((im, rate, "PGX", "g"), "PGX"),
                               ((im, [1e-3, 1e-2], "PGA", "g"), "must be less than .* 0.001"),
                               (([0.1], [1e-2], "PGA", "g"), "2"), ((im, [1e-2], "PGA", "g"), "")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.Hazard(given[0], given[1], measure=given[2], unit=given[3])
        with self.assertRaisesRegex(gurney.InputError, "no such file"):
            gurney.read_hazard("nowhere.toml")

    def test_a_changed_byte_is_an_error(self):
        path = os.path.join(self.folder, "changed.h5")
        with open(self.stripes, "rb") as file:
            data = bytearray(file.read())
        data[len(data) // 2] ^= 1
        with open(path, "wb") as file:
            file.write(data)
        with self.assertRaisesRegex(gurney.DamagedFile, "damaged"):
            gurney.open(path)
        with gurney.open(self.stripes) as study:
            self.assertIs(study.verify(), True)
            self.assertIs(study.verified, True)
        end = data.rindex(b"\ngurney sha256 ")
        data[len(data) // 2] ^= 1
        with open(path, "wb") as file:
            file.write(data[:end])
        with self.assertWarnsRegex(UserWarning, "changed.h5: no checksum at its end"):
            study = gurney.open(path)
        with study:
            self.assertIs(study.verified, False)
        with open(path, "wb") as file:
            file.write(data[:end // 2])
        with self.assertRaisesRegex(gurney.DamagedFile, "changed.h5: cannot be read: .*truncated"):
            gurney.open(path)

    def test_errors_name_what_is_there(self):
        for act, message in (
                (lambda study: study.fragility("fart", configuration="free"), "did you mean 'far'"),
                (lambda study: study.fragility("far"), "which configuration.*free, locked"),
                (lambda study: study.fragility("far", "PGV geomeen", "free"), "'PGV geomean'"),
                (lambda study: study.fragility("peak_displacment > 1 m", configuration="free"),
                 "did you mean 'peak_displacement'"),
                (lambda study: study.fragility("peak_displacement > 1 kg", configuration="free"),
                 "must be one of m, cm, mm"),
                (lambda study: study.table("item"), "did you mean 'items'"),
                (lambda study: study.histories(1000), "no histories of run '1000'"),
                (lambda study: study.histories("0"), "run = '0': must be a whole number"),
                (lambda study: study.histories(True), "run = True: must be a whole number"),
                (lambda study: study.histories(), "which run")):
            with gurney.open(self.stripes) as study, self.assertRaisesRegex(gurney.Error, message):
                act(study)
        with gurney.open(self.ida) as study:
            with self.assertRaisesRegex(gurney.NotInFile, "gurney replay"):
                study.histories(0)
            with self.assertRaisesRegex(gurney.NotInFile, r"\[study.keep\]"):
                study.wheels
        with gurney.open(self.bay) as run, self.assertRaisesRegex(gurney.Error, "single run"):
            run.fragility("overturned")
        with self.assertRaisesRegex(gurney.Error, "no such file"):
            gurney.open(os.path.join(self.folder, "absent.h5"))
        with self.assertRaisesRegex(gurney.Error, "not an HDF5 file"):
            gurney.open(self.stripes.replace(".h5", ".toml"))

    def test_merged_shards_are_the_same(self):
        job, path = self.ida.replace(".h5", ".toml"), os.path.join(self.folder, "merged.h5")
        for shard in ("1/2", "2/2"):
            support.gurney("run", job, "-o", path, "--shard", shard)
        support.gurney("merge", path + ".shards")
        with gurney.open(path) as merged, gurney.open(self.ida) as whole:
            pandas.testing.assert_frame_equal(merged.runs, whole.runs)

    def test_figures(self):
        support.need("matplotlib")
        import matplotlib
        matplotlib.use("Agg")
        from gurney import plot
        with gurney.open(self.stripes) as study:
            ax = plot.fragility(study, "far")
            self.assertEqual(len(ax.get_legend().get_texts()), 2)
            self.assertEqual(plot.cloud(study).get_ylabel(), "peak displacement [m]")
            self.assertEqual(len(plot.history(study, run=0).lines), 3)
            with self.assertRaisesRegex(gurney.Error, "no history 'displacemen'"):
                plot.history(study, "displacemen", 0)
        with gurney.open(self.bay) as run:
            self.assertGreater(len(plot.history(run, "normal_force").lines), 3)
            self.assertEqual(plot.history(run, "floor_acceleration").get_xlabel(), "time [s]")


if __name__ == "__main__":
    unittest.main(argv=["results_package.py", "-v"])
