"""`pip install studies/python` works without a network, and the package opens a file."""

import os
import shutil
import subprocess
import sys
import tempfile

import support

support.need("h5py", "pandas", "pip", "setuptools")

with tempfile.TemporaryDirectory() as folder:
    source, target = os.path.join(folder, "source"), os.path.join(folder, "installed")
    shutil.copytree(support.PACKAGE, source)  # pip builds in the folder it is given
    # Debian's environment of builds needs the network; what is installed is enough.
    subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index",
                    "--no-build-isolation", "--no-deps", "--target", target, source], check=True,
                   env={**os.environ, "PIP_ROOT_USER_ACTION": "ignore"})
    path = os.path.join(folder, "run.h5")
    support.gurney("run", os.path.join(support.SOURCE, "studies/jobs/icu_ventilator_shake.toml"),
                   "-o", path, "--no-figure")
    program = ("import gurney; run = gurney.open('run.h5'); "
               "print(gurney.__file__, run.demands['peak_displacement'].iloc[0])")
    printed = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True,
                             text=True, cwd=folder, env={**os.environ, "PYTHONPATH": target}).stdout
    where, peak = printed.split()
    assert where.startswith(target), where
    assert 0 < float(peak) < 10, peak
    with open(os.path.join(support.SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
        version = next(line for line in file if line.startswith("project(")).split()[2]
    with open(os.path.join(support.PACKAGE, "pyproject.toml"), encoding="utf-8") as file:
        assert f'version = "{version}"' in file.read(), version
    sys.path.insert(0, target)
    import gurney
    assert gurney.__version__ == version, gurney.__version__
print("installed with pip")
