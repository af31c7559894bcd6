"""gurney.simulate: the bits of `gurney run`, from several threads too, and errors with their places."""

import multiprocessing.pool
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import support

support.need_module()
support.use_package()

import gurney  # noqa: E402
import numpy  # noqa: E402

JOBS = os.path.join(support.SOURCE, "studies/jobs")
RECORD = os.path.join(support.SOURCE, "groundmotions/records/synthetic_3c.csv")


def samples():
    """The shipped record as an array [m/s2] with its time step."""
    rows = []
    with open(RECORD, encoding="utf-8") as file:
        for line in file:
            if line[0].isdigit() or line[0] == "-":
                rows.append([float(cell) for cell in line.split(",")])
    table = numpy.array(rows)
    return table[:, 1:], table[1, 0] - table[0, 0]


class SameBits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def of_program(self, job):
        path = os.path.join(self.folder, "program.h5")
        support.gurney("run", job, "-o", path, "--no-figure", "--overwrite")
        with open(path, "rb") as file:
            return file.read()

    def test_a_job_gives_the_file_of_gurney_run(self):
        for name in ("icu_ventilator_shake", "icu_bay", "pulling_test", "icu_ventilator_draw"):
            job = os.path.join(JOBS, name + ".toml")
            saved = os.path.join(self.folder, name + ".h5")
            gurney.simulate_job(job).save(saved)
            with open(saved, "rb") as file:
                self.assertEqual(file.read(), self.of_program(job), name)
            with self.assertRaises(FileExistsError):
                gurney.simulate_job(job, predictability=False).save(saved)

    def test_an_array_acts_as_the_file_that_holds_it(self):
        record, step = samples()
        options = {"settings": {"duration_s": 6}, "floor": {"covering": "polyflor_mystique"}}
        item = {"equipment": "icu_ventilator", "headings_deg": numpy.array([10, 100, 200, 300])}
        array = gurney.simulate(item, record, step, **options)
        file = gurney.simulate(item, RECORD, **options)
        stated = gurney.simulate(item, {"file": RECORD, "scale": 1}, **options)
        # As texts, since NaN differs from itself.
        self.assertEqual(repr(array.demands), repr(file.demands))
        self.assertEqual(repr(array.demands), repr(stated.demands))
        for name, values in array.histories.items():
            numpy.testing.assert_array_equal(values, file.histories[name], name)
        one = gurney.simulate(item, record[:, 0], step, **options)
        flat = record * [1, 0, 0]
        self.assertEqual(repr(one.demands),
                         repr(gurney.simulate(item, flat, step, **options).demands))
        self.assertNotEqual(repr(one.demands), repr(array.demands))

    def test_histories_are_those_of_the_file(self):
        for name in ("icu_bay", "pulling_test"):
            run = gurney.simulate_job(os.path.join(JOBS, name + ".toml"))
            self.assertTrue(run.results.verified)
            filed = run.results.histories()
            self.assertGreater(len(run.histories), 30)
            for each, values in run.histories.items():
                numpy.testing.assert_array_equal(values, numpy.asarray(filed[each]), each)
                self.assertEqual(values.shape, numpy.asarray(filed[each]).shape, each)
            demands = run.results.demands
            for item, of_item in run.demands.items():
                for each, value in of_item.items():
                    numpy.testing.assert_equal(value, demands.xs(item, level="item")[each].iloc[0])
            self.assertEqual(set(run.wheels), set(run.items))

    def test_threads_give_the_bits_of_one(self):
        record, step = samples()
        scales = [0.5 + 0.05 * i for i in range(16)]

        def run(scale):
            return gurney.simulate("icu_ventilator", scale * record, step, predictability=False,
                                   settings={"duration_s": 6})._run.results()

        alone = [run(scale) for scale in scales]
        with multiprocessing.pool.ThreadPool(4) as pool:
            together = pool.map(run, scales)
        self.assertEqual(alone, together)
        self.assertEqual(len(set(alone)), len(scales))

    def test_other_threads_run_meanwhile(self):
        record, step = samples()
        long = numpy.tile(record, (20, 1))
        ended, counted = threading.Event(), [0]

        def count():
            while not ended.is_set():
                counted[0] += 1
                ended.wait(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        gurney.simulate("icu_ventilator", long, step, predictability=False,
                        output={"histories": False})
        during = counted[0] - before
        ended.set()
        thread.join()
        # With the GIL held, the other thread counts twice at most: before it is taken, and after.
        self.assertGreater(during, 2)


class Errors(unittest.TestCase):
    def refused(self, pattern, *arguments, **tables):
        with self.assertRaisesRegex(gurney.InputError, pattern):
            gurney.simulate(*arguments, **tables)

    def test_places(self):
        with tempfile.TemporaryDirectory() as folder:
            job = os.path.join(folder, "bad.toml")
            with open(job, "w", encoding="utf-8") as file:
                file.write('schema = "gurney-job/1"\n[item]\nequipment = "icu_ventilatr"\n'
                           "[settings]\ntime_step_s = -1\n")
            with self.assertRaises(gurney.InputError) as raised:
                gurney.simulate_job(job)
            self.assertIn(f"{job}:3:13: item.equipment", str(raised.exception))
            self.assertIn("icu_ventilator", str(raised.exception))
            self.assertIn(f"{job}:5:15: settings.time_step_s", str(raised.exception))
            self.assertIsInstance(raised.exception, ValueError)
            item = os.path.join(folder, "item.toml")
            with open(item, "w", encoding="utf-8") as file:
                file.write('schema = "gurney-item/1"\nnme = "x"\n')
            self.refused(rf"{item}:2:1: .*nme", item)

    def test_arguments(self):
        quiet = numpy.zeros((100, 3))
        self.refused("simulate.json:/item/equipment", "icu_ventilatr")
        self.refused("simulate.json:/settings/solver", "xu_trolley", settings={"solver": "best"})
        self.refused("needs time_step", "xu_trolley", quiet)
        self.refused("time_step = -1: must be in", "xu_trolley", quiet, -1)
        self.refused("2 columns", "xu_trolley", quiet[:, :2], 0.01)
        self.refused("2 or more", "xu_trolley", quiet[:1], 0.01)
        self.refused("1 or 2 dimensions", "xu_trolley", quiet.reshape(10, 10, 3), 0.01)
        self.refused("not an array of real numbers, but of <U1", "xu_trolley", ["a", "b"], 0.01)
        bad = quiet.copy()
        bad[7, 1] = numpy.nan
        self.refused("sample 7, column 1 is not a finite number", "xu_trolley", bad, 0.01)
        self.refused("time_step goes with an array", "xu_trolley", RECORD, 0.01)
        self.refused("time_step goes with an array", "xu_trolley", None, 0.01)
        self.refused("has a record already", "xu_trolley", quiet, 0.01,
                     excitation={"record": {"file": RECORD}})
        for path in ("a\0b", "\0"):
            with self.assertRaisesRegex(gurney.InputError, "no NUL"):
                gurney.simulate_job(path)
        with self.assertRaisesRegex(gurney.InputError, r"table \[study\]"):
            gurney.simulate_job(os.path.join(JOBS, "trolley_levels.toml"))
        with self.assertRaisesRegex(gurney.InputError, "nowhere.toml"):
            gurney.simulate_job("nowhere.toml")

    def test_arrays_that_are_no_record(self):
        quiet = numpy.zeros(100)
        for kind in ("?", "S5", "U5", "M8[s]", "m8[s]", "c16"):
            self.refused("not an array of real numbers", "xu_trolley", quiet.astype(kind), 0.01)
        self.refused("not an array of real numbers", "xu_trolley", [True, 0.5, None], 0.01)
        masked = numpy.ma.masked_array(quiet, numpy.arange(100) < 3)
        self.refused("3 of 100 samples are masked", "xu_trolley", masked, 0.01)
        limit = 980.665
        for sign in (1, -1):
            above = quiet.copy()
            above[7] = sign * limit * (1 + 1e-9)
            self.refused(r"sample 7, column 0 is -?980.665 m/s2; at most 980.665 m/s2 \(100 g\)",
                         "xu_trolley", above, 0.01)
        short = {"settings": {"duration_s": 0.02}, "predictability": False}
        for same in (quiet.astype(object), quiet.astype(">f4"), quiet.astype(int),
                     numpy.ma.masked_array(quiet), quiet.tolist()):
            self.assertFalse(gurney.simulate("xu_trolley", same, 0.01, **short).failed)

    def test_values_of_other_types(self):
        quiet = numpy.zeros(100)
        for step in (True, numpy.bool_(True), "0.01", [0.01]):
            self.refused("time_step = .*: must be a number", "xu_trolley", quiet, step)
        for choice in ("no", 0, None):
            self.refused("predictability = .*: must be True or False", "xu_trolley", quiet, 0.01,
                         predictability=choice)
        deep = {}
        for _ in range(100000):
            deep = {"a": deep}
        self.refused("nested too deep", {"equipment": "xu_trolley", "z": deep})
        while deep:
            deep = deep["a"]
        circle = {"equipment": "xu_trolley"}
        circle["z"] = circle
        self.refused("cannot be written as JSON", circle)
        self.refused("cannot be written as JSON", {"equipment": "xu_trolley", (1, 2): 3})
        self.refused("excitation = 5: must be a dict", "xu_trolley", RECORD, excitation=5)

    def test_without_the_module_the_rest_works(self):
        program = ("import gurney\ntry:\n  gurney.simulate('xu_trolley')\n"
                   "except ImportError as error:\n  print(error)\n")
        printed = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True,
                                 text=True, cwd="/", env={**os.environ,
                                                          "PYTHONPATH": support.PACKAGE}).stdout
        self.assertIn("pybind11-dev", printed)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
