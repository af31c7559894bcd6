"""What commands print with --json fits docs/formats/findings.schema.json; with a key less, or a text for
a number, it does not."""

import copy
import json
import os
import tempfile

import support

support.need("jsonschema")

import jsonschema  # noqa: E402

with open(os.path.join(support.SOURCE, "docs/formats/findings.schema.json"), encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft7Validator.check_schema(schema)


def validator(subject):
    return jsonschema.Draft7Validator({"$ref": "#/definitions/" + subject, "definitions": schema["definitions"]})


def check(subject, found, number):
    """number: a key of a number of the subject, or a path to it."""
    errors = [f"{'/'.join(map(str, error.path))}: {error.message}" for error in validator(subject).iter_errors(found)]
    assert not errors, (subject, errors)
    for key in schema["definitions"][subject]["required"]:
        less = {each: value for each, value in found.items() if each != key}
        assert not validator(subject).is_valid(less), (subject, key)
    wrong = copy.deepcopy(found)
    of = wrong
    for step in number[:-1]:
        of = of[step]
    assert isinstance(of[number[-1]], (int, float)), (subject, number)
    of[number[-1]] = "much"
    assert not validator(subject).is_valid(wrong), (subject, number)


jobs = os.path.join(support.SOURCE, "studies/jobs")
with tempfile.TemporaryDirectory() as folder:
    run, resting, study = (os.path.join(folder, name) for name in ("run.h5", "resting.h5", "study.h5"))
    for job, result in (("pole_overturns", run), ("trolley_meets_wall", resting)):
        found = json.loads(support.gurney("run", os.path.join(jobs, job + ".toml"), "-o", result, "--json"))
        check("run", found, ["end_time_s"])
        check("run_overview", json.loads(support.gurney("show", result, "--json")),
              ["items", 0, "peak_displacement"])
        check("explanation", json.loads(support.gurney("explain", result, "--json")), ["items", 0, "mass_kg"])
    support.gurney("run", os.path.join(jobs, "tutorial_study.toml"), "-o", study)
    check("study_overview", json.loads(support.gurney("show", study, "--json")), ["counts", 0, "runs"])
    for options in ([], ["--method", "cloud"]):
        check("fragility", json.loads(support.gurney("fragility", study, "--json", *options)),
              ["fragilities", 0, "runs"])
    hazard = os.path.join(support.SOURCE, "studies/assessment/hazard.toml")
    losing = os.path.join(folder, "losing.h5")
    with open(os.path.join(jobs, "icu_ventilator_fragility.toml")) as file:
        job = file.read().replace('"../..', f'"{support.SOURCE}').replace("synthetic_records = 30", "synthetic_records = 6")
    fewer = os.path.join(folder, "fewer.toml")
    with open(fewer, "w") as file:
        file.write(job)
    support.gurney("run", fewer, "-o", losing)
    for options in ([], ["--measure", "PGA geomean", "--at", "0.3", "--hazard", hazard]):
        check("loss", json.loads(support.gurney("loss", losing, "--json", *options)), ["losses", 0, "runs"])
    check("comparison", json.loads(support.gurney("compare", study, "--json")), ["smallest_p_possible"])
check("hospital", json.loads(support.gurney(
    "hospital", os.path.join(support.SOURCE, "studies/hospitals/ward.toml"), "--samples", "200", "--json")),
    ["levels", 0, "beds_out"])
check("calibration", json.loads(support.gurney(
    "calibrate", os.path.join(support.SOURCE, "studies/calibration/example"), "--json")), ["constants", 0, "value"])
check("verification", json.loads(support.gurney("verify", "alignment/crosswise", "--json")),
      ["cases", 0, "seconds"])
subjects = {each["$ref"].rsplit("/", 1)[1] for each in schema["anyOf"]}
assert subjects == {name for name, of in schema["definitions"].items() if "required" in of}, subjects
print(f"{len(subjects)} subjects fit their schema")
