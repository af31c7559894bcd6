"""studies/python/Snakefile makes curves and exports, and repeats nothing when all is there."""

import json
import os
import shutil
import subprocess
import tempfile

import support

if shutil.which("snakemake") is None:
    support.skip("no snakemake (Debian: snakemake)")

with tempfile.TemporaryDirectory() as folder:
    command = ["snakemake", "-s", os.path.join(support.PACKAGE, "Snakefile"), "-j", "2",
               "--nolock", "-d", folder, "--config",
               f"job={support.SOURCE}/studies/jobs/trolley_levels.toml", "shards=2",
               f"gurney={support.GURNEY}", "threads=1", "mem_mb=500", "runtime=10"]
    home = {**os.environ, "HOME": folder, "XDG_CACHE_HOME": folder}
    done = subprocess.run(command, capture_output=True, text=True, env=home)
    assert done.returncode == 0, done.stderr
    with open(os.path.join(folder, "trolley_levels_fragility.json"), encoding="utf-8") as file:
        found = json.load(file)
    whole = os.path.join(folder, "whole.h5")
    support.gurney("run", os.path.join(support.SOURCE, "studies/jobs/trolley_levels.toml"), "-o",
                   whole)
    assert found == json.loads(support.gurney("fragility", whole, "--json"))
    assert os.path.exists(os.path.join(folder, "trolley_levels_pelicun/fragility.csv"))
    # What a cluster is asked for, by shard.
    planned = subprocess.run([*command, "--dry-run", "--forceall", "--printshellcmds"], capture_output=True,
                             text=True, env=home)
    shown = planned.stdout + planned.stderr
    assert shown.count("mem_mb=500") == 3 and shown.count("runtime=10") == 3, shown
    again = subprocess.run(command, capture_output=True, text=True, env=home)
    assert "Nothing to be done" in again.stdout + again.stderr, again.stderr
print("the workflow gives the curves of the whole study")
