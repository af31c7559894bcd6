"""Results that an earlier program wrote open in this one, and mean the same.

The files are those of gurney 0.1.0 of commit bde08e5 (2026-11-22): a run, and a study of which this is
the job. That program called the column analysis_case `unit`, and the keys ida and step_check `hunt`
and `certificate`.

usage: old_results.py GURNEY SOURCE_FOLDER BUILT_PACKAGE
"""

import gzip
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../python"))
import support  # noqa: E402

support.need_module()
support.use_package()

import gurney  # noqa: E402
import h5py  # noqa: E402


def unpacked(name, folder):
    path = os.path.join(folder, name)
    packed = os.path.join(support.SOURCE, "tests/system/old_results", f"{name}.gz")
    with gzip.open(packed) as source, open(path, "wb") as target:
        target.write(source.read())
    return path


def in_words_of_today(path, folder):
    """The same study under the names that this program gives."""
    today = os.path.join(folder, "today.h5")
    with open(path, "rb") as source, open(today, "wb") as target:
        target.write(source.read())
    with h5py.File(today, "r+") as file:
        file["runs"].move("unit", "analysis_case")
        text = file.attrs["job_text"]
        text = text.replace("hunt", "ida").replace("certificate", "step_check")
        file.attrs.modify("job_text", text)
        file.attrs.modify("job_sha256", hashlib.sha256(text.encode()).hexdigest())
    return today


class OldResults(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.study = unpacked("study_of_bde08e5.h5", self.folder.name)
        self.run_file = unpacked("run_of_bde08e5.h5", self.folder.name)
        self.today = in_words_of_today(self.study, self.folder.name)

    def csv_of(self, path):
        folder = f"{path}_csv"
        support.gurney("export", path, "--to", "csv", "-o", folder)
        tables = {}
        for name in os.listdir(folder):
            with open(os.path.join(folder, name), encoding="utf-8") as table:
                tables[name] = table.read()
        return tables

    def test_have_the_old_names(self):
        with h5py.File(self.study) as file:
            self.assertIn("unit", file["runs"])
            self.assertNotIn("analysis_case", file["runs"])
            self.assertIn("hunt = {", file.attrs["job_text"])
            self.assertIn("certificate = ", file.attrs["job_text"])
            self.assertTrue(file.attrs["git_commit"].startswith("bde08e5"))

    def test_say_what_they_say_under_the_names_of_today(self):
        for command in (["fragility", "--json"], ["compare", "--configuration", "false,true"],
                        ["measures"]):
            said = [support.gurney(command[0], path, *([path] if command[0] == "compare" else []),
                                   *command[1:]).replace(path, "FILE")
                    for path in (self.study, self.today)]
            self.assertEqual(*said)
        self.assertIn('"moved"', support.gurney("fragility", self.study, "--json"))
        # Of a table only the name of the column is another.
        old, today = self.csv_of(self.study), self.csv_of(self.today)
        self.assertEqual(old.keys(), today.keys())
        for name in old.keys() - {"runs.csv"}:
            self.assertEqual(old[name], today[name], name)

    def test_of_studies_and_runs_open_in_every_command(self):
        self.assertIn("a study of 24 runs", support.gurney("show", self.study))
        self.assertIn("Trolley, as of November 2026", support.gurney("show", self.run_file))
        for path in (self.study, self.run_file):
            support.gurney("report", path, "-o", f"{path}.html")
        support.gurney("play", self.run_file, "-o", f"{self.run_file}.play.html")
        self.csv_of(self.run_file)

    def changed(self, name, change):
        """The study of today with a change that h5py makes."""
        path = os.path.join(self.folder.name, name)
        with open(self.today, "rb") as source, open(path, "wb") as target:
            target.write(source.read())
        with h5py.File(path, "r+") as file:
            change(file)
        return path

    def test_are_read_though_a_demand_is_missing(self):
        def remove(file):
            del file["items/peak_yaw"]
            del file["half_step/peak_yaw"]

        path = self.changed("without.h5", remove)
        # These demands are younger than these files.
        listed = "demands not in this file\n(?:  [a-z_]+\n)*  peak_yaw\n"
        self.assertRegex(support.gurney("show", path), listed)
        self.assertNotRegex(support.gurney("show", self.today), listed)
        missing, before = (json.loads(support.gurney("show", each, "--json"))["demands_not_in_file"]
                           for each in (path, self.today))
        self.assertEqual(set(missing) - set(before), {"peak_yaw"})
        self.assertEqual(set(before), {
            "peak_slide", "time_of_fall", "time_of_toppling", "peak_travel", "residual_travel", "peak_swing", "residual_swing",
            "time_of_release", "largest_stop_speed"})
        for command in (["fragility", "--json"], ["measures"]):
            said = [support.gurney(command[0], each, *command[1:]).replace(each, "FILE")
                    for each in (path, self.today)]
            self.assertEqual(*said)
        support.gurney("compare", path, path, "--configuration", "false,true")
        support.gurney("report", path, "-o", f"{path}.html")
        with open(f"{path}.html", encoding="utf-8") as page:
            self.assertIn("does not have: peak_yaw", page.read())
        responses = os.path.join(self.folder.name, "responses")
        support.gurney("export", path, "--to", "response-csv", "-o", responses)
        refused = subprocess.run([support.GURNEY, "fragility", path, "--limit-state",
                                  "peak_yaw > 1 deg"], capture_output=True, text=True, check=False)
        self.assertEqual(refused.returncode, 1, refused.stdout)
        self.assertIn("holds no peak_yaw", refused.stderr)
        results = gurney.Results(path)
        self.assertNotIn("peak_yaw", results.demands)
        self.assertEqual(str(results.fragility("moved", configuration="true")).replace(path, ""),
                         str(gurney.Results(self.today).fragility(
                             "moved", configuration="true")).replace(self.today, ""))
        with self.assertRaisesRegex(gurney.InputError, "holds no peak_yaw"):
            results.exceeded("peak_yaw > 1 rad")

    def test_of_version_1_are_read(self):
        def to_version_1(file):
            del file["data_files"]
            file.attrs.modify("format_version", 1)

        path = self.changed("version_1.h5", to_version_1)
        self.assertEqual(
            *(support.gurney("fragility", each, "--json").replace(each, "FILE")
              for each in (path, self.today)))
        for command in ("show", "measures"):
            support.gurney(command, path)
        support.gurney("report", path, "-o", f"{path}.html")
        self.assertEqual(list(gurney.Results(path).runs["outcome"]),
                         list(gurney.Results(self.today).runs["outcome"]))

    def test_of_later_versions_are_refused(self):
        path = self.changed("version_9.h5", lambda file: file.attrs.modify("format_version", 9))
        refused = subprocess.run([support.GURNEY, "measures", path], capture_output=True, text=True,
                                 check=False)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("format_version 9", refused.stderr)
        with self.assertRaisesRegex(gurney.Error, "reads version 1 and 2"):
            gurney.Results(path)

    def test_open_in_the_python_package(self):
        old, today = gurney.Results(self.study), gurney.Results(self.today)
        self.assertEqual(list(old.runs["analysis_case"]), list(today.runs["analysis_case"]))
        fits = [json.dumps(str(each.fragility("moved", configuration="true")).replace(
            os.path.basename(path), "")) for each, path in ((old, self.study), (today, self.today))]
        self.assertEqual(*fits)
        self.assertGreater(len(gurney.Results(self.run_file).demands), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
