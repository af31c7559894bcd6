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

    def results():
        with open("results.out", encoding="utf-8") as file:
            return [float(each) for each in file.read().split()]

    def drive(params, *demands, job=job):
        lines = params if isinstance(params, str) else (
            f"{len(params)}\n" + "".join(f"{name} {value}\n" for name, value in params))
        with open("params.in", "w", encoding="utf-8") as file:
            file.write(lines)
        if os.path.exists("results.out"):
            os.remove("results.out")
        return subprocess.run([sys.executable, DRIVER, job, *demands, "--gurney", support.GURNEY],
                              capture_output=True, text=True)

    done = drive([("excitation__record__scale", 0.5), ("item__headings_deg__0", 77)],
                 "peak_displacement", "impacts")
    assert done.returncode == 0, done.stderr
    half = results()
    with open(job, encoding="utf-8") as file:
        text = file.read()
    changed = text.replace("scale = 1.0", "scale = 0.5").replace("[10, 100", "[77, 100")
    assert changed != text
    with open("studies/jobs/changed.toml", "w", encoding="utf-8") as file:
        file.write(changed)
    run = json.loads(support.gurney("run", "studies/jobs/changed.toml", "-o", "changed.h5",
                                    "--no-figure", "--json"))
    demands = run["items"][0]["demands"]
    assert half == [demands["peak_displacement"], demands["impacts"]], (half, demands)
    assert os.listdir("studies/jobs").count("changed.toml") == 1
    assert not [name for name in os.listdir("studies/jobs") if name.endswith(".json")]

    # The first question of a reliability run: 0 or 1, in every run.
    assert demands["time_of_overturning"] is None
    done = drive([("excitation__record__scale", 0.5)], "overturned", "peak_tilt")
    assert done.returncode == 0 and results()[0] == 0, (done, results())
    done = drive([], "overturned", "time_of_overturning", job="studies/jobs/pole_overturns.toml")
    assert done.returncode == 0 and results()[0] == 1 and results()[1] > 0, (done, results())
    done = drive([], "time_of_overturning")
    assert done.returncode != 0 and "'overturned' is 0 or 1" in done.stderr, done
    assert "Traceback" not in done.stderr and not os.path.exists("results.out")
    done = drive([], "time_of_overturning", "--missing", "99")
    assert done.returncode == 0 and results() == [99], done

    # Text, as quoFEM writes it: another floor covering changes the result.
    other = [("floor__covering", '"rubber"')]
    with open(job, encoding="utf-8") as file:
        assert 'covering = "' in file.read()
    done = drive([("excitation__record__scale", 0.5), *other], "peak_displacement")
    assert done.returncode == 0 and results()[0] != half[0], done

    # UQ engines copy the job alone to workdir.N: paths of the job still start where it stood.
    os.makedirs("workdir.1")
    shutil.copy(job, "workdir.1/job.toml")
    alone = [("excitation__record__scale", 0.5), ("item__headings_deg__0", 77)]
    done = drive(alone, "peak_displacement", job="workdir.1/job.toml")
    assert done.returncode != 0 and "--folder states another folder" in done.stderr, done
    done = drive(alone, "peak_displacement", "--folder", "studies/jobs", job="workdir.1/job.toml")
    assert done.returncode == 0 and results() == half[:1], (done, half)

    for params, asked, message in (
            ([("excitation__record__scal", 1)], "impacts", "no key excitation.record.scal"),
            ([], "peak_displacment", "no demand peak_displacment"),
            ([("item__headings_deg__x", 1)], "impacts", "no key item.headings_deg.x"),
            ([("settings__time_step_s", "1 2")], "impacts", "params.in:2:"),
            ([("settings__time_step_s", -1)], "impacts", "time_step_s")):
        done = drive(params, asked)
        assert done.returncode != 0 and message in done.stdout + done.stderr, (params, done)
        assert not os.path.exists("results.out")
    scale = "excitation__record__scale 0.5\n"
    for text, message in (("2\n" + scale, "params.in:1: '2'"), ("1\n" + scale * 2, "there are 2 lines"),
                          ("2\n" + scale * 2, "params.in:3: excitation__record__scale is there twice"),
                          ("x\n" + scale, "params.in:1: 'x'"), ("", "params.in:1: ''")):
        done = drive(text, "impacts")
        assert done.returncode != 0 and message in done.stderr, (text, done)
        assert "Traceback" not in done.stderr and not os.path.exists("results.out")
    done = drive([], "impacts", job="nowhere.toml")
    assert done.returncode != 0 and "nowhere.toml" in done.stderr and "Traceback" not in done.stderr, done

# The shipped example, as a UQ engine loops over it: the template is copied to workdir.N, which gets its
# own params.in and has a results.out of as many numbers as there are responses.
with tempfile.TemporaryDirectory() as folder:
    template = os.path.join(folder, "templatedir")
    shutil.copytree(os.path.join(support.PACKAGE, "quofem_example"), template)
    shutil.copy(DRIVER, template)
    responses = []
    for number, (scale, yaw) in enumerate(((0.2, 0), (1, 0), (1, 130)), start=1):
        place = os.path.join(folder, f"workdir.{number}")
        shutil.copytree(template, place)
        with open(os.path.join(place, "params.in"), "w", encoding="utf-8") as file:
            file.write(f"2\nexcitation__record__scale {scale}\nitem__yaw_deg {yaw}\n")
        done = subprocess.run(["./driver", "--gurney", support.GURNEY], cwd=place, capture_output=True,
                              text=True)
        assert done.returncode == 0, done.stderr
        with open(os.path.join(place, "results.out"), encoding="utf-8") as file:
            responses.append([float(each) for each in file.read().split()])
    assert all(len(each) == 2 and each[0] in (0, 1) for each in responses), responses
    assert responses[0][1] < responses[1][1] and responses[1] != responses[2], responses
print("the driver gives", half, responses)
