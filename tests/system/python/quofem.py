"""The driver for quoFEM: params.in -> results.out; the result is that of the changed job."""

import json
import os
import shutil
import subprocess
import sys
import tempfile

import support

DRIVER = os.path.join(support.PACKAGE, "quofem_driver.py")

with tempfile.TemporaryDirectory() as folder:
    for name in ("studies", "equipment", "groundmotions"):
        shutil.copytree(os.path.join(support.SOURCE, name), os.path.join(folder, name))
    os.chdir(folder)
    job = "studies/jobs/icu_ventilator_shake.toml"

    def drive(params, *demands):
        with open("params.in", "w", encoding="utf-8") as file:
            file.write(f"{len(params)}\n" + "".join(f"{name} {value}\n" for name, value in params))
        if os.path.exists("results.out"):
            os.remove("results.out")
        return subprocess.run([sys.executable, DRIVER, job, *demands, "--gurney", support.GURNEY],
                              capture_output=True, text=True)

    done = drive([("excitation__record__scale", 0.5), ("item__headings_deg__0", 77)],
                 "peak_displacement", "impacts")
    assert done.returncode == 0, done.stderr
    with open("results.out", encoding="utf-8") as file:
        results = [float(each) for each in file.read().split()]
    with open(job, encoding="utf-8") as file:
        text = file.read()
    changed = text.replace("scale = 1.0", "scale = 0.5").replace("[10, 100", "[77, 100")
    assert changed != text
    with open("studies/jobs/changed.toml", "w", encoding="utf-8") as file:
        file.write(changed)
    run = json.loads(support.gurney("run", "studies/jobs/changed.toml", "-o", "changed.h5",
                                    "--no-figure", "--json"))
    demands = run["items"][0]["demands"]
    assert results == [demands["peak_displacement"], demands["impacts"]], (results, demands)
    assert os.listdir("studies/jobs").count("changed.toml") == 1
    assert not [name for name in os.listdir("studies/jobs") if name.endswith(".json")]

    for params, asked, message in (
            ([("excitation__record__scal", 1)], "impacts", "no key excitation.record.scal"),
            ([], "peak_displacment", "no demand peak_displacment"),
            ([("settings__time_step_s", -1)], "impacts", "time_step_s")):
        done = drive(params, asked)
        assert done.returncode != 0 and message in done.stdout + done.stderr, (params, done)
        assert not os.path.exists("results.out")
print("the driver gives", results)
