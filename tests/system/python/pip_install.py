"""`pip install studies/python` works without a network, as python.md says, and the package opens a
file. On Debian that is in a virtual environment that sees the packages of the system."""

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
    environment = os.path.join(folder, "venv")
    made = subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", environment],
                          capture_output=True, text=True)
    if made.returncode == 0:
        python = os.path.join(environment, "bin", "python")
        # With its dependencies: they must be those that Debian has.
        subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index",
                        "--no-build-isolation", source], check=True)
        printed = subprocess.run([python, "-c", program], check=True, capture_output=True,
                                 text=True, cwd=folder).stdout.split()
        assert printed[0].startswith(environment) and printed[1] == peak, printed
        without = ("import sys; sys.modules['h5py'] = None\ntry:\n import gurney\n"
                   "except ModuleNotFoundError as error: print(error)")
        printed = subprocess.run([python, "-c", without], check=True, capture_output=True,
                                 text=True, cwd=folder).stdout
        assert "apt install python3-h5py" in printed, printed
    else:
        print("no virtual environment (python3-venv is missing):", made.stdout[:200])
    sys.path.insert(0, target)
    import gurney
    assert gurney.__version__ == version, gurney.__version__
print("installed with pip")
