"""`pip install .` without a network, as python.md says: the archive of the sources holds what git knows, a
wheel of it has engine, program and data, and a fresh virtual environment runs a job with them to the bits
of the build; afterwards it has the readers alone. The wheel takes the build of the test: it compiles nothing."""

import glob
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile

import support

support.need("h5py", "pandas", "pip", "venv")
support.need_module()
BUILD = os.path.dirname(support.BUILT)
JOB = os.path.join(support.SOURCE, "studies/jobs/icu_ventilator_shake.toml")


def printed(*command, where, code=0, **environment):
    clean = {name: value for name, value in os.environ.items()
             if name not in ("PYTHONPATH", "GURNEY_DATA", "GURNEY_BUILD", "CMAKE_ARGS")}
    done = subprocess.run(command, capture_output=True, text=True, cwd=where,
                          env={**clean, "PIP_NO_INDEX": "1", **environment})
    assert done.returncode == code, (command, done.stdout, done.stderr)
    return done.stdout + done.stderr


with tempfile.TemporaryDirectory() as folder:
    # The archive is made by the backend that the root names, as `python3 -m build --sdist` does it.
    archive = printed(sys.executable, "-Bc", "import sys; sys.path.insert(0, 'studies/build_info'); "
                      "import gurney_wheel; print(gurney_wheel.build_sdist(sys.argv[1]))", folder,
                      where=support.SOURCE).strip()
    with tarfile.open(os.path.join(folder, archive)) as packed:
        names = {name.split("/", 1)[1] for name in packed.getnames()}
        packed.extractall(folder)
    for name in ("PKG-INFO", "pyproject.toml", "CMakeLists.txt", "engine/run/run.h", "LICENSE",
                 "equipment/items/icu_bed.toml", "studies/python/gurney/__init__.py"):
        assert name in names, name
    assert not [name for name in names if name.startswith(("build/", "out/", ".git/"))], names
    source = os.path.join(folder, archive.removesuffix(".tar.gz"))

    whole = os.path.join(folder, "whole")
    python = os.path.join(whole, "bin/python")
    made = subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", whole],
                          capture_output=True, text=True)
    if made.returncode != 0:
        support.skip("no virtual environment (Debian: python3-venv): " + made.stdout[:200])
    # In the isolation of pip, which would fetch what a build needs; then with its dependencies.
    printed(python, "-m", "pip", "wheel", "--no-deps", "-w", folder, os.path.join(folder, archive),
            where=folder, GURNEY_BUILD=BUILD)
    wheel, = glob.glob(os.path.join(folder, "gurney-*-linux_*.whl"))
    printed(python, "-m", "pip", "install", wheel, where=folder)
    installed = os.path.join(whole, "bin/gurney")
    findings = json.loads(printed(installed, "doctor", "--json", where=folder))
    assert os.path.join(whole, "share/gurney") in json.dumps(findings), findings
    # Its own data: an item that only this environment has.
    items = os.path.join(whole, "share/gurney/equipment/items")
    shutil.copy(os.path.join(items, "xu_trolley.toml"), os.path.join(items, "only_here.toml"))
    program = ("import gurney, sys; assert gurney.__file__.startswith(sys.argv[1]), gurney.__file__\n"
               "gurney.simulate_job(sys.argv[2]).save('python.h5')\n"
               "print(gurney.simulate('only_here', settings={'duration_s': 0.1}).outcome)")
    printed(python, "-Bc", program, whole, JOB, where=folder)
    job = os.path.join(whole, "share/gurney/studies/jobs/icu_ventilator_shake.toml")
    printed(installed, "run", job, "-o", "installed.h5", "--no-figure", where=folder)
    support.gurney("run", job, "-o", os.path.join(folder, "built.h5"), "--no-figure")
    support.gurney("run", JOB, "-o", os.path.join(folder, "source.h5"), "--no-figure")
    for one, other in (("installed.h5", "built.h5"), ("python.h5", "source.h5")):
        with open(os.path.join(folder, one), "rb") as a, open(os.path.join(folder, other), "rb") as b:
            assert a.read() == b.read(), (one, other)
    os.remove(os.path.join(items, "only_here.toml"))
    printed(python, "-m", "pip", "uninstall", "-y", "gurney", where=folder)
    left = [names for _, _, names in os.walk(os.path.join(whole, "share")) if names]
    assert not os.path.exists(installed) and not left, left

    # Without an environment: the data are beside the package.
    target = os.path.join(folder, "target")
    printed(python, "-m", "pip", "install", "--no-deps", "--target", target, wheel, where=folder)
    printed(python, "-Bc", "import gurney; gurney.simulate('icu_bed', settings={'duration_s': 0.1})",
            where=folder, PYTHONPATH=target)

    # The readers, on a machine without compilers.
    printed(python, "-m", "pip", "install", "--config-settings", "engine=off", source, where=folder,
            PATH=os.path.join(whole, "bin"))
    assert not os.path.exists(installed)
    program = ("import gurney; run = gurney.open('built.h5'); "
               "print(gurney.__version__, run.demands['peak_displacement'].iloc[0])")
    version, peak = printed(python, "-Bc", program, where=folder).split()
    assert 0 < float(peak) < 10, peak
    without = ("import sys; sys.modules['h5py'] = None\ntry:\n import gurney\n"
               "except ModuleNotFoundError as error: print(error)")
    assert "apt install python3-h5py" in printed(python, "-Bc", without, where=folder)

    # What is wrong is said.
    printed(python, "-m", "pip", "install", source, where=folder, code=1, GURNEY_BUILD=folder)
    refused = printed(python, "-m", "pip", "install", "--config-settings", "engine=maybe", source,
                      where=folder, code=1)
    assert "engine=maybe: must be on or off" in refused, refused
with open(os.path.join(support.SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
    stated = next(line for line in file if line.startswith("project(")).split()[2]
assert version == stated, (version, stated)
print("installed with pip:", stated)
