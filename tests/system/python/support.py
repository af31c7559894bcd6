"""What the tests of studies/python share. Exit code 77: a package is not installed.

usage of each test: TEST.py GURNEY SOURCE_FOLDER [BUILT_PACKAGE]

BUILT_PACKAGE holds the package of the build folder, where gurney.simulate is if it was built.
"""

import importlib.util
import json
import os
import subprocess
import sys

GURNEY, SOURCE = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
PACKAGE = os.path.join(SOURCE, "studies/python")
BUILT = os.path.abspath(sys.argv[3]) if len(sys.argv) > 3 else PACKAGE


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def has(*names):
    """Whether these modules are installed."""
    return all(importlib.util.find_spec(name) is not None for name in names)


def need(*names):
    """Skips the test where a module is missing."""
    for name in names:
        if not has(name):
            skip(f"no Python module {name} (Debian: python3-{name})")


def use_package():
    """Puts the package of this repository before any that is installed."""
    need("h5py", "pandas")
    sys.dont_write_bytecode = True
    sys.path.insert(0, BUILT)


def has_module():
    """Whether gurney.simulate was built."""
    return any(name.startswith("_engine.") for name in os.listdir(os.path.join(BUILT, "gurney")))


def need_module():
    if not has_module():
        skip("gurney.simulate is not built: it needs python3-dev and pybind11-dev")


def gurney(*arguments):
    """Runs the program; returns what it prints."""
    done = subprocess.run([GURNEY, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, (arguments, done.stdout, done.stderr)
    return done.stdout


def fragilities(path, *options):
    """`gurney fragility --json` by (configuration, limit state)."""
    found = json.loads(gurney("fragility", path, "--json", *options))["fragilities"]
    return {(each["configuration"], each["limit_state"]): each for each in found}


#: two limit states of studies/jobs/trolley_levels.toml that are nested: options, and names in order
STATES = ("--limit-state", "near = peak_displacement > 0.03 m", "--limit-state",
          "far = peak_displacement > 0.05 m")
