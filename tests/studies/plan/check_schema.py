"""Every shipped job fits docs/formats/job.schema.json, and bad ones do not. Exit code 77: not
installed.

usage: check_schema.py GURNEY SOURCE_FOLDER
"""

import copy
import json
import os
import subprocess
import sys
import tempfile

try:
    import tomllib

    import jsonschema
except ImportError as error:
    print(f"skipped: {error} (Debian: python3-jsonschema)")
    sys.exit(77)

gurney, source = sys.argv[1], sys.argv[2]
with open(os.path.join(source, "docs/formats/job.schema.json"), encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)

folder = os.path.join(source, "studies/jobs")
jobs = {}
for name in sorted(os.listdir(folder)):
    if name.endswith(".toml"):
        with open(os.path.join(folder, name), "rb") as file:
            jobs[name] = tomllib.load(file)
        errors = [error.message for error in validator.iter_errors(jobs[name])]
        assert not errors, (name, errors)
assert len(jobs) > 5, jobs.keys()

study = jobs["brakes_study.toml"]
bad = {
    "schema": "gurney-job/2",
    "itm": {},
    "item": {"equipment": 3},
    "settings": {"time_step_s": -0.004},
    "excitation": {"record": {"fle": "a.csv"}},
    "study": {"draws": 0},
}
for key, value in bad.items():
    job = copy.deepcopy(study)
    job[key] = value
    assert not validator.is_valid(job), (key, value)
for key in ("schema", "item"):
    job = copy.deepcopy(study)
    del job[key]
    assert not validator.is_valid(job), key

with tempfile.TemporaryDirectory() as temporary:
    path = os.path.join(temporary, "study.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(study, file)
    from_json = json.loads(subprocess.run([gurney, "check", path, "--json"], check=True,
                                          capture_output=True, text=True).stdout)
    from_toml = json.loads(subprocess.run(
        [gurney, "check", os.path.join(folder, "brakes_study.toml"), "--json"], check=True,
        capture_output=True, text=True).stdout)
    for key in ("configurations", "records", "levels", "cases", "runs"):
        assert from_json[key] == from_toml[key], (key, from_json[key], from_toml[key])
print(f"{len(jobs)} jobs fit, {len(bad) + 2} bad ones do not")
