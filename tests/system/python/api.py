"""The package as a first language: jobs with other values, many runs, items, records, studies and their
pages do what the program does; everything public is annotated and described, and its page is current."""

import inspect
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import support

support.need_module()
support.use_package()
sys.path.insert(1, support.PACKAGE)

import api_page  # noqa: E402
import gurney  # noqa: E402
import numpy  # noqa: E402
import pandas  # noqa: E402

JOBS = os.path.join(support.SOURCE, "studies/jobs")
SHAKE = os.path.join(JOBS, "icu_ventilator_shake.toml")
RECORD = os.path.join(support.SOURCE, "groundmotions/records/synthetic_3c.csv")
SHORT = {"settings": {"duration_s": 3}, "predictability": False}


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        self.folder = folder.name
        os.chdir(self.folder)


class Jobs(InFolder):
    def test_other_values_are_those_of_a_changed_file(self):
        with open(SHAKE, encoding="utf-8") as file:
            text = file.read()
        changed = text.replace("scale = 1.0", "scale = 0.5").replace("[10, 100", "[77, 100")
        self.assertNotEqual(changed, text)
        os.makedirs("a/b")  # as deep as the job, whose paths go up
        for name in ("equipment", "groundmotions"):
            os.symlink(os.path.join(support.SOURCE, name), name)
        with open("a/b/changed.toml", "w", encoding="utf-8") as file:
            file.write(changed)
        expected = gurney.run("a/b/changed.toml", predictability=False)
        values = {"excitation.record.scale": 0.5, "item.headings_deg.0": 77}
        for run in (gurney.run(SHAKE, values, predictability=False),
                    gurney.run(SHAKE, {"item.headings_deg.0": 77}, excitation__record__scale=0.5,
                               predictability=False)):
            self.assertEqual(repr(run.demands), repr(expected.demands))
        self.assertNotEqual(repr(gurney.run(SHAKE, predictability=False).demands),
                            repr(expected.demands))

    def test_patches(self):
        job = {"item": [{"name": "bed", "brakes": False}, {"equipment": "icu_bed"}],
               "floor": {"slope": {"value": 1, "source": "x"}, "covering": "rubber"}}
        for overrides, expected in (
                ({"item.bed.brakes": True}, [{"name": "bed", "brakes": True}, {"equipment": "icu_bed"}]),
                ({"item.1.brakes": True}, [job["item"][0], {"equipment": "icu_bed", "brakes": True}]),
                ({"item.*.yaw_deg": 3}, [{**each, "yaw_deg": 3} for each in job["item"]])):
            self.assertEqual(gurney.patched(job, overrides)["item"], expected)
        self.assertEqual(gurney.patched(job, {"floor": {"slope": {"value": 2}}})["floor"],
                         {"slope": {"value": 2}, "covering": "rubber"})
        self.assertEqual(gurney.patched(job, {"floor.covering": None})["floor"],
                         {"slope": job["floor"]["slope"]})
        self.assertEqual(gurney.patched(job, {"settings.duration_s": 3})["settings"], {"duration_s": 3})
        self.assertEqual(job["item"][0]["brakes"], False)
        for wrong in ("item.cot.brakes", "item.9.brakes", "floor.covering.x"):
            with self.assertRaisesRegex(gurney.InputError, wrong):
                gurney.patched(job, {wrong: 1})

    def test_errors_have_the_place_in_the_changed_job(self):
        with self.assertRaisesRegex(gurney.InputError, r"shake.toml:/settings/tme_step_s.*did you mean"):
            gurney.run(SHAKE, settings__tme_step_s=0.01)
        with self.assertRaisesRegex(gurney.InputError, r"table \[study\]"):
            gurney.run(os.path.join(JOBS, "brakes_study.toml"))
        with self.assertRaisesRegex(gurney.InputError, "nowhere.toml"):
            gurney.run("nowhere.toml", settings__duration_s=1)
        with self.assertRaisesRegex(gurney.InputError, "item.yaw_deg = nan"):
            gurney.run(SHAKE, {"item.yaw_deg": numpy.nan})
        with tempfile.TemporaryDirectory() as folder:
            for name, text, place in (("a.toml", "a = 1\nb = = 3\n", ":2:5: "), ("a.json", '{"a": 1,\n]', ":2:1: "),
                                      ("b.toml", 'a = "', ": ")):
                path = os.path.join(folder, name)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
                with self.assertRaisesRegex(gurney.InputError, "^" + path + place):
                    gurney.read_job(path)

    def test_the_figures_are_there_without_another_import(self):
        names = "import gurney; print(gurney.plot.history.__name__); gurney.plott"
        done = subprocess.run([sys.executable, "-B", "-c", names], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": support.BUILT})
        self.assertIn("no attribute 'plott'", done.stderr)
        if support.has("matplotlib"):
            self.assertEqual(done.stdout, "history\n")

    def test_items_with_other_numbers(self):
        plain = gurney.simulate("icu_ventilator", RECORD, **SHORT)
        same = gurney.simulate(gurney.item("icu_ventilator"), RECORD, **SHORT)
        self.assertEqual(repr(plain.demands), repr(same.demands))
        heavy = gurney.item("icu_ventilator", {"chassis.mass_kg": 60.0}, brakes=True)
        self.assertEqual(heavy["brakes"], True)
        self.assertNotEqual(repr(gurney.simulate(heavy, RECORD, **SHORT).demands),
                            repr(gurney.simulate({"equipment": "icu_ventilator", "brakes": True}, RECORD,
                                                 **SHORT).demands))
        rolling = gurney.item("icu_ventilator", {"caster.*.inline.trail_mm": 30.0})
        self.assertEqual({each["inline"]["trail_mm"]["value"] for each in rolling["inline"]["caster"]},
                         {30.0})
        for key in ("chassis.mas_kg", "chasis.mass_kg", "caster.nowhere.inline.trail_mm"):
            with self.assertRaisesRegex(gurney.InputError, key):
                gurney.item("icu_ventilator", {key: 1})
        with self.assertRaisesRegex(gurney.InputError, "icu_ventilator"):
            gurney.item("icu_ventilatr")


class ManyRuns(InFolder):
    def test_runs_are_those_alone_in_their_order(self):
        cases = [{"item": {"equipment": "xu_trolley", "brakes": brakes}, "record": RECORD, **SHORT}
                 for brakes in (True, False)] * 2
        runs = gurney.simulate_many(cases, threads=2)
        for case, run in zip(cases, runs):
            self.assertEqual(repr(run.demands), repr(gurney.simulate(**case).demands))
        frame = runs.to_frame()
        self.assertEqual(frame.index.names, ["run", "item"])
        self.assertEqual(frame["item.brakes"].tolist(), [True, False, True, False])
        self.assertEqual(frame["peak_displacement"].tolist(),
                         [run.demands["xu_trolley"]["peak_displacement"] for run in runs])
        with self.assertRaisesRegex(gurney.InputError, "icu_beds"):
            gurney.simulate_many([{"item": "icu_beds"}])
        for threads in (0, "2", True):
            with self.assertRaisesRegex(gurney.InputError, "threads = .*1 or more"):
                gurney.simulate_many([], threads=threads)
        for wrong, message in (({"item": "icu_beds"}, "cases.1.: .*icu_bed"), ({"itm": "icu_bed"}, "cases.1.: item is missing, got .'itm'")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.simulate_many([{"item": "icu_bed", "settings": {"duration_s": 0.1}}, wrong])

    def test_a_run_shows_itself(self):
        run = gurney.simulate("xu_trolley", RECORD, **SHORT)
        frame = run.to_frame()
        self.assertEqual((frame.index.tolist(), frame.attrs["units"]["peak_displacement"]),
                         (["xu_trolley"], "m"))
        self.assertIn("peak_displacement [m]", run._repr_html_())
        page = run.play()
        run.save("run.h5")
        support.gurney("play", "run.h5", "-o", "page.html")
        with open("page.html", encoding="utf-8") as file:
            self.assertEqual(len(page.html), len(file.read()))
        self.assertTrue(page._repr_html_().startswith("<iframe srcdoc=\"&lt;!"))
        self.assertIn("<table", run.report().html)
        with gurney.open("run.h5") as results:
            self.assertEqual(len(results.play().html), len(page.html))
            self.assertIn("1 runs", results._repr_html_())


class Studies(InFolder):
    def test_a_study_has_the_bytes_of_the_program(self):
        job = os.path.join(JOBS, "brakes_study.toml")
        lines = []
        with gurney.study(job, "mine.h5", threads=2, progress=lines.append) as study:
            self.assertEqual(len(study.runs), 12)
            frame = study.to_frame()
            self.assertEqual(len(frame), 12)
            self.assertIn("brakes", frame)
            self.assertIn("12 runs", study._repr_html_())
        self.assertTrue(any("100 %" in line for line in lines), lines)
        support.gurney("run", job, "-o", "program.h5", "-j", "1")
        with open("mine.h5", "rb") as mine, open("program.h5", "rb") as program:
            self.assertEqual(mine.read(), program.read())
        with self.assertRaisesRegex(gurney.InputError, "mine.h5"):
            gurney.study(job, "mine.h5", progress=False)
        gurney.study(job, "mine.h5", resume=True, progress=False).close()

    def test_a_study_with_other_values(self):
        job = gurney.read_job(os.path.join(JOBS, "brakes_study.toml"))
        with gurney.study(job, "few.h5", progress=False, overrides={
                "study.intensity.levels": [0.3], "study.synthetic_records": 2}) as study:
            self.assertEqual(len(study.runs), 4)
            self.assertEqual(study.job["study"]["synthetic_records"], 2)
        self.assertTrue(os.path.exists("few.job.json"))
        with self.assertRaisesRegex(gurney.InputError, r"no table \[study\]"):
            gurney.study({"item": {"equipment": "icu_bed"}}, "none.h5")
        with self.assertRaisesRegex(gurney.InputError, "wrong.job.json:/study/drawz"):
            gurney.study(job, "wrong.h5", overrides={"study.drawz": 2}, progress=False)
        self.assertFalse(os.path.exists("wrong.job.json"))
        with self.assertRaisesRegex(gurney.InputError, "few.job.json:/study/drawz"):
            gurney.study(job, "few.h5", overrides={"study.drawz": 2}, overwrite=True, progress=False)
        for threads in (0, True, 1.5, "2"):
            with self.assertRaisesRegex(gurney.InputError, "threads = .*1 or more"):
                gurney.study(job, "few.h5", threads=threads, overwrite=True)

    def test_a_refused_study_leaves_the_job_of_another(self):
        job = gurney.read_job(os.path.join(JOBS, "brakes_study.toml"))
        few = {"study.intensity.levels": [0.3], "study.synthetic_records": 1, "settings.duration_s": 2}
        gurney.study(job, "few.h5", overrides=few, progress=False).close()
        with open("few.job.json", "rb") as file:
            first = file.read()
        other = {**few, "study.synthetic_records": 2}
        for options in ({"overrides": other}, {"overrides": other, "resume": True},
                        {"overrides": {"study.drawz": 2}, "overwrite": True}):
            with self.assertRaises(gurney.InputError):
                gurney.study(job, "few.h5", progress=False, **options)
            with open("few.job.json", "rb") as file:
                self.assertEqual(file.read(), first, options)
        gurney.study(job, "few.h5", overrides=few, resume=True, progress=False).close()
        gurney.study(job, "few.h5", overrides=other, overwrite=True, progress=False).close()
        with open("few.job.json", "rb") as file:
            self.assertNotEqual(file.read(), first)
        # Runs that fail, after the job was accepted: the job stays, and nothing else.
        with mock.patch("gurney.studies._follow", side_effect=gurney.Error("ended with 3")):
            with self.assertRaisesRegex(gurney.Error, "ended with 3"):
                gurney.study(job, "few.h5", overrides=few, overwrite=True, progress=False)
        with open("few.job.json", "rb") as file:
            self.assertEqual(file.read(), first)
        with self.assertRaisesRegex(gurney.InputError, "nowhere.*No such file"):
            gurney.study(job, "nowhere/few.h5", overrides=few)
        self.assertEqual(sorted(os.listdir()), ["few.h5", "few.job.json", "few.log"])

    def test_studies_of_one_name_in_two_folders_have_jobs_of_their_own(self):
        for folder in ("a", "b"):
            os.mkdir(folder)
        with open("job.json", "w", encoding="utf-8") as file:
            json.dump(gurney.read_job(os.path.join(JOBS, "brakes_study.toml")), file)
        for folder, level in (("a", 0.2), ("b", 0.3)):
            gurney.study("job.json", f"{folder}/few.h5", progress=False, overrides={
                "study.intensity.levels": [level], "study.synthetic_records": 1,
                "settings.duration_s": 2}).close()
        self.assertEqual(len([each for each in os.listdir() if each.endswith(".job.json")]), 2)
        for folder in ("a", "b"):
            with gurney.open(f"{folder}/few.h5") as study:
                self.assertIn("<html", study.play(0).html)


class Catalogue(unittest.TestCase):
    def test_the_lists_are_those_of_the_program(self):
        listed = json.loads(support.gurney("equipment", "ls", "--json"))
        for kind, rows in listed.items():
            self.assertEqual(gurney.catalogue(kind).index.tolist(), [each["key"] for each in rows])
        self.assertEqual(gurney.sheet("icu_bed"),
                         json.loads(support.gurney("equipment", "show", "icu_bed", "--json")))
        with self.assertRaisesRegex(gurney.NotInFile, "did you mean 'items'"):
            gurney.catalogue("item")


class Records(InFolder):
    def test_a_record_acts_as_its_file(self):
        record = gurney.records.read(RECORD)
        self.assertEqual((record.name, record.acceleration.shape, record.time_step),
                         ("synthetic_3c", (6001, 3), 0.005))
        file, array = (gurney.simulate("xu_trolley", each, **SHORT) for each in (RECORD, record))
        self.assertEqual(repr(file.demands), repr(array.demands))
        record.save("again.csv")
        again = gurney.records.read("again.csv")
        self.assertTrue((again.acceleration == record.acceleration).all())
        half = record.scaled(0.5)
        self.assertEqual(half.to_frame()["h1"].abs().max(), 0.5 * record.to_frame()["h1"].abs().max())

    def test_measures_and_spectra_are_those_of_the_program(self):
        listed = json.loads(support.gurney("records", "info", RECORD, "--json"))["records"][0]["measures"]
        mine = gurney.records.measures(RECORD)
        for name, of in listed.items():
            self.assertEqual(mine.attrs["units"][name], of["unit"])
            for component, value in of["values"].items():
                numpy.testing.assert_equal(mine.loc[name, component],
                                           numpy.nan if value is None else value)
        spectrum = gurney.records.spectrum(gurney.records.read(RECORD), [0.3, 1])
        self.assertEqual(spectrum.index.tolist(), [0.3, 1.0])
        self.assertTrue((spectrum["RotD100"] >= spectrum["RotD50"]).all())
        self.assertEqual(gurney.records.spectrum(RECORD, [0.12345678]).index.tolist(), [0.12345678])
        for periods, message in (([0], "> 0"), ([numpy.nan], "> 0"), ([], "> 0"), ([0.5, 0.5], "are the same")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.records.spectrum(RECORD, periods)
        both = gurney.records.measures(RECORD, ["Sa(0.3)"])
        self.assertAlmostEqual(spectrum.loc[0.3, "RotD50"] / both.loc["Sa(0.3)", "RotD50"], 1, delta=1e-12)

    def test_processing_scaling_floors_and_models(self):
        scaled = gurney.records.read(RECORD, scale_to="PGA component=larger value=0.2 unit=g")
        self.assertAlmostEqual(abs(scaled.acceleration[:, :2]).max(), 0.2 * 9.80665, delta=1e-8)
        low = gurney.records.process(RECORD, "low_pass corner_hz=2")
        self.assertLess(abs(low.acceleration).max(), 3.9)
        roof = gurney.records.floor(RECORD, "lead_rubber_hospital")
        self.assertIn("floor 4", roof.name)
        suite = gurney.records.scale([RECORD], "asce7 sds_g=1 sd1_g=0.6", periods=(0.2, 2))
        self.assertGreater(suite.loc["synthetic_3c", "factor"], 1)
        self.assertIn("common_factor", suite.attrs)
        for one in (RECORD, gurney.records.read(RECORD)):
            alone = gurney.records.scale(one, "asce7 sds_g=1 sd1_g=0.6", periods=(0.2, 2))
            self.assertAlmostEqual(alone["factor"].iloc[0] / suite["factor"].iloc[0], 1, delta=1e-12)
        pulse = gurney.records.make("ricker", period_s=1)
        self.assertEqual((pulse.components, pulse.acceleration.shape[1]), (("h1",), 1))
        self.assertIn("period_s", [each["key"] for each in gurney.records.kinds()["ricker"]["parameters"]])
        model = gurney.records.model(7, 20, vs30=400, periods=[0.5, 1])
        self.assertEqual(model.index.tolist(), [0.5, 1.0])
        self.assertEqual(gurney.records.ls(RECORD)["name"].tolist(), ["synthetic_3c"])
        for wrong in (lambda: gurney.records.read("nowhere.AT2"), lambda: gurney.records.make("rickr"),
                      lambda: gurney.records.process(RECORD, "low_pas corner_hz=2"),
                      lambda: gurney.records.floor(RECORD, "no_hospital"),
                      lambda: gurney.records.model(99, 20)):
            with self.assertRaises(gurney.InputError):
                wrong()


class Arrays(unittest.TestCase):
    PULSE = 3 * numpy.sin(2 * numpy.pi * numpy.arange(0, 2, 0.01))

    def test_times_of_an_index_are_the_time_step(self):
        series = pandas.Series(self.PULSE, 5 + numpy.arange(200).round(2) * 0.01)
        expected = gurney.simulate("xu_trolley", self.PULSE, 0.01, **SHORT).demands["xu_trolley"]
        found = gurney.simulate("xu_trolley", series, **SHORT).demands["xu_trolley"]
        # The step of times that were added up is 0.01 to 1e-15; the motion of half a metre follows.
        self.assertAlmostEqual(found["peak_displacement"], expected["peak_displacement"], delta=1e-9)
        for wrong in (self.PULSE, list(self.PULSE), pandas.Series(self.PULSE)):  # an index of 0, 1, 2 is no time
            with self.assertRaisesRegex(gurney.InputError, "needs time_step"):
                gurney.simulate("xu_trolley", wrong)
        with self.assertRaisesRegex(gurney.InputError, "not evenly spaced"):
            gurney.simulate("xu_trolley", series.drop(series.index[50]))

    def test_records_of_arrays_state_their_unit(self):
        record = gurney.records.from_array(self.PULSE / 9.80665, 0.01, unit="g")
        numpy.testing.assert_allclose(record.acceleration[:, 0], self.PULSE, rtol=1e-15, atol=1e-15)
        self.assertEqual((record.components, record.time_step), (("h1",), 0.01))
        self.assertAlmostEqual(gurney.records.measures(record, ["PGA"]).loc["PGA", "h1"], 3, delta=1e-12)
        frame = pandas.DataFrame(numpy.outer(self.PULSE, [1, 2, 3]), numpy.arange(200) * 0.01)
        self.assertEqual(gurney.records.from_array(frame, unit="cm/s2").to_frame()["vertical"].max(),
                         0.03 * self.PULSE.max())
        for array, step, unit, message in (
                (self.PULSE, 0.01, "m/s", "the unit must be"), (self.PULSE, None, "g", "time_step"),
                (numpy.zeros((5, 2)), 0.01, "g", r"\(5, 2\)"), ([1, numpy.nan], 0.01, "g", "finite"),
                ("abc", 0.01, "g", "record"), (3.0, 0.01, "g", "2 or more samples")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.records.from_array(array, step, unit=unit)

    def test_columns_are_told_apart_by_their_names(self):
        motion = numpy.outer(self.PULSE, [1, -0.5, 0.2])
        expected = repr(gurney.simulate("xu_trolley", motion, 0.01, **SHORT).demands)
        times = pandas.Index(numpy.arange(200) * 0.01, name="time")
        by_name = pandas.DataFrame({name: motion[:, "xyz".index(name)] for name in "zyx"}, times)
        record = gurney.records.from_array(motion, 0.01, unit="m/s2")
        for frame in (by_name, record.to_frame()[["vertical", "h1", "h2"]], by_name.reset_index()):
            self.assertEqual(repr(gurney.simulate("xu_trolley", frame, 0.01, **SHORT).demands), expected)
            again = gurney.records.from_array(frame, unit="m/s2")
            numpy.testing.assert_array_equal(again.acceleration, motion)
            self.assertAlmostEqual(again.time_step, 0.01, delta=1e-15)  # of times that are products
        only_y = gurney.records.from_array(by_name[["y"]], 0.01, unit="m/s2")
        self.assertEqual((only_y.components, only_y.to_frame().columns.tolist()), (("h2",), ["h2"]))
        numpy.testing.assert_array_equal(only_y.acceleration, motion * [0, 1, 0])
        self.assertEqual(repr(gurney.simulate("xu_trolley", only_y, **SHORT).demands),
                         repr(gurney.simulate("xu_trolley", only_y.to_frame(), 0.01, **SHORT).demands))
        for frame, message in (
                (by_name.rename(columns={"x": "ax"}), "column 'ax': must be x, y, z"),
                (by_name.rename(columns={"x": 0}), "column 0: must be x, y, z"),
                (by_name.rename(columns={"x": "h2"}), "a column for each component"),
                (by_name.assign(time=numpy.arange(200.0) ** 2), "not evenly spaced"),
                (by_name.assign(t=0), "column 't'")):
            for use in (lambda: gurney.simulate("xu_trolley", frame),
                        lambda: gurney.records.from_array(frame, unit="g")):
                with self.assertRaisesRegex(gurney.InputError, message):
                    use()
        if support.has("xarray"):
            array = by_name.stack().rename_axis(["time", "component"]).to_xarray().T
            self.assertEqual(array.dims, ("component", "time"))
            self.assertEqual(repr(gurney.simulate("xu_trolley", array, 0.01, **SHORT).demands), expected)

    def test_what_is_no_record_is_refused_by_both(self):
        masked = numpy.ma.masked_array(self.PULSE, numpy.arange(200) < 3)
        for array, step, message in (
                (masked, 0.01, "3 of 200 samples are masked"), (self.PULSE > 0, 0.01, "of bool"),
                (self.PULSE.astype("U9"), 0.01, "of <U9"), (self.PULSE + 0j, 0.01, "of complex128"),
                (self.PULSE, numpy.inf, "time_step"), (self.PULSE, True, "time_step"),
                (self.PULSE, "0.005", "time_step"), (self.PULSE, 5, "time_step"), (self.PULSE, -1, "time_step")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.records.from_array(array, step, unit="g")
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.simulate("xu_trolley", array, step)
        for name in ("a\nb", 3):
            with self.assertRaisesRegex(gurney.InputError, "name = .*one line"):
                gurney.records.from_array(self.PULSE, 0.01, unit="g", name=name)

    def test_labels_are_for_the_frame_alone(self):
        cases = [{"item": "xu_trolley", "record": self.PULSE, "time_step": 0.01, "label": label, **SHORT}
                 for label in ("a", "b")]
        frame = gurney.simulate_many(cases).to_frame()
        self.assertEqual(frame["label"].tolist(), ["a", "b"])
        self.assertEqual(frame.attrs["units"]["peak_displacement"], "m")


class Hazards(InFolder):
    def test_published_curves_need_their_component_alone(self):
        answer = {"response": {"hazardCurves": [{"imt": {"value": imt}, "data": [{
            "component": "Total", "values": {"xs": [0.1, 1], "ys": [0.01, rate]}}]}
            for imt, rate in (("PGA", 1e-4), ("SA1P0", 1e-5))]}}  # synthetic
        with open("usgs.json", "w", encoding="utf-8") as file:
            json.dump(answer, file)
        with open("oq.csv", "w", encoding="utf-8") as file:  # synthetic
            file.write("#,\"imt='PGA', investigation_time=1.0\"\nlon,lat,poe-0.1,poe-1.0\n1,2,0.5,0.1\n")
        hazard = gurney.read_hazard("usgs.json", "RotD50", measure="PGA")
        self.assertEqual(hazard.measure, "PGA RotD50")
        middle = 9.80665 * 10 ** -0.5  # in g; log-log
        self.assertAlmostEqual(hazard.rate(middle), 1e-3, delta=1e-15)
        self.assertTrue(numpy.isnan(hazard.to_frame([middle, 99]).iloc[1, 0]))
        self.assertAlmostEqual(gurney.read_hazard("oq.csv", "RotD50").rate(9.80665), -numpy.log(0.9), delta=1e-15)
        for asked, message in ((("usgs.json",), "component"), (("usgs.json", "RotD50"), "measure must be given"),
                               (("oq.csv", "RotD51"), "RotD50"), (("none.csv", "RotD50"), "no such file")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.read_hazard(*asked)
        with self.assertRaisesRegex(gurney.InputError, "go with component"):
            gurney.read_hazard("oq.csv", site=2)


class ComparedRecords(InFolder):
    def test_a_measure_predicts_each_record_from_the_others(self):
        job = gurney.read_job(os.path.join(JOBS, "ventilator_brakes.toml"))
        with gurney.study(job, "study.h5", progress=False, overrides={
                "study.synthetic_records": 7, "study.draws": 2, "study.measures": ["PGV", "Sa(0.3)"],
                "study.intensity.levels": [0.2, 0.4]}) as study:
            ranking = study.compare_records(configuration="free")
            frame = study.to_frame().reset_index()
            for wrong in ({"configuration": "freee"}, {"demand": "peak_tlt"}, {"level": 3}):
                with self.assertRaises(gurney.InputError):
                    study.compare_records(**{"configuration": "free", **wrong})
            with self.assertRaisesRegex(gurney.Error, "of 'locked'"):
                study.compare_records()
        frame = frame[(frame["configuration"] == "free") & (frame["intensity"] > 3)]
        means = frame.groupby("record")[["peak_displacement", "PGV geomean", "Sa(0.3) geomean", "pfv"]].mean()
        means = means.loc[ranking.index]
        numpy.testing.assert_allclose(ranking["demand"], means["peak_displacement"], rtol=1e-12)
        self.assertEqual(ranking["demand"].tolist(), sorted(ranking["demand"], reverse=True))
        self.assertEqual((ranking["runs"].tolist(), ranking.attrs["units"]["pfv"]), ([2] * 7, "m/s"))
        y, predicted = numpy.log(means["peak_displacement"].to_numpy()), {}
        for name in means.columns[1:]:  # each record by a line through the other six
            x = numpy.log(means[name].to_numpy())
            others = [numpy.arange(7) != i for i in range(7)]
            predicted[name] = [numpy.polyval(numpy.polyfit(x[i], y[i], 1), x[~i])[0] for i in others]
            of_mean = [y[i].mean() for i in others]
            share = 1 - sum((y - predicted[name]) ** 2) / sum((y - of_mean) ** 2)
            self.assertAlmostEqual(ranking.attrs["explained"][name], share, delta=1e-9)
        best = next(iter(ranking.attrs["explained"]))
        self.assertEqual(ranking.attrs["explained"][best], max(ranking.attrs["explained"].values()))
        numpy.testing.assert_allclose(ranking["predicted"], numpy.exp(predicted[best]), rtol=1e-9)
        self.assertIn(best, ranking.attrs["verdict"])


class Selections(InFolder):
    TARGET = "conditional magnitude=7 distance_km=10 vs30_m_per_s=400 period_s=1 epsilon=1"

    def setUp(self):
        super().setUp()
        os.mkdir("pool")
        for seed in range(8):
            gurney.records.make("stochastic", seed=seed + 1, frequency_hz=seed % 4 + 1).save(f"pool/{seed}.csv")

    def test_a_suite_is_that_of_the_program(self):
        listed = json.loads(support.gurney("records", "select", "pool", "--target", self.TARGET, "-n", 4,
                                           "--seed", 7, "--json", "-o", "program.csv"))
        suite = gurney.records.select("pool", self.TARGET, records=4, seed=7)
        self.assertEqual(suite.target, listed["target"])
        for row, (name, mine) in zip(listed["records"], suite.records.iterrows()):
            self.assertEqual((name, mine["factor"], mine["misfit"]),
                             (row["name"], row["factor"], row["misfit"]))
        self.assertEqual(suite.spectra.tolist(), [each["sa_m_per_s2"] for each in listed["records"]])
        for mine, name in ((suite.periods, "period_s"), (suite.median, "median_m_per_s2"),
                           (suite.sigma, "sigma"), (suite.mean_error, "mean_error")):
            self.assertEqual(mine.tolist(), [each[name] for each in listed["periods"]])
        self.assertEqual(suite.facts["total_error"], listed["total_error"])
        self.assertEqual(suite.to_frame()[listed["records"][2]["name"]].tolist(), suite.spectra[2].tolist())
        self.assertIn(suite.records.index[0], suite._repr_html_())
        suite.save("mine.csv")
        with open("mine.csv", encoding="utf-8") as mine, open("program.csv", encoding="utf-8") as program:
            self.assertEqual(mine.read(), program.read())
        with self.assertRaisesRegex(gurney.InputError, "mine.csv"):
            suite.save("mine.csv")

    def test_the_records_have_the_spectra(self):
        for steps in ((), ("high_pass corner_hz=0.2",)):
            suite = gurney.records.select(["pool"], self.TARGET, records=3, component="larger", steps=steps)
            for record, row in zip(suite.read(), suite.spectra):
                own = gurney.records.spectrum(record, suite.periods[::6])[["h1", "h2"]].max(axis=1)
                # A list has the factors with six digits; the periods go as text with six.
                numpy.testing.assert_allclose(own, row[::6], rtol=1e-4)

    def test_records_in_memory(self):
        files = gurney.records.read_all("pool")
        self.assertEqual([each.name for each in files], [str(each) for each in range(8)])
        suite = gurney.records.select(files, self.TARGET, records=3)
        self.assertEqual(suite.records["factor"].tolist(),
                         gurney.records.select("pool", self.TARGET, records=3).records["factor"].tolist())
        self.assertEqual([each.name for each in suite.read()], suite.records.index.tolist())
        with self.assertRaisesRegex(gurney.InputError, "save it first"):
            suite.save("list.csv")

    def test_what_is_left_out_is_warned_of(self):
        with self.assertWarnsRegex(UserWarning, "records are excluded: their factor is not in 0.5:1.5"):
            gurney.records.select("pool", self.TARGET, records=2, factors=(0.5, 1.5))
        alone = gurney.records.make("ricker", period_s=1)  # has h1 only, hence no RotD50
        for wrong, message in (((alone, self.TARGET), "skipped: .*h2"), (("pool", "condtional"), "conditional"),
                               (([], self.TARGET), "no record"), (("nowhere", self.TARGET), "nowhere")):
            with self.assertRaisesRegex(gurney.InputError, message):
                gurney.records.select(*wrong)
        with open("bins.csv", "w", encoding="utf-8") as file:  # synthetic
            file.write("#\nimt,iml,poe,mag,dist,eps,mean\nSA(1.0),0.4,0.02,6.5,15,1,0.01\n"
                       "SA(1.0),0.4,0.02,7.5,15,1,0.01\n")
        suite = gurney.records.select("pool", "disaggregation file=bins.csv vs30_m_per_s=400", records=2,
                                      factors=(0.1, 10))
        same = gurney.records.select(
            "pool", "conditional magnitude=7 distance_km=15 vs30_m_per_s=400 period_s=1 sa_g=0.4", records=2,
            factors=(0.1, 10))
        numpy.testing.assert_allclose(suite.median, same.median, rtol=1e-12)
        self.assertEqual(suite.records.index.tolist(), same.records.index.tolist())
        self.assertRegex(suite.target, r"Sa\(1 s\) = 0.4 g, .*M 7, .*bins.csv, whose epsilon is 1")
        with self.assertRaisesRegex(gurney.InputError, "20 are to be selected"):
            gurney.records.select("pool", self.TARGET)


class Described(unittest.TestCase):
    def test_everything_public_is_annotated_and_described(self):
        for _, module, names in api_page.GROUPS:
            for name in names:
                of = getattr(module, name)
                self.assertTrue(of.__doc__, name)
                functions = [of] if not inspect.isclass(of) else [
                    each for key, each in vars(of).items() if inspect.isfunction(each) and key[0] != "_"]
                for each in functions:
                    self.assertTrue(each.__doc__, each)
                    for parameter in inspect.signature(each).parameters.values():
                        if parameter.name != "self":
                            self.assertIsNot(parameter.annotation, parameter.empty, (each, parameter))
                    self.assertIsNot(inspect.signature(each).return_annotation, inspect.Signature.empty)
        shown = {name for _, module, names in api_page.GROUPS for name in names if module is gurney}
        self.assertEqual(set(gurney.__all__) - shown, {"Record", "program", "records"})

    def test_the_page_is_current(self):
        with open(os.path.join(support.SOURCE, "docs/python_api.md"), encoding="utf-8") as file:
            self.assertEqual(file.read(), api_page.page(), "run studies/python/api_page.py")

    def test_types(self):
        self.assertTrue(os.path.exists(os.path.join(support.BUILT, "gurney/py.typed")))
        if shutil.which("mypy") is None:
            self.skipTest("no mypy (Debian: mypy)")
        with tempfile.TemporaryDirectory() as cache:
            done = subprocess.run(["mypy", "--strict", "--ignore-missing-imports", "--allow-any-generics",
                                   "--cache-dir", cache, "gurney"], cwd=support.PACKAGE,
                                  capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main(argv=["api.py", "-v", *sys.argv[4:]])
