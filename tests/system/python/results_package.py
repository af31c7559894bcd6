"""The package `gurney` on files of single runs and studies; its fits against the program's."""

import json
import math
import os
import shutil
import tempfile
import unittest

import support

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

# Newton's method ends at steps below 1e-10 of ln theta and ln beta in the program (the tolerance of
# studies/statistics) and 1e-12 here; ten times the larger.
FIT = 1e-9


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
            for (configuration, state), theirs in expected.items():
                mine = study.fragility(state, configuration=configuration)
                where = (path, configuration, state)
                methods.add(theirs["method"])
                self.assertTrue(theirs["status"].startswith(mine.status), where)
                self.assertEqual((mine.runs, mine.exceeded, mine.words, mine.units),
                                 (theirs["runs"], theirs["exceeded"], theirs["says"],
                                  theirs["units"]), where)
                if theirs["curve"] is None:
                    continue
                methods.add("fitted " + mine.method)
                for name in ("theta", "beta"):
                    self.assertAlmostEqual(getattr(mine, name) / theirs["curve"][name], 1,
                                           delta=FIT, msg=where)
                if mine.method == "outcomes":
                    self.check_intervals(mine, theirs, where)
                    theirs = numpy.array(theirs["covariance_of_ln_theta_ln_beta"])
                    # The covariance moves with the maximum: its terms by the step times the count
                    # of runs at most.
                    scale = numpy.sqrt(numpy.outer(theirs.diagonal(), theirs.diagonal()))
                    error = abs(mine.covariance - theirs) / scale
                    self.assertLess(error.max(), FIT * mine.runs, where)

    def check_intervals(self, mine, theirs, where):
        self.assertEqual(mine.has_intervals, theirs["theta_interval"] is not None, where)
        if not mine.has_intervals:
            self.assertIsNone(mine.theta_interval(), where)
            return
        # Ends in ln theta lie between two of the 128 points of the outline: within 1 - cos(pi / 128)
        # = 3e-4 of the half-width.
        for name, tolerance in (("theta", 4e-4), ("beta", 1e-6)):
            ours, interval = getattr(mine, name + "_interval")(), theirs[name + "_interval"]
            for end, given in zip(ours, interval):
                if given is None:
                    self.assertIn(end, (0, math.inf), where)
                    continue
                half = abs(math.log(given / getattr(mine, name)))
                self.assertAlmostEqual(math.log(end / given), 0, delta=tolerance * half, msg=where)
                self.compared.add(name)

    def test_fits_are_those_of_the_program(self):
        self.compared = set()
        methods = set()
        self.check_fits(self.stripes, methods)
        self.check_fits(self.ida, methods)
        self.assertEqual({each for each in methods if each.startswith("fitted")},
                         {"fitted outcomes", "fitted capacities"})
        self.assertEqual(self.compared, {"theta", "beta"})

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
                        self.assertAlmostEqual(mine.theta / theirs["curve"]["theta"], 1, delta=FIT)

    def test_own_outcomes_are_a_series(self):
        with gurney.open(self.stripes) as study:
            demands = study.demands.groupby("run")["peak_displacement"].max()
            mine = study.fragility(demands > 0.15, configuration="free")
            job = study.fragility("far", configuration="free")
            self.assertEqual((mine.theta, mine.beta), (job.theta, job.beta))

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
                rate = mine.annual_rate(hazard)
                # The difference of the fits times the slope of ln rate over ln theta, which is at
                # most that of the hazard, ln 8 / ln 2 = 3, and over ln beta, at most 3^2 beta^2.
                self.assertAlmostEqual(rate / theirs["rate"]["per_year"], 1,
                                       delta=(3 + 9 * mine.beta ** 2) * FIT)
                count += 1
            with self.assertRaisesRegex(gurney.Error, "the hazard is of PGA larger"):
                study.fragility("far", "pfv", "free").annual_rate(hazard)
        self.assertGreater(count, 1)

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
        with gurney.open(path) as study:
            self.assertIs(study.verified, False)

    def test_errors_name_what_is_there(self):
        for act, message in (
                (lambda study: study.fragility("fart", configuration="free"), "did you mean 'far'"),
                (lambda study: study.fragility("far"), "which configuration.*free, locked"),
                (lambda study: study.fragility("far", "PGV geomeen", "free"), "'PGV geomean'"),
                (lambda study: study.fragility("peak_displacment > 1 m", configuration="free"),
                 "'peak_displacement'"),
                (lambda study: study.fragility("peak_displacement > 1 kg", configuration="free"),
                 "m or cm or mm"),
                (lambda study: study.table("item"), "did you mean 'items'"),
                (lambda study: study.histories(1000), "no histories of run '1000'"),
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
